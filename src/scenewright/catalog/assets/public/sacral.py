"""What stands in churches, and the bar of a restaurant: demands called altar, pulpit, font, bar."""

from __future__ import annotations

from functools import partial
from math import pi

import numpy as np

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.drawing import letter_models
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import merge_by_material, stock
from scenewright.catalog.assets.symbols import Lines, box, oval, path, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import loft
from scenewright.geometry.solids import block, disc, lathe, limb, oval_ring, rod, slab, tube

TABLE = 0.95
"""Height of an altar."""


def _altar(size: Size, stone: Material) -> Parts:
    """Steps all round; where there is height for it an altar on them with cloth, cross, candles."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    bare = h < TABLE + 0.2
    count = max(1, round((h if bare else 0.3 * (h - TABLE) + 0.1) / 0.15))
    rise = h / count if bare else 0.15
    found: Stuff = {
        stone: [
            block((-w + 0.3 * k, w - 0.3 * k), (-d, d - 0.3 * k), (rise * k, rise * (k + 1)))
            for k in range(count)
        ],
        m.VELVET: [],
    }
    low = rise * count
    half = min(0.35 * w, 1.1)
    run = block((-0.3 * half, 0.3 * half), (-0.5 * d, d - 0.3 * (count - 1)), (low, low + 0.004))
    found[m.VELVET].append(run)
    if bare:
        del found[m.VELVET]
        return parts(size, found)
    deep, top = min(0.35 * d, 0.4), low + min(TABLE, 0.75 * (h - low))
    y = (-0.4 * d - deep, -0.4 * d + deep)
    found[stone] += [
        block((-0.8 * half, 0.8 * half), (y[0] + 0.08, y[1] - 0.08), (low, top - 0.1)),
        block((-half, half), y, (top - 0.1, top)),
    ]
    found[m.LINEN] = [
        block((-0.7 * half, 0.7 * half), (y[0], y[1] + 0.006), (top, top + 0.006)),
        block((-0.7 * half, 0.7 * half), (y[1], y[1] + 0.006), (top - 0.3, top)),
    ]
    tall, at = h - top - 0.006, y[0] + 0.15
    bar = top + 0.006 + 0.66 * tall
    found[m.GILT] = [
        rod((0, at, top + 0.006), (0, at, h), 0.018, sides=8),
        rod((-0.22 * tall - 0.05, at, bar), (0.22 * tall + 0.05, at, bar), 0.018, sides=8),
        *(
            lathe(
                [(0.06, top + 0.006), (0.015, top + 0.05), (0.02, top + 0.3 * tall)],
                (x * half, at),
                10,
            )
            for x in (-0.6, -0.4, 0.4, 0.6)
        ),
    ]
    found[m.PAPER] = [
        disc(0.014, (top + 0.3 * tall, top + 0.6 * tall), (x * half, at), 8)
        for x in (-0.6, -0.4, 0.4, 0.6)
    ]
    return parts(size, found)


def _pulpit(size: Size, wood: Material) -> Parts:
    """An eight-sided desk on a stem, a book on its slope."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    rows = (
        (0.95, 0.0),
        (0.95, 0.05),
        (0.4, 0.1),
        (0.36, 0.45),
        (0.9, 0.62),
        (0.9, 0.9),
        (1.0, 0.92),
        (1.0, 0.96),
    )
    body = loft([oval_ring(r * w, r * d, z * h, 8) for r, z in rows])
    ribs = [
        rod(
            (0.92 * w * np.cos(a), 0.92 * d * np.sin(a), 0.62 * h),
            (0.92 * w * np.cos(a), 0.92 * d * np.sin(a), 0.92 * h),
            0.02,
            sides=6,
        )
        for a in np.arange(8) * pi / 4
    ]
    book = [
        block((s * 0.02, s * 0.16) if s > 0 else (-0.16, -0.02), (-0.12, 0.12), (0.96 * h, h))
        for s in (-1, 1)
    ]
    return parts(size, {wood: [body], m.GILT: ribs, m.PAPER: book})


def _font(size: Size, stone: Material) -> Parts:
    """An eight-sided basin with water on a stem and a step."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    rows = (
        (1.0, 0.0),
        (1.0, 0.1),
        (0.45, 0.16),
        (0.36, 0.5),
        (0.85, 0.72),
        (0.9, 1.0),
        (0.72, 1.0),
        (0.6, 0.86),
    )
    basin = loft([oval_ring(r * w, r * d, z * h, 8) for r, z in rows])
    water = loft([oval_ring(r * w, r * d, z * h, 8) for r, z in ((0.62, 0.87), (0.66, 0.93))])
    return parts(size, {stone: [basin], m.GLASS: [water]})


def _bar(size: Size, wood: Material, seed: int) -> Parts:
    """A bar: panelled front with a foot rail, a stone top, taps, bottles on the staff's side."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = h if h < 1.25 else h - 0.3
    panels = spread(-w + 0.02, w - 0.02, max(2, round(size.width / 0.55)))
    front, back = d - 0.2, -0.25 * d
    found: Stuff = {
        wood: [
            *(
                block((a + 0.01, b - 0.01), (front, front + 0.025), (0.14, top - 0.09))
                for a, b in panels
            ),
            *(
                block(
                    (s * w - 0.02 - 0.02 * s, s * w + 0.02 - 0.02 * s),
                    (-d, front),
                    (0.0, top - 0.04),
                )
                for s in (-1, 1)
            ),
            block((-w + 0.04, w - 0.04), (back, front), (0.1, top - 0.04)),
            *(block((-w + 0.04, w - 0.04), (-d, back), (z - 0.025, z)) for z in (0.14, 0.55)),
        ],
        m.SLATE: [slab((-w, w), (-d + 0.02, d), (top - 0.04, top), 0.02)],
        m.BRASS: [
            tube([(-w + 0.05, d - 0.08, 0.2), (w - 0.05, d - 0.08, 0.2)], 0.02, 8),
            *(
                rod((x, front, 0.2), (x, d - 0.08, 0.2), 0.012, sides=6)
                for x in np.linspace(-0.9 * w, 0.9 * w, max(2, round(size.width)))
            ),
        ],
        m.BLACK: [block((-w + 0.05, w - 0.05), (back, front - 0.06), (0, 0.1))],
    }
    if top < h:
        found[m.BRASS].append(limb([(0, 0, top), (0, 0, h - 0.05)], (0.05, 0.06), 12))
        found[m.BRASS] += [
            rod((x, 0, h - 0.05), (x, 0.08, h), 0.012, sides=6) for x in (-0.03, 0.03)
        ]
    shelves = [(0.14, 0.52), (0.55, top - 0.08)]
    bottles = stock("drinks", (-w + 0.06, w - 0.06), (-d, back - 0.01), shelves, seed, 2600, True)
    return parts(size, merge_by_material(found, bottles))


def _altar_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    half, deep = min(0.35 * w, 1.1), min(0.35 * d, 0.4)
    steps = box(-w + 0.3 * w, w - 0.3 * w, -d, 0.7 * d)
    return rectangle(size), steps, box(-half, half, -0.4 * d - deep, -0.4 * d + deep)


def _round_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return oval(0, 0, w, d, 8), oval(0, 0, 0.6 * w, 0.6 * d, 8)


def _bar_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, 0.6 * d), (w, 0.6 * d)), path((-w, -0.25 * d), (w, -0.25 * d))


_ALTAR = "altar autel 祭坛 祭壇"
_PULPIT = "pulpit ambo kanzel chaire púlpito 讲坛 説教壇"
_FONT = "font taufbecken taufstein baptistère pila 洗礼盆 洗礼盤"
_BAR = "bar pub tresen theke comptoir barra taproom 吧台 バーカウンター"

ASSETS = (
    *letter_models(
        "stage",
        _altar_symbol,
        (partial(_altar, stone=one) for one in (m.LIMESTONE, m.STONE, m.SANDSTONE)),
        "stage_altar",
        "Altar",
        called=_ALTAR,
    ),
    *letter_models(
        "lectern",
        _round_symbol,
        (partial(_pulpit, wood=one) for one in (m.OAK_DARK, m.WALNUT, m.LIMESTONE)),
        "lectern_pulpit",
        "Pulpit",
        called=_PULPIT,
    ),
    *letter_models(
        "plinth",
        _round_symbol,
        (partial(_font, stone=one) for one in (m.LIMESTONE, m.MARBLE, m.SANDSTONE)),
        "plinth_font",
        "Font",
        called=_FONT,
    ),
    *letter_models(
        "counter",
        _bar_symbol,
        (
            partial(_bar, wood=one, seed=k)
            for k, one in enumerate((m.WALNUT, m.OAK, m.TIMBER, m.SAGE, m.NAVY_LACQUER))
        ),
        "counter_bar",
        "Bar",
        called=_BAR,
    ),
)
