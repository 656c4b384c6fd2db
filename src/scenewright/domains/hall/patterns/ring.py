"""Circulation (ring): T = {c, (n_1 … n_M), (r_1 … r_M)} (Cao, Cheng, Zhang 2024).

Layer i is a ring of n_i objects side by side at radius r_i, facing out; it uses floor well. The
paper gives it the same parameters as radiation and tells them apart by use; here the objects of a
ring close up, and ``along`` metres of each ring stay open at its front, to get inside.
"""

from __future__ import annotations

import math

from scenewright.domains.hall.patterns import ACROSS, ALONG, CIRCULATION, CODE, NUMBER, PART
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined


@inlined
def place_circulation(
    layers: Floats,
    first: int,
    last: int,
    extra: float,  # noqa: ARG001
    sizes: Floats,  # noqa: ARG001
    start: int,  # noqa: ARG001
    out: Floats,
    at: int,
) -> int:
    """Write x, y and turn of every object, the centre at the origin, the opening ahead.

    ``layers`` (L, 5), ``out`` (m, 3) written from row ``at``; metres and radians. Returns how
    many were placed.
    """
    i = 0
    for k in range(first, last):
        number, radius = int(layers[k, NUMBER]), layers[k, ACROSS]
        gap = min(layers[k, ALONG] / max(radius, 0.1), math.pi)
        step = (2.0 * math.pi - gap) / number
        for j in range(number):
            turn = 0.5 * gap + step * (j + 0.5)
            out[at + i, 0] = -radius * math.sin(turn)
            out[at + i, 1] = radius * math.cos(turn)
            out[at + i, 2] = turn
            i += 1
    return i


@inlined
def ring_radius(number: int, wide: float, deep: float, opening: float) -> float:
    """The least radius, to 0.02 m, of a ring with an opening whose inner corners do not meet."""
    half = math.pi / number
    radius = 0.5 * wide / math.tan(half) + 0.5 * deep
    while opening > 0.0:
        half = (math.pi - min(0.5 * opening / radius, 0.5 * math.pi)) / number
        if (radius - 0.5 * deep) * math.tan(half) >= 0.5 * wide:
            break
        radius += 0.02
    return radius


@inlined
def seed_circulation(
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
    """Write ``rings`` rings (each with at least 3 objects), radii as small as the backs allow.

    Inner corners of neighbours touch where (r - d / 2) tan(step / 2) = w / 2; several rings are
    open by twice the gap across, so that one can walk in between them. ``layers`` (L, 5),
    changed in place from row ``first`` on; metres. Returns the layer after the last.
    """
    rings = max(min(rings, number // 3, layers.shape[0] - first), 1)
    opening = max(2.0 * across, 1.2) if rings > 1 else 0.0
    left, radius = number, 0.0
    for k in range(rings):
        ahead = rings - k
        share = (k + 1) / (ahead * (k + 1 + 0.5 * ahead))
        count = left if ahead == 1 else max(int(left * share), 3)
        needed = ring_radius(max(count, 3), wide + along, deep, opening)
        radius = max(radius + deep + 2.0 * across if k > 0 else 0.0, needed + 0.002)
        layers[first + k, NUMBER], layers[first + k, ALONG] = count, opening
        layers[first + k, ACROSS] = radius
        layers[first + k, CODE], layers[first + k, PART] = CIRCULATION, part
        left -= count
    return first + rings


@inlined
def lay_circulation(
    code: int,  # noqa: ARG001
    layers: Floats,
    number: int,
    shape: float,
    wide: float,
    deep: float,
    along: float,  # noqa: ARG001
    across: float,
    near: float,  # noqa: ARG001
) -> tuple[int, float]:
    """One to three rings, mostly one; their objects close up.

    See :func:`.chain.lay_chain` for ``layers`` (L, 5) and the measures, in metres.
    """
    rings = 1 + int(shape * shape * 3.0)
    return seed_circulation(layers, 0, number, rings, wide, deep, 0.005, across, 0), 0.0
