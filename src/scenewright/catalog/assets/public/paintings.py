"""Pictures and carpets hung on the walls of galleries."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from scenewright.catalog.assets.drawing import letter_models
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    BLACK,
    BRONZE,
    CARPET,
    GILT,
    GLOW,
    OAK_DARK,
    PAINTINGS,
    PAPER,
)
from scenewright.catalog.assets.model import Parts, parts
from scenewright.catalog.assets.objects import Stuff
from scenewright.catalog.assets.public.wares import merge_by_material
from scenewright.catalog.assets.symbols import Lines, path, rectangle
from scenewright.core.catalog import Material
from scenewright.core.scene import Size
from scenewright.geometry.solids import block, frame, rod


def _rail(size: Size) -> Stuff:
    """A low rail before the wall that keeps people off."""
    w, d = size.width / 2, size.depth / 2
    rail = min(d - 0.02, -d + 0.4)
    return {
        BRONZE: [block((-0.92 * w, 0.92 * w), (rail - 0.018, rail - 0.006), (0.43, 0.45))],
        BLACK: [
            block((s * 0.92 * w - 0.012, s * 0.92 * w + 0.012), (rail - 0.024, rail), (0, 0.45))
            for s in (-1, 1)
        ],
    }


def _painting(size: Size, art: Sequence[Material], share: float) -> Parts:
    """Framed pictures side by side on the wall, lit from bars above them, behind a low rail; their
    height is a ``share`` of what there is."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    high, back = 0.93 * h, -d
    low = high - share * 0.5 * h
    found = merge_by_material({GLOW: []}, _rail(size))
    for k, (material, (a, b)) in enumerate(zip(art, spread(-w, w, len(art)), strict=True)):
        x, z = (a + 0.04 * (b - a), b - 0.04 * (b - a)), (low + 0.1 * (high - low) * (k % 2), high)
        rim = min(0.06, 0.1 * (x[1] - x[0]))
        wood = (GILT, OAK_DARK, BLACK)[(k + len(art)) % 3]
        inner, upright = (x[0] + rim, x[1] - rim), (z[0] + rim, z[1] - rim)
        half = 0.5 * rim
        canvas = (inner[0] + half, inner[1] - half), (upright[0] + half, upright[1] - half)
        long = 0.3 * (b - a)
        lamp = block(
            ((a + b) / 2 - long, (a + b) / 2 + long),
            (back + 0.12, back + 0.15),
            (high + 0.03, high + 0.05),
        )
        for key, mesh in (
            (wood, frame(x, (back, back + 0.05), z, rim)),
            (PAPER, frame(inner, (back, back + 0.035), upright, half)),
            (material, block(canvas[0], (back, back + 0.025), canvas[1])),
            (GLOW, lamp),
        ):
            found.setdefault(key, []).append(mesh)
    return parts(size, found)


def _textile(size: Size) -> Parts:
    """A knotted carpet hung from a rod on the wall."""
    w, d, h = size.width / 2, size.depth / 2, size.height
    hung = block((-0.9 * w, 0.9 * w), (-d + 0.01, -d + 0.03), (0.22 * h, 0.95 * h))
    top = rod((-w, -d + 0.03, 0.97 * h), (w, -d + 0.03, 0.97 * h), 0.03, sides=10)
    return parts(size, merge_by_material({CARPET: [hung], OAK_DARK: [top]}, _rail(size)))


def _painting_symbol(size: Size) -> Lines:
    w, d = size.width / 2, size.depth / 2
    return rectangle(size, 0, 0), path((-0.92 * w, -d + 0.05), (0.92 * w, -d + 0.05))


_PICTURES = (
    "painting picture photo photograph drawing print canvas portrait gemälde bild foto zeichnung "
    "tableau peinture dessin cuadro pintura dibujo 绘画 照片 絵画 写真"
)
_HUNG = "carpet rug tapestry textile teppich tapis tapiz alfombra 地毯 絨毯"
_PAINTING = (Size(0.4, 0.1, 1.4), Size(1.2, 0.15, 2.2), Size(4.0, 0.7, 3.2))
ARTS = (
    ((0,), 1.0),
    ((4,), 1.1),
    ((3,), 0.9),
    ((5,), 0.75),
    ((2,), 1.1),
    ((1,), 0.7),
    ((4, 5), 0.9),
    ((0, 3, 1), 0.7),
)
"""Which pictures hang beside one another, and how high they are."""

ASSETS = (
    *letter_models(
        "wall_exhibit",
        _painting_symbol,
        (partial(_painting, art=[PAINTINGS[k] for k in art], share=share) for art, share in ARTS),
        "wall_exhibit_painting",
        "Paintings on a wall",
        _PAINTING,
        _PICTURES,
    ),
    *letter_models(
        "wall_exhibit",
        _painting_symbol,
        (_textile,),
        "wall_exhibit_textile",
        "Carpet on a wall",
        _PAINTING,
        _HUNG,
    ),
)
