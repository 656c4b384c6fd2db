"""Maps of GIS programs and of OpenStreetMap: every feature has a fate, whatever the format."""

from __future__ import annotations

import bz2
import gzip
import json
import sqlite3
import zipfile
from collections import Counter
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
import shapely

from map_files import (
    FEATURES,
    HOUSES,
    OSM_FEATURES,
    SITE,
    osm_xml,
    write_layers,
    write_pbf,
    zip_shapefiles,
)
from scenewright import cli, formats
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.map_options import MapOptions
from scenewright.formats.geojson import brief_of_map
from scenewright.ground.geodata.reading import load_map
from scenewright.ground.maps.place import place_map

pytest.importorskip("pyogrio", reason="extra gis")
pytest.importorskip("osmium", reason="extra gis")
HOUSE = shapely.Polygon(HOUSES[0]).area


def outcomes(brief: Brief) -> Counter[str]:
    report = brief.input_report
    assert report is not None
    counted: Counter[str] = Counter()
    for row in report.rows:
        counted[f"{row.kind}: {row.outcome}"] += row.count
    return counted


def site_of(brief: Brief) -> shapely.Polygon:
    (site,) = brief.part.sites
    return shapely.Polygon(site.outline, site.holes)


def check_quarter(brief: Brief) -> None:
    """The site is as large as drawn, and the three houses stand on it."""
    assert site_of(brief).area == pytest.approx(120 * 90, rel=2e-3)
    (site,) = brief.part.sites
    areas = sorted(shapely.Polygon(row.outline).area for row in site.landmarks)
    drawn = sorted(shapely.Polygon(ring).area for ring in HOUSES)
    assert areas == pytest.approx(drawn, rel=5e-3)
    assert len(site.roads) >= 1


def refusal(path: Path, options: MapOptions | None = None) -> str:
    with pytest.raises(InputError) as caught:
        formats.read(path, map_options=options or MapOptions())
    text = str(caught.value)
    assert "\n" not in text
    assert "; " in text
    assert text.startswith(str(path))
    return text


def test_layers_say_what_their_features_are(tmp_path: Path) -> None:
    path = write_layers(tmp_path / "quarter.gpkg")
    brief = formats.read(path)
    check_quarter(brief)
    report = brief.input_report
    assert report is not None
    assert (report.format, report.features) == ("GeoPackage", FEATURES)
    assert report.system.startswith("EPSG:25832")
    assert outcomes(brief) == {
        "site (layer Baufeld): used": 1,
        "building (layer Gebäude): used": 3,
        "road (layer Straßen): used": 1,
        "plot (layer Flurstücke): left out": 2,
        "terrain (layer Höhenlinien): left out": 1,
    }
    heights = sorted(row.height or 0 for row in brief.part.sites[0].landmarks)
    assert heights[1:] == [6.0, 9.5]


def test_a_zip_of_shapefiles_is_the_same_map(tmp_path: Path) -> None:
    brief = formats.read(zip_shapefiles(tmp_path / "quarter.zip", tmp_path))
    check_quarter(brief)
    assert brief.input_report is not None
    assert brief.input_report.features == FEATURES
    assert brief.input_report.format == "shapefile"


def test_kml_is_the_same_map(tmp_path: Path) -> None:
    path = write_layers(tmp_path / "quarter.kml", only=("Baufeld", "Gebäude", "Straßen"))
    brief = formats.read(path)
    check_quarter(brief)
    assert brief.input_report is not None
    assert brief.input_report.features == 5


def test_openstreetmap_is_accounted_for(tmp_path: Path) -> None:
    plain = tmp_path / "quarter.osm"
    plain.write_text(osm_xml(), encoding="utf-8")
    packed = tmp_path / "quarter.osm.gz"
    packed.write_bytes(gzip.compress(plain.read_bytes()))
    binary = write_pbf(plain, tmp_path / "quarter.osm.pbf")
    seen = []
    for path in (plain, packed, binary):
        brief = formats.read(path)
        check_quarter(brief)
        assert brief.name == "quarter"
        report = brief.input_report
        assert report is not None
        assert report.features == OSM_FEATURES
        assert report.complete, "what an extract cuts off is no loss"
        seen.append(outcomes(brief))
    assert seen[0] == seen[1] == seen[2]
    cut = [row for row in report.rows if "cut off" in row.reason]
    assert [(row.kind, row.count) for row in cut] == [("building", 1)]


def test_a_shapefile_needs_nothing_beside_it(tmp_path: Path) -> None:
    path = write_layers(tmp_path / "Gebaeude.shp", only=("Gebäude",))
    for suffix in (".shx", ".dbf", ".prj", ".cpg"):
        path.with_suffix(suffix).unlink(missing_ok=True)
    before = sorted(tmp_path.iterdir())
    options = MapOptions(crs="EPSG:25832", site="Gebaeude/1")
    brief = formats.read(path, map_options=options)
    assert site_of(brief).area == pytest.approx(shapely.Polygon(HOUSES[1]).area, rel=1e-3)
    assert brief.part.sites[0].system == "EPSG:25832"
    assert sorted(tmp_path.iterdir()) == before


def test_crs_origin_and_site(tmp_path: Path) -> None:
    found = load_map(write_layers(tmp_path / "quarter.gpkg"))

    def read(**options: Any) -> Brief:
        return brief_of_map(place_map(found, MapOptions(**options)), "quarter")

    low = np.array(read(origin=SITE[0]).part.sites[0].outline).min(axis=0)
    assert np.abs(low).max() < 0.01
    assert read(origin=(11.0689, 49.4541)).part.sites[0].shift == pytest.approx(
        (649_956, 5_480_033), abs=60
    )
    plot = read(site=f"{SITE[0][0] + 100},{SITE[0][1] + 40}")
    assert site_of(plot).area == pytest.approx(60 * 90, rel=2e-3)
    assert read(crs="EPSG:25833").part.sites[0].system == "EPSG:25833"
    for options, fault in (
        ({"origin": (3.0, 3.0)}, "--origin 3,3 is "),
        ({"site": "x"}, "holds no area 'x'"),
        ({"crs": "EPSG:99"}, "is not known"),
    ):
        with pytest.raises(InputError, match=fault):
            read(**options)


def test_layers_are_chosen_by_name(tmp_path: Path) -> None:
    path = write_layers(tmp_path / "quarter.gpkg")
    only = formats.read(path, map_options=MapOptions(layers=("Baufeld", "Gebäude")))
    assert only.input_report is not None
    assert only.input_report.features == 4
    assert "holds no layer 'roads'; give --layer one of: Baufeld" in refusal(
        path, MapOptions(layers=("roads",))
    )


def test_between_streets_is_a_site(tmp_path: Path) -> None:
    ring = [[11.07, 49.45], [11.072, 49.45], [11.072, 49.451], [11.07, 49.451], [11.07, 49.45]]
    street = {"type": "LineString", "coordinates": ring}
    feature = {"type": "Feature", "properties": {"highway": "residential"}, "geometry": street}
    path = tmp_path / "streets.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))
    brief = formats.read(path, map_options=MapOptions(site="11.071,49.4505"))
    width, depth = 0.002 * 72_506 - 8, 0.001 * 111_218 - 8
    assert site_of(brief).area == pytest.approx(width * depth, rel=0.01)
    assert brief.input_report is not None
    assert brief.input_report.features == 1
    outside = MapOptions(site="11.08,49.4505")
    assert "nothing encloses the place 11.08,49.4505" in refusal(path, outside)


def test_the_likeliest_ground_is_the_site(tmp_path: Path) -> None:
    """A plot before settled ground before a wood, however large; the report names the others."""

    def square(name: str, side: float, **tags: str) -> dict[str, Any]:
        ring = [[0, 0], [side, 0], [side, side], [0, side], [0, 0]]
        geometry = {"type": "Polygon", "coordinates": [[[x + 11, y + 49] for x, y in ring]]}
        return {"type": "Feature", "id": name, "properties": tags, "geometry": geometry}

    rows = [
        square("wood", 0.004, landuse="forest"),
        square("town", 0.006, boundary="administrative"),
        square("homes", 0.002, landuse="residential"),
        square("plot", 0.001, place="plot"),
    ]
    path = tmp_path / "grounds.geojson"

    def site_and_report(kept: list[dict[str, Any]]) -> tuple[str, list[str]]:
        path.write_text(json.dumps({"type": "FeatureCollection", "features": kept}))
        brief = formats.read(path)
        assert brief.input_report is not None
        reasons = [row.reason for row in brief.input_report.rows]
        return brief.part.sites[0].id, [one for one in reasons if "--site" in one]

    site, (told,) = site_and_report(rows)
    assert site == "plot"
    assert told.endswith("--site takes another: homes, wood, town")
    assert "such as plot, homes, wood, town" in refusal(path, MapOptions(site="nowhere"))
    assert site_and_report(rows[:3])[0] == "homes"
    assert site_and_report(rows[:2])[0] == "wood"
    assert site_and_report(rows[:1]) == ("wood", [])


def test_a_map_without_areas_names_places(tmp_path: Path) -> None:
    ring = [[11.07, 49.45], [11.072, 49.45], [11.072, 49.451], [11.07, 49.451], [11.07, 49.45]]
    street = (
        {"type": "LineString", "coordinates": ring[:3]},
        {"type": "LineString", "coordinates": ring[2:]},
    )
    rows = [{"type": "Feature", "properties": {"highway": "road"}, "geometry": g} for g in street]
    path = tmp_path / "streets.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": rows}))
    place = refusal(path).partition("such as ")[2]
    assert site_of(formats.read(path, map_options=MapOptions(site=place))).area > 5_000


def test_kmz_and_bzip2_are_unpacked(tmp_path: Path) -> None:
    kml = write_layers(tmp_path / "doc.kml", only=("Baufeld", "Gebäude", "Straßen"))
    with zipfile.ZipFile(tmp_path / "quarter.kmz", "w") as archive:
        archive.write(kml, "doc.kml")
    check_quarter(formats.read(tmp_path / "quarter.kmz"))
    packed = tmp_path / "quarter.osm.bz2"
    packed.write_bytes(bz2.compress(osm_xml().encode()))
    check_quarter(formats.read(packed))


def test_options_of_maps_are_refused_elsewhere(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="is no map: --crs cannot be used"):
        formats.read("sample:home-room", map_options=MapOptions(crs="EPSG:25832"))
    assert cli.run(["plan", "sample:home-room", "--origin", "here"]) == 2


@pytest.mark.filterwarnings("ignore:'crs' was not provided")
def test_without_a_system_metres_are_metres(tmp_path: Path) -> None:
    brief = formats.read(write_layers(tmp_path / "quarter.gpkg", crs=None))
    check_quarter(brief)
    assert brief.input_report is not None
    assert brief.input_report.system == "none stated: local metres"


HOSTILE = {
    "empty.osm": b"",
    "empty.shp": b"",
    "entities.osm": b'<!DOCTYPE osm [<!ENTITY a "aaaa">]><osm><node id="1"/></osm>',
    "entities.kml": b'<!DOCTYPE kml SYSTEM "file:///etc/passwd"><kml xmlns="x"/>',
    "other.kml": b"<!-- <kml> --><OGRVRTDataSource><OGRVRTLayer/></OGRVRTDataSource>",
    "broken.osm": b'<osm version="0.6"><node id="1" lat="49" lon="11"><tag k="a" v="b"/>',
    "coding.kml": b"<?xml version='1.0' encoding='UnanF-8'?><kml><Document/></kml>",
    "coding.osm": b"<?xml version='1.0' encoding='idna'?><osm version='0.6'></osm>",
    "nothing.osm": b'<osm version="0.6"></osm>',
    "text.gpkg": b"this is no database",
    "short.gpkg": b"SQLite format 3\0" + b"\0" * 400,
    "short.shp": b"\0\0\x27\x0a" + b"\0" * 20,
    "text.osm.gz": b"not gzip at all",
    "text.osm.pbf": b"\0\0\0\x0dnothing of the kind",
    "header.osm.pbf": b"\0\0\0\x0d\x0a\x09OSMHeader\x18\xff\xff\xff\x7f",
    "text.zip": b"PK\3\4 and no more",
}


@pytest.mark.parametrize("name", HOSTILE)
def test_a_hostile_file_is_one_line(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / name
    path.write_bytes(HOSTILE[name])
    assert cli.run(["plan", str(path), "-o", str(tmp_path / "out.json")]) == 2
    shown = capsys.readouterr()
    assert shown.err.count("\n") == 1
    assert shown.err.startswith(f"scenewright: {path}: ")
    assert "; " in shown.err
    assert [file.name for file in tmp_path.iterdir()] == [name]


def test_archives_that_swell_lead_out_or_are_locked(tmp_path: Path) -> None:
    swelling = tmp_path / "swelling.zip"
    with zipfile.ZipFile(swelling, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("a.shp", b"\0\0\x27\x0a")
    content = bytearray(swelling.read_bytes())
    place = content.index(b"PK\1\2") + 24
    content[place : place + 4] = (300_000_000).to_bytes(4, "little")
    swelling.write_bytes(content)
    assert "is larger than 256 MiB unpacked" in refusal(swelling)
    leading = tmp_path / "leading.zip"
    with zipfile.ZipFile(leading, "w") as archive:
        archive.writestr("../../etc/a.kml", "<kml><Document/></kml>")
    assert "holds no" in refusal(leading)
    assert [file.name for file in tmp_path.parent.glob("etc")] == []
    locked = tmp_path / "locked.zip"
    with zipfile.ZipFile(locked, "w") as archive:
        archive.writestr("a.kml", "<kml><Document/></kml>")
    content = bytearray(locked.read_bytes())
    content[6] |= 1
    content[content.index(b"PK\1\2") + 8] |= 1
    locked.write_bytes(content)
    assert "a.kml is encrypted" in refusal(locked)


def test_a_missing_package_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from scenewright.ground.geodata import reading

    path = tmp_path / "a.osm"
    path.write_text(osm_xml(), encoding="utf-8")
    monkeypatch.setattr(reading, "find_spec", lambda _name: None)
    assert "needs the package 'osmium'; pip install 'scenewright[gis]'" in refusal(path)


def raw_count(path: Path) -> int:
    """Features of a map, counted without our readers: rows of feature tables, records of
    shapefiles by their index, objects of OpenStreetMap with tags."""
    if path.suffix == ".gpkg":
        with sqlite3.connect(f"file:{path}?immutable=1", uri=True) as database:
            listed = "SELECT table_name FROM gpkg_contents WHERE data_type = 'features'"
            names = [name for (name,) in database.execute(listed)]
            return sum(database.execute(f'SELECT COUNT(*) FROM "{n}"').fetchone()[0] for n in names)
    if path.suffix == ".zip":
        with zipfile.ZipFile(path) as archive:
            sizes = [e.file_size for e in archive.infolist() if e.filename.lower().endswith(".shx")]
        return sum((size - 100) // 8 for size in sizes)
    data = path.read_bytes()
    root = ElementTree.fromstring(gzip.decompress(data) if path.suffix == ".gz" else data)
    if path.suffix == ".kml":
        return sum(1 for _ in root.iter("{http://www.opengis.net/kml/2.2}Placemark"))
    objects = [one for one in root if one.tag in ("node", "way", "relation")]
    return sum(one.find("tag") is not None for one in objects)


@pytest.mark.realdata
@pytest.mark.parametrize("kind", ["gis", "osm"])
def test_every_feature_of_real_maps_has_a_fate(real_data: Path, kind: str) -> None:
    """Read by the parts of the reader, so that no site is needed."""
    files = sorted((real_data / "professional_files" / kind).glob("*"))
    assert len(files) == 6
    for path in files:
        found = load_map(path)
        assert len(found.features) + len(found.skipped) == raw_count(path), path.name
        names = [f.id for f in found.features] + [row.feature for row in found.skipped]
        assert len(set(names)) == len(names), path.name


@pytest.mark.realdata
@pytest.mark.parametrize("name", ["luneray_shp.zip", "bubenec.gpkg"])
def test_every_feature_of_real_maps_as_kml_has_a_fate(
    real_data: Path, tmp_path: Path, name: str
) -> None:
    """Rewritten by GDAL, counted by placemarks."""
    source, path = real_data / "professional_files" / "gis" / name, tmp_path / "map.kml"
    rewrite_as_kml(source, path)
    found = load_map(path)
    assert len(found.features) + len(found.skipped) == raw_count(path) > 0


def rewrite_as_kml(source: Path, path: Path) -> None:
    """Each layer of a map in longitude and latitude, shapes only."""
    import pyogrio
    from pyproj import Transformer

    for layer, kind in pyogrio.list_layers(source):
        info, _, shapes, _ = pyogrio.raw.read(source, layer=layer, columns=[], force_2d=True)
        turn = Transformer.from_crs(info["crs"], "EPSG:4326", always_xy=True).transform
        moved = shapely.transform(shapely.from_wkb(shapes), turn, interleaved=False)
        wkb, more = shapely.to_wkb(moved), path.exists()
        pyogrio.raw.write(
            path,
            wkb,
            [],
            [],
            layer=layer,
            driver="LIBKML",
            geometry_type=kind,
            crs="EPSG:4326",
            append=more,
            promote_to_multi=True,
        )
