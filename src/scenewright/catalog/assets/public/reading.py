"""Reading rooms: long tables with lamps, chairs, carrels, terminals."""

from __future__ import annotations

from scenewright.catalog.assets.materials import BRASS, GLOW, OAK, PAPER, SAGE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.solids import block, rod, slab


def _lamp_spots(size: Size) -> list[float]:
    count = min(6, max(1, round(size.width / 1.1)))
    return [size.width * ((i + 0.5) / count - 0.5) for i in range(count)]


def _reading_table(size: Size) -> Parts:
    """A long table on trestles; with the height to spare, a row of lamps along its middle."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    lit = h > 0.92
    top = 0.75 if lit else h
    deep = d - min(0.2, 0.4 * d)  # chairs stand in before them
    ends = [
        block((s * (w - 0.16) - 0.03, s * (w - 0.16) + 0.03), (-deep, deep), (0, top - 0.04))
        for s in (-1, 1)
    ]
    beam = block((-w + 0.16, w - 0.16), (-0.03, 0.03), (top - 0.18, top - 0.04))
    table = [slab((-w, w), (-d, d), (top - 0.04, top), 0.03), *ends, beam]
    if not lit:
        return parts(size, {OAK: table})
    stems, shades, light = [], [], []
    for x in _lamp_spots(size):
        stems.append(rod((x, 0, top), (x, 0, h - 0.06), 0.012, sides=6))
        shades.append(block((x - 0.2, x + 0.2), (-0.07, 0.07), (h - 0.05, h)))
        light.append(block((x - 0.18, x + 0.18), (-0.05, 0.05), (h - 0.06, h - 0.05)))
    book = [
        block((-0.6 * w, -0.6 * w + 0.3), (0.35 * d, 0.35 * d + 0.2), (top, top + 0.02)),
        block((0.3 * w, 0.3 * w + 0.22), (-0.6 * d, -0.6 * d + 0.16), (top, top + 0.03)),
    ]
    rail = block((-w + 0.1, w - 0.1), (-0.02, 0.02), (top, top + 0.06))
    return parts(size, {OAK: [*table, rail], BRASS: stems, SAGE: shades, GLOW: light, PAPER: book})
