"""One annealing chain's layout with every part of its energy kept, so a move costs little.

Moving item i recomputes its box cost, its row of pairs and its relations; sums change by the
differences. The sums are written once, here; terms know nothing of chains.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import compiled, compiled_entry
from scenewright.terms.assemble import (
    Prepared,
    box_cost,
    measure,
    pair_cost,
    relation_cost,
    whole_cost,
)


class Chain(NamedTuple):
    """Frames (n, 8) and the costs of boxes (n, 4), pairs (n, n), relations (r,); ``sums`` (2, 4)
    and ``row`` (n,), ``fresh`` (r,), ``cost`` (4,) hold the sums and parts: row 0 as they are, row 1
    and the rest as they would be after the move last tried."""

    frames: Floats
    boxes: Floats
    pairs: Floats
    relations: Floats
    sums: Floats
    row: Floats
    fresh: Floats
    cost: Floats


@compiled_entry
def make_chain(n: int, relations: int) -> Chain:
    """Room for a chain of ``n`` items."""
    return Chain(
        np.zeros((n, 8)), np.zeros((n, 4)), np.zeros((n, n)), np.zeros(relations),
        np.zeros((2, 4)), np.zeros(n), np.zeros(relations), np.zeros(4),
    )  # fmt: skip


@compiled
def write_frame(frames: Floats, i: int, frame: Frame) -> None:
    """Set row ``i`` of frames (n, 8)."""
    frames[i, 0], frames[i, 1], frames[i, 2], frames[i, 3] = frame[0], frame[1], frame[2], frame[3]
    frames[i, 4], frames[i, 5], frames[i, 6], frames[i, 7] = frame[4], frame[5], frame[6], frame[7]


@compiled
def copy_rows(into: Floats, source: Floats) -> None:
    """Copy one (n, k) array over another."""
    for i in range(source.shape[0]):
        for k in range(source.shape[1]):
            into[i, k] = source[i, k]


@compiled
def refresh(chain: Chain, p: Prepared) -> float:
    """Recompute everything from the frames; returns the energy without the route."""
    energy = measure(chain.frames, p, chain.boxes, chain.pairs, chain.relations)
    n = chain.frames.shape[0]
    for k in range(4):
        chain.sums[0, k] = 0.0
    for i in range(n):
        for k in range(4):
            chain.sums[0, k] += chain.boxes[i, k]
        for j in range(i):
            chain.sums[0, 0] += chain.pairs[i, j]
    for r in range(chain.relations.shape[0]):
        chain.sums[0, 1] += chain.relations[r]
    return energy


@compiled
def try_item(chain: Chain, p: Prepared, i: int, frame: Frame) -> float:
    """Energy without the route if item ``i`` stood at ``frame``; nothing is changed yet."""
    cost = box_cost(frame, i, p)
    shared = chain.sums[0, 0] + cost[0] - chain.boxes[i, 0]
    own = chain.sums[0, 1] + cost[1] - chain.boxes[i, 1]
    area = chain.sums[0, 2] + cost[2] - chain.boxes[i, 2]
    turn = chain.sums[0, 3] + cost[3] - chain.boxes[i, 3]
    for j in range(chain.frames.shape[0]):
        if j != i:
            value = pair_cost(frame, read_frame(chain.frames, j), i, j, p)
            shared += value - chain.pairs[i, j]
            chain.row[j] = value
    for k in range(p.related_start[i], p.related_start[i + 1]):
        r = p.related[k]
        first, second = p.pairs[r, 0], p.pairs[r, 1]
        a = frame if first == i else read_frame(chain.frames, first)
        b = frame if second == i else read_frame(chain.frames, second)
        chain.fresh[r] = relation_cost(a, b, r, p)
        own += chain.fresh[r] - chain.relations[r]
    chain.cost[0], chain.cost[1], chain.cost[2], chain.cost[3] = cost
    chain.sums[1, 0], chain.sums[1, 1], chain.sums[1, 2], chain.sums[1, 3] = shared, own, area, turn
    return whole_cost(shared, own, area, turn, p)


@compiled
def commit(chain: Chain, p: Prepared, i: int, frame: Frame) -> None:
    """Take over the move of item ``i`` to ``frame`` just tried."""
    write_frame(chain.frames, i, frame)
    for k in range(4):
        chain.boxes[i, k] = chain.cost[k]
        chain.sums[0, k] = chain.sums[1, k]
    for j in range(chain.frames.shape[0]):
        if j != i:
            chain.pairs[i, j] = chain.pairs[j, i] = chain.row[j]
    for k in range(p.related_start[i], p.related_start[i + 1]):
        chain.relations[p.related[k]] = chain.fresh[p.related[k]]
