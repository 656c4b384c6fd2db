"""Exhibition halls: showcases, plinths, wall cases, panels, islands, touch tables."""

from __future__ import annotations

from functools import partial

from scenewright.catalog.assets.drawing import Drawing, letter_models
from scenewright.catalog.assets.exhibits.treasures import show, show_row
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    BOARD,
    CLEAR,
    GLOW,
    GREIGE,
    LINEN,
    MUSTARD,
    PAINTINGS,
    PAPER,
    SCREEN,
    SLATE,
    TERRACOTTA,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import merge_by_material
from scenewright.catalog.assets.symbols import Lines, oval, path, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, translate_mesh
from scenewright.geometry.solids import Interval, block, frame, make_bevelled_box, slab


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


def _showcase(size: Size, start: int = 0) -> Parts:
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
    inside = show_row(
        SMALL[start % 3],
        (-w + 0.06, w - 0.06),
        (-d + 0.06, d - 0.06),
        (deck + 0.02, h - 0.02),
        start,
        4,
    )
    return parts(size, merge_by_material(found, inside))


def _tall_showcase(size: Size, start: int = 0) -> Parts:
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
    low = show_row(SMALL[(start + 1) % 3], x, y, (deck + 0.02, middle - 0.05), start, 3)
    high = show_row(SMALL[start % 3], x, y, (middle, top - 0.15), start + 2, 2)
    return parts(size, merge_by_material(found, low, high))


SMALL = (
    ("krater", "tablet", "mask", "jug", "ammonite"),
    ("finds", "skull", "bottle", "crystals", "ship"),
    ("helmet", "amphora", "finds", "pebbles", "torso"),
)
"""What stands in cases beside one another."""
ON_PLINTHS = (
    "bust",
    "amphora",
    "ring",
    "torso",
    "column",
    "ammonite",
    "helmet",
    "pebbles",
    "mask",
    "krater",
    "ship",
    "capital",
)
FRONTAL = ("bust", "mask", "torso", "helmet", "ship", "ammonite")
"""What is seen from its front."""


def _pedestal(size: Size, top: float) -> Stuff:
    w, d = size.width / 2, size.depth / 2
    return {
        WHITE: [block((-w, w), (-d, d), (0.03, top))],
        BLACK: [block((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.02), (0, 0.03))],
    }


def _plinth(size: Size, name: str) -> Parts:
    """A treasure on a pedestal as high as leaves it its own shape."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.62 * h, 1.05)
    turn = 0.0 if name in FRONTAL else 0.5
    shown = show(name, (-0.9 * w, 0.9 * w), (-0.9 * d, 0.9 * d), (0.0, h - top), turn)
    tall = max(float(p.vertices[:, 2].max()) for meshes in shown.values() for p in meshes)
    raised = {k: [translate_mesh(p, 0.0, 0.0, h - tall) for p in v] for k, v in shown.items()}
    return parts(size, merge_by_material(_pedestal(size, h - tall), raised))


def _panel(size: Size, picture: Material = BOARD) -> Parts:
    """A board printed on both sides, on a bar or, where there is room, on crosswise feet."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    board, low = min(0.7 * d, 0.025), 0.16
    sides = (-1, 1)
    feet = (
        [block((-w, w), (-d, d), (0, 0.03))]
        if d < 0.1
        else [
            block((s * (w - 0.06) - 0.04, s * (w - 0.06) + 0.04), (-d, d), (0, 0.025))
            for s in sides
        ]
    )
    posts = [
        block((s * (w - 0.02) - 0.02, s * (w - 0.02) + 0.02), (-board, board), (0.02, h))
        for s in sides
    ]
    inner, ink = (-w + 0.04, w - 0.04), (-board - 0.001, board + 0.001)
    count = max(1, round(size.width / 0.9))
    sheets = [
        block((a + 0.04, b - 0.04), ink, (low + 0.1 + 0.15 * (h - low) * (k % 2 == 1), h - 0.28))
        for k, (a, b) in enumerate(spread(*inner, count))
    ]
    found: Stuff = {
        BLACK: [*feet, *posts],
        PAPER: [block(inner, (-board + 0.004, board - 0.004), (low, h - 0.01))],
        ACCENT: [block(inner, (-board, board), (h - 0.2, h - 0.01))],
    }
    for k, sheet in enumerate(sheets):
        found.setdefault(picture if k == 0 else BOARD, []).append(sheet)
    return parts(size, found)


def _wall_exhibit(size: Size, start: int = 0) -> Parts:
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
    below = show_row(SMALL[start % 3], inner, y, (z[0], middle - 0.05), start, 3)
    above = show_row(SMALL[(start + 1) % 3], inner, y, (middle, high - 0.1), start + 3, 2)
    return parts(size, merge_by_material(found, below, above))


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
ASSETS = (
    *letter_models("showcase", _case_symbol, (partial(_showcase, start=k) for k in range(6))),
    *letter_models(
        "showcase",
        _case_symbol,
        (partial(_tall_showcase, start=k) for k in range(6)),
        "showcase_tall",
        "Tall showcase",
        _TALL,
    ),
    *(
        Drawing(
            "plinth",
            partial(_plinth, name=name),
            _plinth_symbol,
            f"plinth_{name}" if k else "",
            f"Plinth, {name}",
        )
        for k, name in enumerate(ON_PLINTHS)
    ),
    *letter_models(
        "exhibit_panel",
        _panel_symbol,
        (partial(_panel, picture=one) for one in (BOARD, *PAINTINGS[:4])),
    ),
    *letter_models(
        "wall_exhibit", _wall_case_symbol, (partial(_wall_exhibit, start=k) for k in range(5))
    ),
    Drawing("interactive_table", _interactive_table, _touch_symbol),
)
