"""The command line: exit codes, one line for every fault, whole files or none."""

from __future__ import annotations

import json
import os
import re
import signal
import sys
import threading
import time
from dataclasses import replace
from math import prod
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

import scenewright
from deadline import within
from flat import flat_brief, flat_solution
from scenewright import cli
from scenewright.cli import bench as cli_bench
from scenewright.cli import show
from scenewright.core.errors import InputError
from scenewright.core.report import Report
from scenewright.core.solution import LeftOut, Solution, TermValue
from scenewright.domains import plan_of
from scenewright.formats import brief_json, solution_json
from scenewright.workflow.events import run_to_end
from scenewright.workflow.writing import write_all

Captured = pytest.CaptureFixture[str]


@pytest.fixture(autouse=True)
def _in_an_empty_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "100")


def fault(capsys: Captured, *arguments: str, code: int = 2) -> str:
    """The one line a command that cannot work tells; stdout stays empty."""
    assert cli.run(list(arguments)) == code
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.startswith("scenewright: ")
    assert told.err.count("\n") == 1
    return told.err


def save_brief(**changes: Any) -> str:
    brief = flat_brief().model_copy(update=changes)
    Path("flat.json").write_text(brief_json.dumps(brief), encoding="utf-8")
    return "flat.json"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["arrange"], "INPUT"),
        (["frob"], "frob"),
        (["arrange", "sample:home-flat", "--seconds", "1", "--steps", "2"], "exclude each other"),
        (["arrange", "sample:home-flat", "--seconds", "nan"], "positive number"),
        (["arrange", "sample:home-flat", "--seconds", "inf"], "positive number"),
        (["arrange", "sample:home-flat", "--seconds", "-1"], "positive number"),
        (["arrange", "sample:home-flat", "--steps", "0"], "positive whole number"),
        (["arrange", "sample:home-flat", "--steps", "x"], "--steps"),
        (["arrange", "sample:home-flat", "--seconds", "abc"], "'--seconds': give a number;"),
        (["arrange", "home-flat"], "say sample:home-flat"),
        (["arrange", "sample:home-flat", "-o", "a.svg", "-o", "./a.svg"], "a.svg: is given twice"),
        (["arrange", "sample:home-flat", "--seed", "-1"], "--seed"),
        (["arrange", "a.json", "--style", "nordic", "--style=retro"], "--style is given twice"),
        (["arrange", "--seed=1", "a.json", "--seed", "1"], "--seed is given twice; give it once"),
        (["view", "a.glb", "-oa.png", "--output", "b.png"], "--output is given twice"),
        (["arrange", "sample:home-flat", "--preset", "papper"], "use one of: default"),
        (["arrange", "sample:home-flat", "--solver", "magic"], "use one of: anneal"),
        (["arrange", "sample:home-flat", "-o", "home.obj"], ".glb"),
        (["arrange", "sample:home-flat", "-o", "home"], "no suffix"),
        (["arrange", "sample:nowhere"], "sample:home-flat"),
        (["arrange", "missing"], "missing: there is no such file or folder"),
        (["arrange", "sample:hall-exhibition", "--accessible"], "--accessible is for homes"),
        (["arrange", "--batch", "sample:home-flat", "-o", "a.svg"], "give it with -o FOLDER"),
        (
            ["arrange", "--batch", "sample:home-flat", "-o", "all", "--format", "odd"],
            "--format: '.odd' files cannot be written",
        ),
        (["arrange", "missing.json"], "missing.json: there is no such file"),
        (["arrange", "plan.dwg"], "is a DWG drawing, which is not read; save it as .dxf"),
        (["arrange", "."], "is a folder; add --batch"),
        (["check", "missing.json"], "missing.json: there is no such file; check the path"),
        (
            ["check", "missing"],
            "missing: there is no such file; check the path; solutions are .json",
        ),
        (["explain", "missing"], "solutions are .json files"),
        (["adjust", "missing", "-o", "a.json"], "solutions are .json files"),
        (["check", "home.glb"], "home.glb: is not a Scenewright solution; give a solution .json"),
        (["explain", "missing.json"], "missing.json"),
        (["list", "wishes"], "use one of: solvers"),
        (["fold", "missing.glb"], "missing.glb: there is no such file; check the path"),
        (["schema", "poem"], "use one of: brief, solution"),
        (["warm", "castle"], "give home, hall, site"),
    ],
)
def test_what_cannot_work_is_one_line(arguments: list[str], told: str, capsys: Captured) -> None:
    assert told in fault(capsys, *arguments)
    assert list(Path().iterdir()) == []


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "is empty"),
        ("{", "broken JSON"),
        ('{"rooms": []}', "rooms"),
        ('{"rooms": [{"outline": [[0, 0], [4, 0], [0, 3], [4, 3]]}]}', "cross"),
        ('{"rooms": [{"outline": [[0, 0], [4, 0], [4, NaN]]}]}', "NaN"),
        ('{"rooms": [{"outline": [[0, 0], [4, 0], [4, 3]], "doors": [{"at": [9, 9]}]}]}', "door"),
    ],
)
def test_a_bad_brief_is_one_line_and_writes_nothing(text: str, told: str, capsys: Captured) -> None:
    Path("bad.json").write_text(text)
    found = fault(capsys, "arrange", "bad.json", "-o", "out/home.svg")
    assert "bad.json" in found
    assert told in found
    assert os.listdir() == ["bad.json"]


def test_a_brief_is_no_solution_and_is_not_replaced(capsys: Captured) -> None:
    source = save_brief()
    text = Path(source).read_text()
    for verb in ("check", "explain"):
        assert "is not a solution but a brief; arrange it first" in fault(capsys, verb, source)
    replaced = fault(capsys, "arrange", "sample:home-room", "-o", source)
    assert "is a brief and would be replaced; give -o another name" in replaced
    assert Path(source).read_text() == text


def test_version_and_help(capsys: Captured) -> None:
    assert cli.run(["--version"]) == 0
    assert capsys.readouterr().out == f"scenewright {scenewright.__version__}\n"
    assert cli.run(["--help"]) == 0
    out = capsys.readouterr().out
    assert all(verb in out for verb in ("arrange", "check", "explain", "bench", "list", "schema"))


def test_arrange_check_explain_and_arrange_again(capsys: Captured) -> None:
    source = save_brief()
    code = cli.run(
        [
            "arrange",
            source,
            "-o",
            "new/home.json",
            "-o",
            "new/home.svg",
            "--steps",
            "2000",
            "--json",
        ]
    )
    document = json.loads(capsys.readouterr().out)
    assert code == document["exit"]
    assert sorted(os.listdir("new")) == ["home.json", "home.svg"]
    assert {room["id"] for room in document["rooms"]} == {"living", "bedroom"}
    assert "tv_stand" in document["rooms"][0]["pieces"]
    assert (document["preset"], document["seed"]) == ("default", 0)
    valid = cli.run(["check", "new/home.json", "--json"])
    assert json.loads(capsys.readouterr().out)["findings"] == document["check"]["findings"]
    assert (valid == 0) == document["check"]["valid"]
    assert cli.run(["explain", "new/home.json", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["terms"]
    relock(Path("new/home.json"))


def relock(path: Path) -> None:
    """The largest piece, locked in the file, stays to the bit while another seed moves others."""
    document = json.loads(path.read_text())
    locked = max(document["pieces"], key=lambda piece: prod(piece["size"]))
    locked["fixed"] = True
    path.write_text(json.dumps(document))
    assert cli.run(
        ["arrange", str(path), "-o", "again.json", "--steps", "2000", "--seed", "9", "-q"]
    ) in (0, 1)
    again = solution_json.read("again.json")
    same = next(piece for piece in again.pieces if piece.id == locked["id"])
    assert [*same.pose] == locked["pose"]
    assert [*same.size] == locked["size"]
    assert same.fixed


def test_the_same_seed_gives_the_same_pieces(capsys: Captured) -> None:
    source = save_brief()
    for name in ("a.json", "b.json"):
        cli.run(["arrange", source, "-o", name, "--steps", "2000", "--seed", "5", "--quiet"])
    told = capsys.readouterr()
    assert (told.out, told.err) == ("", "")
    first, second = (solution_json.read(name) for name in ("a.json", "b.json"))
    assert first.pieces == second.pieces
    assert first.energies == second.energies


def test_the_table_tells_rooms_reasons_and_verdict(capsys: Captured) -> None:
    """A room too small for what is asked: files are written, the exit code is 1."""
    room = (
        flat_brief()
        .rooms[1]
        .model_copy(
            update={"outline": [(0, 0), (1.2, 0), (1.2, 1.3), (0, 1.3)], "fixed": [], "windows": []}
        )
    )
    source = save_brief(rooms=[room])
    assert cli.run(["arrange", source, "-o", "home.json", "--steps", "1000"]) == 1
    out = capsys.readouterr().out
    assert re.search(r"^not placed: .* \(Bedroom\): ", out, re.M)
    assert "wrote home.json" in out
    assert "Bedroom" in out.splitlines()[4]


def test_missing_things_are_told_in_plain_words(solution: Solution, capsys: Captured) -> None:
    """Missing and merely welcome have other words; what is said thrice is one line."""
    bed = LeftOut("bedroom", "sleeping", "no space", True)
    plant = LeftOut("living", "plant", "no corner", False)
    show.print_explanation(
        Console(),
        replace(
            solution,
            left_out=(bed, bed, bed, plant),
            terms=(
                TermValue("living", "seating", "overlap", 1e-9, 600, 6e-7),
                TermValue("living", "seating", "route", 0.5, 100, 50),
            ),
        ),
        with_terms=True,
    )
    out = capsys.readouterr().out
    assert "not placed: 3 × double bed (Bedroom): no space\n" in out
    assert "optional, not placed: plant (Living room): no corner\n" in out
    assert "overlap" not in out
    assert "\nroute: " in out


def test_keep_without_furniture_is_noted(capsys: Captured) -> None:
    source = save_brief()
    for more, noted in (([], True), (["-q"], False)):
        cli.run(["arrange", source, "--keep", "--steps", "500", *more])
        assert ("--keep has no effect" in capsys.readouterr().err) is noted


def test_seconds_with_a_seed_are_noted(capsys: Captured) -> None:
    for more, noted in (["--seconds", "0.01"], True), (["--steps", "10"], False):
        cli.run(["arrange", save_brief(), "--seed", "1", *more])
        assert ("ends by the clock" in capsys.readouterr().err) is noted


def test_the_look_of_a_home_is_told_with_what_chose_it(capsys: Captured) -> None:
    """A style or palette that nobody named may be another with another seed."""
    drawn = named = flat_solution()
    named = replace(named, brief=named.brief.model_copy(update={"style": "nordic fjord"}))
    for solution, told in ((drawn, " (drawn by seed 7)"), (named, "style nordic, palette fjord")):
        plan = plan_of(solution.brief)
        show.print_arranged(Console(), [], solution, plan, Report(()))
        line = next(line for line in capsys.readouterr().out.splitlines() if "palette" in line)
        assert line.endswith(told)


def test_nothing_asked_shows_the_help_only(capsys: Captured) -> None:
    assert cli.run([]) == 2
    told = capsys.readouterr()
    assert "arrange" in told.out
    assert told.err == ""


def test_check_tells_every_violation(solution: Solution, capsys: Captured) -> None:
    solution_json.write(solution, "good.json")
    document = solution_json.to_document(solution)
    document["pieces"][2]["pose"] = document["pieces"][0]["pose"]
    Path("bad.json").write_text(json.dumps(document))
    assert cli.run(["check", "bad.json"]) == 1
    out = capsys.readouterr().out
    assert "not valid" in out
    assert "collision" in out
    assert cli.run(["check", "bad.json", "--quiet"]) == 1
    assert capsys.readouterr().out == ""


def test_schemas_accept_what_is_written(solution: Solution, capsys: Captured) -> None:
    jsonschema = pytest.importorskip("jsonschema")
    for what, text in (
        ("brief", brief_json.dumps(solution.brief)),
        ("solution", solution_json.dumps(solution)),
    ):
        assert cli.run(["schema", what]) == 0
        jsonschema.validate(json.loads(text), json.loads(capsys.readouterr().out))


def test_markup_in_names_is_printed_as_it_is(capsys: Captured) -> None:
    source = save_brief(name="[red]home[/red] [/nothing]")
    assert cli.run(["arrange", source, "--steps", "500"]) in (0, 1)
    assert "[red]home[/red] [/nothing]" in capsys.readouterr().out


def test_all_files_or_none(tmp_path: Path) -> None:
    """The second output cannot be written: the first does not appear, the old one stays."""
    Path("home.json").write_text("old")
    Path("taken").write_text("a file where a folder is wanted")
    paths = [Path("home.json"), Path("taken/home.svg")]
    files = write_all([(flat_solution(), path) for path in paths])
    with pytest.raises(InputError, match=r"^taken.home.svg: cannot be written"):
        run_to_end(files)
    assert Path("home.json").read_text() == "old"
    assert sorted(os.listdir()) == ["home.json", "taken"]


def test_what_a_file_cannot_hold_is_said_before_solving(
    capsys: Captured, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("scenewright.domains.solve", None)
    told = fault(capsys, "arrange", "sample:home-studio", "-o", str(tmp_path / "a.cityjson"))
    assert "only sites can be written as .cityjson" in told


def test_a_fault_of_ours_is_one_line_and_three(
    capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cli.tables, "table", None)
    assert "internal error, please report" in fault(capsys, "list", "formats", code=3)
    monkeypatch.setenv("SCENEWRIGHT_DEBUG", "1")
    with pytest.raises(TypeError):
        cli.run(["list", "formats"])


def test_benchmarks_are_found_from_the_checkout(
    root: Path, capsys: Captured, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert cli_bench.find_folder() == root / "benchmarks"
    folder = Path("src/scenewright")
    folder.mkdir(parents=True)
    Path("benchmarks").mkdir()
    Path("benchmarks/__init__.py").touch()
    long = "a case that is told at such length that no narrow table holds it in one line of eighty"
    record = {
        "case": long,
        "metric": "time",
        "unit": "s",
        "ours": 1.0,
        "baseline": 2.0,
        "baseline_name": "it",
        "ratio": 2.0,
        "runs": 3,
    }
    Path("benchmarks/tiny.py").write_text(
        f"def records(quick=False, progress=None):\n    progress(1.0, 'a')\n    return [{record}]\n"
    )
    monkeypatch.setattr(sys, "path", list(sys.path))
    for name in [name for name in sys.modules if name.partition(".")[0] == "benchmarks"]:
        monkeypatch.delitem(sys.modules, name)
    assert cli.run(["bench", "tiny", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == [record]
    assert cli.run(["bench", "tiny"]) == 0
    told = capsys.readouterr().out
    assert re.search(f"{long} +time", told), "in a file a row is a line"
    assert "use one of: tiny" in fault(capsys, "bench", "huge")
    sys.modules.pop("benchmarks.tiny", None)
    sys.modules.pop("benchmarks", None)


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_interrupting_keeps_the_best_so_far(capsys: Captured) -> None:
    """Ctrl-C while solving for ten minutes ends soon and writes what was found."""
    before = signal.getsignal(signal.SIGINT)

    def interrupt() -> None:
        while signal.getsignal(signal.SIGINT) is before:
            time.sleep(0.01)
        time.sleep(0.5)
        os.kill(os.getpid(), signal.SIGINT)

    thread = threading.Thread(target=interrupt, daemon=True)
    thread.start()
    with within(120):
        code = cli.run(["arrange", save_brief(), "-o", "home.json", "--seconds", "600"])
    thread.join()
    assert code == 130
    told = capsys.readouterr()
    assert told.err == "scenewright: interrupted: best so far written\n"
    assert "(interrupted: best so far)" in told.out
    assert signal.getsignal(signal.SIGINT) is before
    assert solution_json.read("home.json").pieces
