"""City models as sites: buildings stand where the file has them, streets and water keep free."""

from __future__ import annotations

import json
import math
from dataclasses import replace

import numpy as np
import pytest
import shapely

from catalogs import city, flat, saved
from scenewright.catalog.loading import catalog_of
from scenewright.core.errors import InputError
from scenewright.core.scene import Scene
from scenewright.domains import check, scene_of, solve
from scenewright.domains.site.plan import plans_of
from scenewright.domains.site.reading.cityjson import read_report
from scenewright.formats import read, write
from scenewright.ground.reading.road_areas import pieces
from scenewright.render.items import things, to_level_coordinates
from thoroughness import only_thorough

L_SHAPE = [(0, 0), (20, 0), (20, 8), (8, 8), (8, 24), (0, 24)]
BLOCK = [(60, 10), (84, 10), (84, 22), (60, 22)]
FAR = [(10, 70), (40, 70), (40, 82), (10, 82)]
TOWN = {"el": L_SHAPE, "block": BLOCK, "far": FAR}


def turned(outline, angle: float, by=(0.0, 0.0)):
    cos, sin = math.cos(angle), math.sin(angle)
    return np.asarray(outline, float) @ np.array([[cos, sin], [-sin, cos]]) + by


def drawn(scene: Scene, name: str, catalog) -> np.ndarray:
    """The corners of a piece as they are drawn."""
    (thing,) = [t for t in things(scene, catalog) if t.name == name]
    return np.concatenate([to_level_coordinates(thing, part.vertices) for part in thing.parts])


@pytest.mark.parametrize("angle", [0.0, 0.3, 1.2, 2.9, -0.7])
def test_buildings_are_drawn_where_the_file_has_them(tmp_path, angle):
    truth = {key: turned(outline, angle, (500, 300)) for key, outline in TOWN.items()}
    brief = read(saved(tmp_path / "town.city.json", city(truth)))
    (site,) = brief.part.sites
    solution = solve(brief, seed=1)
    catalog, scene = catalog_of(brief.catalogs), scene_of(solution)
    offset = np.array(site.shift) - (84000, 447000)
    plan = plans_of(brief)[0]
    for row in plan.landmarks:
        key = row.id
        want = truth[key] - offset
        assert (
            shapely.Polygon(row.footprint).symmetric_difference(shapely.Polygon(want)).area < 0.05
        )
        corners = drawn(scene, f"{plan.id}/{row.id}", catalog)
        away = shapely.distance(shapely.points(corners[:, :2]), shapely.LinearRing(want))
        assert away.max() < 0.002
        assert (corners[:, 2].min(), corners[:, 2].max()) == pytest.approx((0, 9))
    assert len(plan.landmarks) == 3
    assert check(solution).valid


def test_written_city_models_lie_where_they_were_read(tmp_path):
    brief = read(saved(tmp_path / "town.json", city(TOWN)))
    write(solve(brief, seed=1), tmp_path / "out.cityjson")
    document = json.loads((tmp_path / "out.cityjson").read_text())
    scale, shift = (np.array(document["transform"][key]) for key in ("scale", "translate"))
    corners = np.array(document["vertices"]) * scale + shift
    built = document["CityObjects"]["town/block"]["geometry"][0]["boundaries"][0][0][0]
    found = corners[built][:, :2] - (84000, 447000)
    assert sorted(map(tuple, found.round(3).tolist())) == sorted(
        (float(x), float(y)) for x, y in BLOCK
    )
    assert document["metadata"]["referenceSystem"].endswith("7415")


def test_scenes_say_where_their_origin_lies(tmp_path):
    brief = read(saved(tmp_path / "town.json", city(TOWN)))
    solution, (site,) = solve(brief, seed=1, steps=1), brief.part.sites
    roots = []
    for told in (solution, replace(solution, brief=_unplaced(brief))):
        write(told, tmp_path / "town.glb")
        content = (tmp_path / "town.glb").read_bytes()
        document = json.loads(content[20 : 20 + int.from_bytes(content[12:16], "little")])
        roots.append(document["nodes"][0]["extras"])
    system = "https://www.opengis.net/def/crs/EPSG/0/7415"
    stated = {"crs": system, "origin": list(site.shift)}
    assert roots == [{"category": "site", "georeference": stated}, {"category": "site"}]


def _unplaced(brief):
    sites = [site.model_copy(update={"system": ""}) for site in brief.part.sites]
    return brief.model_copy(update={"part": brief.part.model_copy(update={"sites": sites})})


def test_what_was_written_is_read_with_its_ground(tmp_path):
    brief = read(saved(tmp_path / "town.json", city(TOWN)))
    first = solve(brief, seed=1)
    write(first, tmp_path / "out.cityjson")
    back = read(tmp_path / "out.cityjson")
    before, after = plans_of(brief)[0], plans_of(back)[0]
    assert after.area == pytest.approx(before.area, rel=1e-3)
    assert len(after.landmarks) == sum(p.category == "building" for p in first.pieces)


def test_streets_and_water_are_kept_free(tmp_path):
    town = city(TOWN)
    flat(town, "street", "Road", [(-10, 30), (95, 30), (95, 40), (-10, 40)])
    flat(town, "pond", "WaterBody", [(45, 50), (55, 50), (55, 65), (45, 65)])
    brief = read(saved(tmp_path / "town.json", town))
    (plan,), shift = plans_of(brief), np.array(brief.part.sites[0].shift) - (84000, 447000)
    (road,) = plan.roads
    assert (road.kind, road.width) == ("road", pytest.approx(10, abs=0.5))
    floor = shapely.Polygon(plan.outline, plan.holes)
    assert not floor.contains(shapely.Point(np.array([50, 57]) - shift))
    solution = solve(brief, seed=1)
    assert check(solution).valid
    assert any(not p.fixed and p.category == "building" for p in solution.pieces)


def test_a_drawn_ground_counts_and_buildings_outside_it_do_not(tmp_path):
    town = city(TOWN)
    flat(town, "lot", "LandUse", [(-5, -5), (100, -5), (100, 50), (-5, 50)], name="Lot")
    town["CityObjects"]["lot"]["attributes"]["class"] = "site"
    plan = plans_of(read(saved(tmp_path / "town.json", town)))[0]
    assert (plan.name, plan.area) == ("Lot", pytest.approx(105 * 55))
    assert {row.id for row in plan.landmarks} == {"el", "block"}


def test_buildings_that_overlap_share_the_ground(tmp_path):
    twin = {"a": BLOCK, "b": [(x + 6, y) for x, y in BLOCK], "c": BLOCK}
    solution = solve(read(saved(tmp_path / "town.json", city(twin))), seed=1)
    assert check(solution).valid
    plan = plans_of(solution.brief)[0]
    areas = [shapely.Polygon(row.footprint).area for row in plan.landmarks]
    assert areas == pytest.approx([288, 72])


def test_what_is_left_out_of_a_city_is_told(tmp_path):
    town = city(TOWN | {"twin": BLOCK})
    town["CityObjects"]["far"]["geometry"] = []
    found = read_report(saved(tmp_path / "town.city.json", town))
    assert found.buildings == 4
    assert {row.name: row.reason for row in found.skipped} == {
        "far": "has no geometry that can be used",
        "twin": "another building covers it",
    }
    assert found.brief.name == "town"


def test_a_building_of_impossible_size_is_left_out_by_name(tmp_path):
    """A solution with it could not be read again."""
    slab = [(200, 0), (900, 0), (900, 20), (200, 20)]
    found = read_report(saved(tmp_path / "town.city.json", city(TOWN | {"slab": slab})))
    assert [(row.name, row.reason) for row in found.skipped] == [
        ("slab", "is 700 m large, more than a building's 500 m")
    ]
    assert found.buildings == 4


def test_buildings_of_one_name_keep_apart(tmp_path):
    long = "x" * 90
    town = city({long + "a": L_SHAPE, long + "b": BLOCK})
    solution = solve(read(saved(tmp_path / "town.json", town)), seed=1)
    assert check(solution).valid
    sizes = {tuple(np.round(p.size, 3)) for p in solution.pieces if p.fixed}
    assert len(sizes) == 2


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"version": "9.0"}, "is CityJSON 9.0"),
        ({"CityObjects": {}}, "holds no buildings"),
        (
            {"metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/4326"}},
            "are no longitude and latitude",
        ),
        ({"vertices": [[0, 0]]}, "vertices"),
        ({"transform": {"scale": [1e300, 1, 1]}}, "transform"),
    ],
)
def test_what_is_no_site_is_told(tmp_path, change, told):
    path = saved(tmp_path / "town.json", city(TOWN) | change)
    with pytest.raises(InputError) as error:
        read(path)
    assert told in str(error.value)
    assert "town.json" in str(error.value)


def test_of_buildings_far_apart_those_together_are_the_site(tmp_path):
    far = TOWN | {"lost": [(x + 4000, y + 5000) for x, y in BLOCK]}
    brief = read(saved(tmp_path / "town.json", city(far)))
    assert {row.id for row in brief.part.sites[0].landmarks} == {"el", "block", "far"}
    (row,) = [row for row in brief.input_report.rows if row.outcome == "left out"]
    assert (row.examples, row.reason) == (
        ["lost"],
        "stands more than 150 m from the 3 that are the site",
    )
    scattered = {str(k): [(x + 3000 * k, y) for x, y in BLOCK] for k in range(5)}
    with pytest.raises(InputError, match="5 buildings lie over 12 km, none within 150 m"):
        read(saved(tmp_path / "strewn.json", city(scattered)))


def test_ground_under_water_is_no_site(tmp_path):
    town = city(TOWN)
    flat(town, "sea", "WaterBody", [(-100, -100), (200, -100), (200, 200), (-100, 200)])
    with pytest.raises(InputError, match="under water"):
        read(saved(tmp_path / "town.json", town))


def test_road_areas_become_straight_pieces_that_cover_them():
    bend = shapely.LineString([(0, 0), (60, 0), (100, 40), (100, 90)]).buffer(4, cap_style="flat")
    found = pieces(bend)
    cover = shapely.union_all(
        [
            shapely.LineString(piece.line).buffer(piece.width / 2, cap_style="flat")
            for piece in found
        ]
    )
    assert cover.intersection(bend).area > 0.85 * bend.area
    assert cover.difference(bend).area < 0.15 * bend.area
    assert len(found) < 40
    assert pieces(shapely.Polygon()) == []


@pytest.mark.realdata
@pytest.mark.parametrize("name", ["delft", pytest.param("rotterdam_subset", marks=only_thorough)])
def test_real_city_models_are_sites(real_data, name):
    path = real_data / "citymodels_cityjson" / f"{name}.json"
    if not path.exists():
        pytest.skip(f"no {path.name}")
    solution = solve(read(path), seed=0)
    assert check(solution).valid
    assert sum(p.fixed for p in solution.pieces if p.category == "building") >= 16
