"""A domain of another package, registered by entry point, works with every verb."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

PLUGINS = Path(__file__).parent / "plugins"
BRIEF = {
    "domain": "meadow",
    "name": "Sunday",
    "meadows": [{"id": "south", "outline": [[0, 0], [14, 0], [14, 9], [0, 9]], "blankets": 5}],
}


SERVING = """
import contextlib, io, json, sys
from scenewright import cli
for line in sys.stdin:
    told = io.StringIO()
    with contextlib.redirect_stdout(told), contextlib.redirect_stderr(told):
        code = cli.run(json.loads(line))
    print(json.dumps([code, told.getvalue()]), flush=True)
"""
"""Runs the command of each line it reads: one process in which the package is installed."""


class Program(NamedTuple):
    """A process that serves commands in a folder of its own."""

    process: subprocess.Popen[str]
    folder: Path

    def run(self, *words: str, code: int = 0) -> str:
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps(words) + "\n")
        self.process.stdin.flush()
        ended, told = json.loads(self.process.stdout.readline())
        assert ended == code, told
        return str(told)


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Program]:
    folder = tmp_path_factory.mktemp("meadow")
    (folder / "sunday.json").write_text(json.dumps(BRIEF))
    paths = os.pathsep.join([str(PLUGINS), *filter(None, [os.environ.get("PYTHONPATH")])])
    with subprocess.Popen(
        [sys.executable, "-c", SERVING],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
        cwd=folder,
        env=os.environ | {"PYTHONPATH": paths},
    ) as process:
        made = Program(process, folder)
        outputs = ("-o", "out.json", "-o", "out.svg", "-o", "out.glb", "-o", "out.png")
        made.run("arrange", "sunday.json", *outputs)
        yield made


def test_it_is_arranged_and_written(program: Program) -> None:
    saved = json.loads((program.folder / "out.json").read_text())
    assert [piece["category"] for piece in saved["pieces"]] == ["rug"] * 5
    assert saved["brief"]["meadows"][0]["blankets"] == 5
    assert "<svg" in (program.folder / "out.svg").read_text()
    assert (program.folder / "out.glb").read_bytes()[:4] == b"glTF"


def test_it_is_checked_and_explained(program: Program) -> None:
    assert "valid" in program.run("check", "out.json")
    assert "near" in program.run("explain", "out.json", "--terms")


def test_a_broken_answer_is_found(program: Program) -> None:
    saved = json.loads((program.folder / "out.json").read_text())
    saved["pieces"][0]["pose"] = [40.0, 40.0, 0.0, 0.0]
    (program.folder / "moved.json").write_text(json.dumps(saved))
    assert "out of bounds" in program.run("check", "moved.json", code=1)


def test_it_has_alternatives_and_batches(program: Program) -> None:
    program.run("arrange", "sunday.json", "--alternatives", "2", "-o", "plan.svg")
    one, other = (program.folder / f"plan-{k}.svg" for k in (1, 2))
    assert one.read_text() != other.read_text()
    program.run("arrange", "sunday.json", "--batch", "-o", "many")
    assert list((program.folder / "many").rglob("sunday*.json"))


def test_what_it_lacks_is_refused_in_one_line(program: Program) -> None:
    told = program.run("adjust", "out.json", "-o", "x.json", "--lock", "south/blanket_1", code=2)
    assert "do not support" in told
    assert "Traceback" not in told


def test_it_is_listed(program: Program) -> None:
    assert "meadow" in program.run("list", "presets")


def test_bad_briefs_are_refused_by_place(program: Program) -> None:
    bad = BRIEF | {"meadows": [{"outline": [[0, 0], [4, 0]]}]}
    (program.folder / "bad.json").write_text(json.dumps(bad))
    assert "meadows[0].outline" in program.run("arrange", "bad.json", "-o", "y.svg", code=2)
