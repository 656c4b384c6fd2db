"""Sites by a particle swarm over poses, the paper's comparison "PSO".

The swarm is :class:`scenewright.engine.swarm.Swarm`. A particle is all poses (n, 3); headings are
rounded to the four of the site when judged.
"""

from __future__ import annotations

import math

import numpy as np

from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.answer import answer, make_measure, stand, standing
from scenewright.domains.site.solvers.outcome import SiteFound
from scenewright.domains.site.solvers.random_search import drop_buildings, lines_of
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Progress, run_population
from scenewright.engine.swarm import Swarm


def swarm_site(
    problem: SiteProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:
    """Fly 40 particles, 250 rounds without a budget; a step is a layout."""
    watch, measure = BudgetWatch(budget, progress, cancel), make_measure(problem)
    n, lines, rng = len(problem.buildings.sizes), lines_of(problem), np.random.default_rng(seed)
    if not n:
        return answer(problem, np.empty((0, 5)), 1, 1)
    rule = problem.settings.swarm
    low = np.tile([*problem.ground.bounds[:2], 0.0], n)
    high = np.tile([*problem.ground.bounds[2:], 4.0], n)

    def poses(genes: Floats) -> Floats:
        boxes = np.empty((len(genes), n, 5))
        boxes[..., :3] = genes.reshape(len(genes), n, 3)
        boxes[..., 2] = lines[0] + 0.5 * math.pi * (np.floor(boxes[..., 2]) % 4)
        boxes[..., 3:] = problem.buildings.sizes[:, :2]
        return boxes

    count, rounds = rule.particles, None if budget.seconds else rule.rounds
    if budget.steps:
        count = min(count, budget.steps)
        rounds = max(budget.steps // count, 1)
    genes, _, done = run_population(
        Swarm(_first(problem, count, seed, low, high)),
        lambda rows: measure.energies(poses(rows)),
        low,
        high,
        rng,
        watch,
        lambda row: stand(problem, poses(row[None])[0]),
        rounds,
    )
    ended = poses(genes[: rule.looked])
    for boxes in ended:
        boxes[~standing(measure, boxes), 3:] = 0.0
    best = int(measure.energies(ended).argmin())
    return answer(problem, ended[best], done, done // count)


def _first(problem: SiteProblem, count: int, seed: int, low: Floats, high: Floats) -> Floats:
    """Random layouts (count, m): dropped where there is room, else anywhere."""
    measure, lines, rng = make_measure(problem), lines_of(problem), np.random.default_rng(seed + 1)
    boxes, stream = np.zeros((len(problem.buildings.sizes), 5)), streams(seed, 1)[0]
    tries = problem.settings.random.tries
    first = rng.uniform(low, high, (count, len(low))).reshape(count, -1, 3)
    for k in range(count):
        order = rng.permutation(len(boxes)).astype(np.int64)
        drop_buildings(measure.p, measure.s, order, tries, lines, stream, boxes)
        stood = boxes[:, 3] > 0.0
        first[k, stood, :2] = boxes[stood, :2]
        first[k, stood, 2] = np.rint((boxes[stood, 2] - lines[0]) / (0.5 * math.pi)) % 4 + 0.5
    return first.reshape(count, -1)
