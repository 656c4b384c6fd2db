"""The demands of a hall, checked: how many objects of what size, and the floor they need."""

from __future__ import annotations

import difflib

import numpy as np

from scenewright.building.plan import place
from scenewright.catalog.assets import shipped
from scenewright.catalog.kinds import SIZES, hall_use, name_of
from scenewright.catalog.suggestions import offer_kinds
from scenewright.core.brief import Brief
from scenewright.core.brief.zones import Demand, Sizes
from scenewright.core.errors import InputError
from scenewright.core.kind import SIDES
from scenewright.core.space import Space
from scenewright.domains.hall.classes import PEW_PITCH, is_pew
from scenewright.domains.hall.demands.stand_ins import offer_stand_in
from scenewright.domains.hall.demands.themes import read_theme
from scenewright.domains.hall.measures import AISLE
from scenewright.domains.hall.patterns import PATTERNS

MOST_OBJECTS = 20_000
USED = 0.75
"""Free depth before a side that people come to, at least, in metres."""
LEAST_FOOTPRINT = 0.0025
"""Square metres: what is smaller is a slip of the unit of length."""


def sizes_of(demand: Demand) -> tuple[Sizes, ...]:
    """Width, depth and height of every object of a demand.

    Of 1 if nothing else is said; of ``length`` metres of front as many as fit side by side.

    >>> len(sizes_of(Demand(category="bookcase", length=10.0, size=(0.9, 0.3, 2.0))))
    11
    """
    if demand.sizes:
        return tuple(demand.sizes)
    width, depth, height = usual_size(demand)
    count = demand.most or demand.count or 1
    if demand.length is not None:
        count = int(demand.length / width + 1e-9)
    return ((width, depth, height),) * count


def usual_size(demand: Demand) -> Sizes:
    """The size given, else the usual one of the category."""
    if demand.size is not None:
        return demand.size
    usual = SIZES[demand.category][1]
    return (usual[0], usual[1], usual[2])


def ids_of(demands: list[Demand]) -> tuple[str, ...]:
    """The id of every demand: the one given, else its category, with a number where taken.

    >>> ids_of([Demand(category="bench"), Demand(category="bench"), Demand(id="b", category="box")])
    ('bench', 'bench-2', 'b')
    """
    taken = {demand.id for demand in demands if demand.id}
    found: list[str] = []
    for demand in demands:
        names = (
            demand.category if count == 1 else f"{demand.category}-{count}"
            for count in range(1, len(demands) + len(taken) + 2)
        )
        found.append(demand.id or next(name for name in names if name not in taken))
        taken.add(found[-1])
    return tuple(found)


def floor_needed(demand: Demand) -> float:
    """Square metres a demand needs: of every object (width + left + right) (depth + front +
    back), with the clearance of its category where the demand does not state one."""
    clear = usual_clearance(demand) if demand.clearance is None else demand.clearance
    front, left, back, right = clear if isinstance(clear, tuple) else (clear,) * 4
    sizes = np.array(sizes_of(demand), float).reshape(-1, 3)
    return float(((sizes[:, 0] + left + right) * (sizes[:, 1] + front + back)).sum())


def usual_clearance(demand: Demand) -> tuple[float, float, float, float]:
    """The free depth at front, left, back and right of each object that is usual for a category;
    of pews what is left of their pitch, and half an aisle at both ends; where it is said from which
    sides they are used, only there."""
    width, depth, _ = usual_size(demand)
    if is_pew(demand.category, width):
        return (max(PEW_PITCH - depth, 0.0), 0.5 * AISLE, 0.0, 0.5 * AISLE)
    usual = hall_use(demand.category).clearance
    if not demand.used_from:
        return usual
    front, left, back, right = (max(*usual, USED) * (s in demand.used_from) for s in SIDES)
    return (front, left, back, right)


def check_demands(brief: Brief, number: int, space: Space) -> None:
    """InputError for a demand of room ``number`` that cannot be meant."""
    demands = brief.rooms[number].demands
    if brief.rooms[number].theme:
        read_theme(brief.rooms[number].theme or "", place(brief, number, "theme"))
    ids = ids_of(demands)
    total, seen = 0, set[str]()
    for index, demand in enumerate(demands):
        where = place(brief, number, f"demands[{index}] '{demand.id or demand.category}'")
        if demand.id and demand.id in seen:
            raise InputError("the id is used twice", "give every demand its own id", place=where)
        seen.add(demand.id)
        _check_category(demand, where)
        _check_number(demand, where)
        _check_sizes(demand, space, where)
        _check_patterns(demand, where)
        _check_place(demand, where)
        _check_facing(demand, ids[index], ids, where)
        _check_clearance(demand, space, where)
        _check_aisle(demand, where)
        total += len(sizes_of(demand))
        if total > MOST_OBJECTS:
            raise InputError(
                f"brings the objects of this hall to {total}",
                f"at most {MOST_OBJECTS} can be laid out at once: divide the hall",
                place=where,
            )


def _check_category(demand: Demand, where: str) -> None:
    kinds = shipped().kinds
    if demand.category not in kinds:
        fault = f"'{demand.category}' is not a kind of the catalog"
        near = offer_stand_in(demand.category, kinds) or offer_kinds(demand.category, kinds)
        raise InputError(fault, near, place=where)
    if kinds[demand.category].support != "floor":
        raise InputError(
            f"a {name_of(demand.category)} does not stand on the floor",
            offer_stand_in(demand.category, kinds, unknown=False) or "ask for things that do",
            place=where,
        )
    if demand.size is None and not demand.sizes and demand.category not in SIZES:
        raise InputError(
            f"the usual size of a {name_of(demand.category)} is not known",
            "give its size",
            place=where,
        )


def _check_number(demand: Demand, where: str) -> None:
    if demand.sizes and demand.size is not None:
        raise InputError("has both size and sizes", "leave out one of them", place=where)
    if demand.sizes and demand.length is not None:
        raise InputError("has both sizes and length", "leave out one of them", place=where)
    if demand.sizes and demand.count not in (None, len(demand.sizes)):
        raise InputError(
            f"count is {demand.count}, but {len(demand.sizes)} sizes are listed",
            "leave out count, or list a size for every object",
            place=where,
        )
    for key in ("most", "fill"):
        if getattr(demand, key) is not None and demand.sizes:
            raise InputError(f"has both sizes and {key}", "leave out one of them", place=where)
    if demand.most is not None and demand.most < (demand.count or 1):
        raise InputError(
            f"most is {demand.most}, but count {demand.count}",
            "give a greater most: count is the least",
            place=where,
        )
    if demand.length is None:
        return
    if demand.most is not None:
        raise InputError("has both length and most", "leave out one of them", place=where)
    if demand.count is not None:
        raise InputError("has both count and length", "leave out one of them", place=where)
    width = usual_size(demand)[0]
    if demand.length < width:
        raise InputError(
            f"one {name_of(demand.category)} is {width:g} m wide, more than the length of "
            f"{demand.length:g} m",
            "give a greater length, a smaller size, or a count",
            place=where,
        )
    if demand.length / width > MOST_OBJECTS:
        raise InputError(
            f"{demand.length:g} m are {demand.length / width:.0f} objects of {width:g} m",
            "lengths are metres: give a smaller length or a larger size",
            place=where,
        )


def _check_aisle(demand: Demand, where: str) -> None:
    if demand.aisle and shipped().kinds[demand.category].chairs:
        raise InputError(
            f"rows of {name_of(demand.category)} are not broken by an aisle",
            "leave 'aisle' out: tables bring chairs, and ways between these",
            place=where,
        )


def _check_sizes(demand: Demand, space: Space, where: str) -> None:
    stated = np.array(demand.sizes or [demand.size or (1.0, 1.0, 0.0)], float)
    width, depth, _ = stated[int((stated[:, 0] * stated[:, 1]).argmin())]
    if width * depth < LEAST_FOOTPRINT:
        raise InputError(
            f"one is only {width:g} by {depth:g} m",
            "lengths are metres: give its size",
            place=where,
        )
    tallest = stated[:, 2].max()
    if tallest > space.height + 1e-6:
        raise InputError(
            f"one is {tallest:g} m tall, {tallest - space.height:.2f} m more than the hall",
            "give a lower one, or the hall its height",
            place=where,
        )


def _check_patterns(demand: Demand, where: str) -> None:
    for name in demand.patterns:
        if name not in PATTERNS:
            remedy = f"use one of: {', '.join(PATTERNS)}"
            raise InputError(f"'{name}' is not a pattern", remedy, place=where)


def _check_place(demand: Demand, where: str) -> None:
    if demand.place is None or not demand.patterns:
        return
    if demand.place == "free" and demand.patterns == ["wall"]:
        raise InputError(
            "is to stand free, but in the pattern of walls", "leave out one of them", place=where
        )
    if demand.place == "wall" and "wall" not in demand.patterns:
        raise InputError(
            f"is to stand at a wall, but in the pattern {' or '.join(demand.patterns)}",
            "leave out place or patterns",
            place=where,
        )


def _check_facing(demand: Demand, own: str, ids: tuple[str, ...], where: str) -> None:
    if demand.facing is None:
        return
    others = [name for name in ids if name != own]
    if demand.facing == own:
        raise InputError("is to face itself", "name another demand in facing", place=where)
    if demand.facing not in others:
        near = difflib.get_close_matches(demand.facing, others, 3) or others[:12]
        remedy = f"use one of: {', '.join(near)}" if near else "leave it out"
        raise InputError(
            f"'{demand.facing}' in facing is not a demand of the hall", remedy, place=where
        )


def _check_clearance(demand: Demand, space: Space, where: str) -> None:
    extent = float(np.ptp(space.outline, axis=0).max())
    clear = demand.clearance if isinstance(demand.clearance, tuple) else (demand.clearance or 0.0,)
    if max(clear) > extent:
        raise InputError(
            f"asks for {max(clear):g} m free, but the hall is only {extent:.2f} m long",
            "clearances are metres: give a smaller one",
            place=where,
        )
