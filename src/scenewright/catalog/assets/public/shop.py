"""Shops: clothes, tables of goods, fitting rooms, checkouts, baskets."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import pairwise
from math import pi

import numpy as np

from scenewright.catalog.assets.drawing import LETTERS, Drawing
from scenewright.catalog.assets.joinery import four_legs, spread
from scenewright.catalog.assets.materials import (
    BLACK,
    BRASS,
    CHROME,
    MIRROR,
    OAK,
    PINE,
    RED,
    RUBBER,
    SAGE_FABRIC,
    STEEL,
    WALNUT,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.garments import OUTFITS, Outfit, dress_mannequin, hang_row
from scenewright.catalog.assets.public.wares import merge_by_material, stack_folded_cloth, stock
from scenewright.catalog.assets.symbols import Lines, arc, box, oval, path, rectangle
from scenewright.core.catalog import Symbol
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import block, disc, pipe, rod, slab, trough, tube

SUITS = {"steel": (CHROME, WHITE), "oak": (BRASS, OAK), "black": (BLACK, WALNUT)}
"""Metal and wood of the fitting of a shop."""
TURNS = 5
"""Models of a kind in each suit."""


def _clothes_rail(size: Size, suit: str, seed: int) -> Parts:
    """A rail on two posts, of two uprights each on every other model, clothes along it."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    x = w - 0.03
    bars = [rod((s * x, 0, 0.03), (s * x, 0, h), 0.016, sides=8) for s in (-1, 1)]
    feet = [block((s * x - 0.03, s * x + 0.03), (-d, d), (0, 0.03)) for s in (-1, 1)]
    rail = rod((-w, 0, h - 0.03), (w, 0, h - 0.03), 0.015, sides=8)
    count = min(22, max(3, round(size.width / 0.07)))

    def put(k: int, mesh: Mesh) -> Mesh:
        return translate_mesh(mesh, -w + 0.1 + (size.width - 0.2) * (k + 0.5) / count)

    hung = hang_row(count, min(0.23, 0.85 * d), h - 0.045, h - 0.42, 13 * seed, put)
    metal, wood = SUITS[suit]
    found: Stuff = {metal: [*bars, *feet, rail]}
    if seed % 2:
        shoes = stock("shoes", (-w + 0.08, w - 0.08), (-0.6 * d, 0.6 * d), [(0.2, 0.5)], seed, 500)
        shelf = block((-x, x), (-0.7 * d, 0.7 * d), (0.18, 0.2))
        found = merge_by_material(found, {wood: [shelf]}, shoes)
    return parts(size, merge_by_material(found, hung))


def _round_rack(size: Size, suit: str, seed: int) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    half = min(0.22, 0.42 * min(w, d))
    ring, rail = 1.0 - half / min(w, d), h - 0.1
    found: Stuff = {
        SUITS[suit][0]: [
            pipe(ring + 0.02, ring - 0.02, (rail - 0.02, rail + 0.01), sides=20),
            disc(0.06, (0.03, h), sides=6),
            disc(0.5, (0, 0.03), sides=14),
            block((-ring, ring), (-0.012, 0.012), (rail - 0.02, rail)),
            block((-0.012, 0.012), (-ring, ring), (rail - 0.02, rail)),
        ]
    }
    count = 20

    def put(k: int, mesh: Mesh) -> Mesh:
        return rotate_mesh(translate_mesh(mesh, 0.0, ring * min(w, d)), "z", 2 * pi * k / count)

    scaled = {k: [Mesh(b.vertices * (w, d, 1), b.faces) for b in v] for k, v in found.items()}
    row = hang_row(count, half, rail - 0.01, h - 0.42, 17 * seed, put)
    stretched = {
        k: [Mesh(b.vertices * (w / min(w, d), d / min(w, d), 1), b.faces) for b in v]
        for k, v in row.items()
    }
    return parts(size, merge_by_material(scaled, stretched))


def _mannequin(size: Size, outfit: Outfit, seed: int) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    base = disc(1.0, (0, 0.02), sides=20)
    plate = Mesh(base.vertices * (w, d, 1), base.faces)
    return parts(size, merge_by_material({STEEL: [plate]}, dress_mannequin(h, outfit, seed)))


_SHOWN = {"produce": 0.17, "bakery": 0.18, "books": 0.33, "shoes": 0.2, "electronics": 0.31}
"""How high goods of a trade stand on a table, metres; folded cloth else."""


def _display_table(size: Size, suit: str, seed: int, trade: str = "") -> Parts:
    """A table, and one below it: with folded cloth, or goods of a trade in trays."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = h - min(_SHOWN.get(trade, 0.22), 0.35 * h)
    wood = SUITS[suit][1]
    legs = four_legs(w, d, (0, top - 0.04), 0.035, 0.035, 0.03, square=True)
    table = [
        block((-w, w), (-d, d), (top - 0.04, top)),
        block((-w + 0.05, w - 0.05), (-d + 0.05, d - 0.05), (0.2, 0.225)),
    ]
    x, y = (-w + 0.06, w - 0.06), (-d + 0.06, d - 0.06)
    if not trade:
        shown = stack_folded_cloth(x, y, (top, h), 10 * seed + round(10 * size.width))
        below = stock("fashion", x, (y[0], 0.0), [(0.225, min(0.6, top - 0.1))], seed, 500)
        return parts(size, merge_by_material({wood: [*legs, *table]}, shown, below))
    rows = max(1, min(3, round(size.depth / 0.42)))
    found: Stuff = {wood: [*legs, *table]}
    for k, (c, e) in enumerate(spread(*y, rows)):
        sides = [block(x, (a, a + 0.012), (top, top + 0.1)) for a in (c, e - 0.012)]
        sides += [block((a, a + 0.012), (c, e), (top, top + 0.1)) for a in (x[0], x[1] - 0.012)]
        held = stock(
            trade,
            (x[0] + 0.02, x[1] - 0.02),
            (c + 0.02, e - 0.02),
            [(top + 0.03, h + 0.02)],
            seed + 9 * k,
            3400 // rows,
        )
        found = merge_by_material(
            found, {PINE: [*sides, block(x, (c, e), (top, top + 0.03))]}, held
        )
    return parts(size, found)


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


def _suited(
    category: str,
    symbol: Symbol,
    mesh: Callable[..., Parts],
    each: int = TURNS,
    called: str = "",
    trade: str = "",
) -> Iterator[Drawing]:
    """Models of one kind and size that differ in what they hold, in every suit; the first one has
    its kind's id."""
    for number, (suit, k) in enumerate((suit, k) for suit in SUITS for k in range(each)):
        drawn = partial(mesh, suit=suit, seed=number, **({"trade": trade} if trade else {}))
        stem = f"{category}_{trade}" if trade else category
        own = f"{stem}_{LETTERS[number]}" if trade or number else ""
        label = f"{stem.replace('_', ' ').capitalize()}, {suit}, {LETTERS[k]}"
        yield Drawing(category, drawn, symbol, own, label, called=tuple(called.split()), suit=suit)


_LAID_OUT = {
    "produce": "produce fruit vegetable greengrocer obst gemüse légumes fruta verdura 蔬果 青果",
    "bakery": "bakery bread pastry boulangerie pain bäckerei brot panadería pan 面包 パン",
    "books": "book bookshop bookstore librairie livre buch bücher buchhandlung libro 书 本",
    "shoes": "shoe footwear trainer chaussure schuh zapato calzado 鞋 靴",
    "electronics": "electronic computer phone gadget électronique elektronik electrónica 电子 電器",
}
"""What is laid out on tables, and the words by which it is asked for."""

ASSETS = (
    *_suited("clothes_rail", _rail_symbol, _clothes_rail),
    *_suited("round_rack", _round_rack_symbol, _round_rack),
    *(
        Drawing(
            "mannequin",
            partial(_mannequin, outfit=OUTFITS[k % len(OUTFITS)], seed=k),
            _mannequin_symbol,
            f"mannequin_{LETTERS[k]}" if k else "",
            f"Mannequin, {OUTFITS[k % len(OUTFITS)].name}",
        )
        for k in range(12)
    ),
    *_suited("display_table", _stacks_symbol, _display_table),
    *(
        drawing
        for trade, said in _LAID_OUT.items()
        for drawing in _suited("display_table", _stacks_symbol, _display_table, 3, said, trade)
    ),
    Drawing("fitting_room", _fitting_room, _fitting_symbol),
    Drawing("basket_stack", _basket_stack, _basket_symbol),
)
