"""Genetic algorithms over the matrix code of sites (Zhang, Yang 2023): theirs, and a simple one.

Ask / tell, so ratings may come from a measure or from a person who rates layouts: an energy
is a rating with its sign turned. Chromosomes travel as rows (cells · 3,) of whole numbers.
"""

from __future__ import annotations

import math
from typing import Any, Literal, NamedTuple

import numpy as np

from scenewright.domains.site.encodings.cell_moves import (
    cross,
    mutate,
    random_genes,
    repair_genes,
    roulette,
    spread,
    tournament,
)
from scenewright.domains.site.encodings.cells import Ints, SiteLattice
from scenewright.domains.site.encodings.refill import Amount, make_amount, mutate_surely, refill
from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.settings import MatrixSettings
from scenewright.domains.site.solvers.answer import answer, stand
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import MatrixJudge, make_judge
from scenewright.domains.site.solvers.outcome import SiteFound, SiteLayout
from scenewright.domains.site.solvers.seed_layouts import seed_layouts
from scenewright.engine.asked import Asked, join
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Progress
from scenewright.engine.trace import tell

USUAL = MatrixSettings()


class Operations(NamedTuple):
    """What made a generation: ``pairs`` of parents and how many of them were ``crossed``, children
    ``mutated``; all 0 where the best was searched around."""

    pairs: int = 0
    crossed: int = 0
    mutated: int = 0


class Bred(NamedTuple):
    """A generation: genes (P, cells · 3) and their energies (P,), its number, the generation in
    which ρ <= 0 ended the global search (-1: not yet), generations without gain since, all that was
    asked, the generation that waits to be rated, what made it, and ρ of (12)."""

    genes: Floats
    energies: Floats
    age: int
    settled: int
    stalled: int
    asked: Asked
    waiting: Floats
    operations: Operations = Operations()
    rho: float = math.inf


class MatrixGenetic(NamedTuple):
    """Ask / tell over matrix codes, as :class:`scenewright.engine.solve.PopulationSolver`.

    ``points`` of the crossover; ``keep`` how many of the best stay; ``led`` how much the visual
    quality rules the first layouts; ``local`` whether, once the individuals are alike, the best
    one is searched around by single-point mutations; ``amount`` what is to stand where operators
    are repaired (left out: as printed); ``alike`` δ of (12), ``known`` generations without
    anything new after which there is nothing left to ask, and most ``generations``.

    Ratings may come from anybody who looks at the layouts: with their sign turned, the best
    rated breed. Here somebody likes buildings in the west.

    >>> from scenewright import read
    >>> from scenewright.domains.site.solving import problems
    >>> from scenewright.domains.site.solvers.lattice import make_cells
    >>> problem = problems(read("sample:site-30"))[0]
    >>> cells = make_cells(problem)
    >>> solver, judge = MatrixGenetic(cells, problem.buildings.quality), make_judge(problem, cells)
    >>> rng, wide = np.random.default_rng(0), np.zeros(cells.fits.shape[2] * 3)
    >>> state, likings = solver.init(rng, wide, wide), []
    >>> for generation in range(12):
    ...     genes, state = solver.ask(state, rng)
    ...     boxes = judge.boxes(genes)
    ...     ratings = -np.array([one[one[:, 3] > 0, 0].mean() for one in boxes])
    ...     state = solver.tell(state, genes, -ratings)
    ...     likings.append(float(ratings.max()))
    >>> likings[-1] > likings[0]
    True
    """

    cells: SiteLattice
    quality: Floats
    population: int = USUAL.population
    crossover: float = USUAL.crossover
    mutation: float = USUAL.mutation
    selection: Literal["tournament", "roulette"] = "tournament"
    points: int = 2
    keep: int = 1
    led: float = 0.5
    local: bool = True
    amount: Amount | None = None
    parents: Floats | None = None
    alike: float = USUAL.alike
    known: int = USUAL.known
    generations: int = USUAL.generations

    def init(self, rng: np.random.Generator, low: Floats, high: Floats) -> Bred:  # noqa: ARG002
        """Nothing judged yet."""
        none = np.empty((0, len(low)))
        return Bred(none, np.empty(0), 0, -1, 0, Asked(), none)

    def ask(self, state: Bred, rng: np.random.Generator) -> tuple[Floats, Bred]:
        """Layouts to be judged: given parents and random ones at first, then children of the last
        generation. Those asked before are known, and not asked again: a generation that holds
        nothing new is followed by the next. None, if nothing new comes of many, or after the
        last generation."""
        for _ in range(min(self.known, self.generations - state.age)):
            rows, made = (
                (self._first(rng), Operations()) if state.age == 0 else self._next(state, rng)
            )
            new = state.asked.new_among(rows)
            state = state._replace(waiting=rows, operations=made)
            if len(new):
                return new, state
            state = self.tell(state, new, np.empty(0))
        return state.waiting[:0], state

    def _first(self, rng: np.random.Generator) -> Floats:
        drawn = [
            random_genes(self.cells, rng, self.quality, self.led) for _ in range(self.population)
        ]
        rows = np.array(drawn, float).reshape(self.population, -1)
        if self.parents is not None:
            rows = np.vstack([self.parents, rows])[: len(rows)]
        return np.array([self._mend(row, rng) for row in rows])

    def _mend(self, row: Floats, rng: np.random.Generator) -> Floats:
        """A chromosome as a row, with what it lacks where operators are repaired."""
        if self.amount is None:
            return row
        genes = row.reshape(-1, 3).astype(np.int64)
        refill(self.cells, genes, self.amount, rng)
        return genes.reshape(-1).astype(float)

    def _mutate(self, child: Ints, rng: np.random.Generator) -> None:
        """Single-point mutation in place, as printed or repaired."""
        if self.amount is None:
            mutate(self.cells, child, rng)
        else:
            mutate_surely(self.cells, child, self.amount, rng)

    def _next(self, state: Bred, rng: np.random.Generator) -> tuple[Floats, Operations]:
        """The kept best and children, and what made them."""
        order = np.argsort(state.energies, kind="stable")
        parents = state.genes.astype(np.int64).reshape(len(order), -1, 3)
        if self.local and state.settled >= 0:
            children, made = self._around(parents[order[0]], rng), Operations()
        else:
            children, made = self._breed(parents, state.energies, rng)
        rows = [*parents[order[: self.keep]], *children][: self.population]
        return np.array(rows, float).reshape(self.population, -1), made

    def _around(self, best: Ints, rng: np.random.Generator) -> list[Ints]:
        """Local search: the best one with one to three mutations."""
        children = [best.copy() for _ in range(self.population)]
        for child in children:
            for _ in range(int(rng.integers(1, 4))):
                self._mutate(child, rng)
        return children

    def _breed(
        self, parents: Ints, energies: Floats, rng: np.random.Generator
    ) -> tuple[list[Ints], Operations]:
        """Global search: parents drawn, crossed, repaired, mutated."""
        draw = tournament if self.selection == "tournament" else roulette
        chosen = draw(energies, 2 * ((self.population + 1) // 2), rng)
        children, done = list[Ints](), Operations(len(chosen) // 2)
        for a, b in chosen.reshape(-1, 2):
            pair = parents[a].copy(), parents[b].copy()
            if rng.random() < self.crossover:
                done = done._replace(crossed=done.crossed + 1)
                crossed = cross(parents[a], parents[b], rng, self.points)
                pair = (
                    repair_genes(self.cells, crossed[0], rng),
                    repair_genes(self.cells, crossed[1], rng),
                )
                if self.amount is not None:
                    for one in pair:
                        refill(self.cells, one, self.amount, rng)
            children += pair
        for child in children:
            if rng.random() < self.mutation:
                done = done._replace(mutated=done.mutated + 1)
                self._mutate(child, rng)
        return children, done

    def tell(self, state: Bred, genes: Floats, energies: Floats) -> Bred:
        """The next generation's parents, what is rated now and what was known; whether they are
        alike by (12)."""
        asked = state.asked.record(genes, energies)
        genes = join(state.waiting, genes)
        energies = asked.energies(genes)
        settled, before = state.settled, state.energies.min(initial=math.inf)
        rated = energies[np.isfinite(energies)]
        rho = spread(-rated, self.alike) if len(rated) > 1 else math.inf
        if settled < 0 and rho <= 0.0:
            settled = state.age + 1
        gained = energies.min() < before - 1e-12
        stalled = 0 if gained or settled < 0 or not self.local else state.stalled + 1
        return state._replace(
            genes=genes,
            energies=energies,
            age=state.age + 1,
            settled=settled,
            stalled=stalled,
            asked=asked,
            waiting=genes[:0],
            rho=rho,
        )


def evolve(
    problem: SiteProblem,
    solver: MatrixGenetic,
    judge: MatrixJudge,
    budget: Budget,
    seed: int,
    progress: Progress | None,
    cancel: Cancel | None,
) -> SiteFound:
    """Breed until the budget is spent or the last generation is bred; without a budget until
    nothing is gained, too."""
    watch, rng = BudgetWatch(budget, progress, cancel), np.random.default_rng(seed)
    rule = problem.settings.matrix
    if budget.steps:
        solver = solver._replace(population=min(solver.population, budget.steps))
    width = solver.cells.fits.shape[2] * 3
    state, done = solver.init(rng, np.zeros(width), np.zeros(width)), 0
    best, least = np.zeros(width), math.inf
    bounded = budget.steps is not None or budget.seconds is not None

    def layout() -> SiteLayout:
        return stand(problem, judge.boxes(best[None])[0])

    tell(budget.hear, "begin", 0, **told_settings(solver), budget=budget.steps)
    while True:
        genes, state = solver.ask(state, rng)
        if not len(genes):
            over = state.age >= solver.generations
            ended = "the last generation" if over else f"nothing new in {solver.known} generations"
            break
        energies = judge.energies(genes)
        state, done = solver.tell(state, genes, energies), done + len(genes)
        first = int(energies.argmin())
        if energies[first] < least:
            best, least = genes[first].copy(), float(energies[first])
        tell_generation(budget, state, done, least)
        full = budget.steps is not None and done + solver.population > budget.steps
        if watch.over(done, least, layout) or full:
            ended = "cancelled" if watch.cancelled() else "the budget is spent"
            break
        if not bounded and state.stalled > rule.stalled:
            ended = f"nothing gained in {rule.stalled} generations of local search"
            break
    tell(budget.hear, "stop", state.age, reason=ended, evaluations=done, best=-least)
    settled = state.settled if state.settled >= 0 else state.age
    return answer(problem, judge.boxes(best[None])[0], done, settled)


def told_settings(solver: MatrixGenetic) -> dict[str, Any]:
    """The parameters of an algorithm as a trace tells them."""
    known = ("population", "generations", "crossover", "mutation", "selection", "points", "keep")
    found = {name: getattr(solver, name) for name in (*known, "local", "alike")}
    parents = 0 if solver.parents is None else len(solver.parents)
    return found | {"templates": parents, "refilled": solver.amount is not None}


def tell_generation(budget: Budget, state: Bred, done: int, least: float) -> None:
    """Tell a generation: whether it searched the whole space or around the best, how it was bred,
    the values (22) of its layouts and of the best so far, and ρ of (12)."""
    tell(
        budget.hear,
        "generation",
        state.age,
        stage="global" if state.settled < 0 or state.settled == state.age else "local",
        evaluations=done,
        population=len(state.energies),
        values=-state.energies,
        best=-least,
        rho=state.rho,
        settled=state.settled if state.settled >= 0 else None,
        **state.operations._asdict(),
    )


def viewpoint_site(
    problem: SiteProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:
    """The paper's algorithm with its measure in place of the person; a step is a layout. Once all
    are alike by (12), it searches around the best. In the form printed, (22) alone judges, and
    crossover and mutation lose what they lose."""
    cells, printed = make_cells(problem), problem.form == "printed"
    rule = problem.settings.matrix
    amount = make_amount(problem.target, cells, problem.buildings.floors)
    solver = MatrixGenetic(
        cells,
        problem.buildings.quality,
        rule.population,
        rule.crossover,
        rule.mutation,
        amount=amount if not printed or amount.covered > 0.0 else None,
        parents=seed_layouts(problem, cells, rule.templates, seed),
        alike=rule.alike,
        known=rule.known,
        generations=rule.generations,
    )
    judge = make_judge(problem, cells)._replace(position=0.0 if printed else rule.position)
    return evolve(problem, solver, judge, budget, seed, progress, cancel)


def simple_site(
    problem: SiteProblem,
    budget: Budget,
    seed: int = 0,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
) -> SiteFound:
    """The simple genetic algorithm (Goldberg 1989) over the same code and measure: selection in
    proportion to fitness, one-point crossover, nobody kept, no local search. What crossover loses
    is put back as for the paper's algorithm, but in the form printed."""
    cells, rule = make_cells(problem), problem.settings.matrix
    amount = make_amount(problem.target, cells, problem.buildings.floors)
    solver = MatrixGenetic(
        cells,
        problem.buildings.quality,
        rule.population,
        rule.crossover,
        rule.mutation,
        selection="roulette",
        points=1,
        keep=0,
        led=0.0,
        local=False,
        amount=amount if problem.form != "printed" or amount.covered > 0.0 else None,
        known=rule.known,
        generations=rule.generations,
    )
    return evolve(problem, solver, make_judge(problem, cells), budget, seed, progress, cancel)
