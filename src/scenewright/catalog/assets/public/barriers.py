"""Glass barriers of halls, the post of a wide gate in them and its leaves."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import BLACK, GLASS, LEAF, STEEL
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, box, oval, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.solids import block, slab


def _glass_barrier(size: Size) -> Parts:
    """Panes of glass between steel posts, a rail on top."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    posts = np.linspace(-w + d, w - d, max(2, round(size.width / 1.4) + 1))
    return parts(
        size,
        {
            STEEL: [
                *(block((x - d, x + d), (-d, d), (0, h - 0.04)) for x in posts),
                block((-w, w), (-d, d), (h - 0.04, h)),
            ],
            GLASS: [
                block((a + d, b - d), (-0.006, 0.006), (0.1, h - 0.06))
                for a, b in pairwise(posts)
                if b - a > 2 * d + 0.01
            ],
        },
    )


def _barrier_symbol(size: Size) -> Lines:
    """A line, and a dot for each post."""
    w, d = size.width / 2, size.depth / 2
    posts = np.linspace(-w + d, w - d, max(2, round(size.width / 1.4) + 1))
    return rectangle(size), *(oval(float(x), 0, d, d) for x in posts)


def _gate_post(size: Size) -> Parts:
    """A housing like that of a gate, a light at either end."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    lights = [(-w + 0.11, -w + 0.21), (w - 0.21, w - 0.11)]
    return parts(
        size,
        {
            STEEL: [slab((-w, w), (-d, d), (0, h - 0.03), 0.05, 2)],
            BLACK: [slab((-w, w), (-d, d), (h - 0.03, h), 0.05, 2)],
            LEAF: [block(x, (-d + 0.05, d - 0.05), (h - 0.001, h + 0.004)) for x in lights],
        },
    )


def _gate_leaf(size: Size) -> Parts:
    """Two leaves of glass that meet in the middle, a rail round each."""
    w, d, h, rim = size.width / 2, size.depth / 2, size.height, 0.03
    glass, steel = [], []
    for low, high in ((-w, -0.02), (0.02, w)):
        glass.append(block((low, high), (-0.3 * d, 0.3 * d), (0.2, h)))
        steel.append(block((low, high), (-d, d), (h - rim, h)))
        steel.append(block((low, high), (-d, d), (0.2, 0.2 + rim)))
    return parts(size, {GLASS: glass, STEEL: steel})


def _leaf_symbol(size: Size) -> Lines:
    """Two slim boxes with a gap between."""
    w, d = size.width / 2, size.depth / 2
    return box(-w, -0.03, -d, d, 0.2 * d), box(0.03, w, -d, d, 0.2 * d)


def _post_symbol(size: Size) -> Lines:
    """A box with round corners, as of a gate."""
    w, d = size.width / 2, size.depth / 2
    return (box(-w, w, -d, d, 0.05),)


ASSETS = (
    Drawing("glass_barrier", _glass_barrier, _barrier_symbol),
    Drawing("gate_post", _gate_post, _post_symbol),
    Drawing("gate_leaf", _gate_leaf, _leaf_symbol),
)
