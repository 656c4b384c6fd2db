"""The case library: groups by function, found by width and depth.

Liu, Jiang, Mao, Wang (2017), section 3.4, take the group of the same function whose (length,
width) is nearest to the patch, by a bounded k-d tree, and do not ask whether it fits. We take
the nearest of those that *do* fit inside the patch, and shrink the patch to it. A function has
at most some 120 cases, among which a NumPy mask and sort find the nearest sooner than a tree.

A library is the shipped one unless a brief brings cases of its own: learned from furnished homes,
or made with the furniture of its catalogues.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache
from types import MappingProxyType
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.core.same import once
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.learned.habits import NONE, Habits

SLACK = 0.005
LARGER = 0.45
"""By how much a case may be wider or deeper than its patch, in metres: shipped, or real."""


class Cases(NamedTuple):
    """The cases of one function: groups, their (width, depth) as ``(n, 2)`` in metres; ``real``
    tells which are made of a user's own models: these come first. ``areas`` are those of
    the rooms learned cases were seen in, m² (NaN: not known). ``smallest`` is the index of the
    case of the least footprint."""

    groups: tuple[Group, ...]
    sizes: NDArray[np.float64]
    real: NDArray[np.bool_]
    areas: NDArray[np.float64]
    smallest: int


class Library(NamedTuple):
    """Cases by function where they are not the shipped ones, and what learned rooms tell of the
    others' habits; of ``seated`` functions it has the shipped cases that seat enough, and smaller
    ones are taken only where none of these fits."""

    own: Mapping[str, Cases] = MappingProxyType({})
    habits: Habits = NONE
    seated: frozenset[str] = frozenset()


SHIPPED = Library()


@cache
def shipped_cases(function: str) -> Cases:
    """The shipped cases of a group function."""
    return index_cases(tuple(GROUPS[function].cases()))


def index_cases(
    groups: tuple[Group, ...], real: tuple[bool, ...] = (), areas: tuple[float, ...] = ()
) -> Cases:
    """Cases, ready to be found by size; ``real`` tells which come first, ``areas`` of what rooms
    they are."""
    sizes = np.array([(g.width, g.depth) for g in groups])
    first = np.array(real or (False,) * len(groups))
    of_rooms = np.array(areas or (np.nan,) * len(groups))
    smallest = int(np.argmin(sizes.prod(-1)))
    return Cases(groups, sizes, first, of_rooms, smallest)


def subset(known: Cases, chosen: NDArray[np.bool_]) -> Cases:
    """Some of the cases, at least one, with all that is known of them.

    ``chosen`` (n,), one flag a case.
    """
    groups = tuple(group for group, stays in zip(known.groups, chosen, strict=True) if stays)
    real, areas = known.real[chosen].tolist(), known.areas[chosen].tolist()
    return index_cases(groups, tuple(real), tuple(areas))


def cases(function: str, library: Library = SHIPPED) -> Cases:
    """All cases of a group function."""
    return library.own.get(function) or shipped_cases(function)


def nearest(function: str, width: float, depth: float, library: Library = SHIPPED) -> Group:
    """The case nearest to a patch of this size, whether or not it fits (as printed).

    >>> nearest("media", 1.25, 0.4).name
    'TV on a 1.2 m stand'
    """
    found = cases(function, library)
    return found.groups[int(nearest_first(found.sizes, (width, depth))[0])]


def nearest_first(
    sizes: NDArray[np.float64], size: tuple[float, float], most: float = np.inf
) -> NDArray[np.int64]:
    """The rows of ``sizes`` (n, 2) that exceed ``size`` by at most ``most`` metres in width and in
    depth, by their distance |sizes - size| from it, the lower row first where equal.

    >>> sizes = np.array([(0.0, 0.0), (5.0, 1.0), (2.0, 2.0)])
    >>> nearest_first(sizes, (4.0, 0.0)).tolist(), nearest_first(sizes, (4.0, 1.0), 0.5).tolist()
    ([1, 2, 0], [0])
    """
    width, depth = float(size[0]) + most, float(size[1]) + most
    fits = np.flatnonzero((sizes[:, 0] <= width) & (sizes[:, 1] <= depth))
    off = (sizes[fits] - size).astype(np.longdouble)
    far = np.hypot(off[:, 0], off[:, 1]).astype(np.float64)  # rounded once: ties stay ties
    return fits[np.argsort(far, kind="stable")]


def fitting(
    function: str, width: float, depth: float, library: Library = SHIPPED
) -> tuple[Group, ...]:
    """The cases that fit inside a patch, nearest first; empty if none does.

    Those of a user's own furniture come before all others. They are few, so ones that are a
    little larger than the patch are given too: what they run into shows when they are tried.

    >>> [g.width <= 1.9 for g in fitting("wardrobe", 1.9, 0.7)][:3]
    [True, True, True]
    >>> fitting("sleeping", 1.0, 1.0)
    ()
    """
    return tuple(each_fitting(function, width, depth, library))


def each_fitting(
    function: str, width: float, depth: float, library: Library = SHIPPED
) -> Iterator[Group]:
    """The same one by one, as far as they are asked for."""
    found = cases(function, library)
    if not found.real.any():
        return (found.groups[i] for i in nearest_first(found.sizes, (width, depth), SLACK))
    order = nearest_first(found.sizes, (width, depth), LARGER)
    order = order[np.argsort(~found.real[order], kind="stable")]
    return (found.groups[i] for i in order)


def find_preferred_case(function: str, area: float, library: Library = SHIPPED) -> Group:
    """The case a designer would wish for in a room of this area.

    The cases ordered by footprint, at the share that the area takes of the row's ``roomy`` span;
    of learned ones that of the room most like in area.
    """
    small, large = GROUPS[function].roomy
    found = cases(function, library)
    if np.isfinite(found.areas).any():
        return found.groups[int(np.nanargmin(np.abs(np.log(found.areas / area))))]
    order = _order_by_footprint(found)
    share = min(max((area - small) / (large - small), 0.0), 1.0)
    return found.groups[order[round(share * (len(order) - 1))]]


@once(256)
def _order_by_footprint(found: Cases) -> list[int]:
    """The numbers of cases, the smallest first; of those a user has real models of, if any."""
    order = np.argsort(found.sizes.prod(-1), kind="stable")
    return (order[found.real[order]] if found.real.any() else order).tolist()
