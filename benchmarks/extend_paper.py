"""The paper's growth measured: F (22) on the plots of the terrace sample's area by searches at
1,000 evaluations, five seeds (3,000 and ten with ``--full``).

Its claim with simulated raters: :mod:`benchmarks.papers_raters`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

import scenewright as sw
from scenewright.domains import problems
from scenewright.domains.extend.solvers.ants import run_ants
from scenewright.domains.extend.solvers.colony import (
    BredPlots,
    anneal_plots,
    breed,
    climb_plots,
    draw_plots,
)
from scenewright.domains.extend.solvers.paper import PRINTED, REPAIRED, WEIGHTS, grid_of

Record = dict[str, Any]
EVALUATIONS, SEEDS = 3000, 10
USUAL = (1000, 5)
"""Evaluations and seeds unless ``full``."""
SEARCHES: dict[str, Callable[..., BredPlots]] = {
    "ants, printed": partial(run_ants, settings=PRINTED),
    "ants, elite deposit": partial(run_ants, settings=REPAIRED),
    "breeding, printed": partial(breed, settings=PRINTED),
    "breeding, repaired": partial(breed, settings=REPAIRED),
    "annealing": anneal_plots,
    "greedy": climb_plots,
    "random": draw_plots,
}


def records(
    quick: bool, progress: Callable[[float, str], None] | None = None, full: bool = False
) -> Iterator[Record]:
    """Records of all searches."""
    grid = grid_of(problems(sw.read("sample:extend-terrace"))[0])
    seeds = 2 if quick else SEEDS if full else USUAL[1]
    evaluations = 200 if quick else EVALUATIONS if full else USUAL[0]
    found = {}
    for number, (name, search) in enumerate(SEARCHES.items()):
        runs = [
            search(grid, WEIGHTS, evaluations, np.random.default_rng(seed)) for seed in range(seeds)
        ]
        found[name] = float(np.median([run.value for run in runs]))
        if progress is not None:
            progress((number + 1) / len(SEARCHES), name)
    for name, value in found.items():
        case = f"F after {evaluations} evaluations, {grid.free.sum()} plots"
        yield _record(case, name, value, found["random"], "random", seeds)


def _record(case: str, metric: str, ours: float, base: float | None, by: str, runs: int) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": "1",
        "ours": round(ours, 4),
        "baseline": None if base is None else round(base, 4),
        "baseline_name": by,
        "ratio": None if not base else round(ours / base, 3),
        "runs": runs,
    }


def page_lines(told: list[Record]) -> Iterator[str]:
    """A line a search."""
    yield f"| {told[0]['case']} | |"
    yield "|---|---|"
    yield from (f"| {row['metric']} | {row['ours']:.3f} |" for row in told)
