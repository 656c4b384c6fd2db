"""Every feature of real maps has a fate: counted in the raw files, not by the readers."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

from scenewright.core.errors import InputError
from scenewright.domains.site.reading.cityjson import read_report
from scenewright.formats import domains
from scenewright.formats.geojson import read as read_map
from scenewright.ground.maps.features import collection

CITIES = (
    "citymodels_cityjson/rotterdam_subset.json",
    "citymodels_cityjson/delft.json",
    "citymodels_cityjson/zurich_subset_lod2.json",
    "professional_files/cityjson/3dbag_2.city.jsonl",
    "professional_files/cityjson/montreal_energy_ext.city.json",
    "field_cases/f05_building_as_geometry_instance.city.json",
    "field_cases/f15_cityjsonseq.city.jsonl",
)
BUILDINGS = ("Building", "BuildingPart", "+EnergyBuilding")


def raw_objects(path: Path) -> Counter[str]:
    """Objects of a city model by type, line by line where it is a sequence."""
    text = path.read_text()
    rows = text.splitlines() if path.suffix == ".jsonl" else [text]
    return Counter(
        one["type"] for row in rows if row for one in json.loads(row)["CityObjects"].values()
    )


@pytest.mark.realdata(quick=True)
@pytest.mark.parametrize("name", CITIES)
def test_every_object_of_a_city_model_has_a_fate(real_data: Path, name: str) -> None:
    path = real_data / name
    if not path.exists():
        pytest.skip(f"no {name}")
    raw = raw_objects(path)
    report = read_report(path).brief.input_report
    assert report is not None
    counted: Counter[str] = Counter()
    for row in report.rows:
        counted[row.kind] += row.count
    assert counted == raw
    built = [row for row in report.rows if row.kind in BUILDINGS]
    assert all(row.outcome == "used" or row.reason for row in built)
    assert sum(row.count for row in built if row.outcome != "left out") >= 2


@pytest.mark.realdata(quick=True)
def test_a_city_model_of_an_unknown_system_is_refused_by_name(real_data: Path) -> None:
    path = real_data / "professional_files/cityjson/munich_v01_compressed.city.json"
    if not path.exists():
        pytest.skip(f"no {path.name}")
    with pytest.raises(InputError, match="'EPSG:1234' is not known"):
        read_report(path)


def geojson_files(folder: Path) -> list[Path]:
    found = [*folder.glob("indoor_osm/*.geojson"), *folder.glob("field_cases/*.geojson")]
    return sorted(found)


@pytest.mark.realdata
def test_every_feature_of_a_map_has_a_fate(real_data: Path) -> None:
    read = 0
    for path in geojson_files(real_data):
        raw = len(json.loads(path.read_text())["features"])
        report = read_map(path).input_report
        assert report is not None, path.name
        assert report.features == raw, path.name
        read += 1
    assert read or not geojson_files(real_data)


def block_map(block: dict[str, Any]) -> dict[str, Any]:
    """A real block in metres about a place of UTM zone 32, as a map."""
    ring = [[691_000 + x, 5_331_000 + y] for x, y in block["outline"]]
    features = [_feature([*ring, ring[0]], "block")]
    for house in block["houses"]:
        ring = [[691_000 + x, 5_331_000 + y] for x, y in house["polygon"]]
        features.append(_feature([*ring, ring[0]], "building"))
    system = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::25832"}}
    return {"type": "FeatureCollection", "features": features, "crs": system}


def _feature(ring: list[list[float]], key: str) -> dict[str, Any]:
    geometry = {"type": "Polygon", "coordinates": [ring]}
    return {"type": "Feature", "properties": {key: "yes"}, "geometry": geometry}


@pytest.mark.realdata
@pytest.mark.parametrize("kind", ["village", "site", "extend"])
def test_every_house_of_real_blocks_has_a_fate(real_data: Path, kind: str) -> None:
    path = real_data / "village_blocks_osm" / "blocks.json"
    if not path.exists():
        pytest.skip("no blocks")
    key = {"village": "block", "site": "site", "extend": "extend"}[kind]
    (reader,) = [d for d in domains() if d.name == kind]
    from importlib import import_module

    module = import_module(reader.maps, reader.package)
    for block in json.loads(path.read_text())[::90][:12]:
        document = block_map(block)
        document["features"][0]["properties"] = {key: "yes"}
        report = module.brief_of(collection(document), "block").input_report
        assert report.features == len(block["houses"]) + 1
        assert report.system.startswith("EPSG:25832")
        lost = [row for row in report.rows if row.kind == "building" and row.outcome == "left out"]
        assert all(row.reason for row in lost)
