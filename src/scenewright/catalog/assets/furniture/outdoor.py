"""Balcony and terrace: tables, chairs, planters, drying rack."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.foliage import bush, grown, rosette
from scenewright.catalog.assets.joinery import four_legs, spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CONCRETE,
    FABRIC_LIGHT,
    LEAF,
    LEAF_LIGHT,
    LINEN,
    NAVY,
    SOIL,
    STEEL,
    TEAK,
    TERRACOTTA,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, box, crescent, oval, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import block, cushion, profile, rod, trough, tube


def _slats(
    x: tuple[float, float], y: tuple[float, float], z: tuple[float, float], pitch: float = 0.075
) -> list[Mesh]:
    """Boards along x with gaps between."""
    count = max(2, round((y[1] - y[0]) / pitch))
    return [block(x, (a + 0.004, b - 0.004), z) for a, b in spread(*y, count)]


def _outdoor_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = _slats((-w, w), (-d - 0.004, d + 0.004), (h - 0.022, h))
    rails = [
        block((x - 0.015, x + 0.015), (-d + 0.03, d - 0.03), (h - 0.06, h - 0.022))
        for x in (-w + 0.06, w - 0.06)
    ]
    legs = four_legs(w, d, (0, h - 0.03), 0.018, 0.018, 0.03, 0.01, square=True)
    return parts(size, {TEAK: top, BLACK: [*rails, *legs]})


def _outdoor_chair(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = min(0.42, 0.54 * h)
    sides = [
        tube(
            [
                (s * (w - 0.012), d - 0.03, 0),
                (s * (w - 0.012), d - 0.05, seat + 0.2),
                (s * (w - 0.012), -d + 0.08, seat + 0.2),
                (s * (w - 0.012), -d + 0.05, 0),
            ],
            0.012,
        )
        for s in (-1, 1)
    ]
    posts = [
        rod((s * (w - 0.05), -d + 0.1, seat - 0.05), (s * (w - 0.05), -d + 0.012, h), 0.011)
        for s in (-1, 1)
    ]
    rails = [
        block((-w + 0.012, w - 0.012), (y - 0.01, y + 0.01), (seat - 0.06, seat - 0.035))
        for y in (-d + 0.1, d - 0.08)
    ]
    back = [
        block((-w + 0.04, w - 0.04), (y, y + 0.014), z)
        for y, z in (
            (-d + 0.012 + 0.02 * k, (h - 0.07 - 0.085 * k, h - 0.085 * k)) for k in range(3)
        )
    ]
    pad = cushion((-w + 0.03, w - 0.03), (-d + 0.09, d - 0.02), (seat - 0.035, seat + 0.02), 0.025)
    return parts(size, {BLACK: [*sides, *posts, *rails], TEAK: back, LINEN: [pad]})


def _deck_chair(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = min(0.34, 0.6 * h)
    hinge = -d + 0.42 * size.depth
    length = float(np.hypot(hinge + d, h - seat))
    slope = float(np.arctan2(h - seat, hinge + d))
    flat = _slats((-w + 0.03, w - 0.03), (hinge, d), (seat - 0.02, seat))
    lying = _slats((-w + 0.03, w - 0.03), (-length, 0), (-0.02, 0))
    raised = [translate_mesh(rotate_mesh(m, "x", -slope), 0, hinge, seat) for m in lying]
    rails = [
        block(
            (s * (w - 0.015) - 0.015, s * (w - 0.015) + 0.015),
            (-d + 0.1, d),
            (seat - 0.07, seat - 0.02),
        )
        for s in (-1, 1)
    ]
    legs = four_legs(w, d - 0.1, (0, seat - 0.05), 0.018, 0.018, 0.0, 0.0, square=True)
    pad = cushion((-w + 0.05, w - 0.05), (hinge, d - 0.02), (seat, seat + 0.06), 0.028)
    rest = cushion((-w + 0.05, w - 0.05), (-length, -0.01), (0, 0.06), 0.028)
    return parts(
        size,
        {
            TEAK: [*flat, *raised, *rails, *legs],
            FABRIC_LIGHT: [pad, translate_mesh(rotate_mesh(rest, "x", -slope), 0, hinge, seat)],
        },
    )


def _planter(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    high = 0.6 * h
    tub = trough((-w, w), (-d, d), (0, high), 0.02, high - 0.05, 0.01)
    soil = block((-w + 0.021, w - 0.021), (-d + 0.021, d - 0.021), (high - 0.055, high - 0.03))
    count = max(1, round(size.width / (0.8 * size.depth)))
    green: list[Mesh] = []
    light: list[Mesh] = []
    flowers: list[Mesh] = []
    for k, (a, b) in enumerate(spread(-w + 0.03, w - 0.03, count)):
        half, tall = (b - a) / 2, h - high
        leaves = rosette(12, 1.0, 0.42, 0.0, rise=(0.6, 1.45))
        (leaves,) = grown(
            half, d - 0.02, (high - 0.05, high + tall * (1.0 - 0.15 * (k % 2))), leaves
        )
        row = [translate_mesh(m, (a + b) / 2) for m in leaves]
        (green if k % 2 == 0 else light).extend(row)
        flowers += [
            bush(
                (a + b) / 2 + s * 0.4 * half,
                s * 0.3 * d,
                high + 0.5 * tall,
                0.12 * min(half, d) + 0.01,
                0.16 * tall,
            )
            for s in (-1, 1)
        ]
    return parts(
        size, {CONCRETE: [tub], SOIL: [soil], LEAF: green, LEAF_LIGHT: light, TERRACOTTA: flowers}
    )


def _drying_rack(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = h - 0.04
    legs = [
        rod(
            (sx * (w - 0.1), sy * (d - 0.012), 0),
            (sx * (w - 0.1), -sy * 0.5 * d, top),
            0.011,
            sides=6,
        )
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    border = tube(
        [
            (-w + 0.012, -d + 0.012, top),
            (w - 0.012, -d + 0.012, top),
            (w - 0.012, d - 0.012, top),
            (-w + 0.012, d - 0.012, top),
            (-w + 0.012, -d + 0.03, top),
        ],
        0.009,
    )
    wires = [
        rod((-w + 0.012, y, top), (w - 0.012, y, top), 0.004, sides=4)
        for y in np.linspace(-d + 0.06, d - 0.06, 6)
    ]
    cloths = [
        (NAVY, -0.45 * w, 0.22, 0.35),
        (LINEN, 0.3 * w, 0.3, 0.5),
        (TERRACOTTA, -0.1 * w, 0.2, 0.3),
    ]
    found = {STEEL: [*legs, border, *wires]}
    for k, (cloth, x, wide, drop) in enumerate(cloths):
        half, y = (
            min(wide, 0.5 * w) / 2,
            float(np.linspace(-d + 0.06, d - 0.06, 6)[1 + 2 * (k % 2) + k // 2]),
        )
        found[cloth] = [_hung(x - half, x + half, y, h, min(drop, 0.6 * h))]
    return parts(size, found)


def _hung(left: float, right: float, y: float, top: float, drop: float) -> Mesh:
    """A cloth folded over a wire."""
    outline = [
        (y - 0.03, top - drop),
        (y - 0.022, top - drop),
        (y - 0.004, top - 0.03),
        (y + 0.004, top - 0.03),
        (y + 0.022, top - 0.8 * drop),
        (y + 0.03, top - 0.8 * drop),
        (y + 0.01, top - 0.01),
        (y, top),
        (y - 0.01, top - 0.01),
    ]
    return profile(outline, (left, right))


def _slat_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    rows = spread(-d, d, max(2, round(size.depth / 0.11)))
    return rectangle(size), *(path((-w, a), (w, a)) for a, _ in rows[1:])


def _chair_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    arms = [
        box(min(s * w, s * w - s * 0.05), max(s * w, s * w - s * 0.05), -d + 0.1, d - 0.02)
        for s in (-1, 1)
    ]
    back = crescent(0.92 * w, -d, 0.14, 0.07)
    return box(-w + 0.05, w - 0.05, -d + 0.06, d, 0.04), back, *arms


def _deck_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    hinge = -d + 0.42 * size.depth
    return (
        rectangle(size, 0, 0.04),
        path((-w, hinge), (w, hinge)),
        box(-0.7 * w, 0.7 * w, -d + 0.05, -d + 0.3, 0.05),
    )


def _planter_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    count = max(1, round(size.width / size.depth))
    tufts = [oval((a + b) / 2, 0, 0.42 * (b - a), 0.75 * d, 14) for a, b in spread(-w, w, count)]
    inner = [oval((a + b) / 2, 0, 0.15 * (b - a), 0.3 * d, 10) for a, b in spread(-w, w, count)]
    return rectangle(size), *tufts, *inner


def _rack_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), *(path((-w, y), (w, y)) for y in np.linspace(-d, d, 8)[1:-1])


ASSETS = (
    Drawing("outdoor_table", _outdoor_table, _slat_symbol),
    Drawing("outdoor_chair", _outdoor_chair, _chair_symbol),
    Drawing("deck_chair", _deck_chair, _deck_symbol),
    Drawing("planter", _planter, _planter_symbol),
    Drawing("drying_rack", _drying_rack, _rack_symbol),
)
