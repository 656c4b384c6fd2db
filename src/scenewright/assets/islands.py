"""Islands of exhibition halls: a low podium and one large thing on it."""

from __future__ import annotations

from math import pi

import numpy as np

from scenewright.assets.materials import BLACK, BONE, CONCRETE, PAPER, ROCK, STEEL, STONE
from scenewright.assets.model import Parts, asset, parts
from scenewright.assets.objects import Stuff, wobble
from scenewright.assets.symbols import Lines, box, closed, rectangle
from scenewright.assets.wares import gathered
from scenewright.geometry.mesh import Mesh, moved, turned
from scenewright.geometry.solids import ball, block, rod, slab, tube
from scenewright.scene import Size


def _podium(size: Size, top: float) -> Stuff:
    w, d = size.width / 2, size.depth / 2
    label = block((-0.2, 0.2), (-0.12, 0.12), (0, 0.02))
    label = moved(turned(label, "x", -0.5), 0.55 * w, d - 0.2, top + 0.09)
    return {
        CONCRETE: [block((-w, w), (-d, d), (0.06, top))],
        BLACK: [block((-w + 0.06, w - 0.06), (-d + 0.06, d - 0.06), (0, 0.06))],
        PAPER: [label],
    }


def _rock(rx: float, ry: float, rz: float, at: tuple[float, float, float], seed: int) -> Mesh:
    """An uneven lump."""
    lump = ball(1.0, 1.0, 1.0, (0, 0, 0), 10, 6)
    uneven = np.array([0.78 + 0.22 * wobble(seed + k) for k in range(len(lump.vertices))])
    return Mesh(lump.vertices * uneven[:, None] * (rx, ry, rz) + at, lump.faces)


def _island(size: Size) -> Parts:
    """A boulder with two stones beside it."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.3, 0.25 * h)
    half = (h - top) / 2
    lumps = [
        _rock(0.62 * w, 0.62 * d, half, (-0.1 * w, -0.08 * d, top + 0.85 * half), 3),
        _rock(0.2 * w, 0.2 * d, 0.4 * half, (0.62 * w, -0.3 * d, top + 0.2 * half), 40),
        _rock(0.13 * w, 0.16 * d, 0.25 * half, (0.1 * w, 0.72 * d, top + 0.1 * half), 80),
    ]
    lumps[0].vertices[:, 2] += h - lumps[0].vertices[:, 2].max()
    base = slab((-0.8 * w, 0.8 * w), (-0.8 * d, 0.8 * d), (top, top + 0.02), 0.3)
    return parts(size, gathered(_podium(size, top), {ROCK: lumps, STONE: [base]}))


def _island_skeleton(size: Size) -> Parts:
    """The bones of a large animal: an arched spine, ribs, four legs, a skull to the right."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.3, 0.2 * h)
    tall, thick = h - top, 0.018 * (h - top) + 0.02
    share = np.linspace(-0.92, 0.72, 13)
    rise = 0.72 * np.cos(0.95 * share) ** 2 + 0.2 * np.clip(share - 0.35, 0, 1) ** 2 * 4
    spine = np.column_stack([share * w, np.zeros(13), top + tall * rise])
    bones = [tube(spine, 1.4 * thick, 5)]
    for k in range(4, 10):
        x, _, z = spine[k]
        deep, reach = 0.45 * tall * (1 - 0.06 * abs(k - 7)), min(0.5 * d, 0.3 * tall)
        for s in (-1, 1):
            bones.append(
                tube(
                    [
                        (x, 0, z),
                        (x + 0.02, s * reach, z - 0.3 * deep),
                        (x + 0.04, s * 0.9 * reach, z - 0.75 * deep),
                        (x + 0.06, s * 0.35 * reach, z - deep),
                    ],
                    0.6 * thick,
                    4,
                )
            )
    for k, s in ((4, -1), (4, 1), (9, -1), (9, 1)):
        x, _, z = spine[k]
        out = s * min(0.55 * d, 0.32 * tall)
        bones.append(rod((x, 0, z - 0.05), (x - 0.03 * w, out, top + 0.45 * (z - top)), thick))
        bones.append(
            rod((x - 0.03 * w, out, top + 0.47 * (z - top)), (x, out, top), thick, 0.8 * thick)
        )
    x, _, z = spine[-1]
    bones.append(
        ball(
            0.14 * w,
            min(0.25 * d, 0.1 * tall),
            0.07 * tall,
            (x + 0.1 * w, 0, h - 0.07 * tall),
            8,
            5,
        )
    )
    bones.append(
        rod((x, 0, h - 0.16 * tall), (x + 0.22 * w, 0, h - 0.15 * tall), 1.2 * thick, 0.6 * thick)
    )
    stays = [rod((spine[k][0], 0, top), spine[k], 0.3 * thick, sides=4) for k in (2, 7)]
    return parts(size, gathered(_podium(size, top), {BONE: bones, STEEL: stays}))


def _island_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    angle = np.arange(14) * 2 * pi / 14
    uneven = np.array([0.5 + 0.18 * wobble(k) for k in range(14)])
    lump = np.column_stack([w * uneven * np.cos(angle), d * uneven * np.sin(angle)])
    return (
        rectangle(size),
        rectangle(size, 0.06),
        closed(lump),
        box(0.5 * w, 0.7 * w, 0.78 * d, 0.88 * d),
    )


_SKELETON = (Size(2.5, 1.5, 1.2), Size(5.0, 2.4, 2.6), Size(12.0, 6.0, 6.0))

ASSETS = (
    asset("exhibit_island", _island, _island_symbol, name="Island with a boulder"),
    asset("exhibit_island", _island_skeleton, _island_symbol, variant="skeleton",
          name="Island with a skeleton", sizes=_SKELETON),
)  # fmt: skip
