"""A brief names no file outside its workspace, and learns nothing of what is there."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import scenewright as sw
from scenewright.core.errors import InputError

AGENT = """
import sys
from pathlib import Path
import scenewright as sw
from scenewright.studio.agents import call
from scenewright.studio.session import Session
from scenewright.workflow.project import open_project
root = Path(sys.argv[1])
session = Session(open_project(Path(":memory:")), lambda event: None)
names = ["../secret/there.json", str(root.parent / "secret" / "there"), "link", "down/there"]
for name in [*names, *sorted(file.name for file in root.glob("*.json"))]:
    for tool, asked in (("open", {"source": name}), ("export", {"name": "../secret/" + name})):
        try:
            call(session, root, tool, asked)
            print("done")
        except sw.InputError:
            print("refused")
"""
ROOM: dict[str, Any] = {
    "rooms": [{"function": "study", "outline": [[0, 0], [4, 0], [4, 3], [0, 3]]}]
}
AREA: dict[str, Any] = {"outline": [[0, 0], [60, 0], [60, 40], [0, 40]]}
CUBE = "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 1 0\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n"
PROGRAM = """
import os, sys
opened = []
sys.addaudithook(lambda event, args: opened.append(str(args[0])) if event == "open" else None)
from pathlib import Path
import scenewright as sw
space = sw.Workspace(Path(sys.argv[1]))
for name in sorted(sys.argv[2:]):
    try:
        space.read(name)
        print("READ", name)
    except sw.InputError as error:
        print("REFUSED", error)
real = [os.path.realpath(name) for name in opened if not name.isdigit()]
print("OPENED", [name for name in real if "/secret/" in name])
"""


def name_outside(outside: str) -> dict[str, dict[str, Any]]:
    """Briefs that name a file, one for each key that can."""
    village: dict[str, Any] = {"domain": "village", "blocks": [AREA]}
    hall: dict[str, Any] = ROOM["rooms"][0] | {"function": "hall"}
    site: dict[str, Any] = {"domain": "site", "sites": [AREA]}
    return {
        "hall": {"domain": "hall", "rooms": [hall], "catalogs": [outside]},
        "site": site | {"catalogs": [outside]},
        "raster": site | {"terrain": {"raster": outside}},
        "contours": site | {"terrain": {"contours": outside}},
        "catalog": ROOM | {"catalogs": [outside]},
        "entry": ROOM | {"catalogs": [{"path": outside, "fill": False}]},
        "groups": ROOM | {"groups": [outside]},
        "source": ROOM | {"source_file": {"file": outside, "sha256": "0" * 64, "plan": "plan.ifc"}},
        "style": village | {"style": f"{outside}.npz"},
        "nets": village | {"nets": f"{outside}.npz"},
        "sources": {"domain": "extend", "sources": [outside], "areas": [AREA]},
        "solution": {"brief": ROOM | {"catalogs": [outside]}, "pieces": []},
    }


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A workspace whose briefs name what lies beside it, there or not, in every way."""
    secret, inside = tmp_path / "secret", tmp_path / "plans"
    inside.mkdir()
    secret.mkdir()
    for name in ("there", "there.npz", "there.json", "cube.obj"):
        (secret / name).write_text(CUBE)
    for name in ("there", "there.npz"):
        (inside / name.replace("there", "link")).symlink_to(secret / name)
    (inside / "down").symlink_to(secret)
    for where in ("../secret/there", f"{secret}/there", "../secret/gone", "link", "down/there"):
        for key, brief in name_outside(where).items():
            name = f"{key}-{where.replace('/', '_')}.json"
            (inside / name).write_text(json.dumps(brief))
    return inside


def read_all(root: Path, *before: str) -> list[str]:
    """What a process says that reads every brief of a workspace."""
    names = sorted(file.name for file in root.glob("*.json"))
    asked = [*before, sys.executable, "-c", PROGRAM, str(root), *names, "../secret/there.json"]
    done = subprocess.run(asked, capture_output=True, text=True, timeout=300, check=True)
    return done.stdout.splitlines()


def test_hostile_briefs_open_nothing_outside_and_learn_nothing(root: Path) -> None:
    *told, opened = read_all(root)
    assert opened == "OPENED []"
    assert len(told) == len(list(root.glob("*.json"))) + 1
    assert {line.split()[0] for line in told} == {"REFUSED"}
    refused = "lies outside the workspace; use names below its folder"
    assert [line for line in told if refused not in line] == []


@pytest.mark.skipif(shutil.which("strace") is None, reason="strace is not there")
def test_the_system_sees_no_read_outside(root: Path, tmp_path: Path) -> None:
    log = tmp_path / "calls.txt"
    read_all(root, "strace", "-f", "-e", "trace=open,openat", "-o", str(log))
    calls = log.read_text().splitlines()
    assert any("plans/" in call for call in calls)
    outside = ("/secret/", "plans/link", "plans/down")
    assert not [call for call in calls if any(name in call for name in outside)]


@pytest.mark.parametrize(
    "name",
    [
        "a\0.json",
        "x" * 300 + ".json",
        "a/" * 2000,
        "\ud800.json",
        "\\\\host\\share\\a.json",
        "",
        ".",
    ],
)
def test_names_that_no_file_can_have_are_refused_in_a_line(root: Path, name: str) -> None:
    space, before = sw.Workspace(root), sorted(root.iterdir())
    for use in (space.read, space.read_solution):
        with pytest.raises(InputError) as told:
            use(name)
        assert len(str(told.value).splitlines()) <= 1
    (root / "odd.json").write_text(json.dumps(ROOM | {"catalogs": [name]}))
    with pytest.raises(InputError):
        sw.solve(space.read("odd.json"), steps=20)
    (root / "odd.json").unlink()
    assert sorted(root.iterdir()) == before


@pytest.mark.skipif(shutil.which("strace") is None, reason="strace is not there")
def test_what_agents_ask_for_is_read_nowhere_else(root: Path, tmp_path: Path) -> None:
    pytest.importorskip("starlette")
    log = tmp_path / "calls.txt"
    trace = ["strace", "-f", "-e", "trace=%file", "-o", str(log)]
    asked = [sys.executable, "-c", AGENT, str(root)]
    done = subprocess.run([*trace, *asked], capture_output=True, text=True, timeout=300, check=True)
    assert done.stdout.split() == ["refused"] * len(done.stdout.split())
    assert len(done.stdout.split()) > 20
    calls = [call for call in log.read_text().splitlines() if "open" in call.partition("(")[0]]
    assert any("plans/" in call for call in calls)
    assert not [call for call in calls if "/secret/" in call]
    assert sorted(one.name for one in tmp_path.iterdir()) == ["calls.txt", "plans", "secret"]


def test_a_workspace_reads_and_writes_below_its_root(tmp_path: Path) -> None:
    (tmp_path / "models").mkdir()
    (tmp_path / "models" / "chair.obj").write_text(CUBE)
    (tmp_path / "flat.json").write_text(json.dumps(ROOM | {"catalogs": ["models"]}))
    space = sw.Workspace(tmp_path)
    brief = space.read("flat.json")
    assert [str(entry) for entry in brief.catalogs] == [str(tmp_path / "models")]
    solution = sw.solve(brief, steps=50)
    assert space.write(solution, "out.json") == tmp_path / "out.json"
    assert space.read_solution("out.json")[0].pieces == solution.pieces
    for name in ("../out.json", "/tmp/out.json"):
        with pytest.raises(InputError, match="lies outside the workspace"):
            space.write(solution, name)
    assert space.read("sample:home-room").rooms
    with pytest.raises(InputError) as told:
        space.read("gone.json")
    assert str(tmp_path) not in str(told.value)
