"""Mats and rugs on floor that is left free: before the bath or a sofa, in the hall, amid a bedroom.

A mat bars no way, so it is laid last: the largest that lies on free floor, clear of doors, between
what stands there. Rooms with a rug of their own have enough.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from math import cos, pi, remainder, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.home.furnishing.obstacles import (
    StandingObstacles,
    find_faults,
    flat_kinds,
    standing_of,
)
from scenewright.domains.home.problem import Ground

Floats = NDArray[np.float64]

THICK = 0.012  # of a mat, metres
GAP = 0.04  # between a bath and the mat before it, metres
STEP = 0.1  # between places looked at, metres
HALL = ((2.4, 0.8), (2.0, 0.8), (2.4, 0.6), (1.6, 0.8), (1.8, 0.6), (1.2, 0.7), (0.9, 0.6))
ROOM = ((2.3, 1.6), (2.0, 1.4), (1.7, 1.2), (1.4, 1.0), (1.2, 0.8))
BATH = ((1.2, 0.7), (1.0, 0.6), (0.9, 0.6), (0.8, 0.5), (0.6, 0.5), (0.5, 0.4))
"""Widths and depths, metres, the largest first."""
USUAL = 0.9  # width of a mat that may be longer than what it lies before, metres
BATHS = ("bathtub", "shower", "basin", "pedestal_basin")
"""What one steps from onto a mat, the first there is."""
SOFAS = ("sofa", "corner_sofa", "loveseat")
BEYOND = (0.6, 0.4, 0.2)  # a rug before a sofa without a table is so much wider, metres
DEPTHS = (1.4, 1.2, 1.0, 0.8)  # and so deep, metres


class Margin(NamedTuple):
    """Sizes of the rug of a room, and the floor left free round it, metres."""

    sizes: tuple[tuple[float, float], ...]
    margin: float


RUGS: dict[str, Margin] = {
    "hall": Margin(HALL, 0.12),
    "bedroom": Margin(ROOM, 0.1),
    "double_bedroom": Margin(ROOM, 0.1),
    "single_bedroom": Margin(ROOM, 0.1),
    "child_bedroom": Margin(ROOM, 0.1),
    "study": Margin(ROOM, 0.1),
}
"""Rooms by function that have a rug amid their free floor."""
BUSY = frozenset(("living", "dining", "kitchen", "toilet"))
"""Rooms in which a rug that goes with no furniture lies in the way, halls besides or not."""


def lay_mats(
    space: Space, ground: Ground, pieces: Sequence[Piece], catalog: Catalog
) -> list[Piece]:
    """The mat of a room in which ``pieces`` stand; none where it has a rug or no floor is free.

    >>> from scenewright.building.plan import spaces
    >>> from scenewright.catalog.assets import shipped
    >>> from scenewright.domains.home.ground import ground_of
    >>> from scenewright.formats import read
    >>> (hall,) = (s for s in spaces(read("sample:home-flat")) if "hall" in s.functions)
    >>> [mat.category for mat in lay_mats(hall, ground_of(hall, (), 6.0), (), shipped())]
    ['rug']
    """
    here = [p for p in pieces if p.space == space.id]
    if any(p.category == "rug" for p in here):
        return []
    standing = standing_of(tuple(pieces), flat_kinds(catalog))
    for box in _choose_boxes(space, ground, here, standing):
        x, y, heading, width, depth = box.tolist()
        size = Size(width, depth, THICK)
        asset = catalog.choose("rug", size)
        name, pose = f"{space.id}/mat", Pose(x, y, 0.0, heading)
        drawn = asset.id if asset else ""
        return [Piece(name, "rug", drawn, space.id, pose, size, space.id, "light")]
    return []


def _choose_boxes(
    space: Space, ground: Ground, here: Sequence[Piece], standing: StandingObstacles
) -> Iterator[Floats]:
    """Boxes (5,) of mats that lie on free floor, the best first."""
    if "bathroom" in space.functions:
        for bath in (p for name in BATHS for p in here if p.category == name):
            sizes = tuple(s for s in BATH if s[0] <= max(bath.size.width, USUAL))
            for side in _open_sides(bath):
                yield from _before(side, sizes, ground, standing)
    if "living" in space.functions:
        for sofa in (p for p in here if p.category in SOFAS):
            wide = product(DEPTHS, BEYOND)
            sizes = tuple((sofa.size.width + beyond, deep) for deep, beyond in wide)
            yield from _before(sofa, sizes, ground, standing)
    if BUSY.isdisjoint(space.functions):
        for rug in (RUGS[f] for f in space.functions if f in RUGS):
            yield from _amid(ground, standing, rug)


def _open_sides(bath: Piece) -> Iterator[Piece]:
    """A bath as it stands, and turned round: the front of a tub of a user's own may be at a wall,
    and one gets in from the other long side."""
    yield bath
    if bath.category == "bathtub":
        yield replace(
            bath, pose=bath.pose._replace(heading=remainder(bath.pose.heading + pi, 2 * pi))
        )


def _before(
    piece: Piece, sizes: Sequence[tuple[float, float]], ground: Ground, standing: StandingObstacles
) -> Iterator[Floats]:
    """Mats before a piece, the first of the ``sizes`` first, at its middle or aside."""
    (x, y, _, heading), c, s = piece.pose, cos(piece.pose.heading), sin(piece.pose.heading)
    for width, depth in sizes:
        ahead = piece.size.depth / 2 + GAP + depth / 2
        room = abs(piece.size.width - width) / 2
        aside = sorted(np.arange(-room, room + 1e-9, STEP), key=abs)
        boxes = np.array(
            [(x + c * ahead - s * t, y + s * ahead + c * t, heading, width, depth) for t in aside]
        )
        yield from boxes[_lie_free(boxes, ground, standing, 0.0)]


def _amid(ground: Ground, standing: StandingObstacles, rug: Margin) -> Iterator[Floats]:
    """The largest rug, along the longest wall or across, in the middle of where it can lie."""
    x0, y0, x1, y1 = ground.bounds.tolist()
    x, y = (a.ravel() for a in np.meshgrid(np.arange(x0, x1, STEP), np.arange(y0, y1, STEP)))
    walls = ground.walls
    longest = walls[np.argmax(np.hypot(walls[:, 2] - walls[:, 0], walls[:, 3] - walls[:, 1]))]
    along = float(np.arctan2(longest[3] - longest[1], longest[2] - longest[0])) + np.pi / 2
    for width, depth in rug.sizes:
        for turn in (along, along + np.pi / 2):
            boxes = np.column_stack([x, y, *(np.full(len(x), v) for v in (turn, width, depth))])
            free = boxes[_lie_free(boxes, ground, standing, rug.margin)]
            if len(free):
                off = np.hypot(*(free[:, :2] - free[:, :2].mean(0)).T)
                yield free[np.argmin(off)]


def _lie_free(
    boxes: Floats, ground: Ground, standing: StandingObstacles, margin: float
) -> NDArray[np.bool_]:
    """On which of the boxes (n, 5), ``margin`` metres wider on each side, nothing stands and no
    door opens."""
    wider = boxes + np.array([0.0, 0.0, 0.0, 2 * margin, 2 * margin])
    spans = np.tile((0.0, THICK), (len(boxes), 1))
    return find_faults(wider, spans, ground._replace(windows=ground.windows[:0]), standing) == 0
