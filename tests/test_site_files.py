"""Sites as maps: GeoJSON in and out, CityJSON out."""

from __future__ import annotations

import json
from collections import Counter
from itertools import pairwise

import numpy as np
import pytest
import shapely

from scenewright.core.errors import InputError
from scenewright.domains.site.plan import site_plan
from scenewright.domains.site.reading.geojson import report
from scenewright.domains.site.writing import cityjson
from scenewright.domains.site.writing import geojson as footprints_geojson
from scenewright.formats import read
from scenewright.ground.maps.features import collection
from sites import answer, building, quarter, site

LON, LAT = 11.5, 49.5
EAST, NORTH = 72_450.0, 111_223.0  # metres a degree there, to a few metres


def at(*points, close=True):
    """Metres about the corner of the map as longitude and latitude."""
    listed = [[LON + x / EAST, LAT + y / NORTH] for x, y in points]
    return [*listed, listed[0]] if close else listed


def area(points, **tags):
    geometry = {"type": "Polygon", "coordinates": [points]}
    return {"type": "Feature", "properties": tags, "geometry": geometry}


def line(points, **tags):
    geometry = {"type": "LineString", "coordinates": points}
    return {"type": "Feature", "properties": tags, "geometry": geometry}


def dumped(*features, **more):
    return {"type": "FeatureCollection", "features": list(features)} | more


def told(*features, **more):
    return report(collection(dumped(*features, **more)), "map")


SITE = area(
    at((0, 0), (200, 0), (200, 120), (0, 120)), site="yes", name="Mill", setback="4", far="1.5"
)
LANE = line(at((100, -40), (100, 160), close=False), highway="residential", name="Lane")
WALK = line(at((0, 60), (100, 60), close=False), highway="footway")
HALL = {"building": "school", "height": "14 m", "name": "Hall"}


def test_a_map_in_degrees_becomes_a_site_in_metres():
    hall = area(at((20, 20), (50, 20), (50, 40), (20, 40)), **HALL)
    shed = area(
        at((150, 100), (160, 100), (160, 106), (150, 106)),
        building="yes",
        **{"building:levels": "2"},
    )
    pond = area(at((150, 20), (170, 20), (170, 40), (150, 40)), natural="water")
    found = told(SITE, LANE, WALK, hall, shed, pond)
    place = found.brief.part.sites[0]
    plan = site_plan(place)
    assert found.brief.domain == "site"
    assert (place.name, place.setback, place.floor_area_ratio) == ("Mill", 4.0, 1.5)
    assert plan.area == pytest.approx(200 * 120 - 400, rel=1e-3)
    assert place.latitude == pytest.approx(LAT, abs=0.01)
    assert [(road.kind, road.width) for road in place.roads] == [("road", 6.0), ("path", 2.0)]
    assert np.ptp(np.array(place.roads[0].line)[:, 1]) == pytest.approx(140, rel=1e-3)  # cut off
    assert len(plan.entrances) == 3
    assert [(m.name, m.height) for m in place.landmarks] == [("Hall", 14.0), ("", 6.4)]
    assert shapely.Polygon(plan.landmarks[0].footprint).area == pytest.approx(600, rel=1e-3)
    assert len(place.holes) == 1


def test_without_a_mark_the_largest_area_is_the_site():
    small = area(at((300, 0), (310, 0), (310, 9)), landuse="grass")
    plain = area(at((0, 0), (200, 0), (200, 120), (0, 120)), landuse="residential")
    huge = area(at((0, 0), (900, 0), (900, 900), (0, 900)), building="yes")
    found = told(small, plain, huge)
    assert site_plan(found.brief.part.sites[0]).area == pytest.approx(24000, rel=1e-3)
    two = told(SITE, area(at((300, 0), (400, 0), (400, 90)), site="yes"), plain)
    assert [place.name for place in two.brief.part.sites] == ["Mill", "map 2"]


def test_buildings_across_the_border_or_each_other_are_cut():
    across = area(at((190, 10), (206, 10), (206, 20), (190, 20)), building="yes")
    outside = area(at((196, 40), (226, 40), (226, 50), (196, 50)), building="yes")
    first = area(at((50, 50), (70, 50), (70, 70), (50, 70)), building="yes")
    second = area(at((65, 50), (85, 50), (85, 70), (65, 70)), building="yes")
    found = told(SITE, across, outside, first, second)
    plan = site_plan(found.brief.part.sites[0])
    areas = sorted(round(shapely.Polygon(m.footprint).area) for m in plan.landmarks)
    assert areas == [40, 100, 300, 400]
    assert [row.feature for row in found.skipped] == ["feature-2", "feature-3", "feature-5"]


def test_metres_are_known_by_name():
    square = [(691000.0, 5334000), (691200, 5334000), (691200, 5334120), (691000, 5334120)]
    ring = [*map(list, square), list(square[0])]
    named = {"crs": {"properties": {"name": "urn:ogc:def:crs:EPSG::25832"}}}
    found = told(area(ring, site="yes"), **named)
    assert site_plan(found.brief.part.sites[0]).area == pytest.approx(24000)
    assert found.brief.part.sites[0].origin is None


@pytest.mark.parametrize(
    ("document", "words"),
    [
        (dumped(SITE, crs={"properties": {"name": "EPSG:3857"}}), "are degrees, not of 'EPSG:3857"),
        (dumped(area([[1e9 - 1, 0], [1e9 - 1, 9], [2, 9], [1e9 - 1, 0]], site="yes")), '"origin"'),
        (dumped(area([[0.0, 0], [1e-6, 0], [1e-6, 1e-6], [0, 0]], site="yes")), "holds only 0.006"),
        (dumped(area([[0.0, 0], [0.4, 0], [0.4, 0.4], [0, 0]], site="yes")), "45 km long"),
        (dumped(LANE), "holds no outline of a site among its 1 features"),
        (dumped(area(at((0, 0), (9, 0), (9, 9)), building="yes")), "holds no outline"),
        (dumped(area(at((0, 0), (90, 0), (90, 9)), site="yes", setback="20")), "leaves nothing"),
        (dumped(area(at((0, 0), (90, 0), (90, 9)), site="yes", setback="-3")), "setback"),
    ],
)
def test_what_is_no_site_is_told_in_one_line(document, words, tmp_path):
    path = tmp_path / "map.geojson"
    path.write_text(json.dumps(document))
    with pytest.raises(InputError) as caught:
        site_plan(read(path).part.sites[0])
    assert words in str(caught.value)
    assert "\n" not in str(caught.value)


def test_broken_features_are_left_out_and_told():
    odd = {"type": "Feature", "properties": {}, "geometry": {"type": ["Point"], "coordinates": []}}
    dot = line([[LON, LAT]], highway="service")
    bow = area(at((20, 20), (40, 40), (40, 20), (20, 40)), building="yes")
    found = told(SITE, odd, dot, bow, {"type": "Feature"}, LANE)
    assert [row.feature for row in found.skipped] == [
        "feature-2",
        "feature-3",
        "feature-5",
        "feature-4",
    ]
    assert len(found.brief.part.sites[0].roads) == 1


def test_indoor_maps_are_still_read_as_such(tmp_path):
    path = tmp_path / "map.geojson"
    room = area(at((0, 0), (10, 0), (10, 8), (0, 8)), indoor="room", level="0")
    path.write_text(json.dumps(dumped(SITE, room)))
    assert read(path).domain != "site"
    path.write_text(json.dumps(dumped(SITE, LANE)))
    assert read(path).domain == "site"


UTM = {"system": "https://www.opengis.net/def/crs/EPSG/0/25832", "shift": (691_000.0, 5_334_000.0)}


@pytest.mark.parametrize("place", [{"origin": (LON, LAT)}, {"origin": (179.9995, -41.2)}, UTM])
def test_footprints_come_back_as_they_were(tmp_path, place):
    ground, pieces = quarter()
    path = tmp_path / "out.geojson"
    footprints_geojson.write(answer(ground, pieces, **place), path)
    document = json.loads(path.read_text())
    assert ("crs" in document) == ("system" in place)
    rows = {f["id"]: f for f in document["features"]}
    assert rows["tower-1"]["properties"]["height"] == 54
    assert rows["b0"]["properties"]["building:levels"] == 6
    assert rows["b0"]["properties"]["direction"] == 180
    assert rows["rotunda"]["properties"]["landmark"] == "yes"
    back = report(collection(document), "back").brief.part.sites[0]
    before = site_plan(ground)
    after = site_plan(back)
    assert after.area == pytest.approx(before.area, rel=2e-3)
    assert len(back.landmarks) == len(pieces) + 1
    heights = {mark.id: mark.height for mark in back.landmarks}
    assert heights["b3"] == 18
    sizes = {m.id: shapely.Polygon(m.footprint).area for m in after.landmarks}
    assert sizes["b3"] == pytest.approx(28 * 11, rel=2e-3)
    assert back.setback == ground.setback


def solids(document):
    scale = np.array(document["transform"]["scale"])
    points = np.array(document["vertices"]) * scale + document["transform"]["translate"]
    for name, row in document["CityObjects"].items():
        if row["type"] == "Building":
            yield name, row["geometry"][0]["boundaries"][0], points


def test_city_models_are_closed_solids_of_the_right_volume():
    ground, pieces = quarter()
    document = cityjson.document(answer(ground, pieces))
    assert (document["type"], document["version"]) == ("CityJSON", "2.0")
    assert all(isinstance(v, int) for row in document["vertices"] for v in row)
    assert len({tuple(row) for row in document["vertices"]}) == len(document["vertices"])
    volumes = {}
    for name, shell, points in solids(document):
        rings = [ring for surface in shell for ring in surface]
        edges = Counter(
            pair for ring in rings for pair in zip(ring, np.roll(ring, -1), strict=True)
        )
        assert set(edges.values()) == {1}
        assert {(b, a) for a, b in edges} == edges.keys()
        total = 0.0
        for ring in rings:
            corners = points[ring]
            for a, b in pairwise(corners[1:]):
                total += float(np.dot(corners[0], np.cross(a, b))) / 6
        volumes[name] = total
        values = document["CityObjects"][name]["geometry"][0]["semantics"]["values"][0]
        assert len(values) == len(shell)
    assert volumes["b0"] == pytest.approx(30 * 11 * 18)
    round_ = shapely.Polygon(ground.landmarks[0].outline).area
    assert volumes["rotunda"] == pytest.approx(round_ * 18, rel=1e-4)
    extent = np.array(document["metadata"]["geographicalExtent"])
    assert extent[2] == 0
    assert extent[5] == 54
    kinds = Counter(row["type"] for row in document["CityObjects"].values())
    assert kinds == {"LandUse": 1, "Road": 2, "Building": len(pieces) + 1}


def test_ids_used_twice_and_odd_names_are_written(tmp_path):
    pieces = [building("a", 20, 20), building("a", 50, 20), building('"<&\n', 80, 20)]
    path = tmp_path / "out.city.json"
    cityjson.write(answer(site(), pieces), path)
    names = set(json.loads(path.read_text())["CityObjects"])
    assert {"a", "a-2", "s", '"<&\n'} == names
    placed = answer(site(), pieces, origin=(LON, LAT))
    footprints_geojson.write(placed, tmp_path / "out.geojson")
