"""The tables of Cao, Cheng and Zhang (2024) on our halls: ``scenewright bench papers_halls``.

Their three measures (eqs. 7 to 9) of every sample by every method, with the share of valid runs,
the energy above its floor and the seconds; then the energies of eqs. 1 and 3 as printed beside the
repaired ones as a group is spread out. Measures, energy and seconds are of the runs that are valid
and place everything, of all runs where a method has none such. ``error`` is the standard error of
the mean: what lies within one of each other counts as equal.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from benchmarks.hall_measure import posed
from benchmarks.hall_methods import METHODS, halls, judged, methods
from benchmarks.stages import Stage, run_stages
from scenewright.core.brief import Brief
from scenewright.domains.hall.patterns import CHAIN, GRID
from scenewright.domains.hall.settings import HallSettings
from scenewright.domains.hall.solvers.chains import begin_chain
from scenewright.domains.hall.solving import solve
from scenewright.domains.hall.terms.place import unfold
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.table import FILL, SPACE
from scenewright.domains.hall.terms.whole import measure_frames
from scenewright.engine.draws import streams
from scenewright.formats import read

Row = dict[str, Any]
Progress = Callable[[float, str], None]

BETTER = {"aesthetic": 1.0, "uniformity": -1.0, "circulation": -1.0}
"""The three measures, and whether more or less of each is better."""
FIGURES = (
    ("aesthetic", "1"),
    ("uniformity", "1"),
    ("circulation", "m"),
    ("excess", "1"),
    ("seconds", "s"),
)
PRINTED = {"paper": {"preset": "paper"}, "paper-repaired": {"preset": "paper-repaired"}}
SEEDS, QUICK_SEEDS = 20, 1
QUICK = ("sample:hall-irregular",)
SPREADS = (0.0, 0.3, 0.6, 0.9, 1.2)
"""Metres by which the gaps of all rows are widened."""


class MeasuredFigure(NamedTuple):
    """The mean of a figure over runs, its standard error, and of how many runs it is."""

    mean: float
    error: float
    runs: int


def compared(case: str) -> Brief:
    """The brief of a sample as all methods are given it: where it asks for a fan, rows may be
    straight too, as those of methods that know no patterns always are."""
    document = read(case).model_dump()
    for room in document["rooms"]:
        for demand in room["demands"]:
            if demand["patterns"] == ["fan"]:
                demand["patterns"] = ["fan", "chain"]
    return Brief.model_validate(document)


def run(case: str, method: str, seed: int) -> Row:
    """One sample by one method, with the energy above its floor."""
    options = PRINTED.get(method) or METHODS[method]
    row = judged(solve(compared(case), seed=seed, **options))
    row["excess"] = row["energy"] - row["least"]
    return {"case": case, "method": method, "seed": seed, "whole": not row["left_out"]} | row


def counted(rows: list[Row]) -> list[Row]:
    """The runs that are valid and place everything: dropping objects raises the first measure."""
    return [row for row in rows if row["valid"] and row["whole"]]


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


def names() -> list[str]:
    """The methods that run here, the paper's printed and repaired presets among them."""
    return [*(name for name in methods() if name != "paper"), *PRINTED]


def table(case: str, seeds: int, among: list[str]) -> Iterator[Row]:
    """Records of one sample: every figure of every method beside ours, then the verdict."""
    found: dict[str, list[Row]] = {}
    for method in among:
        solve(compared(case), seed=0, **(PRINTED.get(method) or METHODS[method]))
        found[method] = [run(case, method, seed) for seed in range(seeds)]
        yield from _against(case, method, found["default"], found[method])
    rivals = {name: rows for name, rows in found.items() if name != "default" and counted(rows)}
    for name in BETTER:
        ours = figure(found["default"], name)
        beaten = [no_worse(ours, figure(rows, name), name) for rows in rivals.values()]
        record = _record(case, f"{name}: no worse than", "1", float(sum(beaten)), len(beaten))
        yield record | {"baseline_name": "methods with a valid run", "runs": ours.runs}


def _against(case: str, method: str, ours: list[Row], theirs: list[Row]) -> Iterator[Row]:
    shares = [len(counted(rows)) / len(rows) for rows in (ours, theirs)]
    record = _record(case, "valid and complete", "share", *shares)
    yield record | {"baseline_name": method, "runs": len(theirs)}
    for name, unit in FIGURES:
        a, b = figure(ours, name), figure(theirs, name)
        record = _record(case, name, unit, a.mean, b.mean)
        errors = {"error": round(a.error, 5), "baseline_error": round(b.error, 5)}
        valid = method if counted(theirs) else f"{method}, no valid run"
        yield record | errors | {"baseline_name": valid, "runs": b.runs}


def _record(case: str, metric: str, unit: str, ours: float, baseline: float) -> Row:
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


def printed_forms(case: str) -> Iterator[Row]:
    """E_s and E_u, repaired (ours) and as printed (baseline), of one first layout as the gaps of
    all its rows are spread out: the printed E_u stays the same, the printed E_s saturates."""
    ready = posed(compared(case), 0, printed=True).fitted
    for metres in SPREADS:
        kept = spread_rows(ready.start, metres)
        for term, name in ((SPACE, "E_s"), (FILL, "E_u")):
            costs = []
            for printed in (False, True):
                problem = ready.problem._replace(settings=HallSettings(printed=printed))
                chain = begin_chain(problem, ready.start, streams(0, 1)[0])
                chain.s.layers[:] = kept.layers
                for unit in range(len(chain.p.spans)):
                    unfold(chain.p, chain.s, chain.work, unit)
                measure_frames(chain.p, chain.s, chain.work, False)
                costs.append(float(chain.s.costs[term].sum()))
            record = _record(case, f"{name}, gaps {metres:+.1f} m", "1", *costs)
            yield record | {"baseline_name": "as printed", "runs": 1}


def spread_rows(start: Kept, metres: float) -> Kept:
    """A layout whose rows have wider gaps, along and across."""
    layers = start.layers.copy()
    rows = np.isin(layers[:, 3], (CHAIN, GRID))
    layers[rows, 1:3] += metres
    return start._replace(layers=layers)


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Row]:
    """All records; ``quick`` takes one sample, one seed and two methods."""
    among = ["default", "paper", "paper-repaired"] if quick else names()
    seeds = QUICK_SEEDS if quick else SEEDS
    cases = list(QUICK) if quick else halls()
    stages: list[Stage] = [(case, partial(table, case, seeds, among)) for case in cases]
    stages += [(f"printed forms, {case}", partial(printed_forms, case)) for case in cases]
    yield from run_stages(stages, progress)
