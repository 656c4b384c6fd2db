"""The compiled loop of annealing: propose, look at what changed, accept or refuse.

Metropolis et al. 1953, Kirkpatrick et al. 1983. The walking route is only looked at when
everything else would accept a move.
"""

from __future__ import annotations

import math

import numpy as np

from scenewright.geometry.boxes import Floats, Frame, make_frame, read_frame
from scenewright.geometry.compiled import compiled, compiled_entry
from scenewright.geometry.paths import Bits, Grid
from scenewright.solvers.chain import (
    Chain,
    commit,
    copy_rows,
    make_chain,
    refresh,
    try_item,
    write_frame,
)
from scenewright.solvers.draws import Stream, below, uniform
from scenewright.solvers.moves import back_of, from_back, jump, propose, to_wall, turn
from scenewright.terms.assemble import Prepared, route_cost

REFRESH = 4096


@compiled
def scatter(frames: Floats, p: Prepared, stream: Stream) -> None:
    """A first layout: sizes drawn within limits, backs at walls where they belong."""
    for i in range(frames.shape[0]):
        w = p.limits[i, 0] + uniform(stream) * (p.limits[i, 2] - p.limits[i, 0])
        d = p.limits[i, 1] + uniform(stream) * (p.limits[i, 3] - p.limits[i, 1])
        frame = make_frame(0.0, 0.0, 2.0 * math.pi * uniform(stream), w, d)
        frame = turn(jump(frame, p.bounds, stream), math.pi, stream)
        if p.traits[i, 1] != 0.0 and p.walls.shape[0] > 0:
            frame = to_wall(frame, p.walls, stream)
        write_frame(frames, i, frame)


@compiled
def accept(
    chain: Chain,
    p: Prepared,
    grid: Grid,
    free: Bits,
    reached: Bits,
    i: int,
    frame: Frame,
    energy: float,
    limit: float,
) -> float:
    """Make the move just tried if its energy, with the route's added, stays within the limit;
    returns the energy, infinity if refused. ``energy`` is that without the route."""
    if energy > limit:
        return math.inf
    if grid.doors.shape[0] > 0:
        before = read_frame(chain.frames, i)
        write_frame(chain.frames, i, frame)
        energy += route_cost(chain.frames, p, grid, free, reached)
        write_frame(chain.frames, i, before)
    if energy > limit:
        return math.inf
    commit(chain, p, i, frame)
    return energy


@compiled
def swap(
    chain: Chain,
    p: Prepared,
    grid: Grid,
    free: Bits,
    reached: Bits,
    i: int,
    j: int,
    limit: float,
) -> float:
    """Exchange the places of two items, by the middles of their backs; infinity if refused."""
    a, b = read_frame(chain.frames, i), read_frame(chain.frames, j)
    ax, ay = back_of(a)
    bx, by = back_of(b)
    there, here = from_back(bx, by, b[7], a[4], a[5]), from_back(ax, ay, a[7], b[4], b[5])
    try_item(chain, p, i, there)
    commit(chain, p, i, there)
    energy = try_item(chain, p, j, here)
    energy = accept(chain, p, grid, free, reached, j, here, energy, limit)
    if energy == math.inf:
        try_item(chain, p, i, a)
        commit(chain, p, i, a)
    return energy


@compiled
def run_chain(
    chain: Chain,
    p: Prepared,
    grid: Grid,
    free: Bits,
    reached: Bits,
    best: Floats,
    stream: Stream,
    steps: int,
    hot: float,
    cold: float,
    first: float,
    last: float,
) -> tuple[float, float]:
    """Anneal from ``chain.frames``; temperature falls from ``hot`` to ``cold`` geometrically as
    the share of the schedule goes from ``first`` to ``last``. Writes the ``best`` frames (n, 8);
    returns the energies, last and best."""
    n = chain.frames.shape[0]
    energy = refresh(chain, p) + route_cost(chain.frames, p, grid, free, reached)
    least, temperature, heat = energy, hot, 1.0
    copy_rows(best, chain.frames)
    for step in range(steps):
        if step % 32 == 0:
            share = first + (last - first) * step / steps
            temperature, heat = hot * (cold / hot) ** share, 1.0 - share
        if step % REFRESH == REFRESH - 1:
            refresh(chain, p)
        limit = energy - temperature * math.log(1.0 - uniform(stream))
        i = below(stream, n)
        if n > 1 and uniform(stream) < 0.03:
            j = (i + 1 + below(stream, n - 1)) % n
            after = swap(chain, p, grid, free, reached, i, j, limit)
        else:
            frame = propose(chain.frames, i, p, heat, stream)
            after = try_item(chain, p, i, frame)
            after = accept(chain, p, grid, free, reached, i, frame, after, limit)
        if after < math.inf:
            energy = after
            if energy < least:
                least = energy
                copy_rows(best, chain.frames)
    return energy, least


@compiled_entry
def anneal_chains(
    p: Prepared,
    grid: Grid,
    starts: Floats,
    bests: Floats,
    draws: Stream,
    fresh: bool,
    steps: int,
    hot: float,
    cold: float,
    first: float,
    last: float,
) -> Floats:
    """Run chains ``starts`` (c, n, 8) one after another, in place; ``bests`` (c, n, 8) is written.

    ``fresh`` draws the starting layouts. Returns the best energy of each (c,).
    """
    count, n = starts.shape[0], starts.shape[1]
    chain = make_chain(n, p.pairs.shape[0])
    free, reached = np.empty_like(grid.free), np.empty_like(grid.free)
    found = np.empty(count)
    for c in range(count):
        if fresh:
            scatter(starts[c], p, draws[c])
        copy_rows(chain.frames, starts[c])
        found[c] = run_chain(
            chain, p, grid, free, reached, bests[c], draws[c], steps, hot, cold, first, last
        )[1]
        copy_rows(starts[c], chain.frames)
    return found
