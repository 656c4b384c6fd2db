"""The smallest forms of what a room is for: tried only where nothing of the usual sizes fits.

They are real things at the lower end of what is sold and used (a bed of 0.8 x 1.9 m, a pantry
kitchen, a narrow wardrobe), none below :mod:`.least_sizes`; no room that holds a usual size is
given one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.groups.kitchen import short_runs, shortest_kitchenettes
from scenewright.domains.home.least_sizes import BED, CHEST, SHALLOW_WARDROBE, WARDROBE


def _bed() -> Iterator[Group]:
    """Beds with a long side at the wall, the longer first."""
    for width, length in ((0.9, 2.05), BED[:2]):
        piece = Member("single_bed", 0, 0, 0, pi / 2, Size(width, length, 0.9))
        yield Group("single", f"{width:.2f} m bed along", length, width + 0.01, (piece,))


def _wardrobe() -> Iterator[Group]:
    """Narrow ones as deep as all are, then shallow ones in which hangers face the door."""
    for width in (0.5, WARDROBE.width):
        piece = Member("wardrobe", 0, 0, 0, 0, Size(width, WARDROBE.depth, 2.0))
        yield Group("wardrobe", f"{width:.2f} m wardrobe", width, WARDROBE.depth + 0.01, (piece,))
    for rails, depth in product((3, 2), (0.45, SHALLOW_WARDROBE.depth)):
        width = rails * SHALLOW_WARDROBE.width
        size = Size(width, depth, 2.0)
        piece = Member("wardrobe", 0, 0, 0, 0, size, asset="wardrobe_shallow")
        yield Group("wardrobe", f"{width:.1f} m shallow wardrobe", width, depth + 0.01, (piece,))


def _chest() -> Iterator[Group]:
    width, depth, _ = CHEST
    piece = Member("chest_of_drawers", 0, 0, 0, 0, Size(width, depth, 0.8))
    yield Group("chest", f"{width:.1f} m chest of drawers", width, depth + 0.01, (piece,))


def _seating() -> Iterator[Group]:
    """A lone loveseat, its back at the wall."""
    piece = Member("loveseat", 0, 0, 0, 0, Size(1.2, 0.8, 0.8))
    yield Group("seating", "1.2 m loveseat", 1.2, 0.82, (piece,))


def _shower() -> Iterator[Group]:
    """A tray, then what turns the whole floor into one: a wet room, with its shower on a wall."""
    tray = Member("shower", 0, 0, 0, 0, Size(0.66, 0.66, 2.0))
    yield Group("shower", "0.66 m shower", 0.66, 0.66, (tray,))
    panel = Member("wall_shower", 0, 0, 0, 0, Size(0.3, 0.12, 2.1))
    yield Group("shower", "wet room shower", 0.3, 0.13, (panel,))


def _toilet() -> Iterator[Group]:
    piece = Member("toilet", 0, 0, 0, 0, Size(0.34, 0.49, 0.74))
    yield Group("toilet", "short toilet", 0.34, 0.5, (piece,))


LEAST: dict[str, Callable[[], Iterator[Group]]] = {
    "single": _bed,
    "wardrobe": _wardrobe,
    "chest": _chest,
    "seating": _seating,
    "shower": _shower,
    "toilet": _toilet,
    "kitchen": short_runs,
    "kitchenette": shortest_kitchenettes,
}
"""Further cases of some groups, each smaller than all of :data:`.GROUPS`."""
