"""Planar forms asked for in a brief: they reach the layout, and a wrong one is told in one line."""

from __future__ import annotations

import json

import numpy as np
import pytest

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import check, plan_of
from scenewright.domains.site.encodings.cells import decode
from scenewright.domains.site.encodings.forms import FORMS as TEMPLATE_FORMS
from scenewright.domains.site.solvers.blocks.block import FORMS
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.seed_layouts import seed_layouts
from scenewright.domains.site.solving import problems
from scenewright.geometry.rectangles import largest_rectangle

SOUTH = -np.pi / 2


def asked(form, count=8, **more):
    site = {
        "outline": [[0, 0], [120, 0], [120, 100], [0, 100]],
        "roads": [{"line": [[0, 50], [120, 50]], "width": 8}],
        "buildings": [{"model": "villa", "size": [20, 10, 9], "count": count}],
        "form": form,
    }
    return Brief.model_validate({"domain": "site", "name": "Forms", "sites": [site | more]})


def headings_of(brief):
    solution = sw.solve(brief)
    report = check(solution)
    assert report.valid, report.findings
    assert not solution.left_out
    poses = [p.pose for p in solution.pieces if p.category == "building"]
    return np.array([(pose.x, pose.y, pose.heading) for pose in poses])


def test_both_tables_hold_the_forms_a_brief_may_ask_for():
    assert set(FORMS) == set(TEMPLATE_FORMS)


def test_determinant_forms():
    straight, turned = headings_of(asked("parallel")), headings_of(asked("rotated"))
    assert straight[:, 2] % np.pi == pytest.approx(SOUTH % np.pi)
    assert turned[:, 2] % np.pi == pytest.approx((SOUTH + np.pi / 6) % np.pi)
    spliced = headings_of(asked("spliced"))
    assert 2 <= (np.abs(np.cos(spliced[:, 2])) > 0.9).sum() <= 6


def test_courts_close_and_half_closed_ones_are_open_to_the_front():
    closed, half = headings_of(asked("peripheral", 16)), headings_of(asked("half-closed", 10))
    for rows, open_ in ((closed, False), (half, True)):
        north = rows[rows[:, 1] > 50]
        east, west = north[:, 0].max(), north[:, 0].min()
        assert east > 105
        assert west < 15
        middle = north[(north[:, 0] > 25) & (north[:, 0] < 85)]
        assert bool((middle[:, 1] < 65).any()) != open_


def test_the_form_of_one_block_is_its_own():
    rows = headings_of(asked("parallel", blocks=[{"at": [60, 75], "form": "rotated"}]))
    north = rows[:, 1] > 50
    assert rows[north, 2] % np.pi == pytest.approx((SOUTH + np.pi / 6) % np.pi)
    assert rows[~north, 2] % np.pi == pytest.approx(SOUTH % np.pi)


def test_a_wrong_form_is_told_in_one_line(tmp_path):
    document = asked("parallel").model_dump(mode="json")
    document["sites"][0]["form"] = "spiral"
    path = tmp_path / "a.json"
    path.write_text(json.dumps(document))
    with pytest.raises(InputError) as told:
        sw.read(path)
    assert "form" in str(told.value)
    assert "\n" not in str(told.value).strip()
    with pytest.raises(InputError, match="lies in no block"):
        plan_of(asked("point", blocks=[{"at": [60, 50], "form": "mixed"}]))


@pytest.mark.parametrize("form", ["peripheral", "point"])
def test_templates_are_the_first_layouts_of_the_matrix_algorithm(form):
    problem = problems(asked(form))[0]
    cells = make_cells(problem)
    genes = seed_layouts(problem, cells, 2, 0)
    assert genes.shape == (2, cells.fits.shape[2] * 3)
    boxes, present = decode(cells, genes[0].reshape(-1, 3).astype(np.int64))
    assert present.sum() >= 5
    solution = sw.solve(asked(form), preset="paper")
    assert check(solution).valid
    del boxes


def test_the_largest_rectangle_is_that_of_a_plain_search():
    rng = np.random.default_rng(1)
    for _ in range(60):
        free = rng.random((6, 7)) < 0.7
        best = max(
            (r1 - r0) * (c1 - c0)
            for r0 in range(6)
            for r1 in range(r0, 7)
            for c0 in range(7)
            for c1 in range(c0, 8)
            if free[r0:r1, c0:c1].all()
        )
        r0, r1, c0, c1 = largest_rectangle(free)
        assert free[r0:r1, c0:c1].all()
        assert (r1 - r0) * (c1 - c0) == best
