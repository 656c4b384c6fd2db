"""What every public hall has: desks, gates, barriers, partitions, signs, bins, lockers."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.furniture.corners import (
    Outline,
    corner_outline,
    cover,
    draw_border,
    turn_about,
)
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    ACCENT,
    BLACK,
    BRASS,
    CHARCOAL,
    CLEAR,
    GLASS,
    GREIGE,
    LEAF,
    MUSTARD,
    OAK,
    PAPER,
    PLASTER,
    RED,
    RUBBER,
    SCREEN,
    STEEL,
    STONE,
    TERRACOTTA,
    VELVET,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.catalog.assets.public.wares import levels_of, merge_by_material, stock
from scenewright.catalog.assets.symbols import Lines, arc, box, oval, path, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, extrude
from scenewright.geometry.solids import block, disc, lathe, rod, slab, tube


def _counter(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    panels = spread(-w + 0.02, w - 0.02, min(12, max(1, round(size.width / 0.6))))
    return parts(
        size,
        {
            OAK: [
                block((a + 0.004, b - 0.004), (d - 0.06, d - 0.04), (0.1, h - 0.05))
                for a, b in panels
            ],
            WHITE: [block((-w + 0.01, w - 0.01), (-d + 0.02, d - 0.06), (0.1, h - 0.04))],
            STONE: [block((-w, w), (-d, d), (h - 0.04, h))],
            BLACK: [block((-w + 0.03, w - 0.03), (-d + 0.05, d - 0.1), (0, 0.1))],
        },
    )


def _info_desk(size: Size) -> Parts:
    """A high ledge to the visitors' side, the desk of the staff behind it, two monitors."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    desk, edge = 0.68 * h, d - 0.35 * min(2 * d, 0.9)
    shown, stems = [], []
    for x in (-0.45 * w, 0.45 * w):
        shown.append(
            block(
                (x - 0.24, x + 0.24), (-0.12 * d - 0.02, -0.12 * d + 0.02), (desk + 0.08, 0.96 * h)
            )
        )
        stems.append(
            block((x - 0.08, x + 0.08), (-0.12 * d - 0.07, -0.12 * d + 0.07), (desk, desk + 0.08))
        )
    return parts(
        size,
        {
            ACCENT: [block((-w + 0.02, w - 0.02), (edge + 0.04, d - 0.04), (0.1, h - 0.04))],
            WHITE: [
                block((-w, w), (edge, d), (h - 0.04, h)),
                block((-w + 0.02, w - 0.02), (-d, edge + 0.04), (desk - 0.04, desk)),
                *(
                    block(
                        (s * (w - 0.035) - 0.015, s * (w - 0.035) + 0.015),
                        (-d + 0.04, edge + 0.04),
                        (0, desk - 0.04),
                    )
                    for s in (-1, 1)
                ),
            ],
            BLACK: [block((-w + 0.05, w - 0.05), (edge + 0.06, d - 0.08), (0, 0.1)), *stems],
            SCREEN: shown,
            PAPER: [
                block((-0.06 * w, 0.06 * w), (d - 0.04, d - 0.036), (0.5 * h, 0.8 * h)),
                block((-0.1 * w, 0.04 * w), (-0.6 * d, -0.6 * d + 0.2), (desk, desk + 0.02)),
            ],
        },
    )


def _corner_counter_outline(size: Size) -> Outline:
    """The leg to the visitors, the wing behind it on the right; staff stand in the nook."""
    deep = min(0.75, 0.42 * size.depth, 0.42 * size.width)
    return turn_about(corner_outline(size, deep, deep))


def _corner_counter(size: Size) -> Parts:
    """Panels to both sides that visitors see; below the ledge a worktop round the nook."""
    h = size.height
    outline = _corner_counter_outline(size)
    (w, d), (edge, back) = outline[0], outline[4]
    inner = outline[2][1]
    shown, work = min(0.3, 0.5 * (d - inner)), 0.68 * h
    at, desk = d - shown - 0.26, w - shown
    ledge = [(w, d), (-w, d), (-w, d - shown), (w - shown, d - shown), (w - shown, back), (w, back)]
    front = [
        block((a + 0.004, b - 0.004), (d - 0.05, d - 0.03), (0.1, h - 0.05))
        for a, b in spread(-w + 0.02, w - 0.05, max(1, round(size.width / 0.6)))
    ]
    side = [
        block((w - 0.05, w - 0.03), (a + 0.004, b - 0.004), (0.1, h - 0.05))
        for a, b in spread(back + 0.02, d - 0.05, max(1, round(size.depth / 0.6)))
    ]
    return parts(
        size,
        {
            OAK: [*front, *side],
            STONE: [extrude(np.array(ledge), h - 0.04, h)],
            WHITE: [
                extrude(np.array(ledge) * [0.97, 0.97], 0.1, h - 0.04),
                block((-w + 0.02, w - shown), (inner, d - shown), (work - 0.04, work)),
                block((edge, w - shown), (back + 0.02, inner), (work - 0.04, work)),
                block((-w + 0.02, -w + 0.05), (inner + 0.02, d - shown), (0, work - 0.04)),
                block((edge + 0.02, w - shown), (back + 0.02, back + 0.05), (0, work - 0.04)),
            ],
            BLACK: [extrude(np.array(ledge) * [0.94, 0.94], 0, 0.1)],
            SCREEN: [
                block((x - 0.24, x + 0.24), (at - 0.04, at), (work + 0.06, 0.97 * h))
                for x in (-0.55 * w, 0.1 * w)
            ],
            PAPER: [
                block((desk - 0.3, desk - 0.1), (back + 0.3, back + 0.58), (work, work + 0.02))
            ],
        },
    )


def _ticket_gate(size: Size) -> Parts:
    """A lane between two housings with glass flaps; people pass from the front to the back."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    body = min(0.2, 0.25 * w + 0.05)
    sides = [(-w, -w + body), (w - body, w)]
    return parts(
        size,
        {
            STEEL: [slab(x, (-d, d), (0, h - 0.03), 0.05, 2) for x in sides],
            BLACK: [slab(x, (-d, d), (h - 0.03, h), 0.05, 2) for x in sides],
            GLASS: [
                block((-w + body, -0.02), (-0.01, 0.01), (0.25, h - 0.08)),
                block((0.02, w - body), (-0.01, 0.01), (0.25, h - 0.08)),
            ],
            LEAF: [
                block((x[0] + 0.05, x[1] - 0.05), (y - 0.05, y + 0.05), (h - 0.001, h + 0.004))
                for x, y in ((sides[0], -d + 0.16), (sides[1], d - 0.16))
            ],
        },
    )


def _rope_barrier(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    x, foot = w - min(d, 0.4 * w), min(d, 0.4 * w)
    posts, share = [], np.linspace(-1, 1, 9)
    for s in (-1, 1):
        base = lathe([(1.0, 0), (1.0, 0.015), (0.25, 0.04)], sides=12)
        posts.append(Mesh(base.vertices * (foot, d, 1) + (s * x, 0, 0), base.faces))
        posts.append(rod((s * x, 0, 0.03), (s * x, 0, h - 0.04), 0.02, sides=8))
        posts.append(disc(0.035, (h - 0.05, h), (s * x, 0), 8))
    sag = np.column_stack([share * x, np.zeros(9), h - 0.12 - 0.22 * min(1.0, x) * (1 - share**2)])
    return parts(size, {BRASS: posts, VELVET: [tube(sag, 0.018, 5)]})


def _partition(size: Size) -> Parts:
    """A plain wall segment, a slim dark line at its foot."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    skin = min(0.003, 0.1 * d)
    return parts(
        size,
        {
            PLASTER: [block((-w + skin, w - skin), (-d + skin, d - skin), (0.06, h))],
            CHARCOAL: [block((-w, w), (-d, d), (0, 0.06))],
        },
    )


def _litter_bin(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    return parts(
        size,
        {
            CHARCOAL: [
                slab((-w + 0.01, w - 0.01), (-d + 0.01, d - 0.01), (0.03, 0.72 * h), 0.04),
                block((-w + 0.06, w - 0.06), (-d + 0.06, d - 0.06), (0.72 * h, 0.9 * h)),
            ],
            STEEL: [
                slab((-w, w), (-d, d), (0.9 * h, h), 0.04),
                *(
                    block(
                        (s * (w - 0.05) - 0.02, s * (w - 0.05) + 0.02),
                        (-d + 0.03, d - 0.03),
                        (0.72 * h, 0.9 * h),
                    )
                    for s in (-1, 1)
                ),
            ],
            RUBBER: [block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.03), (0, 0.03))],
        },
    )


def _sign_totem(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    board, ink = 0.4 * d, 0.4 * d + 0.002
    rows = spread(0.42 * h, 0.78 * h, 4)
    marks = (MUSTARD, TERRACOTTA, LEAF, WHITE)
    found: Stuff = {
        BLACK: [block((-w, w), (-d, d), (0, 0.03))],
        ACCENT: [block((-0.9 * w, 0.9 * w), (-board, board), (0.03, h))],
        WHITE: [block((-0.25 * w, 0.25 * w), (-ink, ink), (0.84 * h, 0.96 * h))],
        PAPER: [
            block(
                (-0.35 * w, 0.7 * w - 0.3 * w * wobble(k)),
                (-ink, ink),
                (a + 0.25 * (b - a), b - 0.25 * (b - a)),
            )
            for k, (a, b) in enumerate(rows)
        ],
    }
    for mark, (a, b) in zip(marks, rows, strict=True):
        found.setdefault(mark, []).append(
            block((-0.75 * w, -0.5 * w), (-ink, ink), (a + 0.2 * (b - a), b - 0.2 * (b - a)))
        )
    return parts(size, found)


def _doors(size: Size) -> tuple[int, int]:
    """Columns and rows of locker doors."""
    return min(12, max(1, round(size.width / 0.3))), max(1, round(size.height / 0.6))


def _lockers(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    columns, rows = _doors(size)
    found: Stuff = {
        GREIGE: [block((-w, w), (-d, d - 0.02), (0.08, h))],
        BLACK: [block((-w + 0.02, w - 0.02), (-d + 0.02, d - 0.05), (0, 0.08))],
        ACCENT: [],
        WHITE: [],
    }
    for i, (a, b) in enumerate(spread(-w, w, columns)):
        for k, (low, high) in enumerate(spread(0.08, h, rows)):
            door = block((a + 0.005, b - 0.005), (d - 0.02, d - 0.004), (low + 0.005, high - 0.005))
            found[ACCENT if wobble(7 * i + k) < 0.25 else WHITE].append(door)
            middle = (low + high) / 2
            found[BLACK].append(
                block((b - 0.05, b - 0.03), (d - 0.004, d), (middle - 0.03, middle + 0.03))
            )
    return parts(size, found)


def _vending_machine(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    face, pane = d - 0.04, (-w + 0.06, 0.4 * w)
    low, high = 0.32 * h, 0.94 * h
    tiers = levels_of(low + 0.03, high, 5)
    shell = [
        block((-w, w), (-d, face - 0.25), (0.06, h)),
        block((-w, pane[0]), (face - 0.25, d), (0.06, h)),
        block((pane[1], w), (face - 0.25, d), (0.06, h)),
        block(pane, (face - 0.25, d), (high, h)),
        block(pane, (face - 0.25, d), (0.06, low)),
    ]
    found: Stuff = {
        RED: shell,
        BLACK: [
            block((-w + 0.03, w - 0.03), (-d + 0.03, d - 0.05), (0, 0.06)),
            block((pane[0] + 0.05, pane[1] - 0.05), (d, d + 0.004), (0.12 * h, 0.22 * h)),
        ],
        SCREEN: [block((0.5 * w, 0.88 * w), (d, d + 0.004), (0.6 * h, 0.75 * h))],
        STEEL: [block(pane, (face - 0.25, face - 0.03), (a - 0.012, a)) for a, _ in tiers],
        CLEAR: [block(pane, (face - 0.01, face), (low, high))],
    }
    packs = stock("drinks", (pane[0] + 0.02, pane[1] - 0.02), (face - 0.2, face - 0.05), tiers, 3)
    return parts(size, merge_by_material(found, packs))


def _ledge_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    line = d - min(0.1, 0.25 * size.depth)
    return rectangle(size), path((-w, line), (w, line))


def _info_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    edge = d - 0.35 * min(2 * d, 0.9)
    spots = [
        box(x - 0.24, x + 0.24, -0.12 * d - 0.03, -0.12 * d + 0.03) for x in (-0.45 * w, 0.45 * w)
    ]
    return rectangle(size), path((-w, edge), (w, edge)), *spots


def _gate_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    body = min(0.2, 0.25 * w + 0.05)
    return (
        box(-w, -w + body, -d, d, 0.05),
        box(w - body, w, -d, d, 0.05),
        path((-w + body, 0), (-0.05, 0)),
        path((0.05, 0), (w - body, 0)),
    )


def _rope_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    foot = min(d, 0.4 * w)
    x = w - foot
    return oval(-x, 0, foot, d), oval(x, 0, foot, d), path((-x, 0), (x, 0))


def _draw_hatching(size: Size) -> Lines:
    """Cut wall: the outline and strokes across at 45 degrees, at most 200."""
    w, d = size.width / 2, size.depth / 2
    step = max(0.12, size.width / 200)
    starts = np.arange(-w - 2 * d + step / 2, w, step)
    strokes = [
        path((max(x, -w), -d + max(-w - x, 0.0)), (min(x + 2 * d, w), d - max(x + 2 * d - w, 0.0)))
        for x in starts
        if min(x + 2 * d, w) - max(x, -w) > 0.2 * d
    ]
    return rectangle(size), *strokes


def _bin_symbol(size: Size) -> Lines:
    return rectangle(size, 0, 0.04), rectangle(size, 0.05, 0.02)


def _corner_counter_symbol(size: Size) -> Lines:
    outline = _corner_counter_outline(size)
    (w, d), (_, back), inner = outline[0], outline[4], outline[2][1]
    shown = min(0.3, 0.5 * (d - inner))
    edge = path((-w, d - shown), (w - shown, d - shown), (w - shown, back))
    return draw_border(outline), edge


def _totem_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), box(-0.9 * w, 0.9 * w, -0.4 * d, 0.4 * d)


def _lockers_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    columns, _ = _doors(size)
    return (
        rectangle(size),
        path((-w, d - 0.03), (w, d - 0.03)),
        *(path((a, -d), (a, d)) for a, _ in spread(-w, w, columns)[1:]),
    )


def _machine_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size), path((-w, -d), (w, d)), arc(0, d - 0.04, 0.8 * w, 0.02, 0, 3.14159)


ASSETS = (
    Drawing("counter", _counter, _ledge_symbol),
    Drawing("info_desk", _info_desk, _info_symbol),
    Drawing(
        "corner_counter",
        _corner_counter,
        _corner_counter_symbol,
        footprint=cover(_corner_counter_outline),
    ),
    Drawing("ticket_gate", _ticket_gate, _gate_symbol),
    Drawing("rope_barrier", _rope_barrier, _rope_symbol),
    Drawing("partition", _partition, _draw_hatching),
    Drawing("litter_bin", _litter_bin, _bin_symbol),
    Drawing("sign_totem", _sign_totem, _totem_symbol),
    Drawing("lockers", _lockers, _lockers_symbol),
    Drawing("vending_machine", _vending_machine, _machine_symbol),
)
