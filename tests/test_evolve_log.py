"""Logs of evolutions: what is damaged or no log is refused in one line and left as it is."""

from __future__ import annotations

import hashlib
import json
import os
import shutil
import sqlite3
import zlib
from collections.abc import Callable
from pathlib import Path

import pytest

from scenewright import cli
from scenewright.core.errors import InputError
from scenewright.engine.preference.events import Pick
from scenewright.workflow.evolution.log import EvolutionLog
from scenewright.workflow.evolution.log_file import MARK
from scenewright.workflow.evolution.population import BreedingPlan
from scenewright.workflow.evolve import evolve, resume_evolution

HOME = "sample:home-room"
FEW = BreedingPlan(first=4, each=2, rounds=1, brood=4)


@pytest.fixture(scope="module")
def sound(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The log of an evolution in which one was picked."""
    path = tmp_path_factory.mktemp("sound") / "my.evolution"
    with evolve(HOME, path, breeding=FEW) as evolution:
        shown = tuple(one.number for one in evolution.ask().candidates)
        evolution.tell(Pick(shown[1], shown))
    return path


@pytest.fixture
def log(sound: Path, tmp_path: Path) -> Path:
    return Path(shutil.copy(sound, tmp_path / "my.evolution"))


def run_sql(path: Path, *statements: str, values: tuple[object, ...] = ()) -> None:
    base = sqlite3.connect(path)
    for statement in statements:
        base.execute(statement, values)
    base.commit()
    base.execute("PRAGMA wal_checkpoint(TRUNCATE)")
    base.close()


def digest(folder: Path) -> dict[str, str]:
    return {p.name: hashlib.sha256(p.read_bytes()).hexdigest() for p in folder.iterdir()}


def test_a_log_is_marked_as_one(sound: Path) -> None:
    assert int.from_bytes(sound.read_bytes()[68:72], "big") == MARK
    with resume_evolution(sound) as again:
        assert len(again.events) == 1


def test_a_log_from_before_the_mark_goes_on(log: Path) -> None:
    run_sql(log, "PRAGMA application_id=0")
    with resume_evolution(log) as again:
        assert len(again.events) == 1
    assert int.from_bytes(log.read_bytes()[68:72], "big") == MARK


STRANGERS: dict[str, tuple[str, ...]] = {
    "places": ("CREATE TABLE moz_places (id INTEGER)",),
    "marked": ("CREATE TABLE a (b)", "PRAGMA application_id=7"),
    "more than a log": ("CREATE TABLE extra (id INTEGER)",),
    "trigger": ("CREATE TRIGGER t AFTER INSERT ON entry BEGIN DELETE FROM entry; END",),
    "view": ("DROP TABLE bred", "CREATE VIEW bred AS SELECT 0 AS number, '' AS epoch, '' AS body"),
}


@pytest.mark.parametrize("name", STRANGERS)
def test_a_strangers_database_is_not_touched(name: str, log: Path, tmp_path: Path) -> None:
    path = log if name in ("more than a log", "trigger", "view") else tmp_path / "places.sqlite"
    run_sql(path, *STRANGERS[name])
    before = digest(tmp_path)
    for action in (
        lambda: evolve(HOME, path, breeding=FEW),
        lambda: resume_evolution(path),
        lambda: EvolutionLog(path),
    ):
        with pytest.raises(InputError) as caught:
            action()
        assert "\n" not in str(caught.value)
    assert digest(tmp_path) == before


BODY = "UPDATE entry SET body = ? WHERE number = 0"
DAMAGES: dict[str, tuple[str, tuple[object, ...]]] = {
    "no object": (BODY, ("[1]",)),
    "no json": (BODY, ("{",)),
    "nested": (BODY, ("[" * 100_000,)),
    "number": (BODY, (b"\x00\xff",)),
    "shown": (BODY, (json.dumps({"screen": 0, "shown": [99], "predicted": [None]}),)),
    "uneven": (BODY, (json.dumps({"screen": 0, "shown": [0, 1], "predicted": []}),)),
    "kind": ("UPDATE entry SET kind = 'shrug' WHERE number = 0", ()),
    "gap": ("DELETE FROM entry WHERE number = 0", ()),
    "event": ("UPDATE entry SET body = ? WHERE number = 1", ('{"event": "keep"}',)),
    "stranger": (
        "UPDATE entry SET body = ? WHERE number = 1",
        ('{"event": "keep", "candidate": 99}',),
    ),
    "genome": ("UPDATE bred SET body = json_set(body, '$.genome', json('[1,2,999]'))", ()),
    "values": ("UPDATE bred SET body = json_set(body, '$.values', json('[1]'))", ()),
    "huge": ("UPDATE bred SET body = json_set(body, '$.values[0]', 1e300) WHERE number = 0", ()),
    "epoch": ("UPDATE bred SET epoch = 'x:;y' WHERE number = 0", ()),
    "bomb": ("UPDATE solution SET document = ?", (zlib.compress(b" " * 2**26),)),
    "rubbish": ("UPDATE solution SET document = ?", (b"rubbish",)),
    "text": ("UPDATE solution SET document = ?", ("text",)),
    "other": ("UPDATE solution SET document = ?", (zlib.compress(b'{"rooms": []}'),)),
    "brief": ("UPDATE about SET value = '{}' WHERE name = 'brief'", ()),
    "no brief": ("DELETE FROM about WHERE name = 'brief'", ()),
    "seed": ("UPDATE about SET value = '-1' WHERE name = 'seed'", ()),
    "breeding": ("UPDATE about SET value = '[1e9,1,1,1,1,1,1,1,1,1,1]' WHERE name='breeding'", ()),
    "form": ("UPDATE about SET value = '9' WHERE name = 'form'", ()),
}


@pytest.mark.parametrize("name", DAMAGES)
def test_a_damaged_log_costs_one_line(
    name: str, log: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    statement, values = DAMAGES[name]
    run_sql(log, statement, values=values)
    if name in ("genome",):
        run_sql(log, "DELETE FROM solution")
    out = tmp_path / "out.json"
    code = cli.run(["evolve", "--from", str(log), "-o", str(out), "--say", "1; next; done"])
    said = capsys.readouterr().err
    assert code == 2, said
    assert said.count("\n") == 1
    assert not out.exists()


@pytest.mark.parametrize("share", [0.05, 0.3, 0.6, 0.95])
def test_a_log_cut_off_is_refused(share: float, log: Path) -> None:
    log.write_bytes(log.read_bytes()[: int(share * log.stat().st_size)])
    with pytest.raises(InputError):
        resume_evolution(log)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs pipes with names")
def test_a_pipe_or_a_folder_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "pipe", tmp_path):
        for action in (resume_evolution, lambda path: evolve(HOME, path)):
            with pytest.raises(InputError):
                action(path)


Words = Callable[[Path], list[str]]


@pytest.mark.parametrize(
    "words",
    [
        lambda folder: ["--log", str(folder / "z.json"), "-o", str(folder / "z.json")],
        lambda folder: ["-o", str(folder / "a.png"), "--sheet", str(folder / "a.png")],
        lambda folder: ["--log", str(folder / "b-sheet.png"), "-o", str(folder / "b.json")],
        lambda folder: ["--log", str(folder / "c.json"), "-o", str(folder / "mine.evolution.json")],
    ],
)
def test_no_two_files_of_a_run_are_the_same(
    words: Words, sound: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copy(sound, tmp_path / "mine.evolution.json")
    before = digest(tmp_path)
    assert cli.run(["evolve", HOME, *words(tmp_path), "--say", "1; done"]) == 2
    assert capsys.readouterr().err.count("\n") == 1
    assert digest(tmp_path) == before
