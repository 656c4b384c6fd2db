"""Aeroplanes as exhibits.

Their long side lies along that of their box.
"""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.lengthwise import draw_lengthwise, lengthwise, upright_ring, wheel
from scenewright.catalog.assets.materials import BLACK, PANE, RED, RUBBER, STEEL, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, box, close_line
from scenewright.core.scene import Size
from scenewright.geometry.mesh import loft
from scenewright.geometry.solids import block, rectangle_ring, rod, slab

_HULL = ((-1.0, 0.1, 0.62), (-0.5, 0.45, 0.5), (0.1, 0.9, 0.44), (0.6, 0.9, 0.42), (0.92, 0.5, 0.4))
"""Sections of a fuselage: the place, the radius and the height of its middle, in shares."""


def _aeroplane(size: Size) -> Parts:
    """A light aeroplane with one propeller and a wing on top."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    thick = min(0.24 * h, 0.16 * d)
    turn = np.arange(12) * np.pi / 6
    ring = np.column_stack([np.zeros(12), np.cos(turn), np.sin(turn)])
    hull = loft([ring * (thick * share) + (x * w, 0, z * h) for x, share, z in _HULL])
    wing = slab((0.02 * w, 0.42 * w), (-d, d), (0.62 * h, 0.665 * h), 0.12 * w, 3)
    tail = slab((-0.98 * w, -0.74 * w), (-0.36 * d, 0.36 * d), (0.62 * h, 0.65 * h), 0.08 * w, 2)
    fin = loft(
        [
            rectangle_ring((a * w, b * w), (-0.02, 0.02), z * h)
            for a, b, z in ((-1.0, -0.7, 0.6), (-1.0, -0.86, 1.0))
        ]
    )
    pane = loft(
        [upright_ring(x * w, 0.8 * thick, 0.46 * h, z * h) for x, z in ((0.05, 0.63), (0.5, 0.6))]
    )
    legs = [
        rod((0.3 * w, 0, 0.34 * h), (0.3 * w, s * 0.28 * d, 0.1 * h), 0.025, sides=6)
        for s in (-1, 1)
    ]
    stays = [
        rod(
            (0.24 * w, s * 0.8 * thick, 0.36 * h), (0.24 * w, s * 0.55 * d, 0.63 * h), 0.02, sides=5
        )
        for s in (-1, 1)
    ]
    tyres = [
        wheel(x * w, 1, y, 0.1 * h, 0.08)[0]
        for x, y in ((0.3, 0.28 * d + 0.04), (0.3, -0.28 * d + 0.04), (0.8, 0.04))
    ]
    nose = rod((0.92 * w, 0, 0.4 * h), (w, 0, 0.4 * h), 0.4 * thick, 0.1 * thick, 10)
    blade = block((0.95 * w, 0.965 * w), (-0.05, 0.05), (0.4 * h - 0.36 * h, 0.4 * h + 0.36 * h))
    fork = rod((0.8 * w, 0, 0.12 * h), (0.8 * w, 0, 0.3 * h), 0.025, sides=6)
    found: Stuff = {
        WHITE: [hull, wing, tail],
        RED: [fin, nose],
        PANE: [pane],
        STEEL: [*legs, *stays, fork],
        RUBBER: tyres,
        BLACK: [blade],
    }
    return parts(size, found)


def _aeroplane_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    thick = 0.16 * d
    upper = [(x * w, share * thick) for x, share, _ in _HULL] + [(w, 0.0)]
    hull = [(x, -y) for x, y in upper] + upper[-2::-1]
    return (
        close_line(np.array(hull)),
        box(0.02 * w, 0.42 * w, -d, d),
        box(-w, -0.74 * w, -0.36 * d, 0.36 * d),
    )


_PLANE = (Size(2.0, 2.0, 1.0), Size(6.0, 6.0, 2.2), Size(9.0, 9.0, 4.0))
_PLANES = "plane aircraft glider avion flugzeug flugzeuge avión 飞机 飛行機"

ASSETS = (
    Drawing(
        "exhibit_island",
        lengthwise(_aeroplane),
        draw_lengthwise(_aeroplane_symbol),
        id="exhibit_island_aeroplane",
        name="Aeroplane",
        sizes=_PLANE,
        called=tuple(_PLANES.split()),
    ),
)
