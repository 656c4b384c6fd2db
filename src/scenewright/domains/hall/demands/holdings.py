"""What a hall is to hold: demands with everything filled in that the brief leaves open."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.catalog.kinds import hall_use, name_of
from scenewright.core.brief import Brief
from scenewright.core.brief.zones import Demand
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Size
from scenewright.domains.hall.classes import TABLE_CHAIRS, is_pew
from scenewright.domains.hall.demands.checked import ids_of, sizes_of, usual_clearance
from scenewright.domains.hall.desks.cash_desks import is_cash_desk, measure_cash_desk
from scenewright.domains.hall.patterns import PATTERNS
from scenewright.domains.hall.seats.audience import find_shows, find_tables, may_share_zone
from scenewright.domains.hall.seats.chairs import out_of_table, seats_around

SEATWAY = 0.45
"""Free floor to get to a chair from behind, in metres (Neufert)."""
"""Which kinds look at which, unless stated otherwise."""


class HallDemand(NamedTuple):
    """One demand: its id, what to call it, the sizes of its objects, the free depth at front,
    left, back and right of each, the patterns it may take, the zones it may go to (empty: any),
    the id of the demand it looks at (empty: none) and whether leaving it out is a failure.

    Tables that bring chairs are placed with them: ``sizes`` are those of the floor they take
    together, ``chairs`` metres of it before and behind each table and ``aside`` at its sides. Once
    ``least`` stand nothing is missing (0: all are wanted).

    Chairs asked for by themselves name the demand ``at`` whose tables they stand; once joined
    (:mod:`.seating`), that holds them as ``seated``. A desk then stands with ``before`` metres for
    its chair, ``turned`` so that people at it look ahead. Counters at a wall stand with
    ``staff`` metres behind them, and ``before`` them is the floor of stools; those in a ``row`` are
    one object until they are furnished, and so are two rows back to back (``double``). Of what is
    ``unplaced`` the brief says neither whether it stands at a wall nor in what pattern; of what is
    ``unstated`` neither this nor what it looks at, its free floor or how full its zone is. What is
    ``set_last`` is set once all else stands. Each object of sofas and beds in ``lounges``
    (:mod:`.lounges`, :mod:`.bedsides`) is one of these until it is furnished; so are as many as
    stand in a row, ``every`` of them, before an ``aisle`` of that width (:mod:`.cross_aisles`).
    All sides it is ``used`` from are to be reached (empty: one of those of its category)."""

    id: str
    name: str
    category: str
    sizes: tuple[Size, ...]
    clearance: tuple[float, float, float, float]
    patterns: tuple[str, ...]
    zones: tuple[str, ...]
    facing: str
    required: bool
    chairs: float = 0.0
    least: int = 0
    aside: float = 0.0
    at: str = ""
    before: float = 0.0
    turned: bool = False
    unstated: bool = False
    set_last: bool = False
    seated: tuple[HallDemand, ...] = ()
    staff: float = 0.0
    row: tuple[Size, ...] = ()
    double: bool = False
    unplaced: bool = False
    lounges: tuple[tuple[LoungePart, ...], ...] = ()
    every: int = 0
    aisle: float = 0.0
    used: tuple[str, ...] = ()

    @property
    def at_wall(self) -> bool:
        """Whether its objects stand at walls."""
        return self.patterns == ("wall",)


class LoungePart(NamedTuple):
    """A piece of a lounge: its demand and size, how far its middle is to the right of that of the
    lounge and ahead of it, in metres, and how far it is turned from where the lounge looks."""

    wish: HallDemand
    size: Size
    along: float = 0.0
    ahead: float = 0.0
    turn: float = 0.0


def may_stand_together(one: HallDemand, other: HallDemand) -> bool:
    """Whether the objects of two demands may go to the same zone."""
    return not one.zones or not other.zones or bool(set(one.zones) & set(other.zones))


def collect_demands(
    brief: Brief, number: int, locked: tuple[Piece, ...], catalog: Catalog
) -> list[HallDemand]:
    """The demands of room ``number``, less the ``locked`` objects there."""
    room = brief.rooms[number]
    ids = ids_of(room.demands)
    shows, tables = find_shows(room.demands, ids), find_tables(room.demands, ids)
    found = []
    for demand, name, show, table in zip(room.demands, ids, shows, tables, strict=True):
        filled = fill_defaults(demand, name)
        filled = filled._replace(facing=filled.facing or show, at=table)
        if is_cash_desk(demand, room):
            filled = filled._replace(sizes=(measure_cash_desk(catalog),) * len(filled.sizes))
        sizes = _less(filled.sizes, [piece.size for piece in locked if piece.function == name])
        if sizes:
            asked = {other.category for other in room.demands if may_share_zone(demand, other)}
            own = name not in tables
            tall = max(size.height for size in sizes)
            chairs = out_of_table(demand.category, asked, catalog, tall) if own else 0.0
            least = filled.least and max(filled.least - len(filled.sizes) + len(sizes), 1)
            filled = filled._replace(sizes=sizes, least=least)
            found.append(with_floor(filled, chairs, seats_around(demand.category, catalog)))
    return found


def with_floor(wish: HallDemand, chairs: float, around: bool) -> HallDemand:
    """Tables with their chairs as one footprint. Clearances are measured from the table, so the
    chairs stand on them; a seatway stays behind the chairs."""
    if not chairs:
        return wish
    front, left, back, right = wish.clearance
    front, back = (max(depth - chairs, min(depth, SEATWAY)) for depth in (front, back))
    aside = chairs if around else 0.0
    if around:
        left, right = (max(depth - chairs, min(depth, SEATWAY)) for depth in (left, right))
    sizes = tuple(
        Size(size.width + 2 * aside, size.depth + 2 * chairs, size.height) for size in wish.sizes
    )
    return wish._replace(
        sizes=sizes, clearance=(front, left, back, right), chairs=chairs, aside=aside
    )


def _less(sizes: tuple[Size, ...], there: list[Size]) -> tuple[Size, ...]:
    """Sizes without one for each that is there already: the most alike."""
    left = list(sizes)
    for size in there[: len(sizes)]:
        left.remove(
            min(left, key=lambda one: abs(one.width - size.width) + abs(one.depth - size.depth))
        )
    return tuple(left)


def restrict_patterns(wishes: list[HallDemand], lean: int) -> list[HallDemand]:
    """Demands narrowed to one of their patterns each, drawn by ``lean``; all of them for 0."""
    if lean == 0:
        return wishes
    rng = np.random.default_rng(lean)
    return [
        wish._replace(patterns=(wish.patterns[int(rng.integers(len(wish.patterns)))],))
        for wish in wishes
    ]


def fill_defaults(demand: Demand, name: str) -> HallDemand:
    """A demand called ``name`` with all that follows from its category."""
    use = hall_use(demand.category)
    zones = (demand.zone,) if isinstance(demand.zone, str) else tuple(demand.zone or ())
    sizes = tuple(Size(*size) for size in sizes_of(demand))
    pews = is_pew(demand.category, sizes[0].width)
    usual = ("chain",) if pews else use.patterns
    patterns = _patterns(demand, use.place, usual, len(sizes))
    return HallDemand(
        id=name,
        name=demand.name or demand.id or name_of(demand.category),
        category=demand.category,
        sizes=sizes,
        clearance=_clearance(demand, usual_clearance(demand), patterns == ("wall",)),
        patterns=patterns,
        zones=zones,
        facing=demand.facing or "",
        required=demand.required,
        least=0 if demand.most is None else demand.count or 1,
        unplaced=demand.place is None and not demand.patterns,
        unstated=_is_unstated(demand),
        every=demand.aisle.every if demand.aisle else 0,
        aisle=demand.aisle.width if demand.aisle else 0.0,
        used=tuple(demand.used_from or ()),
    )


def _is_unstated(demand: Demand) -> bool:
    stated = (demand.patterns, demand.place, demand.facing, demand.clearance, demand.aisle)
    return not any(stated) and demand.most is None and demand.fill in (None, "none")


def _clearance(
    demand: Demand, usual: tuple[float, float, float, float], at_wall: bool
) -> tuple[float, float, float, float]:
    stated = usual if demand.clearance is None else demand.clearance
    front, left, back, right = stated if isinstance(stated, tuple) else (stated,) * 4
    if demand.clearance is None and at_wall and demand.category in TABLE_CHAIRS:
        return (max(front, back), 0.0, 0.0, 0.0)  # side by side, people before them
    return (front, left, 0.0 if at_wall else back, right)


def _patterns(demand: Demand, place: str, usual: tuple[str, ...], count: int) -> tuple[str, ...]:
    where = demand.place or ("wall" if demand.patterns == ["wall"] else None)
    if where == "wall" or (where is None and not demand.patterns and place == "wall"):
        return ("wall",)
    free = usual if set(usual) - {"wall"} else ("chain", "grid")
    if where == "free":
        free = tuple(name for name in free if name != "wall")
    chosen: tuple[str, ...] = tuple(demand.patterns) or free
    if count == 1 or set(chosen) == {"single"}:
        return ("single",)
    return tuple(name for name in chosen if count >= PATTERNS[name].least) or ("chain",)
