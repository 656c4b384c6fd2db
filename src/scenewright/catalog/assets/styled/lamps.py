"""Lamps in the forms of styles."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.furniture.lighting import draw_lamp, shade
from scenewright.catalog.assets.materials import (
    BLACK,
    BRASS,
    CERAMIC,
    CLAY,
    GLOW,
    OAK,
    RATTAN,
    SHADE,
    WALNUT,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.styled.forms import Form, add, draw_forms
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import (
    ball,
    connect_rings,
    disc,
    lathe,
    leg,
    oval_ring,
    pipe,
    rod,
    tube,
)


def _dome(w: float, d: float, low: float, high: float) -> Mesh:
    """A thin bell that opens below."""
    tall = high - low
    outer = [(1.0, 0.0), (0.96, 0.3), (0.8, 0.62), (0.45, 0.9), (0.12, 1.0)]
    inner = [(0.1, 0.97), (0.41, 0.86), (0.76, 0.58), (0.92, 0.28), (0.97, 0.0)]
    rings = [oval_ring(r * w, r * d, low + z * tall, 20) for r, z in (*outer, *inner)]
    return connect_rings(np.array(rings))


def _bands(w: float, d: float, low: float, high: float, count: int) -> list[Mesh]:
    """Hoops one above the other round a ball: a woven or a paper shade."""
    step = (high - low) / count
    found = []
    for k in range(count):
        share = 2 * (k + 0.5) / count - 1
        wide = max((1 - share * share) ** 0.5, 0.3)
        hoop = pipe(1.0, 0.94, (low + k * step, low + (k + 0.75) * step), sides=18)
        found.append(Mesh(hoop.vertices * (w * wide, d * wide, 1), hoop.faces))
    return found


def _head(form: Form, w: float, d: float, low: float, high: float) -> Stuff:
    """What glows, over a footprint of half sizes ``w`` and ``d``, between two heights."""
    middle, bulb = (low + high) / 2, min(0.05, 0.3 * min(w, d), 0.3 * (high - low))
    light: Stuff = {GLOW: [ball(bulb, bulb, bulb, (0, 0, middle), 8, 4)]}
    match form.name:
        case "nordic":
            return add(light, {SHADE: [shade((w, d), 0.55, low, high)]})
        case "classic":
            return add(
                light,
                {
                    SHADE: [shade((w, d), 0.5, low + 0.02, high, 30)],
                    BRASS: [_hoop(w, d, low, low + 0.02)],
                },
            )
        case "industrial":
            return add(light, {BLACK: [_dome(w, d, low, high)]})
        case "japandi":
            paper = ball(0.98 * w, 0.98 * d, (high - low) / 2, (0, 0, middle), 18, 10)
            return {SHADE: [paper], OAK: [_hoop(w, d, middle - 0.004, middle + 0.004)]}
        case "retro":
            return {GLOW: [ball(w, d, (high - low) / 2, (0, 0, middle), 18, 10)]}
    return add(
        light, {RATTAN: _bands(w, d, low, high, max(5, min(9, round((high - low) / 0.035))))}
    )


def _hoop(w: float, d: float, low: float, high: float) -> Mesh:
    ring = pipe(1.0, 0.96, (low, high), sides=24)
    return Mesh(ring.vertices * (w, d, 1), ring.faces)


def _tripod(w: float, d: float, _low: float, top: float) -> Stuff:
    feet = [
        leg(
            0.05 * w * cos(a),
            0.05 * d * sin(a),
            (0, top),
            0.012,
            0.01,
            lean=(0.8 * w * cos(a), 0.8 * d * sin(a)),
        )
        for a in (pi / 2 + k * 2 * pi / 3 for k in range(3))
    ]
    return {OAK: feet}


def _turned_column(w: float, d: float, _low: float, top: float) -> Stuff:
    rows = [(0.6, 0), (0.58, 0.02), (0.16, 0.05), (0.08, 0.1), (0.14, 0.3), (0.07, 0.42)]
    rows += [(0.06, 0.8), (0.1, 0.86), (0.05, 1)]
    return {BRASS: [lathe([(min(w, d) * r, z * top) for r, z in rows])]}


def _steel_bar(w: float, d: float, low: float, top: float) -> Stuff:
    foot = disc(0.6 * min(w, d), (0, 0.025), sides=20)
    grip = disc(0.025, (0.55 * low, 0.72 * low), sides=10)
    return {BLACK: [foot, rod((0, 0, 0.02), (0, 0, top), 0.011)], OAK: [grip]}


def _frame_of_posts(w: float, d: float, low: float, _top: float) -> Stuff:
    r = 0.7 * min(w, d)
    posts = [
        rod((sx * r, sy * r, 0), (0.5 * sx * r, 0.5 * sy * r, low + 0.05), 0.01, sides=6)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return {OAK: posts}


def _bow(w: float, d: float, low: float, _top: float) -> Stuff:
    way = [(0, 0.7 * d, 0.02), (0, 0.72 * d, 0.6 * low), (0, 0.4 * d, 0.95 * low), (0, 0, low)]
    foot = disc(0.28 * min(w, d), (0, 0.04), (0, 0.7 * d), 20)
    return {BRASS: [tube([*way[:3], (0, 0, low + 0.02)], 0.01)], CERAMIC: [foot]}


def _crossing_sticks(w: float, d: float, low: float, _top: float) -> Stuff:
    ways = [(cos(k * 2 * pi / 3), sin(k * 2 * pi / 3)) for k in range(3)]
    sticks = [
        rod((0.7 * w * x, 0.7 * d * y, 0.004), (-0.2 * w * x, -0.2 * d * y, low + 0.03), 0.014)
        for x, y in ways
    ]
    return {OAK: sticks}


STANDS = {
    "nordic": _tripod,
    "classic": _turned_column,
    "industrial": _steel_bar,
    "japandi": _frame_of_posts,
    "retro": _bow,
    "boho": _crossing_sticks,
}
"""What floor lamps stand on: of half a width and depth, the height of the shade's lower edge and of
the bulb."""


def _floor_lamp(form: Form, size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low = h - min(0.34, 0.26 * h)
    found: Stuff = _head(form, w, d, low, h)
    return parts(size, add(found, STANDS[form.name](w, d, low, low + 0.3 * (h - low))))


FOOT = {
    "nordic": (OAK, ((0.5, 0), (0.55, 0.3), (0.5, 0.55), (0.15, 0.6), (0.12, 1))),
    "classic": (
        CERAMIC,
        ((0.5, 0), (0.5, 0.06), (0.3, 0.1), (0.75, 0.5), (0.6, 0.75), (0.2, 0.9), (0.15, 1)),
    ),
    "industrial": (BLACK, ((0.7, 0), (0.7, 0.06), (0.12, 0.08), (0.12, 1))),
    "japandi": (WALNUT, ((0.45, 0), (0.45, 0.2), (0.2, 0.25), (0.2, 1))),
    "retro": (BRASS, ((0.6, 0), (0.5, 0.05), (0.1, 0.5), (0.3, 0.95), (0.3, 1))),
    "boho": (CLAY, ((0.45, 0), (0.8, 0.35), (0.75, 0.6), (0.3, 0.85), (0.35, 1))),
}
"""Of table lamps: what the foot is of, its radii as shares of the shade's at shares of its
height."""


def _table_lamp(form: Form, size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    low = 0.48 * h
    material, rows = FOOT[form.name]
    radius = min(0.9 * min(w, d), 0.45 * low)
    foot = lathe([(r * radius, z * (low + 0.02)) for r, z in rows], sides=16)
    return parts(size, add(_head(form, w, d, low, h), {material: [foot]}))


def _pendant_lamp(form: Form, size: Size) -> Parts:
    """The style's shade on a cord; a chandelier of six lights in the classic one."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    cord = BRASS if form.name in ("classic", "retro") else BLACK
    high = min(1.3 * min(w, d), 0.6 * h)
    rose = disc(0.2 * min(w, d), (h - 0.025, h), sides=14)
    found: Stuff = {cord: [rod((0, 0, 0.85 * high), (0, 0, h - 0.01), 0.006, sides=6), rose]}
    if form.name != "classic":
        return parts(size, add(found, _head(form, w, d, 0.0, high)))
    shades = []
    for k in range(6):
        x, y = 0.78 * w * cos(k * pi / 3), 0.78 * d * sin(k * pi / 3)
        add(
            found,
            {
                BRASS: [
                    tube(
                        [(0, 0, 0.2 * high), (0.5 * x, 0.5 * y, 0.05 * high), (x, y, 0.35 * high)],
                        0.007,
                    )
                ]
            },
        )
        one = shade((0.22 * w, 0.22 * d), 0.6, 0.4 * high, 0.95 * high, 10)
        shades.append(Mesh(one.vertices + np.array([x, y, 0.0]), one.faces))
    stem = lathe(
        [(0.02, 0), (0.1 * w, 0.15 * high), (0.05 * w, 0.5 * high), (0.02, high)], sides=10
    )
    return parts(size, add(found, {SHADE: shades, BRASS: [stem]}))


def _ceiling_lamp(form: Form, size: Size) -> Parts:
    """A plate at the ceiling with the style's shade below it, flattened."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    plate = disc(1.0, (0.8 * h, h), sides=20)
    metal = BRASS if form.name in ("classic", "retro") else BLACK
    found: Stuff = {metal: [Mesh(plate.vertices * (0.45 * w, 0.45 * d, 1), plate.faces)]}
    return parts(size, add(found, _head(form, w, d, 0.0, 0.86 * h)))


ASSETS = (
    *draw_forms("floor_lamp", _floor_lamp, draw_lamp),
    *draw_forms("table_lamp", _table_lamp, draw_lamp),
    *draw_forms("pendant_lamp", _pendant_lamp, draw_lamp),
    *draw_forms("ceiling_lamp", _ceiling_lamp, draw_lamp),
)
