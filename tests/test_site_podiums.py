"""Podiums beside their towers, and the measure of gaps in rows."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from benchmarks.shapely_hall import polygon
from benchmarks.shapely_home import rectangle
from benchmarks.site_composition import list_gap_variations, list_podium_gaps
from benchmarks.site_instances import example_site

from scenewright.core.footprint import place_outline
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.solvers.podiums import join_podiums

NONE = np.zeros((0, 5))
SOUTH = -math.pi / 2


def open_ground(sizes: list[tuple[float, float, float]]) -> SiteProblem:
    """A site without landmarks for buildings of some sizes."""
    problem = example_site(len(sizes), 400.0)
    ground = problem.ground._replace(
        landmarks=NONE, landmark_heights=np.zeros(0), landmark_quality=np.zeros(0)
    )
    made = problem.buildings._replace(sizes=np.array(sizes, float))
    weights = {"seen": 0.0, "sun": 3.0}
    return problem._replace(ground=ground, buildings=made, weights=weights, spacing=0.0)


def middle_of(problem: SiteProblem) -> np.ndarray:
    first, last = problem.ground.block_spans[int(np.argmax(problem.ground.block_areas))]
    point = polygon(problem.ground.block_edges[first:last]).representative_point()
    return np.array([point.x, point.y])


def test_gaps_are_measured_in_runs_of_equal_buildings_with_nothing_between() -> None:
    row = np.array([[x, 0.0, SOUTH, 10.0, 8.0] for x in (0.0, 16.0, 40.0)])
    high = np.full(3, 9.0)
    assert list_gap_variations(row, high) == [pytest.approx(0.4)]
    assert list_gap_variations(row, np.array([9.0, 9.0, 15.0])) == []
    between = np.append(row, [[28.0, 0.0, SOUTH, 4.0, 4.0]], axis=0)
    assert list_gap_variations(between, np.full(4, 9.0)) == []


def test_a_tower_stands_beside_its_podium() -> None:
    houses = [(x, y) for x in (-45.0, 0.0, 45.0) for y in (30.0, 75.0)]
    problem = open_ground([(40, 24, 9), (14, 14, 45), *[(10, 8, 9)] * 6])
    boxes = np.array([[0.0, 0.0, SOUTH, 40.0, 24.0], [22.0, 50.0, SOUTH, 14.0, 14.0]])
    boxes = np.concatenate([boxes, [[*house, SOUTH, 10.0, 8.0] for house in houses]])
    boxes[:, :2] += middle_of(problem)
    found = SiteLayout(boxes, np.ones(8, bool), {}, ("mixed",) * 8)
    after, joined = join_podiums(problem, found)
    heights = problem.buildings.sizes[:, 2]
    shapes = [np.array([rectangle(box) for box in one.boxes], object) for one in (found, after)]
    assert list_podium_gaps(shapes[0], heights)[0] > 20.0
    assert list_podium_gaps(shapes[1], heights)[0] == pytest.approx(0.0, abs=0.01)
    assert joined.tolist() == [True] * 2 + [False] * 6
    apart = problem._replace(spacing=6.0)
    assert join_podiums(apart, found)[0] is found
    block = shapely.union_all(
        [polygon(problem.ground.block_edges[a:b]) for a, b in problem.ground.block_spans]
    )
    assert shapely.area(shapely.difference(shapes[1], block)).max() < 0.005


def test_a_tower_stands_in_the_corner_of_an_l_shaped_podium() -> None:
    ell = ((-30.0, -20.0), (30.0, -20.0), (30.0, -5.0), (-10.0, -5.0), (-10.0, 20.0), (-30.0, 20.0))
    problem = open_ground([(60, 40, 6), (20, 18, 60)])
    made = problem.buildings._replace(footprints=(ell, ()))
    problem = problem._replace(buildings=made, weights={"seen": 0.0, "sun": 0.0})
    boxes = np.array([[0.0, 0.0, -SOUTH, 60.0, 40.0], [18.0, 12.0, -SOUTH, 20.0, 18.0]])
    boxes[:, :2] += middle_of(problem)
    after, joined = join_podiums(problem, SiteLayout(boxes, np.ones(2, bool), {}, ("",) * 2))
    assert joined.all()
    low, tower = (
        shapely.Polygon(place_outline(outline, *box[:3]))
        for outline, box in zip(made.outlines(), after.boxes, strict=True)
    )
    assert shapely.distance(low, tower) < 0.01
    assert low.intersection(tower).area < 0.05
    assert low.convex_hull.intersection(tower).area > 100.0


def test_what_is_no_tower_or_no_podium_stays() -> None:
    for other in ((14, 14, 15), (40, 24, 45), (30, 30, 45)):
        problem = open_ground([(40, 24, 9), other])
        boxes = np.array([[0.0, 0.0, SOUTH, 40.0, 24.0], [10.0, 50.0, SOUTH, *other[:2]]])
        found = SiteLayout(boxes, np.ones(2, bool), {}, ("mixed",) * 2)
        after, joined = join_podiums(problem, found)
        assert (after.boxes == boxes).all()
        assert not joined.any()
