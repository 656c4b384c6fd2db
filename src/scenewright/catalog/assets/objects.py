"""Small things that fill shelves: rows of books, garments on hangers, storage boxes."""

from __future__ import annotations

from collections.abc import Sequence
from math import sin

from scenewright.catalog.assets.materials import (
    CARDBOARD,
    CLAY,
    LINEN,
    MUSTARD,
    NAVY,
    RATTAN,
    SAGE_FABRIC,
    SPINED,
    STEEL,
    TERRACOTTA,
    WHITE,
)
from scenewright.core.catalog import Material
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.solids import Interval, block, cushion, lathe, rod, slab, tube

Stuff = dict[Material, list[Mesh]]
SPINES = (LINEN, TERRACOTTA, NAVY, SAGE_FABRIC, MUSTARD, WHITE)


def wobble(k: float) -> float:
    """A fixed, uneven number in [0, 1) for every ``k``: the fraction of 43758.55 sin(12.99 k)."""
    value = 43758.5453 * sin(12.9898 * (k + 1.0))
    return value - value // 1


def books(x: Interval, y: Interval, z: Interval, start: int = 0) -> Stuff:
    """Books standing from ``x[0]`` on as far as they fit, no taller than the interval ``z``: runs
    of a height with printed spines, and between them single ones of a colour."""
    found: Stuff = {}
    at, k, tall = x[0], start, min(z[1] - z[0] - 0.02, 0.29)
    while tall > 0.03:
        single = k % 3 == 2
        wide = 0.025 + 0.03 * wobble(k) if single else 0.09 + 0.12 * wobble(k)
        wide = wide if single else max(min(wide, x[1] - at), 0.03)
        if at + wide > x[1] + 1e-9:
            break
        high = tall * (0.72 + 0.28 * wobble(k + 0.5))
        deep = min(y[1] - y[0], 0.16 + 0.06 * wobble(k + 0.25))
        spine = SPINES[int(wobble(k + 0.75) * len(SPINES))] if single else SPINED
        book = block((at, at + wide - 0.003), (y[0], y[0] + deep), (z[0], z[0] + high))
        found.setdefault(spine, []).append(book)
        at, k = at + wide, k + 1
    return found


def book_rows(
    x: Interval, y: Interval, levels: Sequence[Interval], share: float = 0.75, start: int = 0
) -> Stuff:
    """Shelves filled unevenly up to ``share`` of their width with books, a vase or a box beside."""
    found: Stuff = {}
    wide = x[1] - x[0]
    for i, (low, high) in enumerate(levels):
        taken = wide * share * (0.55 + 0.45 * wobble(start + 7 * i))
        left = i % 2 == 0
        row = (x[0], x[0] + taken) if left else (x[1] - taken, x[1])
        spare = (x[0] + taken + 0.04, x[1]) if left else (x[0], x[1] - taken - 0.04)
        for material, meshes in books(row, y, (low, high), start + 11 * i).items():
            found.setdefault(material, []).extend(meshes)
        if spare[1] - spare[0] > 0.12 and high - low > 0.12:
            _beside(found, spare, y, (low, high), i)
    return found


def _beside(found: Stuff, x: Interval, y: Interval, z: Interval, i: int) -> None:
    middle, deep = (x[0] + x[1]) / 2, (y[0] + y[1]) / 2
    radius = min(0.07, (x[1] - x[0]) / 2 - 0.01, (y[1] - y[0]) / 2 - 0.01)
    tall = min(0.2, z[1] - z[0] - 0.03)
    if i % 3 == 1:
        half = min(0.15, (x[1] - x[0]) / 2 - 0.01)
        basket = slab(
            (middle - half, middle + half), (y[0], y[1] - 0.02), (z[0], z[0] + tall), 0.02
        )
        found.setdefault(RATTAN, []).append(basket)
        return
    found.setdefault(CLAY if i % 3 else WHITE, []).append(
        small_vase(radius, z[0], tall, (middle, deep))
    )


def small_vase(radius: float, low: float, tall: float, at: tuple[float, float]) -> Mesh:
    """A bellied vase, 80 triangles."""
    shape = [(0.55, 0), (1, 0.35), (0.85, 0.65), (0.4, 0.85), (0.5, 1)]
    return lathe([(r * radius, low + z * tall) for r, z in shape], at, 10)


def garments(x: Interval, y: float, rail: float, long: float) -> Stuff:
    """Clothes on hangers under a rail along x."""
    found: Stuff = {}
    cloths = (NAVY, LINEN, TERRACOTTA, SAGE_FABRIC, MUSTARD)
    count = max(2, int((x[1] - x[0]) / 0.1))
    step = (x[1] - x[0]) / count
    for i in range(count):
        middle = x[0] + (i + 0.5) * step
        half, drop = 0.15 + 0.03 * wobble(i), long * (0.7 + 0.3 * wobble(i + 0.4))
        thick = min(0.03, 0.35 * step)
        cloth = cushion(
            (middle - thick, middle + thick),
            (y - half, y + half),
            (rail - 0.1 - drop, rail - 0.08),
            thick,
            1,
        )
        hook = tube([(middle, y, rail - 0.1), (middle, y, rail)], 0.004, 4)
        found.setdefault(cloths[i % len(cloths)], []).append(cloth)
        found.setdefault(STEEL, []).append(hook)
    return found


def boxes(x: Interval, y: Interval, z: Interval, count: int, start: int = 0) -> Stuff:
    """Storage boxes in a row, of uneven height."""
    found: Stuff = {}
    step = (x[1] - x[0]) / count
    for i in range(count):
        left = x[0] + i * step
        high = z[0] + (z[1] - z[0]) * (0.55 + 0.35 * wobble(start + i))
        kind = (CARDBOARD, WHITE, RATTAN)[int(3 * wobble(start + i + 0.5))]
        body = block(
            (left + 0.01, left + step - 0.01), (y[0] + 0.01, y[1] - 0.02), (z[0], high - 0.03)
        )
        lid = block(
            (left + 0.005, left + step - 0.005), (y[0] + 0.005, y[1] - 0.015), (high - 0.03, high)
        )
        found.setdefault(kind, []).extend([body, lid])
    return found


def hook(x: float, y: float, z: float) -> Mesh:
    """A short peg pointing to +y and up."""
    return rod((x, y, z), (x, y + 0.05, z + 0.03), 0.008, 0.011, 6)
