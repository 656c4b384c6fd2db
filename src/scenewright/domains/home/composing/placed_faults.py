"""What is wrong with how groups stand: before windows, adrift, too short for their wall."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from math import atan2, cos, hypot, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import BEDS, DESKS, RUN, SOFAS, SOFT_SEATS
from scenewright.core.catalog import Group
from scenewright.core.same import Same
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.composing.bed_places import (
    AT_WALL,
    DEAD,
    measure_head_gaps,
    place_member,
)
from scenewright.domains.home.composing.forms import cost_of_case
from scenewright.domains.home.furnishing.enlarge import find_widest_screen
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.settings import ComposingSettings
from scenewright.geometry.boxes import common_area, make_frame
from scenewright.geometry.flanks import measure_flank_gaps

Floats = NDArray[np.float64]

_CHESTS = ("chest_of_drawers", "sideboard", "tv_stand", "bookcase", "wardrobe", "shelf_unit")
_AWAY_FROM_DOORS = (*BEDS, "armchair")
SHADES = frozenset((*SOFT_SEATS, *BEDS, *_CHESTS, "hob_cabinet"))
"""What takes a window's light, or is not to stand in it."""
FIRMNESS = dict.fromkeys(RUN, 1.9) | dict.fromkeys(("bookcase", "fridge", "wardrobe"), 2.6)
"""How much more it costs that what is built in stands before a wide door, or what is as tall."""
SCREEN = "tv"
BRIGHT, DAYLIT = 1.05, 2.1
"""Metres from a window up to which a desk is in full daylight, and from which it has hardly any: a
window lights the floor as deep as its head is high (the primary sidelighted area of ASHRAE 90.1,
2019, 3.2), by half of that well."""
ROOMY = 8.0  # from so many square metres on a bed leaves the floor at doors free
NEAR_DOOR = 0.3  # a bed nearer to where a door opens is in the entrance, metres
SHELVED = 0.75  # share of the longest wall that shelves of a storage room stand along
OPEN = 1.0  # width of the sight from a sofa to a fireplace in which nothing stands, metres
OFF_AXIS = 0.3  # a sofa this near to the axis of a fireplace is on it, metres
FARTHEST = 3.1  # a screen is watched from so many of its widths at most
BESIDE_TABLE = 0.2  # a seat nearer than this to where one sits at a table crowds it, metres
SEEN = 0.02  # less of an opening that something stands before is not seen, metres
DARK = 0.09  # metres of a window from which on what stands before it takes its light


def cost_of_group(group: FurnishedGroup, ground: Ground, rule: ComposingSettings) -> float:
    """What is wrong with one group as it stands, each fault half for being there and half by its
    degree, by the costs of ``rule``; of the same group on the same ground found once."""
    return _cost_of_group(Same(group), Same(ground), Same(rule))


@lru_cache(maxsize=256)
def _cost_of_group(
    known: Same[FurnishedGroup], on: Same[Ground], by: Same[ComposingSettings]
) -> float:
    """The same."""
    group, ground, rule = known.value, on.value, by.value
    found, standing = list[tuple[float, float]](), 0.0
    covered = (rule.costs.window, rule.costs.opening)
    strips = _read_strips(Same(ground))
    for piece in group.pieces:
        (x, y, z, _), size, shades = piece.pose, piece.size, piece.category in SHADES
        if z > AT_WALL or piece.category == "rug":
            continue
        half = hypot(size.width, size.depth) / 2
        for strip, window, far in strips:  # circles round both that do not meet settle it
            apart = (x - strip[0]) ** 2 + (y - strip[1]) ** 2 > (half + far + AT_WALL) ** 2
            if not apart and (shades or not window):
                share = _metres_before(piece, strip)
                if share > SEEN:
                    each = covered[0 if window else 1] * _weigh_firmness(piece.category, window)
                    found.append((each, min(share, 1.0)))
        if piece.category in _AWAY_FROM_DOORS and ground.area >= ROOMY:
            found += [(rule.costs.at_door, share) for share in _near_doors(piece, ground, half)]
        if piece.category == "single_bed":
            gap = float(measure_flank_gaps(_box(piece)[None], ground.walls).min())
            found.append((rule.costs.adrift * (gap > AT_WALL), 1.0))
            behind = float(measure_head_gaps(_box(piece)[None], ground.walls)[0])
            if behind > AT_WALL:
                found.append((rule.costs.head_off, min(behind / DEAD, 1.0)))
        if piece.category in DESKS:
            standing += rule.costs.dark * find_darkness(piece, ground)
    standing += sum(cost * (1.0 + degree) / 2 for cost, degree in found)
    return standing + cost_of_case(list_standing(group), ground.area, rule)


def _weigh_firmness(category: str, window: bool) -> float:
    """How much more it costs that something firm stands before a wide door."""
    return 1.0 if window else FIRMNESS.get(category, 1.0)


@lru_cache(maxsize=64)
def _read_strips(same: Same[Ground]) -> list[tuple[list[float], bool, float]]:
    """The floor before openings: each strip, whether it is a window's, and how far its corners are
    from its middle, metres."""
    return [(s, s[5] == 1.0, hypot(s[3], s[4]) / 2) for s in same.value.strips.tolist()]


def find_darkness(desk: Piece, ground: Ground) -> float:
    """How far a desk is from the daylight of the nearest window, from 0 (up to :data:`BRIGHT`) to 1
    (from :data:`DAYLIT` on); 0 in a room without windows."""
    x, y, away = desk.pose.x, desk.pose.y, list[float]()
    for u, v, heading, width, depth, _ in ground.windows.tolist():
        along = abs((x - u) * sin(heading) - (y - v) * cos(heading)) - width / 2
        ahead = (x - u) * cos(heading) + (y - v) * sin(heading) + depth / 2
        away.append(hypot(max(along, 0.0), max(ahead, 0.0)))
    nearest = min(away, default=BRIGHT)
    return min(max(nearest - BRIGHT, 0.0) / (DAYLIT - BRIGHT), 1.0)


def _near_doors(bed: Piece, ground: Ground, half: float) -> Iterator[float]:
    """For each door leaf or threshold that a bed or an armchair is nearer to than
    :data:`NEAR_DOOR`, by what share."""
    frame = make_frame(*_box(bed).tolist())
    for x, y, heading, width, depth in ground.keep_free.tolist():
        if hypot(bed.pose.x - x, bed.pose.y - y) < half + hypot(width, depth) / 2 + NEAR_DOOR:
            wide, deep = width + 2 * NEAR_DOOR, depth + 2 * NEAR_DOOR
            near = float(common_area(frame, make_frame(x, y, heading, wide, deep)))
            if near > SEEN:
                yield min(near / NEAR_DOOR, 1.0)


def list_standing(group: FurnishedGroup) -> Group:
    """The case of a group without the members that gave way."""
    case, stands = group.dressed.case, group.dressed.stands
    if all(stands):
        return case
    held = (m for m, there in zip(case.members, stands, strict=True) if there)
    return case._replace(members=tuple(held))


def _box(piece: Piece) -> Floats:
    pose, size = piece.pose, piece.size
    return np.array([pose.x, pose.y, pose.heading, size.width, size.depth])


def _metres_before(piece: Piece, strip: Sequence[float]) -> float:
    """Metres of an opening that a piece stands before."""
    frame = make_frame(*_box(piece).tolist())
    return float(common_area(frame, make_frame(*strip[:5])) / strip[4])


def measure_before_doors(group: FurnishedGroup, ground: Ground) -> float:
    """Metres of wide doors and passages that a group stands before, each from :data:`SEEN` on."""
    doors = [strip for strip, window, _ in _read_strips(Same(ground)) if not window]
    low = [p for p in group.pieces if p.pose.z <= AT_WALL and p.category != "rug"]
    metres = (_metres_before(piece, door) for piece in low for door in doors)
    return sum(found for found in metres if found > SEEN)


def measure_hung_over_doors(group: FurnishedGroup, ground: Ground) -> float:
    """Metres of wide doors and passages over which what a group hangs at a wall reaches: nothing
    holds it there."""
    doors = [strip for strip, window, _ in _read_strips(Same(ground)) if not window]
    hung = [p for p in group.pieces if p.pose.z > AT_WALL and not p.on]
    deep = ((p, door, min(door[4], p.size.depth)) for p in hung for door in doors)
    return sum(_metres_before(piece, door) * door[4] / depth for piece, door, depth in deep)


def cost_of_openings(case: Group, boxes: Floats, ground: Ground, rule: ComposingSettings) -> Floats:
    """What is wrong with a case on each of boxes (n, 5) as it stands before windows and wide doors:
    :func:`cost_of_group` of many places at once, of what stands parallel to its wall."""
    cost = np.zeros(len(boxes))
    for member in case.members:
        if member.on >= 0 or member.z > AT_WALL or member.category == "rug":
            continue
        there = place_member(member, boxes)
        for strip in ground.strips:
            window = strip[5] == 1.0
            if not window or member.category in SHADES:
                share = _lengths_before(there, strip)
                each = rule.costs.window if window else rule.costs.opening
                each *= _weigh_firmness(member.category, window)
                cost += np.where(share > SEEN, each * (1.0 + np.minimum(share, 1.0)) / 2, 0.0)
    return cost


def _lengths_before(boxes: Floats, strip: Floats) -> Floats:
    """Metres of an opening that each of boxes (n, 5) parallel or square to it stands before."""
    x, y, heading, width, depth = strip[:5]
    dx, dy, turn = boxes[:, 0] - x, boxes[:, 1] - y, boxes[:, 2] - heading
    along, ahead = dx * np.sin(heading) - dy * np.cos(heading), dx * np.cos(heading)
    ahead = ahead + dy * np.sin(heading)
    c, s = np.abs(np.cos(turn)), np.abs(np.sin(turn))
    half, deep = (boxes[:, 3] * c + boxes[:, 4] * s) / 2, (boxes[:, 4] * c + boxes[:, 3] * s) / 2
    common = np.minimum(along + half, width / 2) - np.maximum(along - half, -width / 2)
    inside = np.minimum(ahead + deep, depth / 2) - np.maximum(ahead - deep, -depth / 2)
    return np.asarray(np.maximum(common, 0.0) * np.maximum(inside, 0.0) / depth)


def cost_of_screen(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with a stand that has no room for a screen large enough for its distance."""
    pieces = [p for g in groups for p in g.pieces]
    under = {p.on for p in pieces if p.category == "tv"}
    stand = next((p for p in pieces if p.id in under), None)
    seats = [p for p in pieces if p.category in SOFAS]
    if stand is None or not seats:
        return 0.0
    away = min(hypot(p.pose.x - stand.pose.x, p.pose.y - stand.pose.y) for p in seats)
    short = 1.0 - find_widest_screen(stand, ground, pieces) * FARTHEST / away
    return cost * (1.0 + short) / 2 if short > 0.0 else 0.0


def cost_of_hearth(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with a sofa that does not look at the fireplace that stands: by how far it is
    off the fireplace's axis, turned from it, and what of other groups stands between."""
    seats = next((g for g in groups if any(p.category in SOFAS for p in g.pieces)), None)
    if seats is None or not len(ground.hearths):
        return 0.0
    sofa = next(p.pose for p in seats.pieces if p.category in SOFAS)
    x, y, c, s = min(ground.hearths.tolist(), key=lambda h: hypot(sofa.x - h[0], sofa.y - h[1]))
    turned = 1.0 + c * cos(sofa.heading) + s * sin(sofa.heading)
    off = max(abs((sofa.y - y) * c - (sofa.x - x) * s) - OFF_AXIS, 0.0) + turned
    away = (sofa.x - x) * c + (sofa.y - y) * s
    if away > SEEN:
        sight = make_frame(x + c * away / 2, y + s * away / 2, atan2(s, c), OPEN, away)
        between = (p for g in groups if g is not seats for p in g.pieces if p.pose.z < AT_WALL)
        off += sum(float(common_area(make_frame(*_box(p).tolist()), sight)) for p in between)
    return cost * (1.0 + min(off, 1.0)) / 2 if off > SEEN else 0.0


def cost_of_crowding(groups: Sequence[FurnishedGroup], cost: float) -> float:
    """What is wrong with tables that sofas and armchairs crowd: seats nearer than
    :data:`BESIDE_TABLE` to the floor of those who eat, half for being so and half by the share of a
    square metre that they take of it."""
    seats = [p for g in groups for p in g.pieces if p.category in SOFT_SEATS]
    total = 0.0
    for group in groups if seats else ():
        if group.wish.group in TABLES:
            x, y, heading, width, depth = group.dressed.box.tolist()
            wide, deep = width + 2 * BESIDE_TABLE, depth + 2 * BESIDE_TABLE
            far, frame = hypot(wide, deep) / 2, make_frame(x, y, heading, wide, deep)
            for p in seats:
                if hypot(p.pose.x - x, p.pose.y - y) < far + hypot(*p.size[:2]) / 2:
                    area = float(common_area(make_frame(*_box(p).tolist()), frame))
                    total += cost * (1.0 + min(area, 1.0)) / 2 if area > SEEN else 0.0
    return total


def cost_of_shelves(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with the shelves of a storage room that stand along less of its longest wall
    than :data:`SHELVED`."""
    shelves = [p for g in groups if g.wish.group == "storage" for p in g.pieces]
    if not shelves:
        return 0.0
    walls = ground.walls
    longest = float(np.hypot(walls[:, 2] - walls[:, 0], walls[:, 3] - walls[:, 1]).max())
    short = 1.0 - sum(p.size.width for p in shelves) / (SHELVED * longest)
    return cost * (1.0 + short) / 2 if short > 0.0 else 0.0


def list_adrift(groups: Sequence[FurnishedGroup], ground: Ground) -> list[Piece]:
    """The single beds of groups neither long side of which is at a wall."""
    beds = [p for g in groups for p in g.pieces if p.category == "single_bed"]
    gaps = (float(measure_flank_gaps(_box(bed)[None], ground.walls).min()) for bed in beds)
    return [bed for bed, gap in zip(beds, gaps, strict=True) if gap > AT_WALL]


def measure_before_windows(group: FurnishedGroup, ground: Ground) -> Floats:
    """Metres (w,) of each of the windows in walls before which one piece of a group stands that
    takes its light."""
    panes = [strip for strip, window, _ in _read_strips(Same(ground)) if window]
    low = [p for p in group.pieces if _takes_light(p.category, p.pose.z)]
    each = [[_metres_before(piece, pane) for pane in panes] for piece in low]
    return np.array(each).reshape(len(low), len(panes)).max(axis=0, initial=0.0)


def _takes_light(category: str, above: float) -> bool:
    """Whether what stands so far above the floor takes light of a window behind it."""
    return category == SCREEN or (category in SHADES and above <= AT_WALL)


def measure_cases_before_windows(case: Group, boxes: Floats, ground: Ground) -> Floats:
    """:func:`measure_before_windows` (n, w) of a case on each of boxes (n, 5), of what stands
    parallel to its wall."""
    panes = [strip for strip in ground.strips if strip[5] == 1.0]
    metres = np.zeros((len(boxes), len(panes)))
    for member in case.members:
        if _takes_light(member.category, member.z):
            there = place_member(member, boxes)
            for k, pane in enumerate(panes):
                metres[:, k] = np.maximum(metres[:, k], _lengths_before(there, pane))
    return metres
