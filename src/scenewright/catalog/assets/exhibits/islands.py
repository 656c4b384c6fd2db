"""Islands of exhibition halls: a low podium and one large thing on it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import pairwise
from math import pi

import numpy as np

from scenewright.catalog.assets.drawing import LETTERS, Drawing
from scenewright.catalog.assets.exhibits.treasures import show
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import BLACK, BONE, CONCRETE, PAPER, STEEL
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.catalog.assets.public.wares import merge_by_material
from scenewright.catalog.assets.symbols import Lines, box, close_line, rectangle
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import ball, block, rod, tube

Bone = tuple[float, float, float]


def lay_podium(size: Size, top: float) -> Stuff:
    """A low podium with a label."""
    w, d = size.width / 2, size.depth / 2
    label = block((-0.2, 0.2), (-0.12, 0.12), (0, 0.02))
    label = translate_mesh(rotate_mesh(label, "x", -0.5), 0.55 * w, d - 0.2, top + 0.09)
    return {
        CONCRETE: [block((-w, w), (-d, d), (0.06, top))],
        BLACK: [block((-w + 0.06, w - 0.06), (-d + 0.06, d - 0.06), (0, 0.06))],
        PAPER: [label],
    }


def _island(size: Size, names: Sequence[str]) -> Parts:
    """Treasures beside one another on a podium, each as large as fits."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.25, 0.2 * h)
    found = lay_podium(size, top)
    places = spread(-0.9 * w, 0.9 * w, len(names))
    for k, (name, (a, b)) in enumerate(zip(names, places, strict=True)):
        tall = (h - top) * (1.0 - 0.22 * (k % 2))
        back = 0.1 * d * (k % 2)
        here = show(
            name, (a + 0.05, b - 0.05), (back - 0.75 * d, back + 0.55 * d), (top, top + tall)
        )
        found = merge_by_material(found, here)
    return parts(size, found)


_SPINE = (
    (-0.95, 0.34),
    (-0.75, 0.38),
    (-0.55, 0.48),
    (-0.36, 0.59),
    (-0.18, 0.65),
    (0.0, 0.67),
    (0.16, 0.65),
    (0.31, 0.62),
    (0.44, 0.66),
    (0.55, 0.77),
    (0.66, 0.89),
    (0.78, 0.93),
)
"""Points of a spine from tail to skull, as shares of half the width and of the height."""


def _island_skeleton(size: Size) -> Parts:
    """The bones of a large animal: spine, ribs, four legs, a skull to the right."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.3, 0.2 * h)
    tall, thick = h - top, 0.022 * (h - top) + 0.015
    spine = [(x * w, 0.0, top + z * tall) for x, z in _SPINE]
    reach = min(0.5 * d, 0.24 * tall)
    bones = [tube(spine, 1.5 * thick, 5), *_ribs(spine, 0.36 * tall, reach, 0.7 * thick)]
    for k, s in ((3, -1), (3, 1), (7, -1), (7, 1)):
        bones += _leg(spine[k], top, s * 1.1 * reach, thick)
    x, _, z = spine[-1]
    long, deep = 0.13 * w, min(0.25 * d, 0.09 * tall)
    bones.append(ball(long, deep, 0.06 * tall, (x + 0.5 * long, 0, h - 0.06 * tall), 8, 5))
    jaw = ((x, 0, z - 0.05 * tall), (x + 1.4 * long, 0, z - 0.07 * tall))
    bones.append(rod(*jaw, 1.4 * thick, 0.6 * thick, 6))
    stays = [rod((*spine[k][:2], top), spine[k], 0.4 * thick, sides=4) for k in (1, 5)]
    return parts(size, merge_by_material(lay_podium(size, top), {BONE: bones, STEEL: stays}))


def _ribs(spine: Sequence[Bone], deep: float, reach: float, thick: float) -> list[Mesh]:
    """Ribs bent down on both sides of the middle of a spine, at its joints and between them."""
    found = []
    for a, b in pairwise(spine[3:8]):
        for t in (0.25, 0.75):
            x, z = a[0] + t * (b[0] - a[0]), a[2] + t * (b[2] - a[2])
            bow = [(0.0, 0.0), (0.9, 0.15), (1.0, 0.6), (0.4, 1.0)]
            found += [
                tube([(x - 0.1 * f * deep, s * r * reach, z - f * deep) for r, f in bow], thick, 4)
                for s in (-1, 1)
            ]
    return found


def _leg(hip: Bone, low: float, out: float, thick: float) -> list[Mesh]:
    """Two bones down from a hip to the height ``low``, and a foot."""
    x, _, z = hip
    knee = (x + 1.5 * thick, out, low + 0.45 * (z - low))
    ankle = (x - thick, out, low + 2 * thick)
    foot = block(
        (x - 3 * thick, x + 5 * thick), (out - 2 * thick, out + 2 * thick), (low, low + 1.5 * thick)
    )
    upper = rod((x, 0.5 * out, z - thick), knee, 1.3 * thick, thick, 6)
    return [upper, rod(knee, ankle, thick, 0.8 * thick, 6), foot]


def draw_island(size: Size) -> Lines:
    """The plan of an island: its podium, a lump, the label."""
    w, d = size.width / 2, size.depth / 2
    angle = np.arange(14) * 2 * pi / 14
    uneven = np.array([0.5 + 0.18 * wobble(k) for k in range(14)])
    lump = np.column_stack([w * uneven * np.cos(angle), d * uneven * np.sin(angle)])
    return (
        rectangle(size),
        rectangle(size, 0.06),
        close_line(lump),
        box(0.5 * w, 0.7 * w, 0.78 * d, 0.88 * d),
    )


_SKELETON = (Size(2.5, 1.5, 1.2), Size(5.0, 2.4, 2.6), Size(12.0, 6.0, 6.0))
_BONES = (
    "skeleton dinosaur mammoth saurian saurus rex bones fossil skelett dinosaurier "
    "squelette dinosaure esqueleto dinosaurio 恐龙 骨骼 恐竜"
)

ISLANDS = (
    "capital torso capital",
    "sarcophagus",
    "amphora krater jug",
    "gown coat gown",
    "crystals ammonite",
    "column pebbles",
    "ship",
)
"""What stands together on islands that are called nothing in particular."""

ASSETS = (
    *(
        Drawing(
            "exhibit_island",
            partial(_island, names=names.split()),
            draw_island,
            f"exhibit_island_{LETTERS[k]}" if k else "",
            f"Island, {names.replace(' ', ', ')}",
        )
        for k, names in enumerate(ISLANDS)
    ),
    Drawing(
        "exhibit_island",
        _island_skeleton,
        draw_island,
        id="exhibit_island_skeleton",
        name="Island with a skeleton",
        sizes=_SKELETON,
        called=tuple(_BONES.split()),
    ),
)
