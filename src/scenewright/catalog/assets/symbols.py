"""Plan symbols: polylines in a piece's local frame seen from above, as an architect draws them.

The first polyline of a symbol is the outline; closed lines repeat their first point.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from scenewright.core.scene import Size

Line = NDArray[np.float64]
Lines = tuple[Line, ...]
Spot = tuple[float, float]


def path(*points: Spot) -> Line:
    """An open polyline."""
    return np.array(points, np.float64)


def close_line(points: Sequence[Spot] | Line) -> Line:
    """A polyline back to its first point."""
    ring = np.asarray(points, np.float64)
    return np.concatenate([ring, ring[:1]])


def box(x0: float, x1: float, y0: float, y1: float, radius: float = 0.0) -> Line:
    """A closed rectangle, its corners rounded by ``radius``."""
    radius = min(radius, (x1 - x0) / 2, (y1 - y0) / 2)
    if radius <= 0:
        return close_line([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])
    corners = (
        (x1 - radius, y1 - radius),
        (x0 + radius, y1 - radius),
        (x0 + radius, y0 + radius),
        (x1 - radius, y0 + radius),
    )
    turns = [np.linspace(k, k + 1, 5) * pi / 2 for k in range(4)]
    return close_line(
        np.concatenate(
            [
                np.column_stack([x + radius * np.cos(a), y + radius * np.sin(a)])
                for (x, y), a in zip(corners, turns, strict=True)
            ]
        )
    )


def rectangle(size: Size, inset: float = 0.0, radius: float = 0.0) -> Line:
    """The footprint, drawn in by ``inset``."""
    w, d = size.width / 2 - inset, size.depth / 2 - inset
    return box(-w, w, -d, d, radius)


def oval(x: float, y: float, rx: float, ry: float | None = None, points: int = 32) -> Line:
    """A closed ellipse."""
    angle = np.arange(points) * 2 * pi / points
    ry = rx if ry is None else ry
    return close_line(np.column_stack([x + rx * np.cos(angle), y + ry * np.sin(angle)]))


def arc(x: float, y: float, rx: float, ry: float, start: float, end: float) -> Line:
    """A piece of an ellipse from angle ``start`` to ``end``, in radians."""
    angle = np.linspace(start, end, 17)
    return np.column_stack([x + rx * np.cos(angle), y + ry * np.sin(angle)])


def crescent(half: float, back: float, deep: float, thick: float) -> Line:
    """A bent backrest: its rear at ``back``, its ends ``deep`` further to the front."""
    outer = arc(0, back + deep, half, deep, 0, -pi)
    inner = arc(0, back + deep, half - 0.6 * thick, deep - thick, -pi, 0)
    return close_line(np.concatenate([outer, inner]))


def plain(size: Size) -> Lines:
    """The footprint alone."""
    return (rectangle(size),)


def round_plain(size: Size) -> Lines:
    """The ellipse in the footprint."""
    return (oval(0, 0, size.width / 2, size.depth / 2),)


def draw_crossed_box(size: Size) -> Lines:
    """The footprint with its diagonals: something tall or unknown."""
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, -d), (w, d)), path((-w, d), (w, -d))
