"""How buildings are drawn in plan: the outline of the roof, its ridges, a mark at the entrance.

Lines are given in shares of half the width and half the depth, so the footprint is [-1, 1]².
"""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.symbols import Line, Lines, Spot, box, oval, path, rectangle
from scenewright.core.catalog import Covering, Mesher, Symbol, covers_box
from scenewright.core.scene import Size


def ridge(reach: float = 0.6) -> tuple[Line, ...]:
    """A hipped roof: a ridge along x and four hips."""
    ends = path((-reach, 0), (reach, 0))
    hips = [path((s * reach, 0), (s, t)) for s in (-1, 1) for t in (-1, 1)]
    return ends, *hips


def cross() -> tuple[Line, ...]:
    """The diagonals: a pyramid."""
    return path((-1, -1), (1, 1)), path((-1, 1), (1, -1))


def ring(radius: float, x: float = 0.0, y: float = 0.0) -> Line:
    """A circle (an ellipse, where the footprint is not square): a dome, a tower."""
    return oval(x, y, radius, points=24)


def within(x0: float, x1: float, y0: float, y1: float) -> Line:
    """A rectangle."""
    return box(x0, x1, y0, y1)


def across(*ys: float) -> tuple[Line, ...]:
    """Lines from side to side."""
    return tuple(path((-1, y), (1, y)) for y in ys)


def plan(*lines: Line, outline: Line | None = None, door: Spot = (0.0, 1.0)) -> Symbol:
    """A symbol of ``lines``, with the footprint (or another outline) first and a triangle where
    one goes in."""

    def symbol(size: Size) -> Lines:
        half = np.array([size.width, size.depth]) / 2
        border = rectangle(size) if outline is None else outline * half
        wide = min(1.2, 0.12 * size.width, 0.2 * size.depth)
        x, y = door[0] * half[0], door[1] * half[1]
        mark = path((x - wide, y), (x, y - 1.4 * wide), (x + wide, y))
        return border, *(line * half for line in lines), mark

    return symbol


def style(
    identity: str,
    name: str,
    mesh: Mesher,
    symbol: Symbol,
    usual: tuple[float, float, float],
    footprint: Covering = covers_box,
) -> Drawing:
    """How a building is drawn that can be 0.6 to 1.5 times its usual size; ``footprint`` is what
    it covers."""
    small, large = (Size(*(round(f * v, 2) for v in usual)) for f in (0.6, 1.5))
    return Drawing(
        "building", mesh, symbol, identity, name, (small, Size(*usual), large), footprint
    )
