"""Bathroom fittings: toilet, basins, bath, showers, mirror, towel rail."""

from __future__ import annotations

from math import pi

import numpy as np

from scenewright.catalog.assets.bodies import lever_joint
from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import drawer_pulls, fronts
from scenewright.catalog.assets.materials import (
    BLACK,
    CERAMIC,
    CHROME,
    GLASS,
    MIRROR,
    OAK,
    PLASTIC,
    SAGE_FABRIC,
    STEEL,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, box, oval, path, plain, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Floats, Mesh, loft, rotate_mesh, translate_mesh
from scenewright.geometry.solids import (
    Interval,
    block,
    connect_rings,
    cushion,
    disc,
    frame,
    leg,
    make_bevelled_box,
    rectangle_ring,
    rod,
    slab,
    trough,
    tube,
)


def egg_ring(half: float, y: Interval, z: float, sides: int = 20) -> Floats:
    """An egg: round at the front (+y), flatter behind, at height ``z``, counter-clockwise."""
    angle = np.arange(sides) * 2 * pi / sides
    middle, deep = y[0] + 0.42 * (y[1] - y[0]), y[1] - y[0]
    reach = np.where(np.sin(angle) > 0, 0.58 * deep, 0.42 * deep)
    power = np.where(np.sin(angle) > 0, 1.0, 0.75)
    across = np.sign(np.cos(angle)) * np.abs(np.cos(angle)) ** power
    along = np.sign(np.sin(angle)) * np.abs(np.sin(angle)) ** power
    return np.column_stack([half * across, middle + reach * along, np.full(sides, z)])


def _toilet(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim, tank = 0.52 * h, -d + 0.27 * size.depth
    y = (tank - 0.06, d)
    half = min(w, 0.19)
    long = y[1] - y[0]
    body = loft(
        [
            egg_ring(0.62 * half, (y[0] + 0.1 * long, y[1] - 0.22 * long), 0),
            egg_ring(0.58 * half, (y[0] + 0.1 * long, y[1] - 0.24 * long), 0.3 * rim),
            egg_ring(0.85 * half, (y[0] + 0.02 * long, y[1] - 0.08 * long), 0.72 * rim),
            egg_ring(0.97 * half, (y[0], y[1] - 0.004), rim),
            egg_ring(0.72 * half, (y[0] + 0.24 * long, y[1] - 0.1 * long), rim),
            egg_ring(0.5 * half, (y[0] + 0.36 * long, y[1] - 0.24 * long), 0.55 * rim),
        ]
    )
    neck = block((-0.55 * half, 0.55 * half), (-d + 0.02, tank + 0.02), (0, rim - 0.01))
    outer = [egg_ring(half, (y[0] + 0.16 * long, y[1]), z) for z in (rim, rim + 0.022)]
    inner = [
        egg_ring(0.64 * half, (y[0] + 0.28 * long, y[1] - 0.13 * long), z)
        for z in (rim + 0.022, rim)
    ]
    seat = connect_rings(np.array([*outer, *inner]))
    lid = loft([egg_ring(half, (0, 0.8 * long), z) for z in (0.0, 0.018)])
    lid = translate_mesh(
        rotate_mesh(lid, "x", pi / 2 - 0.12 + pi / 36), 0, tank + 0.065, rim + 0.02
    )
    cistern = cushion((-w, w), (-d, tank), (rim - 0.02, h - 0.035), 0.025)
    cover = slab((-w, w), (-d, tank + 0.01), (h - 0.04, h - 0.008), 0.03)
    button = disc(0.03, (h - 0.01, h), (0, (tank - d) / 2), 12)
    return parts(
        size,
        {
            CERAMIC: [body, neck, cistern, cover],
            PLASTIC: [seat, _lid_below(lid, h)],
            CHROME: [button],
        },
    )


def _lid_below(lid: Mesh, h: float) -> Mesh:
    """The raised lid, no higher than just under the top of the cistern."""
    low, high = lid.vertices[:, 2].min(), lid.vertices[:, 2].max()
    scale = min(1.0, (h - 0.03 - low) / (high - low))
    vertices = lid.vertices.copy()
    vertices[:, 2] = low + (vertices[:, 2] - low) * scale
    return Mesh(vertices, lid.faces)


def _mixer(y: float, low: float, high: float, reach: float, x: float = 0.0) -> list[Mesh]:
    """A basin tap: body, spout, lever."""
    tall = high - low
    ends = (x, y, low + 0.85 * tall), (x, y + 0.06, high - 0.008)
    return [
        rod((x, y, low), (x, y, low + 0.8 * tall), 0.018, 0.016, 10),
        rod((x, y + 0.005, low + 0.6 * tall), (x, y + reach, low + 0.5 * tall), 0.012, 0.01),
        rod(*ends, 0.008)._replace(joint=lever_joint(*ends)),
    ]


def _basin(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim = h - 0.09
    low, top, face = 0.28 * h, h - 0.15, d - 0.05
    x, z = (-w + 0.01, w - 0.01), (low, top)
    columns = 2 if size.width > 0.75 else 1
    half = min(w - 0.03, 0.32)
    bowl = trough(
        (-half, half), (-d + 0.11, d - 0.03), (top - 0.06, rim), 0.018, top - 0.03, 0.07, 0.03
    )
    plate = [
        block((-w, w), (-d, -d + 0.12), (top, rim - 0.004)),
        block((-w, w), (d - 0.04, d), (top, rim - 0.004)),
        block((-w, -half + 0.01), (-d + 0.12, d - 0.04), (top, rim - 0.004)),
        block((half - 0.01, w), (-d + 0.12, d - 0.04), (top, rim - 0.004)),
    ]
    case = trough(x, (-d, face), z, 0.016, top - 0.1)
    drain = disc(0.022, (top - 0.031, top - 0.026), (0, 0.04), 10)
    return parts(
        size,
        {
            OAK: [case, *fronts(x, z, columns, 2, (face, face + 0.018))],
            BLACK: [
                *drawer_pulls(x, z, columns, 2, face + 0.018, 0.016, 0.4),
                *(
                    leg(sx * (w - 0.04), y, (0, low + 0.005), 0.014)
                    for sx in (-1, 1)
                    for y in (-d + 0.04, face - 0.03)
                ),
            ],
            CERAMIC: [bowl, *plate],
            CHROME: [*_mixer(-d + 0.06, rim - 0.005, h, min(0.14, 0.35 * size.depth)), drain],
        },
    )


def _pedestal_basin(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim = h - 0.09
    bowl = loft(
        [
            rectangle_ring((-0.45 * w, 0.45 * w), (-d, 0.1 * d), rim - 0.17, 0.08, 4),
            rectangle_ring((-w, w), (-d, d), rim - 0.05, min(0.14, 0.6 * d), 4),
            rectangle_ring((-w, w), (-d, d), rim, min(0.14, 0.6 * d), 4),
            rectangle_ring((-w + 0.03, w - 0.03), (-d + 0.1, d - 0.03), rim, min(0.12, 0.5 * d), 4),
            rectangle_ring((-0.5 * w, 0.5 * w), (-d + 0.13, 0.4 * d), rim - 0.12, 0.06, 4),
        ]
    )
    foot = min(0.09, 0.3 * w)
    column = loft(
        [
            rectangle_ring((-foot - 0.02, foot + 0.02), (-d + 0.02, -d + 0.2), 0, 0.05, 3),
            rectangle_ring((-foot + 0.01, foot - 0.01), (-d + 0.02, -d + 0.17), 0.12, 0.05, 3),
            rectangle_ring((-foot, foot), (-d + 0.02, -d + 0.19), rim - 0.15, 0.05, 3),
        ]
    )
    tap = _mixer(-d + 0.055, rim - 0.005, h, min(0.13, 0.35 * size.depth))
    return parts(size, {CERAMIC: [bowl, column], CHROME: tap})


def _bathtub(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim = h - 0.05
    tub = loft(
        [
            rectangle_ring((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.02), 0, 0.06, 4),
            rectangle_ring((-w + 0.01, w - 0.01), (-d + 0.01, d - 0.01), rim - 0.04, 0.06, 4),
            rectangle_ring((-w, w), (-d, d), rim - 0.03, 0.06, 4),
            rectangle_ring((-w, w), (-d, d), rim, 0.06, 4),
            rectangle_ring((-w + 0.07, w - 0.07), (-d + 0.07, d - 0.07), rim, 0.22, 4),
            rectangle_ring((-w + 0.1, w - 0.22), (-d + 0.11, d - 0.11), 0.17, 0.2, 4),
            rectangle_ring((-w + 0.16, w - 0.3), (-d + 0.16, d - 0.16), 0.13, 0.16, 4),
        ]
    )
    drain = disc(0.028, (0.129, 0.135), (-w + 0.3, 0), 12)
    tap = [
        rod((-w + 0.035, s * 0.08, rim - 0.01), (-w + 0.035, s * 0.08, h - 0.012), 0.014)
        for s in (-1, 1)
    ]
    tap += [
        rod((-w + 0.035, -0.11, h - 0.014), (-w + 0.035, 0.11, h - 0.014), 0.014),
        tube(
            [(-w + 0.035, 0, h - 0.014), (-w + 0.13, 0, h - 0.014), (-w + 0.13, 0, rim - 0.03)],
            0.012,
        ),
    ]
    overflow = rod((-w + 0.075, 0, rim - 0.1), (-w + 0.1, 0, rim - 0.1), 0.026, sides=10)
    return parts(size, {CERAMIC: [tub], CHROME: [drain, *tap, overflow]})


def _shower(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    tray = trough((-w, w), (-d, d), (0, 0.06), 0.05, 0.035, 0.02, 0.02)
    door = 0.0 if size.width < 1.1 else 0.1 * w
    panes = [
        block((-w + 0.02, -w + 0.028), (-d + 0.01, d - 0.03), (0.06, h - 0.012)),
        block((w - 0.028, w - 0.02), (-d + 0.01, d - 0.03), (0.06, h - 0.012)),
        block((-w + 0.03, door - 0.002), (d - 0.028, d - 0.02), (0.06, h - 0.012)),
        block((door + 0.002, w - 0.03), (d - 0.04, d - 0.032), (0.06, h - 0.012)),
    ]
    edge = [
        block((s * (w - 0.024) - 0.008, s * (w - 0.024) + 0.008), (d - 0.032, d - 0.016), (0.06, h))
        for s in (-1, 1)
    ]
    edge += [
        block(
            (s * (w - 0.024) - 0.008, s * (w - 0.024) + 0.008),
            (-d + 0.01, d - 0.03),
            (h - 0.014, h),
        )
        for s in (-1, 1)
    ]
    edge.append(block((-w + 0.03, w - 0.03), (d - 0.034, d - 0.014), (h - 0.014, h)))
    head = [
        tube([(0, -d + 0.03, 1.0), (0, -d + 0.03, h - 0.06), (0, -d + 0.3, h - 0.06)], 0.01),
        disc(0.11, (h - 0.085, h - 0.07), (0, -d + 0.3), 16),
        block((-0.1, 0.1), (-d + 0.01, -d + 0.05), (1.0, 1.03)),
        disc(0.04, (0.0351, 0.04), (0, 0), 12),
        rod((door + 0.05, d - 0.018, 0.95), (door + 0.05, d - 0.018, 1.25), 0.01),
    ]
    return parts(size, {CERAMIC: [tray], GLASS: panes, STEEL: edge, CHROME: head})


def _wall_shower(size: Size) -> Parts:
    """A panel on the wall with mixer, hose, hand shower and overhead shower."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    face, out = -d + 0.3 * size.depth, d - 0.01
    panel = make_bevelled_box((-0.4 * w, 0.4 * w), (-d, face), (0.35, h), 0.004)
    head = min(w, d - face) * 0.95
    fittings = [
        disc(head, (h - 0.05, h - 0.03), (0, out - head), 20),
        tube([(0, face, h - 0.02), (0, out - head, h - 0.02)], 0.009),
        rod((-0.3 * w, face, 1.0), (0.3 * w, face, 1.0), 0.022),
        rod((0.75 * w, face, 0.95), (0.75 * w, face, 1.75), 0.009),
        rod((0.75 * w, face, 1.6), (0.75 * w, out, 1.55), 0.02),
        tube([(0.3 * w, face, 1.0), (0.6 * w, face, 0.6), (0.75 * w, face, 1.55)], 0.006),
    ]
    return parts(size, {STEEL: [panel], CHROME: fittings})


def _mirror(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim = min(0.02, 0.1 * w)
    deep = (-d, d) if d < 0.03 else (d - 0.03, d)
    pane_y = (deep[0], deep[0] + 0.7 * (deep[1] - deep[0]))
    pane = block((-w + rim, w - rim), pane_y, (rim, h - rim))
    border = frame((-w, w), deep, (0, h), rim)
    case = [block((-w, w), (-d, d - 0.031), (0, h))] if d >= 0.03 else []
    return parts(size, {OAK: [border], MIRROR: [pane], WHITE: case})


def _towel_rail(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    y, radius = d - 0.02, 0.011
    bars = [rod((s * (w - radius), y, 0), (s * (w - radius), y, h), radius) for s in (-1, 1)]
    count = max(1, round(h / 0.09))
    levels = [h * (k + 0.5) / count for k in range(count)]
    bars += [rod((-w + radius, y, z), (w - radius, y, z), 0.008, sides=6) for z in levels]
    bars += [
        rod((s * (w - radius), -d, 0.8 * h), (s * (w - radius), y, 0.8 * h), 0.009) for s in (-1, 1)
    ]
    top = levels[-1]
    drop = min(0.45, 0.7 * h)
    towel = [
        make_bevelled_box(
            (-0.65 * w, 0.65 * w), (y + 0.01, y + 0.02), (top - drop, top + 0.012), 0.004
        )
    ]
    return parts(size, {CHROME: bars, SAGE_FABRIC: towel})


def _toilet_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    tank = -d + 0.27 * size.depth
    y = (tank - 0.06, d)
    long = y[1] - y[0]
    outer = egg_ring(min(w, 0.19), (y[0] + 0.08 * long, y[1]), 0, 32)[:, :2]
    inner = egg_ring(0.62 * min(w, 0.19), (y[0] + 0.3 * long, y[1] - 0.13 * long), 0, 32)[:, :2]
    return (
        np.concatenate([outer, outer[:1]]),
        np.concatenate([inner, inner[:1]]),
        box(-w, w, -d, tank, 0.03),
    )


def _basin_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    half = min(w - 0.03, 0.32)
    middle = 0.05 * size.depth
    return (
        rectangle(size),
        oval(0, middle, half, d - 0.08),
        oval(0, middle, 0.022),
        path((0, -d + 0.03), (0, -d + 0.13)),
    )


def _pedestal_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        rectangle(size, 0, min(0.14, 0.6 * d)),
        oval(0, 0.1 * d, 0.78 * w, 0.68 * d),
        oval(0, 0.05 * d, 0.02),
        path((0, -d + 0.02), (0, -d + 0.1)),
    )


def _bath_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    inner = box(-w + 0.07, w - 0.07, -d + 0.07, d - 0.07, 0.25)
    return rectangle(size, 0, 0.03), inner, oval(-w + 0.25, 0, 0.03), path((-w, 0), (-w + 0.12, 0))


def _shower_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (rectangle(size), path((-w, -d), (w, d)), path((-w, d), (w, -d)), oval(0, 0, 0.05))


def _wall_shower_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        rectangle(size),
        oval(0, 0, 0.3 * w, 0.6 * d),
        path((-w, -d), (w, d)),
        path((-w, d), (w, -d)),
    )


def _rail_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, 0.5 * d), (w, 0.5 * d))


ASSETS = (
    Drawing("toilet", _toilet, _toilet_symbol),
    Drawing("basin", _basin, _basin_symbol),
    Drawing("pedestal_basin", _pedestal_basin, _pedestal_symbol),
    Drawing("bathtub", _bathtub, _bath_symbol),
    Drawing("shower", _shower, _shower_symbol),
    Drawing("wall_shower", _wall_shower, _wall_shower_symbol),
    Drawing("mirror", _mirror, plain),
    Drawing("towel_rail", _towel_rail, _rail_symbol),
)
