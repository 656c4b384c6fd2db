"""Grid: rows and columns of equal pitch, aligned both ways. Ours.

Layer i is a row of n_i objects; the pitch across a row is the widest object and the gap, between
rows the deepest object and the gap, so unequal objects still line up by their middles.
"""

from __future__ import annotations

from scenewright.domains.hall.patterns import ACROSS, ALONG, CODE, GRID, NUMBER, PART
from scenewright.domains.hall.patterns.chain import count_rows
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined


@inlined
def place_grid(
    layers: Floats,
    first: int,
    last: int,
    extra: float,  # noqa: ARG001
    sizes: Floats,
    start: int,
    out: Floats,
    at: int,
) -> int:
    """Write x, y and turn of every object; see :func:`.chain.place_chain`.

    ``layers`` (L, 5), ``sizes`` (n, 2) in metres from row ``start``, ``out`` (m, 3) from row
    ``at``.
    """
    number, columns = 0, 0
    for k in range(first, last):
        number += int(layers[k, NUMBER])
        columns = max(columns, int(layers[k, NUMBER]))
    wide, deep = 0.0, 0.0
    for j in range(start, start + number):
        wide, deep = max(wide, sizes[j, 0]), max(deep, sizes[j, 1])
    i, y = 0, 0.0
    for k in range(first, last):
        y -= deep + layers[k, ACROSS] if k > first else 0.5 * deep
        for j in range(int(layers[k, NUMBER])):
            out[at + i, 0] = (j - 0.5 * (columns - 1)) * (wide + layers[k, ALONG])
            out[at + i, 1], out[at + i, 2] = y, 0.0
            i += 1
    return i


@inlined
def seed_grid(
    layers: Floats, first: int, number: int, rows: int, along: float, across: float, part: int
) -> int:
    """Write rows of equal length, the last shorter; returns the layer after the last.

    ``layers`` (L, 5), changed in place from row ``first`` on; gaps in metres.
    """
    rows = max(min(rows, number, layers.shape[0] - first), 1)
    columns = -(-number // rows)
    k, left = first, number
    while left > 0:
        layers[k, NUMBER] = min(columns, left)
        layers[k, ALONG], layers[k, ACROSS] = along, across
        layers[k, CODE], layers[k, PART] = GRID, part
        left -= columns
        k += 1
    return k


@inlined
def lay_grid(
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
    """Rows of equal length.

    See :func:`.chain.lay_chain` for ``layers`` (L, 5) and the measures, in metres.
    """
    rows = count_rows(number, shape, wide, deep, along, across)
    return seed_grid(layers, 0, number, rows, along, across, 0), 0.0
