"""Trees and lamps of extensions: read from maps and city models, put in as densely as the source
has them, clear of all that stands there."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright as sw
from catalogs import city, flat, saved
from scenewright.core.brief import Brief
from scenewright.core.brief.terrain import TerrainBrief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.domains import plan_of
from scenewright.domains.extend.uses import measure_schemes
from scenewright.domains.extend.works import lay_walks
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.planting.density import count_planting, split_ground
from scenewright.ground.reading import read_built
from scenewright.ground.ways.surfaces import kerb

PLACE = (11.5, 49.5)


def box(x: float, y: float, w: float = 10.0, d: float = 8.0) -> list[list[float]]:
    return [[x, y], [x + w, y], [x + w, y + d], [x, y + d]]


def brief(**source: Any) -> Brief:
    """Two rows of houses on a street that runs on into the area, with trees and lamps."""
    given = {
        "name": "Old rows",
        "buildings": [
            {"outline": box(24.0 * k, y), "height": 7.0} for k in range(5) for y in (0.0, 36.0)
        ],
        "roads": [{"line": [[-10, 22], [120, 22]], "width": 6.0}],
        "trees": [[24.0 * k + 17, y] for k in range(5) for y in (4.0, 40.0)]
        + [[12.0 * k, 27.0] for k in range(10)],
        "lamps": [[26.0 * k + 3, 18.4] for k in range(5)],
    }
    area = {"id": "a", "outline": [[120, -6], [240, -6], [240, 50], [120, 50]], "count": 8}
    document = {"domain": "extend", "sources": [given | source], "areas": [area], "origin": PLACE}
    return Brief.model_validate(document)


@pytest.fixture(scope="module")
def planted() -> sw.Solution:
    return sw.solve(brief(), preset="quick", steps=1)


def of(solution: sw.Solution, category: str, space: str = "a") -> list[Piece]:
    return [p for p in solution.pieces if p.category == category and p.space == space]


def points(pieces: list[Piece]) -> Any:
    return shapely.points([piece.pose[:2] for piece in pieces])


def test_new_ground_is_planted_and_lit_as_the_source_is(planted: sw.Solution) -> None:
    found = measure_schemes(planted, plan_of(planted.brief))["a"]
    for name in ("trees_per_hectare", "street_trees_per_100_m", "lamps_per_100_m"):
        assert found[f"source_{name}"] > 0
        assert found[name] == pytest.approx(found[f"source_{name}"], rel=0.25), name
    assert len(of(planted, "tree", "source")) == 20
    assert len(of(planted, "lamp_post", "source")) == 5
    assert sw.check(planted).valid
    told = sw.explain(planted).decided
    assert f"{found['trees']} trees" in told
    assert f"{found['lamps']} lamps" in told


def test_trees_and_lamps_stand_clear(planted: sw.Solution) -> None:
    plan = plan_of(planted.brief).detail
    houses = shapely.union_all(polygons_of([*of(planted, "building")]))
    lines = [(shapely.LineString(way.line), way.width / 2) for way in plan.ground.roads]
    street = shapely.union_all([line.buffer(half) for line, half in lines])
    lane = shapely.union_all([line.buffer(half - kerb(2.0 * half)) for line, half in lines])
    rows = lay_walks(plan, planted.pieces).pathways
    walks = shapely.union_all([shapely.LineString(r.line).buffer(r.width / 2) for r in rows])
    trees, lamps = points(of(planted, "tree")), points(of(planted, "lamp_post"))
    assert len(trees) > 5
    assert len(lamps) > 2
    assert shapely.contains(street, lamps).all()
    for taken, stems, posts in ((houses, 3.2, 0.6), (lane, 1.4, 0.4), (walks, 1.4, 0.6)):
        assert shapely.distance(trees, taken).min() >= stems - 1e-6
        assert shapely.distance(lamps, taken).min() >= posts - 1e-6
    assert shapely.contains(plan.areas[0].outline, np.concatenate([trees, lamps])).all()


def test_a_source_without_trees_gets_none_and_is_named() -> None:
    solution = sw.solve(brief(trees=[]), preset="quick", steps=1)
    assert not of(solution, "tree")
    assert of(solution, "lamp_post")
    assert "Old rows draws no tree:" in sw.explain(solution).decided


def test_planting_is_the_same_by_seed_and_never_moves_a_building(planted: sw.Solution) -> None:
    again = sw.solve(brief(), preset="quick", steps=1)
    bare = sw.solve(brief(trees=[], lamps=[]), preset="quick", steps=1)
    assert again.pieces == planted.pieces
    assert [p for p in planted.pieces if p.category == "building"] == list(bare.pieces)


@pytest.mark.parametrize("suffix", [".geojson", ".city.json", ".json"])
def test_written_trees_and_lamps_are_read_again(
    planted: sw.Solution, suffix: str, tmp_path: Path
) -> None:
    sw.write(planted, tmp_path / f"e{suffix}")
    scene = read_built(tmp_path / f"e{suffix}")
    for category, found in (("tree", scene.trees), ("lamp_post", scene.lamps)):
        assert len(found) == sum(p.category == category for p in planted.pieces), category
    middle = np.mean([p.pose[:2] for p in planted.pieces if p.category == "tree"], axis=0)
    houses = np.mean([one.outline.mean(0) for one in scene.buildings], axis=0)
    ours = [p for p in planted.pieces if p.category == "building"]
    shift = houses - np.mean([shapely.Polygon(s).centroid.coords[0] for s in polygons_of(ours)], 0)
    assert np.abs(np.mean(scene.trees, axis=0) - middle - shift).max() < 1.0


def feature(name: str, tags: dict[str, str], kind: str, at: Any) -> dict[str, Any]:
    return {
        "type": "Feature",
        "id": name,
        "properties": tags,
        "geometry": {"type": kind, "coordinates": at},
    }


def degrees(shape: Any) -> Any:
    rows = np.array(shape, float) * (1 / 72300, 1 / 111200) + PLACE
    return rows.tolist()


def town(path: Path, more: list[dict[str, Any]]) -> Path:
    ring = [*box(120, -6, 100, 50), [120, -6]]
    rows = [feature("area", {"extend": "yes"}, "Polygon", [degrees(ring)])]
    for k in range(4):
        house = [*box(24.0 * k, 0), [24.0 * k, 0]]
        rows.append(feature(f"h{k}", {"building": "yes"}, "Polygon", [degrees(house)]))
    path.write_text(json.dumps({"type": "FeatureCollection", "features": rows + more}))
    return path


def circle(x: float, y: float) -> Any:
    turn = np.linspace(0, 2 * np.pi, 13)
    return np.stack([x + 2 * np.cos(turn), y + 2 * np.sin(turn)], 1)


def test_maps_tell_their_trees_and_lamps(tmp_path: Path) -> None:
    more = [
        feature("t", {"natural": "tree"}, "Point", degrees([[5, 20]])[0]),
        feature("r", {"natural": "tree_row"}, "LineString", degrees([[0, 40], [45, 40]])),
        feature("l", {"highway": "street_lamp"}, "Point", degrees([[9, 20]])[0]),
        feature("bin", {"amenity": "waste_basket"}, "Point", degrees([[9, 30]])[0]),
    ]
    found = sw.read(town(tmp_path / "a.geojson", more))
    assert len(found.part.sources[0].trees) == 6
    assert len(found.part.sources[0].lamps) == 1
    fates = {name: row for row in found.input_report.rows for name in row.examples}
    assert [fates[name].outcome for name in ("t", "r", "l", "bin")] == [
        "used",
        "changed",
        "used",
        "left out",
    ]
    assert "every 10 m" in fates["r"].reason


@pytest.mark.parametrize("count", [4, 12])
def test_many_round_areas_without_tags_are_trees_and_the_report_says_so(
    count: int, tmp_path: Path
) -> None:
    rows = [feature(f"c{k}", {}, "Polygon", [degrees(circle(8.0 * k, 30.0))]) for k in range(count)]
    found = sw.read(town(tmp_path / "a.geojson", rows))
    many = count == 12
    told = [row.count for row in found.input_report.rows if "a tree, small" in row.reason]
    assert told == [12] * many
    assert len(found.part.sources[0].trees) == 12 * many
    assert len(found.part.sources[0].buildings) == 4 + 4 * (not many)


def test_city_models_tell_high_plants_and_lamps(tmp_path: Path) -> None:
    document = city(
        {"a": [(0, 0), (9, 0), (9, 9), (0, 9)], "b": [(20, 0), (29, 0), (29, 9), (20, 9)]}
    )
    for name, kind, about in (
        ("wood", "PlantCover", {"averageHeight": 6.0}),
        ("lawn", "PlantCover", {}),
        ("lamp", "CityFurniture", {"function": "Street lamp"}),
        ("bench", "CityFurniture", {"function": "bench"}),
    ):
        flat(document, name, kind, np.array([(0, 20), (30, 20), (30, 40), (0, 40)], float))
        document["CityObjects"][name]["attributes"] = about
    scene = read_built(saved(tmp_path / "t.city.json", document))
    assert (len(scene.trees), len(scene.lamps)) == (6, 1)
    assert [line[:4] for line in scene.left_out] == ["1 x "] * 2


def test_trees_of_a_city_model_stand_on_the_slope(planted: sw.Solution, tmp_path: Path) -> None:
    part = planted.brief.part.model_copy(
        update={"terrain": TerrainBrief.model_validate({"slope": 0.1, "towards": 90.0})}
    )
    sloped = replace(planted, brief=planted.brief.model_copy(update={"part": part}))
    sw.write(sloped, tmp_path / "e.city.json")
    made = json.loads((tmp_path / "e.city.json").read_text())
    high = [
        made["vertices"][one["geometry"][0]["boundaries"][0]][2]
        for one in made["CityObjects"].values()
        if one["type"] == "SolitaryVegetationObject"
    ]
    assert np.ptp(high) * made["transform"]["scale"][2] > 5.0


def test_streets_are_told_from_green() -> None:
    road = BuiltRoad(np.array([[0.0, 5.0], [100.0, 5.0]]), 6.0)
    ground = split_ground(shapely.box(0, 0, 100, 50), [road], shapely.box(0, 30, 10, 40))
    found = count_planting(
        ground, np.array([[50.0, 9.0], [50.0, 40.0], [500.0, 40.0]]), np.array([[5.0, 9.0]])
    )
    assert found.trees_along == found.lamps_along == 1.0
    assert found.trees_per_hectare == pytest.approx(1e4 / (5000 - 1200 - 100))
