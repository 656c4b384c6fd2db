"""Which houses stand together: real blocks as lists of sizes, and drawing one that is like a block.

Blocks are not of houses drawn one by one: some are rows of garages, some are three farms. So the
sizes of a block's houses are those of a real block of like area, share of street and count
(hot-deck imputation: Andridge and Little 2010), and houses of the library are fetched by size.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.domains.village.standing import Floats

SPREAD = (0.35, 0.25, 0.25)
"""How far the log of the area, the share of street and the log of the count of like blocks may be
off, about."""
GROWTH = 0.66
"""The power of the area by which counts grow."""
ALIKE = 0.15
"""How far the logs of area and stretch of houses fetched for a size may be off, about."""
SAME = 0.04
"""Logs of area and stretch within which two sizes of a block are one house of the library."""


class HouseMix(NamedTuple):
    """Real blocks (b, 3): log of the area in m², share of the outline that is street, number of
    houses; and the houses of all, block by block (n, 2): area in m², longer side by shorter."""

    blocks: Floats
    houses: Floats


EMPTY = HouseMix(np.zeros((0, 3)), np.zeros((0, 2)))


def draw_sizes(
    mix: HouseMix, area: float, street_share: float, count: int | None, rng: np.random.Generator
) -> Floats:
    """Sizes (n, 2), as :class:`HouseMix` has them, of the houses of a block: those of a real block
    like it, without repeating one before all are taken. ``count`` is how many; None: as many as
    that block has, for its area.

    >>> mix = HouseMix(np.array([[9.0, 0.3, 2.0]]), np.array([[80.0, 1.2], [20.0, 1.0]]))
    >>> sorted(draw_sizes(mix, 8000.0, 0.3, 4, np.random.default_rng(0))[:, 0].tolist())
    [20.0, 20.0, 80.0, 80.0]
    >>> len(draw_sizes(mix, np.exp(9.0), 0.3, None, np.random.default_rng(0)))
    2
    """
    logs = np.column_stack([mix.blocks[:, :2], np.log(mix.blocks[:, 2])])
    off = (logs - (np.log(area), street_share, np.log(max(count or 1, 1)))) / SPREAD
    away = (off[:, : 2 if count is None else 3] ** 2).sum(1)
    odds = np.exp(-0.5 * (away - away.min()))
    pick = int(rng.choice(len(odds), p=odds / odds.sum()))
    size = int(mix.blocks[pick, 2])
    if count is None:
        count = max(1, round(size * float(area / np.exp(mix.blocks[pick, 0])) ** GROWTH))
    end = int(mix.blocks[: pick + 1, 2].sum())
    order = [rng.permutation(size) for _ in range(max(1, -(-count // size)))]
    return np.asarray(mix.houses[end - size : end][np.concatenate(order)[:count]])


def fetch_houses(
    sizes: Floats, library: Floats, share: Floats, rng: np.random.Generator
) -> list[int]:
    """The number in a library (m, 2) of a house for each size (n, 2): of those about as large and
    long by their ``share`` (m,), the same one for sizes that are the same.

    >>> library = np.array([[20.0, 1.0], [80.0, 1.3]])
    >>> fetch_houses(np.array([[75.0, 1.2], [22.0, 1.1]]), library, np.ones(2),
    ...              np.random.default_rng(0))
    [1, 0]
    """
    logs, theirs = np.log(sizes), np.log(library)
    kept: dict[tuple[int, ...], int] = {}
    found = []
    for row in logs:
        key = tuple(np.floor(row / SAME).astype(int).tolist())
        if key not in kept:
            off = (((theirs - row) / ALIKE) ** 2).sum(1)
            odds = share * np.exp(-0.5 * (off - off.min()))
            kept[key] = int(rng.choice(len(odds), p=odds / odds.sum()))
        found.append(kept[key])
    return found
