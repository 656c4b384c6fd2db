"""ProcTHOR's generator beside ours: ``scenewright bench procthor_peer``.

Both make homes by seed; a referee that neither knows judges both, as homes of placed furniture.
ProcTHOR (:data:`PACKAGES`) asks Unity for the meshes of grouped furniture and for where small
objects fall; here Unity is not run: a mesh is the box that ProcTHOR's own database states, and
there are no small objects. A house that its code ends with an error, or not within a minute, is
counted as none. Not asked, of both: what furniture is missing and what floats (their counters hold
their sinks, their screens hang on walls; the translation knows neither). Its interpreter is
``PROCTHOR_PYTHON``, else ours.
"""

from __future__ import annotations

import json
import os
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path
from time import process_time
from typing import Any

from benchmarks.generated_plans import asked_of
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution, unfurnished
from scenewright.domains import check, solve
from scenewright.formats import read
from scenewright.workflow.generate import generate

Record = dict[str, Any]
Progress = Callable[[float, str], None]
PACKAGES = "procthor ai2thor python-fcl pandas attrs 'moviepy<2'"
USUAL, QUICK = 50, 4
UNASKED = {"missing", "floating"}
"""Kinds of findings that the translation of their furniture would cause."""
THIN = 0.02
"""Thickness of walls that a house of theirs is read with, in metres: they have none."""
CODE = Path(__file__).with_name("procthor_houses.py")


def records(
    quick: bool = False, progress: Progress | None = None, count: int | None = None
) -> Iterator[Record]:
    """Seconds a house, pieces, shares made and valid, findings a house, of theirs and of ours."""
    number = count or (QUICK if quick else USUAL)
    with tempfile.TemporaryDirectory() as folder:
        theirs, seconds = _their_homes(Path(folder), number)
        ours, our_seconds = _our_homes(number, progress)
    yield _row("processor time", "s a house", our_seconds, seconds, number)
    made = [100 * len(each) / number for each in (ours, theirs)]
    yield _row("made", "%", made[0], made[1], number)
    judged = [[broken_rules(one) for one in each] for each in (ours, theirs)]
    valid = [100 * statistics.mean(not n for n in each) if each else 0.0 for each in judged]
    yield _row("valid by the referee, of those made", "%", valid[0], valid[1], number)
    for metric, unit, measure in (
        ("pieces", "a house", lambda one, _: len(one.pieces)),
        ("rooms", "a house", lambda one, _: len(one.brief.rooms)),
        ("rules broken", "a house", lambda _, broken: broken),
    ):
        pair = [
            statistics.mean(measure(one, broken) for one, broken in zip(each, found, strict=True))
            if each
            else 0.0
            for each, found in zip((ours, theirs), judged, strict=True)
        ]
        yield _row(metric, unit, pair[0], pair[1], number)


def broken_rules(home: Solution) -> int:
    """Findings of the referee that are to blame on whoever placed the furniture."""
    return sum(f.is_blamed and f.kind not in UNASKED for f in check(home).findings)


def _our_homes(number: int, progress: Progress | None) -> tuple[list[Solution], float]:
    homes, seconds = [], []
    for seed in range(number):
        if progress is not None:
            progress(seed / number, f"home {seed + 1} of {number}")
        before = process_time()
        homes.append(solve(generate("home", seed=seed, **asked_of(seed))))
        seconds.append(process_time() - before)
    return homes, statistics.median(seconds)


def _their_homes(folder: Path, number: int) -> tuple[list[Solution], float]:
    """Houses of ProcTHOR as solutions, and the seconds of the processor one takes."""
    python = os.environ.get("PROCTHOR_PYTHON", sys.executable)
    words = [python, "-P", str(CODE), str(folder), str(number)]  # its folder shadows modules
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    made = folder / "seconds.json"
    seconds = json.loads(made.read_text("utf-8")) if made.exists() else []
    if done.returncode or not seconds:
        last = (done.stderr.strip().splitlines() or ["it ended without a word"])[-1]
        raise InputError(
            f"ProcTHOR cannot be run: {last[:200]}",
            f"pip install {PACKAGES}, and name that Python in PROCTHOR_PYTHON",
        )
    homes = [placed_home(path) for path in sorted(folder.glob("*.procthor.json"))]
    return homes, statistics.median(seconds)


def placed_home(path: Path) -> Solution:
    """A house with its objects as pieces that were placed; its doors have no leaf and its walls the
    least thickness there is, so that neither is held against it."""
    brief = read(path, keep=True).model_copy(
        update={"wall_thickness": THIN, "outer_wall_thickness": THIN}
    )
    ids = {room.id or room.name for room in brief.rooms}
    assert len(ids) == len(brief.rooms)
    pieces = tuple(
        Piece(
            item.id,
            item.category,
            "",
            room.id,
            Pose(*item.at, item.z, item.heading),
            Size(*item.size),
            on=item.on,
        )
        for room in brief.rooms
        for item in room.fixed
    )
    empty = [
        room.model_copy(
            update={
                "fixed": [],
                "doors": [door.model_copy(update={"swing": "slide"}) for door in room.doors],
            }
        )
        for room in brief.rooms
    ]
    return replace(unfurnished(brief.model_copy(update={"rooms": empty})), pieces=pieces)


def _row(metric: str, unit: str, ours: float, theirs: float, runs: int) -> Record:
    return {
        "case": "homes",
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 3),
        "baseline": round(theirs, 3),
        "baseline_name": "ProcTHOR without Unity",
        "ratio": round(ours / theirs, 3) if theirs else None,
        "runs": runs,
    }
