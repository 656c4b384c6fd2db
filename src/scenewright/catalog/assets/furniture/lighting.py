"""Lamps: their shades glow a little."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import (
    BLACK,
    BRASS,
    CERAMIC,
    CLAY,
    GLOW,
    OAK,
    SAGE,
    SHADE,
    SLATE,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.catalog.assets.symbols import Lines, oval, path
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Spot, ball, connect_rings, disc, lathe, leg, rod, tube
from scenewright.geometry.solids import oval_ring as ring


def shade(radius: Spot, top: float, low: float, high: float, sides: int = 24) -> Mesh:
    """A hollow lamp shade, ``radius`` in x and y below, ``top`` of it above."""
    thin = 0.96
    return connect_rings(
        np.array(
            [
                ring(radius[0], radius[1], low, sides),
                ring(radius[0] * top, radius[1] * top, high, sides),
                ring(radius[0] * top * thin, radius[1] * top * thin, high, sides),
                ring(radius[0] * thin, radius[1] * thin, low, sides),
            ]
        )
    )


def _floor_lamp(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low = h - min(0.32, 0.26 * h)
    reach = 0.88
    feet = [
        leg(
            0.06 * a * w,
            0.06 * b * d,
            (0, low + 0.02),
            0.012,
            0.01,
            lean=(reach * a * w, reach * b * d),
        )
        for a, b in ((0, 1.1), (0.95, -0.55), (-0.95, -0.55))
    ]
    return parts(
        size,
        {
            OAK: feet,
            BRASS: [
                disc(0.05, (low - 0.01, low + 0.03), sides=12),
                rod((0, 0, low), (0, 0, low + 0.12), 0.01),
            ],
            SHADE: [shade((w, d), 0.78, low, h)],
            GLOW: [ball(0.045, 0.045, 0.055, (0, 0, low + 0.16), 8, 4)],
        },
    )


def _table_lamp(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low = 0.5 * h
    belly = min(0.62 * min(w, d), 0.3 * low)
    rows = [(0.6, 0), (0.62, 0.05), (1, 0.4), (0.8, 0.7), (0.22, 0.92), (0.2, 1)]
    base = lathe([(r * belly, z * low) for r, z in rows], sides=16)
    return parts(
        size,
        {
            pick(size, (CERAMIC, CLAY, SLATE)): [base],
            BRASS: [rod((0, 0, low - 0.01), (0, 0, low + 0.06), 0.008, sides=6)],
            SHADE: [shade((w, d), 0.7, low, h, 20)],
            GLOW: [ball(0.03, 0.03, 0.04, (0, 0, low + 0.09), 6, 4)],
        },
    )


def _desk_lamp(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    foot = min(w, 0.09)
    elbow, top = (0, -d + 0.02, 0.55 * h), (0, 0.25 * d, h - 0.03)
    head = lathe([(0.3, h - 0.02), (1.0, h - 0.13), (0.94, h - 0.135), (0.25, h - 0.035)], sides=16)
    head = Mesh(head.vertices * (w, w, 1) + (0, d - w, 0), head.faces[:, ::-1])
    return parts(
        size,
        {
            BLACK: [
                disc(foot, (0, 0.018), (0, -d + foot), 20),
                tube([(0, -d + foot, 0.015), elbow, top, (0, d - w, h - 0.01)], 0.008),
            ],
            SAGE: [head],
            GLOW: [ball(0.025, 0.025, 0.03, (0, d - w, h - 0.09), 8, 4)],
        },
    )


def _pendant_lamp(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    dome = min(0.55 * min(w, d) * 2, 0.5 * h)
    rows = [(1.0, 0.0), (0.97, 0.25), (0.82, 0.6), (0.5, 0.88), (0.12, 1.0)]
    inner = [(0.1, 0.97), (0.46, 0.83), (0.77, 0.57), (0.93, 0.25), (0.97, 0.0)]
    bulb = min(0.07, 0.4 * min(w, d), 0.3 * dome)
    stack = np.array([ring(r * w, r * d, z * dome, 24) for r, z in (*rows, *inner)])
    return parts(
        size,
        {
            SAGE: [connect_rings(stack)],
            BLACK: [
                rod((0, 0, 0.9 * dome), (0, 0, h - 0.01), 0.006, sides=6),
                disc(0.24 * min(w, d), (h - 0.025, h), sides=14),
            ],
            BRASS: [disc(0.1 * (w + d), (0.93 * dome, 1.1 * dome), sides=12)],
            GLOW: [ball(bulb, bulb, bulb, (0, 0, 0.4 * dome), 10, 6)],
        },
    )


def _ceiling_lamp(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    bowl = lathe([(0.35, 0), (0.8, 0.18 * h), (1, 0.5 * h), (1, 0.72 * h)], sides=24)
    glass = Mesh(bowl.vertices * (0.96 * w, 0.96 * d, 1), bowl.faces)
    rim = lathe([(1, 0.66 * h), (1, 0.78 * h), (0.6, 0.8 * h), (0.6, h)], sides=24)
    return parts(size, {GLOW: [glass], BRASS: [Mesh(rim.vertices * (w, d, 1), rim.faces)]})


def _wall_lamp(size: Size) -> Parts:
    """A shade on an arm before a round plate at the wall, which is behind it."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    wide = min(w, 0.8 * d)
    middle, low = d - wide, 0.2 * h
    cloth = shade((w, wide), 0.72, low, h, 20)
    plate = lathe([(1, 0), (1, 0.014), (0.4, 0.024)], sides=16)
    upright = plate.vertices[:, [0, 2, 1]] * (0.6 * w, 1, 0.6 * w) + np.array([0, -d, 0.3 * h])
    arm = [(0, -d + 0.02, 0.3 * h), (0, middle, 0.08 * h), (0, middle, 0.5 * h)]
    return parts(
        size,
        {
            SHADE: [Mesh(cloth.vertices + np.array([0, middle, 0]), cloth.faces)],
            BRASS: [Mesh(upright, plate.faces[:, ::-1]), tube(arm, 0.007)],
            GLOW: [ball(0.03, 0.03, 0.035, (0, middle, 0.5 * h), 8, 4)],
        },
    )


def _wall_lamp_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    wide = min(w, 0.8 * d)
    return path((-0.6 * w, -d), (0.6 * w, -d)), oval(0, d - wide, w, wide), path((0, -d), (0, d))


def draw_lamp(size: Size) -> Lines:
    """A circle with the cross that marks a light."""
    w, d = size.width / 2, size.depth / 2
    return (
        oval(0, 0, w, d),
        oval(0, 0, 0.25 * w, 0.25 * d),
        path((-0.7 * w, 0), (0.7 * w, 0)),
        path((0, -0.7 * d), (0, 0.7 * d)),
    )


def _desk_lamp_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    foot = min(w, 0.09)
    return oval(0, -d + foot, foot), path((0, -d + foot), (0, d - w)), oval(0, d - w, w)


ASSETS = (
    Drawing("floor_lamp", _floor_lamp, draw_lamp),
    Drawing("table_lamp", _table_lamp, draw_lamp),
    Drawing("desk_lamp", _desk_lamp, _desk_lamp_symbol),
    Drawing("wall_lamp", _wall_lamp, _wall_lamp_symbol),
    Drawing("pendant_lamp", _pendant_lamp, draw_lamp),
    Drawing("ceiling_lamp", _ceiling_lamp, draw_lamp),
)
