"""Shelving of shops and libraries that carries goods or books; all light enough for long rows."""

from __future__ import annotations

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    CHARCOAL,
    CLEAR,
    GLOW,
    OAK,
    PLASTIC,
    RUBBER,
    STEEL,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import goods, levels_of, merge_by_material, volumes
from scenewright.catalog.assets.symbols import Lines, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block

FACINGS = 36
"""Most blocks of goods on one shelving, however long it is."""


def _tiers(low: float, high: float, apart: float) -> list[Interval]:
    return levels_of(low, high, max(2, round((high - low) / apart)))


def _facings(size: Size, tiers: int, apart: float = 0.17) -> int:
    return max(2, min(round(size.width / apart), FACINGS // tiers))


def _shelves(x: Interval, y: Interval, tiers: list[Interval], thick: float) -> list[Mesh]:
    return [block(x, y, (low - thick, low)) for low, _ in tiers]


def _gondola(size: Size) -> Parts:
    """Shelves to both sides of a middle wall; each block of goods goes through it."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    tiers = _tiers(0.16, h - 0.02, 0.38)
    deep, slim = (-d, d), (-0.84 * d, 0.84 * d)
    inner = (-w + 0.02, w - 0.02)
    count = _facings(size, len(tiers))
    found: Stuff = {
        PLASTIC: [block((-w + 0.002, w - 0.002), (-0.02, 0.02), (0.1, h - 0.01))],
        WHITE: [block((-w, w), deep, (0.1, 0.16)), *_shelves((-w, w), slim, tiers[1:], 0.025)],
        STEEL: [
            block((s * (w - 0.012) - 0.012, s * (w - 0.012) + 0.012), (-0.03, 0.03), (0.1, h))
            for s in (-1, 1)
        ],
        RUBBER: [block((-w, w), (-d + 0.05, d - 0.05), (0, 0.1))],
    }
    seed = round(10 * size.width)
    low = goods(inner, (-0.92 * d, 0.92 * d), tiers[:1], count, seed)
    return parts(
        size,
        merge_by_material(
            found, low, goods(inner, (-0.8 * d, 0.8 * d), tiers[1:], count, seed + 9)
        ),
    )


def _wall_shelving(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    tiers = _tiers(0.16, h - 0.1, 0.38)
    slim, inner = (-d + 0.04, 0.75 * d), (-w + 0.02, w - 0.02)
    count = _facings(size, len(tiers))
    found: Stuff = {
        PLASTIC: [block((-w + 0.002, w - 0.002), (-d, -d + 0.04), (0.1, h - 0.01))],
        WHITE: [
            block((-w, w), (-d, d), (0.1, 0.16)),
            *_shelves((-w, w), slim, tiers[1:], 0.025),
            block((-w, w), slim, (h - 0.1, h - 0.02)),
        ],
        STEEL: [
            block((s * (w - 0.012) - 0.012, s * (w - 0.012) + 0.012), (-d, -d + 0.05), (0.1, h))
            for s in (-1, 1)
        ],
        RUBBER: [block((-w, w), (-d + 0.02, d - 0.05), (0, 0.1))],
    }
    seed = round(10 * size.width)
    low = goods(inner, (-d + 0.04, 0.92 * d), tiers[:1], count, seed)
    return parts(
        size,
        merge_by_material(
            found, low, goods(inner, (-d + 0.04, 0.7 * d), tiers[1:], count, seed + 9)
        ),
    )


def _ring_shelf(size: Size) -> Parts:
    """A segment with plain ends, so that it stands beside its like around a middle."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    tiers = _tiers(0.14, h - 0.03, 0.36)
    inner = (-w + 0.022, w - 0.022)
    found: Stuff = {
        OAK: [
            block((s * (w - 0.011) - 0.011, s * (w - 0.011) + 0.011), (-d, d), (0, h))
            for s in (-1, 1)
        ],
        WHITE: [
            block(inner, (-d, -d + 0.02), (0.1, h - 0.03)),
            *_shelves(inner, (-d + 0.02, d - 0.01), tiers, 0.024),
        ],
        CHARCOAL: [block(inner, (-d + 0.02, d - 0.05), (0, 0.1))],
    }
    found[OAK].append(block(inner, (-d, d), (h - 0.03, h)))
    y = (-d + 0.03, d - 0.04)
    shown = goods((-w + 0.03, w - 0.03), y, tiers, _facings(size, len(tiers), 0.2), round(7 * h))
    return parts(size, merge_by_material(found, shown))


def _fridge_shelf(size: Size) -> Parts:
    """A cooler: a white case, lit shelves, glass doors with dark frames."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, high, face = 0.3, h - 0.2, d - 0.05
    tiers = _tiers(low, high, 0.34)
    doors = spread(-w + 0.03, w - 0.03, min(5, max(1, round(size.width / 0.65))))
    x = (-w + 0.03, w - 0.03)
    found: Stuff = {
        WHITE: [
            block((-w, x[0]), (-d, face), (0.08, high)),
            block((x[1], w), (-d, face), (0.08, high)),
            block(x, (-d, -d + 0.05), (low, high)),
            block(x, (-d, face), (0.08, low)),
            *_shelves(x, (-d + 0.05, face - 0.06), tiers[1:], 0.02),
        ],
        BLACK: [
            block((-w, w), (-d, d), (high, h)),
            block((-w, w), (face, d), (0.12, low - 0.03)),
            block((-w + 0.03, w - 0.03), (-d + 0.03, face - 0.05), (0, 0.08)),
            *(
                block((a - 0.02, a + 0.02), (face, d - 0.005), (low - 0.03, high))
                for a in (*(a for a, _ in doors[1:]), x[0], x[1])
            ),
        ],
        GLOW: [block(x, (face - 0.05, face - 0.02), (high - 0.03, high))],
        CLEAR: [
            block((a + 0.02, b - 0.02), (face + 0.01, face + 0.02), (low - 0.03, high))
            for a, b in doors
        ],
        STEEL: [
            block((b - 0.05, b - 0.035), (face + 0.02, d), (low + 0.3, high - 0.3))
            for _, b in doors
        ],
    }
    count = _facings(size, len(tiers), 0.15)
    chilled = goods(
        (-w + 0.05, w - 0.05), (-d + 0.05, face - 0.08), tiers, count, round(10 * size.width)
    )
    return parts(size, merge_by_material(found, chilled))


def _book_stack(size: Size) -> Parts:
    """Library shelving for both sides; a block of books goes through from face to face."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    bays = max(1, round(size.width / 0.95))
    tiers = _tiers(0.12, h - 0.06, 0.32)
    ends = [a for a, _ in spread(-w + 0.012, w - 0.012, bays)] + [w - 0.012]
    count = max(
        3, min(round(size.width / bays / 0.13), 44 // len(tiers), 200 // (bays * len(tiers)))
    )
    found: Stuff = {
        OAK: [
            *(block((a - 0.012, a + 0.012), (-d, d), (0, h - 0.02)) for a in ends),
            block((-w, w), (-d, d), (h - 0.03, h)),
        ],
        WHITE: _shelves((-w + 0.024, w - 0.024), (-d + 0.01, d - 0.01), tiers, 0.02),
        CHARCOAL: [block((-w + 0.024, w - 0.024), (-d + 0.04, d - 0.04), (0, 0.1))],
    }
    rows = [
        volumes(
            (a + 0.016, b - 0.016 - 0.06 * (b - a)), (-d + 0.03, d - 0.03), tiers, count, 53 * k
        )
        for k, (a, b) in enumerate(spread(ends[0], ends[-1], bays))
    ]
    return parts(size, merge_by_material(found, *rows))


def _double_symbol(size: Size) -> Lines:
    """Outline, the wall in the middle and the ends of bays."""
    w, d = size.width / 2, size.depth / 2
    bays = spread(-w, w, max(1, round(size.width / 1.0)))
    return rectangle(size), path((-w, 0), (w, 0)), *(path((a, -d), (a, d)) for a, _ in bays[1:])


def _gondola_symbol(size: Size) -> Lines:
    """As the double shelving, with the edges of the upper shelves."""
    w, d = size.width / 2, size.depth / 2
    return (
        *_double_symbol(size),
        path((-w, 0.84 * d), (w, 0.84 * d)),
        path((-w, -0.84 * d), (w, -0.84 * d)),
    )


def _single_symbol(size: Size) -> Lines:
    """Outline, the wall behind and the ends of bays."""
    w, d = size.width / 2, size.depth / 2
    bays = spread(-w, w, max(1, round(size.width / 1.0)))
    back = -d + min(0.05, 0.2 * size.depth)
    return (
        rectangle(size),
        path((-w, back), (w, back)),
        *(path((a, back), (a, d)) for a, _ in bays[1:]),
    )


def _cooler_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    doors = spread(-w, w, min(5, max(1, round(size.width / 0.65))))
    face = d - min(0.06, 0.2 * size.depth)
    return (
        rectangle(size),
        path((-w, face), (w, face)),
        *(path((a, -d), (b, face)) for a, b in doors),
    )


ASSETS = (
    Drawing("gondola", _gondola, _gondola_symbol),
    Drawing("wall_shelving", _wall_shelving, _single_symbol),
    Drawing("ring_shelf", _ring_shelf, _single_symbol),
    Drawing("fridge_shelf", _fridge_shelf, _cooler_symbol),
    Drawing("book_stack", _book_stack, _double_symbol),
)
