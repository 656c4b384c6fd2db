"""The experiments of Liu et al. (2017) repeated, and the same with our default solver.

``scenewright bench papers_home -o t.md`` takes a minute, ``--quick`` two rooms and two runs; its
Markdown is a table for ``docs/reproduction-homes.md``. All costs are the printed one
(preset ``paper``), of patches; those of single pieces are of the boxes round their groups. Runs are
ten, as the paper's; its figures, of a room it does not print and a machine of 2011, stand beside.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.comparison import ratio
from benchmarks.home_methods import Method, lay_out
from benchmarks.home_peers import Ended
from benchmarks.home_rooms import Case
from benchmarks.papers_home_rooms import BOXED, FOUR, ROOMS, case_of
from benchmarks.papers_home_tables import (
    BESIDE,
    EVALUATIONS,
    FEW,
    GA,
    MERRELL,
    SA,
    SA1,
    TIME,
    markdown_lines,
)
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers import SOLVERS
from scenewright.domains.home.solvers.paper_annealing import paper_sa
from scenewright.engine.solve import Budget

__all__ = ["EVALUATIONS", "METHODS", "markdown_lines", "records"]

Record = dict[str, Any]
Row = dict[str, Any]
Progress = Callable[[float, str], None]
RUNS, QUICK = 10, 2
WITH_BOXES = ("living 1", "living 3, acute", "bedroom 1", "bedroom 4")
PRINTED = {
    (GA, "cost"): (52.74, 43.2, 75.9),
    (SA, "cost"): (1047.3, 840.8, 1384.2),
    (SA1, "cost"): (1047.3, 840.8, 1384.2),
    (GA, "seconds"): (50.3, 47.5, 52.8),
    (SA, "seconds"): (46.7, 43.3, 50.4),
    (SA1, "seconds"): (46.7, 43.3, 50.4),
    (MERRELL, "seconds"): (217.3, 196.5, 225.9),
}
"""Mean, least and most of tables 1 and 2."""


def solver_of(name: str, pieces: bool = False) -> Method:
    """A solver of homes as a method, by name."""

    def run(problem: Problem, budget: Budget, seed: int) -> Ended:
        found = SOLVERS[name].run(problem, budget, seed)
        return Ended(found.layouts[0].boxes, found.layouts[0].energy, found.evaluations)

    return Method(name, run, pieces)


def _annealing(moves: int) -> Method:
    def run(problem: Problem, budget: Budget, seed: int) -> Ended:
        found = paper_sa(problem, budget, seed, moves=moves)
        return Ended(found.layouts[0].boxes, found.layouts[0].energy, found.evaluations)

    return Method("paper-sa", run)


METHODS = {
    GA: solver_of("paper-ga"),
    SA: _annealing(8),
    SA1: _annealing(1),
    MERRELL: solver_of("merrell", pieces=True),
}


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """Every method in every room against ours, under the printed cost."""
    usual = (ROOMS[0], ROOMS[4]) if quick else (*ROOMS, FOUR)
    boxed = [room._replace(name=room.name + BOXED) for room in usual if room.name in WITH_BOXES]
    chosen = (*usual, *boxed)
    runs = QUICK if quick else RUNS
    for number, room in enumerate(chosen):
        if progress:
            progress(number / len(chosen), room.name)
        rows = measure(case_of(room), runs)
        for name in rows:
            yield from _compared(room.name, name, rows)


def measure(case: Case, runs: int) -> dict[str, list[Row]]:
    """Rows of every method, seeds from 0 on; kernels are warm before the first is timed."""
    rows: dict[str, list[Row]] = {}
    for name, method in METHODS.items():
        lay_out(method, case, Budget(steps=50, threads=1), 0)
        rows[name] = [lay_out(method, case, Budget(threads=1), seed) for seed in range(runs)]
    ours = solver_of("anneal")
    lay_out(ours, case, Budget(steps=50, threads=1), 0)
    seconds = statistics.fmean(row["seconds"] for row in rows[GA])
    for name, budget in (
        (EVALUATIONS, Budget(steps=4000, threads=1)),
        (FEW, Budget(steps=450, threads=1)),
        (TIME, Budget(seconds=seconds, threads=1)),
    ):
        rows[name] = [lay_out(ours, case, budget, seed) for seed in range(runs)]
    return rows


def _compared(room: str, name: str, rows: dict[str, list[Row]]) -> Iterator[Record]:
    """Mean cost and seconds of a method beside ours at no more evaluations."""
    beside = BESIDE.get(name, EVALUATIONS)
    for metric, key, unit in (
        ("printed cost, mean", "energy", "cost"),
        ("seconds", "seconds", "s"),
    ):
        theirs, ours = ([float(row[key]) for row in rows[n]] for n in (name, beside))
        printed = PRINTED.get((name, "cost" if key == "energy" else "seconds"))
        mean, mine = statistics.fmean(theirs), statistics.fmean(ours)
        yield Record(
            case=room,
            metric=metric,
            unit=unit,
            ours=round(mine, 4),
            baseline=round(mean, 4),
            baseline_name=name,
            ratio=ratio(round(mine, 4), round(mean, 4), "s"),
            runs=len(theirs),
            least=round(min(theirs), 4),
            most=round(max(theirs), 4),
            layouts=round(statistics.fmean(row["layouts"] for row in rows[name])),
            printed=printed,
        )
