"""The three measures of Cao, Cheng and Zhang (2024, eqs. 7 to 9) by every method, in one table.

Measures, energy and seconds are of the runs that are valid and place everything, of all runs where
a method has none such. ``error`` is the standard error of the mean: what lies within one of each
other counts as equal. Layouts drawn by hand (:mod:`.papers_halls_scenes`) stand beside. All
methods start from the same first layout and have the budgets of their
papers; ``layouts`` is how many each looked at.
"""

from __future__ import annotations

import statistics
import time
from collections.abc import Iterator
from functools import cache, partial
from typing import Any, NamedTuple

from benchmarks.hall_methods import METHODS, judged, methods
from benchmarks.papers_halls_scenes import SCENES, by_hand, read_scene
from benchmarks.spread import SpreadTable
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.solving import solve
from scenewright.formats import read

Row = dict[str, Any]

BETTER = {"aesthetic": 1.0, "uniformity": -1.0, "circulation": -1.0}
"""The three measures, and whether more or less of each is better."""
FIGURES = (
    ("aesthetic", "1"),
    ("uniformity", "1"),
    ("circulation", "m"),
    ("excess", "1"),
    ("seconds", "s"),
)
PRINTED = {name: {"preset": name} for name in ("paper", "paper-repaired", "paper-strict")}
BEST = "excess beside the paper's best valid run"
OURS, HAND = "default", "by hand"
WARM = "sample:hall-irregular"
"""What a method lays out once in each process before it is timed: kernels are loaded then."""


LOOSE = "sample:hall-auditorium, lounge seats in rows too"
"""The auditorium where lounge seats may stand in any pattern of free objects."""
UNHUNG = "walls not asked"


class MeasuredFigure(NamedTuple):
    """The mean of a figure over runs, its standard error, and of how many runs it is."""

    mean: float
    error: float
    runs: int


def compared(case: str) -> Brief:
    """The brief of a sample as all methods are given it: where it asks for a fan, rows may be
    straight too, as those of methods that know no patterns always are. In :data:`LOOSE` lounge
    seats need not stand round low tables, as they usually do."""
    document = read_scene("sample:hall-auditorium" if case == LOOSE else case).model_dump()
    for room in document["rooms"]:
        for demand in room["demands"]:
            if case == LOOSE and demand["category"] == "lounge_seat":
                demand["patterns"] = ["around", "chain", "grid", "radiation"]
            if demand["patterns"] == ["fan"]:
                demand["patterns"] = ["fan", "chain"]
    return Brief.model_validate(document)


def names() -> list[str]:
    """The methods that run here, the paper's printed and repaired presets among them."""
    return [*(name for name in methods() if name != "paper"), *PRINTED]


def run(case: str, method: str, seed: int) -> Row:
    """One sample by one method on one thread, with the energy above its floor; ``seconds`` are
    the processor's."""
    brief, options = compared(case), _warm(method)
    begun = time.process_time()
    solution = solve(brief, seed=seed, threads=1, **options)
    seconds = time.process_time() - begun
    return {"case": case, "method": method, "seed": seed} | measured(solution, seconds)


def measured(solution: Solution, seconds: float) -> Row:
    """A solution as a row of the table."""
    row, walls = judged(solution), sum(p.category == "partition" for p in solution.pieces)
    hung = bool(row["valid"]) or row["no_wall"] == row["faults"]
    more = {"excess": row["energy"] - row["least"], "whole": not row["left_out"], "unhung": hung}
    size = {"objects": row["pieces"] - walls, "walls": walls}
    return row | more | size | {"seconds": seconds, "layouts": solution.evaluations}


def run_by_hand(case: str) -> Row:
    """The layout drawn by hand, which took no seconds that can be compared."""
    return {"case": case, "method": HAND, "seed": 0} | measured(by_hand(case), 0.0)


@cache
def _warm(method: str) -> Row:
    """What a method is called with, once it has run in this process."""
    options = PRINTED.get(method) or METHODS[method]
    solve(read(WARM), seed=0, threads=1, **options)
    return options


def counted(rows: list[Row]) -> list[Row]:
    """The runs that are valid and place everything: dropping objects raises the first measure."""
    return [row for row in rows if row["valid"] and row["whole"]]


def forgiven(rows: list[Row]) -> list[Row]:
    """The same runs where what hangs needs no wall: those without another fault are valid."""
    return [row | {"valid": float(row["unhung"])} for row in rows]


def figure(rows: list[Row], name: str) -> MeasuredFigure:
    """A figure over the runs that count, else over all.

    >>> run = {"valid": 1.0, "whole": True}
    >>> figure([run | {"a": 1.0}, run | {"a": 3.0}], "a")
    MeasuredFigure(mean=2.0, error=1.0, runs=2)
    """
    values = [float(row[name]) for row in counted(rows) or rows]
    error = statistics.stdev(values) / len(values) ** 0.5 if len(values) > 1 else 0.0
    return MeasuredFigure(statistics.fmean(values), error, len(values))


def no_worse(ours: MeasuredFigure, theirs: MeasuredFigure, name: str) -> bool:
    """Whether a mean is at least as good as another, within one standard error of the difference
    (both taken to spread alike, as one run alone says nothing of its spread).

    >>> no_worse(MeasuredFigure(1.0, 0.3, 9), MeasuredFigure(1.3, 0.1, 9), "aesthetic")
    True
    """
    runs = ours.runs + theirs.runs
    squares = [(one.error**2) * one.runs * (one.runs - 1) for one in (ours, theirs)]
    spread = (sum(squares) / max(runs - 2, 1)) ** 0.5
    error = spread * (1 / ours.runs + 1 / theirs.runs) ** 0.5
    return BETTER[name] * (ours.mean - theirs.mean) >= -error - 1e-9


def measures(case: str, seeds: int, among: list[str]) -> SpreadTable:
    """The table of one sample: every figure of every method beside ours, then the verdict."""
    jobs = [partial(run, case, method, seed) for method in among for seed in range(seeds)]
    jobs += [partial(run_by_hand, case)] if case in SCENES else []
    return SpreadTable(f"measures, {case}", jobs, partial(compare_methods, case))


def compare_methods(case: str, rows: list[Row]) -> Iterator[Row]:
    """Records of one sample: each method beside ours; then how many of those with a valid run
    ours is no worse than, by each measure."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row["method"], []).append(row)
    for method, theirs in found.items():
        yield from _against(case, method, found[OURS], theirs)
    for name in BETTER:
        yield _beaten(case, found, name, "")
    yield from best_of_paper(case, found)
    lax = {name: forgiven(rows) for name, rows in found.items()}
    if any(len(counted(lax[name])) > len(counted(rows)) for name, rows in found.items()):
        yield from _without_walls(case, found, lax)


def _beaten(case: str, found: dict[str, list[Row]], name: str, when: str) -> Row:
    """How many methods with a valid run ours is no worse than, by one measure."""
    rivals = {name: rows for name, rows in found.items() if name != OURS and counted(rows)}
    ours = figure(found[OURS], name)
    beaten = [no_worse(ours, figure(rows, name), name) for rows in rivals.values()]
    worse = [name for name, good in zip(rivals, beaten, strict=True) if not good]
    told = make_record(case, f"{name}: no worse than{when}", "1", float(sum(beaten)), len(beaten))
    rival = "methods with a valid run" + (f", not {', '.join(worse)}" if worse else "")
    return told | {"baseline_name": rival, "runs": ours.runs}


def _without_walls(
    case: str, found: dict[str, list[Row]], lax: dict[str, list[Row]]
) -> Iterator[Row]:
    """The measures of methods that have more valid runs where what hangs needs no wall, and the
    verdicts over all methods then."""
    for method, rows in lax.items():
        number = len(counted(rows))
        if number > len(counted(found[method])):
            for name in BETTER:
                a, b = figure(lax[OURS], name), figure(rows, name)
                told = make_record(case, f"{name}, {UNHUNG}", "1", a.mean, b.mean)
                yield told | {"baseline_name": method, "runs": number}
    for name in BETTER:
        yield _beaten(case, lax, name, f", {UNHUNG}")


def best_of_paper(case: str, found: dict[str, list[Row]]) -> Iterator[Row]:
    """Our mean energy above its floor beside the least of the paper's valid runs: as printed, else
    with the referee's rules as refusals."""
    ours = figure(found[OURS], "excess")
    for method in ("paper", "paper-strict"):
        runs = counted(found.get(method, []))
        if runs:
            least = min(float(row["excess"]) for row in runs)
            told = make_record(case, BEST, "1", ours.mean, least)
            name = f"{method}, best of {len(runs)} valid runs"
            yield told | {"baseline_name": name, "runs": ours.runs}
            return


def _against(case: str, method: str, ours: list[Row], theirs: list[Row]) -> Iterator[Row]:
    shares = [len(counted(rows)) / len(rows) for rows in (ours, theirs)]
    told = make_record(case, "valid and complete", "share", *shares)
    sizes = {
        name: round(statistics.fmean(row[name] for row in theirs), 2)
        for name in ("layouts", "objects", "walls")
    }
    yield told | {"baseline_name": method, "runs": len(theirs)} | sizes
    for name, unit in FIGURES if method != HAND else FIGURES[:-1]:
        a, b = figure(ours, name), figure(theirs, name)
        told = make_record(case, name, unit, a.mean, b.mean)
        errors = {"error": round(a.error, 5), "baseline_error": round(b.error, 5)}
        valid = method if counted(theirs) else f"{method}, no valid run"
        yield told | errors | {"baseline_name": valid, "runs": b.runs}


def make_record(case: str, metric: str, unit: str, ours: float, baseline: float) -> Row:
    """A record of a benchmark, without the names of what is compared and of how many runs."""
    ratio = round(ours / baseline, 4) if baseline else None
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 5),
        "baseline": round(baseline, 5),
        "baseline_name": "",
        "ratio": ratio,
        "runs": 0,
    }
