"""Furniture groups learned from rooms that somebody furnished.

A group is found about the piece that makes it (a bed, a table, a sofa, a desk): the pieces near
it, facing it, on it or above it. Each becomes a case in the group's own frame, as the
paper made its library from designers' rooms (Liu et al. 2017, section 3.4); what a person could
not use is mended or dropped, and like cases of several homes become one with a range of sizes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, pi, remainder, sin
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.models.furniture import LIKELY, misfits
from scenewright.core.catalog import Catalog, Group, Member
from scenewright.core.scene import Piece, Size
from scenewright.core.space import Space
from scenewright.domains.home.cases.trial import usable
from scenewright.domains.home.learned.space import (
    BACK_AT_WALL,
    TOP,
    above,
    apart,
    drawn_out,
    gap,
    local,
    on,
    pushed_out,
    rotate_to_frame,
)
from scenewright.domains.home.learned.words import (
    ABOVE,
    ANCHORS,
    COMPANIONS,
    ROOMS,
    RUN_ROWS,
    SEATS,
    GroupCompanions,
)

Floats = NDArray[np.float64]

STRAIGHT = 0.15  # headings nearer to a quarter turn than this are one, radians
FACING = 1.9  # an armchair turned further from its sofa than this is not of its group, radians
TOUCHING = 0.12  # units of a run nearer than this are one row, metres
PULL = 0.2  # floor behind a chair to rise from it, metres
ELBOWS = 0.6  # least width of a toilet's place, metres
RUG = 0.6  # by how much a rug may be longer than the group on it, metres
STAND = 0.5  # height of a stand that was drawn together with its television, metres


class FurnishedSpace(NamedTuple):
    """A furnished room: the home's name, the space and the pieces in it."""

    home: str
    space: Space
    pieces: tuple[Piece, ...]


class GroupOccurrence(NamedTuple):
    """One group as found: its case, the home, the room and its area, how far its back is from a
    wall and its middle from the nearest door (NaN: there is none), and the middle and heading of
    its box in the room."""

    case: Group
    home: str
    room: str
    area: float
    wall: float
    door: float
    box: tuple[float, float, float]


def found_in(room: FurnishedSpace, catalog: Catalog) -> Iterator[GroupOccurrence]:
    """The groups of a room that a person can use."""
    free = [p for p in room.pieces if p.category in catalog.kinds]
    for anchor in sorted(free, key=_rank):
        if anchor not in free or anchor.category not in ANCHORS or anchor.pose.z > TOP:
            continue
        function = _function(anchor, room)
        members = _members(anchor, function, free, catalog)
        for piece in members:
            free.remove(piece)
        function = _identify_function(function, members, anchor, room)
        case = _usable(function, anchor, members, room, catalog) if function else None
        if case:
            yield _record_group(case, anchor, room)


def _usable(
    function: str, anchor: Piece, members: list[Piece], room: FurnishedSpace, catalog: Catalog
) -> Group | None:
    """The case of the members, without the last of those on the floor until a person can use it."""
    floor = [p for p in members if p is not anchor and p.pose.z <= TOP]
    for count in range(len(floor) + 1):
        left = [p for p in members if p not in floor[len(floor) - count :]]
        case = _case(function, anchor, left, room, catalog)
        if case and usable(case, catalog):
            return case if _identify_function(function, left, anchor, room) or count == 0 else None
    return None


def _rank(piece: Piece) -> tuple[int, float]:
    order = list(ANCHORS)
    rank = order.index(piece.category) if piece.category in ANCHORS else len(order)
    return rank, -piece.size.width * piece.size.depth


def _function(anchor: Piece, room: FurnishedSpace) -> str:
    """A table in a bedroom or study is a desk."""
    return ROOMS.get((anchor.category, *room.space.functions[:1]), ANCHORS[anchor.category])


def _members(anchor: Piece, function: str, free: Sequence[Piece], catalog: Catalog) -> list[Piece]:
    """The anchor and what keeps it company: on the floor first, then on them and above."""
    company = COMPANIONS.get(function, GroupCompanions(()))
    members = [anchor]
    if company.row:
        members += _row(anchor, company, free)
    else:
        near = [p for p in free if p is not anchor and p.category in company.kinds]
        near.sort(key=lambda p: company.kinds.index(p.category))
        members += [p for p in near if gap(p, anchor) < company.reach and _faces(p, anchor)]
    standing = tuple(members)
    for piece in free:
        if (
            piece not in members
            and piece.category != "obstacle"
            and (
                any(on(piece, below) for below in standing)
                or (piece.category in ABOVE.get(function, ()) and above(piece, standing))
            )
        ):
            members.append(piece)
    del catalog
    return members


def _row(anchor: Piece, company: GroupCompanions, free: Sequence[Piece]) -> list[Piece]:
    """Units side by side with the anchor, with the same heading."""
    row = [anchor]
    grown = True
    while grown:
        more = [
            p
            for p in free
            if p not in row
            and p.category in company.kinds
            and abs(remainder(p.pose.heading - anchor.pose.heading, 2 * pi)) < STRAIGHT
            and any(gap(p, q) < TOUCHING for q in row)
            and abs(local(p, anchor)[1]) < 0.25
        ]
        row += more
        grown = bool(more)
    return row[1:]


def _faces(piece: Piece, anchor: Piece) -> bool:
    """Whether a seat looks towards the anchor; other pieces need not."""
    if piece.category != "armchair":
        return True
    way = np.arctan2(anchor.pose.y - piece.pose.y, anchor.pose.x - piece.pose.x)
    return abs(remainder(float(way) - piece.pose.heading, 2 * pi)) < FACING


def _identify_function(
    function: str, members: Sequence[Piece], anchor: Piece, room: FurnishedSpace
) -> str:
    """The function by what the group turned out to hold; empty if it is of none."""
    kinds = {piece.category for piece in members}
    if function in ("kitchen", "fridge", "counter"):
        return next(
            (name for name, needs, not_ in RUN_ROWS if needs <= kinds and not not_ & kinds), ""
        )
    seats = sum(piece.category in SEATS for piece in members)
    at_wall = _wall_gap(anchor, _heading(anchor, room), room) < BACK_AT_WALL
    if function == "dining":
        return "" if seats < 2 - at_wall else "dining_wall" if at_wall else function
    return "" if function == "desk" and not seats else function


def _heading(anchor: Piece, room: FurnishedSpace) -> float:
    """Where the group looks: as its anchor, but a table looks away from the wall it is at."""
    heading = anchor.pose.heading
    if "table" not in anchor.category and anchor.category != "desk":
        return heading
    if anchor.category == "desk":
        turns: tuple[float, ...] = (0.0, pi)
    else:
        turns = (0.0, pi) if anchor.size.width >= anchor.size.depth else (pi / 2, -pi / 2)
    gaps = [(_wall_gap(anchor, heading + turn, room), k) for k, turn in enumerate(turns)]
    best = min(gaps)
    return heading + turns[best[1] if best[0] < BACK_AT_WALL else 0]


def _wall_gap(anchor: Piece, heading: float, room: FurnishedSpace) -> float:
    """How far the back of a piece is from the nearest wall, were its heading so."""
    across = abs(sin(heading - anchor.pose.heading)) > 0.5
    half = (anchor.size.width if across else anchor.size.depth) / 2
    back = shapely.Point(anchor.pose.x - cos(heading) * half, anchor.pose.y - sin(heading) * half)
    return float(shapely.LinearRing(room.space.outline).distance(back))


def _case(
    function: str, anchor: Piece, pieces: Sequence[Piece], room: FurnishedSpace, catalog: Catalog
) -> Group | None:
    """The pieces as a case in the group's frame, without what runs into something."""
    heading = _heading(anchor, room)
    clear = [_pull_clear(piece, anchor) for piece in pieces]
    kept = apart(anchor, clear, catalog)
    kept.sort(key=lambda p: p.pose.z > TOP)
    members: list[Member] = []
    for piece in kept:
        x, y = rotate_to_frame(piece.pose.x - anchor.pose.x, piece.pose.y - anchor.pose.y, heading)
        turn = remainder(piece.pose.heading - heading, 2 * pi)
        quarter = round(turn / (pi / 2)) * pi / 2
        straight = abs(turn - quarter) < STRAIGHT or piece.category == "rug"
        turn = quarter if straight else turn
        below = next((k for k, q in enumerate(kept) if q is not piece and on(piece, q)), -1)
        top = members[below].z + members[below].size.height if 0 <= below < len(members) else None
        category = function if function in ("desk",) and piece is anchor else piece.category
        members.append(
            Member(
                category,
                x,
                y,
                piece.pose.z if top is None else top,
                turn,
                piece.size,
                below if top is not None else -1,
            )
        )
    first = members[0]
    if max(misfits(first.category, first.size)) > LIKELY:
        return None
    return box_members(function, _repair_members(members))


def _pull_clear(piece: Piece, anchor: Piece) -> Piece:
    """A seat drawn out of its table, a table out of the corner of an L-shaped sofa."""
    if piece.category in SEATS:
        return drawn_out(piece, anchor)
    if anchor.category == "corner_sofa" and piece.category in ("coffee_table", "side_table"):
        return pushed_out(piece, anchor)
    return piece


def _repair_members(members: list[Member]) -> list[Member]:
    """Without a rug that reaches far out of the group; a television in one with its stand
    becomes two."""
    solid = box_members("", [m for m in members if m.category != "rug"])
    most = max(solid.width, solid.depth) + RUG
    kept = [m for m in members if m.category != "rug" or max(m.size[:2]) <= most]
    first = kept[0]
    if len(kept) == len(members) and first.category == "tv_stand" and len(members) == 1:
        wide = min(first.size.width, 1.4) * 0.8
        stand = first._replace(size=Size(first.size.width, first.size.depth, STAND))
        screen = Size(wide, min(0.2, first.size.depth), 0.62 * wide)
        kept = [stand, Member("tv", first.x, first.y, STAND, first.heading, screen, 0)]
    return (
        kept
        if len(kept) == len(members) or first.category == "tv_stand"
        else _renumber_members(members, kept)
    )


def _renumber_members(members: list[Member], kept: list[Member]) -> list[Member]:
    """Members with the numbers of what they stand on after some were left out."""
    new = {k: kept.index(m) for k, m in enumerate(members) if m in kept}
    return [m._replace(on=new.get(m.on, -1)) for m in kept]


def box_members(function: str, members: Sequence[Member]) -> Group:
    """Members as a case: the box round those on the floor, with room to rise from chairs."""
    low, high = np.full(2, np.inf), np.full(2, -np.inf)
    for member in members:
        if member.on >= 0 or member.z > TOP:
            continue
        half = _half(member)
        at = np.array([member.x, member.y])
        back = np.array([sin(member.heading), -cos(member.heading)]) * PULL
        behind = at + (back if member.category in ("dining_chair", "stool", "bench") else 0.0)
        low = np.minimum(low, np.minimum(at, behind) - half)
        high = np.maximum(high, np.maximum(at, behind) + half)
    spare = max(ELBOWS - float(high[0] - low[0]), 0.0) / 2 if function == "toilet" else 0.0
    low[0], high[0] = low[0] - spare, high[0] + spare
    middle, size = (low + high) / 2, high - low
    moved = tuple(m._replace(x=m.x - float(middle[0]), y=m.y - float(middle[1])) for m in members)
    floor = [m.category.replace("_", " ") for m in members if m.on < 0 and m.z <= TOP]
    named = ", ".join(
        f"{floor.count(k)} {k}" if floor.count(k) > 1 else k for k in dict.fromkeys(floor)
    )
    return Group(function, named, float(size[0]), float(size[1]) + 0.01, moved)


def _half(member: Member) -> Floats:
    c, s = abs(cos(member.heading)), abs(sin(member.heading))
    w, d = member.size.width / 2, member.size.depth / 2
    return np.array([w * c + d * s, w * s + d * c])


def _record_group(case: Group, anchor: Piece, room: FurnishedSpace) -> GroupOccurrence:
    at = shapely.Point(anchor.pose.x, anchor.pose.y)
    doors = [o for o in room.space.openings if o.kind != "window"]
    door = min((at.distance(shapely.Point(o.x, o.y)) for o in doors), default=float("nan"))
    first = case.members[0]
    area = shapely.Polygon(room.space.outline, list(room.space.holes)).area
    heading = _heading(anchor, room)
    return GroupOccurrence(
        case,
        room.home,
        room.space.id,
        float(area),
        _wall_gap(anchor, heading, room),
        float(door),
        _centre(anchor, first, heading),
    )


def _centre(anchor: Piece, first: Member, heading: float) -> tuple[float, float, float]:
    """Where the middle of a group's box is in the room, and where the group looks."""
    x = anchor.pose.x - first.x * sin(heading) - first.y * cos(heading)
    y = anchor.pose.y + first.x * cos(heading) - first.y * sin(heading)
    return x, y, heading
