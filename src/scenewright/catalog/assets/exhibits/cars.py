"""Cars as exhibits.

Their long side lies along that of their box.
"""

from __future__ import annotations

from functools import partial

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.lengthwise import draw_lengthwise, lengthwise, upright_ring, wheel
from scenewright.catalog.assets.materials import (
    ACCENT,
    CHROME,
    GLOW,
    MUSTARD,
    PANE,
    RED,
    RUBBER,
    VERMILION,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import Lines, close_line, path
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import loft
from scenewright.geometry.solids import block, rectangle_ring, rod, slab

PAINTS = (RED, WHITE, ACCENT, MUSTARD)
"""Colours of cars that stand beside one another."""

_BODY = (
    (-1.0, 0.3, 0.52, 0.78),
    (-0.96, 0.2, 0.62, 0.9),
    (-0.8, 0.15, 0.67, 0.98),
    (0.0, 0.15, 0.65, 1.0),
    (0.45, 0.15, 0.62, 1.0),
    (0.8, 0.16, 0.54, 0.95),
    (0.95, 0.2, 0.46, 0.84),
    (1.0, 0.28, 0.4, 0.7),
)
"""Sections of a car from its tail to its nose: the place, shares of half the length; under and
upper side, shares of the height; the width, a share of the whole."""


def _car(size: Size, paint: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    body = loft(
        [upright_ring(x * w, share * d, low * h, high * h) for x, low, high, share in _BODY]
    )
    rims = (((-0.84, 0.5), 0.88, 0.6), ((-0.56, 0.12), 0.7, 0.96))
    cabin = loft(
        [
            rectangle_ring((x[0] * w, x[1] * w), (-y * d, y * d), z * h, 0.08 * d, 2)
            for x, y, z in rims
        ]
    )
    roof = slab((-0.58 * w, 0.13 * w), (-0.71 * d, 0.71 * d), (0.95 * h, h), 0.12 * d, 3)
    bars = [
        rod((a * w, s * 0.87 * d, 0.6 * h), (b * w, s * 0.69 * d, 0.97 * h), 0.03 * d, sides=5)
        for a, b in ((-0.83, -0.56), (-0.2, -0.2), (0.49, 0.12))
        for s in (-1, 1)
    ]
    wheels = [
        wheel(x, s, 0.97 * d, 0.22 * h, 0.2 * d) for x in (-0.62 * w, 0.62 * w) for s in (-1, 1)
    ]
    lamps = [
        [
            block((x - 0.02 * w, x + 0.01 * w), (y - 0.12 * d, y + 0.12 * d), (z, z + 0.06 * h))
            for y in (-0.55 * d, 0.55 * d)
        ]
        for x, z in ((0.985 * w, 0.34 * h), (-0.985 * w, 0.45 * h))
    ]
    found: Stuff = {
        RUBBER: [tyre for tyre, _ in wheels],
        CHROME: [hub for _, hub in wheels],
        PANE: [cabin],
        GLOW: lamps[0],
        VERMILION: lamps[1],
    }
    found.setdefault(paint, []).extend([body, roof, *bars])
    return parts(size, found)


def _car_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    upper = [(x * w, share * d) for x, _, _, share in _BODY]
    rim = [(x, -y) for x, y in upper] + upper[::-1]
    front, back = (0.12, 0.5), (-0.56, -0.84)
    panes = [
        close_line(
            np.array([(a * w, -0.68 * d), (b * w, -0.8 * d), (b * w, 0.8 * d), (a * w, 0.68 * d)])
        )
        for a, b in (front, back)
    ]
    sides = [path((-0.56 * w, s * 0.68 * d), (0.12 * w, s * 0.68 * d)) for s in (-1, 1)]
    return close_line(np.array(rim)), *panes, *sides


_CAR = (Size(2.2, 1.1, 0.8), Size(4.5, 1.9, 1.5), Size(8.0, 3.0, 3.0))
_CARS = "car automobile vehicle cabriolet oldtimer auto voiture coche pkw 汽车 車 自動車"

ASSETS = tuple(
    Drawing(
        "exhibit_island",
        lengthwise(partial(_car, paint=paint)),
        draw_lengthwise(_car_symbol),
        id=f"exhibit_island_car_{number}",
        name=f"Car, {number}",
        sizes=_CAR,
        called=tuple(_CARS.split()),
    )
    for number, paint in enumerate(PAINTS, 1)
)
