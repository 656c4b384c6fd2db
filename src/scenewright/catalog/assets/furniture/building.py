"""Things that belong to the building: radiator, column, staircase, fireplace, boxes."""

from __future__ import annotations

from math import pi

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CARDBOARD,
    EMBER,
    GREY,
    LINEN,
    OAK,
    OAK_DARK,
    PLASTER,
    RUBBER,
    SLATE,
    STEEL,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, arc, draw_crossed_box, oval, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import block, lathe, make_bevelled_box, profile, rod


def _radiator(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    count = max(4, round(size.width / 0.07))
    deep = (-d + min(0.025, 0.3 * d), d)
    ribs = [
        make_bevelled_box((a + 0.006, b - 0.006), deep, (0.0, h), 0.012)
        for a, b in spread(-w - 0.006, w + 0.006, count)
    ]
    pipes = [
        block((-w + 0.01, w - 0.01), (-0.4 * d, 0.4 * d), (z, z + 0.03)) for z in (0.06, h - 0.09)
    ]
    stays = [
        block((s * 0.7 * w - 0.01, s * 0.7 * w + 0.01), (-d, -0.3 * d), (h - 0.1, h - 0.07))
        for s in (-1, 1)
    ]
    return parts(size, {WHITE: [*ribs, *pipes], STEEL: stays})


def _column(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(size, {PLASTER: [block((-w, w), (-d, d), (0, h))]})


def _obstacle(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(size, {GREY: [block((-w, w), (-d, d), (0, h))]})


PARCEL = 0.7
"""Longest side in metres that a parcel has; larger boxes stand for furniture of the user's own."""


def _box(size: Size) -> Parts:
    """A parcel with tape; if large a plain body on a recessed foot, under a top."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    if max(size.width, size.depth) > PARCEL:
        foot, top = min(0.08, 0.1 * h), min(0.04, 0.1 * h)
        return parts(
            size,
            {
                SLATE: [block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.03), (0, foot))],
                PLASTER: [block((-w + 0.01, w - 0.01), (-d + 0.01, d - 0.01), (foot, h - top))],
                OAK: [block((-w, w), (-d, d), (h - top, h))],
            },
        )
    tape = min(0.025, 0.2 * d)
    return parts(
        size,
        {
            CARDBOARD: [block((-w, w), (-d + 0.001, d - 0.001), (0, h - 0.001))],
            LINEN: [block((-w + 0.001, w - 0.001), (-tape, tape), (h - 0.01, h))],
            RUBBER: [
                block((0.2 * w, 0.7 * w), (d - 0.002, d), (0.35 * h, 0.6 * h)),
                block((0.2 * w, 0.7 * w), (-d, -d + 0.002), (0.35 * h, 0.6 * h)),
            ],
        },
    )


def risers(size: Size) -> int:
    """Number of steps for a rise near 17.5 cm (a comfortable stair, Blondel's 2 r + g = 63 cm)."""
    return max(3, round(size.height / 0.175))


def _staircase(size: Size) -> Parts:
    """A straight flight up from the front (+y) to the back; a rail as far as the height allows."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    count = risers(size)
    run, rise = size.depth / count, h / count
    treads, faces = [], []
    for k in range(count):
        y, level = d - k * run, (k + 1) * rise
        back = max(y - run - 0.02, -d)
        treads.append(block((-w + 0.03, w - 0.03), (back, y), (level - 0.035, level)))
        faces.append(
            block(
                (-w + 0.031, w - 0.031),
                (y - 0.035, y - 0.015),
                (k * rise - 0.035 * (k > 0), level - 0.035),
            )
        )
    low = d - 0.28 * run / rise
    slope = [(low, 0.0), (d, 0.0), (d, rise + 0.02), (-d + run, h), (-d, h), (-d, h - 0.3)]
    strings = [profile(slope, (s * (w - 0.015) - 0.015, s * (w - 0.015) + 0.015)) for s in (-1, 1)]
    rails, bars = _railing(w - 0.015, d, rise, run, h)
    return parts(size, {OAK: [*treads, *rails], WHITE: [*faces, *strings], BLACK: bars})


def _railing(
    x: float, d: float, rise: float, run: float, h: float
) -> tuple[list[Mesh], list[Mesh]]:
    """Handrails 0.9 m above the noses on both sides, up to the height ``h``, and their bars."""
    tall = min(0.9, 0.5 * h)
    steps = int((h - tall - rise) / rise)
    if steps < 1:
        return [], []
    spots = [(d - 0.04 - k * run, (k + 1) * rise) for k in range(steps + 1)]
    (y0, z0), (y1, z1) = spots[0], spots[-1]
    rails = [
        rod((s * x, y0, z0 + tall - 0.02), (s * x, y1, z1 + tall - 0.02), 0.02, sides=8)
        for s in (-1, 1)
    ]
    bars = [
        rod((s * x, y, z - 0.05), (s * x, y, z + tall - 0.02), 0.009, sides=4)
        for s in (-1, 1)
        for y, z in spots
    ]
    return rails, bars


def _fireplace(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    mouth, top, base = 0.52 * w, 0.58 * min(h, 1.3), 0.08
    mantel = min(h, 1.3) - 0.06
    y = (-d, d - 0.06)
    body = [
        block((-w + 0.06, -mouth), y, (0, mantel)),
        block((mouth, w - 0.06), y, (0, mantel)),
        block((-mouth, mouth), y, (top, mantel)),
        block((-mouth, mouth), (-d, -d + 0.05), (0, top)),
    ]
    chimney = (
        [block((-0.6 * w, 0.6 * w), (-d, 0.3 * d), (mantel + 0.06, h))] if h > mantel + 0.1 else []
    )
    under = rod((-0.3 * mouth, 0.1 * d, base + 0.05), (0.32 * mouth, 0.0, base + 0.05), 0.04)
    logs = [rotate_mesh(under, "z", a) for a in (0.15, -0.2)]
    logs.append(
        rod((-0.25 * mouth, -0.1 * d, base + 0.12), (0.28 * mouth, 0.15 * d, base + 0.12), 0.036)
    )
    flames = [
        translate_mesh(Mesh(_flame().vertices * (s, s, s), _flame().faces), x, 0.0, base + 0.12)
        for x, s in ((-0.2 * mouth, 0.14), (0.02, 0.2), (0.24 * mouth, 0.12))
    ]
    return parts(
        size,
        {
            PLASTER: [*body, *chimney],
            SLATE: [
                block((-w, w), (-d, d), (0, 0.04)),
                block((-mouth, mouth), (-d + 0.05, d - 0.06), (0.04, base)),
                block((-mouth + 0.001, mouth - 0.001), (-d + 0.05, -d + 0.06), (base, top - 0.001)),
            ],
            OAK_DARK: [make_bevelled_box((-w, w), (-d, d), (mantel, mantel + 0.06), 0.008), *logs],
            EMBER: flames,
        },
    )


def _flame() -> Mesh:
    return lathe([(0.0, 0), (0.3, 0.12), (0.34, 0.35), (0.16, 0.75), (0.0, 1.2)], sides=8)


def _radiator_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    ribs = spread(-w, w, max(4, round(size.width / 0.1)))
    return rectangle(size), *(path((a, -d), (a, d)) for a, _ in ribs[1:])


def _draw_hatching(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    marks = np.linspace(-1, 1, 6)
    strokes = [path((w * t, -d), (w, -d * t)) for t in marks[:-1]]
    strokes += [path((-w, d * t), (-w * t, d)) for t in marks[1:-1]]
    return rectangle(size), *strokes


def _stairs_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    treads = [path((-w, y), (w, y)) for y, _ in spread(-d, d, risers(size))[1:]]
    tip = -d + 0.15
    arrow = path((-0.08, tip + 0.14), (0, tip), (0.08, tip + 0.14))
    return rectangle(size), *treads, path((0, d - 0.12), (0, tip)), arrow, oval(0, d - 0.12, 0.03)


def _fireplace_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    mouth = 0.52 * w
    hearth = path((-mouth, d), (-0.8 * mouth, -0.5 * d), (0.8 * mouth, -0.5 * d), (mouth, d))
    flame = arc(0, 0.1 * d, 0.35 * mouth, 0.5 * d, pi, 2 * pi)
    return rectangle(size), hearth, flame


def _box_symbol(size: Size) -> Lines:
    w = size.width / 2
    return rectangle(size), path((-w, 0), (w, 0))


ASSETS = (
    Drawing("radiator", _radiator, _radiator_symbol),
    Drawing("column", _column, _draw_hatching),
    Drawing("staircase", _staircase, _stairs_symbol),
    Drawing("fireplace", _fireplace, _fireplace_symbol),
    Drawing("box", _box, _box_symbol),
    Drawing("obstacle", _obstacle, draw_crossed_box),
)
