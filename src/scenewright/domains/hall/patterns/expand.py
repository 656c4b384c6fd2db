"""From the layers of a unit to the boxes of its objects, and back to layers that make sense."""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import (
    CHAIN,
    CIRCULATION,
    CODE,
    FAN,
    GRID,
    MIXTURE,
    PART,
    RADIATION,
    SINGLE,
    WALL,
)
from scenewright.domains.hall.patterns.chain import place_chain, seed_chain
from scenewright.domains.hall.patterns.fan import fan_angle, place_fan, seed_fan
from scenewright.domains.hall.patterns.grid import place_grid, seed_grid
from scenewright.domains.hall.patterns.mixture import seed_mixture, seed_single
from scenewright.domains.hall.patterns.radiation import place_radiation, seed_radiation
from scenewright.domains.hall.patterns.ring import place_circulation, seed_circulation
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import compiled, inlined


@inlined
def place_part(
    layers: Floats,
    first: int,
    last: int,
    sector: float,
    sizes: Floats,
    start: int,
    out: Floats,
    at: int,
) -> int:
    """Place the layers of one part by their pattern; how many objects it has.

    ``layers`` (L, 5), ``sizes`` (n, 2) width and depth from row ``start``, ``out`` (m, 3)
    written from row ``at``; metres and radians.
    """
    code = int(layers[first, CODE])
    if code == GRID:
        return place_grid(layers, first, last, sizes, start, out, at)
    if code == RADIATION:
        return place_radiation(layers, first, last, out, at)
    if code == CIRCULATION:
        return place_circulation(layers, first, last, out, at)
    if code == FAN:
        return place_fan(layers, first, last, sector, out, at)
    return place_chain(layers, first, last, sizes, start, out, at)


@inlined
def shift_to(
    out: Floats, at: int, end: int, sizes: Floats, start: int, left: float, centred: bool
) -> float:
    """Move objects so that their bounds start at x = ``left`` (or are centred on x) and are
    centred on y; the width of the bounds.

    ``out`` (m, 3) rows ``at`` to ``end`` - 1, changed in place; ``sizes`` (n, 2) in metres from
    row ``start``.
    """
    x0, x1, y0, y1 = math.inf, -math.inf, math.inf, -math.inf
    for i in range(at, end):
        c, s = abs(math.cos(out[i, 2])), abs(math.sin(out[i, 2]))
        w, d = 0.5 * sizes[start + i - at, 0], 0.5 * sizes[start + i - at, 1]
        x0, x1 = min(x0, out[i, 0] - c * w - s * d), max(x1, out[i, 0] + c * w + s * d)
        y0, y1 = min(y0, out[i, 1] - s * w - c * d), max(y1, out[i, 1] + s * w + c * d)
    dx = -0.5 * (x0 + x1) if centred else left - x0
    for i in range(at, end):
        out[i, 0] += dx
        out[i, 1] -= 0.5 * (y0 + y1)
    return x1 - x0


@compiled
def expand(code: int, layers: Floats, extra: float, sizes: Floats, start: int, out: Floats) -> int:
    """Write x (right), y (ahead) and turn of a unit's objects in its own frame to ``out``.

    ``layers`` are the used ones; ``extra`` is the angle of a fan or the gap of a mixture. The
    origin is the middle of the bounds, for rings their centre. Not for wall rows. ``layers`` (k,
    5), ``sizes`` (n, 2) width and depth in metres from row ``start``, ``out`` (m, 3) from row 0;
    returns how many were placed.
    """
    used, first, i, left = layers.shape[0], 0, 0, 0.0
    while first < used:
        last = first + 1
        while last < used and layers[last, PART] == layers[first, PART]:
            last += 1
        placed = place_part(layers, first, last, extra, sizes, start + i, out, i)
        if code == MIXTURE:
            left += extra + shift_to(out, i, i + placed, sizes, start + i, left, False)
        i, first = i + placed, last
    if code not in (RADIATION, CIRCULATION):
        shift_to(out, 0, i, sizes, start, 0.0, True)
    return i


@inlined
def even_rows(rows: int, number: int) -> int:
    """The nearest number of rows, at most two away, that all get equally many objects."""
    for off in range(3):
        for found in (rows - off, rows + off):
            if 0 < found <= number and number % found == 0:
                return found
    return rows


@compiled
def seed(
    code: int,
    number: int,
    shape: float,
    wide: float,
    deep: float,
    along: float,
    across: float,
    near: float,
    layers: Floats,
) -> tuple[int, float]:
    """Write layers for ``number`` objects; how many layers, and the unit's extra measure.

    ``shape`` in [0, 1) chooses among forms: few or many rows, rings, sector angles. ``wide`` and
    ``deep`` are the largest object, ``along`` and ``across`` the gaps, ``near`` the least radius
    of a fan.
    """
    most = max(int(math.sqrt(2.5 * number * (wide + along) / (deep + across))), 2)
    rows = even_rows(1 + int(shape * min(number, most)), number)
    if code in (SINGLE, WALL):
        return seed_single(layers, 0, number), 0.0
    if code == GRID:
        return seed_grid(layers, 0, number, rows, along, across, 0), 0.0
    if code == RADIATION:
        rings = 1 + int(shape * 3.0)
        return seed_radiation(layers, 0, number, rings, wide, deep, along, across, 0), 0.0
    if code == CIRCULATION:
        rings = 1 + int(shape * shape * 3.0)
        return seed_circulation(layers, 0, number, rings, wide, deep, 0.005, across, 0), 0.0
    if code == FAN:
        sector = math.pi * (0.35 + 0.5 * shape)
        used = seed_fan(layers, 0, number, sector, near, wide, deep, along, across, 0)
        return used, min(fan_angle(layers, used, wide, deep, along) + 0.01, sector)
    if code == MIXTURE:
        rows = 1 + int(shape * 3.0)
        return seed_mixture(layers, 0, number, rows, wide, deep, along, across), 2.0 * across
    return seed_chain(layers, 0, number, rows, along, across, 0), 0.0


@compiled
def stretch(code: int, layers: Floats, extra: float, along: float, across: float) -> float:
    """Expand (positive) or shrink a pattern in place by metres along its rows and across them;
    the new extra measure.

    Rows change their gaps, rings and arcs their radii, further out the more. ``layers`` (k, 5)
    is changed in place.
    """
    rank = 0
    for k in range(layers.shape[0]):
        kind = int(layers[k, CODE])
        rank = rank + 1 if k > 0 and layers[k, PART] == layers[k - 1, PART] else 1
        if kind in (CHAIN, GRID):
            layers[k, 1] = max(layers[k, 1] + along, 0.0)
            layers[k, 2] = max(layers[k, 2] + across, 0.0)
        elif layers[k, 2] > 0.0:
            layers[k, 2] = max(layers[k, 2] + across * rank, 0.3)
    if code == FAN:
        return min(max(extra + 0.1 * along, 0.3), 0.95 * math.pi)
    return max(extra + along, 0.0) if code == MIXTURE else extra
