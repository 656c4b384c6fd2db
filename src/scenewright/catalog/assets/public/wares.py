"""What is shown and sold, light enough for halls of thousands: goods, garments, exhibits."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.materials import (
    ACCENT,
    BRONZE,
    CARDBOARD,
    CERAMIC,
    CLAY,
    LINEN,
    MUSTARD,
    NAVY,
    OAK_DARK,
    SAGE_FABRIC,
    STONE,
    TERRACOTTA,
    WHITE,
)
from scenewright.catalog.assets.objects import SPINES, Stuff, wobble
from scenewright.core.catalog import Material
from scenewright.geometry.mesh import Mesh, rotate_mesh
from scenewright.geometry.solids import Interval, ball, block, disc, lathe, profile

PACKS = (TERRACOTTA, LINEN, MUSTARD, SAGE_FABRIC, ACCENT, CARDBOARD, NAVY, WHITE)
CLOTHS = (NAVY, LINEN, TERRACOTTA, SAGE_FABRIC, MUSTARD)
SKEW = 0.3


def merge_by_material(*several: Stuff) -> Stuff:
    """Meshes of several things by material."""
    found: Stuff = {}
    for stuff in several:
        for material, meshes in stuff.items():
            found.setdefault(material, []).extend(meshes)
    return found


def levels_of(low: float, high: float, count: int) -> list[Interval]:
    """The clear heights between ``count`` + 1 shelf tops spread evenly over ``(low, high)``."""
    return list(pairwise(low + (high - low) * k / count for k in range(count + 1)))


def goods(
    x: Interval,
    y: Interval,
    levels: Sequence[Interval],
    count: int,
    start: int = 0,
    colours: Sequence[Material] = PACKS,
    least: float = 0.45,
    like: int = 2,
) -> Stuff:
    """``count`` facings of packed goods on each level, one block each, with gaps here and there.

    A block stands for a row of like packs; ``like`` neighbours share a colour.
    """
    found: Stuff = {}
    for row, (low, high) in enumerate(levels):
        for i, (a, b) in enumerate(spread(*x, count)):
            seed = start + 37 * row + i
            if count > 2 and wobble(seed + 0.3) < 0.07:
                continue
            tall = (high - low) * (least + (0.88 - least) * wobble(seed))
            slack = 0.04 * (b - a) * (1 + wobble(seed + 0.6))
            material = colours[int(wobble(start + 29 * row + i // like + 0.8) * len(colours))]
            body = block((a + slack, b - slack), y, (low, low + tall))
            found.setdefault(material, []).append(body)
    return found


def volumes(
    x: Interval, y: Interval, levels: Sequence[Interval], count: int, start: int = 0
) -> Stuff:
    """Books on each level as ``count`` blocks of a few spines, nearly level at the top."""
    return goods(x, y, levels, count, start, SPINES, 0.68, 1)


def garment(x: float, half: float, rail: float, long: float, thick: float = 0.03) -> Mesh:
    """A garment on a hanger below a rail along x: shoulders across it in y, 20 triangles."""
    top, hem = rail - 0.04, rail - 0.04 - long
    outline = [
        (-0.85 * half, hem),
        (0.85 * half, hem),
        (half, top - 0.08),
        (0.04, top),
        (-0.04, top),
        (-half, top - 0.08),
    ]
    return profile(outline, (x - thick / 2, x + thick / 2))


def stack_folded_cloth(x: Interval, y: Interval, z: Interval, start: int = 0) -> Stuff:
    """A grid of stacks of folded cloth about 0.3 by 0.35 m, three layers each."""
    found: Stuff = {}
    columns = min(6, max(1, round((x[1] - x[0]) / 0.36)))
    rows = min(3, max(1, round((y[1] - y[0]) / 0.4)))
    for i, (a, b) in enumerate(spread(*x, columns)):
        for k, (c, e) in enumerate(spread(*y, rows)):
            seed = start + 5 * i + 3 * k
            top = z[0] + (z[1] - z[0]) * (0.55 + 0.45 * wobble(seed))
            top = z[1] if i + k == 0 else top
            for n, (low, high) in enumerate(spread(z[0], top, 3)):
                inset = 0.03 + 0.012 * wobble(seed + n)
                cloth = CLOTHS[int(wobble(seed + n // 2 + 0.4) * len(CLOTHS))]
                layer = block((a + inset, b - inset), (c + inset, e - inset), (low, high - 0.002))
                found.setdefault(cloth, []).append(layer)
    return found


def exhibits(x: Interval, y: Interval, z: Interval, start: int = 0, most: int = 5) -> Stuff:
    """Small objects in a row on a deck: vessels, tablets, figures; at most ``most``."""
    found: Stuff = {}
    count = min(most, max(1, round((x[1] - x[0]) / 0.32)))
    deep = (y[0] + y[1]) / 2
    for i, (a, b) in enumerate(spread(*x, count)):
        radius = min(0.36 * (b - a), 0.42 * (y[1] - y[0]), 0.5 * (z[1] - z[0]), 0.16)
        tall = (z[1] - z[0]) * (0.6 + 0.25 * wobble(start + i + 0.5))
        for material, mesh in _exhibit((start + i) % 4, radius, tall, (a + b) / 2, deep, z[0]):
            found.setdefault(material, []).append(mesh)
    return found


def _exhibit(
    which: int, radius: float, tall: float, x: float, y: float, z: float
) -> list[tuple[Material, Mesh]]:
    if which == 0:
        return [(CLAY, vessel(0.8 * radius, z, tall, (x, y)))]
    if which == 1:
        thick = 0.25 * radius
        slab = block((x - radius, x + radius), (y - thick, y + thick), (z + 0.004, z + 0.85 * tall))
        return [(STONE, rotate_mesh(slab, "x", 0.5 * SKEW, (x, y, z)))]
    if which == 2:
        foot = disc(0.4 * radius, (z, z + 0.25 * tall), (x, y), 8)
        size = min(0.75 * radius, 0.35 * tall)
        return [
            (OAK_DARK, foot),
            (BRONZE, ball(size, size, size, (x, y, z + 0.25 * tall + size), 8, 5)),
        ]
    shape = [(0.3, 0), (0.3, 0.1), (0.95, 0.75), (1, 1), (0.85, 1), (0.2, 0.3)]
    bowl = lathe([(r * radius, z + v * 0.6 * min(tall, 2 * radius)) for r, v in shape], (x, y), 10)
    return [(CERAMIC, bowl)]


def vessel(radius: float, low: float, tall: float, at: tuple[float, float], sides: int = 8) -> Mesh:
    """A tall-necked vessel."""
    shape = [(0.5, 0), (1, 0.38), (0.85, 0.6), (0.38, 0.8), (0.55, 1)]
    return lathe([(r * radius, low + z * tall) for r, z in shape], at, sides)
