"""All real flats of ``floorplans_r2v``, furnished and judged: ``scenewright bench r2v``.

Two worker processes share the plans; each writes a line per flat as it ends, and a worker that
dies is started again after the flat it died of, which counts as a crash.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_folder, data_set

Record = dict[str, Any]
Progress = Callable[[float, str], None]

WORKERS = 2
QUICK = 40
FAULTS = ("collision", "out_of_bounds", "blocked_door", "blocked_window", "unreachable_piece",
          "unreachable_room", "floating", "sunk", "malformed")  # fmt: skip
AIM = 1_000_000 / 24 / 60
"""A million flats a day, in flats per minute."""


def records(quick: bool = False, progress: Progress | None = None) -> list[Record]:
    """Furnish and check every flat (the first 40 if ``quick``) and tally."""
    return tally(run(QUICK if quick else None, progress))


def run(
    most: int | None = None, progress: Progress | None = None, folder: Path | None = None
) -> list[Record]:
    """One result for each flat, in any order; lines are kept in ``folder`` if given."""
    data_set(PLANS)
    with tempfile.TemporaryDirectory() as spare:
        files = [(folder or Path(spare)) / f"r2v-{k}.jsonl" for k in range(WORKERS)]
        workers: list[subprocess.Popen[bytes] | None]
        workers = [_start(file, k, most) for k, file in enumerate(files)]
        while any(worker is not None for worker in workers):
            time.sleep(0.2)
            for k, worker in enumerate(workers):
                if worker is not None and worker.poll() is not None:
                    died = worker.returncode != 0 and _bury(files[k])
                    workers[k] = _start(files[k], k, most) if died else None
            _tell(files, progress)
        rows = [row for file in files for row in _rows(file)]
    if not rows or len(rows) < rows[0]["of"]:
        raise RuntimeError("the workers could not start: see what they said above")
    return rows


def _start(file: Path, worker: int, most: int | None) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "benchmarks.r2v", str(file), str(worker), str(most or 0)]
    root = Path(__file__).resolve().parent.parent
    environment = os.environ | {"SCENEWRIGHT_DATA": str(data_folder().resolve())}
    return subprocess.Popen(command, cwd=root, env=environment)


def _rows(file: Path) -> list[Record]:
    if not file.exists():
        return []
    lines = file.read_text(encoding="utf-8").splitlines()
    return [row for line in lines if (row := json.loads(line)).get("done")]


def _bury(file: Path) -> bool:
    """Count the flat a worker died of as a crash; false if it died before its first flat."""
    lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
    last = json.loads(lines[-1]) if lines else {"done": True}
    if last.get("done"):
        return False
    crashed = last | {"done": True, "crash": "the worker died", "solve": 0.0, "check": 0.0}
    _append(file, crashed)
    return True


def _append(file: Path, row: Record) -> None:
    with file.open("a", encoding="utf-8") as out:
        out.write(json.dumps(row) + "\n")


def _tell(files: list[Path], progress: Progress | None) -> None:
    if progress is None:
        return
    rows = [row for file in files for row in _rows(file)]
    if rows:
        progress(len(rows) / rows[0]["of"], f"{len(rows)} of {rows[0]['of']} flats")


def work(file: Path, worker: int, most: int) -> None:
    """Furnish and check this worker's share of the flats, a line begun and a line done for each."""
    from scenewright.check import check
    from scenewright.domains.home import solve

    plans = raw_plans()[: most or None]
    before = {row["index"] for row in _rows(file)}
    check(solve(next(p.brief for p in map(adapt, plans) if p.brief is not None), seed=0))
    for index in range(worker, len(plans), WORKERS):
        if index not in before:
            begun = {"index": index, "id": plans[index]["id"], "of": len(plans)}
            _append(file, begun)
            _append(file, begun | {"done": True} | _one(adapt(plans[index]).brief))


def _one(brief: Any) -> Record:
    """Solve and check one flat; an exception is a crash, told."""
    from scenewright import plan
    from scenewright.check import check
    from scenewright.domains.home import solve

    started = time.perf_counter()
    solved = started
    try:
        if brief is None:
            raise ValueError("no brief could be made of the plan")
        solution = solve(brief, seed=0, threads=1)
        solved = time.perf_counter()
        spaces = plan.spaces(brief)
        report = check(solution, spaces=spaces)
        found = _summary(solution, report, spaces)
    except Exception as error:
        found = {"crash": f"{type(error).__name__}: {error}".splitlines()[0]}
    ended = time.perf_counter()
    return found | {"solve": solved - started, "check": ended - solved}


def _summary(solution: Any, report: Any, spaces: Any) -> Record:
    """What the tally needs of one flat: faults by kind with the first told, the usable rooms by
    function with those that lack something, and why."""
    from scenewright.check import expected
    from scenewright.check.bodies import rooms_of

    lacking: dict[tuple[str, str], list[str]] = {}
    for note in report.notes:
        lacking.setdefault((note.space, note.function), []).append(note.missing)
    told: dict[str, list[str]] = {}
    for out in solution.left_out:
        told.setdefault(out.space, []).append(f"{out.what}: {out.reason}")
    rooms: list[list[Any]] = []
    for space, shape in zip(spaces, rooms_of(spaces).shapes, strict=True):
        for function in expected(space.functions, shape):
            missing = lacking.get((space.id, function), [])
            reasons = told.get(space.id, []) if missing else []
            rooms.append([function, round(float(shape.area), 2), missing, reasons])
    return {
        "pieces": len(solution.pieces),
        "faults": {kind: n for kind, n in report.figures["counts"].items() if n},
        "told": [found.message for found in report.findings][:12],
        "rooms": rooms,
        "navigable": report.figures["navigable_share"],
    }


def tally(results: list[Record]) -> list[Record]:
    """The figures of the benchmark as records.

    Shares of flats without each fault; of rooms of a usable size (``check.USABLE``) that are
    complete, all and by function, and of the others that are told why; flats a minute with two
    processes. ``runs`` is the number of flats or rooms counted.
    """
    sound = [row for row in results if "crash" not in row]
    flats = len(results)
    found = [_record("no crash", "share", "1", len(sound) / max(flats, 1), 1.0, flats)]
    for kind in FAULTS:
        clean = sum(kind not in row["faults"] for row in sound) / max(len(sound), 1)
        name = f"no {kind.replace('_', ' ')}"
        found.append(_record(name, "share", "1", clean, 1.0, len(sound)))
    valid = sum(not row["faults"] for row in sound) / max(len(sound), 1)
    found.append(_record("valid", "share", "1", valid, 1.0, len(sound)))
    found += _complete(sound)
    for name, parts in (("solve", ("solve",)), ("solve + check", ("solve", "check"))):
        spent = sum(row[part] for row in results for part in parts) / WORKERS
        pace = 60 * flats / max(spent, 1e-9)
        found.append(_record(name, "speed", "flats/min", pace, AIM, flats))
    return found


def _complete(sound: list[Record]) -> list[Record]:
    rooms = [room for row in sound for room in row["rooms"]]
    total = Counter(room[0] for room in rooms)
    whole = Counter(room[0] for room in rooms if not room[2])
    explained = sum(bool(room[3]) for room in rooms if room[2])
    lacking = sum(bool(room[2]) for room in rooms)
    found = [
        _record(f"{name} complete", "share", "1", whole[name] / n, 0.95, n)
        for name, n in sorted(total.items())
    ]
    share = sum(whole.values()) / max(len(rooms), 1)
    told = explained / lacking if lacking else 1.0
    return [
        _record("rooms complete", "share", "1", share, 0.95, len(rooms)),
        *found,
        _record("others told why", "share", "1", told, 1.0, lacking),
    ]


def _record(case: str, metric: str, unit: str, ours: float, aim: float, runs: int) -> Record:
    return {
        "case": case, "metric": metric, "unit": unit, "ours": round(ours, 4), "baseline": aim,
        "baseline_name": "aim", "ratio": round(ours / aim, 4), "runs": runs,
    }  # fmt: skip


if __name__ == "__main__":
    work(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
