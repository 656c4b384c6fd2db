"""Lamps: their shades glow a little."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.symbols import Lines, oval, path
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Spot, connect_rings
from scenewright.geometry.solids import oval_ring as ring


def shade(radius: Spot, top: float, low: float, high: float, sides: int = 24) -> Mesh:
    """A hollow lamp shade, ``radius`` in x and y below, ``top`` of it above."""
    thin = 0.96
    return connect_rings(
        np.array(
            [
                ring(radius[0], radius[1], low, sides),
                ring(radius[0] * top, radius[1] * top, high, sides),
                ring(radius[0] * top * thin, radius[1] * top * thin, high, sides),
                ring(radius[0] * thin, radius[1] * thin, low, sides),
            ]
        )
    )


def draw_lamp(size: Size) -> Lines:
    """A circle with the cross that marks a light."""
    w, d = size.width / 2, size.depth / 2
    return (
        oval(0, 0, w, d),
        oval(0, 0, 0.25 * w, 0.25 * d),
        path((-0.7 * w, 0), (0.7 * w, 0)),
        path((0, -0.7 * d), (0, 0.7 * d)),
    )
