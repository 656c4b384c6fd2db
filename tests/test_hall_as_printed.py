"""The equations of Cao, Cheng and Zhang (2024), each separately: preset `paper` is what they print.

Eqs. 7 to 9 are tested in `test_check_hall_measures`, patterns in `test_patterns`, walls in
`test_hall_walls`; here is what the energy and the chain are made of.
"""

from __future__ import annotations

import math

import numpy as np
import pytest

from hall_chains import posed, two_zones
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain
from scenewright.domains.hall.solvers.printed_metropolis import run_printed
from scenewright.domains.hall.terms.place import unfold
from scenewright.domains.hall.terms.table import (
    ACCESS,
    FILL,
    PROPORTION,
    SPACE,
    access_cost,
    barrier,
    fill_cost,
    proportion_cost,
    space_cost,
)
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.domains.hall.zoning.assign import KAPPA, area_of, assign, length_of
from scenewright.engine.draws import streams

PAIR = {
    "id": "cases",
    "category": "showcase",
    "count": 2,
    "size": [1.2, 0.6, 1.0],
    "clearance": 0.5,
    "zone": "west",
    "patterns": ["chain"],
}


def phi(x: float) -> float:
    return 1.0 / (x + math.sqrt(x * x + 0.05**2))


def chain_of(preset: str, gap: float | None = None) -> HallChain:
    """Two showcases 1.2 m wide in a row, their gap as it is set."""
    fitted = posed(two_zones(PAIR), preset).fitted
    chain = begin_chain(fitted.problem, fitted.start, streams(0, 1)[0])
    if gap is not None:
        chain.s.layers[:, 1:3] = gap
        chain.s.pose[0, :2] = 5.0, 5.0
        unfold(chain.p, chain.s, chain.work, 0)
    measure_all(chain.p, chain.s, chain.work)
    return chain


@pytest.mark.parametrize("alpha", [0.0, 0.4, 3.0])
def test_eq_1_space(alpha):
    share = 1.0 / (1.0 + math.exp(-alpha))
    assert space_cost(alpha, 1.0) == pytest.approx(phi(1.5 - 3.0 * share))
    repaired = phi(1.5 - 3.0 / (1.0 + math.exp(-alpha / 2.5)))
    assert space_cost(alpha, 2.5) == pytest.approx(repaired)


def test_eq_1_is_divided_by_the_clearance_demanded():
    demanded = 2 * (2.2 * 1.6 - 1.2 * 0.6)
    for preset in ("paper", "paper-repaired"):
        assert chain_of(preset).p.beta.tolist() == pytest.approx([demanded])
    close = chain_of("paper", gap=0.4)  # 0.6 of the 1.0 m between them is shared, 1.6 m deep
    assert close.s.covered[0, 0] == pytest.approx(0.6 * 1.6, rel=1e-6)
    assert close.s.costs[SPACE, 0] == pytest.approx(space_cost(close.s.covered[0].sum(), demanded))


@pytest.mark.parametrize("x", [-1.0, 0.0, 0.03, 2.0])
def test_eq_2_barrier(x):
    assert barrier(x) == pytest.approx(phi(x), rel=1e-9)


def test_eq_3_fill():
    assert fill_cost(0.3, 0.5) == pytest.approx(phi(1.0 - 0.3 / 0.5))
    chain = chain_of("paper")
    used = 2 * 2.2 * 1.6 / 100.0
    assert chain.s.costs[FILL, 0] == pytest.approx(fill_cost(chain.p.least[0], used))
    assert chain.s.costs[FILL, 1] == 0.0


def test_eq_4_access():
    assert access_cost(1.8, 1.5) == pytest.approx(math.exp(0.3) - 1.0)
    assert access_cost(1.8, 1.9) == 0.0
    assert chain_of("paper").s.costs[ACCESS, 0] == 0.0


@pytest.mark.parametrize("gap", [1.0, 2.0, 3.0])
def test_eq_5_proportion(gap):
    most = 0.5 + 0.5 + 1.0  # the clearances of both and Z
    assert proportion_cost(gap, most) == pytest.approx(phi(1.0 - max(gap - most, 0.0) / most))
    chain = chain_of("paper", gap)
    assert chain.s.costs[PROPORTION, 0] == pytest.approx(proportion_cost(gap, most), rel=1e-6)


def test_eq_6_weights_are_one_and_energies_add_up():
    printed = dict.fromkeys(("space", "fill", "access", "proportion"), 1.0)
    assert PRESETS["paper"].weights == PRESETS["paper-repaired"].weights == printed
    chain = chain_of("paper", 2.5)
    total = sum(chain.s.costs[term].sum() for term in (SPACE, FILL, ACCESS, PROPORTION))
    assert measure_all(chain.p, chain.s, chain.work) == pytest.approx(float(total))


def test_utilisation_of_area_and_wall():
    """U_a = Σ A / A_r and U_w = Σ L / L_r of the whole hall; a zone keeps within U + κ."""
    found = posed(two_zones(PAIR), "paper")
    wish = found.wishes[0]
    assert area_of(wish) == pytest.approx(2.2 * 1.6)
    assert length_of(wish._replace(patterns=("wall",))) == pytest.approx(1.2 + 1.0)
    assert length_of(wish) == 0.0
    many = [wish._replace(id=str(k), zones=()) for k in range(4)]
    areas = np.array([40.0, 40.0])
    share = 8 * area_of(wish) / 80.0
    units = assign(many, ("west", "east"), areas, np.array([20.0, 20.0]), True)
    for zone in range(2):
        used = sum(2 * area_of(wish) for unit in units if unit.zone == zone) / 40.0
        assert used <= share + KAPPA
    assert len({unit.zone for unit in units}) == 2


def test_the_chain_has_the_printed_schedule():
    """1000 iterations, λ = 0.1 in f = exp(-λE)."""
    for preset in ("paper", "paper-repaired"):
        row = PRESETS[preset]
        assert (row.solver, row.steps) == ("gd-mh", 1000)
        assert row.settings.guided[:2] == (1000, 0.1)


def test_moves_are_taken_by_the_ratio_of_f():
    """min(1, f' / f): a λ that forbids all rises lets none happen, that of the paper many."""
    rises = {}
    for rate in (0.1, 1e9):
        chain, seen = chain_of("paper-repaired"), []
        stuck, schedule = np.zeros(1, np.int64), np.array([rate, rate, 400.0, 0.0])
        for step in range(400):
            parts = (chain.p, chain.s, chain.work, chain.grid, chain.bits, chain.inset)
            told = (schedule, chain.problem.settings.guided, stuck, step, 1)
            ends = (chain.stream, chain.tally, *told, chain.last, chain.best)
            before = float(chain.tally[0])
            run_printed(*parts, *ends)
            seen.append(float(chain.tally[0]) - before)
        rises[rate] = [rise for rise in seen if rise > 1e-9]
    assert not rises[1e9]
    assert len(rises[0.1]) > 20


def test_steps_are_halved_by_the_middle_of_the_run():
    """U(·) max((I - i) / I, 0.5): what one iteration moves a single object at most."""
    moved = {}
    for first in (0, 990):
        far = 0.0
        for seed in range(60):
            fitted = posed(two_zones(PAIR | {"count": 1}), "paper").fitted
            chain = begin_chain(fitted.problem, fitted.start, streams(seed, 1)[0])
            measure_all(chain.p, chain.s, chain.work)
            before = chain.s.frames[0, :2].copy()
            schedule, stuck = np.array([0.1, 0.1, 1000.0, 0.0]), np.zeros(1, np.int64)
            parts = (chain.p, chain.s, chain.work, chain.grid, chain.bits, chain.inset)
            told = (schedule, chain.problem.settings.guided, stuck, first, 1)
            ends = (chain.stream, chain.tally, *told, chain.last, chain.best)
            run_printed(*parts, *ends)
            far = max(far, float(np.hypot(*(chain.s.frames[0, :2] - before))))
        moved[first] = far
    assert moved[990] < moved[0]
