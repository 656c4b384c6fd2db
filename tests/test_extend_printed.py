"""The paper's growth, equation by equation: what is printed, what it does, what is repaired."""

from __future__ import annotations

import numpy as np
import pytest

import scenewright as sw
from scenewright.domains import problems
from scenewright.domains.extend.areas import OLD
from scenewright.domains.extend.printed import (
    GOLDEN,
    PlotGrid,
    aims_of,
    allele_values,
    attract,
    fitness,
    next_evaporation,
    tree_length,
)
from scenewright.domains.extend.solvers.ants import BestAnt, run_ants, update_trails
from scenewright.domains.extend.solvers.colony import (
    ColonySettings,
    anneal_plots,
    breed,
    draw_plots,
    mutate,
    swap_blocks,
)
from scenewright.domains.extend.solvers.paper import grid_of

EVEN = np.full(4, 0.25)
REPAIRED = ColonySettings(printed=False)


def plots(rows: int = 6, columns: int = 8, wanted: float = 2400.0) -> PlotGrid:
    x, y = np.meshgrid(np.arange(columns) * 20.0, np.arange(rows) * 20.0)
    free = np.ones((rows, columns), bool)
    return PlotGrid(np.stack([x, y], -1), free, np.array([80.0, 120.0, 200.0]), wanted)


def test_aims_are_one_where_they_should_be() -> None:
    grid = plots(5, 8, wanted=40 * 80.0)
    use, mirror, golden, path = aims_of(grid, np.ones((5, 8), int))
    assert (use, mirror, path) == pytest.approx((1.0, 1.0, 1.0))
    assert golden == pytest.approx(1 - abs(8 / 5 - GOLDEN) / GOLDEN)
    assert aims_of(grid, np.zeros((5, 8), int)).tolist() == [0, 0, 0, 0]
    lopsided = np.ones((5, 8), int)
    lopsided[:, :3], lopsided[:2] = 2, 3
    assert aims_of(grid, lopsided)[1] < 1.0


def test_f_is_the_weighted_sum_of_the_aims() -> None:
    grid, genes = plots(), np.random.default_rng(0).integers(0, 4, (6, 8))
    weights = np.array([0.4, 0.3, 0.2, 0.1])
    assert fitness(grid, genes, weights) == pytest.approx(float(aims_of(grid, genes) @ weights))


def test_the_tree_is_as_short_as_any() -> None:
    points = np.random.default_rng(1).uniform(0, 100, (30, 2))
    away = np.hypot(*(points[:, None] - points[None]).transpose(2, 0, 1))
    joined, total, parent = sorted((away[a, b], a, b) for a in range(30) for b in range(a)), 0.0, {}

    def root(k: int) -> int:
        while k in parent:
            k = parent[k]
        return k

    for length, a, b in joined:
        if root(a) != root(b):
            parent[root(a)] = root(b)
            total += length
    assert tree_length(points) == pytest.approx(total)


def test_attractors_draw_and_repel() -> None:
    """(14) with κ + λ + μ = 1 and Σ ω = 1; a negative ω repels."""
    points = np.array([[0.0, 0, 0], [10.0, 0, 0]])
    mix = np.array([0.5, 0.3, 0.2])
    found = attract(points, np.array([[0.0, 0, 0], [10, 0, 0]]), np.array([1.5, -0.5]), mix)
    assert found.tolist() == pytest.approx([-0.5 * 5, 1.5 * 5])


def test_trails_of_ants_far_from_the_best_are_drawn_to_its_fitness() -> None:
    """(15) with p >= p0, then the way of the best by rho* of table 1."""
    flat, rule = np.full((6, 6), 0.05), ColonySettings()
    ways = tuple(np.array(way) for way in ([0, 1], [2, 3], [2, 3], [4, 5]))
    values = np.array([0.9, 0.9 * 0.75, 0.9 * 0.7, 0.9 * 0.95])
    after, far = update_trails(flat, ways, values, BestAnt(ways[0], 0.9), 0.5, rule)
    assert far == 2
    assert after[2, 3] == after[3, 2] == pytest.approx(0.25 * 0.05 + 0.75 * 0.9)
    assert after[0, 1] == pytest.approx(0.7 * 0.05 + 0.3 * 0.9)
    assert after[4, 5] == after[0, 2] == 0.05
    repaired, _ = update_trails(flat, ways, values, BestAnt(ways[0], 0.9), 0.5, REPAIRED)
    assert repaired[0, 1] > 2 * repaired[0, 4]
    assert repaired[2, 3] == repaired[0, 4] < 0.05


def test_evaporation_of_the_preset_falls_to_its_least() -> None:
    """From rho of table 1, with a and b at the end of the printed ranges."""
    rule, rates = ColonySettings(), [ColonySettings().local]
    for step in range(1, 6):
        rates.append(next_evaporation(rates[-1], step, rule.a, rule.b, rule.least))
    assert rates[0] == 0.5 > rates[1] > rates[2] > rule.least == rates[-1]


def test_evaporation_grows_without_bound_or_falls_to_its_least() -> None:
    """(16) and (17): ρ = c is a fixed point, and unstable; nothing between is held."""
    found = {}
    for a in (0.2, 0.5, 3.0):
        rate = 0.5
        for step in range(1, 60):
            rate = min(next_evaporation(rate, step, a, 6.0, 0.1), 1e9)
        found[a] = rate
    assert found[0.2] == 1e9
    assert found[3.0] == 0.1
    assert found[0.5] in (0.1, 1e9)


def test_the_printed_allele_value_is_that_of_those_who_do_not_carry_it() -> None:
    elites = np.array([[[1]], [[1]], [[2]]])
    values = np.array([0.4, 0.6, 0.9])
    assert allele_values(elites, values, 2)[0, 0].tolist() == [0.0, 0.5, 0.9]
    printed = allele_values(elites, values, 2, as_printed=True)[0, 0]
    assert printed.tolist() == pytest.approx([(0.4 + 0.6 + 0.9) / 3, 0.9, 0.5])


def test_blocks_are_swapped_whole_and_genes_mutate_by_worth() -> None:
    rng = np.random.default_rng(0)
    one, other = np.zeros((6, 6), int), np.ones((6, 6), int)
    for _ in range(30):
        child = swap_blocks(one, other, rng)
        rows, columns = np.flatnonzero(child.any(1)), np.flatnonzero(child.any(0))
        if len(rows):
            assert child[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1].all()
    worth = np.zeros((6, 6, 3))
    worth[..., 2] = 50.0
    assert (mutate(one, worth, np.ones((6, 6), bool), rng) == 2).mean() > 0.95


def test_searches_look_at_as_many_layouts_as_they_may_and_beat_chance() -> None:
    grid = plots()
    found = {}
    for name, run in (
        ("ants", run_ants),
        ("breeding", breed),
        ("annealing", anneal_plots),
        ("random", draw_plots),
    ):
        runs = [run(grid, EVEN, 400, np.random.default_rng(seed)) for seed in range(3)]
        assert all(len(one.history) == 400 for one in runs)
        assert all(np.diff(one.history).min() >= 0 for one in runs)
        found[name] = float(np.median([one.value for one in runs]))
    assert found["annealing"] > found["random"]
    assert found["breeding"] > 0.9 * found["random"]


def test_plots_lie_on_free_ground_at_the_pitch_of_the_source() -> None:
    (problem,) = problems(sw.read("sample:extend-court"))
    grid = grid_of(problem)
    assert grid.free.any()
    steps = np.hypot(*np.diff(grid.middles, axis=1).reshape(-1, 2).T)
    assert np.ptp(steps) < 1e-6
    assert steps.mean() > 40.0


@pytest.mark.parametrize("preset", ["paper", "paper-repaired"])
def test_presets_of_the_paper_grow_without_a_fault(preset: str) -> None:
    solution = sw.solve(sw.read("sample:extend-terrace"), preset=preset, steps=120)
    assert sw.check(solution).valid
    new = [piece for piece in solution.pieces if piece.space != OLD]
    assert len(new) > 8
    again = sw.solve(sw.read("sample:extend-terrace"), preset=preset, steps=120)
    assert again.pieces == solution.pieces
