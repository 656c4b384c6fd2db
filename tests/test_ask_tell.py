"""What whoever rates layouts, perhaps a person, may rely on: ask and tell of every solver."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
import pytest
from benchmarks.site_instances import example_site

from scenewright.domains.home.solvers.random_search import RandomDraws
from scenewright.domains.site.encodings.cell_moves import random_genes
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.genetic import MatrixGenetic
from scenewright.domains.site.solvers.lattice import SiteLattice, make_cells
from scenewright.engine.genetic import PaperGenetic, roulette
from scenewright.engine.solve import Budget, BudgetWatch, Floats, run_population
from scenewright.engine.swarm import Swarm

LOW, HIGH = np.full(3, -5.0), np.full(3, 5.0)
FIRST = np.random.default_rng(5).uniform(LOW, HIGH, (10, 3))
EVERY = pytest.mark.parametrize("name", ["genetic", "swarm", "random", "matrix", "matrix-roulette"])


@cache
def problem() -> SiteProblem:
    return example_site(4, 80.0)


@cache
def cells() -> SiteLattice:
    return make_cells(problem())


def matrix(**more: Any) -> MatrixGenetic:
    return MatrixGenetic(cells(), problem().buildings.quality, **more)


@cache
def solver_named(name: str) -> Any:
    makers: dict[str, Callable[[], Any]] = {
        "genetic": lambda: PaperGenetic(population=10, generations=30, mutation=0.1, crossover=0.3),
        "swarm": lambda: Swarm(FIRST),
        "random": lambda: RandomDraws(10),
        "matrix": matrix,
        "matrix-roulette": lambda: matrix(selection="roulette"),
    }
    return makers[name]()


def rate(genes: Floats) -> Floats:
    return ((genes - 0.5) ** 2).sum(1)


@EVERY
def test_nothing_is_asked_twice(name: str) -> None:
    rng, seen = np.random.default_rng(1), set[bytes]()
    state = solver_named(name).init(rng, LOW, HIGH)
    for _ in range(30):
        genes, state = solver_named(name).ask(state, rng)
        asked = [row.tobytes() for row in genes]
        assert len(set(asked)) == len(asked)
        assert seen.isdisjoint(asked)
        seen.update(asked)
        state = solver_named(name).tell(state, genes, rate(genes))
    assert len(seen) > 60


@EVERY
def test_what_is_not_rated_never_wins(name: str) -> None:
    """Rows far from the best are rated, those nearer to it are not."""
    rng, solver = np.random.default_rng(2), solver_named(name)
    state = solver.init(rng, LOW, HIGH)
    for _ in range(12):
        genes, state = solver.ask(state, rng)
        energies = rate(genes)
        rated = energies >= np.median(energies) if len(energies) else energies > 0.0
        state = solver.tell(state, genes, np.where(rated, energies, np.nan))
        if name not in ("random",):
            kept = getattr(state, "bests", None)
            kept = state.genes if kept is None else kept
            best = kept[state.energies.argmin()]
            assert np.isfinite(state.energies.min())
            assert any(np.array_equal(best, row) for row in kept[np.isfinite(state.energies)])


def test_a_run_answers_with_what_was_rated() -> None:
    def objective(genes: Floats) -> Floats:
        return np.where(genes[:, 0] < 0.0, np.nan, rate(genes))

    watch = BudgetWatch(Budget(), None, None)
    rng = np.random.default_rng(0)
    genes, energies, _ = run_population(
        PaperGenetic(population=10), objective, LOW, HIGH, rng, watch, tuple, 20
    )
    assert genes[0, 0] >= 0.0
    assert np.isfinite(energies[0])
    assert not np.isnan(energies).any()


@pytest.mark.parametrize("name", ["genetic", "swarm", "matrix"])
def test_when_nothing_is_rated_others_are_asked(name: str) -> None:
    rng, solver = np.random.default_rng(3), solver_named(name)
    first, state = solver.ask(solver.init(rng, LOW, HIGH), rng)
    state = solver.tell(state, first, np.full(len(first), np.nan))
    second, _ = solver.ask(state, rng)
    assert len(second)
    assert {row.tobytes() for row in first}.isdisjoint(row.tobytes() for row in second)


def test_given_parents_are_asked_first() -> None:
    rng, parents = np.random.default_rng(4), np.array([[1.0, 2.0, 3.0], [9.0, 0.0, 0.0]])
    solver = PaperGenetic(population=6, parents=parents)
    genes, _ = solver.ask(solver.init(rng, LOW, HIGH), rng)
    assert genes[:2].tolist() == [[1.0, 2.0, 3.0], [5.0, 0.0, 0.0]]
    assert len(genes) == 6
    layout = random_genes(cells(), rng).astype(float).reshape(1, -1)
    bred = matrix(parents=layout)
    genes, _ = bred.ask(bred.init(rng, layout[0], layout[0]), rng)
    assert np.array_equal(genes[0], layout[0])
    assert len(genes) == bred.population
    places, _ = Swarm(FIRST).ask(Swarm(FIRST).init(rng, LOW, HIGH), rng)
    assert np.array_equal(places, FIRST)


def test_parents_that_are_rated_already_are_bred_from() -> None:
    rng, solver = np.random.default_rng(6), solver_named("genetic")
    parents = np.full((10, 3), 0.5) + 0.01 * np.arange(10)[:, None]
    state = solver.tell(solver.init(rng, LOW, HIGH), parents, rate(parents))
    genes, _ = solver.ask(state, rng)
    assert np.median(rate(genes)) < 1.0


def test_roulette_draws_only_what_is_rated() -> None:
    energies = np.array([np.inf, 3.0, 1.0, np.inf])
    assert set(roulette(energies, 200, np.random.default_rng(0)).tolist()) == {2}
    equal = np.array([np.inf, 2.0, 2.0])
    assert set(roulette(equal, 200, np.random.default_rng(0)).tolist()) == {1, 2}
