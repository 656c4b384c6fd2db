"""A domain of another package, registered by entry point, works with every verb."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

PLUGINS = Path(__file__).parent / "plugins"
BRIEF = {
    "domain": "meadow",
    "name": "Sunday",
    "meadows": [{"id": "south", "outline": [[0, 0], [14, 0], [14, 9], [0, 9]], "blankets": 5}],
}


def run(*words: str, cwd: Path, code: int = 0) -> str:
    paths = os.pathsep.join([str(PLUGINS), *filter(None, [os.environ.get("PYTHONPATH")])])
    command = [sys.executable, "-m", "scenewright", *words]
    done = subprocess.run(
        command, capture_output=True, text=True, cwd=cwd, env=os.environ | {"PYTHONPATH": paths}
    )
    assert done.returncode == code, done.stderr
    return done.stdout + done.stderr


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("meadow")
    (folder / "sunday.json").write_text(json.dumps(BRIEF))
    outputs = ("-o", "out.json", "-o", "out.svg", "-o", "out.glb", "-o", "out.png")
    run("arrange", "sunday.json", *outputs, cwd=folder)
    return folder


def test_it_is_arranged_and_written(folder: Path) -> None:
    saved = json.loads((folder / "out.json").read_text())
    assert [piece["category"] for piece in saved["pieces"]] == ["rug"] * 5
    assert saved["brief"]["meadows"][0]["blankets"] == 5
    assert "<svg" in (folder / "out.svg").read_text()
    assert (folder / "out.glb").read_bytes()[:4] == b"glTF"


def test_it_is_checked_and_explained(folder: Path) -> None:
    assert "valid" in run("check", "out.json", cwd=folder)
    assert "near" in run("explain", "out.json", "--terms", cwd=folder)


def test_a_broken_answer_is_found(folder: Path) -> None:
    saved = json.loads((folder / "out.json").read_text())
    saved["pieces"][0]["pose"] = [40.0, 40.0, 0.0, 0.0]
    (folder / "moved.json").write_text(json.dumps(saved))
    assert "out of bounds" in run("check", "moved.json", cwd=folder, code=1)


def test_it_has_alternatives_and_batches(folder: Path) -> None:
    run("arrange", "sunday.json", "--alternatives", "2", "-o", "plan.svg", cwd=folder)
    assert (folder / "plan-1.svg").read_text() != (folder / "plan-2.svg").read_text()
    run("arrange", "sunday.json", "--batch", "-o", "many", cwd=folder)
    assert list((folder / "many").rglob("sunday*.json"))


def test_what_it_lacks_is_refused_in_one_line(folder: Path) -> None:
    told = run(
        "adjust", "out.json", "-o", "x.json", "--lock", "south/blanket_1", cwd=folder, code=2
    )
    assert "do not support" in told
    assert "Traceback" not in told


def test_it_is_listed(folder: Path) -> None:
    assert "meadow" in run("list", "presets", cwd=folder)


def test_bad_briefs_are_refused_by_place(folder: Path) -> None:
    bad = BRIEF | {"meadows": [{"outline": [[0, 0], [4, 0]]}]}
    (folder / "bad.json").write_text(json.dumps(bad))
    assert "meadows[0].outline" in run("arrange", "bad.json", "-o", "y.svg", cwd=folder, code=2)
