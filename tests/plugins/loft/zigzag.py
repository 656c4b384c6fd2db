"""A pattern: one row whose objects stand ahead and behind by turns."""

from __future__ import annotations

from scenewright.domains.hall.patterns import ACROSS, ALONG, CODE, NUMBER, PART, PatternRow
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined

STEP = 0.4
"""Metres ahead."""


@inlined
def place(
    layers: Floats,
    first: int,
    last: int,
    extra: float,
    sizes: Floats,
    start: int,
    out: Floats,
    at: int,
) -> int:
    """Objects side by side, every other one ``STEP`` ahead."""
    i, x = 0, 0.0
    for k in range(first, last):
        for j in range(int(layers[k, NUMBER])):
            half = 0.5 * sizes[start + i, 0]
            out[at + i, 0], out[at + i, 1], out[at + i, 2] = x + half, STEP * (j % 2), 0.0
            x += 2.0 * half + layers[k, ALONG]
            i += 1
    return i


@inlined
def lay(
    code: int,
    layers: Floats,
    number: int,
    shape: float,
    wide: float,
    deep: float,
    along: float,
    across: float,
    near: float,
) -> tuple[int, float]:
    """One layer."""
    layers[0, NUMBER], layers[0, ALONG], layers[0, ACROSS] = number, along, across
    layers[0, CODE], layers[0, PART] = code, 0
    return 1, 0.0


ROW = PatternRow(
    "zigzag",
    "one row, ahead and behind by turns",
    "plinths along a way",
    "loft",
    place=f"{__name__}:place",
    layout=f"{__name__}:lay",
)
