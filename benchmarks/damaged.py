"""Damaged files: ``scenewright bench damaged``.

Two thousand files over all stored formats, readers and plug-ins, each a sound one damaged by a
seed (``benchmarks.damage``), among them pipes, links and devices in place of files. Every one has
to be used or refused in one line: no internal error (exit 3), no hang, no more than half a
gigabyte of memory beyond what the process held. Runs on Linux.
"""

from __future__ import annotations

import os
import random
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from benchmarks.damaged_formats import FORMATS
from benchmarks.damaged_plugins import run_plugins
from benchmarks.damaged_runs import DamagedRun, run_all
from benchmarks.damaged_uses import DamagedFormat

Record = dict[str, Any]
Progress = Callable[[float, str], None]

QUICK = 0.1
"""The share of the files that ``--quick`` uses."""
MOST_MEMORY = 500.0
KINDS = ("pipe", "folder", "loop", "device", "nothing", "empty")
"""What stands in place of the first few files of a format."""


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """How many files of each format were refused, accepted, led to an internal error or hung, and
    the most seconds of the processor and memory one took."""
    share = QUICK if quick else 1.0
    total = sum(one.share for one in FORMATS)
    done = 0
    with tempfile.TemporaryDirectory() as spare:
        for one in FORMATS:
            if progress is not None:
                progress(done / total, f"damaged {one.name}")
            count = max(round(one.share * share), len(KINDS) + 1)
            runs = list(run_format(one, count, Path(spare)))
            yield from count_runs(one.name, runs)
            done += one.share
        yield from count_runs("plug-ins", list(run_plugins(Path(spare), quick)))


def run_format(one: DamagedFormat, count: int, spare: Path, seed: int = 0) -> Iterator[DamagedRun]:
    """What ``count`` damaged files of a format led to."""
    top = spare / one.name.replace(" ", "-")
    top.mkdir()
    sound = one.sound(top)
    whole = top / f"as-it-was{one.suffix}"
    whole.write_bytes(sound)
    paths = [make_file(one, number, sound, top, seed) for number in range(count)]
    for path, run in run_all([whole, *paths], one.use, top):
        if path == whole:
            if run.outcome != "accepted":
                raise RuntimeError(f"the sound file of {one.name} was not accepted: {run}")
            continue
        if run.outcome in ("error", "hang") or run.memory > MOST_MEMORY:
            print(f"{one.name} {path.stem}: {run}", flush=True)
        yield run


def make_file(one: DamagedFormat, number: int, sound: bytes, top: Path, seed: int = 0) -> Path:
    """The damaged file of a number: first those that are no files, then by the seed."""
    path = top / f"{seed}-{number}{one.suffix}"
    if number < len(KINDS):
        _make_odd(path, KINDS[number])
        return path
    draw = random.Random(f"{one.name} {seed} {number}")
    path.write_bytes(one.damage(sound, draw, top / "spare"))
    return path


def _make_odd(path: Path, kind: str) -> None:
    """Something in place of a file."""
    if kind == "pipe":
        os.mkfifo(path)
    elif kind == "folder":
        path.mkdir()
    elif kind == "loop":
        path.symlink_to(path)
    elif kind == "device":
        path.symlink_to("/dev/zero")
    elif kind == "empty":
        path.write_bytes(b"")


def count_runs(name: str, runs: list[DamagedRun]) -> Iterator[Record]:
    """The records of a format."""
    counts = {kind: sum(run.outcome == kind for run in runs) for kind in OUTCOMES}
    values: dict[str, tuple[float, str]] = {
        OUTCOMES[kind]: (count, "files") for kind, count in counts.items()
    }
    values["most seconds of the processor"] = (max(run.seconds for run in runs), "s")
    values["most memory"] = (max(run.memory for run in runs), "MiB")
    for metric, (value, unit) in values.items():
        yield {
            "case": name,
            "metric": metric,
            "unit": unit,
            "ours": round(value, 2),
            "baseline": None,
            "baseline_name": "",
            "ratio": None,
            "runs": len(runs),
        }


OUTCOMES = {"refused": "refused", "accepted": "accepted", "error": "exit 3", "hang": "hung"}


def markdown_lines(found: list[Record]) -> Iterator[str]:
    """One line a format."""
    metrics = list(dict.fromkeys(record["metric"] for record in found))
    yield f"| format | files | {' | '.join(metrics)} |"
    yield f"|{'---|' * (len(metrics) + 2)}"
    for case in dict.fromkeys(record["case"] for record in found):
        own = {r["metric"]: r["ours"] for r in found if r["case"] == case}
        count = next(r["runs"] for r in found if r["case"] == case)
        yield f"| {case} | {count} | {' | '.join(str(own[m]) for m in metrics)} |"
