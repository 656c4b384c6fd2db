"""Shelving of shops and libraries by fitting and trade; all light enough for long rows."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from typing import NamedTuple

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.drawing import LETTERS, Drawing
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import levels_of, merge_by_material, stock
from scenewright.catalog.assets.symbols import Lines, path, rectangle
from scenewright.core.catalog import Material, Symbol
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block

MOST, WIDE = 3500, 1.25
"""About how many triangles of goods a shelving of this width carries."""


class Fitting(NamedTuple):
    """What shelving is built of: its back, shelves, ends, edge strips and foot; how far apart its
    shelves are, and whether a sign runs along its top."""

    name: str
    back: Material
    shelf: Material
    ends: Material
    strip: Material
    foot: Material
    apart: float = 0.38
    panelled: bool = False
    sign: Material | None = None


FITTINGS = (
    Fitting("steel", m.PLASTIC, m.WHITE, m.STEEL, m.PAPER, m.RUBBER, 0.36, sign=m.ACCENT),
    Fitting("oak", m.OAK, m.OAK, m.OAK, m.BLACK, m.CHARCOAL, 0.36, True),
    Fitting("black", m.IRON, m.BLACK, m.BLACK, m.PAPER, m.BLACK, 0.4, sign=m.RED),
)
"""A shop is fitted out by one of them."""


def _tiers(low: float, high: float, apart: float) -> list[Interval]:
    return levels_of(low, high, max(2, round((high - low) / apart)))


def _shelves(x: Interval, y: Interval, tiers: list[Interval], thick: float) -> list[Mesh]:
    return [block(x, y, (low - thick, low)) for low, _ in tiers]


def _side(
    fitting: Fitting,
    trade: str,
    x: Interval,
    y: Interval,
    h: float,
    seed: int,
    turned: bool,
    most: int,
) -> Stuff:
    """One side of a shelving: a deep lowest shelf, slimmer ones above, strips for prices, goods."""
    tiers = _tiers(0.16, h, fitting.apart)
    deep, slim = y, _front_off(y, 0.16, turned)
    held = (_front_off(where, 0.0, turned, 0.006) for where in (deep, slim))
    shelves = [block(x, next(held), (0.1, 0.16)), *_shelves(x, next(held), tiers[1:], 0.022)]
    strips = [
        block((x[0] + 0.004, x[1] - 0.004), _edge(where, turned), (low - 0.034, low + 0.006))
        for (low, _), where in zip(tiers, (deep, *[slim] * len(tiers)), strict=False)
    ]
    inner = (x[0] + 0.02, x[1] - 0.02)
    rows = (
        stock(trade, inner, _front_off(where, 0.03, turned), held, seed + k, share, turned)
        for k, (where, held, share) in enumerate(
            ((deep, tiers[:1], most // len(tiers)), (slim, tiers[1:], most - most // len(tiers)))
        )
    )
    return merge_by_material({fitting.shelf: shelves, fitting.strip: strips}, *rows)


def _most(size: Size) -> int:
    return int(MOST * min(max(size.width / WIDE, 1.0), 1.8))


def _front_off(y: Interval, share: float, turned: bool, more: float = 0.0) -> Interval:
    """A depth less a share of it, and ``more`` metres, at its front, which is ``y[0]`` of
    ``turned`` ones."""
    by = share * (y[1] - y[0]) + more
    return (y[0] + by, y[1]) if turned else (y[0], y[1] - by)


def _edge(y: Interval, turned: bool) -> Interval:
    return (y[0], y[0] + 0.008) if turned else (y[1] - 0.008, y[1])


def _shelving(size: Size, fitting: Fitting, trade: str, seed: int, double: bool) -> Parts:
    """Shelves before a wall, or to both sides of one that stands in their middle."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    sign = min(0.2, 0.12 * h) if fitting.sign else 0.0
    wall = (-0.02, 0.02) if double else (-d, -d + 0.04)
    top, x = h - sign, (-w + 0.008, w - 0.008)
    ends = (-d, d) if fitting.panelled else (wall[0] - 0.01 * double, wall[1] + 0.012)
    found: Stuff = {
        fitting.back: [block(x, wall, (0.1, top - 0.01))],
        fitting.foot: [block(x, (-d + 0.05 * double + 0.02, d - 0.05), (0, 0.1))],
    }
    found.setdefault(fitting.ends, []).extend(
        block((s * w - 0.012 - 0.012 * s, s * w + 0.012 - 0.012 * s), ends, (0.0, top))
        for s in (-1, 1)
    )
    if fitting.sign:
        found.setdefault(fitting.sign, []).append(block((-w, w), _thicker(wall), (top, h)))
    else:
        found.setdefault(fitting.ends, []).append(block((-w, w), wall, (h - 0.01, h)))
    inner = (-w + 0.024, w - 0.024)
    most = _most(size) // (1 + double)
    sides = [_side(fitting, trade, inner, (wall[1], d), top - 0.02, seed, False, most)]
    if double:
        sides.append(_side(fitting, trade, inner, (-d, wall[0]), top - 0.02, seed + 50, True, most))
    return parts(size, merge_by_material(found, *sides))


def _thicker(wall: Interval) -> Interval:
    return wall[0] - 0.01, wall[1] + 0.01


def _fridge_shelf(size: Size, trade: str, seed: int, frame: Material) -> Parts:
    """A cooler: a white case, lit shelves, glass doors with frames."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, high, face = 0.3, h - 0.2, d - 0.05
    tiers = _tiers(low, high, 0.36)
    doors = spread(-w + 0.03, w - 0.03, min(5, max(1, round(size.width / 0.65))))
    x = (-w + 0.03, w - 0.03)
    found: Stuff = {
        m.WHITE: [
            *(block(side, (-d, face), (0.08, high)) for side in ((-w, x[0]), (x[1], w))),
            block(x, (-d, -d + 0.05), (low, high)),
            block(x, (-d, face), (0.08, low)),
            *_shelves(x, (-d + 0.05, face - 0.06), tiers[1:], 0.02),
        ],
        m.GLOW: [block((-0.7 * w, 0.7 * w), (d - 0.006, d), (high + 0.05, h - 0.05)),
                 block(x, (face - 0.05, face - 0.02), (high - 0.03, high))],
        m.CLEAR: [block((a + 0.02, b - 0.02), (face + 0.01, face + 0.02), (low - 0.03, high))
                  for a, b in doors],
        m.STEEL: [block((b - 0.05, b - 0.035), (face + 0.02, d), (low + 0.3, high - 0.3))
                  for _, b in doors],
    }  # fmt: skip
    found.setdefault(frame, []).extend(
        [
            block((-w, w), (-d, d - 0.006), (high, h)),
            block((-w, w), (face, d), (0.12, low - 0.03)),
            block((-w + 0.03, w - 0.03), (-d + 0.03, face - 0.05), (0, 0.08)),
            *(block((a - 0.02, a + 0.02), (face, d - 0.005), (low - 0.03, high))
              for a in (*(a for a, _ in doors[1:]), *x)),
        ]
    )  # fmt: skip
    chilled = stock(
        trade, (-w + 0.05, w - 0.05), (-d + 0.05, face - 0.08), tiers, seed, _most(size)
    )
    return parts(size, merge_by_material(found, chilled))


def _book_stack(size: Size, fitting: Fitting, seed: int) -> Parts:
    """Library shelving for both sides, in bays."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    bays = max(1, round(size.width / 0.95))
    tiers = _tiers(0.12, h - 0.06, 0.34)
    ends = [a for a, _ in spread(-w + 0.012, w - 0.012, bays)] + [w - 0.012]
    found: Stuff = {
        fitting.ends: [block((a - 0.012, a + 0.012), (-d, d), (0, h - 0.02)) for a in ends]
    }
    found.setdefault(fitting.back, []).append(block((-w, w), (-d, d), (h - 0.03, h)))
    found.setdefault(fitting.shelf, []).extend(
        _shelves((-w + 0.024, w - 0.024), (-d + 0.01, d - 0.01), tiers, 0.02)
    )
    found.setdefault(fitting.foot, []).append(
        block((-w + 0.024, w - 0.024), (-d + 0.04, d - 0.04), (0, 0.1))
    )
    most = _most(size) // (2 * bays)
    rows = (
        stock("library", (a + 0.016, b - 0.016), y, tiers, seed + 7 * k + 3 * turned, most, turned)
        for k, (a, b) in enumerate(spread(ends[0], ends[-1], bays))
        for turned, y in ((False, (0.01, d - 0.02)), (True, (-d + 0.02, -0.01)))
    )
    return parts(size, merge_by_material(found, *rows))


def _double_symbol(size: Size) -> Lines:
    """Outline, the wall in the middle and the ends of bays."""
    w, d = size.width / 2, size.depth / 2
    bays = spread(-w, w, max(1, round(size.width / 1.0)))
    return rectangle(size), path((-w, 0), (w, 0)), *(path((a, -d), (a, d)) for a, _ in bays[1:])


def _gondola_symbol(size: Size) -> Lines:
    """As the double shelving, with the edges of the upper shelves."""
    w, d = size.width / 2, size.depth / 2
    edges = (path((-w, s * 0.84 * d), (w, s * 0.84 * d)) for s in (-1, 1))
    return *_double_symbol(size), *edges


def _single_symbol(size: Size) -> Lines:
    """Outline, the wall behind and the ends of bays."""
    w, d = size.width / 2, size.depth / 2
    bays = spread(-w, w, max(1, round(size.width / 1.0)))
    back = -d + min(0.05, 0.2 * size.depth)
    ends = (path((a, back), (a, d)) for a, _ in bays[1:])
    return rectangle(size), path((-w, back), (w, back)), *ends


def _cooler_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    doors = spread(-w, w, min(5, max(1, round(size.width / 0.65))))
    face = d - min(0.06, 0.2 * size.depth)
    leaves = (path((a, -d), (b, face)) for a, b in doors)
    return rectangle(size), path((-w, face), (w, face)), *leaves


_WORDS = {
    "books": "book bookshop bookstore novel librairie livre buch bücher buchhandlung libro 书 本",
    "shoes": "shoe footwear trainer chaussure schuh zapato calzado 鞋 靴",
    "pharmacy": "pharmacy drugstore chemist cosmetic perfumery pharmacie apotheke farmacia 药 薬",
    "bakery": "bakery bread pastry boulangerie pain bäckerei brot panadería pan 面包 パン",
    "electronics": "electronic computer phone gadget électronique elektronik electrónica 电子 電器",
    "fashion": "fashion clothes clothing apparel garment boutique mode kleidung vêtement ropa 服",
    "drinks": "wine drink beverage liquor bottle beer vin boisson wein getränk vino bebida 酒",
}
"""Words for what a trade sells, by which its shelving is asked for."""
_MIXED = ("groceries", "household", "drinks")
PLAIN, EACH = 10, 4
"""Models of a fitting for a market, and for each other trade."""


def _rows(category: str, double: bool, symbol: Symbol, trades: bool = True) -> Iterator[Drawing]:
    """Shelving of every fitting and trade; that of no trade in particular holds the goods of a
    market."""
    label = category.replace("_", " ").capitalize()
    plain = [
        (fit, trade, k) for fit in FITTINGS for k in range(PLAIN) for trade in _MIXED[k % 3 :][:1]
    ]
    for number, (fit, trade, k) in enumerate(plain):
        mesh = partial(_shelving, fitting=fit, trade=trade, seed=5 * number + k, double=double)
        own = f"{category}_{fit.name}_{LETTERS[k]}" if number else ""
        name = f"{label}, {trade}, {fit.name}"
        yield Drawing(category, mesh, symbol, own, name, suit=fit.name)
    sold = [(*row, fit, k) for row in _WORDS.items() for fit in FITTINGS for k in range(EACH)]
    for trade, said, fit, k in sold if trades else ():
        mesh = partial(_shelving, fitting=fit, trade=trade, seed=40 + 9 * k, double=double)
        own, name = f"{category}_{trade}_{fit.name}_{LETTERS[k]}", f"{label}, {trade}, {fit.name}"
        words = tuple(said.split())
        yield Drawing(category, mesh, symbol, own, name, called=words, suit=fit.name)


ASSETS = (
    *_rows("gondola", True, _gondola_symbol),
    *_rows("wall_shelving", False, _single_symbol),
    *_rows("ring_shelf", False, _single_symbol, trades=False),
    *(
        Drawing(
            "fridge_shelf",
            partial(_fridge_shelf, trade=trade, seed=number, frame=frame),
            _cooler_symbol,
            f"fridge_shelf_{LETTERS[number - 1]}" if number > 1 else "",
            f"Cooler with glass doors, {LETTERS[number - 1]}",
        )
        for number, (trade, frame) in enumerate(
            (
                *(("drinks", m.BLACK), ("chilled", m.STEEL), ("chilled", m.BLACK)),
                *(("drinks", m.WHITE), ("chilled", m.CHARCOAL), ("groceries", m.STEEL)),
            ),
            1,
        )
    ),
    *(
        Drawing(
            "book_stack",
            partial(_book_stack, fitting=fit, seed=11 * k),
            _double_symbol,
            f"book_stack_{fit.name}_{LETTERS[k]}" if fit is not FITTINGS[1] or k else "",
            f"Library shelf, {fit.name}, {LETTERS[k]}",
            suit=fit.name,
        )
        for fit in (FITTINGS[1], FITTINGS[0], FITTINGS[2])
        for k in range(PLAIN)
    ),
)
