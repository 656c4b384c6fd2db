"""The prompt of ``evolve``: every form is understood, bad ones get one line, and a run writes."""

from __future__ import annotations

import io
import json
import os
import re
import time
from pathlib import Path
from threading import Thread

import pytest

import scenewright as sw
from scenewright import cli
from scenewright.core.errors import InputError
from scenewright.engine.preference.events import (
    Event,
    Keep,
    Lock,
    Pick,
    Prefer,
    Reason,
    Stars,
    Worst,
)
from scenewright.workflow.evolution.population import BreedingPlan
from scenewright.workflow.evolution.words import FORMS, HELP, Command, parse_line
from scenewright.workflow.evolve import evolve

SHOWN = (10, 11, 12, 13)
REASONS = ("too dense", "more sun", "more trees")
HOME = "sample:home-room"
FEW = BreedingPlan(first=8, each=4, rounds=1, brood=8)


def begin(log: Path) -> None:
    """A log that a run goes on with, so that it breeds a few candidates only."""
    evolve(HOME, log, breeding=FEW).close()


def parse(line: str, said: tuple[Event, ...] = (), champion: int | None = None) -> object:
    return parse_line(line, SHOWN, 2, said, REASONS, champion)


@pytest.mark.parametrize(
    ("line", "meant"),
    [
        ("3", (Pick(12, SHOWN),)),
        ("  3  ", (Pick(12, SHOWN),)),
        ("3 > 1", (Prefer(12, 10),)),
        ("3>1>2", (Prefer(12, 10), Prefer(10, 11))),
        ("worst 4", (Worst(13, SHOWN),)),
        ("WORST 4", (Worst(13, SHOWN),)),
        ("3=5", (Stars(12, 5, 2),)),
        ("3 = 1", (Stars(12, 1, 2),)),
        ("why 3 too dense", (Reason(12, "too dense"),)),
        ("why 3 dense", (Reason(12, "too dense"),)),
        ("why 3 More Sun", (Reason(12, "more sun"),)),
        ("lock church", (Lock("church"),)),
        ("lock Bedroom/bed 2", (Lock("Bedroom/bed 2"),)),
        ("keep 2", (Keep(11),)),
        ("undo", Command("undo")),
        ("", Command("next")),
        ("n", Command("next")),
        ("next", Command("next")),
        ("done", Command("done")),
        ("quit", Command("quit")),
        ("help", Command("help")),
        ("?", Command("help")),
        ("reasons", Command("reasons")),
        ("best", Command("best")),
        ("names", Command("names")),
        ("auto 3", Command("auto", 3)),
        ("move 2 sofa 1.5,-2", Command("move", 11, "sofa", (1.5, -2.0))),
        ("move 2 sofa 1.5,2,90", Command("move", 11, "sofa", (1.5, 2.0, 90.0))),
    ],
)
def test_every_form_is_understood(line: str, meant: object) -> None:
    assert parse(line) == meant


def test_the_champion_is_kept_without_a_number() -> None:
    assert parse("keep", champion=44) == (Keep(44),)
    with pytest.raises(InputError, match="no champion yet"):
        parse("keep")


def test_a_second_pick_is_the_best_of_the_rest() -> None:
    said: tuple[Event, ...] = (Pick(12, SHOWN), Worst(10, (10, 11, 13)))
    assert parse("2", said) == (Pick(11, (11, 13)),)
    assert parse("3", said) == (Pick(12, SHOWN),)


BAD = """0|5|3 >|> 3|3 > 9|3=|why 3|why 3 purple|why 3 more|lock|keep x|auto|auto x|move 1 sofa
move 1 sofa 1|move 1 sofa 1,-,2|hello|3 4|-1|=3|worst|3, drop|99999999999999999999999|\x1b[2J"""


@pytest.mark.parametrize("line", re.split(r"[|\n]", BAD))
def test_bad_forms_get_one_line(line: str) -> None:
    with pytest.raises(InputError) as caught:
        parse(line)
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 250


def test_the_help_tells_every_form() -> None:
    for word in FORMS.replace("sofa", "NAME").replace("too dense", "WORDS").split(" · "):
        assert word in " ".join(HELP.split()), word


def test_a_conversation_writes_the_champion(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    begin(tmp_path / "room.evolution")
    said = "2\nwhat\nwhy 1 dense\n3 > 1\n4=2\n\n1\nundo\nkeep\ndone\nnever read\n"
    monkeypatch.setattr("sys.stdin", io.StringIO(said))
    assert cli.run(["evolve", HOME, "-o", "room.json", "-o", "room.svg"]) == 0
    told = capsys.readouterr()
    assert "cannot read 'what'" in told.err
    assert "1: too dense" in told.err
    assert "taken back: 1 is the best" in told.err
    assert "wrote room.svg" in told.out
    assert {f.name for f in tmp_path.iterdir()} == {
        "room.json", "room.svg", "room.evolution", "room-sheet.png",
    }  # fmt: skip
    assert sw.check(sw.read_solution("room.json")).valid
    assert cli.run(["evolve", "--from", "room.evolution", "--json", "--say", "quit"]) == 0
    document = json.loads(capsys.readouterr().out)
    kinds = [event["event"] for event in document["events"]]
    assert kinds == ["pick", "reason", "prefer", "stars", "keep"]
    assert document["champion"]["candidate"] == document["events"][-1]["candidate"]


def test_the_best_so_far_is_drawn_while_the_person_thinks(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """At a terminal the picture appears before the next line is typed."""
    pty = pytest.importorskip("pty")
    monkeypatch.chdir(tmp_path)
    begin(tmp_path / "room.evolution")
    leader, follower = pty.openpty()
    picture = tmp_path / "room-best.png"

    def type_slowly() -> None:
        os.write(leader, b"2\n1\n")
        os.write(leader, b"next\n3\n")
        deadline = time.monotonic() + 60.0
        while not picture.exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        os.write(leader, b"best\nquit\n")

    typist = Thread(target=type_slowly)
    with os.fdopen(follower) as terminal:
        monkeypatch.setattr("sys.stdin", terminal)
        typist.start()
        assert cli.run(["evolve", HOME, "-o", "room.json"]) == 0
        typist.join()
    os.close(leader)
    assert picture.read_bytes()[:4] == b"\x89PNG"


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ([], "nothing to evolve"),
        ([HOME, "--from", "x.evolution"], "exclude each other"),
        (["--from", "x.evolution"], "does not exist"),
        ([HOME, "--sheet", "sheet.jpg"], "sheets are .png files"),
        ([HOME, "-o", "plan.xyz"], "plan.xyz"),
        ([HOME, "--say", "done"], "no champion to write"),
        ([HOME, "--say", "3; hop", "--log", "begun.evolution"], "cannot read 'hop'"),
    ],
)
def test_what_cannot_be_done_is_one_line(
    arguments: list[str],
    told: str,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(tmp_path)
    if "begun.evolution" in arguments:
        begin(tmp_path / "begun.evolution")
    assert cli.run(["evolve", *arguments]) == 2
    errors = capsys.readouterr().err.strip().splitlines()
    assert told in errors[-1]
    assert not list(tmp_path.glob("plan*"))
