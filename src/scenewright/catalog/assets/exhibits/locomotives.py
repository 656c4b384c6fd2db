"""Locomotives as exhibits.

Their long side lies along that of their box.
"""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.lengthwise import draw_lengthwise, lengthwise
from scenewright.catalog.assets.materials import BLACK, BRASS, IRON, ROCK, STEEL, TIMBER, VERMILION
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import merge_by_material
from scenewright.catalog.assets.symbols import Lines, box, oval, path
from scenewright.core.scene import Size
from scenewright.geometry.solids import block, disc, lathe, rod, slab

RAIL = 0.06
"""Height of the rails, as a share of the whole."""


def _locomotive(size: Size) -> Parts:
    """A steam engine on a piece of track."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(size, merge_by_material(_track(w, d, h), _gear(w, d, h), _boiler(w, d, h)))


def _track(w: float, d: float, h: float) -> Stuff:
    sleepers = np.linspace(-w + 0.15, w - 0.15, max(4, round(2 * w / 0.6)))
    return {
        ROCK: [block((-w, w), (-d, d), (0, 0.02 * h))],
        TIMBER: [
            block((x - 0.1, x + 0.1), (-0.85 * d, 0.85 * d), (0.02 * h, 0.035 * h))
            for x in sleepers
        ],
        STEEL: [
            block((-w, w), (s * 0.56 * d - 0.035, s * 0.56 * d + 0.035), (0.035 * h, RAIL * h))
            for s in (-1, 1)
        ],
    }


def _gear(w: float, d: float, h: float) -> Stuff:
    """Wheels, frame and buffer beam."""
    rail, tall = RAIL * h, (1 - RAIL) * h
    rows = ((-0.62, 0.19), (-0.3, 0.19), (0.02, 0.19), (0.45, 0.11), (0.7, 0.11))
    wheels = [
        rod(
            (x * w, s * 0.5 * d, rail + r * tall),
            (x * w, s * 0.62 * d, rail + r * tall),
            r * tall,
            sides=16,
        )
        for x, r in rows
        for s in (-1, 1)
    ]
    low, high = rail + 0.17 * tall, rail + 0.3 * tall
    return {
        VERMILION: [
            *wheels,
            block((-0.96 * w, 0.9 * w), (-0.46 * d, 0.46 * d), (low, high)),
            block((0.9 * w, 0.94 * w), (-0.7 * d, 0.7 * d), (low, high)),
        ]
    }


def _boiler(w: float, d: float, h: float) -> Stuff:
    """The boiler with funnel and dome, and the cab behind it."""
    rail, tall = RAIL * h, (1 - RAIL) * h
    axis, wide = rail + 0.56 * tall, min(0.26 * tall, 0.62 * d)
    low, high = axis + 0.8 * wide, h
    profile = [(0.26, 0), (0.21, 0.6), (0.35, 1.0)]
    funnel = lathe([(r * wide, low + z * (high - low)) for r, z in profile], (0.66 * w, 0), 12)
    posts = [
        block((x * w - 0.04, x * w + 0.04), (y - 0.04, y + 0.04), (0.62 * h, 0.92 * h))
        for x in (-0.88, -0.53)
        for y in (-0.67 * d, 0.67 * d)
    ]
    body = block(
        (-0.92 * w, -0.5 * w), (-0.72 * d, 0.72 * d), (rail + 0.3 * tall, rail + 0.64 * tall)
    )
    bands = [
        rod((x * w, 0, axis), ((x + 0.012) * w, 0, axis), 1.02 * wide, sides=20)
        for x in (-0.25, 0.2, 0.5)
    ]
    dome = disc(0.34 * wide, (axis + 0.85 * wide, axis + 1.35 * wide), (0.1 * w, 0), 12)
    return {
        IRON: [rod((-0.5 * w, 0, axis), (0.82 * w, 0, axis), wide, sides=20), body, *posts, funnel],
        BLACK: [
            slab((-0.97 * w, -0.45 * w), (-0.78 * d, 0.78 * d), (0.91 * h, 0.95 * h), 0.1 * d),
            rod((0.82 * w, 0, axis), (0.86 * w, 0, axis), 0.9 * wide, sides=20),
        ],
        BRASS: [dome, *bands],
    }


def _locomotive_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        box(-w, w, -d, d),
        *(path((-w, s * 0.56 * d), (w, s * 0.56 * d)) for s in (-1, 1)),
        box(-0.97 * w, -0.45 * w, -0.78 * d, 0.78 * d),
        box(-0.45 * w, 0.86 * w, -0.45 * d, 0.45 * d),
        oval(0.66 * w, 0, 0.2 * d),
    )


_ENGINE = (Size(1.5, 0.9, 1.0), Size(8.0, 3.0, 3.5), Size(9.0, 4.0, 4.5))
_ENGINES = "locomotive train tram lokomotive lokomotiven lok zug locomotora tren 火车 机车 機関車"

ASSETS = (
    Drawing(
        "exhibit_island",
        lengthwise(_locomotive),
        draw_lengthwise(_locomotive_symbol),
        id="exhibit_island_locomotive",
        name="Locomotive",
        sizes=_ENGINE,
        called=tuple(_ENGINES.split()),
    ),
)
