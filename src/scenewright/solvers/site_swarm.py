"""Sites by a particle swarm over poses, the paper's comparison "PSO".

Kennedy, Eberhart 1995, with the constriction of Clerc, Kennedy 2002: w = 0.7298, c = 1.49618.
A particle is all poses (n, 3); headings are rounded to the four of the site when judged.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from scenewright.site_problem import Floats, SiteProblem
from scenewright.solve import Budget, Cancel, Progress, Watch, run_population
from scenewright.solvers.draws import streams
from scenewright.solvers.site_answer import answer, make_measure, standing
from scenewright.solvers.site_found import SiteFound
from scenewright.solvers.site_random import TRIES, drop_buildings, lines_of

PARTICLES, ROUNDS = 40, 250
LOOKED = 40
"""How many of the best are looked at for what can stand."""
INERTIA, PULL = 0.7298, 1.49618


class Flight(NamedTuple):
    """Positions and velocities (P, m), the best of each particle with its energy (P,), bounds."""

    places: Floats
    speeds: Floats
    bests: Floats
    energies: Floats
    low: Floats
    high: Floats


class Swarm(NamedTuple):
    """Ask / tell of :class:`scenewright.solve.PopulationSolver`; ``first`` (P, m) where it
    starts."""

    first: Floats

    def init(self, rng: np.random.Generator, low: Floats, high: Floats) -> Flight:
        """At the first places, with small random speeds."""
        speeds = 0.1 * (high - low) * rng.uniform(-1.0, 1.0, self.first.shape)
        energies = np.full(len(self.first), math.inf)
        return Flight(self.first.copy(), speeds, self.first.copy(), energies, low, high)

    def ask(self, state: Flight, rng: np.random.Generator) -> tuple[Floats, Flight]:
        """Where the particles are; after the first round each flies on, pulled to its own best
        and to the best of all, and stays within the bounds."""
        if not np.isfinite(state.energies).any():
            return state.places, state
        shape, leader = state.places.shape, state.bests[state.energies.argmin()]
        speeds = INERTIA * state.speeds
        speeds += PULL * rng.random(shape) * (state.bests - state.places)
        speeds += PULL * rng.random(shape) * (leader - state.places)
        places = np.clip(state.places + speeds, state.low, state.high)
        return places, state._replace(places=places, speeds=speeds)

    def tell(self, state: Flight, genes: Floats, energies: Floats) -> Flight:
        """Each particle keeps its best."""
        better = energies < state.energies
        bests = np.where(better[:, None], genes, state.bests)
        return state._replace(bests=bests, energies=np.where(better, energies, state.energies))


def swarm_site(
    problem: SiteProblem, budget: Budget, seed: int = 0,
    progress: Progress | None = None, cancel: Cancel | None = None,
) -> SiteFound:  # fmt: skip
    """Fly 40 particles, 250 rounds without a budget; a step is a layout."""
    watch, measure = Watch(budget, progress, cancel), make_measure(problem)
    n, lines, rng = len(problem.buildings.sizes), lines_of(problem), np.random.default_rng(seed)
    low = np.tile([*problem.ground.bounds[:2], 0.0], n)
    high = np.tile([*problem.ground.bounds[2:], 4.0], n)

    def poses(genes: Floats) -> Floats:
        boxes = np.empty((len(genes), n, 5))
        boxes[..., :3] = genes.reshape(-1, n, 3)
        boxes[..., 2] = lines[0] + 0.5 * math.pi * (np.floor(boxes[..., 2]) % 4)
        boxes[..., 3:] = problem.buildings.sizes[:, :2]
        return boxes

    count = min(PARTICLES, budget.steps) if budget.steps else PARTICLES
    rounds = max(budget.steps // count, 1) if budget.steps else None if budget.seconds else ROUNDS
    genes, _, done = run_population(
        Swarm(_first(problem, count, seed, low, high)),
        lambda rows: measure.energies(poses(rows)), low, high, rng, watch, rounds,
    )  # fmt: skip
    ended = poses(genes[:LOOKED])
    for boxes in ended:
        boxes[~standing(measure, boxes), 3:] = 0.0
    best = int(measure.energies(ended).argmin())
    return answer(problem, ended[best], done, done // count)


def _first(problem: SiteProblem, count: int, seed: int, low: Floats, high: Floats) -> Floats:
    """Random layouts (count, m): dropped where there is room, else anywhere."""
    measure, lines, rng = make_measure(problem), lines_of(problem), np.random.default_rng(seed + 1)
    boxes, stream = np.zeros((len(problem.buildings.sizes), 5)), streams(seed, 1)[0]
    first = rng.uniform(low, high, (count, len(low))).reshape(count, -1, 3)
    for k in range(count):
        order = rng.permutation(len(boxes)).astype(np.int64)
        drop_buildings(measure.p, measure.s, order, TRIES, lines, stream, boxes)
        stood = boxes[:, 3] > 0.0
        first[k, stood, :2] = boxes[stood, :2]
        first[k, stood, 2] = np.rint((boxes[stood, 2] - lines[0]) / (0.5 * math.pi)) % 4 + 0.5
    return first.reshape(count, -1)
