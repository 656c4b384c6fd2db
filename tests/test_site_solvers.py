"""Solvers of sites: the contract of every row, the forms, and what evolution may not do."""

from __future__ import annotations

import math
import statistics

import numpy as np
import pytest
import shapely
from benchmarks.shapely_hall import polygon
from benchmarks.shapely_home import rectangle
from benchmarks.shapely_site import site_terms
from benchmarks.site_instances import STYLES, example_site
from hypothesis import given
from hypothesis import strategies as st

from deadline import within
from scenewright.core.errors import InputError
from scenewright.domains.site.encodings.forms import FORMS
from scenewright.domains.site.problem import Buildings, SiteProblem
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.solvers.anneal import anneal_from
from scenewright.domains.site.solvers.answer import make_measure, score, standing
from scenewright.domains.site.solvers.genetic import MatrixGenetic, viewpoint_site
from scenewright.domains.site.solvers.lattice import make_cells
from scenewright.domains.site.solvers.matrix_judge import make_judge
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.solvers.random_search import lines_of
from scenewright.domains.site.solvers.templates import make_template
from scenewright.domains.site.terms.table import SITE_TERMS, read_site_weights
from scenewright.engine.solve import Budget, BudgetWatch
from scenewright.engine.swarm import Swarm
from thoroughness import few_or_many

PROBLEM = example_site(12, 110.0)
ROWS = list(SITE_SOLVERS.values())
IDS = list(SITE_SOLVERS)
SCORED = [row for row in ROWS if row.name != "fill"]
"""Solvers whose steps are layouts of the site and which score their answer."""
LIMIT = 60
"""Seconds after which a solver that was given one, or cancelled at once, hangs."""
SCORED_IDS = [row.name for row in SCORED]


def assert_stands(problem: SiteProblem, found: SiteLayout) -> None:
    """What stands lies in the blocks and keeps its distance, by exact polygons."""
    ground = problem.ground
    assert found.boxes.shape == (len(problem.buildings.sizes), 5)
    assert np.isfinite(found.boxes).all()
    sizes = problem.buildings.sizes[:, :2]
    assert np.allclose(found.boxes[found.present, 3:], sizes[found.present])
    blocks = shapely.union_all([polygon(ground.block_edges[a:b]) for a, b in ground.block_spans])
    shapes = [rectangle(box) for box in found.boxes[found.present]]
    assert all(shape.difference(blocks).area < 0.02 for shape in shapes)
    assert_apart(shapes, problem.spacing - 0.05)


def assert_apart(shapes: list, distance: float) -> None:
    """No two of some polygons nearer than a distance."""
    shapes = np.array(shapes, object)
    pairs = shapely.STRtree(shapes).query(shapes, "dwithin", distance)
    assert (pairs[0] == pairs[1]).all()


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_the_contract(row) -> None:
    steps = {"sa": 4000, "sa-free": 4000, "fill": 6}.get(row.name, 200)
    runs = [row.run(PROBLEM, Budget(steps=steps), seed) for seed in (3, 3, 4)]
    found, again, other = (run.layouts[0] for run in runs)
    assert np.array_equal(found.boxes, again.boxes)
    assert np.array_equal(found.present, again.present)
    assert found.score == again.score
    if row in SCORED:
        assert not np.array_equal(found.boxes, other.boxes)
        assert 0 < runs[0].evaluations <= steps
    assert found.present.sum() >= 6
    assert_stands(PROBLEM, found)


@pytest.mark.parametrize("row", SCORED, ids=SCORED_IDS)
def test_scores_are_those_of_what_stands(row) -> None:
    found = row.run(PROBLEM, Budget(steps=100), 1).layouts[0]
    exact = site_terms(PROBLEM, np.where(found.present[:, None], found.boxes, 0.0))
    for term in SITE_TERMS:
        assert found.score[term.name] == pytest.approx(exact[term.number], abs=1e-6)
    assert found.score["left"] == 12 - found.present.sum()
    weights = read_site_weights({})
    position = exact[[0, 1, 2, 3]] @ weights[[0, 1, 2, 3]]
    assert found.score["ratio"] == pytest.approx(position / exact[4])
    assert found.score["energy"] == pytest.approx(position + 12 - exact[4] + 10 * exact[5])
    for name in ("use", "shown", "texture", "height", "value", "seen"):
        assert 0.0 <= found.score[name] <= 1.0
    assert 0.0 <= found.score["sun"] <= 8.0


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_seconds_progress_and_cancelling(row) -> None:
    row.run(PROBLEM, Budget(seconds=0.1), 0)
    told: list[tuple[float, SiteLayout]] = []
    with within(LIMIT):
        row.run(PROBLEM, Budget(seconds=0.6), 0, lambda now: told.append((now.share, now.best())))
    shares = [share for share, _ in told]
    assert shares == sorted(shares)
    assert shares[-1] == 1.0
    for _, layout in told[:: len(told) // 3 or 1]:
        assert_stands(PROBLEM, layout)
    with within(LIMIT):
        found = row.run(PROBLEM, Budget(seconds=600.0), 0, None, lambda: True).layouts[0]
    assert_stands(PROBLEM, found)


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_a_site_without_room_and_a_single_building(row) -> None:
    ground = PROBLEM.ground._replace(
        block_edges=np.zeros((0, 4)),
        block_spans=np.zeros((0, 2), np.int64),
        block_areas=np.zeros(0),
    )
    found = row.run(PROBLEM._replace(ground=ground), Budget(steps=6), 0).layouts[0]
    assert not found.present.any()
    steps = 6 if row.name == "fill" else 200
    one = row.run(example_site(1), Budget(steps=steps), 0).layouts[0]
    assert one.present.all()


@pytest.mark.parametrize("row", ROWS, ids=IDS)
def test_more_buildings_than_there_is_room_for(row) -> None:
    problem = example_site(60, 150.0)
    steps = {"fill": 6, "random": 300}.get(row.name, few_or_many(1000, 3000))
    found = row.run(problem, Budget(steps=steps), 0).layouts[0]
    assert (1 if row.name == "pso" else 5) <= found.present.sum() < 60
    assert_stands(problem, found)


def scores(name: str, steps: int) -> list[dict[str, float]]:
    """What a solver makes of thirty buildings, for each of some seeds."""
    problem, budget = example_site(30, 150.0), Budget(steps=steps)
    return [
        SITE_SOLVERS[name].run(problem, budget, seed).layouts[0].score
        for seed in range(few_or_many(1, 3))
    ]


def test_annealing_finds_what_chance_does_not() -> None:
    annealed, drawn = scores("sa", few_or_many(40_000, 100_000)), scores("random", 300)
    ratios = [a["energy"] / b["energy"] for a, b in zip(annealed, drawn, strict=True)]
    assert statistics.median(ratios) < 0.7
    assert all(a["left"] < b["left"] for a, b in zip(annealed, drawn, strict=True))
    led, plain = (scores(name, few_or_many(1000, 2000)) for name in ("vp", "sga"))
    assert all(a["facing"] < b["facing"] for a, b in zip(led, drawn, strict=True))
    assert all(a["value"] > b["value"] for a, b in zip(led, plain, strict=True))


def test_annealing_starts_from_what_it_is_given() -> None:
    problem = example_site(6)
    found = SITE_SOLVERS["sa"].run(problem, Budget(steps=30_000), 0).layouts[0]
    watch = BudgetWatch(Budget(steps=1), None, None)
    boxes, _ = anneal_from(problem, found.boxes, Budget(steps=1), 0, watch, lines_of(problem))
    assert np.abs(boxes - found.boxes).max(1).astype(bool).sum() <= 1


def test_of_two_too_near_each_other_one_stays() -> None:
    problem = example_site(2, 150.0)
    boxes = np.array(
        [[90.0, 80.0, -math.pi / 2, 12.0, 10.0], [95.0, 80.0, math.pi / 2, 18.0, 12.0]]
    )
    measure = make_measure(problem)
    assert standing(measure, boxes).tolist() == [True, False]
    boxes[1, 0] = 112.0
    assert standing(measure, boxes).tolist() == [True, True]
    assert score(problem, boxes, np.array([True, False]))["left"] == 1.0


@pytest.mark.parametrize(("short", "stay"), [(-0.01, 2), (0.005, 2), (0.03, 1)])
def test_a_corner_may_lack_no_more_than_the_referee_lets_it(short: float, stay: int) -> None:
    """A square stands with a corner ``short`` metres too near to the side of another."""
    problem = example_site(2, 200.0)
    apart = 5.0 + 5.0 * math.sqrt(2.0) + problem.spacing / 2 * (1.0 + math.sqrt(2.0)) - short
    boxes = np.array([[20.0, 25.0, 0.0, 10.0, 10.0], [20.0 + apart, 25.0, math.pi / 4, 10, 10]])
    assert standing(make_measure(problem), boxes).sum() == stay


def test_genes_may_be_rated_from_outside() -> None:
    cells = make_cells(PROBLEM)
    solver = MatrixGenetic(cells, PROBLEM.buildings.quality)
    judge, rng = make_judge(PROBLEM, cells), np.random.default_rng(0)
    state = solver.init(rng, np.zeros(cells.fits.shape[2] * 3), np.zeros(0))
    means = []
    for _ in range(40):
        genes, state = solver.ask(state, rng)
        boxes = judge.boxes(genes)
        rating = (boxes[..., 0] * (boxes[..., 3] > 0)).sum(1)  # a person who likes the east
        state = solver.tell(state, genes, -rating)
        means.append(-state.energies.mean())
    assert means[-1] > 1.2 * means[0]


def test_a_liked_building_is_worth_more() -> None:
    cells = make_cells(PROBLEM)
    found = viewpoint_site(PROBLEM, Budget(steps=50), 0)
    genes = MatrixGenetic(cells, PROBLEM.buildings.quality)
    rows, _ = genes.ask(
        genes.init(np.random.default_rng(0), np.zeros(1), np.zeros(1)), np.random.default_rng(0)
    )
    less = make_judge(PROBLEM, cells, np.zeros(12)).energies(rows)
    more = make_judge(PROBLEM, cells, np.ones(12)).energies(rows)
    assert (more < less).all()
    assert found.layouts[0].generations >= 1


def test_particles_meet_where_it_costs_least() -> None:
    rng, low, high = np.random.default_rng(0), np.full(4, -5.0), np.full(4, 5.0)
    swarm = Swarm(rng.uniform(low, high, (20, 4)))
    state = swarm.init(rng, low, high)
    for _ in range(120):
        places, state = swarm.ask(state, rng)
        assert (np.abs(places) <= 5.0).all()
        state = swarm.tell(state, places, ((places - [1.0, 2.0, -3.0, 0.5]) ** 2).sum(1))
    assert np.allclose(state.bests, [1.0, 2.0, -3.0, 0.5], atol=0.05)


def test_the_value_by_hand() -> None:
    problem = example_site(2, 150.0)._replace(form="printed")  # 12 x 10 x 9 and 18 x 12 x 24
    boxes = np.array(
        [[90.0, 80.0, -math.pi / 2, 12.0, 10.0], [112.0, 80.0, -math.pi / 2, 18.0, 12.0]]
    )
    both = score(problem, boxes, np.array([True, True]))
    facades, volume = np.array([2 * 22 * 9, 2 * 30 * 24]), np.array([12 * 10 * 9, 18 * 12 * 24])
    area = problem.ground.block_areas.sum()
    assert both["use"] == pytest.approx((18 * 16 + 24 * 18) / area)
    assert both["shown"] == pytest.approx((facades * [0.35, 0.55]).sum() / facades.sum())
    assert both["texture"] == pytest.approx(((0.9 + 0.8) / 2 + 0.8) / 2)  # tones differ by 0.2
    assert both["height"] == pytest.approx(1.0)
    one = score(problem, boxes, np.array([True, False]))
    assert one["texture"] == pytest.approx((0.9 + 1.0) / 2 / 2)
    assert one["height"] == pytest.approx(volume[0] / volume.sum())
    assert one["shown"] == pytest.approx(facades[0] * 0.35 / facades.sum())
    parts = [both[name] for name in ("use", "shown", "texture", "height")]
    assert both["value"] == pytest.approx(np.dot(parts, [0.2, 0.5, 0.1, 0.2]))
    ours = score(problem._replace(form="repaired"), boxes, np.array([True, True]))
    assert ours["shown"] == pytest.approx(min(ours["seen"] / 0.3, 1.0))
    boxes[1, 0] = 90.0  # in front of the first, to the south
    boxes[1, 1] = 60.0
    assert score(problem, boxes, np.array([True, True]))["sun"] < both["sun"]
    assert both["seen"] > score(problem, boxes, np.array([False, False]))["seen"] > 0.0


def group(models: list[int]) -> Buildings:
    rows = STYLES[models]
    return Buildings(
        rows[:, :3].copy(),
        rows[:, 3],
        rows[:, 4],
        rows[:, 5],
        np.array(models),
        np.ones(len(models), np.int64),
    )


@given(
    st.sampled_from(list(FORMS)),
    st.lists(st.integers(0, 4), min_size=1, max_size=8),
    st.floats(30, 140),
    st.floats(30, 140),
    st.floats(0, 12),
    st.floats(0, 1.5),
)
def test_forms_keep_their_rectangle_and_their_spacing(
    form: str, models: list[int], width: float, depth: float, spacing: float, behind: float
) -> None:
    sizes = group(models).sizes
    boxes = FORMS[form].place(sizes, spacing, (width, depth), behind)
    there = boxes[:, 3] > 0
    assert np.allclose(boxes[there, 3:], sizes[there, :2])
    shapes = [rectangle(box) for box in boxes[there]]
    target = shapely.box(-width / 2, -depth / 2, width / 2, depth / 2)
    assert all(shape.difference(target).area < 1e-6 for shape in shapes)
    if spacing > 0:
        assert_apart(shapes, spacing - 1e-6)
    assert shapely.union_all(shapes).area == pytest.approx(sum(s.area for s in shapes))


def test_forms_look_as_they_are_called() -> None:
    buildings, roomy = group([0] * 8), (90.0, 70.0)
    laid = {name: row.place(buildings.sizes, 6.0, roomy, 0.0) for name, row in FORMS.items()}
    assert all((boxes[:, 3] > 0).all() for boxes in laid.values())
    narrow = FORMS["parallel"].place(buildings.sizes, 6.0, (70.0, 70.0), 0.0)
    assert len(np.unique(narrow[:, 1].round(6))) == 2
    assert np.allclose(narrow[:4, 0], narrow[4:, 0])
    loose = FORMS["staggered"].place(buildings.sizes, 6.0, (80.0, 70.0), 0.0)
    assert np.allclose(loose[4:, 0] - loose[:4, 0], 9.0)
    assert len(np.unique(laid["spliced"][:, 2].round(6))) == 2
    out = laid["peripheral"]
    assert len(np.unique(out[:, 2].round(6) % 6.283185)) == 4
    ahead = np.cos(out[:, 2]) * out[:, 0] + np.sin(out[:, 2]) * out[:, 1]
    assert (ahead > 0).all()
    court = shapely.box(-20, -15, 20, 15)
    assert not any(rectangle(box).intersects(court) for box in out)
    front = np.isclose(laid["half-closed"][:, 2] % (2 * math.pi), math.pi / 2)
    assert not front.any()


def test_templates_place_what_a_form_leaves_out() -> None:
    buildings = group([3, 3, 0, 0, 0, 0, 1, 1])
    plain = make_template("parallel", buildings, (60.0, 55.0), 4.0, steps=0)
    put_right = make_template("parallel", buildings, (60.0, 55.0), 4.0, steps=20_000)
    assert put_right.present.sum() >= plain.present.sum()
    assert 0.0 < put_right.score["fit"] <= 1.2
    assert put_right.score["fitness"] > 0.0
    whole = make_template("point", group([0] * 4), (60.0, 60.0), 6.0)
    assert whole.present.all()
    assert np.array_equal(
        whole.boxes, FORMS["point"].place(group([0] * 4).sizes, 6.0, (60.0, 60.0), 0.0)
    )
    with pytest.raises(InputError, match="no form is called"):
        make_template("round", buildings, (60.0, 60.0), 6.0)
