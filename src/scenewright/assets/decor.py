"""Rugs, plants, pictures, curtains and small things."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.assets.foliage import GOLDEN, grown, pot, rosette, tree
from scenewright.assets.joinery import spread
from scenewright.assets.materials import (
    BARK,
    BLACK,
    CERAMIC,
    CLAY,
    FABRIC_LIGHT,
    LEAF,
    LEAF_LIGHT,
    LINEN,
    MUSTARD,
    NAVY,
    OAK,
    PAPER,
    RATTAN,
    SAGE_FABRIC,
    SHEER,
    SOIL,
    TERRACOTTA,
    WHITE,
    WOOL,
)
from scenewright.assets.model import Parts, asset, parts
from scenewright.assets.objects import SPINES, Stuff, wobble
from scenewright.assets.symbols import Lines, closed, oval, path, plain, rectangle
from scenewright.catalog import Material
from scenewright.geometry.mesh import Mesh, extrude, turned
from scenewright.geometry.solids import ball, block, disc, frame, lathe, pipe, rod, sheet, slab
from scenewright.scene import Size


def _rug(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    edge = min(0.06, 0.1 * min(w, d))
    stripe = min(0.1, 0.12 * min(w, d))
    inner = edge + 2.2 * stripe
    lines = [
        frame((-w + k, w - k), (0.0, 0.01), (-d + k, d - k), 0.3 * stripe)
        for k in (edge + stripe, edge + 1.7 * stripe)
    ]
    flat = [Mesh(m.vertices[:, [0, 2, 1]] * (1, 1, 0.4 * h / 0.01) + (0, 0, 0.5 * h),
                 m.faces[:, ::-1]) for m in lines]  # fmt: skip
    diamonds = _diamonds(w - inner, d - inner, (0.5 * h, h))
    return parts(size, {
        FABRIC_LIGHT: [slab((-w, w), (-d, d), (0, 0.6 * h), 0.01)],
        WOOL: [block((-w + edge, w - edge), (-d + edge, d - edge), (0.3 * h, 0.8 * h))],
        TERRACOTTA: flat, SAGE_FABRIC: diamonds,
    })  # fmt: skip


def _diamonds(w: float, d: float, z: tuple[float, float]) -> list[Mesh]:
    """A few lozenges along the longer side."""
    count = max(1, round(max(w, d) / min(w, d) * 1.5))
    found = []
    for a, b in spread(-max(w, d), max(w, d), count):
        middle, long, short = (a + b) / 2, 0.4 * (b - a), 0.62 * min(w, d)
        ring = [(middle + long, 0), (middle, short), (middle - long, 0), (middle, -short)]
        if d > w:
            ring = [(-y, x) for x, y in ring]
        found.append(extrude(ring, *z))
    return found


def _plant(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    radius, high = 0.62 * min(w, d), 0.36 * h
    body, soil = pot(radius, high)
    reach = h - high
    count = 13 if h < 0.3 else 17
    leaves = rosette(count, reach, 0.34 * reach, 0.9 * high, droop=1.0)
    (leaves,) = grown(w, d, (0.85 * high, h), leaves)
    return parts(size, {
        CERAMIC: [body], SOIL: [soil], LEAF: leaves[::2], LEAF_LIGHT: leaves[1::2],
    })  # fmt: skip


def _potted_tree(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    radius, high = min(0.6 * min(w, d), 0.2), min(0.24 * h, 0.36)
    body, soil = pot(radius, high)
    wood, leaves = grown(w, d, (0.8 * high, h), *tree(0.8 * high, h, 1.2 * min(w, d), 48))
    return parts(size, {
        CLAY: [body], SOIL: [soil], BARK: wood, LEAF: [*leaves[::3], *leaves[1::3]],
        LEAF_LIGHT: leaves[2::3],
    })  # fmt: skip


def _palm(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    radius, high = min(0.55 * min(w, d), 0.19), min(0.24 * h, 0.32)
    body, soil = pot(radius, high)
    crown = rosette(19, h - high, 0.2 * (h - high), 0.9 * high, rise=(0.75, 1.5), droop=1.5)
    (crown,) = grown(w, d, (0.85 * high, h), crown)
    return parts(size, {
        RATTAN: [body], SOIL: [soil], LEAF: crown[::2], LEAF_LIGHT: crown[1::2],
    })  # fmt: skip


def _picture(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rim = min(0.025, 0.12 * min(w, h / 2))
    mat = min(0.07, 0.25 * min(w, h / 2)) + rim
    front = d - 0.3 * size.depth
    art = ((-w + mat, w - mat), (mat, h - mat))
    found: Stuff = {
        OAK: [frame((-w, w), (-d, d), (0, h), rim)],
        PAPER: [block((-w + rim, w - rim), (-d + 0.1 * d, front), (rim, h - rim))],
    }
    for material, mesh in _landscape(*art, (front - 0.0004, front + 0.1 * size.depth)):
        found.setdefault(material, []).append(mesh)
    return parts(size, found)


def _landscape(
    x: tuple[float, float], z: tuple[float, float], y: tuple[float, float]
) -> list[tuple[Material, Mesh]]:
    """Hills under a sun, each a little further to the front."""
    wide, tall, step = x[1] - x[0], z[1] - z[0], (y[1] - y[0]) / 4
    sky = block(x, (y[0], y[0] + step), z)
    sun = min(0.16 * wide, 0.18 * tall)
    ring = [(x[0] + 0.68 * wide + sun * cos(k * pi / 8), z[0] + 0.68 * tall + sun * sin(k * pi / 8))
            for k in range(16)]  # fmt: skip
    found = [(LINEN, sky), (MUSTARD, sheet(ring, (y[0], y[0] + 2 * step)))]
    hills = (
        (TERRACOTTA, 0.5, 0.16, 0.4, 2.5),
        (SAGE_FABRIC, 0.34, 0.1, 2.4, 3.0),
        (NAVY, 0.18, 0.06, 4.4, 3.6),
    )
    for k, (material, level, swing, phase, waves) in enumerate(hills):
        share = np.linspace(0, 1, 9)
        crest = [(x[0] + s * wide, z[0] + tall * (level + swing * sin(phase + waves * s)))
                 for s in share[::-1]]  # fmt: skip
        outline = [(x[0], z[0]), (x[1], z[0]), *crest]
        found.append((material, sheet(outline, (y[0], y[0] + (2.4 + 0.5 * k) * step))))
    return found


def _curtain(size: Size) -> Parts:
    """Two drawn-back lengths in folds on a rod."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    each = min(0.3 * size.width, 0.6)
    rail = h - 0.035
    lengths = [
        _folds((-w + 0.02, -w + 0.02 + each), d, rail),
        _folds((w - 0.02 - each, w - 0.02), d, rail),
    ]
    bar = [rod((-w + 0.015, 0, rail + 0.012), (w - 0.015, 0, rail + 0.012), 0.011, sides=8)]
    bar += [
        ball(0.02, min(0.02, d), 0.022, (s * (w - 0.02), 0, rail + 0.012), 8, 4) for s in (-1, 1)
    ]
    return parts(size, {SHEER: lengths, BLACK: bar})


def _folds(x: tuple[float, float], d: float, high: float) -> Mesh:
    waves = max(2, round((x[1] - x[0]) / 0.09))
    share = np.linspace(0, 1, 4 * waves + 1)
    thin = min(0.008, 0.2 * d)
    across = x[0] + share * (x[1] - x[0])
    swing = (d - thin) * np.sin(share * waves * 2 * pi)
    front = np.column_stack([across, swing + thin / 2])
    rear = np.column_stack([across, swing - thin / 2])
    return extrude(np.concatenate([rear, front[::-1]]), 0.0, high)


def _wall_clock(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height

    def facing(mesh: Mesh) -> Mesh:
        upright = turned(mesh, "x", -pi / 2)
        return Mesh(upright.vertices * (w, 1, h / 2) + (0, 0, h / 2), upright.faces)

    hands = [block((-0.03, 0.03), (-0.1, 0.5), (0.2 * d, 0.5 * d)),
             turned(block((-0.02, 0.02), (-0.1, 0.72), (0.3 * d, 0.6 * d)), "z", 2.1)]  # fmt: skip
    ticks = [turned(block((-0.02, 0.02), (0.74, 0.84), (0.0, 0.4 * d)), "z", k * pi / 6)
             for k in range(12)]  # fmt: skip
    return parts(size, {
        OAK: [facing(pipe(1, 0.9, (-d, d), sides=28))],
        WHITE: [facing(disc(0.92, (-0.8 * d, 0.2 * d), sides=28))],
        BLACK: [facing(m) for m in (*hands, *ticks)],
    })  # fmt: skip


def _books(size: Size) -> Parts:
    """A row of books; a stack if there is no height for a row."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    found: Stuff = {}
    if h > 0.75 * size.depth:
        count = max(2, round(size.width / 0.035))
        for k, (a, b) in enumerate(spread(-w, w, count)):
            tall, deep = h * (0.75 + 0.25 * wobble(k)), size.depth * (0.8 + 0.2 * wobble(k + 0.5))
            book = block((a + 0.001, b - 0.001), (-d, -d + deep), (0, h if k == 1 else tall))
            found.setdefault(SPINES[int(wobble(k + 0.75) * len(SPINES))], []).append(book)
        return parts(size, found)
    for k, level in enumerate(spread(0, h, max(2, round(h / 0.03)))):
        inset = 0.1 * wobble(k) * min(w, d) * (k > 0)
        cover = SPINES[int(wobble(k + 3) * len(SPINES))]
        book = block(
            (-w + inset, w - inset), (-d + inset, d - inset), (level[0], level[1] - 0.0005)
        )
        found.setdefault(cover, []).append(
            turned(book, "z", 0.0 if k == 0 else 0.1 * (wobble(k) - 0.5))
        )
    return parts(size, found)


def _vase(size: Size) -> Parts:
    """A bellied vase with a few twigs."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    tall, radius = 0.55 * h, 0.62 * min(w, d)
    rows = [
        (0.55, 0),
        (0.95, 0.3),
        (1, 0.45),
        (0.75, 0.75),
        (0.4, 0.92),
        (0.5, 1),
        (0.4, 1),
        (0.32, 0.9),
    ]
    body = lathe([(r * radius, z * tall) for r, z in rows], sides=14)
    twigs, leaves = [], []
    for k in range(5):
        angle, out = k * GOLDEN, 0.75 * min(w, d)
        tip = (out * cos(angle), out * sin(angle), h * (0.9 + 0.1 * wobble(k)))
        twigs.append(rod((0, 0, 0.85 * tall), tip, 0.003, 0.002, 4))
        leaves += [ball(0.16 * radius + 0.004, 0.16 * radius + 0.004, 0.26 * radius, (
            s * tip[0], s * tip[1], 0.85 * tall + s * (tip[2] - 0.85 * tall) - 0.02 * h), 6, 3)
            for s in (0.55, 0.78, 1.0)]  # fmt: skip
    return parts(size, {CLAY: [body], BARK: twigs, LEAF_LIGHT: leaves})


def _bowl(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height
    rows = [(0.45, 0), (0.85, 0.4), (1, 0.8), (0.94, 0.8), (0.78, 0.42), (0.4, 0.12)]
    body = lathe([(r, z * h) for r, z in rows], sides=20)
    fruit = 0.27 * min(w, d)
    spots = [(0.36 * w * cos(a), 0.36 * d * sin(a)) for a in (0.3, 2.4, 4.5)]
    high = min(fruit, 0.34 * h)
    fruits = [ball(fruit, fruit, high, (x, y, 0.5 * h), 8, 5) for x, y in spots]
    fruits.append(ball(fruit, fruit, high, (0.02, 0, h - high), 8, 5))
    return parts(size, {
        OAK: [Mesh(body.vertices * (w, d, 1), body.faces)], TERRACOTTA: fruits[:2],
        MUSTARD: fruits[2:],
    })  # fmt: skip


def _rug_symbol(size: Size) -> Lines:
    return rectangle(size), rectangle(size, min(0.08, 0.1 * min(size[:2])))


def rosette_symbol(size: Size) -> Lines:
    """Leaves around the middle of a circle."""
    w, d = size.width / 2, size.depth / 2
    angle = np.linspace(0, 2 * pi, 97)
    reach = 0.72 + 0.28 * np.abs(np.cos(4.5 * angle))
    outline = np.column_stack([w * reach * np.cos(angle), d * reach * np.sin(angle)])
    outline[-1] = outline[0]
    spokes = [
        path((0, 0), (0.75 * w * cos(a), 0.75 * d * sin(a))) for a in np.arange(9) * 2 * pi / 9
    ]
    return outline, *spokes, oval(0, 0, 0.16 * w, 0.16 * d)


def _curtain_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    count = max(6, round(size.width / 0.09))
    share = np.linspace(0, 1, 6 * count + 1)
    wave = np.column_stack([-w + share * 2 * w, 0.9 * d * np.sin(share * count * 2 * pi)])
    return (wave,)


def _vase_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return oval(0, 0, w, d), oval(0, 0, 0.45 * w, 0.45 * d)


def _books_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    if size.height <= 0.75 * size.depth:
        return rectangle(size), closed(
            [(-0.8 * w, -0.7 * d), (0.85 * w, -0.8 * d), (0.8 * w, 0.7 * d)]
        )
    count = max(2, round(size.width / 0.035))
    return rectangle(size), *(path((a, -d), (a, d)) for a, _ in spread(-w, w, count)[1:])


_TALL = (Size(0.25, 0.25, 0.5), Size(0.5, 0.5, 1.0), Size(1.0, 1.0, 1.2))

ASSETS = (
    asset("rug", _rug, _rug_symbol),
    asset("plant", _plant, rosette_symbol),
    asset("potted_tree", _potted_tree, rosette_symbol),
    asset("potted_tree", _palm, rosette_symbol, variant="low", name="Potted palm", sizes=_TALL),
    asset("picture", _picture, plain),
    asset("curtain", _curtain, _curtain_symbol),
    asset("wall_clock", _wall_clock, plain),
    asset("books", _books, _books_symbol),
    asset("vase", _vase, _vase_symbol),
    asset("bowl", _bowl, _vase_symbol),
)
