"""Files of other programs are named, with what makes them readable, whatever they are called."""

from __future__ import annotations

import json
import zipfile
from pathlib import Path
from typing import Any

import pytest

from scenewright import cli, formats
from scenewright.core.errors import InputError
from scenewright.formats.foreign import FOREIGN

SQUARE = [{"x": 0, "y": 0, "z": 0}, {"x": 4, "y": 0, "z": 0}, {"x": 4, "y": 0, "z": 3}]
DOCUMENTS: dict[str, tuple[Any, str]] = {
    "ProcTHOR": (
        {"rooms": [{"roomType": "Kitchen", "floorPolygon": SQUARE}]},
        "name it .procthor.json",
    ),
    "Blueprint3D": ({"floorplan": {"corners": {}, "walls": []}, "items": []}, ".sh3d"),
    "floorspace.js": (
        {"stories": [{"floor_to_ceiling_height": 8, "spaces": [], "geometry": {}}]},
        ".sh3d",
    ),
    "RoomPlan": (
        {
            "walls": [{"dimensions": [4, 2.5, 0], "transform": [1] * 16}],
            "openings": [],
            "objects": [],
        },
        ".sh3d",
    ),
    "react-planner": (
        {"layers": {"a": {"vertices": {"v": {"prototype": "vertices"}}, "areas": {}}}},
        ".sh3d",
    ),
    "GeoJSON": ({"type": "FeatureCollection", "features": []}, "name it .geojson"),
}
CONTENTS = {
    "IFC": (b"ISO-10303-21;\nHEADER;\nFILE_SCHEMA(('IFC4'));", "name it .ifc"),
    "DXF": (b"  0\nSECTION\n  2\nENTITIES\n  0\nENDSEC\n  0\nEOF\n", "name it .dxf"),
    "DWG": (b"AC1032\0\0\0", "save it as .dxf"),
    "SketchUp": (b"\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h\0U\0p\0", ".glb"),
    "USD": (b"#usda 1.0\n", ".glb"),
    "PDF": (b"%PDF-1.7\n", "name it .pdf"),
    "SVG": (b'<svg xmlns="http://www.w3.org/2000/svg"/>', "name it .svg"),
    "picture": (b"\x89PNG\r\n\x1a\n", "Import background image"),
    "OpenStreetMap": (b'<osm version="0.6"><node id="1"/></osm>', "name it .osm"),
    "KML": (b'<kml xmlns="http://www.opengis.net/kml/2.2"/>', "name it .kml"),
    "GeoPackage": (b"SQLite format 3\0 gpkg_contents", "name it .gpkg"),
    "shapefile": (b"\0\0\x27\x0a\0\0", "name it .shp"),
    "CityGML": (b'<CityModel xmlns="http://www.opengis.net/citygml/2.0"/>', "to-cityjson"),
    "gbXML": (b'<gbXML version="6.01"/>', ".sh3d"),
    "glTF": (b"glTF\x02\0\0\0", "--catalog"),
}


def refusal(path: Path) -> str:
    with pytest.raises(InputError) as caught:
        formats.read(path)
    text = str(caught.value)
    assert "\n" not in text
    return text


@pytest.mark.parametrize("name", DOCUMENTS)
def test_a_document_of_another_program_is_named(name: str, tmp_path: Path) -> None:
    document, remedy = DOCUMENTS[name]
    path = tmp_path / "house.json"
    path.write_text(json.dumps(document), encoding="utf-8")
    assert name in refusal(path)
    assert remedy in refusal(path)


@pytest.mark.parametrize("suffix", [".json", ".xml", ".odd", ""])
@pytest.mark.parametrize("name", CONTENTS)
def test_a_file_is_named_by_its_content_whatever_its_suffix(
    name: str, suffix: str, tmp_path: Path
) -> None:
    content, remedy = CONTENTS[name]
    path = tmp_path / f"house{suffix}"
    path.write_bytes(content)
    assert name in refusal(path)
    assert remedy in refusal(path)


def test_a_zipped_shapefile_is_no_home(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "map.sh3d", "w") as archive:
        archive.writestr("roads.shp", b"\0\0\x27\x0a")
    assert "a zipped shapefile; name it .zip" in refusal(tmp_path / "map.sh3d")


def test_a_home_called_zip_is_told_its_name(tmp_path: Path) -> None:
    with zipfile.ZipFile(tmp_path / "home.zip", "w") as archive:
        archive.writestr("Home.xml", "<home/>")
    assert "is a home of Sweet Home 3D; name it .sh3d" in refusal(tmp_path / "home.zip")


def test_a_brief_with_a_fault_stays_a_brief_with_a_fault(tmp_path: Path) -> None:
    room = {"outline": [[0, 0], [4, 0], [4, 3]], "name": "roomType floorPolygon", "lamps": 1}
    path = tmp_path / "flat.json"
    path.write_text(json.dumps({"rooms": [room]}))
    assert "rooms[0].lamps: is not a known key" in refusal(path)


def test_no_row_takes_a_file_that_is_read(tmp_path: Path) -> None:
    read = {row.suffix for row in formats.formats() if row.reader}
    assert not [row.what for row in FOREIGN if read & {*row.suffixes}]
    assert not [row.what for row in FOREIGN if not row.remedy]


def test_the_command_line_says_it_in_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / "my house.fgb"
    path.write_bytes(b"fgb\3fgb\0")
    assert cli.run(["arrange", str(path)]) == 2
    shown = capsys.readouterr()
    assert shown.out == ""
    assert shown.err.startswith(f"scenewright: {path}: is a FlatGeobuf map, which is not read; ")
    assert "ogr2ogr -t_srs EPSG:4326 map.geojson 'my house.fgb'" in shown.err


@pytest.mark.realdata(quick=True)
def test_real_files_of_other_programs_are_named(real_data: Path) -> None:
    folder = real_data / "professional_files"
    files = [*folder.glob("json/*")]
    assert len(files) >= 6
    said = [refusal(file) for file in files]
    assert all("which is not read; " in text for text in said)
