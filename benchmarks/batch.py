"""Many flats on one machine: ``scenewright bench batch``.

All flats of ``floorplans_r2v`` as briefs are laid out, checked and written as JSON by
``scenewright.batch`` on two workers, and the path of one flat is taken apart in one process. The
aim is a million flats a day, every scene valid. Where other work shares the machine the time of
the processor tells more than the clock, so both are told.
"""

from __future__ import annotations

import resource
import tempfile
import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from benchmarks.comparison import ratio
from scenewright import batch, check, formats
from scenewright.batch.table import FAILED, NOT_VALID
from scenewright.domains.home import solving as home
from scenewright.engine.rows import SolverRow

Record = dict[str, Any]
Progress = Callable[[float, str], None]

WORKERS = 2
AIM = 1_000_000 / 86_400
"""A million flats a day, in flats a second."""
PRESETS = ("quick", "default")
PROFILED, QUICK = 100, 60
STEPS = ("read", "pose", "solve", "dress", "ways", "tell", "check", "write")


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """Throughput, validity and the path of one flat, for the presets ``quick`` and ``default``."""
    with tempfile.TemporaryDirectory() as spare:
        files = briefs(Path(spare) / "in", QUICK if quick else None)
        for preset in PRESETS:
            yield from profile(files[: QUICK // 3 if quick else PROFILED], preset)
            yield from throughput(files, Path(spare) / preset, preset, progress)


def briefs(folder: Path, most: int | None) -> list[Path]:
    """The flats as files, spread over the whole set if only so many are wanted."""
    from benchmarks.plans_r2v import adapt, raw_plans

    plans = raw_plans()
    folder.mkdir()
    files = []
    for raw in plans[:: max(len(plans) // (most or len(plans)), 1)][:most]:
        brief = adapt(raw).brief
        if brief is not None:
            files.append(folder / f"{raw['id']}.json")
            files[-1].write_text(brief.model_dump_json(exclude_defaults=True), encoding="utf-8")
    return files


def throughput(
    files: list[Path], out: Path, preset: str, progress: Progress | None
) -> list[Record]:
    """Flats a second by the clock and by the processor, and the share that is valid."""

    def heard(_: object, done: int, total: int, *__: object) -> None:
        if progress:
            progress(done / total, f"{preset}: {done} of {total} flats")

    before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    rows = batch(files, out, jobs=WORKERS, preset=preset, progress=heard)
    clock, after = time.perf_counter() - begun, resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    count = len(rows)
    valid = sum(row.status not in (NOT_VALID, FAILED) for row in rows) / count
    return [
        _record(f"{preset}: {WORKERS} workers, clock", "flats/s", count / clock, AIM, count),
        _record(
            f"{preset}: {WORKERS} cores, processor", "flats/s", WORKERS * count / spent, AIM, count
        ),
        _record(f"{preset}: valid scenes", "1", valid, 1.0, count),
    ]


def profile(files: list[Path], preset: str) -> list[Record]:
    """Milliseconds of the processor for each step of a flat, in one process on one thread.

    *read* the file and check its geometry; *pose* the rooms; *solve*; *dress* the layouts, and
    try less where not all fits; *ways* walk the whole home; *tell* the terms; *check*; *write*.
    """
    spent: dict[str, float] = defaultdict(float)
    steps: dict[str, list[tuple[Any, str]]] = {
        "solve": [(SolverRow, "run")],
        "furnish": [(home, "_run"), (home, "tried_again")],
        "ways": [(home, "yielded")],
        "tell": [(home, "_solution")],
    }
    kept = {
        name: [_timed(owner, attribute, name, spent) for owner, attribute in parts]
        for name, parts in steps.items()
    }
    try:
        for file in (files[0], *files):
            if file is files[0]:
                spent.clear()
            _one(file, preset, spent)
    finally:
        for name, parts in steps.items():
            for (owner, attribute), before in zip(parts, kept[name], strict=True):
                setattr(owner, attribute, before)
    whole = spent.pop("whole")
    spent["dress"] = spent.pop("furnish") - spent["solve"] - spent["ways"]
    spent["pose"] = whole - sum(spent[step] for step in ("solve", "dress", "ways", "tell"))
    count, aim = len(files), 1000.0 * WORKERS / AIM
    found = [
        _record(f"{preset}: {step}", "ms/flat", 1000 * spent[step] / count, aim, count)
        for step in STEPS
    ]
    total = 1000 * sum(spent.values()) / count
    return [*found, _record(f"{preset}: all steps", "ms/flat", total, aim, count)]


def _one(file: Path, preset: str, spent: dict[str, float]) -> None:
    """Do one flat, adding up the time of its steps."""
    marks = [time.process_time()]
    brief = formats.read(file)
    marks.append(time.process_time())
    solution = home.solve(brief, preset=preset, threads=1)
    marks.append(time.process_time())
    check(solution)
    marks.append(time.process_time())
    formats.write(solution, file.with_suffix(".out.json"))
    marks.append(time.process_time())
    file.with_suffix(".out.json").unlink()
    for name, a, b in zip(("read", "whole", "check", "write"), marks, marks[1:], strict=False):
        spent[name] += b - a


def _timed(owner: Any, attribute: str, name: str, spent: dict[str, float]) -> Any:
    """Have a function add its time to a sum; the function as it was."""
    before = getattr(owner, attribute)

    def timed(*arguments: Any, **named: Any) -> Any:
        begun = time.process_time()
        try:
            return before(*arguments, **named)
        finally:
            spent[name] += time.process_time() - begun

    setattr(owner, attribute, timed)
    return before


def _record(case: str, unit: str, ours: float, aim: float, runs: int) -> Record:
    return {
        "case": case,
        "metric": "share" if unit == "1" else "speed",
        "unit": unit,
        "ours": round(ours, 4),
        "baseline": round(aim, 4),
        "baseline_name": "aim",
        "ratio": ratio(ours, aim, unit),
        "runs": runs,
    }
