"""Reading rooms: long tables with lamps, chairs, carrels, terminals."""

from __future__ import annotations

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import bent, four_legs
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    BRASS,
    CHARCOAL,
    FABRIC,
    GLOW,
    MUSTARD,
    NAVY,
    OAK,
    OAK_DARK,
    PAPER,
    SAGE,
    SCREEN,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.symbols import Lines, box, crescent, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import rotate_mesh
from scenewright.geometry.solids import block, cushion, make_bevelled_box, rod, slab


def _lamp_spots(size: Size) -> list[float]:
    count = min(6, max(1, round(size.width / 1.1)))
    return [size.width * ((i + 0.5) / count - 0.5) for i in range(count)]


def _reading_table(size: Size) -> Parts:
    """A long table on trestles; with the height to spare, a row of lamps along its middle."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    lit = h > 0.92
    top = 0.75 if lit else h
    deep = d - min(0.2, 0.4 * d)  # chairs stand in before them
    ends = [
        block((s * (w - 0.16) - 0.03, s * (w - 0.16) + 0.03), (-deep, deep), (0, top - 0.04))
        for s in (-1, 1)
    ]
    beam = block((-w + 0.16, w - 0.16), (-0.03, 0.03), (top - 0.18, top - 0.04))
    table = [slab((-w, w), (-d, d), (top - 0.04, top), 0.03), *ends, beam]
    if not lit:
        return parts(size, {OAK: table})
    stems, shades, light = [], [], []
    for x in _lamp_spots(size):
        stems.append(rod((x, 0, top), (x, 0, h - 0.06), 0.012, sides=6))
        shades.append(block((x - 0.2, x + 0.2), (-0.07, 0.07), (h - 0.05, h)))
        light.append(block((x - 0.18, x + 0.18), (-0.05, 0.05), (h - 0.06, h - 0.05)))
    book = [
        block((-0.6 * w, -0.6 * w + 0.3), (0.35 * d, 0.35 * d + 0.2), (top, top + 0.02)),
        block((0.3 * w, 0.3 * w + 0.22), (-0.6 * d, -0.6 * d + 0.16), (top, top + 0.03)),
    ]
    rail = block((-w + 0.1, w - 0.1), (-0.02, 0.02), (top, top + 0.06))
    return parts(size, {OAK: [*table, rail], BRASS: stems, SAGE: shades, GLOW: light, PAPER: book})


def _reading_chair(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat = min(0.46, 0.56 * h)
    legs = four_legs(w, d, (0, seat - 0.03), 0.02, 0.014, 0.0, 0.025, square=True)
    posts = [
        block(
            (s * (w - 0.05) - 0.015, s * (w - 0.05) + 0.015),
            (-d + 0.02, -d + 0.05),
            (seat - 0.05, h - 0.02),
        )
        for s in (-1, 1)
    ]
    rest = bent(w - 0.02, -d + 0.06, 0.03, 0.022, (h - 0.24, h), 4, lean=0.01)
    pad = make_bevelled_box(
        (-w + 0.015, w - 0.015), (-d + 0.04, d), (seat - 0.03, seat + 0.02), 0.018
    )
    return parts(size, {OAK_DARK: [*legs, *posts, rest], NAVY: [pad]})


def _carrel(size: Size) -> Parts:
    """A desk between screens on three sides, open to the front, with a light and a shelf."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    t, top = 0.025, min(0.74, 0.62 * h)
    inner = (-w + t, w - t)
    ledge = h - 0.12
    return parts(
        size,
        {
            OAK: [
                block((-w, -w + t), (-d, d), (0, h)),
                block((w - t, w), (-d, d), (0, h)),
                block(inner, (-d, -d + t), (0.25, h)),
            ],
            WHITE: [
                block(inner, (-d + t, d - 0.06), (top - 0.03, top)),
                block(inner, (-d + t, -d + 0.24), (ledge - 0.02, ledge)),
            ],
            FABRIC: [block(inner, (-d + t, -d + t + 0.015), (top, ledge - 0.02))],
            GLOW: [
                block((-0.5 * w, 0.5 * w), (-d + 0.14, -d + 0.2), (ledge - 0.035, ledge - 0.02))
            ],
            PAPER: [block((-0.3, 0.02), (-0.1 * d, -0.1 * d + 0.22), (top, top + 0.015))],
            ACCENT: [block((0.3 * w, 0.3 * w + 0.05), (-d + 0.05, -d + 0.2), (ledge, h - 0.01))],
            MUSTARD: [
                block((0.3 * w + 0.06, 0.3 * w + 0.1), (-d + 0.05, -d + 0.2), (ledge, h - 0.03))
            ],
        },
    )


def _lounge_seat(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    seat, arm = min(0.42, 0.55 * h), 0.16 * w
    high = seat + 0.55 * (h - seat)
    return parts(
        size,
        {
            MUSTARD: [
                cushion((-w, w), (-d, -d + 0.18), (0.1, h), 0.05, 1),
                cushion((-w, -w + 2 * arm), (-d + 0.1, d - 0.02), (0.1, high), 0.05, 1),
                cushion((w - 2 * arm, w), (-d + 0.1, d - 0.02), (0.1, high), 0.05, 1),
                cushion((-w + 2 * arm, w - 2 * arm), (-d + 0.16, d), (0.14, seat), 0.06, 1),
            ],
            BLACK: four_legs(w, d, (0, 0.12), 0.02, 0.02, 0.04, square=True),
        },
    )


def _terminal(size: Size) -> Parts:
    """A standing place to search: foot, pillar, sloping board, screen to the front."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    desk = min(1.02, 0.75 * h)
    board = rotate_mesh(
        block((-w, w), (-0.3 * d, d), (desk - 0.04, desk)), "x", -0.08, (0, 0.4 * d, desk)
    )
    keys = rotate_mesh(
        block((-0.6 * w, 0.6 * w), (0.25 * d, 0.7 * d), (desk, desk + 0.015)),
        "x",
        -0.08,
        (0, 0.4 * d, desk),
    )
    low = desk + 0.06
    return parts(
        size,
        {
            WHITE: [
                block((-0.4 * w, 0.4 * w), (-0.7 * d, -0.2 * d), (0.03, low + 0.1)),
                board,
                block((-0.9 * w, 0.9 * w), (-0.46 * d, -0.34 * d), (low, h)),
            ],
            BLACK: [block((-w, w), (-d, 0.8 * d), (0, 0.03)), keys],
            SCREEN: [block((-0.82 * w, 0.82 * w), (-0.34 * d, -0.32 * d), (low + 0.03, h - 0.03))],
            ACCENT: [block((-0.7 * w, 0.1 * w), (-0.32 * d, -0.315 * d), (h - 0.09, h - 0.06))],
            CHARCOAL: [block((-0.2 * w, 0.2 * w), (-0.34 * d, -0.25 * d), (low - 0.02, low))],
        },
    )


def _table_symbol(size: Size) -> Lines:
    w = size.width / 2
    lamps = _lamp_spots(size) if size.height > 0.92 else []
    marks = [box(x - 0.2, x + 0.2, -0.07, 0.07) for x in lamps]
    return rectangle(size, 0, 0.03), path((-w + 0.1, 0), (w - 0.1, 0)), *marks


def _chair_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    deep = 0.16 * size.depth
    return box(-0.9 * w, 0.9 * w, -d + 0.6 * deep, d, 0.04), crescent(w, -d, deep, 0.1 * size.depth)


def _carrel_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    t = 0.025
    screens = path(
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
    return (
        screens,
        path((-w + t, d - 0.06), (w - t, d - 0.06)),
        path((-w + t, -d + 0.24), (w - t, -d + 0.24)),
    )


def _lounge_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size, 0, 0.08), box(-0.68 * w, 0.68 * w, -d + 0.18, d - 0.01, 0.05)


def _terminal_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return (
        rectangle(size),
        path((-0.9 * w, -0.4 * d), (0.9 * w, -0.4 * d)),
        box(-0.6 * w, 0.6 * w, 0.2 * d, 0.7 * d),
    )


ASSETS = (
    Drawing("reading_table", _reading_table, _table_symbol),
    Drawing("reading_chair", _reading_chair, _chair_symbol),
    Drawing("carrel", _carrel, _carrel_symbol),
    Drawing("lounge_seat", _lounge_seat, _lounge_symbol),
    Drawing("catalogue_terminal", _terminal, _terminal_symbol),
)
