"""Text from outside: refused where it is no text, harmless where it is shown."""

from __future__ import annotations

import ast
import copy
import csv
import io
import json
import os
import subprocess
import sys
import zipfile
from pathlib import Path
from typing import Any

import pytest

import scenewright as sw
from hostile_documents import DOCUMENTS, places
from scenewright import cli, formats
from scenewright.batch.jobs import BatchOptions
from scenewright.batch.table import CSV, make_failed_row, write_summary
from scenewright.catalog.loading import read_entry
from scenewright.catalog.models import report
from scenewright.catalog.models.properties import properties
from scenewright.core.brief import Brief
from scenewright.core.brief.catalog import CatalogBrief
from scenewright.core.errors import InputError
from scenewright.core.scene import Size
from scenewright.formats import brief_json, solution_json
from scenewright.text import printable_lines
from test_catalogues import obj

EVIL = "A\x1b[2J\x07\x9b31m\u202eB\u2066\u200f\x00\x7f"
"""What clears a screen, rings, colours and turns around."""
ROOM = {
    "name": EVIL,
    "function": "study",
    "outline": [[0, 0], [4, 0], [4, 3], [0, 3]],
    "doors": [{"at": [2, 0]}],
    "wishes": [{"what": "desk", "by": "window"}],
}
EVIL_BRIEF = {"name": EVIL, "rooms": [ROOM]}


def harmless(text: str) -> bool:
    """Whether a terminal obeys nothing in it."""
    return text == printable_lines(text)


@pytest.mark.parametrize("name", DOCUMENTS)
def test_half_a_character_is_refused_in_every_field(name: str, tmp_path: Path) -> None:
    suffix, sound = DOCUMENTS[name]
    path = tmp_path / f"file{suffix}"
    for number, (_, key) in enumerate(places(sound)):
        for inside in ("value", "key"):
            document = copy.deepcopy(sound)
            parent, key = places(document)[number]
            if inside == "value" and isinstance(parent[key], str):
                parent[key] = "a\ud800b"
            elif inside == "key" and isinstance(parent, dict):
                parent["\udc00a"] = parent[key]
            else:
                continue
            path.write_text(json.dumps(document))
            with pytest.raises(InputError, match="half of a surrogate pair"):
                formats.read(path)


def test_half_a_character_is_refused_in_a_solution(tmp_path: Path) -> None:
    document = solution_json.to_document(sw.solve(Brief(**sound_brief()), steps=50))
    for field in ("preset", "brief_hash", "made_by"):
        with pytest.raises(InputError, match=f"{field}: .*half of a surrogate pair"):
            solution_json.loads(json.dumps(document | {field: "\udfff"}))
    credit = {"author": "\ud8ff", "licence": "", "assets": []}
    with pytest.raises(InputError, match=r"credits\[0\].author: "):
        solution_json.loads(json.dumps(document | {"credits": [credit]}))


def sound_brief() -> dict[str, Any]:
    return {
        "rooms": [
            {
                "outline": [[0, 0], [4, 0], [4, 3], [0, 3]],
                "function": "study",
                "doors": [{"at": [2, 0]}],
            }
        ]
    }


def test_pairs_of_halves_are_characters() -> None:
    text = json.dumps(sound_brief() | {"name": "\U0001f6cb"})
    assert "\\ud83d\\udecb" in text
    assert brief_json.loads(text).name == "\U0001f6cb"


def test_models_of_python_refuse_it_too() -> None:
    with pytest.raises(ValueError, match="unicode"):
        Brief(**sound_brief() | {"name": "\ud800"})


def test_properties_and_xml_refuse_it(tmp_path: Path) -> None:
    assert properties(b"a=\\ud83d\\udecb") == {"a": "\U0001f6cb"}
    with pytest.raises(InputError, match="half of a surrogate pair"):
        properties(b"a=\\ud83d")
    home = '<?xml version="1.0"?><home name="&#xD800;"><room/></home>'
    for content in (
        home.encode(),
        home.replace("&#xD800;", "\ud800").encode("utf-8", "surrogatepass"),
    ):
        path = tmp_path / "home.xml"
        path.write_bytes(content)
        with pytest.raises(InputError):
            formats.read(path)
        with zipfile.ZipFile(tmp_path / "home.sh3d", "w") as archive:
            archive.writestr("Home.xml", content)
        with pytest.raises(InputError):
            formats.read(tmp_path / "home.sh3d")


@pytest.mark.skipif(sys.platform != "linux", reason="names of files are text elsewhere")
def test_names_of_files_are_text(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    name = os.fsdecode(b"K\xfcche.json")
    path = tmp_path / name
    path.write_text(json.dumps(sound_brief()))
    with pytest.raises(InputError, match="name of a file is not valid Unicode"):
        formats.read(path)
    for words in (
        ["arrange", str(path)],
        ["arrange", "sample:home-flat", "-o", name],
        ["arrange", "sample:home-flat", "--preset", name],
        ["list", name],
        ["catalog", "show", name],
        [name],
    ):
        assert cli.run(words) == 2
        assert capsys.readouterr().err.endswith(
            "not valid Unicode; rename the file or correct it\n"
        )
    folder = tmp_path / "models"
    folder.mkdir()
    (folder / os.fsdecode(b"\xff.obj")).write_text(obj(Size(0.5, 0.5, 0.9)))
    assert [row.reason for row in report(folder).skipped] == ["its name is not valid Unicode"]
    assert cli.run(["arrange", "--batch", str(tmp_path), "-o", str(tmp_path / "out"), "-q"]) == 2
    assert "is not valid Unicode" in capsys.readouterr().err


@pytest.fixture
def evil(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a brief, its solution and models, all with hostile names."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("SCENEWRIGHT_HOME", str(tmp_path / "user"))
    name = EVIL.replace("\0", "")
    Path(f"{name}.json").write_text(json.dumps(EVIL_BRIEF))
    sw.write(sw.solve(sw.read(f"{name}.json"), steps=50), f"{name}-out.json")
    Path(name).mkdir()
    Path(name, f"{name}.obj").write_text(obj(Size(0.5, 0.5, 0.9)))
    Path(name, "broken.obj").write_text(f"v 1 2 {EVIL}")
    return tmp_path


COMMANDS: tuple[tuple[str, ...], ...] = (
    ("arrange", "{}.json", "-o", "{}.svg", "--steps", "50"),
    ("arrange", "{}.json", "--steps", "50", "--json"),
    ("arrange", "{}.json", "--steps", "50", "--alternatives", "2", "-o", "{}.json.json"),
    ("arrange", "{}.json", "--preset", "{}"),
    ("arrange", "{}.json", "-o", "x.{}"),
    ("arrange", "{}"),
    ("arrange", "--batch", "{}.json", "nothing{}.json", "-o", "{}-batch"),
    ("check", "{}-out.json"),
    ("check", "{}-out.json", "--json"),
    ("check", "{}.json"),
    ("explain", "{}-out.json"),
    ("explain", "{}-out.json", "--json"),
    ("adjust", "{}-out.json", "-o", "{}-new.json", "--lock", "{}"),
    ("adjust", "{}-out.json", "-o", "{}-new.json", "--move", "{}=1"),
    ("view", "{}", "-o", "{}.png"),
    ("view", "{}", "-o", "{}.png", "--json"),
    ("catalog", "add", "{}", "--name", "{}"),
    ("catalog", "add", "{}", "--name", "evil"),
    ("catalog", "list"),
    ("catalog", "list", "--json"),
    ("catalog", "show", "{}"),
    ("catalog", "show", "{}", "--json"),
    ("catalog", "show", "{}", "--category", "{}"),
    ("catalog", "show", "{}", "-o", "{}.csv"),
    ("catalog", "learn", "{}", "-o", "g.json"),
    ("list", "{}"),
    ("schema", "{}"),
    ("bench", "{}"),
    ("{}",),
    ("arrange", "--{}"),
)
"""Every command, with the hostile text wherever it takes any."""


def test_no_command_prints_what_a_terminal_obeys(
    evil: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    name = EVIL.replace("\0", "")
    for command in COMMANDS:
        code = cli.run([word.replace("{}", name) for word in command])
        told = capsys.readouterr()
        assert code != 3, (command, told.err)
        assert told.out + told.err, command
        assert harmless(told.out), (command, told.out)
        assert harmless(told.err), (command, told.err)
        if "--json" in command and code < 2:
            json.loads(told.out)


def test_every_console_is_a_harmless_one() -> None:
    """Whoever prints takes the console from one place."""
    for file in set(Path(cli.__file__).parent.glob("*.py")):
        made = [
            node
            for node in ast.walk(ast.parse(file.read_text(encoding="utf-8")))
            if isinstance(node, ast.Call)
            and isinstance(node.func, ast.Name)
            and node.func.id == "Console"
        ]
        assert len(made) == (file.name == "terminal.py"), file.name


NAMED = {"name": "居間 \U0001f6cb"}
WORDS = ("arrange", "brief.json", "--steps", "50")


@pytest.mark.parametrize("encoding", ["cp1252", "ascii", "cp437", "utf-8"])
def test_what_an_encoding_cannot_hold_is_replaced(
    encoding: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("brief.json").write_text(json.dumps(sound_brief() | NAMED))
    for more in (["-o", "居間.json"], ["--json"]):
        out, err = io.BytesIO(), io.BytesIO()
        for name, kept in (("sys.stdout", out), ("sys.stderr", err)):
            stream = io.TextIOWrapper(kept, encoding, "replace", write_through=True)
            monkeypatch.setattr(name, stream)
        assert cli.run([*WORDS, *more]) in (0, 1), err.getvalue()
        assert b"Traceback" not in err.getvalue()
    assert Path("居間.json").exists()
    found = json.loads(out.getvalue().decode(encoding))
    assert found["input"] == "brief.json"


def test_a_process_replaces_what_its_encoding_cannot_hold(tmp_path: Path) -> None:
    (tmp_path / "brief.json").write_text(json.dumps(sound_brief() | NAMED))
    environment = os.environ | {
        "PYTHONIOENCODING": "ascii",
        "PYTHONPATH": os.pathsep.join(sys.path),
    }
    command = [sys.executable, "-m", "scenewright", *WORDS, "-o", "居間.json"]
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    assert b"Traceback" not in done.stderr
    assert (tmp_path / "居間.json").exists()


def test_cells_are_no_formulas(tmp_path: Path) -> None:
    rows = [
        make_failed_row("=cmd|' /C calc'!A0.json", 1.0, "+x()"),
        make_failed_row("@x.json", 1.0, "-x"),
        make_failed_row("\tx", -1.0, ""),
    ]
    write_summary(tmp_path, rows, BatchOptions((), "default", None, None, None, 0, False))
    with (tmp_path / CSV).open(encoding="utf-8", newline="") as file:
        cells = [cell for row in csv.reader(file) for cell in row]
    assert not [cell for cell in cells if cell.startswith(("=", "+", "@", "\t", "\r"))]
    assert [cell for cell in cells if cell.startswith("-")] == ["-1.0"]


def test_the_table_of_a_catalogue_is_no_formula_and_reads_back(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    folder = tmp_path / "models"
    folder.mkdir()
    for name in ("=1+1.obj", "@sofa.obj", "-chair.obj"):
        (folder / name).write_text(obj(Size(0.5, 0.5, 0.9)))
    ids = [one.model.id for one in read_entry(CatalogBrief(path=str(folder))).models]
    assert cli.run(["catalog", "show", "models", "-o", str(folder / "catalog.csv")]) == 0
    text = (folder / "catalog.csv").read_text(encoding="utf-8")
    for row in csv.reader(io.StringIO(text)):
        assert not [cell for cell in row if cell.startswith(("=", "+", "-", "@"))]
    assert [one.model.id for one in read_entry(CatalogBrief(path=str(folder))).models] == ids
