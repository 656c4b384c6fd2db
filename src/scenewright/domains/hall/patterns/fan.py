"""Fan: T = {c, θ, (n_1 … n_M), (r_1 … r_M)} (Cao, Cheng, Zhang 2024).

Layer i is an arc of n_i objects at radius r_i within the sector angle θ, facing its apex, which
lies ahead: seats around a stage.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.measures import AISLE
from scenewright.domains.hall.patterns import ACROSS, ALONG, CODE, FAN, NUMBER, PART
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined

STAGE = 2.5
"""Least distance from the apex of a fan to its first row, in metres."""
ROW = 0.61
"""Least gap between two arcs, in metres: one gets through before those who sit."""
BLOCK = 16
"""Most objects of an arc between two aisles."""


def near_radius(number: float, area: float) -> float:
    """The least radius of a fan: half of the greatest where ``number`` objects of ``area`` square
    metres, gaps included, fill a sector of 1.5 rad, n A = 1.5 / 2 (R² - r²), R = 2 r; so the first
    row is no point.

    >>> round(near_radius(140, 0.68), 1), near_radius(6, 0.68)
    (6.5, 2.5)
    """
    return max(math.sqrt(number * area / 2.25), STAGE)


@inlined
def place_fan(
    layers: Floats,
    first: int,
    last: int,
    extra: float,
    sizes: Floats,  # noqa: ARG001
    start: int,  # noqa: ARG001
    out: Floats,
    at: int,
) -> int:
    """Write x, y and turn of every object, the apex at the origin, the rows behind it.

    ``extra`` is the angle of the sector, ``along`` of a layer the number of its aisles: they cut
    every arc into blocks alike.
    ``layers`` (L, 5), ``out`` (m, 3) written from row ``at``; metres and radians. Returns how
    many were placed.
    """
    i = 0
    for k in range(first, last):
        number, radius = int(layers[k, NUMBER]), layers[k, ACROSS]
        blocks = int(layers[k, ALONG]) + 1
        aisle = AISLE / radius
        step = (extra - (blocks - 1) * aisle) / number
        for j in range(number):
            turn = step * (j + 0.5) + aisle * (j * blocks // number) - 0.5 * extra
            out[at + i, 0] = radius * math.sin(turn)
            out[at + i, 1] = -radius * math.cos(turn)
            out[at + i, 2] = turn
            i += 1
    return i


@inlined
def fan_room(sector: float, radius: float, wide: float, aisles: int) -> int:
    """How many objects of some width fit on an arc whose inner edge has a radius."""
    return max(int((sector * radius - aisles * AISLE) / wide), 0)


@inlined
def seed_fan(
    layers: Floats,
    first: int,
    number: int,
    sector: float,
    near: float,
    wide: float,
    deep: float,
    along: float,
    across: float,
    part: int,
) -> int:
    """Write as few arcs as hold all objects, from radius ``near`` outwards, evenly filled.

    ``layers`` (L, 5), changed in place from row ``first`` on; metres and radians. Returns the
    layer after the last.
    """
    rows, room, pitch, aisles = 0, 0, deep + across, 0
    while (room < number or rows == 0) and rows < layers.shape[0] - first:
        rows, room = rows + 1, 0
        longest = fan_room(sector, near + (rows - 1) * pitch, wide + along, 0)
        aisles = max(-(-longest // BLOCK) - 1, 0)
        for k in range(rows):
            room += fan_room(sector, near + k * pitch, wide + along, aisles)
    left, total, k = number, max(room, 1), first
    for row in range(rows):
        fits = fan_room(sector, near + row * pitch, wide + along, aisles)
        count = left if row + 1 == rows else min(int(left * fits / total + 0.5), left)
        total = max(total - fits, 1)
        left -= count
        if count > 0:
            layers[k, NUMBER], layers[k, ALONG] = count, aisles
            layers[k, ACROSS] = near + row * pitch + 0.5 * deep
            layers[k, CODE], layers[k, PART] = FAN, part
            k += 1
    return k


@inlined
def fan_angle(layers: Floats, used: int, wide: float, deep: float, along: float) -> float:
    """The least sector in which the objects of every arc stand side by side.

    ``layers`` (L, 5), the first ``used`` of them; radians.
    """
    angle = 0.0
    for k in range(used):
        need = layers[k, NUMBER] * (wide + along) + layers[k, ALONG] * AISLE
        angle = max(angle, need / (layers[k, ACROSS] - 0.5 * deep))
    return angle


@inlined
def lay_fan(
    code: int,  # noqa: ARG001
    layers: Floats,
    number: int,
    shape: float,
    wide: float,
    deep: float,
    along: float,
    across: float,
    near: float,
) -> tuple[int, float]:
    """A sector of 63 to 153 degrees, no wider than its arcs need; its angle.

    See :func:`.chain.lay_chain` for ``layers`` (L, 5) and the measures, in metres.
    """
    sector = math.pi * (0.35 + 0.5 * shape)
    used = seed_fan(layers, 0, number, sector, near, wide, deep, along, across, 0)
    return used, min(fan_angle(layers, used, wide, deep, along) + 0.01, sector)
