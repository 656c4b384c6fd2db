"""Stands of trade fairs."""

from __future__ import annotations

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    GLOW,
    OAK,
    PAPER,
    PLASTER,
    SCREEN,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, box, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.solids import block, slab


def _stand(size: Size) -> Parts:
    """A platform open to the front and the right: two walls, a lit fascia, a desk, a screen."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    floor, wall = 0.05, 0.08
    tall = h - 0.3
    desk = (-0.2 * w, 0.35 * w), (0.5 * d, 0.5 * d + 0.5)
    high = min(1.05, 0.5 * h)
    found: Stuff = {
        OAK: [block((-w, w), (-d, d), (0, floor)), block(*desk, (floor, high - 0.04))],
        PLASTER: [
            block((-w, w), (-d, -d + wall), (floor, h)),
            block((-w, -w + wall), (-d + wall, 0.2 * d), (floor, h)),
        ],
        ACCENT: [
            block((-w + wall, w), (-d + wall, -d + wall + 0.02), (tall - 0.4, h)),
            block((-w + wall, w), (d - 0.06, d), (tall + 0.05, h)),
            block((-w, -w + wall), (0.2 * d, d), (tall + 0.05, h)),
        ],
        WHITE: [
            slab(
                (desk[0][0] - 0.05, desk[0][1] + 0.05),
                (desk[1][0], desk[1][1] + 0.1),
                (high - 0.04, high),
                0.04,
            ),
            *(
                block((x - 0.04, x + 0.04), (d - 0.08, d), (floor, tall + 0.1))
                for x in (-w + 0.04, w - 0.04)
            ),
        ],
        SCREEN: [
            block((-0.5 * w, 0.2 * w), (-d + wall + 0.02, -d + wall + 0.06), (0.38 * h, 0.72 * h))
        ],
        PAPER: [
            block((-w + wall, -w + wall + 0.02), (y * d - 0.3, y * d + 0.3), (0.35 * h, 0.7 * h))
            for y in (-0.55, -0.1)
        ],
        GLOW: [block((-0.6 * w, 0.6 * w), (d - 0.004, d + 0.004), (tall + 0.12, h - 0.08))],
        BLACK: [block((0.55 * w, 0.85 * w), (-d + wall + 0.1, -d + wall + 0.4), (floor, 0.9))],
    }
    return parts(size, found)


def _stand_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        rectangle(size),
        box(-w, w, -d, -d + 0.08),
        box(-w, -w + 0.08, -d + 0.08, 0.2 * d),
        box(-0.2 * w - 0.05, 0.35 * w + 0.05, 0.5 * d, 0.5 * d + 0.5),
    )


_CALLED = "stand booth stall exhibitor messestand caseta pabellón 展位 ブース"

ASSETS = (
    Drawing(
        "exhibit_island",
        _stand,
        _stand_symbol,
        id="exhibit_island_stand",
        name="Stand of a fair",
        sizes=(Size(2.4, 2.4, 2.0), Size(4.0, 3.0, 2.6), Size(9.0, 6.0, 4.0)),
        called=tuple(_CALLED.split()),
    ),
)
