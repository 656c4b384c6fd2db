"""Mixture: T = {T_1 … T_M}, any patterns side by side (Cao, Cheng, Zhang 2024).

The parts stand left to right, ``gap`` metres apart, their middles on one line. Seeded as the
paper draws it: a radiation between two chains.
"""

from __future__ import annotations

from scenewright.domains.hall.patterns import ALONG, CHAIN, CODE, NUMBER, PART
from scenewright.domains.hall.patterns.chain import seed_chain
from scenewright.domains.hall.patterns.radiation import seed_radiation
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import inlined


@inlined
def seed_mixture(
    layers: Floats,
    first: int,
    number: int,
    rows: int,
    wide: float,
    deep: float,
    along: float,
    across: float,
) -> int:
    """Write two chains of a third of the objects each and a radiation between them; of fewer
    than six objects a chain.

    ``layers`` (L, 5), changed in place from row ``first`` on; metres. Returns the layer after
    the last.
    """
    if number < 6 or layers.shape[0] - first < 6:
        return seed_chain(layers, first, number, rows, along, across, 0)
    side = number // 3
    rows = min(rows, (layers.shape[0] - first - 2) // 2)
    k = seed_chain(layers, first, side, rows, along, across, 0)
    k = seed_radiation(layers, k, number - 2 * side, 1, wide, deep, along, across, 1)
    return seed_chain(layers, k, side, rows, along, across, 2)


@inlined
def seed_single(layers: Floats, first: int, number: int) -> int:
    """Write one layer for a single object.

    ``layers`` (L, 5), row ``first``; returns the layer after it.
    """
    layers[first, NUMBER], layers[first, ALONG] = number, 0.0
    layers[first, CODE], layers[first, PART] = CHAIN, 0
    return first + 1


@inlined
def lay_mixture(
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
    """Two chains of one to three rows and a radiation; the gap between parts.

    See :func:`.chain.lay_chain` for ``layers`` (L, 5) and the measures, in metres.
    """
    rows = 1 + int(shape * 3.0)
    return seed_mixture(layers, 0, number, rows, wide, deep, along, across), 2.0 * across


@inlined
def lay_single(
    code: int,  # noqa: ARG001
    layers: Floats,
    number: int,
    shape: float,  # noqa: ARG001
    wide: float,  # noqa: ARG001
    deep: float,  # noqa: ARG001
    along: float,  # noqa: ARG001
    across: float,  # noqa: ARG001
    near: float,  # noqa: ARG001
) -> tuple[int, float]:
    """One layer, of one object or of a row at a wall.

    See :func:`.chain.lay_chain` for ``layers`` (L, 5) and the measures, in metres.
    """
    return seed_single(layers, 0, number), 0.0
