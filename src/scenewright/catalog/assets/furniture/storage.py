"""Closed storage: wardrobes, chests, sideboards, stands and cabinets."""

from __future__ import annotations

from scenewright.catalog.assets.symbols import Lines, path, rectangle
from scenewright.core.scene import Size


def draw_hangers(size: Size) -> Lines:
    """Outline, the line of the doors, the rail and strokes for the hangers."""
    w, d = size.width / 2, size.depth / 2
    rail = -0.05 * size.depth
    count = max(3, round(size.width / 0.11))
    strokes = [
        path((x - 0.02, rail - 0.5 * d), (x + 0.02, rail + 0.5 * d))
        for x in (-w + (i + 0.5) * size.width / count for i in range(count))
    ]
    return (
        rectangle(size),
        path((-w, d - 0.03), (w, d - 0.03)),
        path((-w + 0.03, rail), (w - 0.03, rail)),
        *strokes,
    )


def draw_front_line(size: Size) -> Lines:
    """The footprint and the line of its doors."""
    w, d = size.width / 2, size.depth / 2
    line = d - min(0.04, 0.15 * size.depth)
    return rectangle(size), path((-w, line), (w, line))
