"""Pose a room as a problem: wishes become patches with sizes, sides, relations."""

from __future__ import annotations

from functools import lru_cache, partial
from itertools import chain
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.cases.library import SHIPPED, Library, cases, find_preferred_case
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.learned import habits
from scenewright.domains.home.problem import Ground, Items, Problem, empty_items
from scenewright.domains.home.programme import MODEST, Wish
from scenewright.domains.home.terms.table import TERMS

NAN = float("nan")
USUAL = 16.0  # area of all furniture from which areas do not count less, square metres


class Relation(NamedTuple):
    """Two groups that belong together: distance between their centres in metres, angle between
    their headings, bearing of the second from the first's front (NaN: any) and weight; it does
    not hold in a room that has ``unless`` too, nor in one without any of ``within``, if stated.

    A metre of distance costs as much as a radian of bearing. Where a seat and its screen have both
    in one relation, a room too narrow for the distance has the seat slide aside to be far
    enough; so the distance is one of its own, and weighs less."""

    first: str
    second: str
    distance: float
    angle: float
    bearing: float
    weight: float
    unless: str = ""
    within: frozenset[str] = frozenset()


RELATIONS: tuple[Relation, ...] = (
    Relation("seating", "media", NAN, np.pi, 0.0, 4.0),
    Relation("media", "seating", NAN, np.pi, 0.0, 4.0),
    Relation("seating", "media", 2.5, NAN, NAN, 3.0),
    Relation("sleeping", "media", 2.8, np.pi, 0.0, 2.0, "seating"),
    Relation("media", "sleeping", 2.8, np.pi, 0.0, 2.0, "seating"),
    Relation("seating", "dining", 3.4, NAN, NAN, 0.3),
    Relation("kitchenette", "fridge", 1.2, 0.0, NAN, 1.0),
    Relation("kitchen", "counter", 1.9, NAN, NAN, 0.6),
    Relation("kitchen", "dining", 2.4, NAN, NAN, 0.3),
    Relation("kitchen", "island", 1.9, NAN, 0.0, 2.0),
    Relation("sleeping", "vanity", 2.6, NAN, NAN, 0.1),
    Relation("sleeping", "wardrobe", 2.4, NAN, NAN, 0.6, within=RUNS),
    Relation("seating", "sleeping", 5.5, NAN, NAN, 0.4, within=RUNS),
    Relation("desk", "shelf", 1.8, NAN, NAN, 0.3, within=RUNS),
)


OF_AREAS = frozenset(row.name for row in TERMS if row.per_area)
"""Terms that count square metres."""


def build_problem(
    ground: Ground,
    wishes: tuple[Wish, ...],
    weights: dict[str, float],
    printed: bool,
    route_width: float,
    area: float,
    library: Library = SHIPPED,
) -> Problem:
    """The problem of placing ``wishes`` on ``ground``; items in the order of the wishes, their
    sizes those of a room of ``area`` square metres."""
    groups = [w.group for w in wishes]
    return Problem(
        ground,
        items_of(wishes, area, library),
        tuple(number_names(groups)),
        weights,
        printed,
        route_width,
    )


def scale_area_weights(weights: dict[str, float], items: Items) -> dict[str, float]:
    """Weights for a room of these items: what counts areas counts a square metre as much as in a
    room with :data:`USUAL` square metres of furniture.

    Such terms are divided by the area of all items (Liu et al. 2017), so in an open plan with
    thrice as much furniture a shelf before a door would weigh a third, but a relation as ever.

    >>> items = empty_items(2)._replace(wish=np.array([[6.0, 4.0], [4.0, 2.0]]))
    >>> scale_area_weights({"keep_free": 100.0, "pairs": 10.0}, items)
    {'keep_free': 200.0, 'pairs': 10.0}
    """
    areas = items.wish.prod(-1)
    areas[np.isnan(areas)] = 0.0
    share = max(float(areas.sum()) / USUAL, 1.0)
    return {name: w * share if name in OF_AREAS else w for name, w in weights.items()}


def items_of(wishes: tuple[Wish, ...], area: float, library: Library = SHIPPED) -> Items:
    """Patches as arrays: size range from the case library, behaviour from the table of groups."""
    if not wishes:
        return NO_ITEMS
    of = _shipped_row if library is SHIPPED else partial(_row_of, library=library)
    rows = np.array([of(w, area) for w in wishes], np.float64)
    pairs, targets, weights = relate([w.group for w in wishes], library, RELATIONS)
    columns, start = dict[str, Any](), 0
    for name, width in COLUMNS.items():
        field = rows[:, start] if width == 1 else rows[:, start : start + width]
        columns[name], start = np.ascontiguousarray(field), start + width
    return NO_ITEMS._replace(**columns, pairs=pairs, pair_targets=targets, pair_weights=weights)


NO_ITEMS = empty_items(0)
COLUMNS = {
    "low": 2,
    "high": 2,
    "wish": 2,
    "height": 1,
    "back_to_wall": 1,
    "main_wall": 1,
    "clear": 4,
    "access": 4,
    "inset": 4,
    "daylight": 1,
    "nestle": 1,
    "shades": 1,
    "symmetry": 1,
}
"""What :func:`_row_of` gives of an item, in this order, and how many numbers each is."""


def _row_of(wish: Wish, area: float, library: Library) -> tuple[float, ...]:
    """One item in numbers, as :data:`COLUMNS`."""
    kind, sizes = GROUPS[wish.group], sizes_of(wish, area, library)
    clear = habits.clear(library.habits, wish.group, kind.clear)
    sides = (*clear, *kind.access, *kind.inset)
    even = 0.0 if wish.group in library.own.keys() - library.seated else kind.symmetry  # as learned
    wants = (kind.daylight, kind.nestle, kind.shades, even)
    return (*chain(*sizes), kind.height, kind.back, kind.main, *sides, *wants)


@lru_cache(maxsize=4096)
def _shipped_row(wish: Wish, area: float) -> tuple[float, ...]:
    """The same with the shipped cases."""
    return _row_of(wish, area, SHIPPED)


def sizes_of(
    wish: Wish, area: float, library: Library = SHIPPED
) -> tuple[tuple[float, float], ...]:
    """Least, greatest and wished (width, depth): the least is that of the smallest real case
    that becomes the room (of any case if the wish may be small). Where the library is one's own,
    what is essential may be as modest as the rest."""
    known, fits = cases(wish.group, library), select_allowed(wish, library)
    found, real = known.sizes[fits], known.real[fits]
    goal = find_preferred_case(wish.group, area, library)
    if not wish.small:
        found = found[real] if real.any() else found
        footprints = found.prod(-1)
        becoming = wish.becoming if library is SHIPPED else min(wish.becoming, MODEST)
        found = found[footprints >= becoming * min(goal.width * goal.depth, footprints.max())]
    low = found[int(np.argmin(found.prod(-1)))]
    high = np.maximum(found.max(0), low)
    ideal = np.clip([goal.width, goal.depth], low, high)
    return tuple(low), tuple(high), tuple(ideal)


def select_allowed(wish: Wish, library: Library = SHIPPED) -> NDArray[np.bool_]:
    """Which cases ``(n,)`` of a group are no larger than asked for; the smallest if none is."""
    known = cases(wish.group, library)
    if wish.most is None:
        return np.ones(len(known.sizes), bool)
    fits = np.asarray((known.sizes <= np.array(wish.most) + 1e-9).all(-1))
    fits[known.smallest] |= not fits.any()
    return fits


def relate(
    groups: list[str], library: Library, table: tuple[Relation, ...]
) -> tuple[NDArray[np.int64], NDArray[np.float64], NDArray[np.float64]]:
    """The relations between groups that stand, at the distances and angles of a library."""
    held = [r for r in table if holds(r, groups)]
    pairs = [(groups.index(r.first), groups.index(r.second)) for r in held]
    targets = [
        (
            habits.distance(library.habits, (r.first, r.second), r.distance),
            habits.angle(library.habits, (r.first, r.second), r.angle),
            r.bearing,
        )
        for r in held
    ]
    return (
        np.array(pairs, np.int64).reshape(-1, 2),
        np.array(targets, np.float64).reshape(-1, 3),
        np.array([r.weight for r in held], np.float64),
    )


def holds(relation: Relation, groups: list[str]) -> bool:
    """Whether a relation is wanted in a room of these groups."""
    both = {relation.first, relation.second} <= set(groups) and relation.unless not in groups
    return both and (not relation.within or any(g in groups for g in relation.within))


def number_names(groups: list[str]) -> list[str]:
    """Names for items: the group's, with a number from the second of its kind on.

    >>> number_names(["shelf", "plant", "shelf"])
    ['shelf', 'plant', 'shelf_2']
    """
    names: list[str] = []
    for i, group in enumerate(groups):
        again = groups[:i].count(group)
        names.append(f"{group}_{again + 1}" if again else group)
    return names
