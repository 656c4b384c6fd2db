"""What the preset ``paper`` of sites takes from Zhang and Yang (2023), coefficient by coefficient,
and what ``paper-repaired`` changes."""

from __future__ import annotations

import json

import numpy as np
import pytest

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import check, plan_of
from scenewright.domains.site.encodings.cell_moves import (
    cross,
    mutate,
    random_genes,
    repair_genes,
    spread,
)
from scenewright.domains.site.encodings.refill import (
    count_kinds,
    make_amount,
    measure_amount,
    mutate_surely,
    refill,
)
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.solvers.genetic import MatrixGenetic, viewpoint_site
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge
from scenewright.domains.site.solving import build_site_problem, problems
from scenewright.domains.site.terms.value import OMEGA
from scenewright.engine.solve import Budget
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.saliency import saliency, sum_over_vertices

BRIEF = sw.read("sample:site-30")
PROBLEM = problems(BRIEF)[0]
CELLS = make_cells(PROBLEM)
AMOUNT = make_amount((0.0, 0.0), CELLS, PROBLEM.buildings.floors)


def test_coefficients():
    rule = PRESETS["paper"].settings.matrix
    assert rule[:4] == (10, 200, 0.75, 0.04)
    solver = MatrixGenetic(CELLS, PROBLEM.buildings.quality)
    assert (solver.selection, solver.points) == ("tournament", 2)
    assert sum(OMEGA) == pytest.approx(1.0)
    assert max(OMEGA) == OMEGA[1]
    assert min(OMEGA) == OMEGA[2]
    assert PRESETS["paper"].steps == rule.population * rule.generations
    assert PRESETS["paper"].settings.measure == "printed"
    assert PRESETS["paper-repaired"].settings.measure == "relief"


def test_equation_8_adds_up_the_vertices():
    cube = Mesh(
        np.array([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)]),
        np.array([[0, 1, 3], [0, 3, 2], [4, 7, 5], [4, 6, 7], [0, 5, 1], [0, 4, 5]]),
    )
    found = saliency(cube)
    assert sum_over_vertices(found) == pytest.approx(sum(found.vertices.tolist()))


def test_equation_12_ends_the_global_search_and_the_local_one_goes_on():
    assert spread(np.array([0.4, 0.4]), 0.01) == pytest.approx(-0.01)
    printed = problems(BRIEF, "paper")[0]
    found = viewpoint_site(printed, Budget(steps=600), 0)
    assert found.layouts[0].generations < 30
    assert found.evaluations > 400


def test_printed_operators_lose_buildings_and_repaired_ones_do_not():
    rng = np.random.default_rng(0)
    whole = [random_genes(CELLS, rng, PROBLEM.buildings.quality, 0.5) for _ in range(40)]
    for genes in whole:
        refill(CELLS, genes, AMOUNT, rng)
    before = np.mean([count_kinds(CELLS, genes).sum() for genes in whole])
    assert before > 28.5
    children = [
        repair_genes(CELLS, child, rng)
        for a, b in zip(whole[::2], whole[1::2], strict=True)
        for child in cross(a, b, rng)
    ]
    assert np.mean([count_kinds(CELLS, genes).sum() for genes in children]) < before - 1.5
    for genes in children:
        refill(CELLS, genes, AMOUNT, rng)
        assert np.array_equal(repair_genes(CELLS, genes, rng), genes)
    assert np.mean([count_kinds(CELLS, genes).sum() for genes in children]) > before - 0.7


def test_printed_mutations_often_change_nothing_and_repaired_ones_do():
    rng = np.random.default_rng(1)
    start = random_genes(CELLS, rng)
    refill(CELLS, start, AMOUNT, rng)
    same = {mutate: 0, mutate_surely: 0}
    for _ in range(60):
        for change in same:
            genes = start.copy()
            given = (AMOUNT, rng) if change is mutate_surely else (rng,)
            change(CELLS, genes, *given)
            same[change] += np.array_equal(genes, start)
            if change is mutate_surely:
                assert count_kinds(CELLS, genes).sum() >= count_kinds(CELLS, start).sum()
    assert same[mutate] > 20
    assert same[mutate_surely] <= 3


def test_what_walkers_see_explains_the_value_of_complete_layouts():
    rng, judge = np.random.default_rng(2), make_judge(PROBLEM, CELLS)
    parts = []
    for _ in range(80):
        genes = random_genes(CELLS, rng, PROBLEM.buildings.quality, 0.5)
        refill(CELLS, genes, AMOUNT, rng)
        if count_kinds(CELLS, genes).sum() == 30:
            row = genes.reshape(1, -1).astype(float)
            boxes = judge.boxes(row)[0]
            value = -judge._replace(position=0.0).energies(row)[0]
            assert judge.seen is not None
            parts.append((value, judge.seen(boxes)))
    assert len(parts) > 30
    value, seen = np.array(parts).T
    assert np.corrcoef(value, seen)[0, 1] ** 2 > 0.5


def library(**more):
    site = {
        "outline": [[0, 0], [140, 0], [140, 100], [0, 100]],
        "roads": [{"line": [[0, 50], [140, 50]], "width": 8}],
        "library": [{"model": "villa", "share": 2}, {"model": "row_houses"}, {"model": "pagoda"}],
        "coverage": 0.2,
    }
    return Brief.model_validate({"domain": "site", "name": "L", "sites": [site | more]})


@pytest.mark.parametrize("preset", ["default", "paper", "paper-repaired"])
def test_a_library_brings_the_target(preset):
    brief = library()
    solution = sw.solve(brief, preset=preset, steps=None if preset == "default" else 300)
    assert check(solution).valid
    plan = plan_of(brief).detail[0]
    placed = [p for p in solution.pieces if p.category == "building"]
    covered = sum(p.size.width * p.size.depth for p in placed) / plan.buildable
    assert covered == pytest.approx(0.2, abs=0.045)
    assert {p.asset for p in placed} <= {"villa", "row_houses", "pagoda"}
    assert not solution.left_out


def test_amounts_are_kept_by_repaired_operators():
    brief = library()
    site, plan = brief.part.sites[0], plan_of(brief).detail[0]
    from scenewright.catalog.assets import shipped

    rows, problem = build_site_problem(site, plan, "", shipped(), PRESETS["paper"], None, True)
    assert len(rows) > 20
    cells, rng = make_cells(problem), np.random.default_rng(0)
    amount = make_amount(problem.target, cells, problem.buildings.floors)
    for _ in range(10):
        genes = random_genes(cells, rng)
        refill(cells, genes, amount, rng)
        covered, floors = measure_amount(cells, genes, amount)
        assert covered <= problem.target[0] + cells.sizes.prod(1).max() / 2 + 1e-6
        assert floors > 0.0


def test_a_library_beside_buildings_is_refused():
    with pytest.raises(InputError, match="both buildings and a library"):
        plan_of(library(buildings=[{"model": "villa"}]))
    assert json.loads(library().model_dump_json())["sites"][0]["library"][0]["share"] == 2
