"""Around: seats that look at each other over a low table, in fours and smaller companies. Ours.

Layer i is a company of n_i seats: half of them left and half right of the table, two by two, of
three the last one behind it; the front stays open to come in by. Companies stand side by side.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import ACROSS, ALONG, AROUND, CODE, NUMBER, PART
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined

COMPANY = 4
"""Most seats round one table, where the layers are enough."""
KNEES = 0.75
"""From the middle of the table to the front of a seat, in metres: a table of 0.6 m and 0.45 m to
sit down in."""
CORNERS = 0.6 / math.sqrt(2.0)
"""Between the corners of seats at right angles, along the side of either, in metres."""
BETWEEN = 1.2
"""Gap of two companies, in metres."""
BESIDE = 0.01
"""Gap of two seats of a side, in metres."""


@inlined
def place_around(
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
    i, x = 0, 0.0
    for k in range(first, last):
        number, far = int(layers[k, NUMBER]), layers[k, ACROSS]
        wide, deep = 0.0, 0.0
        for j in range(start + i, start + i + number):
            wide, deep = max(wide, sizes[j, 0]), max(deep, sizes[j, 1])
        reach = far + 0.5 * deep
        x += layers[k, ALONG] + reach if k > first else 0.0
        pairs = number // 2 if number == 3 else (number + 1) // 2
        for j in range(number):
            side = 1.0 if j % 2 == 1 else -1.0
            out[at + i, 0] = x + side * far
            out[at + i, 1] = (j // 2 - 0.5 * (pairs - 1)) * (wide + BESIDE)
            out[at + i, 2] = side * 0.5 * math.pi
            if number == 3 and j == 2:
                out[at + i, 0], out[at + i, 1], out[at + i, 2] = x, -far, 0.0
            i += 1
        x += reach
    return i


@inlined
def seed_around(
    layers: Floats, first: int, number: int, wide: float, deep: float, across: float, part: int
) -> int:
    """Write companies as equal as can be; corners of seats at right angles stay 0.6 m apart, and
    what is free before seats, ``across`` metres, is shared by none.

    ``layers`` (L, 5), changed in place from row ``first`` on; metres. Returns the layer after the
    last.
    """
    rows = max(min(-(-number // COMPANY), layers.shape[0] - first), 1)
    far = max(KNEES, 0.5 * wide + max(CORNERS, across)) + 0.5 * deep
    along = max(2.0 * across, BETWEEN)
    k, left = first, number
    for row in range(rows):
        count = -(-left // (rows - row))
        layers[k, NUMBER], layers[k, ALONG], layers[k, ACROSS] = count, along, far
        layers[k, CODE], layers[k, PART] = AROUND, part
        left -= count
        k += 1
    return k


@inlined
def lay_around(
    code: int,  # noqa: ARG001
    layers: Floats,
    number: int,
    shape: float,  # noqa: ARG001
    wide: float,
    deep: float,
    along: float,  # noqa: ARG001
    across: float,
    near: float,  # noqa: ARG001
) -> tuple[int, float]:
    """Write the companies of a unit; see :func:`.chain.lay_chain`.

    ``layers`` (L, 5).
    """
    return seed_around(layers, 0, number, wide, deep, across, 0), 0.0
