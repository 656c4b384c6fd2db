"""Batches: nothing lost, doubled or half-written, whatever is killed."""

from __future__ import annotations

import csv
import json
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path
from threading import Event
from typing import Any

import pytest

import scenewright as sw
from scenewright.batch.jobs import BatchOptions, Job, Limits, list_jobs
from scenewright.batch.ledger import NAME, PARTS, Ledger
from scenewright.batch.table import COMPLETE, FAILED, ResultRow
from scenewright.batch.worker import Place
from scenewright.batch.worker_pool import WorkerPool
from scenewright.cli import run
from scenewright.core.errors import InputError
from thoroughness import few_or_many

OPTIONS = BatchOptions((".json",), "default", None, None, 200, 0, False)
PROGRAM = """
import sys, scenewright as sw
sw.batch(sys.argv[1], sys.argv[2], jobs=1, steps=200)
"""


def small(width: float = 2.0) -> dict[str, Any]:
    """A toilet of some width that is furnished in milliseconds."""
    outline = [[0, 0], [width, 0], [width, 2], [0, 2]]
    door = {"at": [width / 2, 0], "width": 0.8, "swing": "out"}
    return {"rooms": [{"name": "WC", "function": "toilet", "outline": outline, "doors": [door]}]}


def briefs(folder: Path, count: int) -> Path:
    folder.mkdir()
    for k in range(count):
        (folder / f"wc-{k:02}.json").write_text(json.dumps(small(1.6 + 0.1 * k)))
    return folder


def read(folder: Path) -> dict[str, Any]:
    """Every scene in a folder of results."""
    found = {}
    for path in folder.glob("*.json"):
        if path.name != "summary.json":
            found[path.name] = json.loads(path.read_text())
    return found


def workers(parent: int) -> list[int]:
    """Process ids of the workers of a process."""
    found = []
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            line = (status.parent / "cmdline").read_bytes()
            told = status.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(told[1]) == parent and b"scenewright.batch.worker" in line and told[0] != "Z":
            found.append(int(status.parent.name))
    return found


def test_names_of_results_are_never_shared(tmp_path: Path) -> None:
    (tmp_path / "a" / "sub").mkdir(parents=True)
    for name in ("flat.json", "flat.sh3d", "Flat.xml", "sub/flat.json", "summary.json", ".x.json"):
        (tmp_path / "a" / name).write_text("{}")
    (tmp_path / "b.txt").write_text("")
    orders = list_jobs(
        [tmp_path / "a", tmp_path / "a" / "flat.json", tmp_path / "b.txt"],
        tmp_path / "out",
        OPTIONS,
    )
    assert [o.name for o in orders] == [
        "Flat.xml",
        "flat.json",
        "flat.sh3d",
        "summary-2",
        "sub/flat",
        "b",
    ]


def test_a_key_changes_with_content_and_options_only(tmp_path: Path) -> None:
    file = tmp_path / "a.json"
    file.write_text("{}")
    first = list_jobs([file], tmp_path / "out", OPTIONS)[0].key
    os.utime(file, (1, 1))
    assert list_jobs([file], tmp_path / "out", OPTIONS)[0].key == first
    assert list_jobs([file], tmp_path / "out", OPTIONS._replace(seed=1))[0].key != first
    file.write_text("{} ")
    assert list_jobs([file], tmp_path / "out", OPTIONS)[0].key != first


def test_a_key_changes_with_the_catalogues_a_brief_names(tmp_path: Path) -> None:
    file, models = tmp_path / "in" / "a.json", tmp_path / "in" / "models"
    models.mkdir(parents=True)
    (models / "chair.obj").write_text("v 0 0 0")
    (tmp_path / "own.groups.json").write_text("{}")
    file.write_text(
        json.dumps({**small(), "catalogs": ["models"], "groups": ["../own.groups.json"]})
    )
    plain = tmp_path / "in" / "b.json"
    plain.write_text(json.dumps(small()))

    def keys(options: BatchOptions = OPTIONS) -> list[str]:
        return [order.key for order in list_jobs([file, plain], tmp_path / "out", options)]

    first = keys()
    assert keys() == first
    (models / "chair.obj").write_text("v 0 0 0 ")
    second = keys()
    assert second[0] != first[0]
    assert second[1] == first[1]
    (tmp_path / "own.groups.json").write_text("{ }")
    third = keys()
    assert third[0] != second[0]
    assert third[1] == first[1]
    further = OPTIONS._replace(catalogs=(str(models),))
    fourth = keys(further)
    (models / "table.obj").write_text("v 0 0 0")
    assert not set(keys(further)) & set(fourth)


def test_one_bad_file_stops_nobody_and_what_is_done_is_not_done_again(tmp_path: Path) -> None:
    folder, out = briefs(tmp_path / "in", 3), tmp_path / "out"
    (folder / "broken.json").write_text("{")
    before: list[bool] = []

    def heard(row: ResultRow, done: int, total: int, was: bool) -> None:
        before.append(was)

    rows = sw.batch(folder, out, jobs=2, steps=200, progress=heard)
    assert [Path(r.file).name for r in rows] == [
        "broken.json",
        "wc-00.json",
        "wc-01.json",
        "wc-02.json",
    ]
    assert [r.status for r in rows] == [FAILED, COMPLETE, COMPLETE, COMPLETE]
    assert "broken.json: " in rows[0].message
    assert rows[0].outputs == ()
    lines = list(csv.reader((out / "summary.csv").read_text().splitlines()))
    assert [line[0] for line in lines[1:]] == [row.file for row in rows]
    document = json.loads((out / "summary.json").read_text())
    assert document["totals"] == {"complete": 3, "left out": 0, "not valid": 0, "failed": 1}
    (folder / "broken.json").write_text(json.dumps(small()))
    (folder / "wc-01.json").write_text(json.dumps(small(2.2)))
    (out / "wc-02.json").unlink()
    before.clear()
    again = sw.batch(folder, out, jobs=1, steps=200, progress=heard)
    assert sorted(before) == [False, False, False, True]
    assert [r.status for r in again] == [COMPLETE] * 4
    assert again[1] == rows[1]
    assert sorted(p.name for p in out.iterdir()) == sorted(
        [NAME, "summary.csv", "summary.json", *(p.name for p in folder.iterdir())]
    )


def test_a_killed_batch_loses_and_doubles_nothing(tmp_path: Path) -> None:
    kills, count = few_or_many(1, 5), few_or_many(10, 24)
    folder, out, whole = briefs(tmp_path / "in", count), tmp_path / "out", tmp_path / "whole"
    sw.batch(folder, whole, jobs=1, steps=200)
    draw, alive, was_done = random.Random(1), 0, []
    for _ in range(kills):
        process = subprocess.Popen([sys.executable, "-c", PROGRAM, str(folder), str(out)])
        done = len(read(out)) if out.exists() else 0
        end = time.monotonic() + 300
        while time.monotonic() < end and len(read(out) if out.exists() else ()) < done + 3:
            time.sleep(0.01)
            if process.poll() is not None:
                break
        time.sleep(0.05 * draw.random())
        alive += process.poll() is None
        process.send_signal(signal.SIGKILL)
        process.wait()
        assert len(read(out)) >= done
        assert all(scene["pieces"] for scene in read(out).values())
    assert alive >= few_or_many(1, 3), "hardly anything was killed"
    kept = len(read(out))
    rows = sw.batch(
        folder,
        out,
        jobs=1,
        steps=200,
        progress=lambda _row, _done, _total, was: was_done.append(was),
    )
    assert sum(was_done) >= kept - alive, "each kill undoes one file at most"
    assert [row.status for row in rows] == [COMPLETE] * count
    assert len({row.file for row in rows}) == count
    assert read(out) == read(whole)
    sw.batch(folder, out, jobs=1, steps=200)  # removes what a worker left that outlived its run
    assert not [path for path in out.iterdir() if PARTS.fullmatch(path.name)]


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="finds workers by /proc")
def test_killed_workers_lose_and_double_nothing(tmp_path: Path) -> None:
    folder, told, killed = briefs(tmp_path / "in", 8), [], []

    def heard(row: ResultRow, done: int, total: int, was: bool) -> None:
        told.append(row)
        if done == 2:
            killed.extend(workers(os.getpid()))
            for worker in killed:
                os.kill(worker, signal.SIGKILL)

    rows = sw.batch(folder, tmp_path / "out", jobs=2, steps=200, progress=heard)
    assert [row.status for row in rows] == [COMPLETE] * 8
    assert len(told) == 8
    assert len(killed) == 2
    assert workers(os.getpid()) == []


def test_a_file_that_kills_twice_or_takes_too_long_is_to_blame(tmp_path: Path) -> None:
    options, place = OPTIONS._replace(steps=10_000_000), Place(str(tmp_path))
    order = Job("sample:home-flat", "flat", (tmp_path / "flat.json",), "")
    with WorkerPool(1, Limits(1, 4.0, 60.0), options, place) as crew:
        future = crew.give(order)
        for _ in range(2):
            while not crew.asking():
                time.sleep(0.05)
            crew.asking()[0].kill()
            time.sleep(0.3)
        row = future.result()[1]
    assert row.status == FAILED
    assert "killed its worker 2 times (signal 9)" in row.message
    with WorkerPool(1, Limits(1, 4.0, 1.0), options, place) as crew:
        row = crew.give(order).result()[1]
    assert row.message == "sample:home-flat: took longer than 1 s; allow more with --limit"
    assert not (tmp_path / "flat.json").exists()


def test_cancelling_keeps_what_is_done(tmp_path: Path) -> None:
    folder, enough = briefs(tmp_path / "in", 30), Event()
    rows = sw.batch(
        folder,
        tmp_path / "out",
        jobs=2,
        steps=200,
        progress=lambda _, done, *__: enough.set() if done > 2 else None,
        cancel=enough.is_set,
    )
    assert 3 <= len(rows) < 30
    assert {f"wc-{k:02}.json" for k in range(30)} >= set(read(tmp_path / "out"))
    assert len(read(tmp_path / "out")) >= len(rows)


def test_a_line_cut_off_in_the_ledger_is_passed_over(tmp_path: Path) -> None:
    order = Job("a.json", "a", (), "key")
    row = ResultRow("a.json", COMPLETE, 1.0, 2, 0, 0, "", ())
    with Ledger(tmp_path) as ledger:
        ledger.write(order, row)
        with pytest.raises(InputError, match="another batch"), Ledger(tmp_path):
            pass
    with (tmp_path / NAME).open("a") as file:
        file.write('{"name": "b", "ke')
    with Ledger(tmp_path) as ledger:
        assert ledger.find(order) == row
        ledger.write(order._replace(name="b"), row)
    with Ledger(tmp_path) as ledger:
        assert ledger.find(order._replace(name="b")) == row
        assert ledger.find(order._replace(key="other")) is None


def test_results_that_were_emptied_or_changed_are_done_again(tmp_path: Path) -> None:
    folder, out, before = briefs(tmp_path / "in", 4), tmp_path / "out", list[bool]()
    rows = sw.batch(folder, out, jobs=1, steps=200)
    whole = read(out)
    (out / "wc-00.json").write_bytes(b"")
    text = (out / "wc-01.json").read_text()
    (out / "wc-01.json").write_text(text.replace("2", "3", 1))
    (out / "wc-02.json").unlink()
    (out / "wc-02.json").mkdir()
    (out / "wc-02.json").rmdir()
    again = sw.batch(
        folder, out, jobs=1, steps=200, progress=lambda *heard: before.append(heard[3])
    )
    assert sorted(before) == [False, False, False, True]
    assert read(out) == whole
    assert [row.status for row in again] == [row.status for row in rows]


def test_folders_and_files_of_others_stay(tmp_path: Path) -> None:
    """A folder of the user's is never removed, whatever it is called; what a killed batch has left
    is."""
    folder, out = briefs(tmp_path / "in", 1), tmp_path / "out"
    for name in (".parts", ".scenewright-parts-" + "0" * 16, ".scenewright-parts-" + "1" * 16):
        (out / name).mkdir(parents=True)
    (out / ".parts" / "mine.txt").write_text("mine")
    left, shared = (out / f".scenewright-parts-{digit * 16}" for digit in "01")
    for place in (left, shared):
        (place / (".scenewright-" + "a" * 16 + ".json")).write_text("half")
    (shared / "mine.txt").write_text("mine")
    sw.batch(folder, out, jobs=1, steps=200)
    assert (out / ".parts" / "mine.txt").read_text() == "mine"
    assert not left.exists()
    assert [path.name for path in shared.iterdir()] == ["mine.txt"]


@pytest.mark.parametrize("kind", ["link", "text", "pipe", "folder"])
def test_a_ledger_that_is_none_is_left_alone(kind: str, tmp_path: Path) -> None:
    folder, out = briefs(tmp_path / "in", 1), tmp_path / "out"
    out.mkdir()
    mine = tmp_path / "mine.txt"
    mine.write_text("my own notes\n")
    if kind == "link":
        (out / NAME).symlink_to(mine)
    elif kind == "text":
        (out / NAME).write_text("my own notes\n")
    elif kind == "folder":
        (out / NAME).mkdir()
    else:
        os.mkfifo(out / NAME)
    with pytest.raises(InputError) as caught:
        sw.batch(folder, out, jobs=1, steps=200)
    assert "\n" not in str(caught.value)
    assert mine.read_text() == "my own notes\n"
    assert {path.name for path in out.iterdir()} == {NAME}


DAMAGED = (
    b"[1]", b"null", b"{}", b"[" * 100_000, b"\x00" * 90, b"\xff\xfe", b'"' + b"x" * 300_000,
    b'{"name": 1}', b'{"name": "a", "key": "key", "outputs": 5}',
)  # fmt: skip


@pytest.mark.parametrize("number", range(len(DAMAGED)))
def test_damaged_lines_of_a_ledger_are_passed_over(number: int, tmp_path: Path) -> None:
    order = Job("a.json", "a", (), "key")
    row = ResultRow("a.json", COMPLETE, 1.0, 2, 0, 0, "", ())
    with Ledger(tmp_path) as ledger:
        ledger.write(order, row)
    with (tmp_path / NAME).open("ab") as file:
        file.write(DAMAGED[number] + b"\n")
    for key, value in (("status", "done"), ("seconds", "x"), ("outputs", [1, 2]), ("pieces", -1)):
        with (tmp_path / NAME).open("ab") as file:
            known = {"name": "a", "key": "key", **row._asdict(), "files": [], key: value}
            file.write(json.dumps(known).encode() + b"\n")
    with Ledger(tmp_path) as ledger:
        assert ledger.find(order) == row


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["{in}", "-o", "{out}", "--preset", "none"], "unknown preset"),
        (["{in}", "-o", "{out}", "--format", "docx"], "cannot be written"),
        (["{in}", "-o", "{out}", "--memory", "-1"], "memory -1 is not possible"),
        (["{in}", "-o", "{out}", "--alternatives", "2"], "exclude each other"),
        (["{in}", "-o", "{in}"], "is where the results go"),
        (["{in}"], "into one folder"),
        (["{none}", "-o", "{out}"], "no files to lay out"),
    ],
)
def test_what_a_batch_cannot_do_is_told_in_one_line(
    words: list[str], told: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    places = {"in": str(briefs(tmp_path / "in", 1)), "out": str(tmp_path / "out")}
    places["none"] = str(tmp_path / "none")
    (tmp_path / "none").mkdir()
    assert run(["arrange", "--batch", *(word.format(**places) for word in words)]) == 2
    said = capsys.readouterr().err
    assert told in said
    assert said.count("\n") == 1
    assert not (tmp_path / "out").exists()


def test_words_of_a_batch_need_it(capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["arrange", "a.json", "b.json"]) == 2
    assert "add --batch" in capsys.readouterr().err
    assert run(["arrange", "a.json", "--jobs", "2"]) == 2
    assert "add --batch" in capsys.readouterr().err


def test_exit_codes_and_the_table(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder, out = briefs(tmp_path / "in", 1), str(tmp_path / "out")
    words = ["arrange", "--batch", "-o", out, "--steps", "200"]
    assert run([*words, str(folder), "--quiet"]) == 0
    assert capsys.readouterr().out == ""
    (folder / "bad.json").write_text("[]")
    assert run([*words, str(folder), "--json"]) == 1
    assert json.loads(capsys.readouterr().out)["totals"]["failed"] == 1
    assert run([*words, str(folder / "bad.json")]) == 2
    assert "bad.json" in capsys.readouterr().out


@pytest.mark.skipif(sys.platform != "linux", reason="bounds a process as Linux does")
def test_too_little_memory_is_told_as_such(tmp_path: Path) -> None:
    (row,) = sw.batch("sample:home-flat", tmp_path / "out", steps=200, memory=0.06, limit=20)
    assert row.status == FAILED
    assert "allow more with --" in row.message
