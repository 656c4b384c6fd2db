"""Rooms piece by piece, without patches: what solvers over single pieces are posed and answer.

Every wished group is taken apart: its floor pieces become the items of a problem, each of its own
size, related to the piece that makes the group as in its case; what lies on them, hangs above
them or lies below rides along. Where the solver leaves the pieces is where they stand: the answer
is a case of its own whose box is drawn round them, judged by the same measures as any patch.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import SOFT_SEATS
from scenewright.core.catalog import Catalog, Group, Member
from scenewright.core.kind import SIDES
from scenewright.domains.home.build_problem import RELATIONS, holds, number_names, sizes_of
from scenewright.domains.home.cases.library import SHIPPED, Library, nearest
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.problem import Ground, Items, Problem, empty_items
from scenewright.domains.home.programme import Wish

Floats = NDArray[np.float64]
BACK = 0.06  # a piece whose back is this near to its group's belongs to the wall, metres
TIED = 2.0  # weight of the ties within a group beside those between groups


class Parts(NamedTuple):
    """A wish taken apart: its case, which members are placed by themselves, the one of them that
    makes the group, and the member each of the others rides with (itself if it is placed)."""

    wish: Wish
    case: Group
    placed: tuple[int, ...]
    anchor: int
    rides: tuple[int, ...]


class Tie(NamedTuple):
    """Two items that belong together: their numbers, wanted distance, angle, bearing, weight."""

    first: int
    second: int
    distance: float
    angle: float
    bearing: float
    weight: float


def parts_of(wish: Wish, area: float, catalog: Catalog, library: Library = SHIPPED) -> Parts:
    """The case a room of ``area`` square metres wishes for, taken apart."""
    case = nearest(wish.group, *sizes_of(wish, area, library)[2], library)
    placed = tuple(i for i, m in enumerate(case.members) if _stands_on_floor(m, catalog))
    essential = GROUPS[wish.group].essential
    anchor = next((i for i in placed if case.members[i].category in essential), placed[0])
    rides = tuple(i if i in placed else _carrier(case, placed, i) for i in range(len(case.members)))
    return Parts(wish, case, placed, anchor, rides)


def _stands_on_floor(member: Member, catalog: Catalog) -> bool:
    kind = catalog.kinds[member.category]
    return member.on < 0 and member.z < 0.05 and not kind.flat and kind.support == "floor"


def _carrier(case: Group, placed: tuple[int, ...], i: int) -> int:
    """The placed member that another stands on, else the nearest."""
    while case.members[i].on >= 0:
        i = case.members[i].on
    member = case.members[i]
    return min(
        placed, key=lambda k: np.hypot(case.members[k].x - member.x, case.members[k].y - member.y)
    )


def posed_pieces(
    ground: Ground,
    parts: tuple[Parts, ...],
    catalog: Catalog,
    weights: dict[str, float],
    printed: bool,
    route_width: float,
) -> Problem:
    """The problem of placing every piece separately; items in the order of wishes and members."""
    names = number_names([p.wish.group for p in parts])
    numbered = number_names(
        [
            f"{name}/{p.case.members[i].category}"
            for name, p in zip(names, parts, strict=True)
            for i in p.placed
        ]
    )
    return Problem(ground, _items(parts, catalog), tuple(numbered), weights, printed, route_width)


def _items(parts: tuple[Parts, ...], catalog: Catalog) -> Items:
    members = [p.case.members[i] for p in parts for i in p.placed]
    rows = [(p, i) for p in parts for i in p.placed]
    sizes = np.array([(m.size.width, m.size.depth) for m in members]).reshape(-1, 2)
    ties = [*_ties_within(parts), *_ties_between(parts)]
    return empty_items(len(members))._replace(
        low=sizes,
        high=sizes.copy(),
        wish=sizes.copy(),
        height=np.array([m.size.height for m in members]),
        back_to_wall=np.array([_back(p, i) for p, i in rows]),
        main_wall=np.array([_role(p, i) for p, i in rows]),
        clear=np.array([_clear(p, i, catalog) for p, i in rows]).reshape(-1, 4),
        pairs=np.array([tie[:2] for tie in ties], np.int64).reshape(-1, 2),
        pair_targets=np.array([tie[2:5] for tie in ties], np.float64).reshape(-1, 3),
        pair_weights=np.array([tie.weight for tie in ties]),
    )


def _back(parts: Parts, i: int) -> float:
    """How much a member belongs to a wall: as its group, if its back is the group's."""
    member = parts.case.members[i]
    off = member.y - member.size.depth / 2 + parts.case.depth / 2
    return GROUPS[parts.wish.group].back if off < BACK and abs(member.heading) < 0.1 else 0.0


def _role(parts: Parts, i: int) -> float:
    """The group's role at the main wall, for the piece that makes it and for its seats."""
    role = GROUPS[parts.wish.group].main
    seat = role > 0 and parts.case.members[i].category in SOFT_SEATS
    return role if seat or i == parts.anchor else 0.0


def _extent(member: Member) -> tuple[float, float]:
    """Half of what a member takes along x and y of its group (headings are quarter turns)."""
    across = abs(np.sin(member.heading)) > 0.5
    w, d = member.size.width / 2, member.size.depth / 2
    return (d, w) if across else (w, d)


def _clear(parts: Parts, i: int, catalog: Catalog) -> list[float]:
    """Free depth at one of the sides a member is used from: the first one that its own group
    leaves at least half free."""
    member, clear = parts.case.members[i], [0.0] * 4
    kind = catalog.kinds[member.category]
    for side in map(SIDES.index, kind.access):
        angle = np.pi / 2 + member.heading + side * np.pi / 2
        out, along = (0, 1) if side % 2 else (1, 0)
        half = (member.size.width / 2, member.size.depth / 2)
        reach = half[out] + kind.reach / 2
        x, y = member.x + reach * np.cos(angle), member.y + reach * np.sin(angle)
        turned = abs(np.sin(angle)) > 0.5
        rx, ry = (half[along], kind.reach / 2) if turned else (kind.reach / 2, half[along])
        others = [parts.case.members[k] for k in parts.placed if k != i]
        taken = sum(
            _measure_overlap(x, rx, m.x, _extent(m)[0])
            * _measure_overlap(y, ry, m.y, _extent(m)[1])
            for m in others
        )
        if taken <= 2 * rx * ry:
            clear[side] = kind.reach
            break
    return clear


def _measure_overlap(a: float, reach: float, b: float, other: float) -> float:
    """Length that two intervals, given by middle and half, have in common."""
    return float(max(min(a + reach, b + other) - max(a - reach, b - other), 0.0))


def _ties_within(parts: tuple[Parts, ...]) -> list[Tie]:
    """Each member to the piece that makes its group, as in the case, but drawn apart until they
    no longer share floor (a chair stands before its table, not under it)."""
    ties, first = [], 0
    for part in parts:
        a = part.case.members[part.anchor]
        for k, i in enumerate(part.placed):
            if i != part.anchor:
                b = part.case.members[i]
                dx, dy = b.x - a.x, b.y - a.y
                need = [e + f for e, f in zip(_extent(a), _extent(b), strict=True)]
                apart = min(need[0] / max(abs(dx), 1e-9), need[1] / max(abs(dy), 1e-9))
                far = float(np.hypot(dx, dy) * max(apart, 1.0))
                bearing = float(np.arctan2(dy, dx) - np.pi / 2 - a.heading)
                ties.append(
                    Tie(
                        first + part.placed.index(part.anchor),
                        first + k,
                        far,
                        b.heading - a.heading,
                        bearing,
                        TIED,
                    )
                )
        first += len(part.placed)
    return ties


def _ties_between(parts: tuple[Parts, ...]) -> list[Tie]:
    """The relations between groups, held by the pieces that make them."""
    groups = [p.wish.group for p in parts]
    starts = np.cumsum([0, *(len(p.placed) for p in parts)])
    ties = []
    for relation in RELATIONS:
        if holds(relation, groups):
            i, j = groups.index(relation.first), groups.index(relation.second)
            a, b = parts[i], parts[j]
            deeper = [max(-p.case.members[p.anchor].y, 0.0) for p in (a, b)]
            ties.append(
                Tie(
                    int(starts[i]) + a.placed.index(a.anchor),
                    int(starts[j]) + b.placed.index(b.anchor),
                    relation.distance + sum(deeper),
                    relation.angle,
                    relation.bearing,
                    relation.weight,
                )
            )
    return ties


def as_laid(parts: Parts, boxes: Floats) -> tuple[Group, Floats]:
    """A case of its own and its box (5,): the placed members stand on ``boxes`` (k, 5), the
    others as they ride with them.

    The box has the heading of the piece that makes the group and is drawn round all placed.
    """
    case, heading = parts.case, float(boxes[parts.placed.index(parts.anchor), 2])
    across = np.array([np.sin(heading), -np.cos(heading)])
    ahead = np.array([np.cos(heading), np.sin(heading)])
    turned = boxes[:, 2] - heading
    cos, sin = np.abs(np.cos(turned)), np.abs(np.sin(turned))
    half = 0.5 * np.stack(
        [boxes[:, 3] * cos + boxes[:, 4] * sin, boxes[:, 3] * sin + boxes[:, 4] * cos], 1
    )
    local = np.stack([boxes[:, :2] @ across, boxes[:, :2] @ ahead], 1)
    low, high = (local - half).min(0), (local + half).max(0)
    middle = 0.5 * (low + high)
    centre = middle[0] * across + middle[1] * ahead
    members = []
    for i, member in enumerate(case.members):
        k = parts.placed.index(parts.rides[i])
        old, turn = case.members[parts.rides[i]], float(turned[k])
        dx, dy = member.x - old.x, member.y - old.y
        away = turn - old.heading
        x = local[k, 0] - middle[0] + np.cos(away) * dx - np.sin(away) * dy
        y = local[k, 1] - middle[1] + np.sin(away) * dx + np.cos(away) * dy
        members.append(member._replace(x=float(x), y=float(y), heading=member.heading + away))
    group = Group(
        case.function, case.name, float(high[0] - low[0]), float(high[1] - low[1]), tuple(members)
    )
    return group, np.array([*centre, heading, group.width, group.depth])
