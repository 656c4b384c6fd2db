"""What is sold, light enough for long rows of shelves: goods by trade, in runs of like things.

A :class:`Ware` is one row: its form, size and colours; a trade is the wares its shelves hold.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

from scenewright.catalog.assets import materials as m
from scenewright.catalog.assets.joinery import spread
from scenewright.catalog.assets.objects import Stuff, wobble
from scenewright.core.catalog import Material
from scenewright.geometry.mesh import Mesh, loft
from scenewright.geometry.solids import Interval, ball, block, lathe, oval_ring, rectangle_ring

PAINTED = (m.WHITE, m.TERRACOTTA, m.ACCENT, m.MUSTARD, m.SAGE, m.BLACK)
CLOTHS = (m.NAVY, m.LINEN, m.TERRACOTTA, m.SAGE_FABRIC, m.DENIM, m.MUSTARD, m.CHARCOAL, m.FABRIC)
FULL = 0.9
"""The share of the clear height of a shelf that goods take at most."""


class Ware(NamedTuple):
    """Things of one form: width, depth and height in metres, the colours of a run, how many are
    stacked at most."""

    form: str
    width: float
    depth: float
    height: float
    colours: tuple[Material, ...] = (m.PRINTED,)
    stacked: int = 1


_ROUND: dict[str, tuple[tuple[float, float], ...]] = {
    "tin": ((1.0, 0.0), (1.0, 1.0)),
    "jar": ((0.9, 0.0), (1.0, 0.1), (1.0, 0.75), (0.75, 0.85), (0.8, 1.0)),
    "bottle": ((1.0, 0.0), (1.0, 0.55), (0.36, 0.75), (0.3, 1.0)),
    "flask": ((0.9, 0.0), (1.0, 0.7), (0.45, 0.82), (0.45, 1.0)),
    "pot": ((0.7, 0.0), (1.0, 0.9), (1.0, 1.0), (0.86, 0.94)),
}
"""Profiles of round things: shares of the radius and of the height."""
_DRINKS = (m.BOTTLE_GREEN, m.COPPER, m.CLAY, m.BRONZE, m.IRON)
_PASTE = (m.TERRACOTTA, m.MUSTARD, m.BRONZE, m.VERMILION)

TRADES: dict[str, tuple[Ware, ...]] = {
    "groceries": (
        Ware("box", 0.17, 0.2, 0.24),
        Ware("tin", 0.085, 0.085, 0.11, (m.PRINTED, m.TERRACOTTA, m.SAGE, m.STEEL), 2),
        Ware("jar", 0.085, 0.085, 0.15, _PASTE),
        Ware("bag", 0.16, 0.14, 0.22),
        Ware("bottle", 0.08, 0.08, 0.28, _DRINKS),
    ),
    "drinks": (
        Ware("bottle", 0.085, 0.085, 0.31, _DRINKS),
        Ware("flask", 0.1, 0.1, 0.3, (m.PRINTED, m.ACCENT, m.RED, m.WHITE)),
        Ware("tin", 0.07, 0.07, 0.12, (m.RED, m.ACCENT, m.STEEL, m.PRINTED), 2),
    ),
    "household": (
        Ware("flask", 0.11, 0.09, 0.27, (m.WHITE, m.ACCENT, m.SAGE, m.MUSTARD, m.RED)),
        Ware("box", 0.24, 0.2, 0.28),
        Ware("pot", 0.14, 0.14, 0.13, (*PAINTED, m.STEEL), 2),
        Ware("bag", 0.26, 0.18, 0.24),
    ),
    "pharmacy": (
        Ware("box", 0.09, 0.12, 0.1, (m.PRINTED, m.WHITE), 2),
        Ware("flask", 0.06, 0.06, 0.15, (m.WHITE, m.SAGE, m.BRONZE)),
        Ware("jar", 0.07, 0.07, 0.08, (m.WHITE, m.GREIGE, m.SAGE), 2),
    ),
    "bakery": (
        Ware("loaf", 0.17, 0.26, 0.13, (m.CRUST, m.CRUST_DARK)),
        Ware("roll", 0.1, 0.1, 0.07, (m.CRUST, m.CRUST_DARK), 2),
        Ware("bag", 0.15, 0.12, 0.2, (m.CARDBOARD, m.PAPER)),
    ),
    "books": (
        Ware("books", 0.3, 0.17, 0.25, (m.SPINED,)), Ware("books", 0.22, 0.2, 0.3, (m.SPINED,)),
        Ware("cloth", 0.17, 0.22, 0.03, (m.SPINED, m.PRINTED), 4),
    ),
    "shoes": (
        Ware("shoes", 0.24, 0.27, 0.13, (m.LEATHER, m.BLACK, m.WHITE, m.NAVY, m.VELVET)),
        Ware("shoes", 0.24, 0.27, 0.16, (m.LEATHER, m.CHARCOAL, m.TERRACOTTA)),
        Ware("box", 0.34, 0.22, 0.13, (m.CARDBOARD, m.WHITE, m.BLACK), 2),
    ),
    "electronics": (
        Ware("screen", 0.42, 0.16, 0.28, (m.BLACK,)),
        Ware("box", 0.26, 0.2, 0.2),
        Ware("flask", 0.14, 0.14, 0.22, (m.BLACK, m.WHITE, m.CHARCOAL)),
        Ware("box", 0.2, 0.22, 0.09, (m.BLACK, m.WHITE, m.STEEL)),
    ),
    "fashion": (
        Ware("cloth", 0.29, 0.3, 0.05, CLOTHS, 5),
        Ware("cloth", 0.29, 0.3, 0.035, CLOTHS, 6),
        Ware("bag", 0.3, 0.14, 0.24, (m.LEATHER, m.BLACK, m.MUSTARD, m.VELVET)),
    ),
    "library": (
        Ware("books", 0.34, 0.17, 0.23, (m.SPINED,)), Ware("books", 0.42, 0.19, 0.26, (m.SPINED,)),
        Ware("books", 0.16, 0.21, 0.28, (m.SPINED,)),
    ),
    "chilled": (
        Ware("flask", 0.085, 0.085, 0.26, (m.WHITE, m.PAPER, m.MUSTARD, m.TERRACOTTA)),
        Ware("pot", 0.085, 0.085, 0.1, (m.WHITE, m.PRINTED, m.RED), 2),
        Ware("box", 0.14, 0.2, 0.1, (m.PRINTED, m.PRINTED, m.MUSTARD), 2),
        Ware("tin", 0.1, 0.1, 0.14, (m.PRINTED,)),
    ),
    "produce": (
        Ware("fruit", 0.3, 0.4, 0.12, (m.RED, m.MUSTARD, m.LEAF_LIGHT, m.PEEL, m.LEAF)),
    ),
}  # fmt: skip
"""What the shelves of a trade hold."""


FILLER = {
    "bakery": Ware("box", 0.3, 0.3, 0.13, (m.RATTAN,)),
    "fashion": Ware("box", 0.3, 0.28, 0.16, (m.CARDBOARD, m.WHITE)),
    "shoes": Ware("box", 0.3, 0.24, 0.12, (m.CARDBOARD, m.WHITE, m.NAVY), 2),
    "library": Ware("books", 0.3, 0.17, 0.24, (m.SPINED,)),
    "books": Ware("books", 0.3, 0.17, 0.24, (m.SPINED,)),
}
"""What the shelves of a trade hold once its goods take too many triangles; else cartons."""
CARTON = Ware("box", 0.15, 0.24, 0.2, (m.PRINTED, m.PRINTED, m.CARDBOARD))


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


def _draw_box(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    return [block(x, y, z)]


def _draw_bag(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    """A filled bag, gathered at the top."""
    (px, rx), (py, ry) = (((a + b) / 2, (b - a) / 2) for a, b in (x, y))
    rows = ((0.85, 0.8, 0.0), (1.0, 1.0, 0.2), (0.95, 0.85, 0.7), (0.9, 0.12, 1.0))
    return [
        loft([oval_ring(rx * a, ry * b, z[0] + c * (z[1] - z[0]), 6, (px, py)) for a, b, c in rows])
    ]


def _draw_loaf(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    half, tall = ((x[1] - x[0]) / 2, (y[1] - y[0]) / 2), z[1] - z[0]
    middle = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2)
    return [
        loft([oval_ring(half[0] * r, half[1] * r, z[0] + c * tall, 8, middle)
              for r, c in ((0.85, 0.0), (1.0, 0.3), (0.9, 0.7), (0.5, 1.0))])
    ]  # fmt: skip


def _fold(x: Interval, y: Interval, z: Interval) -> Mesh:
    """A folded piece of cloth, fuller in its middle."""
    rings = []
    for inset, level in ((0.008, z[0]), (0.0, (z[0] + z[1]) / 2), (0.008, z[1])):
        a, b = (x[0] + inset, x[1] - inset), (y[0] + inset, y[1] - inset)
        rings.append(rectangle_ring(a, b, level, 0.025, 1))
    return loft(rings)


def _draw_cloth(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    return [_fold(x, y, z)]


_SHOE = ((0.0, 0.62, 0.95), (0.12, 0.8, 1.0), (0.34, 0.8, 0.78), (0.55, 0.9, 0.5), (0.8, 1.0, 0.42),
         (0.96, 0.75, 0.3), (1.0, 0.4, 0.16))  # fmt: skip
"""Sections of a shoe from heel to toe: the place, the width, the height, in shares."""


def _draw_shoes(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    """A pair side by side, toes to the front."""
    half, long, tall = 0.21 * (x[1] - x[0]), y[1] - y[0], z[1] - z[0]
    found = []
    for middle in (0.74 * x[0] + 0.26 * x[1], 0.26 * x[0] + 0.74 * x[1]):
        rings = []
        for s, wide, high in _SHOE:
            a, h = half * wide, high * tall
            outline = (
                (-a, 0.0),
                (-a, 0.4 * h),
                (-0.55 * a, h),
                (0.55 * a, h),
                (a, 0.4 * h),
                (a, 0.0),
            )
            rings.append([(middle + p, y[0] + s * long, z[0] + q) for p, q in outline])
        found.append(loft(rings))
    return found


def _draw_screen(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    middle, deep = (x[0] + x[1]) / 2, (y[0] + y[1]) / 2
    low = z[0] + 0.18 * (z[1] - z[0])
    return [
        block(x, (deep - 0.012, deep + 0.012), (low, z[1])),
        block((middle - 0.02, middle + 0.02), (deep - 0.01, deep + 0.01), (z[0] + 0.01, low)),
        block((middle - 0.09, middle + 0.09), y, (z[0], z[0] + 0.012)),
    ]


def _draw_fruit(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
    """A heap of round fruit: two layers."""
    radius, found = 0.05, []
    for layer, (inset, count) in enumerate(((0.0, (3, 3)), (0.05, (2, 2)))):
        for i, (a, b) in enumerate(spread(x[0] + inset, x[1] - inset, count[0])):
            for k, (c, e) in enumerate(spread(y[0] + inset, y[1] - inset, count[1])):
                big = radius * (0.92 + 0.16 * wobble(7 * i + k))
                middle = ((a + b) / 2, (c + e) / 2, z[0] + 1.08 * radius + 0.06 * layer)
                found.append(ball(big, big, big, middle, 7, 4))
    return found


def _draw_round(form: str, sides: int = 6) -> Callable[[Interval, Interval, Interval], list[Mesh]]:
    def drawn(x: Interval, y: Interval, z: Interval) -> list[Mesh]:
        radius = min(x[1] - x[0], y[1] - y[0]) / 2
        rows = [(r * radius, z[0] + s * (z[1] - z[0])) for r, s in _ROUND[form]]
        return [lathe(rows, ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2), sides)]

    return drawn


FORMS: dict[str, Callable[[Interval, Interval, Interval], list[Mesh]]] = {
    **{form: _draw_round(form) for form in _ROUND},
    "box": _draw_box,
    "books": _draw_box,
    "bag": _draw_bag,
    "loaf": _draw_loaf,
    "roll": _draw_loaf,
    "cloth": _draw_cloth,
    "shoes": _draw_shoes,
    "screen": _draw_screen,
    "fruit": _draw_fruit,
}
"""How things of a form are drawn in a box."""


def stock(
    trade: str,
    x: Interval,
    y: Interval,
    levels: Sequence[Interval],
    seed: int = 0,
    most: int = 1500,
    turned: bool = False,
) -> Stuff:
    """Goods of a trade on each level, in runs of like ones along the front edge ``y[1]`` (of
    ``turned`` ones ``y[0]``); about ``most`` triangles."""
    found: Stuff = {}
    left = float(most)
    for row, level in enumerate(levels):
        at, k, spare = x[0], 97 * seed + 31 * row, left / (len(levels) - row)
        wares = [w for w in TRADES[trade] if w.height < FULL * (level[1] - level[0])]
        while True:
            own = [w for w in wares if w.width <= x[1] - at] if spare > 0 else []
            ware = own[int(wobble(k) * len(own))] if own else FILLER.get(trade, CARTON)
            end = min(at + max(ware.width, 0.2 + 0.35 * wobble(k + 0.5)), x[1])
            end = x[1] if x[1] - end < 0.08 else end
            if end - at < ware.width or ware.height > level[1] - level[0]:
                break
            taken = _lay_run(found, ware, (at, end), y, level, k, turned)
            at, k, spare, left = end + 0.012, k + 1, spare - taken, left - taken
    return found


def _lay_run(
    found: Stuff, ware: Ware, x: Interval, y: Interval, z: Interval, seed: int, turned: bool
) -> int:
    """Like things side by side along the front; how many triangles that takes."""
    count = max(1, int((x[1] - x[0]) / (ware.width + 0.008)))
    room = y[1] - y[0] - 0.01
    deep = max(0.85 * room, 0.0) if ware.form == "box" else min(ware.depth, room)
    fits = max(1, min(ware.stacked, int(FULL * (z[1] - z[0]) / ware.height)))
    material = ware.colours[int(wobble(seed + 0.8) * len(ware.colours))]
    drawn: list[Mesh] = []
    for i, (a, b) in enumerate(spread(*x, count)):
        if count > 3 and wobble(seed + 3.1 * i) < 0.06:
            continue
        near = 0.01 + min(0.012 * wobble(seed + i + 0.3), max(room - deep, 0.0))
        front = (y[0] + near, y[0] + near + deep) if turned else (y[1] - near - deep, y[1] - near)
        tall = ware.height * (1 + 0.08 * wobble(seed + i) * (ware.form == "books"))
        slack = (b - a - ware.width) / 2
        for n in range(fits - (i == count - 1 and fits > 2)):
            low = z[0] + n * tall
            drawn += FORMS[ware.form]((a + slack, b - slack), front, (low, low + tall - 0.001))
    found.setdefault(material, []).extend(drawn)
    return sum(len(mesh.faces) for mesh in drawn)


def stack_folded_cloth(x: Interval, y: Interval, z: Interval, start: int = 0) -> Stuff:
    """A grid of stacks of folded cloth about 0.3 by 0.35 m, each of one or two colours."""
    found: Stuff = {}
    columns = min(6, max(1, round((x[1] - x[0]) / 0.36)))
    rows = min(3, max(1, round((y[1] - y[0]) / 0.4)))
    for i, (a, b) in enumerate(spread(*x, columns)):
        for k, (c, e) in enumerate(spread(*y, rows)):
            seed = start + 5 * i + 3 * k
            top = z[0] + (z[1] - z[0]) * (0.45 + 0.55 * wobble(seed))
            top = z[1] if i + k == 0 else top
            layers = max(2, round((top - z[0]) / 0.04))
            for n, (low, high) in enumerate(spread(z[0], top, layers)):
                inset = 0.03 + 0.012 * wobble(seed + n)
                cloth = CLOTHS[int(wobble(seed + n // 3 + 0.4) * len(CLOTHS))]
                layer = ((a + inset, b - inset), (c + inset, e - inset), (low, high - 0.001))
                found.setdefault(cloth, []).append(_fold(*layer))
    return found
