"""Tall things between the eye and what stands behind them, drawn as if of glass in pictures from
above at an angle.

A wardrobe 2 m high hides the bed behind it, a partition the exhibits of the next zone. An eye that
looks ``towards`` (x, y, z) sees what stands at a height h hidden by whatever lies nearer and rises
higher: the footprint of a tall thing, swept away from the eye by (its height - h) |xy| / |z|. A
piece counts as hidden by its middle.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import Geometry

from scenewright.core.catalog import Material, Part
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece

Floats = NDArray[np.float64]

TALL = 1.5
"""Pieces as high as this above the floor hide others, metres."""
WIDE = 0.8
"""So do only those as wide as this, metres: one looks past a plant."""
HIDDEN = 0.35
"""Share of a piece's footprint that is hidden when it counts."""
CLEAR = 0.6
"""How opaque what hides others is drawn."""
WALL = "partition"
SLIGHT = 0.04
"""What stands on less floor than this is not looked for behind others, square metres."""


def find_hiding(pieces: Sequence[Piece], towards: tuple[float, float, float]) -> frozenset[str]:
    """The ids of the tall pieces of a level that hide others for an eye looking ``towards`` a
    direction; what looks straight down or up hides nothing.

    >>> from scenewright.core.scene import Pose, Size
    >>> def piece(name, y, height):
    ...     pose, size = Pose(0.0, y, 0.0, 0.0), Size(1.0, 0.6, height)
    ...     return Piece(name, "wardrobe", "", "a", pose, size)
    >>> two = [piece("high", 0.0, 2.2), piece("low", 1.0, 0.5)]
    >>> sorted(find_hiding(two, (0.0, 0.7, -0.7))), find_hiding(two, (0.0, -0.7, -0.7))
    (['high'], frozenset())
    """
    flat = float(np.hypot(*towards[:2]))
    if flat < 1e-6 or towards[2] > -1e-6:
        return frozenset()
    lean = np.array(towards[:2]) / -towards[2]
    standing = [p for p in pieces if p.pose.z < TALL and p.on is None]
    shapes = list(polygons_of(tuple(standing)))
    tops = np.array([p.pose.z + p.size.height for p in standing])
    middles = np.array([p.pose.z + p.size.height / 2 for p in standing])
    areas = shapely.area(np.array(shapes, object))
    furniture = (areas >= SLIGHT) & np.array([p.category != WALL for p in standing], bool)
    found = set()
    for k, piece in enumerate(standing):
        if tops[k] < TALL or piece.size.width < WIDE:
            continue
        rises = tops[k] - middles
        behind = furniture & (rises > 0) & (np.arange(len(tops)) != k)
        for other in np.flatnonzero(behind):
            shadow = _sweep(shapes[k], float(rises[other]) * lean)
            if shadow.intersection(shapes[other]).area >= HIDDEN * areas[other]:
                found.add(piece.id)
                break
    return frozenset(found)


def _sweep(shape: Geometry, step: Floats) -> Geometry:
    """The hull of a shape and of the same moved by a step."""
    points = shapely.get_coordinates(shape)
    return shapely.MultiPoint(np.vstack([points, points + step])).convex_hull


def make_clear(parts: tuple[Part, ...]) -> tuple[Part, ...]:
    """Parts as if of glass, in their colours."""
    return tuple(Part(_clear(part.material), part.vertices, part.faces) for part in parts)


def _clear(material: Material) -> Material:
    opacity = min(material.opacity, CLEAR)
    return replace(material, name=f"{material.name}, seen through", opacity=opacity)
