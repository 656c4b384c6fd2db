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
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

from benchmarks import stages
from benchmarks.counters_r2v import name_kitchens
from benchmarks.plans_r2v import PLANS, adapt, raw_plans
from benchmarks.real_data import data_folder, data_set
from benchmarks.rescaled_r2v import rescale

Record = dict[str, Any]
Progress = Callable[[float, str], None]

DOOR = "a door"
"""What the referee says of a room that nobody can enter; nothing to be furnished."""
WORKERS = 2
QUICK = 40
FAULTS = (
    "collision",
    "out_of_bounds",
    "blocked_door",
    "blocked_window",
    "unreachable_piece",
    "unreachable_room",
    "floating",
    "sunk",
    "malformed",
)
AIM = 1_000_000 / 24 / 60
"""A million flats a day, in flats per minute."""


def records(
    quick: bool = False, progress: Progress | None = None, rescaled: bool = False
) -> Iterator[Record]:
    """Furnish and check every flat (the first 40 if ``quick``) and tally, those done if
    interrupted; ``rescaled``: flats at their true scale (:mod:`benchmarks.rescaled_r2v`)."""
    return stages.tally(finished(QUICK if quick else None, progress, rescaled=rescaled), tally)


def run(
    most: int | None = None, progress: Progress | None = None, folder: Path | None = None
) -> list[Record]:
    """One result for each flat, in any order; lines are kept in ``folder`` if given."""
    return list(finished(most, progress, folder))


def finished(
    most: int | None = None,
    progress: Progress | None = None,
    folder: Path | None = None,
    rescaled: bool = False,
) -> Iterator[Record]:
    """As :func:`run`; of an interrupted run the flats that are done."""
    data_set(PLANS)
    interruption: KeyboardInterrupt | None = None
    with tempfile.TemporaryDirectory() as spare:
        files = [(folder or Path(spare)) / f"r2v-{k}.jsonl" for k in range(WORKERS)]
        workers: list[subprocess.Popen[bytes] | None]
        start = partial(_start, most=most, rescaled=rescaled)
        workers = [start(file, k) for k, file in enumerate(files)]
        try:
            while any(worker is not None for worker in workers):
                time.sleep(0.2)
                for k, worker in enumerate(workers):
                    if worker is not None and worker.poll() is not None:
                        died = worker.returncode != 0 and _bury(files[k])
                        workers[k] = start(files[k], k) if died else None
                _tell(files, progress)
        except KeyboardInterrupt as caught:
            interruption = caught
        finally:
            _end(workers)
        rows = [row for file in files for row in _rows(file)]
    yield from rows
    if interruption:
        raise interruption
    if not rows or len(rows) < rows[0]["of"]:
        raise RuntimeError("the workers could not start: see what they said above")


def _end(workers: list[subprocess.Popen[bytes] | None]) -> None:
    """Stop those that still run."""
    for worker in workers:
        if worker is not None:
            worker.kill()
            worker.wait()


def _start(file: Path, worker: int, most: int | None, rescaled: bool) -> subprocess.Popen[bytes]:
    command = [sys.executable, "-m", "benchmarks.r2v", str(file), str(worker), str(most or 0)]
    command += ["rescaled"] * rescaled
    root = Path(__file__).resolve().parent.parent
    environment = os.environ | {"SCENEWRIGHT_DATA": str(data_folder().resolve())}
    return subprocess.Popen(  # Ctrl-C is for this process, which ends its workers
        command, cwd=root, env=environment, stdout=subprocess.DEVNULL, start_new_session=True
    )


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


def work(file: Path, worker: int, most: int, rescaled: bool = False) -> None:
    """Furnish and check this worker's share of the flats, a line begun and a line done for each."""
    from scenewright.domains import check
    from scenewright.domains.home.solving import solve

    plans = [name_kitchens(raw) for raw in raw_plans()[: most or None]]
    before = {row["index"] for row in _rows(file)}
    check(solve(next(p.brief for p in map(adapt, plans) if p.brief is not None), seed=0))
    for index in range(worker, len(plans), WORKERS):
        if index not in before:
            begun = {"index": index, "id": plans[index]["id"], "of": len(plans)}
            _append(file, begun)
            raw = rescale(plans[index]) if rescaled else plans[index]
            _append(file, begun | {"done": True} | _one(adapt(raw).brief))


def _one(brief: Any) -> Record:
    """Solve and check one flat; an exception is a crash, told."""
    from scenewright.building import plan
    from scenewright.domains import check
    from scenewright.domains.home.solving import solve

    started = time.perf_counter()
    solved = started
    try:
        if brief is None:
            raise ValueError("no brief could be made of the plan")
        solution = solve(brief, seed=0, threads=1)
        solved = time.perf_counter()
        spaces = plan.spaces(brief)
        report = check(solution, spaces=spaces)
        found = summarise(solution, report, spaces)
    except Exception as error:
        found = {"crash": f"{type(error).__name__}: {error}".splitlines()[0]}
    ended = time.perf_counter()
    return found | {"solve": solved - started, "check": ended - solved}


def summarise(solution: Any, report: Any, spaces: Any) -> Record:
    """What the tally needs of one flat: faults by kind with the first told; the usable rooms by
    function with what each lacks, and what of that is told as left out, with a reason; and the
    rooms that no door leads into, a fault of the plan."""
    from scenewright.check.bodies import rooms_of
    from scenewright.domains.home.check.complete import find_expected_functions

    lacking: dict[tuple[str, str], list[str]] = {}
    for note in report.notes:
        lacking.setdefault((note.space, note.function), []).append(note.missing)
    rooms: list[list[Any]] = []
    for space, shape in zip(spaces, rooms_of(spaces).shapes, strict=True):
        for function in find_expected_functions(space.functions, shape):
            missing = [m for m in lacking.get((space.id, function), []) if m != DOOR]
            told = [m for m in missing if _is_told(solution, space.id, function, m)]
            rooms.append([function, round(float(shape.area), 2), missing, told])
    return {
        "pieces": len(solution.pieces),
        "faults": {kind: n for kind, n in report.figures["counts"].items() if n},
        "told": [found.message for found in report.findings][:12],
        "rooms": rooms,
        "doorless": len({note.space for note in report.notes if note.missing == DOOR}),
        "spaces": len(spaces),
        "navigable": report.figures["navigable_share"],
    }


def _is_told(solution: Any, space: str, function: str, missing: str) -> bool:
    """Whether a group that would bring what is missing is told as left out, as a failure and with
    a reason."""
    from scenewright.building.room_needs import ESSENTIALS
    from scenewright.domains.home.shortfall import groups_serving, kinds_serving

    needs = [need for need in ESSENTIALS[function] if need.name == missing]
    serving = {group for need in needs for group in groups_serving(kinds_serving(need.name))}
    return any(
        out.space == space and out.required and out.reason and out.what in serving
        for out in solution.left_out
    )


def tally(results: list[Record]) -> list[Record]:
    """The figures of the benchmark as records.

    Shares of flats without each fault; of rooms of a usable size (``room_needs.USABLE``) that are
    complete, all and by function, and of the others of which all that is missing is told as left
    out, with a reason; flats a minute with two processes; then the main ones in one line. ``runs``
    is the number of flats or rooms counted.
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
    rooms = _complete(sound)
    found += rooms
    for name, parts in (("solve", ("solve",)), ("solve + check", ("solve", "check"))):
        spent = sum(row[part] for row in results for part in parts) / WORKERS
        pace = 60 * flats / max(spent, 1e-9)
        found.append(_record(name, "speed", "flats/min", pace, AIM, flats))
    complete, reported = rooms[0]["ours"], rooms[1]["ours"]
    line = f"valid {valid:.1%}, complete {complete:.1%}, others reported {reported:.1%}"
    return [*found, _record(line, "speed", "flats/min", pace, AIM, flats)]


def _complete(sound: list[Record]) -> list[Record]:
    """Of the usable rooms those that are complete, of the others those told; then by function."""
    rooms = [room for row in sound for room in row["rooms"]]
    total = Counter(room[0] for room in rooms)
    whole = Counter(room[0] for room in rooms if not room[2])
    lacking = [room for room in rooms if room[2]]
    told = sum(len(room[3]) == len(room[2]) for room in lacking) / max(len(lacking), 1)
    share = sum(whole.values()) / max(len(rooms), 1)
    spaces = sum(row["spaces"] for row in sound)
    doors = 1 - sum(row["doorless"] for row in sound) / max(spaces, 1)
    return [
        _record("rooms complete", "share", "1", share, 0.97, len(rooms)),
        _record("others reported", "share", "1", told if lacking else 1.0, 1.0, len(lacking)),
        *(
            _record(f"{name} complete", "share", "1", whole[name] / n, 0.97, n)
            for name, n in sorted(total.items())
        ),
        _record("rooms with a door", "share", "1", doors, 1.0, spaces),
    ]


def _record(case: str, metric: str, unit: str, ours: float, aim: float, runs: int) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 4),
        "baseline": aim,
        "baseline_name": "aim",
        "ratio": round(ours / aim, 4),
        "runs": runs,
    }


if __name__ == "__main__":
    work(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), sys.argv[4:] == ["rescaled"])
