"""Where benchmarks look for real data, and what they say where there are none."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from benchmarks import batch, designer, hall_malls, home, home_rooms, instances, r2v, site_compounds
from benchmarks.real_data import data_files, data_folder, data_set, instance

from scenewright import cli
from scenewright.core.errors import InputError

NEEDS: dict[str, Callable[[], object]] = {
    "furnished_homes_sh3d": lambda: list(designer.records(quick=True)),
    "floorplans_r2v/plans.json": lambda: r2v.run(1),
    "site_reco_sample/reco_sample.json": site_compounds.file,
    "indoor_osm": hall_malls.names,
    "indoor_osm/apb.geojson": lambda: hall_malls.rows("apb"),
    "home-living.json": lambda: instances.read_instance("living"),
}


@pytest.fixture
def bare(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A data folder with nothing in it, in which one works."""
    (tmp_path / "data").mkdir()
    monkeypatch.setenv("SCENEWRIGHT_DATA", str(tmp_path / "data"))
    monkeypatch.chdir(tmp_path)
    return tmp_path / "data"


@pytest.mark.parametrize("name", NEEDS)
def test_a_missing_set_is_named_with_the_remedy(bare: Path, name: str) -> None:
    with pytest.raises(InputError, match=name) as told:
        NEEDS[name]()
    assert str(bare.parent) in str(told.value)
    assert "SCENEWRIGHT_DATA" in told.value.remedy


def test_rooms_and_flats_of_no_plans(bare: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"plans\.json"):
        home_rooms.rooms.__wrapped__(1)
    with pytest.raises(InputError, match=r"plans\.json"):
        batch.briefs(tmp_path / "in", 1)


def test_a_folder_without_the_files_is_missing_too(bare: Path) -> None:
    (bare / "indoor_osm").mkdir()
    (bare / "indoor_osm" / "notes.txt").write_text("none yet")
    with pytest.raises(InputError, match=r"indoor_osm/\*\.geojson"):
        hall_malls.names()
    (bare / "indoor_osm" / "b.geojson").write_text("{}")
    (bare / "indoor_osm" / "a.geojson").write_text("{}")
    assert hall_malls.names() == ["a", "b"]
    assert [path.stem for path in data_files("indoor_osm", "*.txt")] == ["notes"]


@pytest.mark.usefixtures("bare")
@pytest.mark.parametrize("part", [hall_malls.records, site_compounds.compound_records])
def test_one_part_of_many_is_skipped_with_a_word(part: Callable[[], list[dict]]) -> None:
    told = part()
    assert [(row["metric"], row["runs"]) for row in told] == [("skipped", 0)]
    assert "SCENEWRIGHT_DATA" in told[0]["case"]


def test_the_folder_is_the_same_wherever_one_works(
    bare: Path, monkeypatch: pytest.MonkeyPatch, root: Path
) -> None:
    assert data_folder() == bare
    for unset in (
        lambda: monkeypatch.setenv("SCENEWRIGHT_DATA", ""),
        lambda: monkeypatch.delenv("SCENEWRIGHT_DATA"),
    ):
        unset()
        assert data_folder() == root.parent / "shared" / "data"


def test_sets_and_instances_lie_side_by_side(bare: Path) -> None:
    for path in (bare / "set" / "file.json", bare.parent / "instances" / "home-x.json"):
        path.parent.mkdir()
        path.write_text("{}")
    assert data_set("set/file.json").is_file()
    assert instance("home-x.json").is_file()


@pytest.mark.usefixtures("bare")
def test_homes_are_not_measured_for_an_hour_first() -> None:
    heard: list[str] = []
    with pytest.raises(InputError):
        home.records(True, lambda _, told: heard.append(told))
    assert heard == []


@pytest.mark.usefixtures("bare")
@pytest.mark.parametrize("name", ["batch", "designer", "r2v", "home"])
def test_the_command_ends_in_one_line(
    name: str, root: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(root)
    assert cli.run(["bench", name, "--quick"]) == 2
    told = capsys.readouterr().err
    assert told.startswith("scenewright: the real data ")
    assert told.count("\n") == 1
