"""Fronts along the border of a site look to a way or to the court, not where nobody goes."""

from __future__ import annotations

import math

import numpy as np
import pytest
from benchmarks.site_instances import example_site

import sites
from scenewright.core.brief import Brief
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.blocks.block import lay_out_block
from scenewright.domains.site.solvers.blocks.front import blind, turned_in
from scenewright.domains.site.solving import problems, solve

WEST, EAST, SOUTH = math.pi, 0.0, -math.pi / 2


def posed(*roads: list[tuple[float, float]]) -> SiteProblem:
    """120 by 80 metres for ten pavilions, with roads 4 metres wide."""
    ground = sites.site(
        roads=[{"line": line, "width": 4.0} for line in roads],
        buildings=[{"model": "pavilion", "count": 10}],
    )
    return problems(Brief(domain="site", name="Fronts", sites=[ground]))[0]


@pytest.mark.parametrize(("x", "seen"), [(2.0, True), (30.0, False)])
def test_a_front_at_the_border_sees_a_way_or_nothing(x: float, seen: bool) -> None:
    """A house 5 metres from the western border, a road before it or behind it."""
    problem = posed([(x, -1), (x, 81)])
    house = np.array([[10.0, 40.0, WEST, 10.0, 10.0]])
    assert blind(problem, house).tolist() == [not seen]
    assert math.cos(turned_in(problem, house)[0, 2]) == pytest.approx(-1.0 if seen else 1.0)
    assert not blind(problem, house + np.array([30.0, 0, 0, 0, 0])).any()


def test_what_looks_to_the_sun_or_stands_on_a_site_without_ways_stays() -> None:
    sunny = np.array([[60.0, 9.0, SOUTH + 0.3, 10.0, 10.0]])
    problem = posed([(60, -1), (60, 81)])
    aside = posed([(30, -1), (30, 81)])
    assert turned_in(aside._replace(door_distance=3.5), sunny).tolist() == sunny.tolist()
    near = turned_in(aside._replace(door_distance=5.0), sunny)
    assert near[0, 2] == pytest.approx(sunny[0, 2] + math.pi)
    house = np.array([[10.0, 40.0, WEST, 10.0, 10.0]])
    assert blind(problem, house).all()
    bare = problem._replace(ground=problem.ground._replace(roads=np.zeros((0, 5))))
    assert not blind(bare, house).any()


def test_turning_is_no_matter_of_where_the_site_lies() -> None:
    problem, rng = example_site(12, 140.0), np.random.default_rng(1)
    boxes = np.column_stack(
        [rng.uniform(0, 140, (60, 2)), rng.uniform(-3, 3, 60), np.full((60, 2), 8.0)]
    )
    ground, off = problem.ground, np.array([500.0, -300.0])
    moved = ground._replace(
        edges=ground.edges + np.tile(off, 2), roads=ground.roads + np.array([*off, 0, 0, 0])
    )
    there = boxes + np.array([*off, 0, 0, 0])
    told = blind(problem, boxes)
    assert 0 < told.sum() < len(boxes)
    assert (blind(problem._replace(ground=moved), there) == told).all()


def test_no_rim_looks_out_where_no_way_is() -> None:
    problem = posed([(60, -1), (60, 81)])
    first, last = problem.ground.block_spans[0]
    edges = problem.ground.block_edges[first:last]
    found = lay_out_block(problem, edges, list(range(10)), SOUTH, "peripheral", 1.0)
    off = np.abs((found.boxes[:, 2] - SOUTH + math.pi) % (2 * math.pi) - math.pi)
    assert len(found.numbers) > 4
    assert not (blind(problem, found.boxes) & (off > 1.0)).any()


def test_what_is_built_looks_to_a_way_or_a_court() -> None:
    brief = Brief(
        domain="site",
        name="Rims",
        sites=[
            sites.site(
                roads=[{"line": [(60, -1), (60, 81)], "width": 4.0}],
                buildings=[{"model": "pavilion", "count": 12, "forms": ["peripheral"]}],
            )
        ],
    )
    built = [p for p in solve(brief).pieces if p.category == "building"]
    assert len(built) == 12
    for piece in built:
        boxes = np.array([[piece.pose.x, piece.pose.y, piece.pose.heading, 9.0, 9.0]])
        off = abs((boxes[0, 2] - SOUTH + math.pi) % (2 * math.pi) - math.pi)
        assert off < 0.8 or not blind(problems(brief)[0], boxes).any()
