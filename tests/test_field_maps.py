"""Maps as they come from elsewhere: small remade inputs, and others of their kinds."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely
from benchmarks.damaged_samples import IMDF

import scenewright as sw
from catalogs import city, flat, saved
from scenewright.catalog.models.city_documents import document_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.projection import projection
from scenewright.core.reference_system import system_of
from scenewright.ground.maps.features import collection

CASES = Path(__file__).parent / "data" / "field_cases"
SQUARE = [[0.0, 0.0], [60.0, 0.0], [60.0, 40.0], [0.0, 40.0], [0.0, 0.0]]
LON, LAT = 11.5, 48.1
EAST, NORTH = 74_470.0, 111_200.0


def read(name: str) -> Brief:
    (path,) = CASES.glob(f"{name}_*")
    return sw.read(path)


def site_of(brief: Brief) -> Any:
    (site,) = brief.part.sites
    return site


def box(x: float, y: float, width: float, depth: float) -> list[list[float]]:
    corners = [(x, y), (x + width, y), (x + width, y + depth), (x, y + depth), (x, y)]
    return [[LON + a / EAST, LAT + b / NORTH] for a, b in corners]


def feature(geometry: dict[str, Any], **tags: Any) -> dict[str, Any]:
    return {"type": "Feature", "properties": tags, "geometry": geometry}


def polygon(*rings: list[list[float]]) -> dict[str, Any]:
    return {"type": "Polygon", "coordinates": list(rings)}


SITE = feature(polygon(box(0, 0, 100, 80)), site="yes")


def map_of(tmp_path: Path, *features: dict[str, Any], **more: Any) -> Brief:
    path = tmp_path / "map.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": list(features)} | more))
    return sw.read(path)


def areas(brief: Brief) -> list[int]:
    return [round(shapely.Polygon(row.outline).area) for row in site_of(brief).landmarks]


@pytest.mark.parametrize(
    ("case", "standing", "features"), [("f03", 3, 4), ("f05", 3, 4), ("f15", 3, 3), ("f17", 3, 4)]
)
def test_what_stands_in_a_remade_map_is_a_landmark(case: str, standing: int, features: int) -> None:
    brief = read(case)
    assert len(site_of(brief).landmarks) == standing
    assert brief.input_report is not None
    assert (brief.input_report.features, brief.input_report.complete) == (features, True)


def test_a_template_stands_where_its_matrix_puts_it() -> None:
    site = site_of(read("f05"))
    row = next(row for row in site.landmarks if row.id == "t")
    ring = np.array(row.outline) + site.shift
    assert ring.min(0).tolist() == pytest.approx([85022, 446009])
    assert ring.max(0).tolist() == pytest.approx([85032, 446017])


@pytest.mark.parametrize(("case", "level", "shop"), [("f19", "EG", "Bread"), ("f29", "", "Shoes")])
def test_remade_indoor_maps_are_read(case: str, level: str, shop: str) -> None:
    brief = read(case)
    (only,) = brief.levels
    assert only.name == (level or "Level 0")
    room = next(room for room in brief.rooms if room.name == shop)
    assert room.doors
    assert room.demands
    assert brief.input_report is not None
    assert (brief.input_report.features, brief.input_report.complete) == (3, True)


def test_every_feature_of_imdf_is_kept_or_skipped() -> None:
    """Also an opening whose place is no number that a computer has."""
    rows = json.loads(json.dumps(IMDF))
    rows["features"][3]["geometry"]["coordinates"][0][0] = 10**400
    found = collection(rows)
    assert len(found.features) + len(found.skipped) == len(rows["features"])
    assert [row.feature for row in found.skipped] == ["o"]


def test_imdf_is_an_indoor_map() -> None:
    brief = read("f14")
    assert {room.name for room in brief.rooms} == {"Gift shop", "Corridor", "Toilets"}
    (door,) = next(room for room in brief.rooms if room.name == "Gift shop").doors
    assert door.width == pytest.approx(1.2, abs=0.02)


@pytest.mark.parametrize(
    "named",
    [
        "EPSG:25832",
        "epsg::25832",
        25832,
        "urn:ogc:def:crs:EPSG:9.6:25832",
        "https://www.opengis.net/def/crs/EPSG/0/25832",
        "http://www.opengis.net/gml/srs/epsg.xml#25832",
        "urn:ogc:def:crs,crs:EPSG::25832,crs:EPSG::7837",
        "http://www.opengis.net/def/crs-compound?1=http://www.opengis.net/def/crs/EPSG/0/25832"
        "&2=http://www.opengis.net/def/crs/EPSG/0/7837",
        "ETRS89 / UTM zone 32N",
    ],
)
def test_every_spelling_of_a_system_is_the_same_system(named: object) -> None:
    found = system_of(named)
    assert found is not None
    assert (found.code, found.degrees, found.length) == ("EPSG:25832", False, 1.0)


def test_wkt_and_projjson_are_systems() -> None:
    from pyproj import CRS

    for named in (CRS(2263).to_wkt(), CRS(2263).to_json_dict()):
        found = system_of(named)
        assert found is not None
        assert (found.code, round(found.length, 5)) == ("EPSG:2263", 0.3048)


@pytest.mark.parametrize("named", ["EPSG:1234", "Entenhausen", "EPSG:7837", "EPSG:4978"])
def test_a_system_that_is_no_map_is_refused_in_one_line(named: str) -> None:
    with pytest.raises(InputError, match="its reference system") as error:
        system_of(named)
    assert "\n" not in str(error.value)


def test_feet_mercator_and_swapped_axes_are_metres_of_ground() -> None:
    feet = projection(np.array([[985_000.0, 195_000.0], [985_100.0, 195_100.0]]), "EPSG:2263")
    assert feet.scale == pytest.approx((0.3048006, 0.3048006))
    web = projection(np.array([[1.2e6, 6.1e6], [1.2001e6, 6.1001e6]]), "EPSG:3857")
    assert web.where is not None
    assert web.scale[0] == pytest.approx(math.cos(math.radians(web.where[1])), rel=0.005)
    turned = projection(
        np.array([[5_331_000.0, 691_000.0], [5_331_060.0, 691_080.0]]), "EPSG:25832"
    )
    assert turned.swapped
    assert turned.origin == (691_040.0, 5_331_030.0)


def test_city_models_in_feet_and_in_degrees_are_metres(tmp_path: Path) -> None:
    ring = [(0, 0), (40, 0), (40, 30), (0, 30)]
    town = city({"a": ring})
    town["metadata"]["referenceSystem"] = "https://www.opengis.net/def/crs/EPSG/0/2263"
    town["transform"]["translate"] = [985_000.0, 195_000.0, 0.0]
    (row,) = site_of(sw.read(saved(tmp_path / "feet.city.json", town))).landmarks
    assert shapely.Polygon(row.outline).area == pytest.approx(1200 * 0.3048**2, rel=1e-3)
    degrees = city({"a": [(x / EAST, y / NORTH) for x, y in ring]})
    degrees["vertices"] = [
        [round(1e8 * x / EAST), round(1e8 * y / NORTH), z] for z in (0, 9) for x, y in ring
    ]
    degrees["metadata"]["referenceSystem"] = "EPSG:4979"
    degrees["transform"] = {"scale": [1e-8, 1e-8, 1.0], "translate": [LON, LAT, 0.0]}
    site = site_of(sw.read(saved(tmp_path / "degrees.city.json", degrees)))
    assert shapely.Polygon(site.landmarks[0].outline).area == pytest.approx(1200, rel=2e-3)
    assert site.origin == pytest.approx((LON, LAT), abs=1e-3)


def test_a_school_in_a_collection_or_in_text_tags_stands(tmp_path: Path) -> None:
    point = {"type": "Point", "coordinates": [LON + 30 / EAST, LAT + 30 / NORTH]}
    wings = {"type": "MultiPolygon", "coordinates": [[box(20, 20, 20, 10)], [box(20, 40, 10, 10)]]}
    school = feature(
        {"type": "GeometryCollection", "geometries": [point, wings]}, building="school"
    )
    gdal = feature(
        polygon(box(60, 20, 20, 15)), osm_id="7", other_tags='"building"=>"church","name"=>"St. A"'
    )
    brief = map_of(tmp_path, SITE, school, gdal)
    assert areas(brief) == [200, 100, 300]
    assert [row.use for row in site_of(brief).landmarks] == ["school", "school", "church"]
    assert site_of(brief).landmarks[2].name == "St. A"


def test_parcels_and_tagged_areas_are_no_buildings(tmp_path: Path) -> None:
    parcel = feature(polygon(box(10, 10, 40, 40)), plot=7)
    house = feature(polygon(box(15, 15, 10, 10)), height=7)
    lawn = feature(polygon(box(60, 10, 20, 20)), landuse="grass")
    brief = map_of(tmp_path, SITE, parcel, house, lawn)
    assert areas(brief) == [100]
    assert brief.input_report is not None
    outcomes = {row.examples[0]: row.outcome for row in brief.input_report.rows}
    assert outcomes == {
        "feature-1": "used",
        "feature-2": "left out",
        "feature-3": "changed",
        "feature-4": "left out",
    }
    assert brief.input_report.complete


def test_a_building_without_an_outline_is_said_to_be_lost(tmp_path: Path) -> None:
    at = {"type": "Point", "coordinates": [LON + 50 / EAST, LAT + 40 / NORTH]}
    flat_ring = [box(5, 5, 10, 10)[0], box(5, 5, 10, 10)[1], box(5, 5, 10, 10)[0]]
    brief = map_of(
        tmp_path,
        SITE,
        feature(at, building="school"),
        feature(polygon([*flat_ring, flat_ring[0]]), building="yes"),
    )
    assert brief.input_report is not None
    lost = {row.examples[0]: row.reason for row in brief.input_report.lost}
    assert lost == {
        "feature-2": "is a point: its footprint is not known",
        "feature-3": "has a ring of fewer than three corners",
    }
    assert not brief.input_report.complete


def test_rings_that_are_not_closed_are(tmp_path: Path) -> None:
    brief = map_of(tmp_path, SITE, feature(polygon(box(10, 10, 20, 10)[:-1]), building="yes"))
    assert areas(brief) == [200]


def test_a_sequence_of_one_bad_line_names_it() -> None:
    head = json.dumps({"type": "CityJSON", "version": "2.0", "CityObjects": {}, "vertices": []})
    with pytest.raises(InputError, match="line 2"):
        document_of(f"{head}\n{{broken\n".encode())


def test_objects_of_older_versions_and_extensions_are_read(tmp_path: Path) -> None:
    town = city({"a": [(0, 0), (20, 0), (20, 10), (0, 10)]}, version="0.8")
    town["CityObjects"]["house"] = {"type": "+EnergyBuilding", "geometry": []}
    part = town["CityObjects"].pop("a") | {"type": "BuildingPart", "parent": "house"}
    town["CityObjects"]["part"] = part
    flat(town, "lot", "LandUse", [(-20, -20), (60, -20), (60, 40), (-20, 40)])
    town["CityObjects"]["lot"]["attributes"]["class"] = "site"
    brief = sw.read(saved(tmp_path / "old.city.json", town))
    assert areas(brief) == [200]
    assert brief.input_report is not None
    assert {row.kind: row.outcome for row in brief.input_report.rows} == {
        "+EnergyBuilding": "used",
        "BuildingPart": "used",
        "LandUse": "used",
    }


def test_villages_and_extensions_report_their_map(tmp_path: Path) -> None:
    block = feature(polygon(box(0, 0, 60, 40)), block="yes")
    area = feature(polygon(box(0, 60, 60, 40)), extend="yes")
    house = feature(polygon(box(10, 10, 10, 8)), building="house")
    bare = feature(polygon(box(30, 10, 10, 8)), bin=5)
    tree = feature({"type": "Point", "coordinates": box(50, 30, 1, 1)[0]}, natural="tree")
    village = map_of(tmp_path, block, house, bare, tree)
    assert (village.domain, len(village.part.blocks[0].fixed)) == ("village", 2)
    extension = map_of(tmp_path, area, house, bare, tree)
    assert (extension.domain, len(extension.part.sources[0].buildings)) == ("extend", 2)
    for brief in (village, extension):
        assert brief.input_report is not None
        assert (brief.input_report.features, brief.input_report.complete) == (4, True)
