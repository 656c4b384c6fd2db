"""The bones of a whale on the podium of an exhibition hall."""

from __future__ import annotations

import numpy as np

from scenewright.catalog.assets.drawing import Drawing
from scenewright.catalog.assets.exhibits.islands import Bone, draw_island, lay_podium
from scenewright.catalog.assets.materials import BONE, STEEL
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.public.wares import merge_by_material
from scenewright.core.scene import Size
from scenewright.geometry.mesh import Floats, Mesh
from scenewright.geometry.solids import ball, rod, tube

_BACK = ((-0.95, 0.55), (-0.7, 0.62), (-0.4, 0.72), (-0.1, 0.78), (0.2, 0.8), (0.46, 0.78))
"""Points of a spine from the tail to the skull, as shares of half the width and of the height."""
_JAW = ((0.46, 0.3, 0.66), (0.62, 0.85, 0.6), (0.8, 0.6, 0.6), (0.95, 0.04, 0.66))
"""Of a jaw: half the width, reach to the side, and height."""
_CHEST = (-0.12, 0.4)
_PAIRS = 9
"""Where ribs begin and end, and how many pairs there are."""


def _island_whale(size: Size) -> Parts:
    """Spine and vertebrae, ribs below the front half, two flippers, long jaws, on stays."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    top = min(0.3, 0.2 * h)
    tall, thick = h - top, 0.03 * (h - top) + 0.01
    spine = np.array([(x * w, 0.0, top + z * tall) for x, z in _BACK])
    reach = min(0.7 * d, 0.3 * tall)
    bones = [tube(spine, thick, 5), *_vertebrae(spine, 2.2 * thick)]
    bones += _ribs(spine, w, 0.4 * tall, reach, 0.6 * thick)
    for side in (-1, 1):
        jaw = [(x * w, side * y * reach, top + z * tall) for x, y, z in _JAW]
        bones.append(tube(jaw, 1.2 * thick, 5))
        bones += _flipper((0.32 * w, side * reach, top + 0.5 * tall), side, 0.16 * w, thick)
    snout = ((0.46 * w, 0, spine[-1, 2]), (0.95 * w, 0, top + 0.7 * tall))
    bones += [rod(*snout, 3.0 * thick, thick, 6), _skull(spine[-1], w, reach, tall)]
    stays = [rod((*spine[k, :2], top), spine[k], 0.4 * thick, sides=4) for k in (0, 2, 4)]
    return parts(size, merge_by_material(lay_podium(size, top), {BONE: bones, STEEL: stays}))


def _vertebrae(spine: Floats, big: float) -> list[Mesh]:
    x = np.linspace(spine[0, 0], spine[-1, 0], 16)
    z = np.interp(x, spine[:, 0], spine[:, 2])
    wide = big * np.linspace(0.35, 1.0, len(x))
    return [
        ball(0.5 * r, r, r, (float(u), 0, float(v)), 6, 4)
        for u, v, r in zip(x, z, wide, strict=True)
    ]


def _ribs(spine: Floats, half: float, deep: float, reach: float, thick: float) -> list[Mesh]:
    """Pairs of ribs bent down and in, shorter towards the tail."""
    found = []
    for k, x in enumerate(np.linspace(*_CHEST, _PAIRS) * half):
        z, long = float(np.interp(x, spine[:, 0], spine[:, 2])), 0.55 + 0.45 * k / (_PAIRS - 1)
        bow = [(0.0, 0.0), (0.85, 0.12), (1.0, 0.5), (0.7, 0.95)]
        for side in (-1, 1):
            path = [(x - 0.2 * f * deep, side * r * reach, z - f * long * deep) for r, f in bow]
            found.append(tube(path, thick, 4))
    return found


def _flipper(shoulder: Bone, side: int, long: float, thick: float) -> list[Mesh]:
    """An arm and three fingers, down and back."""
    x, y, z = shoulder
    wrist = (x - 0.4 * long, y + 0.1 * side * long, z - 0.5 * long)
    tips = [(wrist[0] - a * long, wrist[1], wrist[2] - b * long) for a, b in _FINGERS]
    return [
        rod(shoulder, wrist, 1.2 * thick, thick, 6),
        *(rod(wrist, t, 0.7 * thick, sides=4) for t in tips),
    ]


_FINGERS = ((0.55, 0.1), (0.5, 0.25), (0.35, 0.35))


def _skull(neck: Floats, w: float, reach: float, tall: float) -> Mesh:
    return ball(
        0.1 * w, 0.55 * reach, 0.08 * tall, (float(neck[0]) + 0.05 * w, 0, float(neck[2])), 8, 5
    )


ASSETS = (
    Drawing(
        "exhibit_island",
        _island_whale,
        draw_island,
        id="exhibit_island_whale",
        name="Island with the bones of a whale",
        sizes=(Size(3.0, 1.2, 1.2), Size(9.0, 2.4, 2.6), Size(28.0, 7.0, 9.0)),
        called=(
            "whale",
            "wal",
            "walskelett",
            "baleine",
            "cachalot",
            "ballena",
            "鲸",
            "鯨",
            "クジラ",
        ),
    ),
)
