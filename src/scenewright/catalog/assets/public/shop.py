"""Shops: clothes, tables of goods, fitting rooms, checkouts, baskets."""

from __future__ import annotations

from itertools import pairwise
from math import pi

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import four_legs, spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CHARCOAL,
    CHROME,
    GREIGE,
    LINEN,
    MIRROR,
    OAK,
    RED,
    RUBBER,
    SAGE_FABRIC,
    SCREEN,
    STEEL,
    TERRACOTTA,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.catalog.assets.public.wares import (
    CLOTHS,
    garment,
    merge_by_material,
    stack_folded_cloth,
)
from scenewright.catalog.assets.symbols import Lines, arc, box, oval, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import ball, block, disc, lathe, pipe, rod, slab, trough, tube


def _clothes_rail(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    x = w - 0.03
    bars = [rod((s * x, 0, 0.03), (s * x, 0, h), 0.016, sides=6) for s in (-1, 1)]
    feet = [block((s * x - 0.03, s * x + 0.03), (-d, d), (0, 0.03)) for s in (-1, 1)]
    rail = rod((-w, 0, h - 0.03), (w, 0, h - 0.03), 0.015, sides=6)
    count = min(24, max(3, round(size.width / 0.095)))
    found: Stuff = {CHROME: [*bars, *feet, rail]}
    for i in range(count):
        at = -w + 0.1 + (size.width - 0.2) * (i + 0.5) / count
        long = (h - 0.25) * (0.62 + 0.25 * wobble(i))
        cloth = CLOTHS[int(wobble(i // 3 + 0.4) * len(CLOTHS))]
        found.setdefault(cloth, []).append(garment(at, min(0.24, 0.9 * d), h - 0.045, long))
    return parts(size, found)


def _round_rack(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    half = min(0.22, 0.42 * min(w, d))
    ring, rail = 1.0 - half / min(w, d), h - 0.1
    found: Stuff = {
        CHROME: [
            pipe(ring + 0.02, ring - 0.02, (rail - 0.02, rail + 0.01), sides=20),
            disc(0.06, (0.03, h), sides=6),
            disc(0.5, (0, 0.03), sides=14),
            block((-ring, ring), (-0.012, 0.012), (rail - 0.02, rail)),
            block((-0.012, 0.012), (-ring, ring), (rail - 0.02, rail)),
        ]
    }
    count = 18
    for i in range(count):
        long = (h - 0.3) * (0.62 + 0.2 * wobble(i))
        hung = translate_mesh(garment(0.0, half / min(w, d), rail - 0.01, long, 0.06), 0.0, ring)
        cloth = CLOTHS[int(wobble(i // 4 + 2.4) * len(CLOTHS))]
        found.setdefault(cloth, []).append(rotate_mesh(hung, "z", 2 * pi * i / count))
    return parts(
        size,
        {
            material: [Mesh(m.vertices * (w, d, 1), m.faces) for m in meshes]
            for material, meshes in found.items()
        },
    )


def _mannequin(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    squash = min(1.0, 0.75 * d / w)
    body = [
        (0.32, 0.56),
        (0.42, 0.6),
        (0.44, 0.66),
        (0.36, 0.72),
        (0.5, 0.78),
        (0.62, 0.815),
        (0.5, 0.84),
        (0.16, 0.86),
        (0.14, 0.89),
    ]
    dress = [
        (0.5, 0.3),
        (0.95, 0.3),
        (0.46, 0.64),
        (0.385, 0.72),
        (0.52, 0.78),
        (0.6, 0.8),
        (0.4, 0.82),
    ]
    arms = [
        tube(
            [
                (s * 0.58 * w, 0, 0.8 * h),
                (s * 0.78 * w, -0.04, 0.64 * h),
                (s * 0.74 * w, 0.12, 0.5 * h),
            ],
            0.032,
            6,
        )
        for s in (-1, 1)
    ]
    legs = [
        rod((s * 0.2 * w, 0, 0.36 * h), (s * 0.16 * w, 0, 0.02), 0.055, 0.03, 6) for s in (-1, 1)
    ]
    head = ball(0.085, 0.105, 0.065 * h, (0, 0.02, 0.935 * h), 8, 6)
    cloth = pick(size, (TERRACOTTA, SAGE_FABRIC, LINEN))
    dressed = lathe([(r * w, z * h) for r, z in dress], sides=10, squash=squash)
    skin = lathe([(r * w, z * h) for r, z in body], sides=10, squash=0.92 * squash)
    base = disc(1.0, (0, 0.02), sides=16)
    return parts(
        size,
        {
            GREIGE: [skin, *arms, *legs, head],
            cloth: [dressed],
            STEEL: [Mesh(base.vertices * (w, d, 1), base.faces)],
        },
    )


def _display_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = h - min(0.22, 0.2 * h)
    legs = four_legs(w, d, (0, top - 0.04), 0.035, 0.035, 0.03, square=True)
    table = [
        block((-w, w), (-d, d), (top - 0.04, top)),
        block((-w + 0.05, w - 0.05), (-d + 0.05, d - 0.05), (0.2, 0.225)),
    ]
    shown = stack_folded_cloth(
        (-w + 0.06, w - 0.06), (-d + 0.06, d - 0.06), (top, h), round(10 * size.width)
    )
    return parts(size, merge_by_material({OAK: [*legs, *table]}, shown))


def _checkout(size: Size) -> Parts:
    """Customers walk along the front; the cashier sits behind, right of the belt."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.88, 0.75 * h)
    desk = (-0.1 * d, d)
    till = 0.35 * w
    stand = rod((till, 0.1 * d, top), (till, 0.1 * d, h - 0.2), 0.02, sides=6)
    shown = block((till - 0.17, till + 0.17), (0.1 * d - 0.02, 0.1 * d + 0.02), (h - 0.26, h))
    pay = rotate_mesh(
        block((till - 0.05, till + 0.05), (0.75 * d, 0.75 * d + 0.14), (top + 0.05, top + 0.09)),
        "x",
        0.4,
        (till, 0.75 * d, top + 0.05),
    )
    return parts(
        size,
        {
            WHITE: [
                block((-w, w), desk, (0.1, top - 0.03)),
                block((till - 0.5 * w, till - 0.42 * w), (-d, desk[0]), (0.1, top - 0.06)),
                block((0.85 * w, w), (-d, desk[0]), (0.1, top - 0.06)),
            ],
            STEEL: [
                block((-w, w), desk, (top - 0.03, top)),
                stand,
                block((-w, w), (0.94 * d, d), (top, top + 0.06)),
            ],
            RUBBER: [
                block((-w + 0.05, 0.1 * w), (0.02 * d, 0.85 * d), (top, top + 0.012)),
                block((-w + 0.04, w - 0.04), (-0.05 * d, d - 0.05), (0, 0.1)),
            ],
            SCREEN: [shown, pay],
            CHARCOAL: [block((0.6 * w, 0.9 * w), (0.05 * d, 0.8 * d), (top, top + 0.008))],
        },
    )


def _cash_desk(size: Size) -> Parts:
    """A counter to pay at without a belt: a screen and a card reader on a closed desk."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(1.0, h - 0.25)
    till = 0.4 * w
    shown = block((till - 0.17, till + 0.17), (-0.02, 0.02), (top + 0.06, top + 0.25))
    pay = block((till - 0.3, till - 0.2), (0.5 * d, 0.5 * d + 0.14), (top, top + 0.04))
    return parts(
        size,
        {
            WHITE: [block((-w + 0.02, w - 0.02), (-0.2 * d, d - 0.04), (0.1, top - 0.04))],
            OAK: [block((-w, w), (-d, d), (top - 0.04, top))],
            RUBBER: [block((-w + 0.04, w - 0.04), (-0.15 * d, d - 0.08), (0, 0.1))],
            STEEL: [rod((till, 0.0, top), (till, 0.0, top + 0.08), 0.02, sides=6)],
            SCREEN: [shown, pay],
        },
    )


def _fitting_room(size: Size) -> Parts:
    """Three walls, a rail with a curtain half drawn, mirror behind and a seat."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    t = 0.03
    folds = 8
    wave = spread(-w + t, 0.1 * w, folds)
    curtain = [
        block((a, b), (d - 0.1 + 0.03 * (k % 2), d - 0.05 + 0.03 * (k % 2)), (0.08, h - 0.1))
        for k, (a, b) in enumerate(wave)
    ]
    return parts(
        size,
        {
            WHITE: [
                block((-w, -w + t), (-d, d), (0, h)),
                block((w - t, w), (-d, d), (0, h)),
                block((-w + t, w - t), (-d, -d + t), (0, h)),
            ],
            BLACK: [rod((-w + t, d - 0.05, h - 0.08), (w - t, d - 0.05, h - 0.08), 0.015, sides=6)],
            SAGE_FABRIC: curtain,
            MIRROR: [
                block((-0.35 * w, 0.35 * w), (-d + t, -d + t + 0.01), (0.4, min(1.9, h - 0.15)))
            ],
            OAK: [block((0.4 * w, w - t), (-d + t, -d + t + 0.35), (0.4, 0.45))],
            STEEL: [block((-0.75 * w, -0.6 * w), (-d + t, -d + t + 0.06), (1.65, 1.68))],
        },
    )


def _basket_stack(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    deep = min(0.2, 0.4 * h)
    count = min(10, max(1, round((h - deep - 0.06) / 0.09)))
    rims = [
        slab((-w, w), (-d, d), (z, z + 0.04), 0.04, 1)
        for z in np.linspace(0.08, h - deep - 0.06, count)
    ]
    top = trough((-w, w), (-d, d), (h - deep, h - 0.02), 0.02, h - deep + 0.02, 0.04, 0.02, 1)
    core = block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.03), (0.05, h - deep))
    handle = tube(
        [(-w + 0.04, 0, h - 0.03), (-0.6 * w, 0, h), (0.6 * w, 0, h), (w - 0.04, 0, h - 0.03)],
        0.01,
        5,
    )
    return parts(
        size,
        {
            RED: [*rims, top, core],
            CHROME: [handle],
            RUBBER: [block((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.02), (0, 0.05))],
        },
    )


def _rail_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    count = max(3, round(size.width / 0.14))
    spots = (-w + (i + 0.5) * size.width / count for i in range(count))
    return (
        rectangle(size),
        path((-w, 0), (w, 0)),
        *(path((x, -0.7 * d), (x, 0.7 * d)) for x in spots),
    )


def _round_rack_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    angle = np.arange(16) * pi / 8
    spokes = (
        path(
            (0.5 * w * np.cos(a), 0.5 * d * np.sin(a)), (0.95 * w * np.cos(a), 0.95 * d * np.sin(a))
        )
        for a in angle
    )
    return oval(0, 0, w, d), oval(0, 0, 0.72 * w, 0.72 * d), *spokes


def _mannequin_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return oval(0, 0, w, d), box(-0.65 * w, 0.65 * w, -0.3 * d, 0.2 * d, 0.05), oval(0, 0, 0.22 * w)


def _stacks_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    columns, rows = (
        min(6, max(1, round(size.width / 0.36))),
        min(3, max(1, round(size.depth / 0.4))),
    )
    x, y = np.linspace(-0.9 * w, 0.9 * w, columns + 1), np.linspace(-0.9 * d, 0.9 * d, rows + 1)
    gap = 0.04
    return rectangle(size), *(
        box(a + gap, b - gap, c + gap, e - gap) for a, b in pairwise(x) for c, e in pairwise(y)
    )


def _checkout_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = -0.1 * d
    belt = box(-w + 0.05, 0.1 * w, 0.02 * d, 0.85 * d)
    return (
        rectangle(size),
        path((-w, line), (w, line)),
        belt,
        oval(0.52 * w, -0.55 * d, 0.25 * min(w, d)),
    )


def _cash_desk_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = 0.7 * d
    return rectangle(size), path((-w, line), (w, line)), box(0.2 * w, 0.6 * w, -0.1 * d, 0.1 * d)


def _fitting_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    t = 0.03
    walls = path(
        (-w, d),
        (-w, -d),
        (w, -d),
        (w, d),
        (w - t, d),
        (w - t, -d + t),
        (-w + t, -d + t),
        (-w + t, d),
        (-w, d),
    )
    step = (1.1 * w - t) / 4
    folds = [
        arc(-w + t + (k + 0.5) * step, d - 0.05, step / 2, 0.04, 0, pi * (-1) ** k)
        for k in range(4)
    ]
    return walls, *folds, box(0.4 * w, w - t, -d + t, -d + t + 0.35)


def _basket_symbol(size: Size) -> Lines:
    return (
        rectangle(size, 0, 0.04),
        rectangle(size, 0.03, 0.03),
        path((-size.width / 2, 0), (size.width / 2, 0)),
    )


ASSETS = (
    Drawing("clothes_rail", _clothes_rail, _rail_symbol),
    Drawing("round_rack", _round_rack, _round_rack_symbol),
    Drawing("mannequin", _mannequin, _mannequin_symbol),
    Drawing("display_table", _display_table, _stacks_symbol),
    Drawing("checkout", _checkout, _checkout_symbol),
    Drawing(
        "checkout",
        _cash_desk,
        _cash_desk_symbol,
        id="checkout_desk",
        name="Cash desk",
        sizes=(Size(0.8, 0.5, 0.9), Size(1.6, 0.7, 1.2), Size(3.0, 0.78, 1.4)),
    ),
    Drawing("fitting_room", _fitting_room, _fitting_symbol),
    Drawing("basket_stack", _basket_stack, _basket_symbol),
)
