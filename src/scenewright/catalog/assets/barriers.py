"""Glass barriers of halls."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import GLASS, STEEL
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, oval, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.solids import block


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


ASSETS = (Drawing("glass_barrier", _glass_barrier, _barrier_symbol),)
