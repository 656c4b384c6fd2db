"""The ground of extensions: fronts, walks, plots and fences."""

from __future__ import annotations

import json

import numpy as np
import pytest
import shapely

import scenewright as sw
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.extend.problem import GrownLayout
from scenewright.domains.extend.solvers.fronts import turn_fronts
from scenewright.ground.buildings.built import BuiltBuilding, BuiltScene, ground_of
from scenewright.ground.ways.door_walks import WalkGround, lay_long_walks, lay_walks_to_doors


@pytest.fixture(scope="module")
def village() -> sw.Solution:
    return sw.solve(sw.read("sample:extend-village"), preset="quick")


def test_every_new_building_has_a_plot_that_holds_it(village: sw.Solution) -> None:
    plots = {row.house: row for row in sw.plots_of(village)}
    held = {name for row in plots.values() for name in (row.house, *row.outbuildings)}
    new = [p for p in village.pieces if p.category == "building" and p.space != "source"]
    assert held == {piece.id for piece in new}
    shapes = {p.id: s for p, s in zip(new, polygons_of(new), strict=True)}
    for row in plots.values():
        assert shapely.Polygon(row.outline).intersection(shapes[row.house]).area > 0.99 * (
            shapes[row.house].area
        )


def test_old_and_new_plots_are_fenced_alike_and_walks_lead_to_doors(village: sw.Solution) -> None:
    surfaces = {row.kind: row for row in sw.scene_of(village).surfaces}
    fences = shapely.union_all([shapely.Polygon(*area) for area in surfaces["fence"].areas])
    for old in (True, False):
        near = [p for p in village.pieces if (p.space == "source") == old]
        around = shapely.union_all(shapely.buffer(polygons_of(near), 12.0))
        assert fences.intersection(around).length > 20
    walks = shapely.union_all([shapely.Polygon(*area) for area in surfaces["walk"].areas])
    houses = [p for p in village.pieces if p.category == "building"]
    away = [shape.distance(walks) for shape in polygons_of(houses)]
    assert np.mean(np.array(away) < 0.3) > 0.9
    assert fences.intersection(walks).area < 0.01


def test_plots_are_written(village: sw.Solution, tmp_path) -> None:
    sw.write(village, tmp_path / "a.city.json")
    city = json.loads((tmp_path / "a.city.json").read_text())["CityObjects"]
    found = sum(one["attributes"].get("class") == "plot" for one in city.values())
    assert found == len(sw.plots_of(village))


def test_a_house_that_looks_away_from_its_street_is_turned_round() -> None:
    (problem,) = _problems()
    road = np.asarray(problem.roads[0].line)
    way = (road[1] - road[0]) / np.hypot(*(road[1] - road[0]))
    out = np.array([-way[1], way[0]])
    at = road.mean(0) + 10.0 * out
    away = float(np.arctan2(out[1], out[0]))
    rows = np.array([[*at, away], [*at, away + np.pi]])
    layout = GrownLayout(rows, np.array([0, 0]), ("filled",) * 2, 0, {})
    turned = turn_fronts(problem, layout).poses
    for pose in turned:
        assert np.cos(pose[2]) * out[0] + np.sin(pose[2]) * out[1] < 0


def _problems():
    from scenewright.domains import problems

    return problems(sw.read("sample:extend-village"), "quick")[:1]


def test_places_apart_are_as_dense_as_one_of_them() -> None:
    def row(x: float) -> list[BuiltBuilding]:
        boxes = [shapely.box(x + a, 0, x + a + 9, 8) for a in (0, 14, 28, 42)]
        rings = [np.array(box.exterior.coords)[:-1] for box in boxes]
        return [BuiltBuilding(f"{x}-{k}", "", ring, 7.0) for k, ring in enumerate(rings)]

    near, far = BuiltScene("a", tuple(row(0))), BuiltScene("b", (*row(0), *row(5000.0)))
    assert ground_of(far).area == pytest.approx(ground_of(near).area, rel=0.05)


def test_walks_join_one_another_and_none_crosses_another() -> None:
    ground = WalkGround(shapely.box(0, 0, 60, 40), shapely.LineString([(0, 0), (0, 5)]), True)
    houses = [_house(f"h{k}", 20.0 + 6.0 * k, 20.0) for k in range(4)]
    walks = lay_walks_to_doors(ground, houses)
    assert len(walks) == 4
    assert sum(walk.length for walk in walks) < sum(
        walk.length for walk in lay_walks_to_doors(ground._replace(joined=False), houses)
    )
    for k, walk in enumerate(walks):
        assert not any(walk.crosses(other) for other in walks[:k])


def test_a_passage_too_narrow_for_a_walk_leads_to_a_door_behind_it() -> None:
    street = shapely.LineString([(0, 0), (30, 0)])
    ground = WalkGround(shapely.box(0, 0, 30, 20), street, True)
    wall = [_box("left", 7.0, 6.0, 14.0, 2.0), _box("right", 22.4, 6.0, 15.2, 2.0)]
    hut = _box("hut", 14.5, 12.0, 3.0, 3.0)
    walks = shapely.union_all(
        lay_long_walks(ground, [*wall, hut], lay_walks_to_doors(ground, wall))
    )
    door = shapely.Point(14.5, 10.5)
    assert walks.distance(street) < 1e-6
    assert walks.distance(door) < 1e-6
    assert min(walks.distance(shape) for shape in polygons_of(wall)) > 0.2


def _house(name: str, x: float, y: float) -> Piece:
    return _box(name, x, y, 4.0, 4.0)


def _box(name: str, x: float, y: float, width: float, depth: float) -> Piece:
    pose, size = Pose(x, y, 0.0, -np.pi / 2), Size(width, depth, 5.0)
    return Piece(name, "building", "", "area-1", pose, size)
