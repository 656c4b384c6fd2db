"""Halls by every method at equal layouts and equal processor time: ``bench papers_halls_equal``.

One run of our default against as many of each other method, begun anew with the next seed, as look
at as many layouts, and as take as many seconds of the processor (at least one, at most 24). Of
these one is taken: the least of the method's ``own`` energy, or by the ``referee``: the fewest
faults and objects left out first, then own energy. ``best`` is the least energy above its floor of
all that are valid, which nobody who runs the method is told.

Told of what is taken: the share that is valid and complete, the measures of eqs. 7 to 9 of Cao,
Cheng and Zhang (2024), the paper's energy above its floor (:mod:`.hall_measure`), and seconds of
the processor of all runs it was taken of. Five samples, three seeds; ``--full`` takes ten.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

from benchmarks.hall_methods import halls
from benchmarks.kept import open_runs
from benchmarks.papers_halls_equal_tables import markdown_lines, page_lines
from benchmarks.papers_halls_measures import BETTER, OURS, PRINTED, _warm, compared, measured, names
from benchmarks.spread import Progress, SpreadTable, spread_tables
from scenewright.domains.hall.solving import solve

__all__ = ["markdown_lines", "page_lines", "records"]

Row = dict[str, Any]
RUN = ("scenewright.domains.hall.solving", "scenewright.domains.hall.check")
CODE = ("benchmarks/papers_halls_equal.py", "src/scenewright/domains/hall/**/*.py")
"""What the runs are of: those of other code are not kept."""
SEEDS, QUICK_SEEDS, FULL_SEEDS, MOST = 3, 1, 10, 24
QUICK = "sample:hall-irregular"
FIGURES = ("valid", *BETTER, "excess", "seconds", "runs")
EQUALS = ("layouts", "seconds")


def faults_of(row: Row) -> tuple[float, float]:
    """How the referee ranks a run: faults and what is left out, then the method's own energy."""
    return row["faults"] + row["left_out"], row["own"]


PICKS: dict[str, Callable[[Sequence[Row]], Row]] = {
    "own": lambda rows: min(rows, key=lambda row: row["own"]),
    "referee": lambda rows: min(rows, key=faults_of),
    "best": lambda rows: min(
        [row for row in rows if row["sound"]] or rows, key=lambda row: row["excess"]
    ),
}
"""Which of several runs is taken."""


def run_once(case: str, method: str, seed: int) -> Row:
    """One run on one thread: its figures, its own energy, layouts and processor seconds."""
    options, brief = _warm(method), compared(case)
    begun = time.process_time()
    solution = solve(brief, seed=seed, threads=1, **options)
    row = measured(solution, time.process_time() - begun)
    sound = bool(row["valid"] and row["whole"])
    return row | {"own": sum(solution.energies.values()), "sound": sound, "valid": float(sound)}


def run_seed(case: str, among: Sequence[str], seed: int) -> Row:
    """Our default once, and every other method as often as fits in its layouts and seconds."""
    ours, found = run_once(case, OURS, seed), dict[str, Any]()
    for method in among:
        rows = list[Row]()
        while not rows or (len(rows) < MOST and not all(has(rows, ours, by) for by in EQUALS)):
            rows.append(run_once(case, method, seed * MOST + len(rows)))
        for by in EQUALS:
            for name, pick in PICKS.items():
                some = within(rows, ours, by)
                told = pick(some) | {"seconds": sum(row["seconds"] for row in some)}
                found[f"{method}, equal {by}, {name}"] = told | {"runs": len(some)}
    return {OURS: ours | {"runs": 1}} | found


def has(rows: Sequence[Row], ours: Row, by: str) -> bool:
    """Whether runs together have as many layouts or seconds as ours."""
    return bool(sum(row[by] for row in rows) >= ours[by])


def within(rows: Sequence[Row], ours: Row, by: str) -> Sequence[Row]:
    """The first runs that together have no more than ours, at least one.

    >>> rows = [{"seconds": 0.3}, {"seconds": 0.3}, {"seconds": 0.3}]
    >>> [len(within(rows, {"seconds": most}, "seconds")) for most in (0.7, 0.1)]
    [2, 1]
    """
    count = 1
    while count < len(rows) and sum(row[by] for row in rows[: count + 1]) <= ours[by]:
        count += 1
    return rows[:count]


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
