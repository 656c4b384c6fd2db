"""The paper's comparison: annealing over patches (Liu et al. 2017).

T0 = 100, decay 0.99 an iteration, 500 iterations; each tries the moves the paper names: translate,
turn or scale one patch, or swap two patches' positions and headings. How many moves make an
iteration is not printed: here one for every layout of the genetic algorithm's 4000 / 500 = 8, as
the printed seconds of both are alike. It starts from a random layout, as the algorithm does.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from scenewright.core.layout import Layout
from scenewright.domains.home.encodings.boxes import gene_bounds, to_boxes
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Found, Progress, distinct

Floats = NDArray[np.float64]
START = 100.0
DECAY = 0.99
ITERATIONS = 500
MOVES = 8
STEP = 0.3


def propose_layout(genes: Floats, low: Floats, high: Floats, rng: np.random.Generator) -> Floats:
    """Another layout (n, 5): one of the paper's four moves, within the bounds."""
    changed, i, kind = genes.copy(), int(rng.integers(len(genes))), int(rng.integers(4))
    if kind == 3 and len(genes) > 1:
        j = (i + rng.integers(1, len(genes))) % len(genes)
        changed[i, :3], changed[j, :3] = genes[j, :3], genes[i, :3]
        return changed
    columns = (slice(0, 2), slice(2, 3), slice(3, 5))[min(kind, 2)]
    changed[i, columns] += rng.normal(0.0, STEP, len(changed[i, columns]))
    return np.clip(changed, low, high)


def paper_sa(
    problem: Problem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    moves: int = MOVES,
) -> Found[Layout]:
    """Solve by the paper's annealing; without a budget, its 500 iterations of ``moves`` moves.

    With a budget it goes on at the last temperatures, or stops early.
    """
    rng, watch = np.random.default_rng(seed), BudgetWatch(budget, progress, cancel)
    low, high = gene_bounds(problem)
    p, grid = prepare(problem), route_grid(problem, 0.1)
    now = best = rng.uniform(low, high)
    energy = least = float(energies_of(p, grid, to_boxes(now[None]))[0][0])
    kept, energies, done = [best], [least], 1
    limit = math.inf if budget.seconds or budget.steps else ITERATIONS * moves

    def layout() -> Layout:
        return Layout(to_boxes(best[None])[0], least)

    while not watch.over(done, least, layout) and done <= limit:
        temperature = max(START * DECAY ** (done // moves), 1e-9)
        tried = propose_layout(now, low, high, rng)
        after = float(energies_of(p, grid, to_boxes(tried[None]))[0][0])
        done += 1
        if after <= energy or rng.uniform() < math.exp((energy - after) / temperature):
            now, energy = tried, after
        if energy < least:
            best, least = now, energy
            kept, energies = [*kept[-63:], best], [*energies[-63:], least]
    return Found(distinct(to_boxes(np.stack(kept)), np.array(energies)), done)
