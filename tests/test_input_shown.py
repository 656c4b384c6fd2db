"""What became of a file's features is shown by every command, and what was lost is not hidden."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import scenewright as sw
from scenewright import cli
from scenewright.cli.show_input import MOST_KINDS, describe_input
from scenewright.core.brief.input_report import Fate, InputReport, report_input
from scenewright.formats import brief_json

Captured = pytest.CaptureFixture[str]
ROOM = "sample:home-room"
SCHOOL = Fate("way/4", "building", "left out", "its outline crosses itself", stands=True)
TREES = [Fate(f"node/{k}", "tree", "left out", "trees are planted anew") for k in range(5000)]


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def save_room(report: InputReport) -> str:
    """A room that was read from another file, which the report describes."""
    brief = sw.read(ROOM).model_copy(update={"input_report": report})
    Path("room.json").write_text(brief_json.dumps(brief), encoding="utf-8")
    return "room.json"


def run(*words: str) -> int:
    return cli.run([*words])


def arrange(report: InputReport, *words: str) -> int:
    return run("arrange", save_room(report), "--steps", "50", "-o", "out.json", *words)


def test_thousands_of_features_are_a_few_lines(capsys: Captured) -> None:
    used = Fate("way/1", "building", "used")
    report = report_input([used, *TREES], format="GeoJSON", system="EPSG:25832", unit="metres")
    assert arrange(report) == 0
    shown = capsys.readouterr().err
    assert "read: GeoJSON, EPSG:25832, metres: 5,001 features\n" in shown
    assert "  building: 1 used\n" in shown
    reason = "trees are planted anew (node/0, node/1, node/2 …)"
    assert f"  tree: 5,000 left out: {reason}\n" in shown


def test_a_lost_school_is_a_warning_and_exit_1_in_every_command(capsys: Captured) -> None:
    report = report_input([SCHOOL, *TREES], format="GeoJSON")
    warning = "warning: not all of the file was read: building: 1 left out: its outline crosses"
    assert arrange(report) == 1
    assert warning in capsys.readouterr().out
    assert run("check", "out.json") == 1
    assert warning in capsys.readouterr().out
    assert run("explain", "out.json") == 0
    assert warning in capsys.readouterr().out
    assert run("adjust", "out.json", "--move", "desk=2,2", "-o", "moved.json") == 1
    assert warning in capsys.readouterr().out
    assert run("arrange", "room.json", "--batch", "--steps", "50", "-o", "many") == 1
    assert "its outline crosses itself (way/4)" in Path("many/summary.csv").read_text()


def test_the_report_is_an_object_in_json(capsys: Captured) -> None:
    report = report_input([SCHOOL], format="GeoJSON")
    arrange(report, "--json")
    shown = json.loads(capsys.readouterr().out)
    assert shown["exit"] == 1
    assert shown["input_report"]["complete"] is False
    expected = [{"kind": "building", "outcome": "left out", "count": 1}]
    rows = shown["input_report"]["rows"]
    assert [{key: row[key] for key in expected[0]} for row in rows] == expected
    for words in (["check", "out.json"], ["explain", "out.json"]):
        run(*words, "--json")
        assert json.loads(capsys.readouterr().out)["input_report"] == shown["input_report"]


def test_it_is_read_from_python_and_kept_in_the_solution() -> None:
    report = report_input([SCHOOL], format="GeoJSON")
    brief = sw.read(save_room(report))
    assert brief.input_report == report
    assert not brief.is_read_whole
    arranged = sw.arrange("room.json", ["out.json"], steps=50)
    assert not arranged.complete
    assert arranged.report.valid
    assert sw.read_solution("out.json").brief.input_report == report


def test_a_plan_of_which_little_floor_was_read_says_so(capsys: Captured) -> None:
    report = report_input([Fate("w1", "wall", "used")], drawn_floor=39.0, read_floor=2.0)
    assert arrange(report) == 1
    shown = capsys.readouterr()
    assert "only 2.0 of 39.0 m² of drawn floor were read (5 %)" in shown.out
    assert "  floor: 2.0 of 39.0 m² of drawn floor were read (5 %)" in shown.err


def test_many_kinds_are_summed_up() -> None:
    fates = [Fate("", f"kind {k}", "used") for k in range(MOST_KINDS + 3)]
    lines = describe_input(report_input(fates))
    assert len(lines) == MOST_KINDS + 2
    assert lines[-1] == "  3 other kinds: 3"
