"""The verb catalog: a table, a sheet, names, groups from homes; one line for a fault."""

from __future__ import annotations

import csv
import io
import json
from pathlib import Path

import pytest

from scenewright import cli
from scenewright.catalog.models import register
from scenewright.core.scene import Size
from test_catalogues import obj

Captured = pytest.CaptureFixture[str]
HOME = """<home version='7000' name='h' camera='topCamera' wallHeight='250'>
<pieceOfFurniture name='Double bed' x='200' y='105' width='160' depth='200' height='50'
 angle='3.1415927'/><pieceOfFurniture name='Nightstand' x='95' y='25' width='45' depth='40'
 height='50' angle='3.1415927'/><room name='Bedroom'><point x='0' y='0'/><point x='400' y='0'/>
<point x='400' y='400'/><point x='0' y='400'/></room></home>"""


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")
    monkeypatch.setenv("SCENEWRIGHT_HOME", str(tmp_path / "home"))
    Path("mine").mkdir()
    Path("mine", "sofa.obj").write_text(obj(Size(2.0, 0.9, 0.8)))
    Path("mine", "zorble.obj").write_text(obj(Size(0.4, 0.6, 0.5)))
    Path("mine", "broken.obj").write_text("v 1 2\nf 1 2 3\n")


def run(capsys: Captured, *arguments: str) -> str:
    assert cli.run(list(arguments)) == 0
    return capsys.readouterr().out


def fault(capsys: Captured, *arguments: str) -> str:
    assert cli.run(list(arguments)) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.count("\n") == 1
    return told.err


def test_show_tells_what_each_model_is_taken_for(capsys: Captured) -> None:
    told = run(capsys, "catalog", "show", "mine")
    assert "1 left out" in told
    assert "broken.obj" in told
    assert "1 model of 1 category, 1 used only where named, 1 skipped" in told
    document = json.loads(run(capsys, "catalog", "show", "mine", "--json"))
    assert [row["category"] for row in document["models"]] == ["sofa", "other"]
    assert (document["usable"], document["other"], document["skipped"]) == (1, 1, 1)


def test_the_table_written_is_a_table_read(capsys: Captured) -> None:
    run(capsys, "catalog", "show", "mine", "-o", "mine/catalog.csv")
    table = Path("mine", "catalog.csv")
    rows = list(csv.DictReader(io.StringIO(table.read_text())))
    assert [row["id"] for row in rows] == ["sofa", "zorble"]
    table.write_text(table.read_text().replace(",other,", ",pouf,"))
    document = json.loads(run(capsys, "catalog", "show", "mine", "--json"))
    assert document["categories"] == {"pouf": 1, "sofa": 1}


def test_a_sheet_of_pictures(capsys: Captured) -> None:
    assert "wrote sheet.png" in run(capsys, "catalog", "show", "mine", "-o", "sheet.png")
    assert Path("sheet.png").read_bytes().startswith(b"\x89PNG")


def test_add_list_and_use_by_name(capsys: Captured) -> None:
    assert "none yet" in run(capsys, "catalog", "list")
    added = json.loads(run(capsys, "catalog", "add", "mine", "--name", "ours", "--json"))
    assert (added["name"], added["usable"]) == ("ours", 1)
    (row,) = json.loads(run(capsys, "catalog", "list", "--json"))
    assert (row["name"], row["models"], row["usable"], row["there"]) == ("ours", 2, 1, True)
    assert "already" in fault(capsys, "catalog", "add", "mine", "--name", "ours")
    run(capsys, "catalog", "add", "mine", "--name", "ours", "--replace")
    Path("room.json").write_text(
        json.dumps(
            {
                "rooms": [
                    {
                        "function": "living",
                        "outline": [[0, 0], [5, 0], [5, 4], [0, 4]],
                        "doors": [{"at": [0, 0.8]}],
                    }
                ]
            }
        )
    )
    run(
        capsys,
        "arrange",
        "room.json",
        "--catalog",
        "ours",
        "-o",
        "out.json",
        "--steps",
        "200",
        "-q",
    )
    assert '"model:sofa"' in Path("out.json").read_text()


def test_a_catalogue_that_cannot_be_used_leaves_no_name(capsys: Captured) -> None:
    Path("empty").mkdir()
    assert "there are no model files" in fault(capsys, "catalog", "add", "empty")
    run(capsys, "catalog", "add", "mine", "--name", "ours")
    before = register.read_saved_files("ours")
    fault(capsys, "catalog", "add", "empty", "--name", "ours", "--replace")
    assert register.read_saved_files("ours") == before
    assert register.names() == ("ours",)


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["show", "nowhere"], "unknown file or catalogue 'nowhere'"),
        (["show", "mine", "--category", "sofas"], "holds no model of category 'sofas'"),
        (["show", "mine", "-o", "sheet.jpg"], "is neither .png nor .csv"),
        (["add", "mine", "--name", "../x"], "is not a valid name for a catalogue"),
        (["add", "nowhere"], "no such file or folder"),
        (["learn", "nowhere.xml", "-o", "g.json"], "nowhere.xml"),
        (["learn", "mine/sofa.obj", "-o", "g.json"], "mine/sofa.obj"),
    ],
)
def test_faults_are_one_line(capsys: Captured, arguments: list[str], told: str) -> None:
    assert told in fault(capsys, "catalog", *arguments)
    assert not Path("g.json").exists()


def test_learn_writes_groups_that_arrange_takes(capsys: Captured) -> None:
    Path("home.xml").write_text(HOME)
    assert "double bed, nightstand" in run(capsys, "catalog", "learn", "home.xml", "-o", "g.json")
    Path("room.json").write_text(
        json.dumps(
            {
                "groups": ["g.json"],
                "rooms": [
                    {
                        "function": "double_bedroom",
                        "outline": [[0, 0], [4, 0], [4, 4], [0, 4]],
                        "doors": [{"at": [0, 0.8]}],
                    }
                ],
            }
        )
    )
    run(capsys, "arrange", "room.json", "-o", "out.json", "--steps", "300", "-q")
    pieces = json.loads(Path("out.json").read_text())["pieces"]
    assert [p["size"] for p in pieces if p["category"] == "double_bed"] == [[1.6, 2.0, 0.5]]
    Path("g.json").write_text("{}")
    assert "not a file of learned groups" in fault(capsys, "arrange", "room.json", "-o", "x.json")
