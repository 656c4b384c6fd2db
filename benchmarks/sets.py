"""Sets of homes: plans by seed, homes a minute on two cores, memory of a worker, and what is lost
when workers and runs are killed, here and on Dask. ``scenewright bench sets``.

``--count`` homes are furnished by two workers and written as JSON, glTF and, where it is there,
MJCF, with the manifest. The rate is that of two processors: 120 by the processor seconds of a home,
start and reading of kernels included; other work on the machine makes the clock say more. The first
of them are made again, killed ten times by SIGKILL: by turns the run and one of its
workers; then on two workers of a local Dask cluster, one killed twice. What is missing
or other than the bytes of the run that nobody killed is lost. Runs on Linux.
"""

from __future__ import annotations

import json
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import scenewright as sw
from benchmarks.generated_plans import _compared, asked_of
from benchmarks.plans_r2v import adapt, raw_plans
from benchmarks.rescaled_r2v import rescale
from scenewright.batch import Cluster
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.domains import plan_valid
from scenewright.formats import brief_json, formats
from scenewright.workflow.generate import generate
from scenewright.workflow.manifest import plan_hash

Record = dict[str, Any]
Progress = Callable[[float, str], None]
PLANS, QUICK_PLANS = 1000, 60
HOMES, QUICK_HOMES = 200, 12
KILLS, QUICK_KILLS = 10, 2
KILLED, QUICK_KILLED = 24, 12
"""Homes of the runs that are killed."""
WORKERS = 2
ASKED_RATE, ASKED_MEMORY = 60.0, 1.0
"""Homes a minute on two cores, and GB a worker, that are asked for."""
SIMULATION = (".mjcf.zip", ".mjcf", ".mjcf.xml", ".xml")
"""Suffixes under which homes may be written for MuJoCo: the first there is."""
PROGRAM = """
import sys, scenewright as sw
sw.batch(sys.argv[1], sys.argv[2], jobs=2, formats=(".json",), manifest="jsonl")
"""


def records(
    quick: bool = False, progress: Progress | None = None, count: int | None = None
) -> Iterator[Record]:
    """Plans beside real ones, speed and memory, and what is lost."""
    tell = progress or (lambda _share, _words: None)
    homes = count or (QUICK_HOMES if quick else HOMES)
    tell(0.0, "plans")
    made, found = make_plans(max(QUICK_PLANS if quick else PLANS, homes))
    yield from found
    with tempfile.TemporaryDirectory() as top:
        folder = write_plans(made[:homes], Path(top, "plans"))
        yield from measure_homes(folder, Path(top, "set"), tell)
        few = write_plans(made[: QUICK_KILLED if quick else KILLED], Path(top, "few"))
        whole, kills = Path(top, "whole"), QUICK_KILLS if quick else KILLS
        tell(0.6, "a run that nobody kills")
        sw.batch(few, whole, jobs=WORKERS, manifest="jsonl")
        yield lost("kill -9 at random", kills, whole, kill_runs(few, Path(top, "killed"), kills))
        tell(0.8, "Dask")
        yield lost("a Dask worker killed", 2, whole, kill_on_dask(few, Path(top, "dask")))


def make_plans(count: int) -> tuple[list[Brief], list[Record]]:
    """Plans of the first seeds, and their records: valid, alike, rooms and doors beside those of
    real flats."""
    generate("home", seed=0)  # compiled
    begun = time.process_time()
    made = [generate("home", seed=k, **asked_of(k)) for k in range(count)]
    spent = 1000 * (time.process_time() - begun) / count
    valid = sum(map(is_valid, made))
    alike = count - len({plan_hash(brief) for brief in made})
    rows = [
        record("plans", "processor time", "ms", spent, 20.0, count),
        record("plans", "valid", "%", 100 * valid / count, 100.0, count),
        record("plans", "alike", "%", 100 * alike / count, 0.0, count),
    ]
    flats = (adapt(rescale(raw)).brief for raw in raw_plans()[:count])
    return made, [*rows, *_compared(made, [flat for flat in flats if flat is not None], count)]


def is_valid(brief: Brief) -> bool:
    """Whether a plan is one that its domain can lay out."""
    try:
        plan_valid(brief)
    except InputError:
        return False
    return True


def write_plans(briefs: Sequence[Brief], folder: Path) -> Path:
    """A file a plan."""
    folder.mkdir()
    for number, brief in enumerate(briefs):
        (folder / f"home-{number:04}.json").write_text(brief_json.dumps(brief), encoding="utf-8")
    return folder


def suffixes() -> tuple[str, ...]:
    """What a home is written as."""
    known = {row.suffix for row in formats() if row.writer}
    return (".json", ".glb", *[suffix for suffix in SIMULATION if suffix in known][:1])


def measure_homes(folder: Path, out: Path, tell: Progress) -> list[Record]:
    """Homes a minute, memory of the largest worker, validity, and bytes a home."""
    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    written = suffixes()
    rows = sw.batch(
        folder,
        out,
        jobs=WORKERS,
        formats=written,
        manifest="jsonl",
        progress=lambda _row, done, total, _was: tell(0.1 + 0.5 * done / total, "homes"),
    )
    clock, after = time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    count, case = len(rows), f"homes as {' '.join(written)}"
    lines = [json.loads(line) for line in (out / "manifest.jsonl").read_text().splitlines()]
    size = sum(file["bytes"] for line in lines for file in line["files"]) / max(len(lines), 1) / 1e6
    valid = sum(line["score"]["valid"] for line in lines) / count
    whole = sum(line["score"]["complete"] for line in lines) / count
    rate = 60 * WORKERS * count / spent
    return [
        record(case, "two processors", "a minute", rate, ASKED_RATE, count),
        record(case, "clock, machine shared", "a minute", 60 * count / clock, ASKED_RATE, count),
        record(case, "memory of a worker", "GB", after.ru_maxrss / 1e6, ASKED_MEMORY, count),
        record(case, "valid", "%", 100 * valid, 100.0, count),
        record(case, "complete", "%", 100 * whole, 100.0, count),
        record(case, "size", "MB", size, None, count),
    ]


def kill_runs(folder: Path, out: Path, kills: int) -> Path:
    """A set made by a run killed at random moments, then ended."""
    draw = random.Random(45)
    for number in range(kills):
        run = subprocess.Popen([sys.executable, "-c", PROGRAM, str(folder), str(out)])
        begun = len(ledger(out))
        while run.poll() is None and len(ledger(out)) < begun + draw.randint(1, 3):
            time.sleep(0.02)
        time.sleep(draw.random())
        if number % 2 and (workers := children(run.pid)):
            os.kill(draw.choice(workers), signal.SIGKILL)
            while run.poll() is None and len(ledger(out)) < begun + 5:
                time.sleep(0.02)
        run.kill()
        run.wait()
    sw.batch(folder, out, jobs=WORKERS, manifest="jsonl")
    return out


def ledger(out: Path) -> list[str]:
    """The lines of a ledger, none before there is one."""
    path = out / ".batch.jsonl"
    return path.read_text(encoding="utf-8").splitlines() if path.exists() else []


def children(parent: int) -> list[int]:
    """The processes that a process has started."""
    found = []
    for status in Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(status.read_text().rpartition(")")[2].split()[1]) == parent:
                found.append(int(status.parent.name))
        except OSError:
            continue
    return found


def kill_on_dask(folder: Path, out: Path) -> Path:
    """A set made by two Dask workers, one killed after a quarter and after a half."""
    from distributed import Client, LocalCluster

    with LocalCluster(
        n_workers=WORKERS, threads_per_worker=1, dashboard_address=None, silence_logs=50
    ) as cluster:

        def kill(_row: object, done: int, total: int, _was: bool) -> None:
            if done in (total // 4, total // 2):
                with Client(cluster.scheduler_address, set_as_default=False) as client:
                    os.kill(next(iter(client.run(os.getpid).values())), signal.SIGKILL)

        on = Cluster(cluster.scheduler_address)
        sw.batch(folder, out, cluster=on, manifest="jsonl", progress=kill)
    return out


def lost(case: str, kills: int, whole: Path, made: Path) -> Record:
    """How many scenes of a set are missing, listed twice or other than they were without kills."""
    texts = [(folder / "manifest.jsonl").read_text("utf-8") for folder in (whole, made)]
    known, found = ([json.loads(line) for line in text.splitlines()] for text in texts)
    kept = {line["scene"]: line["files"] for line in found}
    gone = sum(kept.get(line["scene"]) != line["files"] for line in known)
    gone += sum(not (made / file["file"]).exists() for line in found for file in line["files"])
    return record(f"{case}, {kills} times", "lost", "homes", gone + len(found) - len(kept), 0.0,
                  len(known))  # fmt: skip


def record(
    case: str, metric: str, unit: str, ours: float, asked: float | None, runs: int
) -> Record:
    """A figure beside what was asked."""
    ratio = round(ours / asked, 2) if asked else None
    said = {"baseline": asked, "baseline_name": "asked" if asked is not None else ""}
    row = {"case": case, "metric": metric, "unit": unit, "ours": round(ours, 2), **said}
    return {**row, "ratio": ratio, "runs": runs}


def markdown_lines(found: list[Record]) -> Iterator[str]:
    """One table: what was measured, of how many, ours, and what was asked or real flats have."""
    yield "| | | of | ours | asked | real flats |"
    yield "|---|---|---|---|---|---|"
    for row in found:
        real = row["baseline_name"] == "real flats"
        told = "" if row["baseline"] is None else f"{row['baseline']:g}"
        sides = f" | {told}" if real else f"{told} | "
        what = f"{row['metric']}, {row['unit']}"
        yield f"| {row['case']} | {what} | {row['runs']} | {row['ours']:g} | {sides} |"
