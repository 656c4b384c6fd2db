"""Models of places, looked down on."""

from __future__ import annotations

from itertools import pairwise
from math import sin

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import BLACK, LEAF, LEAF_LIGHT, OAK_DARK, TURQUOISE, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import wobble
from scenewright.catalog.assets.symbols import Lines, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import ball, block


def _scale_model(size: Size) -> Parts:
    """A place to look down on: a table, land, a river through it, houses on both banks."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = 0.62 * h
    bank = [(x, 0.3 * d * sin(2.2 * x / w + 0.4)) for x in np.linspace(-0.94 * w, 0.94 * w, 13)]
    water = [
        block((a[0], b[0]), (a[1] - 0.09 * d, a[1] + 0.09 * d), (top + 0.01, top + 0.025))
        for a, b in pairwise(bank)
    ]
    houses: list[Mesh] = []
    trees: list[Mesh] = []
    for k in range(60):
        x, y = (2 * wobble(3 * k) - 1) * 0.88 * w, (2 * wobble(3 * k + 1) - 1) * 0.84 * d
        off = abs(y - 0.3 * d * sin(2.2 * x / w + 0.4))
        if off < 0.2 * d:
            continue
        wide, tall = 0.02 * w + 0.03 * w * wobble(k), (0.25 + 0.75 * wobble(k + 7) ** 2) * (h - top)
        if k % 4 == 0:
            trees.append(ball(wide, wide, 0.18 * (h - top), (x, y, top + 0.2 * (h - top)), 6, 4))
        else:
            houses.append(block((x - wide, x + wide), (y - wide, y + wide), (top, top + tall)))
    houses.append(block((0.1 * w, 0.16 * w), (-0.66 * d, -0.56 * d), (top, h)))
    return parts(
        size,
        {
            OAK_DARK: [block((-w, w), (-d, d), (0.06, top)), *_edge(w, d, top)],
            BLACK: [block((-w + 0.06, w - 0.06), (-d + 0.06, d - 0.06), (0, 0.06))],
            LEAF_LIGHT: [block((-0.95 * w, 0.95 * w), (-0.93 * d, 0.93 * d), (top, top + 0.012))],
            TURQUOISE: water,
            LEAF: trees,
            WHITE: houses,
        },
    )


def _edge(w: float, d: float, z: float) -> list[Mesh]:
    """A low rim round the edge of a table."""
    rows = [
        block((-w, w), (s * d - 0.03 * (s > 0), s * d + 0.03 * (s < 0)), (z, z + 0.05))
        for s in (-1, 1)
    ]
    return rows + [
        block(
            (s * w - 0.03 * (s > 0), s * w + 0.03 * (s < 0)), (-d + 0.03, d - 0.03), (z, z + 0.05)
        )
        for s in (-1, 1)
    ]


def _model_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    bank = [(x, 0.3 * d * sin(2.2 * x / w + 0.4)) for x in np.linspace(-0.94 * w, 0.94 * w, 13)]
    return (
        rectangle(size),
        rectangle(size, 0.06),
        *(path(*((x, y + off * d) for x, y in bank)) for off in (-0.09, 0.09)),
    )


_CALLED = (
    "model diorama maquette topography relief landscape town city modell stadtmodell "
    "maqueta 沙盘 模型 ジオラマ"
)

ASSETS = (
    Drawing(
        "exhibit_island",
        _scale_model,
        _model_symbol,
        id="exhibit_island_scale_model",
        name="Model of a place",
        sizes=(Size(1.5, 1.2, 0.6), Size(3.0, 2.0, 1.2), Size(9.0, 6.0, 4.0)),
        called=tuple(_CALLED.split()),
    ),
)
