"""What facades are made of: windows in rows, bands, columns, arches, steps, doors.

Sides are named ``f`` (front, +y), ``b``, ``l`` and ``r``. Panes stand a little out of their wall,
so that no wall has to be cut.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, sin

from scenewright.catalog.assets.joinery import spread
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, Spot, block, disc, sheet

OUT = 0.08
"""How far panes stand out of their wall, in metres."""
_TURNS = {"f": 0.0, "l": pi / 2, "b": pi, "r": -pi / 2}


def box(x: Interval, y: Interval, z: Interval, out: float = 0.0) -> Mesh:
    """A block, larger in plan by ``out`` on all sides: a cornice, a plinth, a slab's edge."""
    return block((x[0] - out, x[1] + out), (y[0] - out, y[1] + out), z)


def storeys(z: Interval, high: float) -> list[Interval]:
    """As many equal storeys as come nearest to ``high`` each.

    >>> storeys((0, 10), 3.2)
    [(0.0, 3.3333333333333335), (3.3333333333333335, 6.666666666666667), (6.666666666666667, 10.0)]
    """
    return spread(*z, max(1, round((z[1] - z[0]) / high)))


def bays(span: Interval, wide: float) -> list[Interval]:
    """As many equal bays as come nearest to ``wide`` each."""
    return storeys(span, wide)


def on(side: str, x: Interval, y: Interval, meshes: Sequence[Mesh]) -> list[Mesh]:
    """Things built on a wall at y = 0 looking to +y, about its middle, set on one side of a
    block."""
    at = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2)
    reach = {"f": (at[0], y[1]), "b": (at[0], y[0]), "l": (x[0], at[1]), "r": (x[1], at[1])}[side]
    found = [rotate_mesh(mesh, "z", _TURNS[side]) for mesh in meshes]
    return [translate_mesh(mesh, *reach) for mesh in found]


def width_of(side: str, x: Interval, y: Interval) -> float:
    """How wide a side of a block is."""
    return x[1] - x[0] if side in "fb" else y[1] - y[0]


def windows(
    x: Interval,
    y: Interval,
    levels: Sequence[Interval],
    bay: float,
    wide: float = 0.5,
    tall: float = 0.55,
    sides: str = "fblr",
    sill: float = 0.28,
    out: float = OUT,
) -> list[Mesh]:
    """A pane in every bay of every storey on the sides of a block; ``wide`` and ``tall`` are
    shares of the bay and the storey."""
    found: list[Mesh] = []
    for side in sides:
        half = width_of(side, x, y) / 2
        panes = [
            _pane(a, b, level, wide, tall, sill, out)
            for a, b in bays((-half, half), bay)
            for level in levels
        ]
        found += on(side, x, y, panes)
    return found


def _pane(
    a: float, b: float, z: Interval, wide: float, tall: float, sill: float, out: float
) -> Mesh:
    middle, half, high = (a + b) / 2, wide * (b - a) / 2, z[1] - z[0]
    low = z[0] + sill * high
    return block((middle - half, middle + half), (-OUT, out), (low, low + tall * high))


def bands(
    x: Interval,
    y: Interval,
    levels: Sequence[Interval],
    tall: float = 0.5,
    sill: float = 0.3,
    sides: str = "fblr",
    inset: float = 0.6,
) -> list[Mesh]:
    """A strip of glass along every storey, ``inset`` metres short of the corners."""
    found: list[Mesh] = []
    for side in sides:
        half = width_of(side, x, y) / 2 - inset
        strips = [
            block((-half, half), (-OUT, OUT), (a + sill * (b - a), a + (sill + tall) * (b - a)))
            for a, b in levels
        ]
        found += on(side, x, y, strips)
    return found


def piers(
    x: Interval,
    y: Interval,
    z: Interval,
    bay: float,
    wide: float = 0.4,
    out: float = 0.3,
    sides: str = "fblr",
) -> list[Mesh]:
    """Upright ribs between the bays and at the corners."""
    found: list[Mesh] = []
    for side in sides:
        half = width_of(side, x, y) / 2
        lines = [a for a, _ in bays((-half, half), bay)] + [half]
        ribs = [
            block((max(a - wide / 2, -half - out), min(a + wide / 2, half + out)), (-OUT, out), z)
            for a in lines
        ]
        found += on(side, x, y, ribs)
    return found


def arch(
    x: float, z: Interval, wide: float, y: Interval, pointed: bool = False, steps: int = 4
) -> Mesh:
    """An arched plate in y: an opening or a portal, round or pointed (of two arcs)."""
    half = wide / 2
    rise = min(half * (1.6 if pointed else 1.0), 0.9 * (z[1] - z[0]))
    spring = z[1] - rise
    curve: list[Spot] = []
    for k in range(steps + 1):
        angle = pi * k / steps
        bow = abs(sin(angle)) ** (0.75 if pointed else 1.0)
        across = cos(angle) if not pointed else 1 - 2 * k / steps
        bow = bow if not pointed else (1 - abs(across) ** 1.8)
        curve.append((x + half * across, spring + rise * bow))
    return sheet([(x - half, z[0]), (x + half, z[0]), *curve], y)


def arches(
    xs: Sequence[float],
    z: Interval,
    wide: float,
    y: Interval,
    pointed: bool = False,
    steps: int = 4,
) -> list[Mesh]:
    """A row of equal arches."""
    return [arch(x, z, wide, y, pointed, steps) for x in xs]


def columns(spots: Sequence[Spot], z: Interval, radius: float, sides: int = 8) -> list[Mesh]:
    """Round columns."""
    return [disc(radius, z, spot, sides) for spot in spots]


def row(low: float, high: float, count: int) -> list[float]:
    """``count`` places from one end to the other, both included."""
    return [low + (high - low) * k / max(count - 1, 1) for k in range(count)]


def steps(x: Interval, y: Interval, z: float, count: int = 3, sides: bool = False) -> list[Mesh]:
    """A flight that rises from the front end of ``y`` to its back end, to height ``z``."""
    tread, rise = (y[1] - y[0]) / count, z / count
    found = []
    for k in range(count):
        wide = k * tread if sides else 0.0
        found.append(
            block((x[0] + wide, x[1] - wide), (y[0], y[1] - k * tread), (k * rise, (k + 1) * rise))
        )
    return found


def pediment(x: Interval, y: Interval, z: Interval) -> Mesh:
    """A flat triangle over a portico."""
    return sheet([(x[0], z[0]), (x[1], z[0]), ((x[0] + x[1]) / 2, z[1])], y)


def rail(x: Interval, y: Interval, z: Interval, thick: float = 0.15) -> list[Mesh]:
    """A parapet round a rectangle."""
    return [
        block(x, (y[0], y[0] + thick), z),
        block(x, (y[1] - thick, y[1]), z),
        block((x[0], x[0] + thick), (y[0] + thick, y[1] - thick), z),
        block((x[1] - thick, x[1]), (y[0] + thick, y[1] - thick), z),
    ]
