"""The site paper's experiments: simulated raters, aims that lead, tables."""

from __future__ import annotations

import numpy as np
import pytest
from benchmarks.papers_site_raters import SiteRater, like, make_taste
from benchmarks.papers_site_tables import markdown_lines
from benchmarks.site_scenes import posed, scene_brief

from scenewright.domains import plan_of
from scenewright.domains.site.encodings.cell_moves import random_genes
from scenewright.domains.site.matrix_breeding import prepare_matrix
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge
from scenewright.engine.preference.interactive.estimates import RatedLayouts, estimate_by_alleles

PROBLEM = posed(scene_brief(6)).problems["default"]


def test_likings_are_on_one_scale_and_ratings_follow_them() -> None:
    cells, rng = make_cells(PROBLEM), np.random.default_rng(7)
    genes = [random_genes(cells, rng, PROBLEM.buildings.quality, 0.0) for _ in range(60)]
    boxes = make_judge(PROBLEM, cells).boxes(np.array(genes, float).reshape(60, -1))
    for number in range(3):
        taste = make_taste(PROBLEM, number)
        values = np.array([like(taste, one) for one in boxes])
        assert abs(values.mean()) < 0.6
        assert 0.5 < values.std() < 2.0
        stars = SiteRater(PROBLEM, number).rate(boxes[:40])
        assert set(np.unique(2 * stars)) <= set(range(2, 11))
        assert np.corrcoef(values[:40], stars)[0, 1] > 0.5
        assert make_taste(PROBLEM, number).omega.tolist() == taste.omega.tolist()


def test_estimates_are_means_of_what_is_known() -> None:
    rated, ratings = np.array([[1, 0], [1, 2], [0, 2]]), np.array([5.0, 3.0, 1.0])
    rng, known = np.random.default_rng(0), RatedLayouts(rated, ratings, np.array([0.0, 0.5, 0.5]))
    assert estimate_by_alleles(known, np.array([1, 0]), rng) == pytest.approx(4.0)
    assert estimate_by_alleles(known, np.array([0, 1]), rng) == 3.0


def test_aims_that_lead_are_told_apart_where_models_are_chosen() -> None:
    brief = scene_brief(6, library=True)
    matrix = prepare_matrix(brief, plan_of(brief))
    rows = np.array([matrix.draw(20, False, np.random.default_rng(1))]).reshape(20, -1)
    boxes = np.array([matrix.boxes(tuple(row)) for row in rows.tolist()])
    told = [score(matrix.problem, one, one[:, 3] > 0.0) for one in boxes]
    for name in ("use", "height"):
        assert np.std([one[name] for one in told]) > 0.01
    use, height = ([one[name] for one in told] for name in ("use", "height"))
    assert abs(np.corrcoef(use, height)[0, 1]) < 0.99


def test_tables() -> None:
    rows = [
        {"case": "6 buildings", "metric": "liked, sa", "ours": 0.5, "baseline": 1, "runs": 2},
        {"case": "M leads, 6", "metric": "use", "ours": 0.5, "baseline": 1, "runs": 2},
    ]
    text = "\n".join(markdown_lines(rows))
    assert "simulated" in text
    assert "| sa | 0.50 |" in text
