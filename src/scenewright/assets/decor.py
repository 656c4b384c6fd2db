"""Rugs, pictures, curtains, clocks and small things."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.assets.joinery import spread
from scenewright.assets.materials import (
    BLACK,
    FABRIC_LIGHT,
    LINEN,
    MUSTARD,
    NAVY,
    OAK,
    PAPER,
    SAGE_FABRIC,
    SHEER,
    TERRACOTTA,
    WHITE,
    WOOL,
)
from scenewright.assets.model import Parts, asset, parts
from scenewright.assets.objects import SPINES, Stuff, wobble
from scenewright.assets.symbols import Lines, closed, path, plain, rectangle
from scenewright.catalog import Material
from scenewright.geometry.mesh import Mesh, extrude, turned
from scenewright.geometry.solids import ball, block, disc, frame, pipe, rod, sheet, slab
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


def _rug_symbol(size: Size) -> Lines:
    return rectangle(size), rectangle(size, min(0.08, 0.1 * min(size[:2])))


def _curtain_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    count = max(6, round(size.width / 0.09))
    share = np.linspace(0, 1, 6 * count + 1)
    wave = np.column_stack([-w + share * 2 * w, 0.9 * d * np.sin(share * count * 2 * pi)])
    return (wave,)


def _books_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    if size.height <= 0.75 * size.depth:
        cover = [
            (-0.85 * w, -0.75 * d),
            (0.8 * w, -0.85 * d),
            (0.85 * w, 0.75 * d),
            (-0.8 * w, 0.85 * d),
        ]
        return rectangle(size), closed(cover)
    count = max(2, round(size.width / 0.035))
    return rectangle(size), *(path((a, -d), (a, d)) for a, _ in spread(-w, w, count)[1:])


ASSETS = (
    asset("rug", _rug, _rug_symbol),
    asset("picture", _picture, plain),
    asset("curtain", _curtain, _curtain_symbol),
    asset("wall_clock", _wall_clock, plain),
    asset("books", _books, _books_symbol),
)
