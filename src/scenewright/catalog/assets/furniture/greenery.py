"""Potted plants, vases with twigs and bowls of fruit."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.foliage import GOLDEN, grown, pot, rosette, tree
from scenewright.catalog.assets.materials import (
    BARK,
    CERAMIC,
    CLAY,
    LEAF,
    LEAF_LIGHT,
    MUSTARD,
    OAK,
    RATTAN,
    SLATE,
    SOIL,
    TERRACOTTA,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.catalog.assets.objects import wobble
from scenewright.catalog.assets.symbols import Lines, oval, path
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import ball, lathe, rod


def _plant(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    radius, high = 0.62 * min(w, d), 0.36 * h
    body, soil = pot(radius, high)
    reach = h - high
    count = 13 if h < 0.3 else 17
    leaves = rosette(count, reach, 0.34 * reach, 0.9 * high, droop=1.0)
    (leaves,) = grown(w, d, (0.85 * high, h), leaves)
    return parts(size, {CERAMIC: [body], SOIL: [soil], LEAF: leaves[::2], LEAF_LIGHT: leaves[1::2]})


def _potted_tree(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    radius, high = min(0.6 * min(w, d), 0.2), min(0.24 * h, 0.36)
    body, soil = pot(radius, high)
    wood, leaves = grown(w, d, (0.8 * high, h), *tree(0.8 * high, h, 1.2 * min(w, d), 48))
    return parts(
        size,
        {
            CLAY: [body],
            SOIL: [soil],
            BARK: wood,
            LEAF: [*leaves[::3], *leaves[1::3]],
            LEAF_LIGHT: leaves[2::3],
        },
    )


def _palm(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    radius, high = min(0.55 * min(w, d), 0.19), min(0.24 * h, 0.32)
    body, soil = pot(radius, high)
    crown = rosette(19, h - high, 0.2 * (h - high), 0.9 * high, rise=(0.75, 1.5), droop=1.5)
    (crown,) = grown(w, d, (0.85 * high, h), crown)
    return parts(size, {RATTAN: [body], SOIL: [soil], LEAF: crown[::2], LEAF_LIGHT: crown[1::2]})


def _vase(size: Size) -> Parts:
    """A bellied vase with a few twigs."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    tall, radius = 0.55 * h, 0.62 * min(w, d)
    rows = [
        (0.55, 0),
        (0.95, 0.3),
        (1, 0.45),
        (0.75, 0.75),
        (0.4, 0.92),
        (0.5, 1),
        (0.4, 1),
        (0.32, 0.9),
    ]
    body = lathe([(r * radius, z * tall) for r, z in rows], sides=14)
    twigs, leaves = [], []
    for k in range(5):
        angle, out = k * GOLDEN, 0.75 * min(w, d)
        tip = (out * cos(angle), out * sin(angle), h * (0.9 + 0.1 * wobble(k)))
        twigs.append(rod((0, 0, 0.85 * tall), tip, 0.003, 0.002, 4))
        leaves += [
            ball(
                0.16 * radius + 0.004,
                0.16 * radius + 0.004,
                0.26 * radius,
                (s * tip[0], s * tip[1], 0.85 * tall + s * (tip[2] - 0.85 * tall) - 0.02 * h),
                6,
                3,
            )
            for s in (0.55, 0.78, 1.0)
        ]
    return parts(
        size, {pick(size, (CLAY, CERAMIC, SLATE)): [body], BARK: twigs, LEAF_LIGHT: leaves}
    )


def _bowl(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rows = [(0.45, 0), (0.85, 0.4), (1, 0.8), (0.94, 0.8), (0.78, 0.42), (0.4, 0.12)]
    body = lathe([(r, z * h) for r, z in rows], sides=20)
    fruit = 0.27 * min(w, d)
    spots = [(0.36 * w * cos(a), 0.36 * d * sin(a)) for a in (0.3, 2.4, 4.5)]
    high = min(fruit, 0.34 * h)
    fruits = [ball(fruit, fruit, high, (x, y, 0.5 * h), 8, 5) for x, y in spots]
    fruits.append(ball(fruit, fruit, high, (0.02, 0, h - high), 8, 5))
    return parts(
        size,
        {
            OAK: [Mesh(body.vertices * (w, d, 1), body.faces)],
            TERRACOTTA: fruits[:2],
            MUSTARD: fruits[2:],
        },
    )


def rosette_symbol(size: Size) -> Lines:
    """Leaves around the middle of a circle."""
    w, d = size.width / 2, size.depth / 2
    angle = np.linspace(0, 2 * pi, 97)
    reach = 0.72 + 0.28 * np.abs(np.cos(4.5 * angle))
    outline = np.column_stack([w * reach * np.cos(angle), d * reach * np.sin(angle)])
    outline[-1] = outline[0]
    spokes = [
        path((0, 0), (0.75 * w * cos(a), 0.75 * d * sin(a))) for a in np.arange(9) * 2 * pi / 9
    ]
    return outline, *spokes, oval(0, 0, 0.16 * w, 0.16 * d)


def _vase_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return oval(0, 0, w, d), oval(0, 0, 0.45 * w, 0.45 * d)


_TALL = (Size(0.25, 0.25, 0.5), Size(0.5, 0.5, 1.0), Size(1.0, 1.0, 1.2))


ASSETS = (
    Drawing("plant", _plant, rosette_symbol),
    Drawing("potted_tree", _potted_tree, rosette_symbol),
    Drawing(
        "potted_tree", _palm, rosette_symbol, id="potted_tree_low", name="Potted palm", sizes=_TALL
    ),
    Drawing("vase", _vase, _vase_symbol),
    Drawing("bowl", _bowl, _vase_symbol),
)
