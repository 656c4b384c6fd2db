"""Exhibition halls: showcases, plinths, wall cases, panels, islands, touch tables."""

from __future__ import annotations

from functools import partial
from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    BRONZE,
    CERAMIC,
    CHARCOAL,
    CLAY,
    CLEAR,
    GLOW,
    GREIGE,
    LINEN,
    MUSTARD,
    PAPER,
    SCREEN,
    SLATE,
    TERRACOTTA,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import exhibits, merge_by_material, vessel
from scenewright.catalog.assets.symbols import Lines, oval, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import (
    Interval,
    ball,
    block,
    connect_rings,
    frame,
    lathe,
    make_bevelled_box,
    mesh_is_inside_out,
    slab,
)


def _corner_posts(w: float, d: float, z: Interval, half: float) -> list[Mesh]:
    return [
        block(
            (sx * (w - half) - half, sx * (w - half) + half),
            (sy * (d - half) - half, sy * (d - half) + half),
            z,
        )
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]


def _rails(w: float, d: float, z: Interval, wide: float) -> list[Mesh]:
    """Bars along the four edges of a rectangle."""
    across = [block((-w, w), y, z) for y in ((-d, -d + wide), (d - wide, d))]
    along = [block(x, (-d + wide, d - wide), z) for x in ((-w, -w + wide), (w - wide, w))]
    return across + along


def _showcase(size: Size) -> Parts:
    """A case to look down into: a cabinet with a glass hood."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    deck = 0.7 * h
    found: Stuff = {
        WHITE: [block((-w, w), (-d, d), (0.08, deck))],
        BLACK: [
            block((-w + 0.04, w - 0.04), (-d + 0.04, d - 0.04), (0, 0.08)),
            *_corner_posts(w, d, (deck, h), 0.006),
            *_rails(w, d, (h - 0.012, h), 0.012),
        ],
        LINEN: [block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.03), (deck, deck + 0.02))],
        CLEAR: [block((-w + 0.003, w - 0.003), (-d + 0.003, d - 0.003), (deck + 0.001, h - 0.002))],
    }
    inside = exhibits(
        (-w + 0.06, w - 0.06),
        (-d + 0.06, d - 0.06),
        (deck + 0.02, h - 0.02),
        round(10 * size.width),
    )
    return parts(size, merge_by_material(found, inside))


def _tall_showcase(size: Size) -> Parts:
    """A case seen from all sides: low base, glass up to a lit top, a glass shelf if it is high."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    deck, top = min(0.45, 0.25 * h), h - 0.1
    middle = (deck + top) / 2
    ledge = ((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.02))
    found: Stuff = {
        GREIGE: [block((-w, w), (-d, d), (0.06, deck)), block((-w, w), (-d, d), (top, h))],
        BLACK: [
            block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.03), (0, 0.06)),
            *_corner_posts(w, d, (deck, top), 0.01),
        ],
        LINEN: [block(*ledge, (deck, deck + 0.02))],
        GLOW: [block(*ledge, (top - 0.012, top))],
        CLEAR: [
            block((-w + 0.005, w - 0.005), (-d + 0.005, d - 0.005), (deck, top)),
            block(*ledge, (middle - 0.01, middle)),
        ],
    }
    x, y = (-w + 0.08, w - 0.08), (-d + 0.08, d - 0.08)
    low = exhibits(x, y, (deck + 0.02, middle - 0.05), round(10 * size.width), 3)
    high = exhibits(x, y, (middle, top - 0.15), round(10 * size.width) + 2, 3)
    return parts(size, merge_by_material(found, low, high))


def _pedestal(size: Size, top: float) -> Stuff:
    w, d = size.width / 2, size.depth / 2
    return {
        WHITE: [block((-w, w), (-d, d), (0.03, top))],
        BLACK: [block((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.02), (0, 0.03))],
    }


def _plinth(size: Size) -> Parts:
    """An abstract ring of bronze, thick below and thin above."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = 0.6 * h
    radius = (h - top) / 2
    wide = min(0.85 * w, 1.1 * radius)
    rings = []
    for k in range(14):
        a = 2 * pi * k / 14
        thick = 0.16 * radius * (1.7 + 0.9 * cos(a)) / 1.7
        centre = np.array([0.78 * wide * sin(a), 0.0, top + radius - 0.72 * radius * cos(a)])
        around = np.arange(6) * pi / 3
        out = np.array([sin(a), 0.0, -cos(a)])
        cross = np.outer(np.cos(around), out) * thick
        rings.append(centre + cross + np.outer(np.sin(around), [0.25, 1.0, 0.0]) * thick)
    body = connect_rings(np.array(rings))
    body = Mesh(body.vertices, body.faces[:, ::-1]) if mesh_is_inside_out(body) else body
    lift = float(body.vertices[:, 2].max())
    body = Mesh(body.vertices * (1, min(1.0, 3 * d), 1) + (0, 0, h - lift), body.faces)
    foot = block((-0.3 * wide, 0.3 * wide), (-0.35 * d, 0.35 * d), (top, top + 0.16 * radius))
    return parts(size, merge_by_material(_pedestal(size, top), {BRONZE: [body], SLATE: [foot]}))


def _plinth_vase(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = 0.62 * h
    body = vessel(min(0.75 * min(w, d), 0.5 * (h - top)), top, h - top, (0.0, 0.0), 14)
    return parts(size, merge_by_material(_pedestal(size, top), {CLAY: [body]}))


def _plinth_bust(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = 0.68 * h
    tall = h - top
    wide = min(0.9 * w, 0.54 * tall)
    deep = min(0.5, 0.9 * d / wide)
    shape = [
        (0.42, 0),
        (0.42, 0.06),
        (0.24, 0.1),
        (0.3, 0.18),
        (0.92, 0.26),
        (1.0, 0.36),
        (0.8, 0.48),
        (0.32, 0.54),
        (0.27, 0.66),
    ]
    body = lathe([(r * wide, top + z * tall) for r, z in shape], sides=12, squash=deep)
    head = ball(0.36 * wide, 0.44 * wide, 0.23 * tall, (0, 0.05 * wide, top + 0.77 * tall), 10, 6)
    nose = block(
        (-0.05 * wide, 0.05 * wide), (0.4 * wide, 0.53 * wide), (top + 0.7 * tall, top + 0.8 * tall)
    )
    return parts(size, merge_by_material(_pedestal(size, top), {CERAMIC: [body, head, nose]}))


def _panel(size: Size) -> Parts:
    """A board printed on both sides, on a bar or, where there is room, on crosswise feet."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    board, low = min(0.7 * d, 0.025), 0.16
    feet = (
        [block((-w, w), (-d, d), (0, 0.03))]
        if d < 0.1
        else [
            block((s * (w - 0.06) - 0.04, s * (w - 0.06) + 0.04), (-d, d), (0, 0.025))
            for s in (-1, 1)
        ]
    )
    posts = [
        block((s * (w - 0.02) - 0.02, s * (w - 0.02) + 0.02), (-board, board), (0.02, h))
        for s in (-1, 1)
    ]
    inner, ink = (-w + 0.04, w - 0.04), (-board - 0.001, board + 0.001)
    left = (inner[0] + 0.06, -0.02 + 0.12 * w)
    right = (left[1] + 0.06, inner[1] - 0.06)
    middle = 0.5 * h
    lines = [
        block(
            (right[0], right[1] - 0.2 * (right[1] - right[0]) * (k % 3 == 2)),
            ink,
            (z - 0.012, z + 0.012),
        )
        for k, z in enumerate(np.linspace(middle, h - 0.42, 7))
    ]
    return parts(
        size,
        {
            BLACK: [*feet, *posts],
            PAPER: [block(inner, (-board + 0.004, board - 0.004), (low, h - 0.01))],
            ACCENT: [block(inner, (-board, board), (h - 0.22, h - 0.01))],
            TERRACOTTA: [block(left, ink, (middle - 0.12, middle + 0.22 * (h - middle)))],
            MUSTARD: [block(left, ink, (middle + 0.22 * (h - middle), h - 0.32))],
            CHARCOAL: lines,
        },
    )


def _wall_exhibit(size: Size) -> Parts:
    """A shallow case against the wall: cabinet, lit niche behind glass, objects on two shelves."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, high, face = 0.33 * h, h - 0.12, d - 0.012
    x, y, z = (-w + 0.03, w - 0.03), (-d + 0.03, face - 0.02), (low + 0.02, high)
    middle = (z[0] + z[1]) / 2
    found: Stuff = {
        SLATE: [
            block((-w, w), (-d, face), (0.06, low)),
            block((-w, w), (-d, face), (high, h)),
            block((-w, x[0]), (-d, face), (low, high)),
            block((x[1], w), (-d, face), (low, high)),
            frame((-w, w), (face, d), (low, h), 0.03),
        ],
        BLACK: [block(x, (-d + 0.02, face - 0.03), (0, 0.06))],
        LINEN: [block(x, (-d, -d + 0.03), (low, high)), block(x, y, (low, z[0]))],
        GLOW: [block(x, (face - 0.05, face - 0.02), (high - 0.02, high))],
        CLEAR: [
            block(x, (face, face + 0.005), (low + 0.03, h - 0.03)),
            block(x, y, (middle - 0.01, middle)),
        ],
    }
    inner = (x[0] + 0.05, x[1] - 0.05)
    seed = round(10 * size.width)
    below = exhibits(inner, y, (z[0], middle - 0.05), seed, 4)
    above = exhibits(inner, y, (middle, high - 0.1), seed + 3, 4)
    return parts(size, merge_by_material(found, below, above))


def _painting(size: Size, turn: int = 0) -> Parts:
    """A framed painting on the wall, lit from a bar above it, behind a low rail; another for each
    ``turn`` from 0 to 3."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    low, high, back = (0.42 + 0.04 * (turn % 2)) * h, 0.93 * h, -d
    x = (-(0.92 - 0.14 * turn) * w, (0.92 - 0.14 * turn) * w)
    tall, wide = high - low, x[1] - x[0]
    rail = min(d - 0.02, back + 0.4)
    shapes = (
        (MUSTARD, 0.06, 0.94, 0.06, 0.45),
        (TERRACOTTA, 0.12, 0.5, 0.35, 0.85),
        (SLATE, 0.55, 0.85, 0.3, 0.7),
        (ACCENT, 0.35, 0.62, 0.6, 0.9),
    )
    found: Stuff = {
        CHARCOAL: [frame(x, (back, back + 0.05), (low, high), 0.05)],
        PAPER: [block((x[0] + 0.05, x[1] - 0.05), (back, back + 0.03), (low + 0.05, high - 0.05))],
        GLOW: [block((-0.4 * w, 0.4 * w), (back + 0.12, back + 0.15), (high + 0.03, high + 0.05))],
        BLACK: [
            block(
                (side * 0.92 * w - 0.012, side * 0.92 * w + 0.012), (rail - 0.024, rail), (0, 0.45)
            )
            for side in (-1, 1)
        ],
        BRONZE: [block((-0.92 * w, 0.92 * w), (rail - 0.018, rail - 0.006), (0.43, 0.45))],
    }
    colours = [row[0] for row in shapes]
    turned = (*colours[turn:], *colours[:turn])
    for k, (material, (_, x0, x1, z0, z1)) in enumerate(zip(turned, shapes, strict=True)):
        face = back + 0.031 + 0.001 * k
        spot = (x[0] + 0.05 + x0 * (wide - 0.1), x[0] + 0.05 + x1 * (wide - 0.1))
        found.setdefault(material, []).append(
            block(spot, (back + 0.03, face), (low + z0 * tall, low + z1 * tall))
        )
    return parts(size, found)


def _painting_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size, 0, 0), path((-0.92 * w, -d + 0.05), (0.92 * w, -d + 0.05))


def _interactive_table(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    foot = block((-0.55 * w, 0.55 * w), (-0.45 * d, 0.45 * d), (0.02, h - 0.1))
    tiles = [(MUSTARD, -0.5, 0.1, 0.16), (ACCENT, 0.1, -0.25, 0.24), (TERRACOTTA, 0.5, 0.3, 0.14)]
    found: Stuff = {
        WHITE: [make_bevelled_box((-w, w), (-d, d), (h - 0.11, h - 0.002), 0.03), foot],
        BLACK: [slab((-0.75 * w, 0.75 * w), (-0.75 * d, 0.75 * d), (0, 0.02), 0.04)],
        SCREEN: [block((-w + 0.07, w - 0.07), (-d + 0.07, d - 0.07), (h - 0.01, h - 0.001))],
    }
    for material, x, y, half in tiles:
        tile = block(
            ((x - half) * w, (x + half) * w), ((y - half) * d, (y + half) * d), (h - 0.002, h)
        )
        found.setdefault(material, []).append(tile)
    return parts(size, found)


def _case_symbol(size: Size) -> Lines:
    """Glass over a case: outline, inner outline, one diagonal."""
    w, d = size.width / 2, size.depth / 2
    inset = min(0.04, 0.2 * min(w, d))
    return (
        rectangle(size),
        rectangle(size, inset),
        path((-w + inset, -d + inset), (w - inset, d - inset)),
    )


def _plinth_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    radius = 0.6 * min(w, d)
    return rectangle(size), oval(0, 0, radius)


def _panel_symbol(size: Size) -> Lines:
    w = size.width / 2
    return rectangle(size), path((-w, 0), (w, 0))


def _wall_case_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = d - min(0.05, 0.2 * size.depth)
    return rectangle(size), path((-w, line), (w, line)), path((-w, -d), (w, line))


def _touch_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        rectangle(size, 0, 0.05),
        rectangle(size, min(0.07, 0.3 * d)),
        oval(0, 0, 0.25 * min(w, d)),
    )


_TALL = (Size(0.4, 0.4, 1.5), Size(1.2, 0.6, 2.1), Size(4.0, 1.5, 3.0))
_VASE = (Size(0.25, 0.25, 0.9), Size(0.6, 0.6, 1.4), Size(1.5, 1.5, 3.2))
_BUST = (Size(0.25, 0.25, 0.9), Size(0.4, 0.4, 1.7), Size(1.5, 1.5, 3.2))
_PICTURES = (
    "painting picture photo photograph drawing print canvas portrait gemälde bild foto zeichnung "
    "tableau peinture dessin cuadro pintura dibujo 绘画 照片 絵画 写真"
)
_PAINTING = (Size(0.4, 0.1, 1.4), Size(1.2, 0.15, 2.2), Size(4.0, 0.7, 3.2))

ASSETS = (
    Drawing("showcase", _showcase, _case_symbol),
    Drawing(
        "showcase",
        _tall_showcase,
        _case_symbol,
        id="showcase_tall",
        name="Tall showcase",
        sizes=_TALL,
    ),
    Drawing("plinth", _plinth, _plinth_symbol, name="Plinth with a bronze"),
    Drawing(
        "plinth",
        _plinth_vase,
        _plinth_symbol,
        id="plinth_vase",
        name="Plinth with a vessel",
        sizes=_VASE,
    ),
    Drawing(
        "plinth",
        _plinth_bust,
        _plinth_symbol,
        id="plinth_bust",
        name="Plinth with a bust",
        sizes=_BUST,
    ),
    Drawing("exhibit_panel", _panel, _panel_symbol),
    Drawing("wall_exhibit", _wall_exhibit, _wall_case_symbol),
    *(
        Drawing(
            "wall_exhibit",
            partial(_painting, turn=turn),
            _painting_symbol,
            id=f"wall_exhibit_painting_{turn + 1}",
            name=f"Painting on a wall, {turn + 1}",
            sizes=_PAINTING,
            called=tuple(_PICTURES.split()),
        )
        for turn in range(4)
    ),
    Drawing("interactive_table", _interactive_table, _touch_symbol),
)
