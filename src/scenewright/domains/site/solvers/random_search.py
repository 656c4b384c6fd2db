"""Sites drawn at random: buildings dropped where there is room, the best layout kept."""

from __future__ import annotations

import math
from functools import partial

import numpy as np

from scenewright.domains.site.problem import Floats, Ints, SiteProblem
from scenewright.domains.site.solvers.answer import LOOSE, answer, make_measure, stand
from scenewright.domains.site.solvers.lattice import main_direction
from scenewright.domains.site.solvers.moves import in_block
from scenewright.domains.site.solvers.outcome import SiteFound
from scenewright.domains.site.terms.measure import SitePrepared, SiteState, put, stands
from scenewright.engine.draws import Stream, streams
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Progress
from scenewright.geometry.buckets import remove
from scenewright.geometry.compiled import compiled


def lines_of(problem: SiteProblem, free: bool = False) -> Floats:
    """Base heading, the one along or across the main direction nearest to the preferred heading,
    and 1 if buildings may stand at any angle; see :func:`.site_moves.drawn_heading`."""
    ground = problem.ground
    main = main_direction(ground.block_edges if len(ground.block_edges) else ground.edges)
    steps = round((problem.facing - main) / (0.5 * math.pi))
    return np.array([main + steps * 0.5 * math.pi, 1.0 if free else 0.0])


@compiled
def drop_buildings(
    p: SitePrepared,
    s: SiteState,
    order: Ints,
    tries: int,
    lines: Floats,
    stream: Stream,
    boxes: Floats,
) -> None:
    """Drop buildings in ``order`` (n,) where they stand clear; write where to ``boxes`` (n, 5),
    no width for those that found no room in ``tries`` tries."""
    for i in range(boxes.shape[0]):
        remove(s.buckets, i)
        for k in range(5):
            boxes[i, k] = 0.0
    for k in range(order.shape[0]):
        i = order[k]
        for _ in range(tries if p.blocks.shape[0] > 0 else 0):
            frame = in_block(p, i, lines, stream)
            if stands(p, s, i, frame, LOOSE):
                put(p, s, i, frame)
                boxes[i, 0], boxes[i, 1], boxes[i, 2] = frame[0], frame[1], frame[7]
                boxes[i, 3], boxes[i, 4] = 2.0 * frame[4], 2.0 * frame[5]
                break


def random_site(
    problem: SiteProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:
    """The best of random layouts by the repaired sum, of 1000 without a budget; a step is a
    layout."""
    watch, stream = BudgetWatch(budget, progress, cancel), streams(seed, 1)[0]
    rule = problem.settings.random
    rng = np.random.default_rng(seed)
    measure, lines = make_measure(problem), lines_of(problem)
    boxes = np.zeros((len(problem.buildings.sizes), 5))
    best, least, done = boxes.copy(), math.inf, 0
    rounds = budget.steps or (math.inf if budget.seconds else rule.layouts)
    while done < rounds:
        order = rng.permutation(len(boxes)).astype(np.int64)
        drop_buildings(measure.p, measure.s, order, rule.tries, lines, stream, boxes)
        energy = float(measure.energies(boxes[None])[0])
        done += 1
        if energy < least:
            best, least = boxes.copy(), energy
        if watch.over(done, least, partial(stand, problem, best)):
            break
    return answer(problem, best, done, done)
