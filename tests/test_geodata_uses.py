"""Maps used: written as GeoPackage and read again, compared, folded, learned from, in batches."""

from __future__ import annotations

import json
import sqlite3
from pathlib import Path

import numpy as np
import pytest
import shapely

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
