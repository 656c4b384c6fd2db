"""What each aim of our default on sites is for: with it alone, with all, and with none.

    scenewright bench site_aims

Medians over seeds on the shipped samples; the baseline is the same filling without any aim.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator
from typing import Any

from benchmarks.comparison import ratio
from benchmarks.site_scale import sites
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solving import problems
from scenewright.domains.site.terms.table import SITE_AIMS
from scenewright.engine.solve import Budget
from scenewright.formats import read

Record = dict[str, Any]
NONE = {row.name: 0.0 for row in SITE_AIMS}
METRICS = {"seen": "V from the ways", "sun": "hours on fronts", "placed": "buildings"}


def judged(problem: SiteProblem, weights: dict[str, float], seed: int) -> dict[str, float]:
    """What a filling with some weights scores."""
    weighed = problem._replace(weights=weights)
    found = SITE_SOLVERS["fill"].run(weighed, Budget(None, 8), seed).layouts[0]
    told = score(problem, found.boxes, found.present)
    return told | {"placed": float(found.present.sum())}


def medians(problem: SiteProblem, weights: dict[str, float], seeds: int) -> dict[str, float]:
    """Medians of the metrics over seeds."""
    rows = [judged(problem, weights, seed) for seed in range(seeds)]
    return {name: statistics.median(row[name] for row in rows) for name in METRICS}


def records(quick: bool, progress: Callable[[float, str], None]) -> Iterator[Record]:
    """One record for each sample, aim and metric."""
    variants = {row.name: NONE | {row.name: row.weight} for row in SITE_AIMS} | {"all": {}}
    names = sites()[: 1 if quick else None]
    seeds = 3 if quick else 9
    for number, name in enumerate(names):
        progress(number / len(names), name)
        problem = problems(read(name))[0]
        none = medians(problem, NONE, seeds)
        for aim, weights in variants.items():
            ours = medians(problem, weights, seeds)
            for metric, unit in METRICS.items():
                yield {
                    "case": f"{name}, aim {aim}",
                    "metric": metric,
                    "unit": unit,
                    "ours": ours[metric],
                    "baseline": none[metric],
                    "baseline_name": "no aim",
                    "ratio": ratio(ours[metric], none[metric], unit),
                    "runs": seeds,
                }
