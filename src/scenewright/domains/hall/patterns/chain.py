"""Chain: T = {c, (n_1 … n_M), (rw_1 … rw_M), (rh_1 … rh_M)} (Cao, Cheng, Zhang 2024).

Layer i is a row of n_i objects with gaps rw_i between them, rh_i behind the row before. Ours: where
a unit has an extra measure, aisles of that width divide rows of more than :data:`BLOCK` objects.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, CODE, NUMBER, PART
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined

BLOCK = 14
"""Most seats of a row between two aisles: for more the International Building Code (2021,
1030.13.2.1) wants the rows farther apart; the German MVStättVO (§ 10) allows 20."""


@inlined
def place_chain(
    layers: Floats,
    first: int,
    last: int,
    extra: float,
    sizes: Floats,
    start: int,
    out: Floats,
    at: int,
) -> int:
    """Write x (right), y (ahead) and turn of every object, middles of the rows at x = 0.

    Layers ``first`` to ``last`` - 1 of ``layers`` (L, 5); ``extra`` is the width of the
    aisles (0: none). Objects from ``start`` in ``sizes`` (n, 2), from ``at`` in ``out`` (m, 3).
    Returns how many were placed.
    """
    i, y = 0, 0.0
    for k in range(first, last):
        number, gap = int(layers[k, NUMBER]), layers[k, ALONG]
        blocks = -(-number // BLOCK) if extra > 0.0 else 1
        wide, deep = (blocks - 1) * extra - gap, 0.0
        for j in range(number):
            wide += sizes[start + i + j, 0] + gap
            deep = max(deep, sizes[start + i + j, 1])
        y -= (layers[k, ACROSS] if k > first else 0.0) + 0.5 * deep
        x = -0.5 * wide
        for j in range(number):
            half = 0.5 * sizes[start + i + j, 0]
            if j > 0 and j * blocks // number > (j - 1) * blocks // number:
                x += extra
            out[at + i + j, 0], out[at + i + j, 1], out[at + i + j, 2] = x + half, y, 0.0
            x += 2.0 * half + gap
        y -= 0.5 * deep
        i += number
    return i


@inlined
def seed_chain(
    layers: Floats, first: int, number: int, rows: int, along: float, across: float, part: int
) -> int:
    """Write ``rows`` rows that share ``number`` objects; returns the layer after the last.

    ``layers`` (L, 5), changed in place from row ``first`` on; gaps in metres.
    """
    rows = max(min(rows, number, layers.shape[0] - first), 1)
    for k in range(rows):
        layers[first + k, NUMBER] = number // rows + (1 if k < number % rows else 0)
        layers[first + k, ALONG], layers[first + k, ACROSS] = along, across
        layers[first + k, CODE], layers[first + k, PART] = CHAIN, part
    return first + rows


@inlined
def even_rows(rows: int, number: int) -> int:
    """The nearest number of rows, at most two away, that all get equally many objects."""
    for off in range(3):
        for found in (rows - off, rows + off):
            if 0 < found <= number and number % found == 0:
                return found
    return rows


@inlined
def count_rows(
    number: int, shape: float, wide: float, deep: float, along: float, across: float
) -> int:
    """How many rows ``shape`` in [0, 1) asks for: from one to two and a half times as deep as
    wide; metres."""
    most = max(int(math.sqrt(2.5 * number * (wide + along) / (deep + across))), 2)
    return even_rows(1 + int(shape * min(number, most)), number)


@inlined
def lay_chain(
    code: int,  # noqa: ARG001
    layers: Floats,
    number: int,
    shape: float,
    wide: float,
    deep: float,
    along: float,
    across: float,
    near: float,  # noqa: ARG001
) -> tuple[int, float]:
    """Write the layers of a unit of ``number`` objects; how many, and its extra measure.

    ``code`` is that of the pattern, ``layers`` (L, 5) are changed in place. ``shape`` in [0, 1)
    chooses among forms: few or many rows, rings, sector angles. ``wide`` and ``deep`` are the
    largest object, ``along`` and ``across`` the gaps, ``near`` the least radius of a fan; metres.
    """
    rows = count_rows(number, shape, wide, deep, along, across)
    return seed_chain(layers, 0, number, rows, along, across, 0), 0.0
