"""Maps used: written as GeoPackage and read again, compared, folded, learned from, in batches."""

from __future__ import annotations

import json
import sqlite3
import zipfile
from pathlib import Path

import numpy as np
import pytest
import shapely

import scenewright as sw
from map_files import HOUSES, SITE, write_layers, write_rows
from scenewright import cli, formats
from scenewright.core.brief import Brief

pytest.importorskip("pyogrio", reason="extra gis")


def site_of(brief: Brief) -> shapely.Polygon:
    (site,) = brief.part.sites
    return shapely.Polygon(site.outline, site.holes)


def test_geopackage_out_reads_again_with_its_system(tmp_path: Path) -> None:
    """What was laid out in a map comes back at its place: as many buildings, the same ground."""
    given = write_layers(tmp_path / "quarter.gpkg")
    out, again = tmp_path / "out.gpkg", tmp_path / "again.gpkg"
    words = ["arrange", str(given), "--steps", "5", "-q", "-o"]
    assert cli.run([*words, str(out), "-o", str(tmp_path / "out.json")]) in (0, 1)
    assert cli.run([*words, str(again)]) in (0, 1)
    assert out.read_bytes() == again.read_bytes()
    assert cli.run([*words, str(again)]) in (0, 1), "an output of ours may be replaced"
    with sqlite3.connect(out) as database:
        systems = set(database.execute("SELECT srs_id FROM gpkg_geometry_columns").fetchall())
        counted = database.execute("SELECT COUNT(*) FROM buildings").fetchone()[0]
    assert systems == {(25832,)}
    brief = formats.read(out)
    assert site_of(brief).area == pytest.approx(120 * 90, rel=2e-3)
    saved = json.loads((tmp_path / "out.json").read_text())
    built = sum(piece["category"] == "building" for piece in saved["pieces"])
    assert counted == len(brief.part.sites[0].landmarks) == built >= len(HOUSES)
    away = np.subtract(brief.part.sites[0].shift, SITE[0])
    assert (away >= -1).all()
    assert (away <= (121, 91)).all()


def test_geopackage_out_is_for_maps(tmp_path: Path) -> None:
    out = tmp_path / "room.gpkg"
    assert cli.run(["arrange", "sample:home-room", "--steps", "5", "-q", "-o", str(out)]) == 2
    assert not out.exists()
    somebodys = tmp_path / "theirs.gpkg"
    write_layers(somebodys)
    before = somebodys.read_bytes()
    words = ["arrange", "sample:site-square", "--steps", "1", "-q", "-o", str(somebodys)]
    assert cli.run(words) == 2
    assert somebodys.read_bytes() == before


def test_places_are_compared_and_folded_from_any_map(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    rows = write_rows(tmp_path / "rows.gpkg")
    same = write_rows(tmp_path / "rows.kml")
    assert cli.run(["compare", str(rows), str(same), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["buildings"] == [10, 10]
    assert found["copied"] > 0.99
    assert cli.run(["fold", str(rows), "--json"]) == 0
    assert [row["elements"] for row in json.loads(capsys.readouterr().out)] == [5, 5]
    assert cli.run(["compare", str(rows)]) == 2
    assert "is no saved extension; give two scenes" in capsys.readouterr().err


def test_a_style_is_learned_from_blocks_only(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("torch", reason="extra learn")
    path = write_layers(tmp_path / "quarter.gpkg")
    assert cli.run(["learn", "village", str(path), "-o", str(tmp_path / "style.npz")]) == 2
    assert "quarter.gpkg: is no village with blocks; tag the" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("name", "ground"), [("village-hamlet", "blocks"), ("extend-terrace", "areas")]
)
def test_a_village_and_an_extension_are_written_and_read_again(
    name: str, ground: str, tmp_path: Path
) -> None:
    """Counted in the database, not by our reader; grounds are as large as they were."""
    solution = sw.solve(sw.read(f"sample:{name}"), steps=1)
    path = tmp_path / "out.gpkg"
    formats.write(solution, path)
    with sqlite3.connect(path) as database:
        listed = database.execute("SELECT table_name, srs_id FROM gpkg_geometry_columns").fetchall()
        counts = {
            table: database.execute(f'SELECT COUNT(*) FROM "{table}"').fetchone()[0]
            for table, _ in listed
        }
    assert {system for _, system in listed} == {4326}
    assert counts["buildings"] == sum(piece.category == "building" for piece in solution.pieces)
    again = formats.read(path)
    assert again.domain == solution.brief.domain
    report = again.input_report
    assert report is not None
    assert report.features == sum(counts.values())
    assert report.system.startswith("EPSG:4326")
    assert not [row for row in report.rows if row.outcome == "left out"]
    (plots,) = [row for row in report.rows if row.kind.startswith("plot")]
    assert plots.count == counts["plots"] == len(sw.plots_of(solution))
    before, after = (getattr(brief.part, ground) for brief in (solution.brief, again))
    areas = [[shapely.Polygon(row.outline).area for row in rows] for rows in (before, after)]
    assert areas[1] == pytest.approx(areas[0], rel=2e-3)
    assert again.part.origin == pytest.approx(solution.brief.part.origin, abs=0.02)


def test_a_batch_of_maps_is_placed_as_the_options_say(tmp_path: Path) -> None:
    """Each file of a batch is read with the site and the system that are given."""
    maps = tmp_path / "maps"
    maps.mkdir()
    for name in ("east", "west"):
        write_layers(maps / f"{name}.gpkg", crs="EPSG:25833")
    words = ["arrange", str(maps), "--batch", "-o", str(tmp_path / "out"), "--steps", "1", "-q"]
    at = f"{SITE[0][0] + 100},{SITE[0][1] + 40}"
    options = ["--crs", "EPSG:25832", "--site", at, "--jobs", "1"]
    assert cli.run([*words, *options]) in (0, 1)
    for name in ("east", "west"):
        saved = json.loads((tmp_path / "out" / f"{name}.json").read_text())
        (site,) = saved["brief"]["sites"]
        assert site["system"] == "EPSG:25832"
        assert shapely.Polygon(site["outline"]).area == pytest.approx(60 * 90, rel=2e-3)


@pytest.mark.parametrize("name", ["bomb.kmz", "bomb.zip"])
def test_an_archive_that_swells_while_it_is_unpacked_is_one_line(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Some hundred kilobytes that become 272 MiB."""
    path, zeros = tmp_path / name, bytes(2**24)
    with (
        zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive,
        archive.open("doc.kml", "w", force_zip64=True) as entry,
    ):
        for _ in range(17):
            entry.write(zeros)
    assert path.stat().st_size < 2**21
    check_refused(path, "is larger than 256 MiB unpacked; cut the place out", capsys)


@pytest.mark.parametrize("name", ["locked.kmz", "locked.zip"])
def test_an_encrypted_archive_is_one_line(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = tmp_path / name
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("doc.kml", "<kml><Document/></kml>")
    content = bytearray(path.read_bytes())
    content[6] |= 1
    content[content.index(b"PK\1\2") + 8] |= 1
    path.write_bytes(content)
    check_refused(path, "doc.kml is encrypted; pack it without a password", capsys)


def check_refused(path: Path, fault: str, capsys: pytest.CaptureFixture[str]) -> None:
    """One line with the fault, exit 2, and nothing written."""
    assert cli.run(["plan", str(path), "-o", str(path.with_name("out.json"))]) == 2
    shown = capsys.readouterr().err
    assert shown.count("\n") == 1
    assert fault in shown
    assert [file.name for file in path.parent.iterdir()] == [path.name]
