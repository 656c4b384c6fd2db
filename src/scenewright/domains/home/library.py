"""The case library: groups by function, found by width and depth with a k-d tree.

Liu, Jiang, Mao, Wang (2017), section 3.4, take the group of the same function whose (length,
width) is nearest to the patch, by a bounded k-d tree, and do not ask whether it fits. We take
the nearest of those that *do* fit inside the patch, and shrink the patch to it.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog import Group
from scenewright.domains.home.groups import GROUPS
from scenewright.geometry.kd_tree import Node, nearest_first, plant


class Cases(NamedTuple):
    """The cases of one function: groups, their (width, depth) as ``(n, 2)`` and its k-d tree."""

    groups: tuple[Group, ...]
    sizes: NDArray[np.float64]
    tree: Node | None


@cache
def cases(function: str) -> Cases:
    """All cases of a group function."""
    groups = tuple(GROUPS[function].cases())
    sizes = np.array([(g.width, g.depth) for g in groups])
    return Cases(groups, sizes, plant(sizes.tolist()))


def nearest(function: str, width: float, depth: float) -> Group:
    """The case nearest to a patch of this size, whether or not it fits (as printed).

    >>> nearest("media", 1.25, 0.4).name
    'TV on a 1.2 m stand'
    """
    found = cases(function)
    return found.groups[next(nearest_first(found.tree, (width, depth)))]


def fitting(function: str, width: float, depth: float, slack: float = 0.005) -> tuple[Group, ...]:
    """The cases that fit inside a patch, nearest first; empty if none does.

    >>> [g.width <= 1.9 for g in fitting("wardrobe", 1.9, 0.7)][:3]
    [True, True, True]
    >>> fitting("sleeping", 1.0, 1.0)
    ()
    """
    found = cases(function)
    most = (width + slack, depth + slack)
    return tuple(found.groups[i] for i in nearest_first(found.tree, (width, depth), most))


def wished(function: str, area: float) -> Group:
    """The case a designer would wish for in a room of this area.

    The cases ordered by footprint, at the share that the area takes of the row's ``roomy`` span.
    """
    small, large = GROUPS[function].roomy
    found = cases(function)
    order = np.argsort(found.sizes.prod(-1), kind="stable")
    share = np.clip((area - small) / (large - small), 0, 1)
    return found.groups[int(order[round(share * (len(order) - 1))])]
