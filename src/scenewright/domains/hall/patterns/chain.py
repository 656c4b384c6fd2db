"""Chain: T = {c, (n_1 … n_M), (rw_1 … rw_M), (rh_1 … rh_M)} (Cao, Cheng, Zhang 2024).

Layer i is a row of n_i objects with gaps rw_i between them, rh_i behind the row before.
"""

from __future__ import annotations

from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, CODE, NUMBER, PART
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined


@inlined
def place_chain(
    layers: Floats, first: int, last: int, sizes: Floats, start: int, out: Floats, at: int
) -> int:
    """Write x (right), y (ahead) and turn of every object, middles of the rows at x = 0.

    Layers ``first`` to ``last`` - 1; objects from ``start`` in ``sizes`` (n, 2), from ``at`` in
    ``out`` (m, 3). Returns how many were placed.
    """
    i, y = 0, 0.0
    for k in range(first, last):
        number, gap = int(layers[k, NUMBER]), layers[k, ALONG]
        wide, deep = -gap, 0.0
        for j in range(number):
            wide += sizes[start + i + j, 0] + gap
            deep = max(deep, sizes[start + i + j, 1])
        y -= (layers[k, ACROSS] if k > first else 0.0) + 0.5 * deep
        x = -0.5 * wide
        for j in range(number):
            half = 0.5 * sizes[start + i + j, 0]
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
