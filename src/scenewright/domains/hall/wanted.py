"""What a hall is to hold: demands with everything filled in that the brief leaves open."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.assets.hall_use import hall_use
from scenewright.brief import Brief, Room
from scenewright.brief_hall import Demand
from scenewright.catalog import Catalog
from scenewright.scene import Piece, Size

MIXTURE_FROM = 6
SPECTATORS, SHOWS = ("auditorium_seat",), ("stage", "screen", "lectern")
"""What looks, unless told otherwise, at what."""


class Wanted(NamedTuple):
    """One demand: its id, what to call it, the sizes of its objects, the free depth at front,
    left, back and right of each, the patterns it may take, the zones it may go to (empty: any),
    the id of the demand it looks at (empty: none) and whether leaving it out is a failure."""

    id: str
    name: str
    category: str
    sizes: tuple[Size, ...]
    clearance: tuple[float, float, float, float]
    patterns: tuple[str, ...]
    zones: tuple[str, ...]
    facing: str
    required: bool

    @property
    def at_wall(self) -> bool:
        """Whether its objects stand at walls."""
        return self.patterns == ("wall",)


def wanted(brief: Brief, number: int, locked: tuple[Piece, ...], catalog: Catalog) -> list[Wanted]:
    """The demands of room ``number`` less what stands there ``locked`` already."""
    room = brief.rooms[number]
    ids = demand_ids(room)
    found = []
    for demand, name in zip(room.demands, ids, strict=True):
        there = sum(piece.function == name for piece in locked)
        filled = _filled(demand, name, catalog)
        if len(filled.sizes) > there:
            found.append(filled._replace(sizes=filled.sizes[there:]))
    shows = [wish.id for wish in found if wish.category in SHOWS]
    return [
        wish._replace(facing=wish.facing or shows[0])
        if shows and wish.category in SPECTATORS
        else wish
        for wish in found
    ]


def leaning(wishes: list[Wanted], lean: int) -> list[Wanted]:
    """Demands narrowed to one of their patterns each, drawn by ``lean``; all of them for 0."""
    if lean == 0:
        return wishes
    rng = np.random.default_rng(lean)
    return [
        wish._replace(patterns=(wish.patterns[int(rng.integers(len(wish.patterns)))],))
        for wish in wishes
    ]


def demand_ids(room: Room) -> tuple[str, ...]:
    """The id of every demand: the one given, else its category, numbered where it is taken."""
    ids: list[str] = []
    given = {demand.id for demand in room.demands if demand.id}
    for demand in room.demands:
        name, count = demand.id or demand.category, 1
        while not demand.id and (name in ids or name in given):
            count += 1
            name = f"{demand.category}-{count}"
        ids.append(name)
    return tuple(ids)


def _filled(demand: Demand, name: str, catalog: Catalog) -> Wanted:
    use = hall_use(demand.category)
    zones = (demand.zone,) if isinstance(demand.zone, str) else tuple(demand.zone or ())
    sizes = _sizes(demand, catalog)
    patterns = _patterns(demand, use.place, use.patterns, len(sizes))
    return Wanted(
        id=name,
        name=demand.name or demand.id or demand.category.replace("_", " "),
        category=demand.category,
        sizes=sizes,
        clearance=_clearance(demand, use.clearance, patterns == ("wall",)),
        patterns=patterns,
        zones=zones,
        facing=demand.facing or "",
        required=demand.required,
    )


def _sizes(demand: Demand, catalog: Catalog) -> tuple[Size, ...]:
    if demand.sizes:
        return tuple(Size(*size) for size in demand.sizes)
    size = Size(*demand.size) if demand.size else usual_size(demand.category, catalog)
    count = demand.count or 1
    if demand.length is not None:
        count = max(math.ceil(demand.length / size.width - 1e-6), 1)
    return (size,) * count


def usual_size(category: str, catalog: Catalog) -> Size:
    """The usual size of a category's first asset."""
    assets = catalog.of(category)
    return assets[0].usual if assets else Size(1.0, 0.6, 1.0)


def _clearance(
    demand: Demand, usual: tuple[float, float, float, float], at_wall: bool
) -> tuple[float, float, float, float]:
    stated = usual if demand.clearance is None else demand.clearance
    front, left, back, right = stated if isinstance(stated, tuple) else (stated,) * 4
    return (front, left, 0.0 if at_wall else back, right)


def _patterns(demand: Demand, place: str, usual: tuple[str, ...], count: int) -> tuple[str, ...]:
    where = demand.place or ("wall" if demand.patterns == ["wall"] else None)
    if where == "wall" or (where is None and not demand.patterns and place == "wall"):
        return ("wall",)
    free = tuple(name for name in usual if name != "wall") or ("chain", "grid")
    chosen: tuple[str, ...] = tuple(demand.patterns) or free
    if count == 1:
        return ("single",)
    chosen = tuple(p for p in chosen if p != "mixture" or count >= MIXTURE_FROM)
    return chosen or ("chain",)
