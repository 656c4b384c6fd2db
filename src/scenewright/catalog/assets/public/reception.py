"""What every public hall has: desks, gates, barriers, partitions, signs, bins, lockers."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.furniture.corners import Outline, corner_outline, turn_about
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    BRASS,
    OAK,
    PAPER,
    SCREEN,
    STONE,
    VELVET,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import block, disc, lathe, rod, tube


def _corner_counter_outline(size: Size) -> Outline:
    """The leg to the visitors, the wing behind it on the right; staff stand in the nook."""
    deep = min(0.75, 0.42 * size.depth, 0.42 * size.width)
    return turn_about(corner_outline(size, deep, deep))


def _corner_counter(size: Size) -> Parts:
    """Panels to both sides that visitors see; below the ledge a worktop round the nook."""
    h = size.height
    outline = _corner_counter_outline(size)
    (w, d), (edge, back) = outline[0], outline[4]
    inner = outline[2][1]
    shown, work = min(0.3, 0.5 * (d - inner)), 0.68 * h
    at, desk = d - shown - 0.26, w - shown
    ledge = [(w, d), (-w, d), (-w, d - shown), (w - shown, d - shown), (w - shown, back), (w, back)]
    front = [
        block((a + 0.004, b - 0.004), (d - 0.05, d - 0.03), (0.1, h - 0.05))
        for a, b in spread(-w + 0.02, w - 0.05, max(1, round(size.width / 0.6)))
    ]
    side = [
        block((w - 0.05, w - 0.03), (a + 0.004, b - 0.004), (0.1, h - 0.05))
        for a, b in spread(back + 0.02, d - 0.05, max(1, round(size.depth / 0.6)))
    ]
    return parts(
        size,
        {
            OAK: [*front, *side],
            STONE: [extrude(np.array(ledge), h - 0.04, h)],
            WHITE: [
                extrude(np.array(ledge) * [0.97, 0.97], 0.1, h - 0.04),
                block((-w + 0.02, w - shown), (inner, d - shown), (work - 0.04, work)),
                block((edge, w - shown), (back + 0.02, inner), (work - 0.04, work)),
                block((-w + 0.02, -w + 0.05), (inner + 0.02, d - shown), (0, work - 0.04)),
                block((edge + 0.02, w - shown), (back + 0.02, back + 0.05), (0, work - 0.04)),
            ],
            BLACK: [extrude(np.array(ledge) * [0.94, 0.94], 0, 0.1)],
            SCREEN: [
                block((x - 0.24, x + 0.24), (at - 0.04, at), (work + 0.06, 0.97 * h))
                for x in (-0.55 * w, 0.1 * w)
            ],
            PAPER: [
                block((desk - 0.3, desk - 0.1), (back + 0.3, back + 0.58), (work, work + 0.02))
            ],
        },
    )


def _rope_barrier(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    x, foot = w - min(d, 0.4 * w), min(d, 0.4 * w)
    posts, share = [], np.linspace(-1, 1, 9)
    for s in (-1, 1):
        base = lathe([(1.0, 0), (1.0, 0.015), (0.25, 0.04)], sides=12)
        posts.append(Mesh(base.vertices * (foot, d, 1) + (s * x, 0, 0), base.faces))
        posts.append(rod((s * x, 0, 0.03), (s * x, 0, h - 0.04), 0.02, sides=8))
        posts.append(disc(0.035, (h - 0.05, h), (s * x, 0), 8))
    sag = np.column_stack([share * x, np.zeros(9), h - 0.12 - 0.22 * min(1.0, x) * (1 - share**2)])
    return parts(size, {BRASS: posts, VELVET: [tube(sag, 0.018, 5)]})
