"""The smallest forms of what a room is for: tried only where nothing of the usual sizes fits.

They are real things at the lower end of what is sold (a bed of 0.7 x 1.6 m, a pantry kitchen, a
narrow wardrobe); no room that holds a usual size is given one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from math import pi

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Size
from scenewright.domains.home.groups.kitchen import short_runs, shortest_kitchenettes
from scenewright.domains.home.groups.sleeping import DEPTHS


def _bed() -> Iterator[Group]:
    """Beds with a long side at the wall, then shorter ones, with their head or a side at it."""
    for width, length in ((0.9, 2.05), (0.8, 1.9), (0.75, 1.8), (0.75, 1.7), (0.7, 1.6)):
        size = Size(width, length, 0.9)
        if length < 1.8:
            piece = Member("single_bed", 0, 0, 0, 0, size)
            yield Group("single", f"{width:.2f} m bed", width, length + 0.01, (piece,))
        piece = Member("single_bed", 0, 0, 0, pi / 2, size)
        yield Group("single", f"{width:.2f} m bed along", length, width + 0.01, (piece,))


def _wardrobe() -> Iterator[Group]:
    """Narrow ones as deep as all are: in a shallower one no hanger has room."""
    for width in (0.5, 0.45):
        piece = Member("wardrobe", 0, 0, 0, 0, Size(width, DEPTHS[0], 2.0))
        yield Group("wardrobe", f"{width:.2f} m wardrobe", width, DEPTHS[0] + 0.01, (piece,))


def _chest() -> Iterator[Group]:
    for width, depth in ((0.6, 0.4), (0.5, 0.38), (0.42, 0.36)):
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
