"""Files that other programs, and readers of their names, take for what they are."""

from __future__ import annotations

import json
import re
import sys
import types
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import scenewright as sw
from scenewright import cli, formats
from scenewright.batch.jobs import BatchOptions, list_jobs
from scenewright.core.errors import InputError
from scenewright.core.plugins import PluginWarning
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site
from scenewright.domains.site.writing import cityjson
from scenewright.formats import table
from scenewright.workflow import lists
from sites import answer, quarter

ROOT = Path(__file__).parent.parent
ORIGIN = (11.5, 49.5)
ADDRESS = "https://www.opengis.net/def/crs/"
UTM = {"system": f"{ADDRESS}EPSG/0/25832", "shift": (691_000.0, 5_334_000.0)}
CITY_KEYS = {"type", "version", "transform", "metadata", "CityObjects", "vertices"}
ABOUT_KEYS = {"title", "geographicalExtent", "referenceSystem"}


def solved(**place: Any) -> Solution:
    """A quarter as it is solved, somewhere on earth or not."""
    return answer(*quarter(), **place)


def test_metres_without_a_place_on_earth_are_not_written(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    site: dict[str, Any] = {
        "outline": [[0, 0], [120, 0], [120, 80], [0, 80]],
        "buildings": [{"model": "villa"}],
    }
    path = Path("close.json")
    path.write_text(json.dumps({"domain": "site", "sites": [site]}))
    words = ["arrange", "close.json", "-o", "close.geojson", "-o", "close.svg"]
    assert cli.run(words) == 2
    fault = capsys.readouterr().err
    assert fault.startswith("scenewright: close.geojson: GeoJSON is in degrees")
    assert fault.count("\n") == 1
    assert '"origin"' in fault
    assert [file.name for file in tmp_path.iterdir()] == ["close.json"]
    batch = ["arrange", "--batch", "close.json", "-o", "out", "--format", ".geojson", "-q"]
    assert cli.run(batch) == 2
    assert '"origin"' in capsys.readouterr().err
    path.write_text(json.dumps({"domain": "site", "sites": [site | {"origin": ORIGIN}]}))
    assert cli.run([*words, "-q"]) == 0
    assert sw.read("close.geojson").part.sites[0].origin == pytest.approx(ORIGIN, abs=0.01)


@pytest.mark.parametrize("far", [120.0, 200.0, 5_000_000.0])
def test_metres_without_a_name_are_refused_naming_the_origin(far: float, tmp_path: Path) -> None:
    ring = [[0.0, 0.0], [far, 0.0], [far, 80.0], [0.0, 80.0], [0.0, 0.0]]
    feature = {
        "type": "Feature",
        "properties": {"site": "yes"},
        "geometry": {"type": "Polygon", "coordinates": [ring]},
    }
    path = tmp_path / "map.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature]}))
    with pytest.raises(InputError, match='"origin"'):
        sw.read(path)


@pytest.mark.parametrize("suffix", [".city.json", ".cityjson"])
def test_city_models_are_read_and_written_by_name(suffix: str, tmp_path: Path) -> None:
    path = tmp_path / f"quarter{suffix}"
    sw.write(solved(**UTM), path)
    document = json.loads(path.read_text())
    assert faults_of_city(document) == []
    assert document["metadata"]["referenceSystem"] == UTM["system"]
    found = sw.read(path)
    assert found.name == "quarter"
    assert found.part.sites[0].system == UTM["system"]
    with pytest.raises(InputError, match="only sites"):
        formats.writer("home.city.json", "home")


def test_systems_are_named_as_city_models_name_them() -> None:
    local = cityjson.document(solved(system="urn:ogc:def:crs:EPSG::28992"))
    assert faults_of_city(local) == []
    assert local["metadata"]["referenceSystem"] == f"{ADDRESS}EPSG/0/28992"
    unknown = cityjson.document(solved(system="of the town"))
    assert "referenceSystem" not in unknown["metadata"]


def faults_of_city(document: dict[str, Any]) -> list[str]:
    """What the schemas of CityJSON 2.0 and its validators would complain of in what we write."""
    about, objects = document["metadata"], document["CityObjects"]
    faults = [*(document.keys() - CITY_KEYS), *(about.keys() - ABOUT_KEYS)]
    faults += ["system"] * (not about.get("referenceSystem", ADDRESS).startswith(ADDRESS))
    faults += ["extent"] * (len(about["geographicalExtent"]) != 6)
    faults += ["transform"] * (document["transform"].keys() != {"scale", "translate"})
    used: set[int] = set()
    for name, row in objects.items():
        faults += [name] * (not row.keys() <= {"type", "attributes", "geometry"})
        for shape in row["geometry"]:
            solids = {("Solid", "1.2"), ("Solid", "2.0")}
            right = {"Building": solids}.get(row["type"], {("MultiSurface", "1")})
            faults += [name] * ((shape["type"], shape["lod"]) not in right)
            used |= set(flat(shape["boundaries"]))
    corners = np.array(document["vertices"])
    extent = corners[[*used]] * document["transform"]["scale"] + document["transform"]["translate"]
    box = [*extent.min(0), *extent.max(0)]
    faults += ["extent"] * (not np.allclose(box, about["geographicalExtent"], atol=1e-3))
    return faults + ["vertices"] * (used != set(range(len(corners))))


def flat(value: Any) -> list[int]:
    """The numbers in nested lists."""
    return [n for part in value for n in flat(part)] if isinstance(value, list) else [value]


def test_a_batch_names_results_without_the_whole_suffix(tmp_path: Path) -> None:
    """``town.city.json`` gives ``town.json``, a solution, and no city model that is none."""
    sw.write(solved(origin=ORIGIN), tmp_path / "town.city.json")
    options = BatchOptions((".json",), "default", None, None, None, 0, False)
    orders = list_jobs([tmp_path], tmp_path / "out", options)
    assert [path.name for order in orders for path in order.outputs] == ["town.json"]


@pytest.mark.parametrize("can", ["read", "write"])
def test_a_registered_format_that_only_reads_or_writes(
    can: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    request: pytest.FixtureRequest,
) -> None:
    module = types.ModuleType("half_a_format")
    setattr(module, can, lambda *_, **__: None)
    monkeypatch.setitem(sys.modules, "half_a_format", module)
    entries = [
        EntryPoint(".half", "half_a_format", "scenewright.formats"),
        EntryPoint(".gone", "not_installed", "scenewright.formats"),
    ]
    monkeypatch.setattr("importlib.metadata.entry_points", lambda **_: entries)
    table._added_formats.cache_clear()
    request.addfinalizer(table._added_formats.cache_clear)
    with pytest.warns(PluginWarning, match="plug-in left out: .*gone"):
        row = next(row for row in formats.formats() if row.suffix == ".half")
    assert (bool(row.reader), bool(row.writer)) == (can == "read", can == "write")
    path = tmp_path / "x.half"
    path.write_text("")
    if can == "write":
        assert cli.run(["arrange", str(path)]) == 2
        assert "'.half' files cannot be read" in capsys.readouterr().err
    else:
        assert cli.run(["arrange", "sample:home-studio", "-o", str(path)]) == 2
        assert "'.half' files cannot be written" in capsys.readouterr().err
    assert cli.run(["arrange", "sample:home-studio", "-o", "x.gone"]) == 2
    assert "'.gone' files cannot be written" in capsys.readouterr().err


def test_the_table_of_files_in_the_readme_is_that_of_the_formats() -> None:
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    told = {}
    for cells in re.findall(r"^\| (`\..*?) \|(.*?)\|(.*?)\|", text, re.MULTILINE):
        for suffix in re.findall(r"`(.*?)`", cells[0]):
            told[suffix] = ("yes" in cells[1], "yes" in cells[2])
    listed = {row["suffix"]: (row["reads"], row["writes"]) for row in lists.rows("formats")}
    assert told == listed


def test_every_field_of_a_site_is_in_the_documents() -> None:
    text = (ROOT / "docs" / "brief-sites.md").read_text(encoding="utf-8")
    assert [name for name in Site.model_fields if f"`{name}`" not in text] == []
