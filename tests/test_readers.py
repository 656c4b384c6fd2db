"""One contract for every reader: its brief carries a report that accounts for the file."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import map_files
from flat import flat_solution
from hostile_documents import CITY, LAND, MAP
from scenewright import formats
from scenewright.core.brief import Brief
from scenewright.core.brief.own_report import input_report_of
from scenewright.core.registry import domain_names, domain_of
from scenewright.formats import solution_json

HOME = """<?xml version="1.0"?><home name="Flat" wallHeight="250">
<wall id="w0" xStart="0" yStart="0" xEnd="500" yEnd="0" thickness="10"/>
<wall id="w1" xStart="500" yStart="0" xEnd="500" yEnd="400" thickness="10"/>
<wall id="w2" xStart="500" yStart="400" xEnd="0" yEnd="400" thickness="10"/>
<wall id="w3" xStart="0" yStart="400" xEnd="0" yEnd="0" thickness="10"/>
<room name="Bedroom"><point x="5" y="5"/><point x="495" y="5"/><point x="495" y="395"/>
<point x="5" y="395"/></room></home>"""
RING = [[11.5, 49.5], [11.501, 49.5], [11.501, 49.5005], [11.5, 49.5005], [11.5, 49.5]]
SAVED = Path(__file__).parent / "data" / "saved"


def draw_map(*drawn: tuple[dict[str, str], float]) -> dict[str, Any]:
    """A map of rectangles with tags, each some degrees east of the last."""
    features = [
        {
            "type": "Feature",
            "properties": tags,
            "geometry": {"type": "Polygon", "coordinates": [[[x + east, y] for x, y in RING]]},
        }
        for tags, east in drawn
    ]
    return {"type": "FeatureCollection", "features": features}


EXTENSION = draw_map(
    ({"building": "yes"}, 0.0), ({"building": "yes"}, 0.0015), ({"extend": "yes"}, 0.003)
)


def write_json(document: Any) -> Callable[[Path], None]:
    return lambda path: path.write_text(json.dumps(document), encoding="utf-8") and None


def write_archive(path: Path) -> None:
    import zipfile

    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("Home.xml", HOME)


def write_map(path: Path) -> None:
    pytest.importorskip("pyogrio", reason="extra gis")
    map_files.write_layers(path, only=("Baufeld",) if path.suffix == ".shp" else (), site="yes")


def write_osm(path: Path) -> None:
    pytest.importorskip("osmium", reason="extra gis")
    plain = path.with_name("plain.osm")
    plain.write_text(map_files.osm_xml(), encoding="utf-8")
    if path.suffix == ".gz":
        path.write_bytes(gzip.compress(plain.read_bytes()))
    elif path.suffix == ".pbf":
        map_files.write_pbf(plain, path)
    else:
        plain.rename(path)


def write_saved(path: Path) -> None:
    path.write_bytes(gzip.decompress((SAVED / "home-room.json.gz").read_bytes()))


def write_house(path: Path) -> None:
    """The flat as a house of ProcTHOR."""
    formats.write(flat_solution(), path)


def write_sequence(path: Path) -> None:
    """The city model as a head and one feature a line."""
    head = CITY | {"CityObjects": {}, "vertices": []}
    feature = {"type": "CityJSONFeature", "id": "b"}
    feature |= {key: CITY[key] for key in ("CityObjects", "vertices")}
    path.write_text(f"{json.dumps(head)}\n{json.dumps(feature)}\n", encoding="utf-8")


def write_by(package: str) -> Callable[[Path], None]:
    """Written by ourselves, where the package it needs is there."""

    def write(path: Path) -> None:
        pytest.importorskip(package)
        write_saved(path.with_suffix(".json"))
        formats.write(solution_json.read(path.with_suffix(".json")), path)

    return write


READERS: dict[str, tuple[str, Callable[[Path], None], str]] = {
    "brief": (".json", write_json({"rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}]}), "home"),
    "saved scene": (".json", write_saved, "home"),
    "sh3d": (".sh3d", write_archive, "home"),
    "xml": (".xml", lambda path: path.write_text(HOME) and None, "home"),
    "indoor map": (".geojson", write_json(MAP), "hall"),
    "site map": (".geojson", write_json(LAND), "site"),
    "village map": (".geojson", write_json(draw_map(({"block": "yes"}, 0.0))), "village"),
    "extension map": (".geojson", write_json(EXTENSION), "extend"),
    "dxf": (".dxf", write_by("ezdxf"), "home"),
    "ifc": (".ifc", write_by("ifcopenshell"), "home"),
    "pdf": (".pdf", write_by("pypdfium2"), "home"),
    "procthor": (".procthor.json", write_house, "home"),
    "svg": (".svg", write_by("svgelements"), "home"),
    "geopackage": (".gpkg", write_map, "site"),
    "shapefile": (".shp", write_map, "site"),
    "kml": (".kml", write_map, "site"),
    "openstreetmap": (".osm", write_osm, "site"),
    "openstreetmap packed": (".osm.gz", write_osm, "site"),
    "openstreetmap in blocks": (".pbf", write_osm, "site"),
    "city": (".city.json", write_json(CITY), "site"),
    "cities in lines": (".city.jsonl", write_sequence, "site"),
}
"""A small file for each reader, and the domain that reads it."""
PAGES = ("pdf", "svg")
"""Of pages ``scale`` is the one they are drawn to."""


def read(name: str, folder: Path, **options: Any) -> Brief:
    suffix, write, _ = READERS[name]
    path = folder / f"file{suffix}"
    write(path)
    return formats.read(path, **options)


@pytest.mark.parametrize("name", READERS)
def test_the_brief_of_a_reader_accounts_for_its_file(name: str, tmp_path: Path) -> None:
    brief = read(name, tmp_path)
    assert brief.domain == READERS[name][2]
    report = input_report_of(brief)
    assert report.features > 0
    assert report.format
    assert report.unit
    assert report.complete


@pytest.mark.parametrize("name", READERS)
def test_the_report_is_carried_through_scale_and_saving(name: str, tmp_path: Path) -> None:
    brief = read(name, tmp_path)
    kept = Brief.model_validate_json(brief.model_dump_json())
    assert input_report_of(kept) == input_report_of(brief)
    if domain_of(brief.domain).rooms and name not in PAGES:
        scaled = read(name, tmp_path, scale=1.25)
        assert "1.25" in input_report_of(scaled).model_dump_json()
        assert input_report_of(scaled).features == input_report_of(brief).features


def test_every_reader_has_a_sample() -> None:
    suffixes = {row.suffix for row in formats.formats() if row.reader}
    tried = {suffix for suffix, _, _ in READERS.values()}
    others = {".cityjson", ".jsonl", ".osm.bz2", ".zip", ".kmz", ".ifczip"}
    assert suffixes - tried <= others, "those have the readers of others, some unpacked first"
    maps = {name for name in domain_names() if domain_of(name).maps}
    assert maps <= {domain for suffix, _, domain in READERS.values() if suffix == ".geojson"}


def test_a_brief_of_which_nothing_was_changed_is_stored_as_before(tmp_path: Path) -> None:
    brief = read("brief", tmp_path)
    assert brief.input_report is None
    assert "input_report" not in brief.model_dump_json()


def test_keys_of_other_kinds_of_scene_that_are_dropped_are_told(tmp_path: Path) -> None:
    path = tmp_path / "old.json"
    path.write_text('{"sites": [], "rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}]}')
    report = formats.read(path).input_report
    assert report is not None
    (row,) = [row for row in report.rows if row.outcome == "left out"]
    assert (row.kind, row.count, row.reason) == ("sites", 1, "empty, and not of a home")


def test_the_pieces_of_a_saved_scene_stay_or_are_laid_out_anew(tmp_path: Path) -> None:
    write_saved(tmp_path / "room.json")
    document = json.loads((tmp_path / "room.json").read_text())
    document["pieces"][0]["fixed"] = True
    (tmp_path / "room.json").write_text(json.dumps(document))
    for _ in range(2):
        report = formats.read(tmp_path / "room.json").input_report
        assert report is not None
        counts = {row.reason: row.count for row in report.rows if row.kind == "piece"}
        assert counts == {
            "locked, stays where it is": 1,
            "not locked, laid out anew": len(document["pieces"]) - 1,
        }
        document["brief"]["input_report"] = report.model_dump(mode="json")
        (tmp_path / "room.json").write_text(json.dumps(document))
