"""No file that a run reads is replaced, all files appear or none, and temporary files are gone."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from flat import flat_solution
from scenewright import cli
from scenewright.core import atomic_file as whole_file
from scenewright.core.atomic_file import atomic_write, check_targets, recorded_run, whole_together
from scenewright.core.errors import InputError
from scenewright.core.scene import Size
from scenewright.formats import solution_json
from test_catalogues import obj
from test_cli_catalog import HOME
from thoroughness import only_thorough

Captured = pytest.CaptureFixture[str]
ROOM = {
    "rooms": [
        {
            "id": "r",
            "function": "bedroom",
            "outline": [[0, 0], [4, 0], [4, 4], [0, 4]],
            "doors": [{"at": [3.4, 0]}],
        }
    ]
}
ARRANGE = ["arrange", "room.json", "--steps", "50"]


@pytest.fixture(autouse=True)
def _in_a_folder_of_files(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("SCENEWRIGHT_HOME", str(tmp_path / ".home"))
    Path("room.json").write_text(json.dumps(ROOM))
    Path("home.xml").write_text(HOME)
    Path("cat").mkdir()
    Path("cat", "sofa.obj").write_text(obj(Size(2.0, 0.9, 0.8)))
    Path("cat", "notes.svg").write_text("<svg/>")
    Path("alone.obj").write_text("mtllib alone.mtl\n" + obj(Size(2.0, 0.9, 0.8)))
    Path("alone.mtl").write_text("newmtl cloth\nKd 1 0 0\n")


def content() -> dict[str, bytes]:
    return {str(p): p.read_bytes() for p in sorted(Path().rglob("*")) if p.is_file()}


def refused(capsys: Captured, *arguments: str) -> str:
    """The one line on an error; nothing has changed in the folder."""
    before = content()
    assert cli.run(list(arguments)) == 2
    assert content() == before
    told = capsys.readouterr().err
    assert told.count("\n") == 1
    return told


@pytest.mark.parametrize("output", ["home.xml", "link.xml", "hard.xml"])
def test_the_homes_that_are_learned_from_stay(output: str, capsys: Captured) -> None:
    Path("link.xml").symlink_to("home.xml")
    os.link("home.xml", "hard.xml")
    told = refused(capsys, "catalog", "learn", "home.xml", "-o", output)
    assert told.startswith(f"scenewright: {output}: is read by this run and would be replaced")
    assert Path("link.xml").is_symlink()


def test_learned_groups_that_are_used_stay(capsys: Captured) -> None:
    assert cli.run(["catalog", "learn", "home.xml", "-o", "g.json"]) == 0
    capsys.readouterr()
    assert "is read" in refused(capsys, *ARRANGE, "--groups", "g.json", "-o", "g.json")
    Path("room.json").write_text(json.dumps(ROOM | {"groups": ["g.json"]}))
    assert "is read" in refused(capsys, *ARRANGE, "-o", "plan.svg", "-o", "g.json")


@pytest.mark.parametrize("times", [1, 2])
def test_files_of_a_catalogue_stay(times: int, capsys: Captured) -> None:
    """Also where the catalogue is known from an earlier reading."""
    for _ in range(times):
        told = refused(capsys, *ARRANGE, "--catalog", "cat", "-o", "cat/notes.svg")
        assert "is read" in told
    table = Path("cat", "catalog.csv")
    assert cli.run(["catalog", "show", "cat", "-o", str(table)]) == 0
    capsys.readouterr()
    assert "is read" in refused(capsys, "catalog", "show", "cat", "-o", str(table))


def test_what_a_model_file_refers_to_stays(capsys: Captured) -> None:
    os.link("alone.mtl", "sheet.png")
    assert "is read" in refused(capsys, "view", "alone.obj", "-o", "sheet.png")


def test_inputs_of_a_batch_stay(capsys: Captured) -> None:
    """The result of one file has the name of another input."""
    Path("in").mkdir()
    for name in ("room.json", "in/room.json", "in/room.json.json"):
        Path(name).write_text(json.dumps(ROOM))
    before = content()
    batch = ["arrange", "--batch", "--jobs", "1", "--steps", "50", "-q"]
    files = ["room.json", "in/room.json", "in/room.json.json"]
    assert cli.run([*batch, *files, "-o", "in"]) == 1
    assert before.items() <= content().items()
    capsys.readouterr()
    rows = json.loads(Path("in", "summary.json").read_text())["files"]
    failed = [row["message"] for row in rows if row["status"] == "failed"]
    assert failed
    assert all("is read by this run" in told for told in failed)
    Path("summary.json").write_text(json.dumps(ROOM))
    assert "summary.json: is read" in refused(capsys, *batch, "summary.json", "-o", ".")


def test_a_folder_among_the_targets_stops_all(capsys: Captured) -> None:
    Path("plan.svg").mkdir()
    told = refused(capsys, *ARRANGE, "-o", "saved.json", "-o", "plan.svg")
    assert told == "scenewright: plan.svg: is a folder; give the name of a file\n"
    with pytest.raises(InputError, match=r"late\.svg: is a folder"):
        _write_beside_a_new_folder()
    assert not Path("one.json").exists()
    assert not [name for name in os.listdir() if "scenewright" in name]


def _write_beside_a_new_folder() -> None:
    with whole_together(["one.json", "late.svg"]) as partials:
        for partial in partials:
            partial.write_text("x")
        Path("late.svg").mkdir()


def test_one_target_by_two_names_is_refused() -> None:
    Path("a.svg").write_text("x")
    os.link("a.svg", "b.svg")
    with pytest.raises(InputError, match="is given twice"):
        check_targets(["a.svg", "b.svg"])
    with pytest.raises(InputError, match="is given twice"):
        check_targets(["cat/new.svg", "cat/../cat/new.svg"])


@pytest.mark.parametrize("suffix", [".json", ".svg", ".glb", ".credits.txt"])
def test_names_as_long_as_the_file_system_allows(suffix: str, capsys: Captured) -> None:
    name = "n" * (255 - len(suffix)) + suffix
    assert cli.run([*ARRANGE, "-o", name, "-q"]) < 2
    assert Path(name).stat().st_size
    assert "nnn... is no name of a file" in refused(capsys, *ARRANGE, "-o", f"n{name}")


def test_long_names_in_a_batch() -> None:
    name = "n" * (255 - len(".json")) + ".json"
    Path(name).write_text(json.dumps(ROOM))
    assert cli.run(["arrange", "--batch", name, "-o", "out", "--jobs", "1", "--steps", "50"]) < 2
    assert Path("out", name).stat().st_size


def test_temporary_names_follow_no_link(monkeypatch: pytest.MonkeyPatch) -> None:
    """Even a name that was guessed: what a link there leads to is not written to."""
    Path("victim").write_text("mine")
    monkeypatch.setattr(whole_file.secrets, "token_hex", lambda _: "0")
    Path(".scenewright-0.svg").symlink_to("victim")
    with pytest.raises(FileExistsError), atomic_write("plan.svg"):
        pass
    assert Path("victim").read_text() == "mine"


def test_files_of_our_own_may_be_made_anew() -> None:
    with recorded_run():
        whole_file.note_read("room.json")
        with pytest.raises(InputError), atomic_write("room.json"):
            pass
        whole_file.write_atomically("room.json", "{}", own=True)
    assert Path("room.json").read_text() == "{}"


def test_what_would_not_read_back_is_not_written(monkeypatch: pytest.MonkeyPatch) -> None:
    flat = flat_solution()
    solution_json.write(flat, "flat.json")
    twice = solution_json.dumps(flat).replace(flat.pieces[1].id, flat.pieces[0].id)
    monkeypatch.setattr(solution_json, "dumps", lambda _: twice)
    before = content()
    assert cli.run(["adjust", "flat.json", "-o", "flat.json", "--lock", flat.pieces[0].id]) == 3
    assert content() == before


SLOW = """
import time
from pathlib import Path
from scenewright import cli
def slow(partial, text, **options):
    with partial.open("w") as stream:
        stream.write(text[:20])
    print("writing", flush=True)
    time.sleep(2)
Path.write_text = slow
cli.main()
"""
BATCH = ["arrange", "--batch", "room.json", "-o", "out", "--jobs", "1", "--steps", "50"]


def left_over(before: dict[str, bytes]) -> set[str]:
    """New files but for the list of what a batch has done, and results that are whole."""
    return {
        name
        for name in content().keys() - before.keys()
        if name not in ("out/.batch.jsonl", "out/room.json") and not name.startswith("first/")
    }


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
@pytest.mark.parametrize(
    "arguments",
    [
        [*ARRANGE, "-o", "out.svg", "-o", "out.json"],
        pytest.param(["catalog", "show", "cat", "-o", "out.csv"], marks=only_thorough),
        BATCH,
    ],
)
def test_nothing_is_left_when_the_process_is_told_to_end(arguments: list[str]) -> None:
    before = content()
    process = subprocess.Popen(
        [sys.executable, "-c", SLOW, *arguments],
        text=True,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "writing\n"
    process.send_signal(signal.SIGTERM)
    _, told = process.communicate(timeout=90)
    assert process.returncode == 143
    assert told.endswith("scenewright: terminated\n")
    assert not left_over(before)


FULL = """
import contextlib, io, resource, sys
from scenewright import cli
first = [a.replace("out", "first/out") for a in sys.argv[1:]]  # compiles what it needs
with contextlib.redirect_stdout(io.StringIO()):
    assert cli.run(first) < 2
resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))
cli.main()
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs limits of processes")
@pytest.mark.parametrize(
    "arguments",
    [
        [*ARRANGE, "-o", "out.svg", "-o", "out.glb"],
        pytest.param(["catalog", "learn", "home.xml", "-o", "out.json"], marks=only_thorough),
        pytest.param(["catalog", "show", "cat", "-o", "out.csv"], marks=only_thorough),
        BATCH,
    ],
)
def test_nothing_is_left_when_the_disk_is_full(arguments: list[str]) -> None:
    """A limit of 100 bytes for a file stands for a disk that takes no more."""
    before = content()
    Path("first").mkdir()
    done = subprocess.run([sys.executable, "-c", FULL, *arguments], capture_output=True, text=True)
    assert done.returncode == 2, done.stderr
    assert "File too large" in done.stderr
    assert "internal error" not in done.stderr
    assert not left_over(before)
