"""Signs of routes on a plan: numbered stops, ends, narrow places."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.drawing.marks import LINE, ROUTE, WARNING, Mark, disc, group, line, text

Vector = NDArray[np.float64]
PEN, CASING, BUBBLE, HEAD = 0.5, 1.2, 1.75, 3.0
"""Millimetres: the line, the white under it, radius of a stop's number, arrow heads."""


def bubble(count: int, at: Vector, filled: bool) -> Mark:
    """The number of a group in a circle: filled at a stop of the route."""
    fill, pen = (ROUTE, "#ffffff") if filled else ("#ffffff", ROUTE)
    size = 2.1 if count < 10 else 1.8 if count < 100 else 1.4
    ring = disc(at, BUBBLE, fill=fill, stroke=pen, stroke_width=2 * LINE)
    figure = text(str(count), at, size, fill=pen, stroke="none", font_weight="bold")
    return group([ring, figure])


def narrow_mark(ends: Vector) -> Mark:
    """A dimension line between two paper points, with slashes at its ends."""
    way = (ends[1] - ends[0]) / max(float(np.hypot(*(ends[1] - ends[0]))), 1e-9)
    slash = 0.8 * (way + np.array([-way[1], way[0]])) / np.sqrt(2)
    strokes = [line(ends, stroke_width=2 * LINE)]
    strokes += [line([end - slash, end + slash], stroke_width=3 * LINE) for end in ends]
    return group(strokes, stroke=WARNING)


def start_mark(at: ArrayLike) -> Mark:
    """A disc: where the route starts."""
    return disc(at, 1.2, fill=ROUTE, stroke="#ffffff", stroke_width=LINE)


def end_mark(at: ArrayLike) -> Mark:
    """A ring with a dot: where the route ends."""
    ring = disc(at, 1.1, fill="#ffffff", stroke=ROUTE, stroke_width=PEN)
    return group([ring, disc(at, 0.5, fill=ROUTE, stroke="none")])
