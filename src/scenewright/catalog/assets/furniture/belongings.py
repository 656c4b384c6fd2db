"""What people leave about: books, frames, candles, bottles, boxes, toys, stationery."""

from __future__ import annotations

from math import pi

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.tableware import in_colours, vessel_wall
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    BRASS,
    CARDBOARD,
    CERAMIC,
    CHARCOAL,
    CREAM,
    FABRIC_LIGHT,
    LINEN,
    MUSTARD,
    NAVY,
    OAK,
    OAK_DARK,
    PAPER,
    PINE,
    PLASTIC,
    RATTAN,
    RED,
    RUBBER,
    SAGE,
    SAGE_FABRIC,
    SCREEN,
    TERRACOTTA,
    VELVET,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.symbols import round_plain
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import rotate_mesh
from scenewright.geometry.solids import (
    block,
    cushion,
    disc,
    lathe,
    make_bevelled_box,
    pipe,
    rod,
    slab,
)


def _book(size: Size, cover: Material) -> Parts:
    """A book lying, its spine to the left."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    board = 0.12 * h
    boards = [block((-w, w), (-d, d), z) for z in ((0, board), (h - board, h))]
    spine = block((-w, -w + board), (-d, d), (board, h - board))
    pages = block((-w + board, 0.97 * w), (-0.97 * d, 0.97 * d), (board, h - board))
    return parts(size, {cover: [*boards, spine], PAPER: [pages]})


def _magazine(size: Size, cover: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    title = block((-0.8 * w, 0.5 * w), (0.55 * d, 0.85 * d), (0.8 * h, h))
    return parts(
        size,
        {
            PAPER: [block((-w, w), (-d, d), (0, 0.5 * h)), title],
            cover: [block((-w, w), (-d, d), (0.5 * h, 0.9 * h))],
        },
    )


def _frame(size: Size, wood: Material) -> Parts:
    """A photograph in a frame that leans on its strut."""
    w, h = size.width / 2, size.height
    lean = 0.22
    rim = block((-w, w), (-0.008, 0.008), (0, h))
    mount = block((-0.82 * w, 0.82 * w), (0.006, 0.0095), (0.12 * h, 0.88 * h))
    view = block((-0.6 * w, 0.6 * w), (0.009, 0.0115), (0.24 * h, 0.76 * h))
    strut = block((-0.02, 0.02), (-0.012, -0.007), (0.007 * h, 0.75 * h))
    strut = rotate_mesh(strut, "x", -0.3, (0, 0, 0.75 * h))
    turned = {
        m: rotate_mesh(p, "x", lean) for m, p in ((wood, rim), (PAPER, mount), (ACCENT, view))
    }
    return parts(
        size, {m: [p] for m, p in turned.items()} | {OAK_DARK: [rotate_mesh(strut, "x", lean)]}
    )


def _candle(size: Size, wax: Material) -> Parts:
    r, h = min(size.width, size.depth) / 2, size.height
    wick = rod((0, 0, 0.88 * h), (0, 0, h), 0.0015, sides=4)
    return parts(
        size,
        {
            BRASS: [disc(r, (0, 0.08 * h))],
            wax: [disc(0.72 * r, (0.08 * h, 0.9 * h))],
            BLACK: [wick],
        },
    )


def _pump(size: Size, body: Material) -> Parts:
    """A bottle with a pump: soap or shampoo."""
    r, h = min(size.width, size.depth) / 2, size.height
    bottle = lathe([(r, 0), (r, 0.62 * h), (0.4 * r, 0.72 * h)], sides=12)
    neck, head = (
        disc(0.3 * r, (0.7 * h, 0.93 * h), sides=8),
        block((-0.35 * r, 0.35 * r), (-0.35 * r, 0.98 * r), (0.92 * h, h)),
    )
    return parts(size, {body: [bottle], BLACK: [neck, head]})


def _tube(size: Size, body: Material) -> Parts:
    """A tube of cream standing on its cap."""
    r, h = min(size.width, size.depth) / 2, size.height
    squeezed = lathe([(0.9 * r, 0.18 * h), (r, 0.3 * h), (r, 0.9 * h), (0.2 * r, h)], sides=10)
    return parts(size, {WHITE: [disc(0.8 * r, (0, 0.18 * h), sides=10)], body: [squeezed]})


def _toothbrushes(size: Size) -> Parts:
    r, h = min(size.width, size.depth) / 2, size.height
    cup = vessel_wall(Size(1.6 * r, 1.6 * r, 0.52 * h), [(0.85, 0), (1, 1)], 0.004)
    made = {CERAMIC: [cup]}
    for k, colour in enumerate((ACCENT, RED)):
        s = 1 - 2 * k
        stem = rod((0, 0, 0.03), (s * 0.8 * r, 0.1 * r, 0.9 * h), 0.004, sides=6)
        head = block((s * 0.8 * r - 0.006, s * 0.8 * r + 0.006), (-0.1 * r, 0.4 * r), (0.86 * h, h))
        made[colour] = [stem, head]
    return parts(size, made)


def _paper_roll(size: Size) -> Parts:
    r = min(size.width, size.depth) / 2
    return parts(size, {PAPER: [pipe(r, 0.36 * r, (0, size.height))]})


def _box(size: Size, body: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    lid = slab((-w, w), (-d, d), (0.78 * h, h), 0.01)
    return parts(
        size, {body: [slab((-0.97 * w, 0.97 * w), (-0.97 * d, 0.97 * d), (0, 0.78 * h), 0.01), lid]}
    )


def _basket(size: Size, weave: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    walls = [slab((-w, w), (-d, d), (k * h / 5, (k + 0.9) * h / 5), 0.03) for k in range(5)]
    return parts(
        size,
        {
            weave: walls,
            LINEN: [cushion((-0.85 * w, 0.85 * w), (-0.85 * d, 0.85 * d), (0.9 * h, h), 0.04)],
        },
    )


def _remote(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    keys = [
        block((-0.5 * w, 0.5 * w), (y, y + 0.1 * d), (0.9 * h, h)) for y in (-0.5 * d, 0.0, 0.5 * d)
    ]
    return parts(
        size,
        {
            RUBBER: [make_bevelled_box((-w, w), (-d, d), (0, 0.92 * h), 0.003)],
            RED: keys[2:],
            PLASTIC: keys[:2],
        },
    )


def _phone(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(
        size,
        {
            BLACK: [slab((-w, w), (-d, d), (0, 0.9 * h), 0.008)],
            SCREEN: [block((-0.92 * w, 0.92 * w), (-0.95 * d, 0.95 * d), (0.9 * h, h))],
        },
    )


def _keyboard(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rows = [
        block((-0.95 * w, 0.95 * w), (y - 0.17 * d, y + 0.17 * d), (0.6 * h, h))
        for y in (-0.75 * d, -0.36 * d, 0.03 * d, 0.42 * d, 0.81 * d)
    ]
    return parts(size, {PLASTIC: [slab((-w, w), (-d, d), (0, 0.62 * h), 0.01)], WHITE: rows})


def _mouse(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(size, {PLASTIC: [cushion((-w, w), (-d, d), (0, h), 0.015, 2, 0.4)]})


def _pens(size: Size) -> Parts:
    r, h = min(size.width, size.depth) / 2, size.height
    made = {CHARCOAL: [vessel_wall(Size(1.5 * r, 1.5 * r, 0.6 * h), [(1, 0), (1, 1)], 0.003, 10)]}
    for k, colour in enumerate((MUSTARD, ACCENT, RED, OAK)):
        turn = 2 * pi * k / 4
        made[colour] = [
            rotate_mesh(
                rod((0, 0, 0.02), (0.8 * r, 0, h * (0.9 + 0.03 * k)), 0.0035, sides=6), "z", turn
            )
        ]
    return parts(size, made)


def _clock(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    case = make_bevelled_box((-w, w), (-d, 0.8 * d), (0, h), 0.012)
    return parts(
        size,
        {WHITE: [case], SCREEN: [block((-0.8 * w, 0.8 * w), (0.7 * d, d), (0.25 * h, 0.8 * h))]},
    )


def _toy_car(size: Size, paint: Material) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    body = make_bevelled_box((-0.85 * w, 0.85 * w), (-d, d), (0.2 * h, 0.6 * h), 0.008)
    cabin = make_bevelled_box((-0.7 * w, 0.7 * w), (-0.6 * d, 0.35 * d), (0.58 * h, h), 0.008)
    wheels = [
        rotate_mesh(disc(0.24 * h, (-0.12 * w, 0.12 * w), sides=10), "y", pi / 2, (0, 0, 0))
        for _ in range(4)
    ]
    spots = [(s * 0.88 * w, t * 0.6 * d, 0.24 * h) for s in (-1, 1) for t in (-1, 1)]
    turned = [type(m)(m.vertices + spot, m.faces) for m, spot in zip(wheels, spots, strict=True)]
    return parts(size, {paint: [body], WHITE: [cabin], RUBBER: turned})


def _blocks(size: Size) -> Parts:
    """Wooden bricks: three below, two above, one on top."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    made: Stuff = {}
    colours = (RED, MUSTARD, ACCENT, SAGE, PINE, OAK)
    spots = [(-0.66, 0), (0.0, 0), (0.66, 0), (-0.33, 1), (0.33, 1), (0.0, 2)]
    for colour, (x, level) in zip(colours, spots, strict=True):
        brick = make_bevelled_box(
            (x * w - 0.3 * w, x * w + 0.3 * w), (-d, d), (level * h / 3, (level + 1) * h / 3), 0.003
        )
        made.setdefault(colour, []).append(brick)
    return parts(size, made)


def _speaker(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    cone = [rotate_mesh(disc(r, (0, 0.02 * h), (0, 0)), "x", -pi / 2) for r in (0.6 * w, 0.4 * w)]
    spots = ((0, 0.9 * d, 0.32 * h), (0, 0.9 * d, 0.74 * h))
    cones = [type(m)(m.vertices + spot, m.faces) for m, spot in zip(cone, spots, strict=True)]
    return parts(
        size, {OAK_DARK: [make_bevelled_box((-w, w), (-d, 0.92 * d), (0, h), 0.004)], BLACK: cones}
    )


ASSETS = (
    *in_colours("book", _book, (TERRACOTTA, NAVY, SAGE_FABRIC, MUSTARD, LINEN, VELVET)),
    *in_colours("magazine", _magazine, (ACCENT, TERRACOTTA, CREAM)),
    *in_colours("photo_frame", _frame, (OAK, BLACK, BRASS)),
    *in_colours("candle", _candle, (CREAM, TERRACOTTA, MUSTARD), round_plain),
    *in_colours("pump_bottle", _pump, (WHITE, OAK_DARK, SAGE), round_plain),
    *in_colours("cream_tube", _tube, (ACCENT, TERRACOTTA, MUSTARD, CREAM), round_plain),
    Drawing("toothbrush_cup", _toothbrushes, round_plain),
    Drawing("paper_roll", _paper_roll, round_plain),
    *in_colours("storage_box", _box, (CARDBOARD, WHITE, SAGE, TERRACOTTA)),
    *in_colours("basket", _basket, (RATTAN, FABRIC_LIGHT)),
    Drawing("remote_control", _remote),
    Drawing("phone", _phone),
    Drawing("keyboard", _keyboard),
    Drawing("mouse", _mouse),
    Drawing("pen_pot", _pens, round_plain),
    Drawing("alarm_clock", _clock),
    *in_colours("toy_car", _toy_car, (RED, ACCENT, MUSTARD)),
    Drawing("toy_blocks", _blocks),
    Drawing("loudspeaker", _speaker),
)
