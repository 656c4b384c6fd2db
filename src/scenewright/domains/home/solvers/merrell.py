"""The paper's comparison: single pieces annealed by the guidelines of Merrell et al. 2011.

The schedule is the one Liu et al. 2017 give for their own comparison: T0 = 100, times 0.99 each
iteration, 500 iterations, ΔE accepted with exp(-ΔE / T). How many moves make an iteration is not
printed; here as many as there are pieces. Moves: translate, turn, snap
to a wall, swap (Merrell et al., 5). Sizes stay as they are: a piece is bought, not stretched.

The costs it goes by are its own (:mod:`scenewright.domains.home.terms.piece_guidelines`); the
energy of what it returns is the problem's, as for every solver.
"""

from __future__ import annotations

import math

import numpy as np

from scenewright.core.layout import Layout
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.anneal import boxes_of, scatter_boxes
from scenewright.domains.home.solvers.chain import copy_rows, write_frame
from scenewright.domains.home.solvers.moves import jump, nudge, to_wall, turn
from scenewright.domains.home.terms.assemble import PreparedHome
from scenewright.domains.home.terms.piece_guidelines import (
    ZONES,
    circulation,
    composition,
    own_cost,
    summed_cost,
)
from scenewright.engine.draws import Stream, below, streams, uniform
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress, distinct
from scenewright.geometry.boxes import Floats, Frame, frames_of, make_frame, read_frame
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.flood import Bits
from scenewright.geometry.paths import RouteGrid, make_grid

HOT, DECAY, ITERATIONS = 100.0, 0.99, 500
COLD = 0.001  # where a schedule of ours ends
FAR, NEAR = 2.0, 0.01
CELL = 0.1
SWEEPS = 10  # iterations between two looks at the clock


@inlined
def propose_move(p: PreparedHome, frames: Floats, i: int, reach: float, stream: Stream) -> Frame:
    """Another place for a piece: a step, a turn, a wall or anywhere.

    ``frames`` (n, 8); ``reach`` in metres.
    """
    frame, kind = read_frame(frames, i), uniform(stream)
    if kind < 0.55:
        return nudge(frame, reach, stream)
    if kind < 0.75:
        return turn(frame, 0.3 * reach, stream)
    if kind < 0.88 and p.walls.shape[0] > 0:
        return to_wall(frame, p.walls, stream)
    return jump(frame, p.bounds, stream)


@inlined
def apply_move(p: PreparedHome, frames: Floats, i: int, frame: Frame) -> float:
    """Move one piece; the change of all costs but composition and circulation.

    ``frames`` (n, 8), changed in place.
    """
    before = own_cost(p, frames, i)
    write_frame(frames, i, frame)
    return own_cost(p, frames, i) - before


@compiled
def sweep(
    p: PreparedHome,
    grid: RouteGrid,
    free: Bits,
    reached: Bits,
    frames: Floats,
    stream: Stream,
    moves: int,
    heat: float,
    reach: float,
    tally: Floats,
    best: Floats,
) -> None:
    """Try moves at one temperature.

    ``tally`` (4,): cost, composition and circulation in it, least cost; ``best`` (n, 8) frames.
    Circulation, which takes longest, is only looked at when all else would let a move pass.
    """
    n = frames.shape[0]
    for _ in range(moves):
        i = below(stream, n)
        j = below(stream, n) if uniform(stream) < 0.1 else i
        old, other = read_frame(frames, i), read_frame(frames, j)
        limit = tally[0] - heat * math.log(1.0 - uniform(stream))
        there = propose_move(p, frames, i, reach, stream)
        if j != i:
            there = make_frame(other[0], other[1], other[7], 2.0 * old[4], 2.0 * old[5])
        change = apply_move(p, frames, i, there)
        if j != i:
            there = make_frame(old[0], old[1], old[7], 2.0 * other[4], 2.0 * other[5])
            change += apply_move(p, frames, j, there)
        weight, walk = composition(p, frames), tally[2]
        after = tally[0] - tally[1] - tally[2] + change + weight
        if after <= limit:
            walk = circulation(frames, grid, free, reached)
        if after + walk <= limit:
            tally[0], tally[1], tally[2] = after + walk, weight, walk
            if tally[0] < tally[3] - 1e-9:
                tally[3] = tally[0]
                copy_rows(best, frames)
        else:
            write_frame(frames, i, old)
            if j != i:
                write_frame(frames, j, other)


def prepare_guided(problem: Problem) -> tuple[PreparedHome, RouteGrid]:
    """The problem with the zones weighed as the guidelines do, and where a person can walk."""
    p, ground = prepare(problem), problem.ground
    weights = np.zeros_like(p.weights)
    for term, weight in ZONES:
        weights[term] = weight
    doors, solids = np.reshape(ground.doors, (-1, 5)), np.reshape(ground.obstacles, (-1, 5))
    grid = make_grid(
        p.edges, frames_of(solids), frames_of(doors), p.bounds, CELL, problem.route_width
    )
    return p._replace(weights=weights), grid


def first_layout(p: PreparedHome, rng: np.random.Generator) -> Floats:
    """Boxes (n, 5) drawn anywhere, each of its preferred size."""
    boxes: Floats = scatter_boxes(p, 1, rng)[0]
    low, high, wish = p.limits[:, :2], p.limits[:, 2:], p.traits[:, 5:7]
    boxes[:, 3:] = np.clip(np.where(np.isnan(wish), 0.5 * (low + high), wish), low, high)
    return boxes


def merrell(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> Found[Layout]:
    """Place every item of a problem as a single piece.

    Without a budget it takes the stated schedule; with one, it cools to 0.001 within it.
    Steps are moves. Hard rules are costs here, as in the paper: the result may break them.
    """
    watch, (p, grid) = BudgetWatch(budget, progress, cancel), prepare_guided(problem)
    judge, ways = prepare(problem), route_grid(problem, CELL)
    free, reached = np.empty_like(grid.free), np.empty_like(grid.free)
    frames = frames_of(first_layout(p, np.random.default_rng(seed)))
    stream, n, best = streams(seed, 1)[0], len(frames), frames.copy()
    weight, walk = composition(p, frames), circulation(frames, grid, free, reached)
    cost = summed_cost(p, frames) + weight + walk
    tally, done, age = np.array([cost, weight, walk, cost]), 1, 0

    def energy() -> float:
        return float(energies_of(judge, ways, boxes_of(best)[None])[0][0])

    def layout() -> Layout:
        return Layout(boxes_of(best), energy())

    bounded = bool(budget.seconds or budget.steps)
    while not watch.over(done, energy(), layout) and (bounded or age < ITERATIONS):
        share = watch.share(done) if bounded else age / ITERATIONS
        moves = min(SWEEPS * n, budget.steps - done) if budget.steps else SWEEPS * n
        heat = HOT * (COLD / HOT) ** share if bounded else HOT * DECAY**age
        reach = FAR * (NEAR / FAR) ** share
        sweep(p, grid, free, reached, frames, stream, moves, heat, reach, tally, best)
        done, age = done + moves, age + SWEEPS
    return Found(distinct(boxes_of(best)[None], np.array([energy()])), done)
