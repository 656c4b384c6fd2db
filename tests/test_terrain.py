"""Ground that is not flat: heights read, ways graded, doors on the ground, scenes lifted."""

from __future__ import annotations

import json

import numpy as np
import pytest
import shapely
from PIL import Image, TiffImagePlugin

import scenewright as sw
from scenewright.core.brief import Brief
from scenewright.core.brief.terrain import TerrainBrief
from scenewright.core.errors import InputError
from scenewright.core.heights import HeightGrid, facet_heights_at, heights_at
from scenewright.domains import check, explain, plan_of, scene_of
from scenewright.geometry.batters import bank
from scenewright.ground.terrain.profiles import WayLinks, limit_slope
from scenewright.ground.terrain.reading import natural_ground
from scenewright.render.draping import drape

FLOOR = shapely.box(0, 0, 60, 40)
SPOTS = np.array([[10.0, 10.0], [33.3, 21.7], [59.0, 1.0]])
SITE = {
    "domain": "site",
    "sites": [
        {
            "outline": [[0, 0], [110, 0], [110, 70], [0, 70]],
            "roads": [{"name": "Road", "line": [[-5, 34], [115, 36]], "width": 6}],
            "buildings": [{"model": "villa", "count": 5}],
        }
    ],
}


def plane(points):
    """A tenth of rise to the east, half of that to the north."""
    return 100 + 0.1 * points[..., 0] + 0.05 * points[..., 1]


def solved(terrain, base=SITE):
    brief = Brief.model_validate(base | {"terrain": terrain})
    return sw.solve(brief, preset="quick")


@pytest.fixture(scope="module")
def hill():
    return solved({"slope": 0.2, "towards": 180})


def test_heights_are_bilinear_and_facets_meet_them_at_the_corners():
    grid = HeightGrid((1.0, 2.0), 2.0, np.array([[0.0, 1.0, 3.0], [5.0, 2.0, 8.0]]))
    corners = grid.points.reshape(-1, 2)
    for read in (heights_at, facet_heights_at):
        assert read(grid, corners).tolist() == grid.values.reshape(-1).tolist()
    assert heights_at(grid, np.array([[2.0, 3.0]])) == pytest.approx(2.0)


def write_ascii(path):
    x, y = np.meshgrid(np.arange(-10, 80, 5) + 2.5, np.arange(-10, 60, 5) + 2.5)
    rows = plane(np.stack([x, y], -1))[::-1]
    head = "ncols 18\nnrows 14\nxllcorner 990\nyllcorner 1990\ncellsize 5\nNODATA_value -9999\n"
    path.write_text(head + "\n".join(" ".join(f"{v:.6f}" for v in row) for row in rows))
    return rows


def test_rasters_and_contours_give_the_heights_they_hold(tmp_path):
    rows = write_ascii(tmp_path / "hill.asc")
    tags = TiffImagePlugin.ImageFileDirectory_v2()
    tags[33550], tags[33922] = (5.0, 5.0, 0.0), (0.0, 0.0, 0.0, 990.0, 2060.0, 0.0)
    Image.fromarray(rows.astype(np.float32)).save(tmp_path / "hill.tif", tiffinfo=tags)
    lines = [
        {
            "type": "Feature",
            "properties": {"ELEV": z},
            "geometry": {
                "type": "LineString",
                "coordinates": [[(z - 100 - 0.05 * y) / 0.1, y] for y in (-20, 60)],
            },
        }
        for z in np.arange(97.0, 110.0)
    ]
    (tmp_path / "hill.geojson").write_text(
        json.dumps({"type": "FeatureCollection", "features": lines})
    )
    for name, key, at in (
        ("hill.asc", "raster", (1000, 2000)),
        ("hill.tif", "raster", (1000, 2000)),
        ("hill.geojson", "contours", (0, 0)),
    ):
        brief = TerrainBrief.model_validate({key: str(tmp_path / name), "at": at})
        found = heights_at(natural_ground(brief, FLOOR), SPOTS)
        assert found == pytest.approx(plane(SPOTS), abs=1e-3), name


def test_wrong_terrain_is_one_line_that_names_it(tmp_path):
    write_ascii(tmp_path / "hill.asc")
    (tmp_path / "no.asc").write_text("no grid")
    for terrain, words in (
        ({"raster": str(tmp_path / "hill.asc")}, "do not cover the ground"),
        ({"raster": str(tmp_path / "no.asc")}, "neither an ESRI ASCII grid nor a GeoTIFF"),
        ({"contours": str(tmp_path / "no.asc")}, "no GeoJSON of lines"),
        ({"contours": str(tmp_path / "gone.geojson")}, "there is no file"),
        ({"water": [{"outline": [[0, 0], [9, 9], [9, 0], [0, 9]]}]}, "its outline crosses itself"),
    ):
        with pytest.raises(InputError, match=words) as error:
            plan_of(Brief.model_validate(SITE | {"terrain": terrain}))
        assert "\n" not in str(error.value)
        assert error.value.place.startswith("terrain.")
    with pytest.raises(ValueError, match="one of slope, contours and raster"):
        TerrainBrief(slope=0.1, raster="hill.asc")


def test_profiles_keep_the_slope_and_leave_gentle_ground_as_it_is():
    links = WayLinks(np.array([[0, 1], [1, 2], [2, 3], [3, 4]]), np.full(4, 10.0))
    steep = np.array([0.0, 3.0, 0.0, 5.0, 5.0])
    found = limit_slope(steep, links, 0.1)
    assert np.abs(np.diff(found)).max() <= 1.0 + 1e-9
    assert np.abs(found - steep).max() == pytest.approx(2.0)  # half of the 4 m it is too steep by
    gentle = np.array([0.0, 0.5, 1.0, 1.9, 1.0])
    assert limit_slope(gentle, links, 0.1) == pytest.approx(gentle)


def test_banks_fall_no_steeper_than_their_batter():
    fixed = np.full((30, 30), np.nan)
    fixed[15, 15] = 10.0
    high = bank(fixed, 0.5)
    assert np.abs(np.diff(high)).max() <= 0.5 + 1e-9
    away = np.hypot(*(np.indices(high.shape) - 15))
    assert (high <= 10.0 - 0.5 * away + 1e-9).all()
    assert (high >= 10.0 - 0.5 * 1.083 * away - 1e-9).all()


def test_what_is_draped_covers_its_polygon_and_lies_on_the_facets():
    rng = np.random.default_rng(0)
    grid = HeightGrid((0.0, 0.0), 1.0, rng.normal(0, 1, (12, 12)))
    shape = shapely.Point(5.2, 5.7).buffer(3.9).difference(shapely.box(4, 4, 5, 6))
    vertices, faces = drape(shape, grid, 0.25)[:2]
    corners = vertices[faces]
    u, v = (corners[:, k, :2] - corners[:, 0, :2] for k in (1, 2))
    areas = (u[:, 0] * v[:, 1] - u[:, 1] * v[:, 0]) / 2
    assert areas.min() > 0
    assert areas.sum() == pytest.approx(shape.area, rel=1e-4)
    middles = corners.mean(1)
    assert middles[:, 2] == pytest.approx(facet_heights_at(grid, middles[:, :2]) + 0.25, abs=1e-4)


def test_a_site_on_a_fifth_is_valid_and_tells_what_is_moved(hill):
    report = check(hill)
    assert report.findings == ()
    ground = report.figures["terrain"]
    assert ground["natural_grade"] == pytest.approx(0.2, abs=1e-6)
    assert ground["steepest_way"] <= 0.1
    assert ground["largest_door_step"] <= 0.3
    assert ground["cut"] > 50
    assert ground["fill"] > 50
    told = explain(hill).decided.partition(" m³ cut")[0].rpartition(" ")[2]
    assert float(told.replace(",", "")) == pytest.approx(ground["cut"], abs=1.0)


def test_the_scene_stands_on_the_ground_and_the_solution_stays_flat(hill):
    scene = scene_of(hill)
    assert scene.terrain is not None
    flat = {piece.id: piece.pose for piece in hill.pieces}
    assert {pose.z for pose in flat.values()} == {0.0}
    trees = [piece for piece in scene.pieces if piece.category == "tree"]
    ground = facet_heights_at(scene.terrain.finished, np.array([t.pose[:2] for t in trees]))
    assert [t.pose.z for t in trees] == pytest.approx(ground.tolist())
    assert all(piece.pose[:2] == flat[piece.id][:2] for piece in scene.pieces)


def test_the_referee_finds_doors_and_ways_by_itself(hill):
    from scenewright.check.terrain import JudgedTerrain, judge_terrain
    from scenewright.domains.terrain import ground_shape

    shaped = ground_shape(hill, plan_of(hill.brief))
    assert shaped is not None
    brief = hill.brief.part.terrain
    natural = shaped.natural, shaped.finished, shaped.finished
    name, floor = next(iter(shaped.floors.items()))
    straight = [("Cut", np.array([[10.0, 0.0], [10.0, 70.0]]))]
    sunk = JudgedTerrain(brief, *natural, {name: floor - 1.0}, straight)
    kinds = {finding.kind for finding in judge_terrain(sunk, hill.pieces)[0]}
    assert kinds == {"door_off_ground", "steep_way"}
    deep = shaped.finished._replace(values=shaped.finished.values - 9.0)
    lowered = JudgedTerrain(brief, shaped.natural, deep, deep, {name: floor}, straight)
    told = [note.message for note in judge_terrain(lowered, hill.pieces)[1]]
    assert len(told) == 3
    assert "1 of 1 ways lie more than 3 m above or below the ground, Cut in a cut of" in told[0]
    assert "1 of 1 buildings" in told[1]
    assert "by the square metre (1 at most): lead streets along the contours" in told[2]
    assert not [n for n in check(hill).notes if "square metre" in n.message]


def test_nothing_is_built_on_a_river_and_its_road_bridges_it():
    river = [[-20, 44], [130, 50], [130, 58], [-20, 52]]
    road = {"name": "Bridge", "line": [[50, -5], [52, 75]], "width": 6}
    site = SITE["sites"][0] | {"roads": [*SITE["sites"][0]["roads"], road]}
    terrain = {"slope": 0.05, "towards": 0, "water": [{"name": "Brook", "outline": river}]}
    wet = solved(terrain, SITE | {"sites": [site]})
    assert check(wet).findings == ()
    scene = scene_of(wet)
    assert scene.terrain is not None
    middle = np.array([[51.2, 51.0]])
    ((_, level),) = scene.terrain.waters
    assert (
        heights_at(scene.terrain.finished, middle)[0]
        < level
        < heights_at(scene.terrain.deck, middle)
    )
    trees = [shapely.Point(p.pose[:2]) for p in scene.pieces if p.category == "tree"]
    assert not shapely.intersects(shapely.Polygon(river), trees).any()


def test_flat_ground_is_as_it_was():
    flat = sw.solve(Brief.model_validate(SITE), preset="quick")
    assert scene_of(flat).terrain is None
    assert "terrain" not in check(flat).figures
    assert "terrain" not in flat.brief.part.model_dump(exclude_none=True)


def test_city_models_hold_the_relief_and_buildings_on_their_floors(hill, tmp_path):
    from scenewright.domains.terrain import ground_shape

    sw.write(hill, tmp_path / "hill.city.json")
    made = json.loads((tmp_path / "hill.city.json").read_text())
    points = np.array(made["vertices"]) * made["transform"]["scale"]
    shaped = ground_shape(hill, plan_of(hill.brief))
    assert shaped is not None
    for name, floor in shaped.floors.items():
        (solid,) = made["CityObjects"][name]["geometry"]
        used = {k for face in solid["boundaries"][0] for ring in face for k in ring}
        assert points[sorted(used), 2].min() == pytest.approx(floor, abs=1e-3)
    (relief,) = [o for o in made["CityObjects"].values() if o["type"] == "TINRelief"]
    faces = np.array([face[0] for face in relief["geometry"][0]["boundaries"]])
    middles = points[faces].mean(1)
    off = middles[:, 2] - heights_at(shaped.finished, middles[:, :2])
    assert np.median(np.abs(off)) < 0.05


def test_plans_draw_contours_at_their_heights(hill):
    from scenewright.domains import draw_plan
    from scenewright.drawing.contours import contour_lines

    x = np.array([0.0, 1.0, 2.0, 3.0])
    cone = HeightGrid((-20.0, -20.0), 1.0, np.zeros((41, 41)))
    cone = cone._replace(values=10 - np.hypot(*cone.points.transpose(2, 0, 1)))
    ring = contour_lines(cone, 4.5)
    assert ring.length == pytest.approx(2 * np.pi * 5.5, rel=0.02)
    away = np.hypot(*shapely.get_coordinates(ring).T)
    assert away == pytest.approx(5.5, abs=0.1)
    assert contour_lines(cone._replace(values=np.tile(x, (2, 1))), 9.0).is_empty
    assert "Contours" in [layer.name for layer in draw_plan(hill).layers]
