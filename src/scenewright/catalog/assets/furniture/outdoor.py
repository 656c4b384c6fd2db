"""Balcony and terrace: tables, chairs, planters, drying rack."""

from __future__ import annotations

from scenewright.catalog.assets.furniture.foliage import bush, grown, rosette
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import CONCRETE, LEAF, LEAF_LIGHT, SOIL, TERRACOTTA
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, translate_mesh
from scenewright.geometry.solids import block, trough


def _planter(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    high = 0.6 * h
    tub = trough((-w, w), (-d, d), (0, high), 0.02, high - 0.05, 0.01)
    soil = block((-w + 0.021, w - 0.021), (-d + 0.021, d - 0.021), (high - 0.055, high - 0.03))
    count = max(1, round(size.width / (0.8 * size.depth)))
    green: list[Mesh] = []
    light: list[Mesh] = []
    flowers: list[Mesh] = []
    for k, (a, b) in enumerate(spread(-w + 0.03, w - 0.03, count)):
        half, tall = (b - a) / 2, h - high
        leaves = rosette(12, 1.0, 0.42, 0.0, rise=(0.6, 1.45))
        (leaves,) = grown(
            half, d - 0.02, (high - 0.05, high + tall * (1.0 - 0.15 * (k % 2))), leaves
        )
        row = [translate_mesh(m, (a + b) / 2) for m in leaves]
        (green if k % 2 == 0 else light).extend(row)
        flowers += [
            bush(
                (a + b) / 2 + s * 0.4 * half,
                s * 0.3 * d,
                high + 0.5 * tall,
                0.12 * min(half, d) + 0.01,
                0.16 * tall,
            )
            for s in (-1, 1)
        ]
    return parts(
        size, {CONCRETE: [tub], SOIL: [soil], LEAF: green, LEAF_LIGHT: light, TERRACOTTA: flowers}
    )
