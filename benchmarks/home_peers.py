"""General optimisers on the same compiled objective, as their libraries ship them.

SciPy's differential evolution, CMA-ES, pymoo's genetic algorithm and particle swarm, DEAP's simple
evolution: genes scaled to [0, 1], 40 layouts a generation where that is theirs to choose, all else
by default (CMA-ES starts again with twice the population when it stops). They need the extra
``peers``; those absent are left out with a word.
"""

from __future__ import annotations

import importlib.util
import sys
import time
from collections.abc import Callable
from contextlib import suppress
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.encodings.boxes import gene_bounds, to_boxes
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.problem import Problem
from scenewright.engine.solve import Budget

Floats = NDArray[np.float64]
POPULATION = 40
ENDLESS = 10**9


class SpentError(Exception):
    """The budget is spent; raised through whatever library is running."""


class Objective:
    """Energies of genes (P, m) in [0, 1], counted and timed; keeps the best it was shown."""

    def __init__(self, problem: Problem, budget: Budget) -> None:
        self.low, self.high = (bound.ravel() for bound in gene_bounds(problem))
        self.p, self.grid, self.n = prepare(problem), route_grid(problem, 0.1), len(problem.names)
        self.left = budget.steps or ENDLESS
        self.end = time.perf_counter() + (budget.seconds or ENDLESS)
        self.best, self.energy, self.looked = np.zeros(len(self.low)), np.inf, 0

    def boxes(self, genes: Floats) -> Floats:
        """Boxes (P, n, 5) of scaled genes."""
        inside = self.low + np.clip(genes, 0.0, 1.0) * (self.high - self.low)
        return to_boxes(inside.reshape(-1, self.n, 5))

    def __call__(self, genes: Floats) -> Floats:
        """Energies (P,); raises :class:`SpentError` with the last of the budget."""
        rows = np.atleast_2d(np.asarray(genes, np.float64))[: self.left]
        if time.perf_counter() < self.end or not self.looked:
            found = energies_of(self.p, self.grid, self.boxes(rows))[0]
            self.left, self.looked = self.left - len(rows), self.looked + len(rows)
            first = int(found.argmin())
            if found[first] < self.energy:
                self.best, self.energy = rows[first].copy(), float(found[first])
            if self.left > 0:
                return found
        raise SpentError


class Ended(NamedTuple):
    """The best boxes (n, 5), their energy, and layouts looked at."""

    boxes: Floats
    energy: float
    evaluations: int


def differential_evolution(objective: Objective, seed: int) -> None:
    """SciPy: best1bin, whole generations at a time, without the final polish."""
    from scipy import optimize

    m = len(objective.low)
    optimize.differential_evolution(
        lambda genes: objective(genes.T),
        [(0.0, 1.0)] * m,
        rng=np.random.default_rng(seed),
        popsize=-(-POPULATION // m),
        maxiter=ENDLESS,
        polish=False,
        vectorized=True,
        updating="deferred",
        tol=0.0,
    )


def cma_es(objective: Objective, seed: int) -> None:
    """Hansen's CMA-ES from the middle with σ = 0.3, population doubled at each new start."""
    import cma

    rng, population = np.random.default_rng(seed), None
    while True:
        options = {"bounds": [0.0, 1.0], "seed": int(rng.integers(1, 2**31)), "verbose": -9}
        if population:
            options["popsize"] = population
        run = cma.CMAEvolutionStrategy(rng.uniform(size=len(objective.low)), 0.3, options)
        while not run.stop():
            genes = run.ask()
            run.tell(genes, objective(np.array(genes)).tolist())
        population = 2 * run.popsize


def _pymoo(algorithm: Any, objective: Objective, seed: int) -> None:
    from pymoo.core.problem import Problem as Posed
    from pymoo.optimize import minimize

    class Home(Posed):
        def __init__(self) -> None:
            super().__init__(n_var=len(objective.low), n_obj=1, xl=0.0, xu=1.0)

        def _evaluate(self, x: Floats, out: dict[str, Any], *_: Any, **__: Any) -> None:
            out["F"] = objective(x)

    minimize(Home(), algorithm, ("n_gen", ENDLESS), seed=seed)


def pymoo_ga(objective: Objective, seed: int) -> None:
    """pymoo: simulated binary crossover, polynomial mutation, tournaments."""
    from pymoo.algorithms.soo.nonconvex.ga import GA

    _pymoo(GA(pop_size=POPULATION), objective, seed)


def pymoo_pso(objective: Objective, seed: int) -> None:
    """pymoo: adaptive particle swarm."""
    from pymoo.algorithms.soo.nonconvex.pso import PSO

    _pymoo(PSO(pop_size=POPULATION), objective, seed)


def deap_ea(objective: Objective, seed: int) -> None:
    """DEAP: ``eaSimple`` with blend crossover, Gaussian mutation, tournaments of three."""
    import random

    from deap import algorithms, base, tools

    class Fitness(base.Fitness):
        weights = (-1.0,)

    class Layout(list[float]):
        def __init__(self, genes: Any) -> None:
            super().__init__(genes)
            self.fitness = Fitness()

    def judged(_: Any, layouts: list[Layout]) -> list[tuple[float]]:
        return [(float(e),) for e in objective(np.array(layouts))] if layouts else []

    before = random.getstate()
    random.seed(seed)
    tools_ = base.Toolbox()
    tools_.register("evaluate", lambda _: (0.0,))
    tools_.register("map", judged)
    tools_.register("mate", tools.cxBlend, alpha=0.5)
    tools_.register("mutate", tools.mutGaussian, mu=0.0, sigma=0.1, indpb=0.1)
    tools_.register("select", tools.selTournament, tournsize=3)
    first = np.random.default_rng(seed).uniform(size=(POPULATION, len(objective.low)))
    try:
        layouts = [Layout(row.tolist()) for row in first]
        algorithms.eaSimple(layouts, tools_, 0.7, 0.3, ENDLESS, verbose=False)
    finally:
        random.setstate(before)


class Peer(NamedTuple):
    """A general optimiser, the package it needs, and its run."""

    name: str
    package: str
    function: Callable[[Objective, int], None]

    def run(self, problem: Problem, budget: Budget, seed: int) -> Ended:
        """Optimise until the budget is spent."""
        objective = Objective(problem, budget)
        with suppress(SpentError):
            self.function(objective, seed)
        boxes = objective.boxes(objective.best[None])[0]
        return Ended(boxes, objective.energy, objective.looked)


PEERS = (
    Peer("scipy DE", "scipy", differential_evolution),
    Peer("CMA-ES", "cma", cma_es),
    Peer("pymoo GA", "pymoo", pymoo_ga),
    Peer("pymoo PSO", "pymoo", pymoo_pso),
    Peer("DEAP", "deap", deap_ea),
)


def peers() -> tuple[Peer, ...]:
    """Those whose package is installed; the others are named and left out."""
    found = tuple(p for p in PEERS if importlib.util.find_spec(p.package) is not None)
    absent = [p.name for p in PEERS if p not in found]
    if absent:
        told = f"left out, as the extra 'peers' is not installed: {', '.join(absent)}"
        sys.stderr.write(told + "\n")
    return found
