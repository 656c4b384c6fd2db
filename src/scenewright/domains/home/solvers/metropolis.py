"""The compiled loop of annealing: propose, look at what changed, accept or refuse.

Metropolis et al. 1953, Kirkpatrick et al. 1983. The walking route is only looked at when
everything else would accept a move.
"""

from __future__ import annotations

import math

from scenewright.domains.home.solvers.chain import (
    Chain,
    chain_of,
    commit,
    copy_rows,
    try_item,
    write_frame,
)
from scenewright.domains.home.solvers.kept_route import (
    KeptRoute,
    count_unreached,
    keep_all,
    keep_cells,
    try_cells,
)
from scenewright.domains.home.solvers.moves import from_back, propose
from scenewright.domains.home.terms.assemble import PreparedHome
from scenewright.domains.home.terms.table import ROUTE
from scenewright.engine.draws import Stream, below, uniform
from scenewright.geometry.boxes import Floats, read_frame, read_sides
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.paths import RouteGrid

REFRESH = 4096
"""Steps after which the sums of a chain, made of differences, are renewed."""
SWAPS = 0.03


@inlined
def attempt(
    chain: Chain,
    p: PreparedHome,
    grid: RouteGrid,
    kept: KeptRoute,
    stream: Stream,
    energy: float,
    temperature: float,
    heat: float,
) -> float:
    """Propose a move of one item, or a swap of two, and make it by Metropolis' rule; the energy
    after, infinity if refused with all as before.

    A swap exchanges the middles of two backs: it moves the first item, decides on the second,
    and if refused takes the first back. So there are up to three turns; turn 1 decides.
    """
    n = chain.frames.shape[0]
    i = below(stream, n)
    j = below(stream, n) if uniform(stream) < SWAPS else i
    a, b = read_frame(chain.frames, i), read_frame(chain.frames, j)
    if i == j:
        there = propose(chain.frames, i, p, heat, stream)
    else:
        there = from_back(b[0] - b[2] * b[5], b[1] - b[3] * b[5], b[7], a[4], a[5])
    limit = energy - temperature * math.log(1.0 - uniform(stream))
    item, frame, turn, accepted = i, there, 1 if i == j else 0, True
    while turn < 3:
        tried = try_item(chain, p, item, frame, limit if turn == 1 else math.inf)
        if turn == 1:
            energy = tried
            if energy <= limit and p.weights[ROUTE] != 0.0:
                before = read_frame(chain.frames, item)
                write_frame(chain.frames, item, frame)
                most = (limit - energy) / p.weights[ROUTE]
                energy += p.weights[ROUTE] * count_unreached(
                    kept, item, chain.frames, p.access, p.inset, grid, most
                )
                write_frame(chain.frames, item, before)
            accepted = energy <= limit
        if accepted or turn == 2:
            commit(chain, p, item, frame)
            if p.weights[ROUTE] != 0.0:
                if turn != 1:
                    try_cells(kept, grid, frame, read_sides(p.inset, item))
                keep_cells(kept, item)
        if turn == 0:
            turn, item = 1, j
            frame = from_back(a[0] - a[2] * a[5], a[1] - a[3] * a[5], a[7], b[4], b[5])
        elif turn == 1 and not accepted and i != j:
            turn, item, frame = 2, i, a
        else:
            turn = 3
    return energy if accepted else math.inf


@compiled
def run_chains(
    chains: Chain,
    p: PreparedHome,
    grid: RouteGrid,
    kept: KeptRoute,
    bests: Floats,
    energies: Floats,
    streams: Stream,
    begin: int,
    end: int,
    steps: int,
    schedule: Floats,
) -> None:
    """Anneal the layouts of ``chains`` (c, n, 8) one after another by steps ``begin`` to ``end`` of
    ``steps``, at most :data:`REFRESH`, and leave them as they end.

    ``bests`` (c, n, 8) are the best layouts so far; ``energies`` (c, 2) those of now and of the
    best. Temperature falls geometrically over a schedule; this run is a part of it:
    ``schedule`` (4,) is its hot and cold end and where the part starts and stops (0 to 1). The
    other arguments are scratch.
    """
    hot, cold, first, last = schedule[0], schedule[1], schedule[2], schedule[3]
    for c in range(bests.shape[0]):
        chain = chain_of(chains, c)
        if p.weights[ROUTE] != 0.0:
            keep_all(kept, grid, chain.frames, p.inset)
        energy, temperature, heat = energies[c, 0], hot, 1.0
        for step in range(begin, end):
            if step % 32 == 0:
                share = first + (last - first) * step / steps
                temperature, heat = hot * (cold / hot) ** share, 1.0 - share
            after = attempt(chain, p, grid, kept, streams[c], energy, temperature, heat)
            if after < math.inf:
                energy = after
                if energy < energies[c, 1]:
                    energies[c, 1] = energy
                    copy_rows(bests[c], chain.frames)
        energies[c, 0] = energy
