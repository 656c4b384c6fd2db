"""Shops: clothes, tables of goods, fitting rooms, checkouts, baskets."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from math import pi

from scenewright.catalog.assets.drawing import LETTERS, Drawing
from scenewright.catalog.assets.joinery import four_legs, spread
from scenewright.catalog.assets.materials import BLACK, BRASS, CHROME, OAK, PINE, WALNUT, WHITE
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.garments import hang_row
from scenewright.catalog.assets.public.wares import merge_by_material, stack_folded_cloth, stock
from scenewright.core.catalog import Symbol
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import block, disc, pipe, rod

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
