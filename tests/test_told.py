"""What is told of slips that once passed in silence."""

from __future__ import annotations

import csv
import json
import os
from pathlib import Path
from typing import Any

import pytest

from scenewright import cli
from scenewright.batch import batch
from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.home import solving as home

OUTLINE = [[0, 0], [4, 0], [4, 3.4], [0, 3.4]]
BEDROOM: dict[str, Any] = {
    "rooms": [{"id": "r", "name": "Bedroom", "outline": OUTLINE, "doors": [{"at": [0.8, 0]}]}]
}


def written(path: Path, document: Any) -> Path:
    path.write_text(json.dumps(document), encoding="utf-8")
    return path


def solved(**more: Any) -> Any:
    brief = Brief.model_validate({"rooms": [BEDROOM["rooms"][0] | more]})
    return check(home.solve(brief, steps=100))


@pytest.mark.parametrize("output", ["plan.json", "./plan.json", "link.json", "hard.json"])
def test_a_brief_is_not_replaced_by_its_answer(
    output: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    plan = written(Path("plan.json"), BEDROOM)
    before = plan.read_bytes()
    Path("link.json").symlink_to(plan)
    os.link(plan, "hard.json")
    assert cli.run(["arrange", "plan.json", "-o", output, "--steps", "50"]) == 2
    assert "is read by this run" in capsys.readouterr().err
    assert plan.read_bytes() == before
    assert Path("link.json").is_symlink()


def test_nor_by_one_of_several_plans_or_of_a_batch(tmp_path: Path) -> None:
    plan = written(tmp_path / "plan-2.json", BEDROOM)
    line = ["arrange", str(plan), "-o", str(tmp_path / "plan.json"), "--alternatives", "2"]
    assert cli.run([*line, "--steps", "50"]) == 2
    assert json.loads(plan.read_text()) == BEDROOM
    (row,) = batch([plan], tmp_path, steps=50, jobs=1)
    assert row.status == "failed"
    assert "is read by this run" in row.message
    assert json.loads(plan.read_text()) == BEDROOM


def test_a_saved_home_is_replaced_by_adjust_alone(tmp_path: Path) -> None:
    plan, saved = written(tmp_path / "plan.json", BEDROOM), tmp_path / "saved.json"
    assert cli.run(["arrange", str(plan), "-o", str(saved), "--steps", "300", "-q"]) < 2
    before = saved.read_bytes()
    assert cli.run(["arrange", str(saved), "-o", str(saved), "--steps", "300", "-q"]) == 2
    assert saved.read_bytes() == before
    assert cli.run(["adjust", str(saved), "-o", str(saved), "--lock", "bed", "-q"]) < 2
    assert saved.read_bytes() != before


@pytest.mark.parametrize(
    ("more", "noted"),
    [
        ({"name": "Zzyzx"}, True),
        ({"name": ""}, True),
        ({"name": "Zzyzx", "function": "other"}, False),
        ({"name": "Zzyzx", "function": "bedroom"}, False),
        ({"name": "Garage"}, False),
        ({"name": "Zzyzx", "ask": [{"group": "desk"}]}, False),
        ({"name": "Zzyzx", "outline": [[0, 0], [1.6, 0], [1.6, 1], [0, 1]]}, False),
    ],
)
def test_a_room_of_unknown_use_is_noted(more: dict[str, Any], noted: bool) -> None:
    notes = [note.message for note in solved(**more).notes if note.missing == "a use"]
    assert bool(notes) == noted
    assert all("its use is not known" in told and '"function"' in told for told in notes)


def test_away_from_a_door_needs_a_door() -> None:
    wish = {"what": "sleeping", "away_from": "door"}
    (told,) = solved(doors=[], wishes=[wish]).figures["wishes"]
    assert not told["fulfilled"]
    assert told["why"] == "the room has no door"


def test_a_batch_tells_what_is_left_out(tmp_path: Path) -> None:
    narrow = [[0, 0], [1.2, 0], [1.2, 1.5], [0, 1.5]]
    room = BEDROOM["rooms"][0] | {"outline": narrow, "doors": [{"at": [0.6, 0]}]}
    plan = written(tmp_path / "plan.json", {"rooms": [room | {"ask": [{"group": "sleeping"}]}]})
    (row,) = batch([plan], tmp_path / "out", steps=50, jobs=1)
    assert row.status == "left out"
    with (tmp_path / "out" / "summary.csv").open(encoding="utf-8") as file:
        (line,) = csv.DictReader(file)
    assert line["message"].startswith("r: sleeping: no free wall of 2.0 m to stand against")


def test_a_batch_that_is_quiet_names_what_failed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    good, bad = written(tmp_path / "good.json", BEDROOM), written(tmp_path / "bad.json", {})
    line = ["arrange", "--batch", str(good), str(bad), "-o", str(tmp_path / "out")]
    assert cli.run([*line, "--steps", "50", "--jobs", "1", "-q"]) == 1
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.startswith(f"scenewright: {bad}: rooms: is missing")
    assert str(good) not in told.err


def test_groups_are_learned_from_homes_only(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    plan = written(tmp_path / "plan.json", BEDROOM)
    assert cli.run(["catalog", "learn", str(plan), "-o", str(tmp_path / "groups.json")]) == 2
    assert ".sh3d or .xml" in capsys.readouterr().err


def test_ids_of_a_catalogue_can_be_copied(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    name = "sofa_" + "of_a_long_name_" * 4
    corners = [f"v {x} {y} {z}" for x in (0, 2) for y in (0, 0.8) for z in (0, 0.9)]
    faces = ["f 1 2 4 3", "f 5 6 8 7", "f 1 2 6 5", "f 3 4 8 7", "f 1 3 7 5", "f 2 4 8 6"]
    (tmp_path / f"{name}.obj").write_text("\n".join([*corners, *faces]))
    assert cli.run(["catalog", "show", str(tmp_path)]) == 0
    shown = capsys.readouterr().out
    assert name in shown
    assert "2.00" in shown
