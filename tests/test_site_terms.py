"""Terms of sites: agreement with one shapely object a building, and what each says."""

from __future__ import annotations

import math

import numpy as np
import pytest
from benchmarks.shapely_site import site_terms
from benchmarks.site_instances import example_site
from hypothesis import given, settings
from hypothesis import strategies as st

from scenewright.core.errors import InputError
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.terms.measure import (
    change,
    commit,
    energies,
    energy_of,
    evaluate,
    lay,
    make_site_state,
    prepare_site,
)
from scenewright.domains.site.terms.table import (
    FACING,
    INSERT,
    LEFT,
    OVERLAP,
    QUALITY,
    ROAD,
    SITE_TERMS,
    fitness_of_cost,
    kept_apart,
    printed_ratio,
    read_site_weights,
    repaired_sum,
    utilisation,
    within_box,
)
from scenewright.geometry.boxes import frames_of


def drawn(problem: SiteProblem, count: int, seed: int, absent: float = 0.1) -> np.ndarray:
    """Layouts (count, n, 5) anywhere on the site, some buildings left out."""
    rng, sizes = np.random.default_rng(seed), problem.buildings.sizes[:, :2]
    boxes = np.empty((count, len(sizes), 5))
    low, high = problem.ground.bounds[:2] - 10, problem.ground.bounds[2:] + 10
    boxes[..., :2] = rng.uniform(low, high, (count, len(sizes), 2))
    boxes[..., 2] = rng.uniform(-7, 7, boxes.shape[:2])
    boxes[:, ::2, 2] = rng.integers(-2, 3, boxes[:, ::2, 2].shape) * math.pi / 2
    boxes[..., 3:] = sizes
    boxes[rng.random(boxes.shape[:2]) < absent, 3:] = 0.0
    return boxes


@pytest.mark.parametrize(("spacing", "fire"), [(6.0, 4.0), (2.0, 5.0), (4.0, 4.0), (0.0, 3.0)])
def test_terms_agree_with_polygons(spacing: float, fire: float) -> None:
    problem = example_site(12, 120.0)._replace(spacing=spacing, fire_access=fire, facing=0.4)
    layouts = drawn(problem, 12, 3)
    ours = evaluate(problem, layouts)
    assert np.allclose(ours, [site_terms(problem, boxes) for boxes in layouts], atol=1e-7)
    assert (ours[:, [INSERT, OVERLAP, ROAD, LEFT]] > 0).any(0).all()


def test_terms_of_many_buildings_agree_with_polygons() -> None:
    problem = example_site(80)
    problem.buildings.sizes[0, :2] = 120.0, 30.0  # too large for a bucket
    layouts = drawn(problem, 1, 5)
    assert np.allclose(evaluate(problem, layouts)[0], site_terms(problem, layouts[0]), atol=1e-7)


def test_a_moved_building_adds_up_to_the_whole() -> None:
    problem = example_site(40)
    p, s = prepare_site(problem), make_site_state(problem)
    boxes = drawn(problem, 8, 7)
    lay(p, s, boxes[0])
    before, now = energy_of(p, s), boxes[0].copy()
    for k in range(1, 8):
        for i in range(40):
            frame = tuple(frames_of(boxes[k, i : i + 1])[0])
            foretold = change(p, s, i, frame)
            if (i + k) % 3 == 0:
                continue
            commit(p, s, i, frame)
            now[i] = boxes[k, i]
            assert energy_of(p, s) == pytest.approx(before + foretold, abs=1e-8)
            before = energy_of(p, s)
    assert np.allclose(s.sums, evaluate(problem, now[None])[0], atol=1e-8)
    assert energies(problem, now[None])[0] == pytest.approx(before, abs=1e-7)


@given(st.floats(-math.pi, math.pi), st.floats(-500, 500), st.integers(0, 2**31))
@settings(max_examples=25, deadline=None)
def test_turning_and_moving_the_whole_site_changes_nothing(
    turn: float, shift: float, seed: int
) -> None:
    problem = example_site(8, 100.0)
    layout = drawn(problem, 1, seed)
    c, s = math.cos(turn), math.sin(turn)
    matrix = np.array([[c, s], [-s, c]])

    def moved(points: np.ndarray) -> np.ndarray:
        return points @ matrix + shift

    ground = problem.ground
    turned = {}
    for name in ("edges", "block_edges"):
        edges = getattr(ground, name)
        turned[name] = np.hstack([moved(edges[:, :2]), moved(edges[:, 2:])])
    marks = np.hstack([moved(ground.landmarks[:, :2]), ground.landmarks[:, 2:]])
    marks[:, 2] += turn
    low, high = turned["edges"][:, :2].min(0), turned["edges"][:, :2].max(0)
    other = problem._replace(
        ground=ground._replace(**turned, landmarks=marks, bounds=np.array([*low, *high])),
        facing=problem.facing + turn,
    )
    there = layout.copy()
    there[0, :, :2] = moved(layout[0, :, :2])
    there[0, :, 2] += turn
    assert np.allclose(evaluate(problem, layout), evaluate(other, there), atol=1e-6)


def test_a_building_alone_in_its_block_costs_nothing_but_what_it_lacks() -> None:
    problem = example_site(1, 150.0)
    boxes = np.array([[[90.0, 80.0, -math.pi / 2, 12.0, 10.0]]])
    assert np.allclose(evaluate(problem, boxes)[0], [0, 0, 0, 0, 0.35, 0])
    assert energies(problem, boxes)[0] == pytest.approx(0.65)
    for heading, cost in ((0.0, 0.5), (math.pi / 2, 1.0), (math.pi, 0.5), (1.5 * math.pi, 0.0)):
        boxes[0, 0, 2] = heading
        assert evaluate(problem, boxes)[0, FACING] == pytest.approx(cost)
    boxes[0, 0, 0] = 150.0 - 5.5  # half of the setback of 3 m, and of the fire access of 2 m
    terms = evaluate(problem, boxes)[0]
    assert terms[INSERT] > 0
    assert terms[ROAD] > 0


def test_each_half_of_the_way_between_two_buildings_is_its_own() -> None:
    problem = example_site(2, 150.0)._replace(spacing=0.0, fire_access=4.0)
    boxes = np.array(
        [[[90.0, 80.0, -math.pi / 2, 12.0, 10.0], [90.0 + 16.0, 80.0, -math.pi / 2, 12.0, 10.0]]]
    )
    problem.buildings.sizes[1] = problem.buildings.sizes[0]
    assert evaluate(problem, boxes)[0, ROAD] == pytest.approx(0.0, abs=1e-9)  # 4 m between them
    boxes[0, 1, 0] -= 1.0
    assert evaluate(problem, boxes)[0, ROAD] == pytest.approx(2 * 14 / (16 * 14))


def test_the_printed_ratio_explodes_where_little_is_worth_seeing() -> None:
    weights = read_site_weights({})
    terms = np.zeros((3, 6))
    terms[:, FACING], terms[:, QUALITY] = 1.0, [1.0, 1e-6, 0.0]
    ratio = printed_ratio(terms, weights)
    assert ratio[0] == 1.0
    assert ratio[1] > 1e5
    assert ratio[2] == math.inf
    assert fitness_of_cost(ratio, 5.0).tolist() == [4.0, 0.0, 0.0]
    assert repaired_sum(terms, weights, 1)[1:].max() <= 2.0


def test_buildings_in_a_box_by_the_paper() -> None:
    sizes = np.array([[10.0, 8.0, 6.0], [10.0, 8.0, 12.0]])
    assert utilisation(sizes, (2.0, 2.0), (40.0, 20.0, 12.0)) == pytest.approx(
        (12 * 10 * 6 + 12 * 10 * 12) / (40 * 20 * 12)
    )
    centres = np.array([[6.0, 5.0, 3.0], [18.0, 5.0, 6.0]])
    assert within_box(centres, sizes, (2.0, 2.0), (40.0, 20.0, 12.0)).all()
    assert not within_box(centres - [0.1, 0, 0], sizes, (2.0, 2.0), (40.0, 20.0, 12.0))[0]
    assert kept_apart(centres, sizes, (2.0, 2.0, 0.0))[0, 1]
    assert not kept_apart(centres - [[0, 0, 0], [0.1, 0, 0]], sizes, (2.0, 2.0, 0.0))[0, 1]


def test_rows_and_weights() -> None:
    assert [row.number for row in SITE_TERMS] == list(range(len(SITE_TERMS)))
    with pytest.raises(InputError, match="no term of sites is called"):
        read_site_weights({"sunshine": 1.0})
