"""Why a site is as good as it is, and the paper's measures in printed and repaired form."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import shapely
from benchmarks.site_instances import example_site
from typer.testing import CliRunner

import scenewright as sw
from scenewright.catalog.appearance import shipped_facts
from scenewright.cli.commands import app
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.settings import ChainSettings
from scenewright.domains.site.solvers.anneal import anneal_site
from scenewright.domains.site.solvers.answer import make_measure, score
from scenewright.domains.site.solvers.genetic import MatrixGenetic, viewpoint_site
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge
from scenewright.domains.site.solving import problems
from scenewright.domains.site.terms.measure import change_of_fitness, commit, fitness, lay
from scenewright.domains.site.terms.table import (
    SITE_AIMS,
    SITE_FIGURES,
    SITE_TERMS,
    fitness_of_cost,
    printed_ratio,
)
from scenewright.engine.solve import Budget
from scenewright.formats import solution_json
from scenewright.geometry.boxes import make_frame


@pytest.fixture(scope="module")
def solution() -> sw.Solution:
    return sw.solve(sw.read("sample:site-landmarks"))


def test_costs_of_terms_add_up_to_the_energy(solution: sw.Solution) -> None:
    assert {term.space for term in solution.terms} == set(solution.energies) == {"quarter"}
    assert sum(t.cost for t in solution.terms) == pytest.approx(solution.energies["quarter"])
    named = {term.term: term for term in solution.terms}
    aims = {row.name for row in SITE_AIMS}
    assert set(named) == {row.name for row in SITE_TERMS} | aims | set(SITE_FIGURES)
    assert named["overlap"].value < 1e-4 > named["left"].value == 0.0
    assert 0.0 < named["seen"].value < 0.5
    assert 0.0 < named["sun"].value <= 8.0
    assert named["seen"].cost == pytest.approx(3.0 * (1.0 - named["seen"].value / 0.4))
    assert 0.0 < named["even"].value < 1.0
    assert named["even"].cost == pytest.approx(0.5 * named["even"].value)
    value = [named[name].value for name in ("use", "shown", "texture", "height")]
    assert named["value"].value == pytest.approx(np.dot(value, (0.2, 0.5, 0.1, 0.2)))


def test_what_stands_round_the_middle_of_its_block_is_even_and_in_a_corner_it_is_not() -> None:
    ground = example_site(3, 200.0).ground
    first, last = ground.block_spans[int(np.argmax(ground.block_areas))]
    edges = ground.block_edges[first:last]
    floor = shapely.Polygon(edges[:, :2])
    middle, size = np.array([floor.centroid.x, floor.centroid.y]), floor.area**0.5
    problem = example_site(3, 200.0)
    about = np.array([[-9.0, 0], [9.0, 0], [0.0, 0]]) + middle
    boxes = np.column_stack([about, np.zeros(3), np.full((3, 2), 6.0)])
    assert score(problem, boxes, np.ones(3, bool))["even"] == pytest.approx(0.0, abs=1e-9)
    boxes[:, 0] += 10.0
    told = score(problem, boxes, np.ones(3, bool))["even"]
    assert told == pytest.approx(20.0 / size)
    assert score(problem, boxes, np.zeros(3, bool))["even"] == 0.0


def test_terms_are_saved_and_explained(solution: sw.Solution, tmp_path: Path) -> None:
    assert solution_json.loads(solution_json.dumps(solution)).terms == solution.terms
    sw.write(solution, tmp_path / "site.json")
    told = CliRunner().invoke(app, ["explain", str(tmp_path / "site.json"), "--terms"])
    assert told.exit_code == 0, told.output
    for word in ("even", "seen", "walkers on the ways see", "F_eva", "generations", "hours of sun"):
        assert word in told.output


def test_models_count_as_they_look() -> None:
    problem = problems(sw.read("sample:site-landmarks"))[0]
    names = [name.partition("/")[2].rpartition("_")[0] for name in problem.names]
    facts = [shipped_facts()[name] for name in names]
    assert problem.buildings.tone.tolist() == [row.tone for row in facts]
    assert problem.buildings.symmetry.tolist() == [row.symmetry for row in facts]
    order = np.argsort([row.relief for row in facts], kind="stable")
    assert (np.diff(problem.buildings.quality[order]) >= 0).all()
    assert problem.ground.landmark_quality.tolist() == pytest.approx(
        [
            shipped_facts()[name].relief / shipped_facts()["pagoda"].relief
            for name in ("gothic_church", "pagoda")
        ]
    )
    assert problem.buildings.sides.shape == (len(names), 5)
    printed = problems(sw.read("sample:site-landmarks"), "paper")[0]
    assert printed.form == "printed"
    assert (printed.buildings.quality != problem.buildings.quality).any()
    assert (printed.buildings.sides == problem.buildings.sides).all()


def test_a_move_changes_the_printed_fitness_by_what_the_whole_says() -> None:
    problem, rng = example_site(10, 110.0), np.random.default_rng(2)
    measure = make_measure(problem)
    boxes = np.column_stack(
        [rng.uniform(10, 90, (10, 2)), rng.uniform(0, 6, 10), problem.buildings.sizes[:, :2]]
    )
    lay(measure.p, measure.s, boxes)
    for _ in range(20):
        i = int(rng.integers(10))
        boxes[i, :3] = [*rng.uniform(10, 90, 2), rng.uniform(0, 6)]
        frame = make_frame(*boxes[i].tolist())
        before = whole(measure)
        assert fitness(measure.p, measure.s, 1e3, 0.0) == pytest.approx(before)
        change = change_of_fitness(measure.p, measure.s, i, frame, 1e3)
        commit(measure.p, measure.s, i, frame)
        lay(measure.p, measure.s, boxes)
        assert change == pytest.approx(before - whole(measure), abs=1e-9)
    assert fitness(measure.p, measure.s, 1e-9, 0.0) == 0.0


def whole(measure) -> float:
    ratio = printed_ratio(measure.s.sums, np.abs(measure.p.weights))
    return float(fitness_of_cost(ratio, 1e3))


def test_annealing_as_printed_lowers_the_ratio_and_pays_nothing_for_what_it_leaves_out() -> None:
    problem = example_site(8, 120.0)._replace(form="printed")
    budgets = Budget(steps=1), Budget(steps=200_000)
    ends = [anneal_site(problem, budget, 0).layouts[0] for budget in budgets]
    ratios = [score(problem, end.boxes, end.present)["ratio"] for end in ends]
    assert ratios[1] < ratios[0] < ChainSettings().most
    other = problem._replace(form="repaired")
    assert anneal_site(other, budgets[1], 0).layouts[0].present.all()
    assert not ends[1].present.all()


def test_the_printed_algorithm_judges_by_value_alone_and_searches_on_when_all_are_alike() -> None:
    problem = example_site(8, 120.0)._replace(form="printed")
    cells = make_cells(problem)
    genes, _ = MatrixGenetic(cells, problem.buildings.quality).ask(
        MatrixGenetic(cells, problem.buildings.quality).init(
            np.random.default_rng(0), np.zeros(3), np.zeros(3)
        ),
        np.random.default_rng(0),
    )
    judge = make_judge(problem, cells)._replace(position=0.0)
    boxes = judge.boxes(genes)
    values = [score(problem, one, one[:, 3] > 0)["value"] for one in boxes]
    assert judge.energies(genes) == pytest.approx(-np.array(values))
    for one in (problem, problem._replace(form="repaired")):
        found = viewpoint_site(one, Budget(None, 2000, threads=None), 0)
        assert 10 * found.layouts[0].generations < 300 < found.evaluations <= 2000


def test_paper_presets_are_the_papers() -> None:
    for name in ("paper", "paper-repaired"):
        assert PRESETS[name].solver == "vp"
        assert PRESETS[name].steps == 10 * 200
    solved = sw.solve(sw.read("sample:site-courtyards"), preset="paper")
    told = {term.term: term.value for term in solved.terms}
    assert solved.evaluations <= 10 * 200
    assert told["generations"] <= 200
