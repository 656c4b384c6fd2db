"""How near pieces of different groups may stand to one another, as a table.

Groups are placed by the floor they need. Between them there may still be a bed whose foot touches
the fridge, a sofa in line with the hob, a chair that cannot be pushed back, a cupboard whose doors
open against a bed. Each row says round which pieces, or on which side of them, how much floor is
left free of which others.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from math import cos, hypot, sin
from typing import NamedTuple

from scenewright.catalog.classes import BEDS, SOFAS
from scenewright.core.same import Same
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.composing.case_faults import RUN
from scenewright.domains.home.composing.fronts import MOVED
from scenewright.domains.home.composing.spacing.askew import COST as ASKEW
from scenewright.domains.home.composing.spacing.askew import is_askew
from scenewright.domains.home.composing.spacing.cut_off import cost_of_cut_off, cost_of_shut_off
from scenewright.domains.home.composing.spacing.shut_in import list_shut_in
from scenewright.domains.home.composing.spacing.walled import BACK, FRONT, list_walled
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.problem import Ground
from scenewright.geometry.boxes import Frame, beyond, common_area, make_frame

ROUND = 4
"""Floor is left free all round a piece."""
SEEN = 0.03
"""A share of that floor that is not noticed."""
BACKED = frozenset((*SOFAS, "dining_chair"))
"""What an armchair is not to look at the back of."""
VIEW, AWAY, BEHIND = (0.5, 1.6), 0.5, 4.0
"""The floor before an armchair (width, depth; m), the cosine of the angle by which a back on it is
turned at most, and what it costs."""
FRONTED = RUN - {"fridge"}
"""What is stood before to cook, and opens."""
CUPBOARDS = frozenset(
    (
        *("bookcase", "chest_of_drawers", "coat_rack", "console_table", "desk", "shelf_unit"),
        *("shoe_cabinet", "sideboard", "storage_shelf", "tv_stand", "vanity", "wardrobe"),
    )
)
"""What is not to stand across the end of a worktop."""
EATEN_AT = frozenset(("dining_table", "round_table", "dining_chair", "stool"))
"""What coats are not to hang over."""
CHESTS = frozenset(("chest_of_drawers", "console_table", "sideboard", "vanity"))
"""What is not to stand before open shelves."""
UNMISSED = 0.02  # so much floor is not seen, square metres


class Distance(NamedTuple):
    """Floor so many ``metres`` wide that is left free on a ``side`` of pieces ``of`` some kinds, by
    pieces of the kinds named (none: whatever is not pushed aside); what it costs if it is not."""

    of: frozenset[str]
    side: int
    metres: float
    by: frozenset[str]
    cost: float


DISTANCES = (
    Distance(BEDS | {*SOFAS, "armchair"}, ROUND, 0.3, RUN, 10.0),
    Distance(frozenset(("nightstand",)), ROUND, 0.25, RUN, 6.0),
    Distance(BEDS, FRONT, 0.4, frozenset(SOFAS), 4.0),
    Distance(BEDS, ROUND, 0.3, frozenset(SOFAS), 5.0),
    Distance(frozenset(("tv_stand", "wall_shelf")), ROUND, 0.3, RUN, 6.0),
    Distance(FRONTED, FRONT, 0.4, CUPBOARDS, 6.0),
    Distance(frozenset(("fridge",)), FRONT, 0.4, CUPBOARDS | {"side_table", "coffee_table"}, 6.0),
    Distance(frozenset(("wardrobe",)), FRONT, 0.5, frozenset(), 8.0),
    Distance(
        frozenset(("chest_of_drawers", "sideboard", "tv_stand")), FRONT, 0.5, frozenset(), 6.0
    ),
    Distance(frozenset(("shoe_cabinet", "bookcase")), FRONT, 0.4, frozenset(), 5.0),
    Distance(frozenset(("storage_shelf",)), FRONT, 0.3, CHESTS, 6.0),
    Distance(frozenset(("dining_table", "round_table")), ROUND, 0.3, BEDS, 5.0),
    Distance(frozenset(("dining_table", "round_table")), ROUND, 0.3, RUN, 4.0),
    Distance(frozenset(("coat_rack",)), ROUND, 0.3, EATEN_AT, 5.0),
    Distance(frozenset(("dining_chair", "bar_stool")), BACK, 0.5, frozenset(), 5.0),
    Distance(frozenset(("dining_chair", "bar_stool", "stool")), BACK, 0.25, frozenset(), 10.0),
    Distance(frozenset(("armchair",)), FRONT, 0.4, frozenset(), 5.0),
)
"""The rows; of two that name the same pieces both count."""


class Close(NamedTuple):
    """Two groups of which a piece of the first lacks floor for a piece of the second (empty: what
    stands already), and what that costs."""

    group: str
    other: str
    cost: float


def list_close(
    groups: Sequence[FurnishedGroup], fixed: Sequence[Piece] = (), ground: Ground | None = None
) -> list[Close]:
    """The pairs of groups that stand too near to one another, each row of :data:`DISTANCES` half
    for being broken and half by the share of its floor that is taken, or of which one turns its
    back on an armchair; and groups whose seats have a wall, a door or a column of the ``ground``
    too near, or that stand askew on it."""
    return list(_list_close(Same(groups), Same(fixed), Same(ground)))


@lru_cache(maxsize=32)
def _list_close(
    known: Same[Sequence[FurnishedGroup]], beside: Same[Sequence[Piece]], on: Same[Ground | None]
) -> tuple[Close, ...]:
    """The same, of the same groups found once."""
    own = [(g.name, p) for g in known.value for p in g.pieces if _is_low(p)]
    low = [*own, *(("", p) for p in beside.value if _is_low(p))]
    found = list[Close]()
    for name, piece in own:
        found += [*_list_near(name, piece, low), *_list_backs(name, piece, low)]
        if on.value is not None:
            found += [Close(name, "", cost) for cost in _measure_alone(Same(piece), on)]
            shut = list_shut_in(piece, low, on.value)
            found += [Close(name, other, cost) for other, cost in shut if other != name]
    return (*found, *_list_cut_off(low, on.value)) if on.value is not None else tuple(found)


def _list_cut_off(low: Sequence[tuple[str, Piece]], ground: Ground) -> Iterator[Close]:
    """That floor or a door is cut off, as the fault of the group without which least is; what
    stands already may cut off some by itself."""
    solid = [(name, p) for name, p in low if p.category not in MOVED]
    cost = _measure_cut([p for _, p in solid], ground)
    if not cost:
        return
    less = {
        n: _measure_cut([p for name, p in solid if name != n], ground)
        for n in dict.fromkeys(name for name, _ in solid if name)
    }
    worst = min(less, key=lambda name: less[name], default="")
    if less.get(worst, cost) < cost:
        yield Close(worst, "", cost)


def _measure_cut(pieces: Sequence[Piece], ground: Ground) -> float:
    """What it costs that pieces cut off floor, and doors."""
    return cost_of_cut_off(pieces, ground) + cost_of_shut_off(pieces, ground)


@lru_cache(maxsize=1024)
def _measure_alone(known: Same[Piece], on: Same[Ground]) -> tuple[float, ...]:
    """What is wrong with where a piece stands, whatever else does; most of a room's do not move."""
    walled = tuple(list_walled(known.value, on.value))
    return (*walled, ASKEW) if is_askew(known.value, on.value) else walled


def _list_backs(name: str, piece: Piece, low: Sequence[tuple[str, Piece]]) -> Iterator[Close]:
    """What turns its back on an armchair right before it."""
    if piece.category != "armchair":
        return
    x, y, _, turn = piece.pose
    ahead = (piece.size.depth + VIEW[1]) / 2
    floor = make_frame(x + ahead * cos(turn), y + ahead * sin(turn), turn, *VIEW)
    for other, there in low:
        if other == name or there.category not in BACKED or not _may_meet(floor, there):
            continue
        away = cos(there.pose.heading - turn) > AWAY
        if away and float(common_area(floor, _frame(there))) > UNMISSED:
            yield Close(name, other, BEHIND)


def measure_closeness(
    groups: Sequence[FurnishedGroup], fixed: Sequence[Piece] = (), ground: Ground | None = None
) -> float:
    """What it costs in all that groups stand too near to one another or, of chairs, to walls and
    doors."""
    return sum(close.cost for close in list_close(groups, fixed, ground))


def _is_low(piece: Piece) -> bool:
    low = piece.pose.z < ON_FLOOR or piece.category == "wall_shelf"  # a screen hangs over it
    return low and piece.category != "rug"


def _list_near(name: str, piece: Piece, low: Sequence[tuple[str, Piece]]) -> Iterator[Close]:
    """What stands on the floor that is to be free at one piece."""
    for row, floor in _make_floors(Same(piece)):
        for other, there in low:
            if other != name and _is_meant(row, there) and _may_meet(floor, there):
                share = float(common_area(floor, _frame(there))) / _whole(floor, row, piece, there)
                if share > SEEN:
                    yield Close(name, other, row.cost * (1.0 + min(share, 1.0)) / 2)


def _whole(floor: Frame, row: Distance, piece: Piece, other: Piece) -> float:
    """Square metres that count as the whole floor of a row: those of the floor, or of a strip as
    long as the shorter side of either piece."""
    if row.side != ROUND:
        return 4 * floor[4] * floor[5]
    return row.metres * min(*piece.size[:2], *other.size[:2])


def _is_meant(row: Distance, other: Piece) -> bool:
    return other.category in row.by if row.by else other.category not in MOVED


@lru_cache(maxsize=1024)
def _make_floors(known: Same[Piece]) -> tuple[tuple[Distance, Frame], ...]:
    """The rows a piece is of, each with its floor."""
    piece = known.value
    return tuple((row, _make_floor(piece, row)) for row in DISTANCES if piece.category in row.of)


def _make_floor(piece: Piece, row: Distance) -> Frame:
    """The floor of a row at a piece."""
    if row.side != ROUND:
        return beyond(_frame(piece), row.side, row.metres)
    (x, y, _, heading), (width, depth, _) = piece.pose, piece.size
    return make_frame(x, y, heading, width + 2 * row.metres, depth + 2 * row.metres)


def _may_meet(floor: Frame, piece: Piece) -> bool:
    """Whether the circles round a floor and a piece meet."""
    away = hypot(piece.pose.x - floor[0], piece.pose.y - floor[1])
    return away < floor[6] + hypot(*piece.size[:2]) / 2


def _frame(piece: Piece) -> Frame:
    (x, y, _, heading), size = piece.pose, piece.size
    return make_frame(x, y, heading, size.width, size.depth)
