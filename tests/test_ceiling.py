"""Sloped ceilings: the arithmetic against slow references, turned, read, saved, and the energy."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
import shapely

from rooms import OUTLINE, full_problem, random_layouts
from scenewright.building import ceiling
from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.core.space import Slope, Space
from scenewright.domains import check
from scenewright.domains.home import solving as home
from scenewright.domains.home import tasks, wheelchair
from scenewright.domains.home.cases.library import SHIPPED
from scenewright.domains.home.energy import evaluate, explain
from scenewright.domains.home.presets import PRESETS
from scenewright.formats import brief_json, read, solution_json
from scenewright.geometry.boxes import common_area, make_frame

QUARTER = math.pi / 4


def attic(slopes: tuple[Slope, ...], outline: np.ndarray = OUTLINE, height: float = 2.5) -> Space:
    return Space("a", "a", ("bedroom",), "0", outline, height=height, slopes=slopes)


def slow_height(space: Space, x: float, y: float) -> float:
    """The height of the ceiling at one point, slope by slope, by the distance from a line."""
    found = space.height
    for slope in space.slopes:
        (x0, y0), (x1, y1) = space.outline[slope.edge], space.outline[slope.edge - len(OUTLINE) + 1]
        side = (x1 - x0) * (y - y0) - (y1 - y0) * (x - x0)
        found = min(
            found,
            slope.knee + max(side, 0.0) / math.hypot(x1 - x0, y1 - y0) * math.tan(slope.pitch),
        )
    return found


def some_slopes(random: np.random.Generator) -> tuple[Slope, ...]:
    return tuple(
        Slope(int(random.integers(6)), float(random.uniform(0, 2)), float(random.uniform(0.2, 1.4)))
        for _ in range(int(random.integers(1, 4)))
    )


@pytest.mark.parametrize("seed", range(20))
def test_heights_strips_and_areas_agree_with_sampling(seed: int) -> None:
    random = np.random.default_rng(seed)
    space = attic(some_slopes(random))
    slopes, bounds = ceiling.planes(space), np.array([0.0, 0.0, 6.0, 5.5])
    points = random.uniform([0, 0], [6, 5.5], (400, 2))
    slow = np.array([slow_height(space, x, y) for x, y in points])
    assert np.allclose(ceiling.heights(points, slopes, space.height), slow)

    tops = random.uniform(0.3, 2.4, 4)
    strips = ceiling.strips(slopes, tops, bounds)
    areas = shapely.polygons(corners(strips[:, :5]))
    for top in tops:
        met = shapely.intersects_xy(shapely.union_all(areas[strips[:, 5] < top]), points)
        sure = np.abs(slow - top) > 1e-6
        assert (met == (slow < top))[sure].all()

    low = ceiling.below(shapely.box(*bounds), slopes, space.height, 1.7)
    assert (shapely.intersects_xy(low, points) == (slow < 1.7))[np.abs(slow - 1.7) > 1e-6].all()


@pytest.mark.parametrize("seed", range(10))
def test_the_lowest_ceiling_over_a_box_is_that_of_its_points(seed: int) -> None:
    random = np.random.default_rng(seed)
    space = attic(some_slopes(random))
    box = np.array([[*random.uniform(1, 4, 2), random.uniform(-3, 3), *random.uniform(0.2, 2, 2)]])
    square = np.stack(np.meshgrid(*[np.linspace(-0.5, 0.5, 21)] * 2), -1).reshape(-1, 2)
    x, y, heading, width, depth = box[0]
    right, ahead = square[:, :1] * width, square[:, 1:] * depth
    points = (x, y) + right * (math.sin(heading), -math.cos(heading))
    points = points + ahead * (math.cos(heading), math.sin(heading))
    slow = min(slow_height(space, *point) for point in points)
    assert ceiling.lowest(box, ceiling.planes(space), space.height)[0] == pytest.approx(slow)


def test_living_area_counts_low_floor_by_half_or_not_at_all() -> None:
    space = attic((Slope(0, 0.4, QUARTER),))
    shape, slopes = shapely.Polygon(OUTLINE), ceiling.planes(space)
    fine = np.stack(np.meshgrid(np.arange(0.01, 6, 0.02), np.arange(0.01, 5.5, 0.02)), -1)
    fine = fine.reshape(-1, 2)[shapely.intersects_xy(shape, fine.reshape(-1, 2))]
    high = ceiling.heights(fine, slopes, 2.5)
    slow = (np.sum(high >= 2) + np.sum((high >= 1) & (high < 2)) / 2) * 0.0004
    assert ceiling.living_area(shape, slopes, 2.5) == pytest.approx(slow, rel=0.01)
    assert ceiling.living_area(shape, slopes[:0], 2.5) == pytest.approx(shape.area)
    assert ceiling.living_area(shape, slopes[:0], 1.9) == pytest.approx(shape.area / 2)


def test_the_energy_charges_what_is_too_tall_and_turns_with_the_room() -> None:
    problem = full_problem()
    slopes = ceiling.planes(attic((Slope(0, 0.6, 0.6), Slope(4, 1.0, 0.9))))
    under = problem._replace(
        ground=problem.ground._replace(slopes=slopes), weights={"slope": 1.0, "route": 3.0}
    )
    layouts = random_layouts(problem, 40)
    found = evaluate(under, layouts)
    plain = evaluate(under._replace(weights={"slope": 1.0}), layouts)
    for layout, value in zip(layouts, plain, strict=True):
        areas, total = shapely.polygons(corners(layout)), float(layout[:, 3:].prod(-1).sum())
        slow = sum(
            max(0.0, _area_below(area, slope, top))
            for area, top in zip(areas, problem.items.height, strict=True)
            for slope in slopes
        )
        assert value == pytest.approx(slow / total, abs=1e-5)
    part = next(p for p in explain(under, layouts[0]) if p.term == "slope")
    assert part.weight == 1.0
    assert (found >= plain - 1e-9).all()


def _area_below(area: shapely.Polygon, slope: np.ndarray, top: float) -> float:
    return float(ceiling.below(area, slope[None], 99.0, top).area)


@pytest.mark.parametrize(
    ("slope", "words"),
    [
        ({"edge": 1, "pitch": math.pi / 2}, "1.55"),
        ({"edge": 1, "pitch": 0}, "0.02"),
        ({"edge": 1, "pitch": -0.7}, "0.02"),
        ({"edge": 4, "pitch": 0.7}, "edges 0 to 3"),
        ({"edge": -1, "pitch": 0.7}, "0"),
        ({"edge": 0.5, "pitch": 0.7}, "whole number"),
        ({"edge": 1, "pitch": 0.7, "knee": 2.7}, "above the ceiling"),
        ({"edge": 1, "pitch": 0.7, "knee": -1}, "0"),
        ({"edge": 1}, "pitch"),
        ({"edge": 1, "pitch": 0.7, "height": 1}, "height"),
        ("steep", ""),
    ],
)
def test_bad_slopes_are_told_in_one_line(slope: object, words: str) -> None:
    room = {"name": "Loft", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "slopes": [slope]}
    with pytest.raises(InputError) as told:
        spaces(brief_json.loads(json.dumps({"rooms": [room]})))
    assert "slopes[0]" in str(told.value)
    assert words in str(told.value)
    assert "\n" not in str(told.value)


def test_slopes_that_are_no_numbers_are_told_in_one_line() -> None:
    room = {"outline": [[0, 0], [4, 0], [4, 3], [0, 3]], "slopes": [{"edge": 0, "pitch": math.nan}]}
    with pytest.raises(InputError, match="NaN is not a number"):
        brief_json.loads(json.dumps({"rooms": [room]}))


def test_too_many_slopes_and_slopes_of_halls_are_refused() -> None:
    slope = {"edge": 0, "pitch": 0.7}
    room = {"outline": [[0, 0], [9, 0], [9, 9], [0, 9]], "slopes": [slope] * 21}
    with pytest.raises(InputError, match="slopes"):
        brief_json.loads(json.dumps({"rooms": [room]}))
    hall = {"domain": "hall", "rooms": [room | {"slopes": [slope]}]}
    with pytest.raises(InputError, match="slopes: are given, but the brief is of a hall"):
        spaces(brief_json.loads(json.dumps(hall)))


def test_slopes_keep_their_walls_whichever_way_the_outline_runs() -> None:
    corners_ = [[0, 0], [4, 0], [4, 1.5], [4, 3], [0, 3]]
    for listed in (corners_, corners_[::-1]):
        for outlines in ("inner", "centre"):
            middles = {
                number: np.mean([listed[number], listed[(number + 1) % 5]], 0)
                for number in range(5)
            }
            for number, middle in middles.items():
                room = {"outline": listed, "slopes": [{"edge": number, "pitch": 0.7}]}
                space = spaces(Brief.model_validate({"rooms": [room], "outlines": outlines}))[0]
                row = ceiling.planes(space)[0]
                assert abs((middle - row[:2]) @ row[2:4]) < 0.07
                assert (np.array([2.0, 1.6]) - row[:2]) @ row[2:4] > 0


def test_slopes_survive_saving_and_solving_again() -> None:
    brief = read("sample:home-attic")
    solution = home.solve(brief, steps=200)
    again = solution_json.loads(solution_json.dumps(solution))
    assert again.brief == solution.brief
    assert [s.slopes for s in spaces(again.brief)] == [s.slopes for s in spaces(brief)]
    assert brief_json.loads(brief_json.dumps(brief)) == brief
    locked = brief_json.loads(solution_json.dumps(solution))
    assert [room.slopes for room in locked.rooms] == [room.slopes for room in brief.rooms]


def test_wheelchairs_turn_where_the_ceiling_lets_them() -> None:
    brief = read("sample:home-attic").model_copy(update={"accessible": True})
    rooms = spaces(brief)
    for room, space in zip(brief.rooms, rooms, strict=True):
        task = tasks.task_of(
            brief, room, space, (), catalog_of([]), SHIPPED, PRESETS["default"], "anneal", 0
        )
        for spot in wheelchair.spots(task):
            ring = np.array(spot) + 0.75 * np.array([[1, 0], [0, 1], [-1, 0], [0, -1], [0, 0]])
            over = ceiling.heights(ring, ceiling.planes(space), space.height)
            assert over.min() >= 1.5 - 1e-6
            assert over[-1] >= 2.0 - 1e-6


@pytest.mark.parametrize("seed", range(8))
def test_low_floor_is_where_no_route_can_pass(seed: int) -> None:
    random = np.random.default_rng(seed)
    space = attic((Slope(0, float(random.uniform(0, 1.9)), float(random.uniform(0.2, 1.5))),))
    slopes, width = ceiling.planes(space), float(random.uniform(0.4, 1.5))
    low = ceiling.low_floor(slopes, width, np.array([0.0, 0.0, 6.0, 5.5]))
    grown = shapely.union_all(shapely.polygons(corners(low))).buffer(width / 2)
    for y in np.linspace(width / 2 + 0.01, 5, 60):
        nearest = slow_height(space, 3.0, float(y) - width / 2)
        passes = slow_height(space, 3.0, float(y)) >= 2.0 and nearest >= 1.5
        edge = shapely.Point(3.0, y).distance(grown.boundary) < 1e-3 if len(low) else False
        assert edge or passes != shapely.intersects_xy(grown, 3.0, float(y))


def test_a_lamp_over_a_table_hangs_from_the_slope() -> None:
    table = {"category": "dining_table", "at": [2.0, 1.6], "size": [1.4, 0.9, 0.75]}
    room = {
        "name": "Dining room",
        "outline": [[0, 0], [4, 0], [4, 4], [0, 4]],
        "ask": [],
        "slopes": [{"edge": 0, "knee": 1.0, "pitch": QUARTER}],
        "doors": [{"at": [4, 3.2]}],
        "fixed": [table | {"group": "a", "function": "dining"}],
    }
    solution = home.solve(Brief.model_validate({"rooms": [room]}), steps=50)
    (lamp,) = [p for p in solution.pieces if p.category == "pendant_lamp"]
    assert lamp.pose.z + lamp.size.height == pytest.approx(1.0 + 1.6 - 0.22)
    assert check(solution).valid


@pytest.mark.parametrize("at", [(2.0, 1.6), (2.0, 2.0)])
def test_a_lamp_hangs_beside_a_beam_not_through_it(at: tuple[float, float]) -> None:
    """Over a table no lamp hangs where a beam runs; the room has one beside the beam."""
    beam = {"category": "obstacle", "at": at, "size": [3.9, 0.3, 0.3], "z": 2.2}
    table = {"category": "dining_table", "at": [2.0, 1.6], "size": [1.4, 0.9, 0.75]}
    room = {
        "name": "Dining room",
        "height": 2.5,
        "outline": [[0, 0], [4, 0], [4, 4], [0, 4]],
        "ask": [],
        "doors": [{"at": [4, 3.2]}],
        "fixed": [table | {"group": "a", "function": "dining"}, beam],
    }
    solution = home.solve(Brief.model_validate({"rooms": [room]}), steps=50)
    lamps = [p for p in solution.pieces if p.category in ("pendant_lamp", "ceiling_lamp")]
    assert lamps
    assert check(solution).valid, check(solution).findings
    for lamp in lamps:
        beam_box = make_frame(*at, 0.0, 3.9, 0.3)
        assert common_area(make_frame(*lamp.pose[:2], 0.0, *lamp.size[:2]), beam_box) < 1e-4
