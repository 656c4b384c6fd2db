"""Homes by every method on the same problems: our default, the paper's two, the baselines by name
and general optimisers, at equal numbers of layouts and at equal time, one thread each.

Every method is judged by the problem's own energy, whatever it goes by itself. On the instances
that is the paper's cost as printed over some seeds; on the fifty rooms it is our default energy of
the boxes round its groups, and each answer is also dressed and judged as ``scenewright arrange``
does. Solvers whose schedule ends before the time does start again with the next seed.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from benchmarks.home_peers import Ended, peers
from benchmarks.home_rooms import Case, rooms
from benchmarks.instances import read_instance
from benchmarks.shapely_home import INSTANCES
from scenewright.domains.home.attempts.attempt import (
    RoomAnswer,
    build_task_problem,
    furnish_layout,
    score_answer,
)
from scenewright.domains.home.attempts.piecewise import lay_out_parts
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.furnishing.pieces import as_laid
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers import SOLVERS
from scenewright.engine.solve import Budget

Floats = NDArray[np.float64]
Row = dict[str, Any]
Progress = Callable[[float, str], None]
BUDGETS = {
    "4000 layouts": Budget(steps=4000, threads=1),
    "0.1 s": Budget(seconds=0.1, threads=1),
    "1 s": Budget(seconds=1.0, threads=1),
}
SCHEDULED = {"paper-ga": Budget(), "paper-sa": Budget(steps=4000)}
"""Solvers that end by themselves, and the budget that is their schedule."""
OURS = "anneal"


class Method(NamedTuple):
    """A way to lay out a problem, over patches or over single pieces."""

    name: str
    run: Callable[[Problem, Budget, int], Ended]
    pieces: bool = False


def named(name: str) -> Method:
    """A solver of the table."""

    def run(problem: Problem, budget: Budget, seed: int) -> Ended:
        end, best, looked = time.perf_counter() + (budget.seconds or 0.0), None, 0
        while True:
            left = end - time.perf_counter()
            limit = budget
            if budget.seconds and name in SCHEDULED:
                limit = SCHEDULED[name]._replace(seconds=max(left, 1e-4), threads=1)
            found = SOLVERS[name].run(problem, limit, seed)
            looked, seed = looked + found.evaluations, seed + 1000
            if best is None or found.layouts[0].energy < best.energy:
                best = found.layouts[0]
            if limit is budget or time.perf_counter() >= end:
                return Ended(best.boxes, best.energy, looked)

    return Method(name, run, SOLVERS[name].encoding == "pieces")


def methods() -> tuple[Method, ...]:
    """Every solver of the table, and the peers that are installed."""
    return (*map(named, SOLVERS), *(Method(p.name, p.run) for p in peers()))


def instances() -> tuple[Case, ...]:
    """The two measuring instances; their rectangles are patches and pieces alike."""
    return tuple(Case(name, read_instance(name), read_instance(name)) for name in INSTANCES)


def lay_out(method: Method, case: Case, budget: Budget, seed: int) -> Row:
    """One run: energy of the answer, seconds, layouts looked at, and what stands of it."""
    problem = case.pieces if method.pieces else case.problem
    begun = time.perf_counter()
    ended = method.run(problem, budget, seed)
    taken, boxes = time.perf_counter() - begun, ended.boxes
    if method.pieces and case.parts:
        boxes, first = np.empty((len(case.parts), 5)), 0
        for k, part in enumerate(case.parts):
            boxes[k] = as_laid(part, ended.boxes[first : first + len(part.placed)])[1]
            first += len(part.placed)
    energy = float(evaluate(case.problem, boxes[None])[0])
    row = {
        "case": case.name,
        "method": method.name,
        "seed": seed,
        "energy": energy,
        "seconds": taken,
        "layouts": ended.evaluations,
    }
    return row | (_standing(method, case, ended.boxes, energy) if case.task else {})


def _standing(method: Method, case: Case, boxes: Floats, energy: float) -> Row:
    """The share of the wished groups that stand, and whether all do and can be reached."""
    assert case.task is not None
    answer = _furnished(method, case, boxes, energy)
    share = len(answer.placed) / len(case.wishes)
    essential = [m for m in answer.missing if m.wish.rank == 0]
    return {"stand": share, "whole": float(not essential and not answer.unreached)}


def _furnished(method: Method, case: Case, boxes: Floats, energy: float) -> RoomAnswer:
    task = case.task
    assert task is not None
    if not method.pieces:
        return furnish_layout(task, case.wishes, case.problem, boxes, energy)
    placed, missing = lay_out_parts(task, case.parts, boxes)
    return score_answer(
        task, placed, missing, build_task_problem(task, case.wishes, task.ground), energy
    )


def rows(cases: tuple[Case, ...], budget: str, seeds: int, chosen: tuple[Method, ...]) -> list[Row]:
    """Every case by every method and seed, the methods in turns, so that all share what else the
    machine does."""
    return [
        lay_out(method, case, BUDGETS[budget], seed) | {"budget": budget}
        for case in cases
        for seed in range(seeds)
        for method in chosen
    ]


def quartiles(values: list[float]) -> tuple[float, float, float]:
    """Lower quartile, median and upper quartile."""
    low, middle, high = np.quantile(values, (0.25, 0.5, 0.75))
    return float(low), float(middle), float(high)


def table(found: list[Row], group: str) -> list[Row]:
    """One row for each budget and method: quartiles of the energy, how often the method is best of
    all, how often ours is at least as good, and what stands."""
    told = []
    for budget in dict.fromkeys(row["budget"] for row in found):
        mine = [row for row in found if row["budget"] == budget]
        best = _least(mine)
        ours = {_key(row): row["energy"] for row in mine if row["method"] == OURS}
        for method in dict.fromkeys(row["method"] for row in mine):
            theirs = [row for row in mine if row["method"] == method]
            low, middle, high = quartiles([row["energy"] for row in theirs])
            line = {
                "case": group,
                "budget": budget,
                "method": method,
                "lower": low,
                "median": middle,
                "upper": high,
                "runs": len(theirs),
                "best": sum(row["energy"] <= best[_key(row)] * (1 + 1e-9) for row in theirs),
                "ours as good": sum(
                    ours[_key(row)] <= row["energy"] * (1 + 1e-9) for row in theirs
                ),
                "layouts": statistics.median(row["layouts"] for row in theirs),
                "seconds": statistics.median(row["seconds"] for row in theirs),
            }
            for key in ("stand", "whole"):
                if key in theirs[0]:
                    line[key] = statistics.fmean(row[key] for row in theirs)
            told.append(line)
    return told


def _key(row: Row) -> tuple[str, int]:
    return row["case"], row["seed"]


def _least(found: list[Row]) -> dict[tuple[str, int], float]:
    least: dict[tuple[str, int], float] = {}
    for row in found:
        least[_key(row)] = min(least.get(_key(row), np.inf), row["energy"])
    return least


def tables(
    seeds: int,
    count: int,
    budgets: tuple[str, ...] = tuple(BUDGETS),
    progress: Progress | None = None,
) -> Iterator[list[Row]]:
    """One table after the other: each instance over the seeds, the rooms once each."""
    chosen, real = methods(), rooms(count) if count else ()
    jobs: list[tuple[str, tuple[Case, ...], int, str]] = [
        (case.name, (case,), seeds, budget) for case in instances() for budget in budgets
    ]
    jobs += [(f"{count} rooms", real, 1, budget) for budget in budgets if count]
    for method in chosen:
        for case in (*instances(), *real[:1]):
            lay_out(method, case, Budget(steps=300, threads=1), 0)
    for number, (name, cases, times, budget) in enumerate(jobs):
        if progress:
            progress(number / len(jobs), f"{name}, {budget}")
        yield table(rows(cases, budget, times, chosen), name)


def records(seeds: int, count: int, budgets: tuple[str, ...] = tuple(BUDGETS)) -> Iterator[Row]:
    """As the other benchmarks tell it: our median energy against each method's."""
    for told in tables(seeds, count, budgets):
        ours = {
            (row["case"], row["budget"]): row["median"] for row in told if row["method"] == OURS
        }
        for row in (row for row in told if row["method"] != OURS):
            own = ours[row["case"], row["budget"]]
            yield {
                "case": row["case"],
                "metric": f"energy, {row['budget']}",
                "unit": "energy",
                "ours": round(own, 2),
                "baseline": round(row["median"], 2),
                "baseline_name": row["method"],
                "ratio": round(row["median"] / own, 2),
                "runs": row["runs"],
            }


def lines(told: list[Row]) -> list[str]:
    """The tables as lines of Markdown."""
    out = []
    for group in dict.fromkeys((row["case"], row["budget"]) for row in told):
        mine = [row for row in told if (row["case"], row["budget"]) == group]
        more = "stand" in mine[0]
        out += ["", f"**{group[0]}, {group[1]}** ({mine[0]['runs']} runs)", ""]
        head = ["method", "median", "quartiles", "best of all", "ours at least as good", "layouts"]
        head += ["seconds", *(("groups that stand", "rooms complete") if more else ())]
        out += ["| " + " | ".join(head) + " |", "|---" * len(head) + "|"]
        for row in sorted(mine, key=lambda r: float(r["median"])):
            cells = [
                row["method"],
                f"{row['median']:.4g}",
                f"{row['lower']:.4g} – {row['upper']:.4g}",
                str(row["best"]),
                f"{row['ours as good']} of {row['runs']}",
                f"{row['layouts']:.0f}",
                f"{row['seconds']:.3f}",
            ]
            if more:
                cells += [f"{row['stand']:.0%}", f"{row['whole']:.0%}"]
            out.append("| " + " | ".join(cells) + " |")
    return out


if __name__ == "__main__":
    import sys

    seeds, count = (int(v) for v in (sys.argv[1:] or ("10", "50")))
    for told in tables(seeds, count):
        print("\n".join(lines(told)), flush=True)
