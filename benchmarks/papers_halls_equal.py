"""Halls by every method at equal layouts and equal processor time: ``bench papers_halls_equal``.

One run of our default against as many of each other method, begun anew with the next seed, as look
at as many layouts, and as take as many seconds of the processor (at least one, at most 40). Of
these one is taken: the least of the method's ``own`` energy, or by the ``referee``: the fewest
faults and objects left out first, then own energy. ``best`` is the least energy above its floor of
all that are valid, which nobody who runs the method is told.

Told of what is taken: the share that is valid and complete, the measures of eqs. 7 to 9 of Cao,
Cheng and Zhang (2024), the paper's energy above its floor (:mod:`.hall_measure`), and seconds of
the processor of all runs it was taken of. Five samples, two seeds; ``--full`` takes ten.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from typing import Any, NamedTuple

from benchmarks.hall_measure import energies_of
from benchmarks.hall_methods import halls
from benchmarks.kept import open_runs
from benchmarks.papers_halls_equal_tables import markdown_lines, page_lines
from benchmarks.papers_halls_measures import BETTER, OURS, PRINTED, _warm, compared, measured, names
from benchmarks.spread import Progress, SpreadTable, spread_tables
from scenewright.core.solution import Solution
from scenewright.domains.hall.solving import solve

__all__ = ["markdown_lines", "page_lines", "records"]

Row = dict[str, Any]
RUN = ("scenewright.domains.hall.solving", "scenewright.domains.hall.check")
CODE = ("benchmarks/papers_halls_equal.py", "src/scenewright/domains/hall/**/*.py")
"""What the runs are of: those of other code are not kept."""
SEEDS, QUICK_SEEDS, FULL_SEEDS, MOST = 2, 1, 10, 40
QUICK = "sample:hall-irregular"
FIGURES = ("valid", *BETTER, "excess", "seconds", "runs")
EQUALS = ("seconds", "layouts")
AT_LAYOUTS = ("paper", "paper-repaired", "miqp", "merrell")
"""What the paper runs and compares: measured at equal layouts, too."""


class HallRun(NamedTuple):
    """One run: its solution, its own energy, the paper's above its floor, its layouts, and seconds
    of the processor."""

    solution: Solution
    own: float
    excess: float
    layouts: float
    seconds: float


def run_once(case: str, method: str, seed: int) -> HallRun:
    """One run on one thread."""
    options, brief = _warm(method), compared(case)
    begun = time.process_time()
    solution = solve(brief, seed=seed, threads=1, **options)
    seconds, energies = time.process_time() - begun, energies_of(solution)
    own, excess = sum(solution.energies.values()), energies.total - energies.least
    return HallRun(solution, own, excess, solution.evaluations, seconds)


def run_seed(case: str, among: Sequence[str], seed: int) -> Row:
    """Our default once, and every other method as often as fits in its layouts and seconds."""
    ours = run_once(case, OURS, seed)
    found = {OURS: tell_run(ours, [ours], judge_run)}
    for method in among:
        runs, judge = list[HallRun](), remember(judge_run)
        equals = EQUALS if method in AT_LAYOUTS else EQUALS[:1]
        while not runs or (len(runs) < MOST and not all(has(runs, ours, by) for by in equals)):
            runs.append(run_once(case, method, seed * MOST + len(runs)))
        for by in equals:
            some = within(runs, ours, by)
            for name in PICKS if method in PRINTED else ("referee",):
                taken = PICKS[name](some, judge)
                found[f"{method}, equal {by}, {name}"] = tell_run(taken, some, judge)
    return found


Judge = Callable[[HallRun], Row]


def remember(judge: Judge) -> Judge:
    """The same, asking of each run once: the referee takes longer than a run."""
    known: dict[int, Row] = {}

    def told(run: HallRun) -> Row:
        if id(run) not in known:
            known[id(run)] = judge(run)
        return known[id(run)]

    return told


def judge_run(run: HallRun) -> Row:
    """A run as the referee sees it; ``sound``: valid and complete."""
    row = measured(run.solution, run.seconds)
    sound = bool(row["valid"] and row["whole"])
    return row | {"sound": sound, "valid": float(sound), "faults": row["faults"] + row["left_out"]}


def tell_run(run: HallRun, among: Sequence[HallRun], judge: Judge) -> Row:
    """The figures of a run, with the seconds of all it was taken of, and their number."""
    row = judge(run) | {"seconds": sum(one.seconds for one in among), "runs": len(among)}
    return {name: float(row[name]) for name in FIGURES}


def first_sound(runs: Iterable[HallRun], judge: Judge) -> HallRun:
    """The first that is valid and complete; else the first of those with the fewest faults."""
    known = list(runs)
    sound = next((run for run in known if judge(run)["sound"]), None)
    return sound or min(known, key=lambda run: judge(run)["faults"])


def by_own(run: HallRun) -> float:
    """A run by its own energy."""
    return run.own


PICKS: dict[str, Callable[[Sequence[HallRun], Judge], HallRun]] = {
    "own": lambda runs, _judge: min(runs, key=by_own),
    "referee": lambda runs, judge: first_sound(sorted(runs, key=by_own), judge),
    "best": lambda runs, judge: first_sound(sorted(runs, key=lambda run: run.excess), judge),
}
"""Which of several runs is taken."""


def has(runs: Sequence[HallRun], ours: HallRun, by: str) -> bool:
    """Whether runs together have as many layouts or seconds as ours."""
    return bool(sum(getattr(run, by) for run in runs) >= getattr(ours, by))


def within(runs: Sequence[HallRun], ours: HallRun, by: str) -> Sequence[HallRun]:
    """The first runs that together have no more than ours, at least one."""
    count, most = 1, getattr(ours, by)
    while count < len(runs) and sum(getattr(run, by) for run in runs[: count + 1]) <= most:
        count += 1
    return runs[:count]


def compare_seeds(case: str, found: Sequence[Row]) -> Iterator[Row]:
    """Means of each figure of every method and pick, beside ours, with the standard error of the
    difference over seeds."""
    for key in found[0]:
        for name in FIGURES:
            ours, theirs = ([float(one[which][name]) for one in found] for which in (OURS, key))
            yield _record(case, name, key, ours, theirs)


def _record(case: str, metric: str, key: str, ours: list[float], theirs: list[float]) -> Row:
    gaps = [a - b for a, b in zip(ours, theirs, strict=True)]
    mine, other = statistics.fmean(ours), statistics.fmean(theirs)
    error = statistics.stdev(gaps) / len(gaps) ** 0.5 if len(gaps) > 1 else 0.0
    return {
        "case": case,
        "metric": metric,
        "unit": "s" if metric == "seconds" else "1",
        "ours": round(mine, 5),
        "baseline": round(other, 5),
        "baseline_name": key,
        "ratio": round(mine / other, 4) if other else None,
        "runs": len(ours),
        "error": round(error, 5),
    }


def records(
    quick: bool = False, progress: Progress | None = None, full: bool = False
) -> Iterator[Row]:
    """All records; ``quick`` takes one sample, one seed and the paper's own presets. Runs once done
    are kept."""
    seeds = QUICK_SEEDS if quick else FULL_SEEDS if full else SEEDS
    kept, count = open_runs(f"papers_halls_equal{'-quick' * quick}", CODE), range(seeds)
    among = list(PRINTED)[:2] if quick else [name for name in names() if name != OURS]
    tables = [
        SpreadTable(
            case,
            [partial(kept.have, f"{case}, {s}", partial(run_seed, case, among, s)) for s in count],
            partial(compare_seeds, case),
        )
        for case in ([QUICK] if quick else halls())
    ]
    yield from spread_tables(tables, progress, 1)
