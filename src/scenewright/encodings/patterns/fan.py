"""Fan: T = {c, θ, (n_1 … n_M), (r_1 … r_M)} (Cao, Cheng, Zhang 2024).

Layer i is an arc of n_i objects at radius r_i within the sector angle θ, facing its apex, which
lies ahead: seats around a stage.
"""

from __future__ import annotations

import math

from scenewright.encodings.patterns import ACROSS, ALONG, CODE, FAN, NUMBER, PART
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined


@inlined
def place_fan(
    layers: Floats, first: int, last: int, sector: float, out: Floats, at: int
) -> int:
    """Write x, y and turn of every object, the apex at the origin, the rows behind it."""
    i = 0
    for k in range(first, last):
        number, radius = int(layers[k, NUMBER]), layers[k, ACROSS]
        for j in range(number):
            turn = sector * ((j + 0.5) / number - 0.5)
            out[at + i, 0] = radius * math.sin(turn)
            out[at + i, 1] = -radius * math.cos(turn)
            out[at + i, 2] = turn
            i += 1
    return i


@inlined
def seed_fan(
    layers: Floats, first: int, number: int, sector: float, near: float, wide: float, deep: float,
    along: float, across: float, part: int,
) -> int:  # fmt: skip
    """Write arcs from radius ``near`` outwards, each as full as the sector allows."""
    k, left, radius = first, number, near + 0.5 * deep
    while left > 0 and k < layers.shape[0]:
        inner = radius - 0.5 * deep
        count = max(int(sector * inner / (wide + along)), 1)
        count = left if k + 1 == layers.shape[0] else min(count, left)
        if 0 < left - count < max(count // 3, 1):
            radius += 0.05 * (wide + along)
            continue
        layers[k, NUMBER], layers[k, ALONG], layers[k, ACROSS] = count, along, radius
        layers[k, CODE], layers[k, PART] = FAN, part
        radius += deep + across
        k, left = k + 1, left - count
    return k
