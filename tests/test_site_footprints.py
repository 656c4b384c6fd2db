"""Buildings of a site that are no boxes: measured, placed, judged, written."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.footprint import place_outline
from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.domains import adjust
from scenewright.domains.site.check import figures as referee
from scenewright.domains.site.drawing.marks import buildings_mark
from scenewright.domains.site.locks import lock_sites
from scenewright.domains.site.plan import plan_sites, site_plans
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.shapes import StandingBuilding
from scenewright.domains.site.solvers.answer import make_measure, standing
from scenewright.domains.site.solvers.interlock import blocks_of, convex_parts, middles
from scenewright.domains.site.solvers.loosen import loosen_buildings
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.solving import problems
from scenewright.domains.site.terms.measure import evaluate
from scenewright.drawing.marks import PaperView
from scenewright.drawing.svg import mark_text
from scenewright.engine.solve import Budget, BudgetWatch
from scenewright.formats import brief_json, solution_json
from sites import SOUTH, building, site

ELL = [[0, 0], [30, 0], [30, 7], [8, 7], [8, 16], [0, 16]]


def judge_sites(ground, *pieces):
    return referee.judge_sites([ground], pieces, site_plans([ground]))


def close(footprint: list[list[float]] | None = ELL, **more: Any) -> Brief:
    """Ground on which two L-shaped houses stand only if each reaches into the other's corner."""
    house = {"model": "villa", "name": "Corner house", "count": 2, "size": [30, 16, 7]}
    house |= {"footprint": footprint} if footprint else {}
    ground = {
        "id": "s",
        "outline": [[0, 0], [40, 0], [40, 28], [0, 28]],
        "buildings": [house],
        "setback": 1,
        "spacing": 2,
        "fire_access": 2,
        "origin": [11.58, 48.14],
    }
    return brief_json.loads(json.dumps({"domain": "site", "sites": [ground | more]}))


def buildings_of(solution: sw.Solution) -> list[sw.Piece]:
    return [piece for piece in solution.pieces if piece.category == "building"]


def box_problem(count: int = 6) -> SiteProblem:
    brief = close(None, outline=[[0, 0], [120, 0], [120, 90], [0, 90]])
    house = brief.part.sites[0].buildings[0].model_copy(update={"count": count})
    sites = [brief.part.sites[0].model_copy(update={"buildings": [house]})]
    part = brief.part.model_copy(update={"sites": sites})
    return problems(brief.model_copy(update={"part": part}))[0]


def test_buildings_set_close_are_moved_apart_and_neither_turned_nor_put_outside() -> None:
    problem = problems(close(outline=[[0, 0], [90, 0], [90, 60], [0, 60]]))[0]
    boxes = np.array([[12.0, 20.0, 0.0, 30.0, 16.0], [30.5, 20.0, 0.0, 30.0, 16.0]])
    jammed = SiteLayout(boxes, np.ones(2, bool), {})
    watch = BudgetWatch(Budget(steps=1), None, None)
    freed = loosen_buildings(problem, jammed, watch, np.random.default_rng(1))

    def shapes(layout: SiteLayout) -> list[shapely.Polygon]:
        rings = zip(problem.buildings.outlines(), layout.boxes, strict=True)
        return [shapely.Polygon(place_outline(ring, *box[:3])) for ring, box in rings]

    assert shapely.distance(*shapes(jammed)) < 3.0
    assert shapely.distance(*shapes(freed)) > 8.0
    assert np.array_equal(freed.boxes[:, 2:], boxes[:, 2:])
    assert all(shapely.box(1, 1, 89, 59).buffer(0.01).covers(one) for one in shapes(freed))


def test_boxes_cost_the_same_as_polygons() -> None:
    plain = box_problem()
    outline = plain.buildings.outlines()[0]
    corners = tuple((float(x), float(y)) for x, y in outline)
    shaped = plain._replace(buildings=plain.buildings._replace(footprints=(corners,) * 6))
    rng = np.random.default_rng(4)
    low, high = (-10, -10, -4), (130, 100, 4)
    poses = rng.uniform(low, high, (40, 6, 3))
    population = np.concatenate([poses, np.broadcast_to([30.0, 16.0], (40, 6, 2))], 2)
    assert np.abs(evaluate(plain, population) - evaluate(shaped, population)).max() < 1e-9


def test_two_houses_stand_in_each_others_corner() -> None:
    assert len(buildings_of(sw.solve(close(None), seed=1))) == 1
    solution = sw.solve(close(), seed=1)
    first, second = buildings_of(solution)
    assert sw.check(solution).valid
    assert not solution.left_out
    boxes = polygons_of([replace(first, footprint=()), replace(second, footprint=())])
    assert boxes[0].intersection(boxes[1]).area > 10.0
    shapes = polygons_of([first, second])
    assert shapely.distance(*shapes) > 2.0
    assert [shape.area for shape in shapes] == pytest.approx([30 * 7 + 8 * 9] * 2)


def test_behind_a_house_stays_its_shade() -> None:
    room = [[0, 0], [40, 0], [40, 44], [0, 44]]
    solution = sw.solve(close(sun_spacing=1.5, outline=room), seed=1)
    assert sw.check(solution).valid


def test_layouts_are_cleared_by_what_buildings_cover() -> None:
    problem = problems(close())[0]
    made = make_measure(problem)
    boxes = np.array([[16.0, 19.0, SOUTH, 30, 16], [16.0, 10.0, -SOUTH, 30, 16]])
    assert standing(made, boxes).all()
    nearer = boxes - np.array([[0, 1.2, 0, 0, 0], [0, 0, 0, 0, 0]])
    assert standing(made, nearer).sum() == 1
    assert standing(made, boxes + np.array([9.0, 0, 0, 0, 0])).sum() == 0
    plain = problem._replace(buildings=problem.buildings._replace(footprints=()))
    assert standing(make_measure(plain), boxes).sum() == 1


@pytest.mark.parametrize("solver", ["sa", "random"])
def test_the_papers_solvers_keep_polygons_apart(solver: str) -> None:
    solution = sw.solve(close(), solver=solver, steps=400, seed=2)
    assert sw.check(solution).valid


def test_the_referee_judges_what_houses_cover() -> None:
    ground = site(60, 40, spacing=2.0)
    local = tuple((float(x) - 15, float(y) - 8) for x, y in ELL)
    first = building("a", 16, 19, 30, 16, heading=SOUTH, footprint=local)
    second = building("b", 16, 10, 30, 16, heading=-SOUTH, footprint=local)
    assert not judge_sites(ground, first, second).findings
    for gap, kind in ((1.5, "spacing"), (4.0, "collision")):
        nearer = replace(second, pose=second.pose._replace(y=second.pose.y + gap))
        kinds = {f.kind for f in judge_sites(ground, first, nearer).findings}
        assert kinds == {kind}
    figures = judge_sites(ground, first, second).figures["s"]
    assert figures["coverage"] == pytest.approx(2 * 282 / 2400, abs=1e-4)


def test_locked_houses_keep_their_footprint() -> None:
    solution = sw.solve(close(), seed=1)
    first, second = buildings_of(solution)
    turned = (first.pose.x, first.pose.y, first.pose.heading)
    changed = adjust(solution, move={first.id: turned}, lock=(second.id,)).solution
    assert sw.check(changed).valid
    brief = lock_sites(changed)
    held = plan_sites(brief).detail[0].fixed
    assert [shapely.Polygon(row.footprint).area for row in held] == pytest.approx([282, 282])
    again = sw.solve(brief, seed=3)
    assert sw.check(again).valid
    assert [p.footprint for p in buildings_of(again)] == [first.footprint, second.footprint]


def test_files_show_the_polygon(tmp_path: Path) -> None:
    solution = sw.solve(close(), seed=1)
    assert solution_json.loads(solution_json.dumps(solution)).pieces == solution.pieces
    names = ("s.geojson", "s.city.json", "s.svg", "s.glb")
    for name in names:
        sw.write(solution, tmp_path / name)
    features = json.loads((tmp_path / "s.geojson").read_text())["features"]
    rings = [f["geometry"]["coordinates"][0] for f in features if "building" in f["properties"]]
    assert [len(ring) for ring in rings] == [7, 7]
    objects = json.loads((tmp_path / "s.city.json").read_text())["CityObjects"].values()
    solids = [o["geometry"][0]["boundaries"][0] for o in objects if o["type"] == "Building"]
    assert [len(shell) for shell in solids] == [8, 8]


def test_the_plan_marks_the_side_farthest_ahead() -> None:
    corners = np.array([(0, 0), (30, 0), (30, 7), (8, 7), (8, 16), (0, 16)], float)
    house = StandingBuilding("h", "", "villa", "s", corners, 0, 7, np.pi / 2, 2, False)
    drawn = mark_text(buildings_mark(PaperView(1.0, 0.0, 0.0), [house]))
    tips = [[*map(float, spot.split(","))] for spot in re.findall(r"-?[0-9.]+,-?[0-9.]+", drawn)]
    assert np.mean([x for x, _ in tips[-3:]]) == pytest.approx(4.0, abs=0.1)


def test_a_size_is_that_of_the_footprint() -> None:
    brief = close()
    house = brief.part.sites[0].buildings[0].model_copy(update={"size": None, "count": 1})
    sites = [brief.part.sites[0].model_copy(update={"buildings": [house]})]
    part = brief.part.model_copy(update={"sites": sites})
    piece = buildings_of(sw.solve(brief.model_copy(update={"part": part}), seed=1))[0]
    assert piece.size[:2] == (30.0, 16.0)
    assert shapely.Polygon(outline_of(piece)).area == pytest.approx(282)


def test_a_footprint_that_crosses_itself_is_one_line() -> None:
    with pytest.raises(InputError, match=r"footprint.*simple polygon") as told:
        close([[0, 0], [1, 1], [1, 0], [0, 1]])
    assert "\n" not in str(told.value)


def test_where_a_middle_can_stand_is_exact() -> None:
    block = blocks_of(problems(close())[0])[0]
    rng, ell = np.random.default_rng(1), np.array(ELL, float) - (15, 8)
    kept = [shapely.box(10, 10, 16, 14), shapely.Polygon([(30, 5), (36, 8), (31, 12)])]
    found = middles(block, ell, kept)
    free = block.difference(shapely.union_all(kept))
    for x, y in rng.uniform((0, 0), (40, 28), (300, 2)):
        moved = shapely.Polygon(ell + np.array([x, y]))
        lost = moved.area - moved.intersection(free).area
        if found.covers(shapely.Point(x, y)):
            assert lost < 0.05
        else:
            assert lost > 0 or found.distance(shapely.Point(x, y)) < 1e-6


def test_convex_parts_cover_a_polygon_once() -> None:
    shape = shapely.Point(0, 0).buffer(5).difference(shapely.box(0, 0, 9, 9))
    corners = tuple(map(tuple, shapely.get_coordinates(shape.exterior)[:-1].tolist()))
    parts = [shapely.Polygon(part) for part in convex_parts(corners)]
    assert sum(part.area for part in parts) == pytest.approx(shape.area)
    assert all(part.convex_hull.area == pytest.approx(part.area) for part in parts)
    assert len(parts) < 8
