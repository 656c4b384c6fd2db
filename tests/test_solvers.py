"""The contract of every solver in the table, and what annealing's chains promise."""

from __future__ import annotations

import numpy as np
import pytest

from rooms import full_problem, random_layouts
from scenewright.core.layout import Layout
from scenewright.domains.home.energy import costs_of, energies_of, evaluate, prepare, route_grid
from scenewright.domains.home.problem import empty_items
from scenewright.domains.home.solvers import SOLVERS
from scenewright.domains.home.solvers.anneal import anneal, boxes_of, scatter_boxes
from scenewright.domains.home.solvers.chain import make_chains
from scenewright.domains.home.solvers.kept_route import make_route
from scenewright.domains.home.solvers.metropolis import run_chains
from scenewright.engine.draws import bell, below, streams, uniform
from scenewright.engine.genetic import cross, roulette
from scenewright.engine.pace import pace_by_clock
from scenewright.engine.solve import Budget, Report, distinct
from scenewright.geometry.boxes import frames_of

EVERY = pytest.mark.parametrize("name", sorted(SOLVERS))
STEPS = Budget(steps=2000)


def same(a, b):
    return len(a) == len(b) and all(
        np.array_equal(x.boxes, y.boxes) and x.energy == y.energy for x, y in zip(a, b, strict=True)
    )


@EVERY
def test_same_seed_same_result(name):
    problem, run = full_problem(), SOLVERS[name].run
    first, again, other = (run(problem, STEPS, seed) for seed in (3, 3, 4))
    assert same(first.layouts, again.layouts)
    assert first.evaluations == again.evaluations
    assert not same(first.layouts, other.layouts)


@EVERY
def test_found_layouts_are_true_sorted_and_within_limits(name):
    problem = full_problem()
    found = SOLVERS[name].run(problem, STEPS, 0)
    energies = [layout.energy for layout in found.layouts]
    boxes = np.stack([layout.boxes for layout in found.layouts])
    assert energies == sorted(energies)
    assert evaluate(problem, boxes) == pytest.approx(energies)
    assert (boxes[..., 3:] >= problem.items.low - 1e-9).all()
    assert (boxes[..., 3:] <= problem.items.high + 1e-9).all()
    assert found.evaluations >= 1000


@EVERY
def test_solver_beats_the_median_of_random_layouts(name):
    problem = full_problem()
    median = np.median(evaluate(problem, random_layouts(problem, 200)))
    assert SOLVERS[name].run(problem, STEPS, 1).layouts[0].energy < 0.6 * median


@EVERY
def test_progress_is_told_and_cancelling_keeps_the_best_so_far(name):
    told: list[Report] = []
    found = SOLVERS[name].run(full_problem(), Budget(steps=10**7), 0, told.append, lambda: True)
    assert len(told) == 1
    assert 0.0 <= told[0].share < 1.0
    assert isinstance(found.layouts[0], Layout)
    assert found.layouts[0].energy <= told[0].energy + 1e-9


@EVERY
def test_target_ends_the_run(name):
    found = SOLVERS[name].run(full_problem(), Budget(steps=10**8, target=1e9), 0)
    assert found.evaluations < 10**6


@EVERY
def test_seconds_end_the_run(name):
    told: list[Report] = []
    SOLVERS[name].run(full_problem(), STEPS, 0)
    found = SOLVERS[name].run(full_problem(), Budget(seconds=0.05), 0, told.append)
    assert found.evaluations > 0
    shares = [report.share for report in told]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0


@EVERY
def test_a_room_with_nothing_to_place(name):
    problem = full_problem()._replace(items=empty_items(0), names=(), weights={"boundary": 1.0})
    found = SOLVERS[name].run(problem, Budget(steps=100), 0)
    assert found.layouts[0].boxes.shape == (0, 5)


def test_result_does_not_depend_on_threads():
    problem, budget = full_problem(), Budget(steps=30_000)
    one, three = (anneal(problem, budget, 5, threads=count) for count in (1, 3))
    assert same(one.layouts, three.layouts)


@pytest.mark.parametrize("weights", [None, {"route": 900.0}])
@pytest.mark.parametrize("printed", [False, True])
def test_chain_sums_stay_equal_to_a_fresh_evaluation(printed, weights):
    problem = full_problem(printed)
    problem = problem._replace(weights=weights or problem.weights)
    p, grid = prepare(problem), route_grid(problem, 0.1)
    boxes = scatter_boxes(p, 3, np.random.default_rng(0))
    now = np.stack([frames_of(layout) for layout in boxes])
    bests, energies = now.copy(), np.repeat(energies_of(p, grid, boxes)[0][:, None], 2, axis=1)
    route, schedule, draws = make_route(4, grid), np.array([500, 0.01, 0, 1]), streams(1, 3)
    for begin in range(0, 12288, 4096):
        chains, steps = make_chains(now, costs_of(p, grid, now)), (begin, begin + 4096, 12288)
        run_chains(chains, p, grid, route, bests, energies, draws, *steps, schedule)
        assert energies_of(p, grid, boxes_of(now))[0] == pytest.approx(energies[:, 0], abs=1e-6)
        assert energies_of(p, grid, boxes_of(bests))[0] == pytest.approx(energies[:, 1], abs=1e-6)
        assert (energies[:, 1] <= energies[:, 0]).all()


def test_default_is_far_better_than_the_papers_algorithm():
    problem = full_problem()
    ours = [anneal(problem, Budget(steps=20_000), seed).layouts[0].energy for seed in range(3)]
    papers = [SOLVERS["paper-ga"].run(problem, Budget(), s).layouts[0].energy for s in range(3)]
    assert np.mean(ours) < 0.3 * np.mean(papers)


def test_draws_are_even_and_normal():
    stream = streams(7, 1)[0]
    even = np.array([uniform(stream) for _ in range(4000)])
    normal = np.array([bell(stream) for _ in range(4000)])
    assert (even.min() >= 0, even.max() < 1, abs(even.mean() - 0.5) < 0.02) == (True, True, True)
    assert abs(normal.mean()) < 0.06
    assert normal.std() == pytest.approx(1.0, abs=0.05)
    assert {below(stream, 3) for _ in range(100)} == {0, 1, 2}


def test_roulette_prefers_the_fit_and_never_draws_the_worst():
    drawn = roulette(np.array([0.0, 5.0, 10.0]), 3000, np.random.default_rng(0))
    counts = np.bincount(drawn, minlength=3)
    assert counts[2] == 0
    assert counts[0] / counts[1] == pytest.approx(2.0, rel=0.2)


def test_crossover_keeps_the_sum_of_both_parents():
    genes = np.random.default_rng(0).normal(size=(6, 5))
    children = cross(genes, np.array([True, False, True]), np.random.default_rng(1))
    assert children[0::2] + children[1::2] == pytest.approx(genes[0::2] + genes[1::2])
    assert not np.allclose(children, genes)


def test_distinct_drops_what_is_nearly_the_same():
    boxes = np.zeros((3, 1, 5))
    boxes[1, 0, 0], boxes[2, 0, 2] = 0.1, 1.0
    kept = distinct(boxes, np.array([2.0, 1.0, 3.0]))
    assert [layout.energy for layout in kept] == [1.0, 3.0]


def test_the_clock_always_ends_the_schedule_cold():
    shares = [share for _, share in pace_by_clock(0.01, 1e5)]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    assert len(shares) <= 13
