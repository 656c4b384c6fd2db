"""What vehicles are drawn by: they lie along the longer side of their box, however it is turned."""

from __future__ import annotations

import numpy as np

from scenewright.core.catalog import Mesher, Part, Symbol
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Floats, Mesh
from scenewright.geometry.solids import rectangle_ring, rod

_QUARTER = np.array([[0.0, 1.0], [-1.0, 0.0]])
"""Row vectors a quarter turn counter-clockwise."""


def upright_ring(x: float, half: float, low: float, high: float) -> Floats:
    """A rounded upright rectangle across the x axis."""
    ring = rectangle_ring((-half, half), (low, high), x, 0.3 * (high - low), 2)
    return ring[:, [2, 0, 1]]


def wheel(x: float, side: float, y: float, radius: float, deep: float) -> tuple[Mesh, Mesh]:
    """A tyre and its hub, their outer face ``y`` from the middle."""
    tyre = rod((x, side * (y - deep), radius), (x, side * y, radius), radius, sides=16)
    hub = rod(
        (x, side * (y - deep), radius), (x, side * (y + 0.01), radius), 0.55 * radius, sides=10
    )
    return tyre, hub


def lengthwise(mesh: Mesher) -> Mesher:
    """A mesh drawn along x, turned a quarter where a box is deeper than wide.

    >>> boat = lengthwise(lambda size: (Part(None, np.diag([size.width, 0.0, 0.0]), np.eye(3)),))
    >>> boat(Size(2.0, 5.0, 1.0))[0].vertices[0].tolist()
    [0.0, 5.0, 0.0]
    """

    def drawn(size: Size) -> tuple[Part, ...]:
        if size.width >= size.depth:
            return mesh(size)
        lying = mesh(Size(size.depth, size.width, size.height))
        return tuple(Part(p.material, _turn(p.vertices), p.faces) for p in lying)

    return drawn


def draw_lengthwise(symbol: Symbol) -> Symbol:
    """The same of a symbol."""

    def drawn(size: Size) -> tuple[Floats, ...]:
        if size.width >= size.depth:
            return symbol(size)
        return tuple(line @ _QUARTER for line in symbol(Size(size.depth, size.width, size.height)))

    return drawn


def _turn(points: Floats) -> Floats:
    return np.column_stack([points[:, :2] @ _QUARTER, points[:, 2]])
