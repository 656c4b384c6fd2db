"""One annealing chain's layout with every part of its energy kept, so a move costs little.

Moving item i recomputes its box cost, its row of pairs and its relations; sums change by the
differences. The sums are written once, here; terms know nothing of chains.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.domains.home.terms.assemble import (
    Costs,
    PreparedHome,
    box_cost,
    layout_cost,
    pair_cost,
    part_of,
    relation_cost,
    whole_cost,
)
from scenewright.geometry.boxes import Floats, Frame, read_frame
from scenewright.geometry.compiled import inlined


class Chain(NamedTuple):
    """Frames (n, 8) and their ``costs``; ``box`` (4,), ``row`` (n,), ``relations`` (r,) and
    ``sums`` (4,) are the parts as they would be after the move last tried."""

    frames: Floats
    costs: Costs
    box: Floats
    row: Floats
    relations: Floats
    sums: Floats


def make_chains(frames: Floats, costs: Costs) -> Chain:
    """Chains of layouts (c, n, 8) with their ``costs`` (c, ...), and room for a move of one."""
    tried = (np.zeros(4), np.zeros(frames.shape[1]), np.zeros(costs.relations.shape[1]))
    return Chain(frames, costs, *tried, np.zeros(4))


@inlined
def chain_of(chains: Chain, c: int) -> Chain:
    """Chain ``c`` of several."""
    costs = part_of(chains.costs, c)
    return Chain(chains.frames[c], costs, chains.box, chains.row, chains.relations, chains.sums)


@inlined
def write_frame(frames: Floats, i: int, frame: Frame) -> None:
    """Set row ``i`` of frames (n, 8)."""
    frames[i, 0], frames[i, 1], frames[i, 2], frames[i, 3] = frame[0], frame[1], frame[2], frame[3]
    frames[i, 4], frames[i, 5], frames[i, 6], frames[i, 7] = frame[4], frame[5], frame[6], frame[7]


@inlined
def copy_rows(into: Floats, source: Floats) -> None:
    """Copy one (n, k) array over another."""
    for i in range(source.shape[0]):
        for k in range(source.shape[1]):
            into[i, k] = source[i, k]


@inlined
def without_item(chain: Chain, p: PreparedHome, i: int) -> tuple[float, float]:
    """The sums (shared, own) that are left if item ``i`` is taken away."""
    old = chain.costs
    shared, own = old.sums[0] - old.boxes[i, 0], old.sums[1] - old.boxes[i, 1]
    for j in range(chain.frames.shape[0]):
        shared -= old.pairs[i, j] if j != i else 0.0
    for k in range(p.related_start[i], p.related_start[i + 1]):
        own -= old.relations[p.related[k]]
    return shared, own


@inlined
def try_item(chain: Chain, p: PreparedHome, i: int, frame: Frame, limit: float) -> float:
    """Energy without the route if item ``i`` stood at ``frame``; nothing is changed yet.

    No cost is negative, so what the parts looked at come to is the least it can be: once that is
    over ``limit`` the answer is infinity and the rest is not looked at.
    """
    box, sums, old = chain.box, chain.sums, chain.costs
    shared, own = without_item(chain, p, i)
    area = old.sums[2] - old.boxes[i, 2] + 4.0 * frame[4] * frame[5]
    most = limit + 1e-9 * abs(limit)  # sums made of differences are not exact to the last digit
    spare = (most - own) * area - shared if area > 0.0 else math.inf
    box[0], box[1], box[2], box[3] = box_cost(frame, i, p, area, spare)
    if box[0] > spare or (area > 0.0 and (shared + box[0]) / area + own + box[1] > most):
        return math.inf
    for k in range(4):
        sums[k] = old.sums[k] + box[k] - old.boxes[i, k]
    spare -= box[0] + box[1] * area
    shared, own = sums[0], sums[1]
    for j in range(chain.frames.shape[0]):
        if j != i:
            value = pair_cost(frame, read_frame(chain.frames, j), i, j, p)
            shared += value - old.pairs[i, j]
            spare -= value
            chain.row[j] = value
            if spare < 0.0:
                return math.inf
    for k in range(p.related_start[i], p.related_start[i + 1]):
        r = p.related[k]
        first, second = p.pairs[r, 0], p.pairs[r, 1]
        a = frame if first == i else read_frame(chain.frames, first)
        b = frame if second == i else read_frame(chain.frames, second)
        value = relation_cost(a, b, r, p)
        own += value - old.relations[r]
        spare -= value * area
        chain.relations[r] = value
        if spare < 0.0:
            return math.inf
    sums[0], sums[1] = shared, own
    energy = whole_cost(shared, own, sums[2], sums[3], p)
    if energy > limit:
        return math.inf
    return energy + layout_cost(chain.frames, i, frame, p.weights, p.own, p.weights[:0])


@inlined
def commit(chain: Chain, p: PreparedHome, i: int, frame: Frame) -> None:
    """Take over the move of item ``i`` to ``frame`` just tried."""
    write_frame(chain.frames, i, frame)
    for k in range(4):
        chain.costs.boxes[i, k] = chain.box[k]
        chain.costs.sums[k] = chain.sums[k]
    for j in range(chain.frames.shape[0]):
        if j != i:
            chain.costs.pairs[i, j] = chain.costs.pairs[j, i] = chain.row[j]
    for k in range(p.related_start[i], p.related_start[i + 1]):
        chain.costs.relations[p.related[k]] = chain.relations[p.related[k]]
