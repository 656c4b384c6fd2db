"""Pictures, clocks and books."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    LEAF,
    LINEN,
    MUSTARD,
    NAVY,
    OAK,
    PAPER,
    SAGE_FABRIC,
    TERRACOTTA,
    WHITE,
)
from scenewright.catalog.assets.model import Parts, parts, pick
from scenewright.catalog.assets.objects import SPINES, Stuff, wobble
from scenewright.catalog.assets.symbols import Lines, close_line, path, plain, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh
from scenewright.geometry.solids import Interval, block, disc, frame, pipe, sheet


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
    drawn = pick(size, (_landscape, _circles, _leaves))
    for material, mesh in drawn(*art, (front - 0.0004, front + 0.1 * size.depth)):
        found.setdefault(material, []).append(mesh)
    return parts(size, found)


def _landscape(x: Interval, z: Interval, y: Interval) -> list[tuple[Material, Mesh]]:
    """Hills under a sun, each a little further to the front."""
    wide, tall, step = x[1] - x[0], z[1] - z[0], (y[1] - y[0]) / 4
    sky = block(x, (y[0], y[0] + step), z)
    sun = min(0.16 * wide, 0.18 * tall)
    ring = [
        (x[0] + 0.68 * wide + sun * cos(k * pi / 8), z[0] + 0.68 * tall + sun * sin(k * pi / 8))
        for k in range(16)
    ]
    found = [(LINEN, sky), (MUSTARD, sheet(ring, (y[0], y[0] + 2 * step)))]
    hills = (
        (TERRACOTTA, 0.5, 0.16, 0.4, 2.5),
        (SAGE_FABRIC, 0.34, 0.1, 2.4, 3.0),
        (NAVY, 0.18, 0.06, 4.4, 3.6),
    )
    for k, (material, level, swing, phase, waves) in enumerate(hills):
        share = np.linspace(0, 1, 9)
        crest = [
            (x[0] + s * wide, z[0] + tall * (level + swing * sin(phase + waves * s)))
            for s in share[::-1]
        ]
        outline = [(x[0], z[0]), (x[1], z[0]), *crest]
        found.append((material, sheet(outline, (y[0], y[0] + (2.4 + 0.5 * k) * step))))
    return found


def _circles(x: Interval, z: Interval, y: Interval) -> list[tuple[Material, Mesh]]:
    """Overlapping discs and half discs on a light ground."""
    wide, tall, step = x[1] - x[0], z[1] - z[0], (y[1] - y[0]) / 4
    found = [(LINEN, block(x, (y[0], y[0] + step), z))]
    spots = (
        (SAGE_FABRIC, 0.32, 0.62, 0.34),
        (TERRACOTTA, 0.62, 0.45, 0.42),
        (NAVY, 0.42, 0.28, 0.25),
    )
    for k, (material, px, pz, share) in enumerate(spots):
        radius = share * min(wide, tall)
        middle = (x[0] + px * wide, z[0] + pz * tall)
        angle = np.arange(20) * 2 * pi / 20
        ring = np.column_stack([np.cos(angle), np.sin(angle)]) * radius + middle
        found.append((material, sheet(ring, (y[0], y[0] + (2 + 0.6 * k) * step))))
    return found


def _leaves(x: Interval, z: Interval, y: Interval) -> list[tuple[Material, Mesh]]:
    """A branch with pairs of leaves on a light ground."""
    wide, tall, step = x[1] - x[0], z[1] - z[0], (y[1] - y[0]) / 4
    middle, thin = x[0] + wide / 2, 0.012 * wide
    found = [(LINEN, block(x, (y[0], y[0] + step), z))]
    stem = block(
        (middle - thin, middle + thin),
        (y[0], y[0] + 2 * step),
        (z[0] + 0.08 * tall, z[0] + 0.8 * tall),
    )
    found.append((LEAF, stem))
    share = np.linspace(0, 1, 6)
    bow = 0.17 * np.sin(share * pi)
    blade = np.concatenate([np.column_stack([share, -bow]), np.column_stack([share, bow])[-2:0:-1]])
    for k in range(7):
        angle = pi / 2 if k == 6 else (0.6 if k % 2 == 0 else pi - 0.6)
        long = (0.46 - 0.05 * (k // 2)) * min(wide, tall)
        turn = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
        root = (middle, z[0] + tall * (0.16 + 0.18 * (k // 2)))
        green = SAGE_FABRIC if k % 3 else LEAF
        found.append((green, sheet(blade * long @ turn + root, (y[0], y[0] + 2.6 * step))))
    return found


def _wall_clock(size: Size) -> Parts:
    w, d, h = size.width / 2, size.depth / 2, size.height

    def facing(mesh: Mesh) -> Mesh:
        upright = rotate_mesh(mesh, "x", -pi / 2)
        return Mesh(upright.vertices * (w, 1, h / 2) + (0, 0, h / 2), upright.faces)

    hands = [
        block((-0.03, 0.03), (-0.1, 0.5), (0.2 * d, 0.5 * d)),
        rotate_mesh(block((-0.02, 0.02), (-0.1, 0.72), (0.3 * d, 0.6 * d)), "z", 2.1),
    ]
    ticks = [
        rotate_mesh(block((-0.02, 0.02), (0.74, 0.84), (0.0, 0.4 * d)), "z", k * pi / 6)
        for k in range(12)
    ]
    return parts(
        size,
        {
            OAK: [facing(pipe(1, 0.9, (-d, d), sides=28))],
            WHITE: [facing(disc(0.92, (-0.8 * d, 0.2 * d), sides=28))],
            BLACK: [facing(m) for m in (*hands, *ticks)],
        },
    )


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
            rotate_mesh(book, "z", 0.0 if k == 0 else 0.1 * (wobble(k) - 0.5))
        )
    return parts(size, found)


def _books_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    if size.height <= 0.75 * size.depth:
        cover = [
            (-0.85 * w, -0.75 * d),
            (0.8 * w, -0.85 * d),
            (0.85 * w, 0.75 * d),
            (-0.8 * w, 0.85 * d),
        ]
        return rectangle(size), close_line(cover)
    count = max(2, round(size.width / 0.035))
    return rectangle(size), *(path((a, -d), (a, d)) for a, _ in spread(-w, w, count)[1:])


ASSETS = (
    Drawing("picture", _picture, plain),
    Drawing("wall_clock", _wall_clock, plain),
    Drawing("books", _books, _books_symbol),
)
