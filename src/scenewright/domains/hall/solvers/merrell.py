"""The paper's comparison: objects annealed one by one under the guidelines of Merrell et al. 2011.

As Cao, Cheng, Zhang 2024 run it: T0 = 1000, times 0.99 each iteration until it is below a least
temperature (not printed; here 0.001, so 1376 iterations), ΔE accepted with exp(-ΔE / T), from the
same first layout. One move an iteration, as printed, would touch each of 40 objects 30 times; here
an iteration tries as many moves as there are objects. Moves: translate, turn, snap to a wall, swap
(Merrell et al., 5). The printed test (reject if ΔE > 0 and exp(-ΔE / T) > rand) is turned round.
"""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.hall.energy import make_state, prepare
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.objects import (
    TRIES,
    ObjectLayout,
    at_wall,
    boxes_of,
    cover_obstacles,
    drawn_place,
    drop,
    lay,
    make_ways,
)
from scenewright.domains.hall.terms.guidelines import (
    Ways,
    off_balance,
    own_cost,
    put,
    regions,
    whole_cost,
)
from scenewright.domains.hall.terms.state import Floats, PreparedHall, State
from scenewright.engine.draws import Stream, bell, below, streams, uniform
from scenewright.engine.guidelines import BALANCE, CIRCULATION
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Progress
from scenewright.geometry.boxes import Frame, make_frame, read_frame
from scenewright.geometry.compiled import compiled, inlined

HOT, DECAY, COLD = 1000.0, 0.99, 0.001
ITERATIONS = 1 + math.ceil(math.log(COLD / HOT) / math.log(DECAY))
FAR_MOVE, NEAR_MOVE = 3.0, 0.03


@inlined
def propose_move(p: PreparedHall, s: State, i: int, reach: float, stream: Stream) -> Frame:
    """Another place for an object: a step, a turn, a wall or anywhere in its zone."""
    kind, (w, d) = uniform(stream), (p.sizes[i, 0], p.sizes[i, 1])
    x, y, heading = s.frames[i, 0], s.frames[i, 1], s.frames[i, 7]
    if kind < 0.55:
        return make_frame(x + reach * bell(stream), y + reach * bell(stream), heading, w, d)
    if kind < 0.70:
        return make_frame(x, y, heading + 0.3 * reach * bell(stream), w, d)
    if kind < 0.78:
        quarter = 0.5 * math.pi
        return make_frame(x, y, quarter * round(heading / quarter + below(stream, 4)), w, d)
    if kind < 0.88:
        found, frame = at_wall(p, i, stream)
        if found:
            return frame
    return drawn_place(p, i, stream)


@inlined
def partner(p: PreparedHall, i: int, stream: Stream) -> int:
    """Another object of the same zone to swap with; -1 if the drawn one is of another."""
    j = below(stream, p.sizes.shape[0])
    same = p.zones[p.unit_of[j]] == p.zones[p.unit_of[i]]
    return j if same and j != i else -1


@compiled
def apply_move(p: PreparedHall, s: State, ways: Ways, i: int, frame: Frame, doors: Floats) -> float:
    """Move one object; the change of all costs but balance and circulation.

    ``doors`` (d, 2) x, y of the entrances in metres.
    """
    before = own_cost(p, s, i, doors)
    put(p, s, ways, i, frame)
    return own_cost(p, s, i, doors) - before


@compiled
def sweep(
    p: PreparedHall,
    s: State,
    ways: Ways,
    stream: Stream,
    moves: int,
    heat: float,
    reach: float,
    middle: Floats,
    doors: Floats,
    tally: Floats,
    best: Floats,
) -> None:
    """Try moves at one temperature.

    ``tally`` (4,): energy, balance and circulation in it, least energy; ``best`` (n, 8) frames.
    Circulation, which takes longest, is only looked at when all else would let a move pass.
    """
    n = s.frames.shape[0]
    for _ in range(moves):
        i, j = below(stream, n), -1
        old = read_frame(s.frames, i)
        other = old
        if uniform(stream) < 0.1:
            j = partner(p, i, stream)
        limit = tally[0] - heat * math.log(1.0 - uniform(stream))
        if j >= 0:
            other = read_frame(s.frames, j)
            change = apply_move(
                p,
                s,
                ways,
                i,
                make_frame(other[0], other[1], other[7], p.sizes[i, 0], p.sizes[i, 1]),
                doors,
            )
            change += apply_move(
                p,
                s,
                ways,
                j,
                make_frame(old[0], old[1], old[7], p.sizes[j, 0], p.sizes[j, 1]),
                doors,
            )
        else:
            change = apply_move(p, s, ways, i, propose_move(p, s, i, reach, stream), doors)
        balance = BALANCE * off_balance(s, middle)
        after, walk = tally[0] - tally[1] - tally[2] + change + balance, tally[2]
        if after <= limit:
            walk = CIRCULATION * max(regions(ways) - 1, 0)
        if after + walk <= limit:
            tally[0], tally[1], tally[2] = after + walk, balance, walk
            if tally[0] < tally[3] - 1e-9:
                tally[3] = tally[0]
                for k in range(n):
                    for c in range(8):
                        best[k, c] = s.frames[k, c]
        else:
            put(p, s, ways, i, old)
            if j >= 0:
                put(p, s, ways, j, other)


def merrell(
    problem: HallProblem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    start: Floats | None = None,
) -> ObjectLayout:
    """Place every object of a hall independently; ``start`` are the first boxes (n, 5).

    Without a budget it takes the printed schedule; with one, the schedule is spread over it.
    Steps are moves. Hard rules are costs here, as in the paper: the result may break them.
    """
    p, watch = prepare(problem), BudgetWatch(budget, progress, cancel)
    s, ways, stream = make_state(p), make_ways(problem), streams(seed, 1)[0]
    cover_obstacles(p, ways)
    if start is None:
        drop(p, s, ways, TRIES, stream)
    else:
        lay(p, s, ways, np.ascontiguousarray(start, np.float64))
    doors = np.asarray(problem.ground.doors, np.float64).reshape(-1, 5)
    bounds = np.asarray(problem.ground.bounds, np.float64)
    middle, n = 0.5 * (bounds[:2] + bounds[2:]), len(p.sizes)
    energy = whole_cost(p, s, ways, middle, doors)
    tally = np.array(
        [energy, BALANCE * off_balance(s, middle), CIRCULATION * max(regions(ways) - 1, 0), energy]
    )
    best, done, age = s.frames.copy(), 1, 0
    bounded = bool(budget.seconds or budget.steps)

    def stand() -> Floats:
        return boxes_of(s._replace(frames=best))

    while n and not watch.over(done, float(tally[3]), stand) and (bounded or age < ITERATIONS):
        share = watch.share(done) if bounded else age / ITERATIONS
        moves = min(n, budget.steps - done) if budget.steps else n
        heat, reach = HOT * (COLD / HOT) ** share, FAR_MOVE * (NEAR_MOVE / FAR_MOVE) ** share
        sweep(p, s, ways, stream, moves, heat, reach, middle, doors, tally, best)
        done, age = done + moves, age + 1
    return ObjectLayout(boxes_of(s._replace(frames=best)), float(tally[3]), done)
