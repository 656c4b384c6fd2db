"""Radiation: T = {c, (n_1 … n_M), (r_1 … r_M)} (Cao, Cheng, Zhang 2024).

Layer i is a regular polygon of n_i objects at radius r_i, facing out; n_1 = 1, r_1 = 0 is one
object in the centre. Needs open floor; shows off a centrepiece.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import ACROSS, ALONG, CODE, NUMBER, PART, RADIATION
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined


@inlined
def place_radiation(
    layers: Floats,
    first: int,
    last: int,
    extra: float,  # noqa: ARG001
    sizes: Floats,  # noqa: ARG001
    start: int,  # noqa: ARG001
    out: Floats,
    at: int,
) -> int:
    """Write x, y and turn of every object, the centre at the origin, the first one ahead.

    Every other ring starts half a step further, so that nobody stands behind another. ``layers``
    (L, 5), ``out`` (m, 3) written from row ``at``; metres and radians. Returns how many were
    placed.
    """
    i = 0
    for k in range(first, last):
        number, radius = int(layers[k, NUMBER]), layers[k, ACROSS]
        step = 2.0 * math.pi / number
        for j in range(number):
            turn = step * (j + 0.5 * ((k - first) % 2)) if radius > 0.0 else 0.0
            out[at + i, 0] = -radius * math.sin(turn)
            out[at + i, 1] = radius * math.cos(turn)
            out[at + i, 2] = turn
            i += 1
    return i


@inlined
def seed_radiation(
    layers: Floats,
    first: int,
    number: int,
    rings: int,
    wide: float,
    deep: float,
    along: float,
    across: float,
    part: int,
) -> int:
    """Write a centre (if the number is odd) and ``rings`` rings, the outer ones fuller.

    ``layers`` (L, 5), changed in place from row ``first`` on; metres. Returns the layer after
    the last.
    """
    k, left, radius = first, number, 0.0
    if number < 3 or (number % 2 == 1 and number > 4):
        layers[k, NUMBER], layers[k, ALONG], layers[k, ACROSS] = 1, 0.0, 0.0
        layers[k, CODE], layers[k, PART] = RADIATION, part
        k, left, radius = k + 1, left - 1, 0.5 * deep
    rings = max(min(rings, left // 6, layers.shape[0] - k), 1)
    for ring in range(rings):
        shares = 0.5 * (rings * (rings + 1) - ring * (ring + 1))
        count = int(left * (ring + 1) / shares + 0.5)
        step = math.pi / max(count, 2)
        needed = max(0.5 * (wide + along) / math.sin(step), 0.5 * (wide / math.tan(step) + deep))
        radius = max(radius + 0.5 * deep + across, needed)
        if count > 0:
            layers[k, NUMBER], layers[k, ALONG], layers[k, ACROSS] = count, along, radius
            layers[k, CODE], layers[k, PART] = RADIATION, part
            k, left, radius = k + 1, left - count, radius + 0.5 * deep
    return k


@inlined
def lay_radiation(
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
    """One to three rings.

    See :func:`.chain.lay_chain` for ``layers`` (L, 5) and the measures, in metres.
    """
    rings = 1 + int(shape * 3.0)
    return seed_radiation(layers, 0, number, rings, wide, deep, along, across, 0), 0.0
