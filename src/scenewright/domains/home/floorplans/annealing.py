"""Annealing the slicing trees of a storey."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.floorplans.slicing import (
    SIDE_BY_SIDE,
    STACKED,
    judge,
    place_rooms,
    propose,
)
from scenewright.engine.draws import streams, uniform
from scenewright.geometry.compiled import compiled

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]
STEPS = 4000
HOTTEST, COLDEST = 4.0, 0.02


class Storey(NamedTuple):
    """A storey to divide: ``parts`` (k, 4) rectangles, the rooms ``within`` each at first, the
    areas ``wanted`` (n,), the ``rooms`` (n, 5), ``joins`` (n, 2) and ``lit_sides`` (4,) of
    :func:`~.slicing.judge`. A part with one room is that room and stays so."""

    parts: Floats
    within: tuple[tuple[int, ...], ...]
    wanted: Floats
    rooms: Floats
    joins: Whole
    lit_sides: Floats


@compiled
def copy_tree(tokens: Whole, weights: Floats, to_tokens: Whole, to_weights: Floats) -> None:
    """Copy trees (k, m) and weights (n,)."""
    for p in range(tokens.shape[0]):
        for i in range(tokens.shape[1]):
            to_tokens[p, i] = tokens[p, i]
    for k in range(len(weights)):
        to_weights[k] = weights[k]


@compiled
def _anneal(
    parts: Floats,
    tokens: Whole,
    lengths: Whole,
    weights: Floats,
    wanted: Floats,
    rooms: Floats,
    joins: Whole,
    lit_sides: Floats,
    kept: tuple[Whole, Floats, Floats],
    scratch: tuple[Floats, Floats, Floats, Floats],
    steps: int,
    stream: NDArray[np.uint64],
) -> float:
    """Metropolis' walk while the temperature falls; ``kept`` gets the trees, weights and boxes of
    the best plan; returns what that breaks."""
    kept_tokens, kept_weights, best = kept
    nodes, boxes, contacts, sides = scratch
    free = 0
    while free < len(lengths) and lengths[free] > 1:
        free += 1
    lowest, least = 1e9, 1e9
    cost = 1e9
    cooling = (COLDEST / HOTTEST) ** (1.0 / steps)
    heat = HOTTEST
    copy_tree(tokens, weights, kept_tokens, kept_weights)
    for _ in range(steps):
        if free:
            propose(tokens, lengths[:free], weights, wanted, stream)
        place_rooms(parts, tokens, lengths, weights, nodes, boxes)
        now, broken = judge(boxes, wanted, rooms, joins, lit_sides, contacts, sides)
        if now <= cost or uniform(stream) < np.exp((cost - now) / heat):
            cost = now
            copy_tree(tokens, weights, kept_tokens, kept_weights)
            if now < lowest:
                lowest, least = now, broken
                for k in range(len(boxes)):
                    for c in range(4):
                        best[k, c] = boxes[k, c]
        else:
            copy_tree(kept_tokens, kept_weights, tokens, weights)
        heat *= cooling
    return least


def divide(storey: Storey, seed: int, steps: int = STEPS) -> tuple[Floats, float]:
    """The rooms (n, 4) of a storey on the middle lines of its walls, x0, y0, x1, y1, and what of
    the rules they break: 0 for a plan that can be lived in. Parts with a tree of several rooms
    come first in ``storey.parts``.

    >>> rooms = np.array([[2.0, 2, 1, 0, 0], [2.0, 2, 1, 0, 0]])
    >>> joins = np.full((2, 2), -1)
    >>> storey = Storey(np.array([[0.0, 0, 8, 4]]), ((0, 1),), np.array([16.0, 16]), rooms, joins,
    ...     np.ones(4))
    >>> boxes, broken = divide(storey, 0, 200)
    >>> broken, round(float(np.prod(boxes[:, 2:] - boxes[:, :2], axis=1).sum()), 6)
    (0.0, 32.0)
    """
    count, longest = len(storey.wanted), 2 * max(map(len, storey.within)) - 1
    tokens = np.full((len(storey.parts), longest), SIDE_BY_SIDE)
    for row, members in zip(tokens, storey.within, strict=True):
        row[0] = members[0]
        for k, room in enumerate(members[1:]):
            row[1 + 2 * k : 3 + 2 * k] = room, (SIDE_BY_SIDE, STACKED)[k % 2]
    lengths = np.array([2 * len(members) - 1 for members in storey.within])
    boxes, weights = np.zeros((count, 4)), storey.wanted.copy()
    kept = (tokens.copy(), weights.copy(), np.zeros((count, 4)))
    scratch = (np.zeros((longest, 7)), boxes, np.zeros((count, count)), np.zeros((count, 4)))
    broken = _anneal(
        storey.parts,
        tokens,
        lengths,
        weights,
        storey.wanted,
        storey.rooms,
        storey.joins,
        storey.lit_sides,
        kept,
        scratch,
        steps,
        streams(seed, 1)[0],
    )
    return kept[2], broken
