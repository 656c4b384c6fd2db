"""Villages against real ones: blocks of places held out, filled by every method.

Three splits by place; tables and library are of the training places only; outlines are treated
alike. ``real`` is the other half of the real blocks against the one half, the floor of every
figure. Annealing knows the real density and near-road values and the real number of houses; ours
draws its own number. Time is the processor's.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import numpy as np
import shapely

from benchmarks.spread import SpreadTable, spread_tables
from benchmarks.village_annealing import STEPS, anneal_block
from benchmarks.village_data import SPLITS, library_of, split
from benchmarks.village_metrics import BlockFigures, classifier_auc, divergences, figures
from scenewright.domains.village.grow import choose_houses
from scenewright.domains.village.learning.tables import RealBlock, learn_manner
from scenewright.domains.village.problem import VillageProblem, stand
from scenewright.domains.village.settings import VillageSettings
from scenewright.domains.village.solvers import VILLAGE_SOLVERS
from scenewright.domains.village.solvers.growing import standing_of
from scenewright.engine.solve import Budget

Record = dict[str, Any]
Progress = Callable[[float, str], None]
METHODS = ("grow", "proposals", "annealing")
ANNEALED = 12
"""Blocks of a split that are annealed: 40,000 moves take ten seconds each."""
QUICK = 6


def records(quick: bool, progress: Progress | None = None, full: bool = False) -> Iterator[Record]:
    """A record for every split, method and measure; ``full`` anneals every block."""
    names = list(SPLITS)[:1] if quick else list(SPLITS)
    most = {"grow": QUICK if quick else None, "proposals": QUICK if quick else None}
    steps = 2000 if quick else STEPS
    most["annealing"] = 2 if quick else None if full else ANNEALED
    tables = [
        SpreadTable(
            name,
            [partial(fill_split, name, method, most[method], steps) for method in METHODS],
            partial(_records, name),
        )
        for name in names
    ]
    yield from spread_tables(tables, progress)


def problem_of(
    block: RealBlock, houses: Sequence[Any], settings: VillageSettings
) -> VillageProblem:
    """The problem of filling a real block anew."""
    shapely.prepare(block.floor)
    lines = shapely.union_all(shapely.linestrings(block.streets))
    walkable = shapely.union(block.floor, shapely.buffer(lines, 2.0))
    return VillageProblem(
        block.name,
        block.floor,
        block.streets,
        block.street_share,
        walkable,
        stand([], []),
        tuple(houses),
        None,
        None,
        settings.manner.sizes,
        settings,
        shapely.Polygon(),
    )


def fill_split(
    name: str, method: str, most: int | None, steps: int
) -> tuple[list[BlockFigures], list[BlockFigures], float, float]:
    """The held-out blocks of a split as they are and as filled; processor seconds a block, and the
    median ratio of void to real."""
    train, test = split(name)
    houses = library_of(train)
    settings = VillageSettings(manner=learn_manner(train))
    order = np.random.default_rng(7).permutation(len(test))[:most]
    chosen = [test[k] for k in order]
    begun = time.process_time()
    filled = [_fill(block, houses, settings, method, k, steps) for k, block in enumerate(chosen)]
    took = (time.process_time() - begun) / len(chosen)
    pairs = zip(chosen, filled, strict=True)
    made = [figures(block.floor, block.streets, one) for block, one in pairs if len(one.shapes)]
    real = [figures(block.floor, block.streets, block.standing) for block in test]
    mine = [real[k] for k in order]
    ratios = [m.void / r.void for m, r in zip(made, mine, strict=False) if r.void > 0]
    return real, made, took, float(np.median(ratios))


def _fill(
    block: RealBlock,
    houses: Sequence[Any],
    settings: VillageSettings,
    method: str,
    seed: int,
    steps: int,
) -> Any:
    problem = problem_of(block, houses, settings)
    if method == "annealing":
        counted = problem._replace(asked=len(block.houses))
        picked = choose_houses(counted, np.random.default_rng(seed))
        return anneal_block(block, [houses[k] for k in picked], seed, steps)
    layout = VILLAGE_SOLVERS[method].run(problem, Budget(steps=3), seed).layouts[0]
    return standing_of(problem, layout)


def _records(name: str, found: list[Any]) -> Iterator[Record]:
    real = found[0][0]
    half = np.random.default_rng(1).permutation(len(real))
    one, other = ([real[k] for k in part] for part in np.array_split(half, 2))
    floor = {**divergences(one, other), "AUC": classifier_auc(one, other)}
    for method, (truth, made, took, ratio) in zip(METHODS, found, strict=True):
        told = {**divergences(truth, made), "AUC": classifier_auc(truth, made)}
        told["void against real"] = ratio
        told["houses against real"] = _mean(made, lambda b: len(b.rows)) / _mean(
            truth, lambda b: len(b.rows)
        )
        told["coverage against real"] = _mean(made, lambda b: b.coverage) / _mean(
            truth, lambda b: b.coverage
        )
        told["faulty houses"] = _mean(made, lambda b: b.faulty)
        told["CPU seconds a block"] = took
        for metric, value in told.items():
            yield _record(name, method, metric, value, floor.get(metric), len(made))


def _mean(blocks: Sequence[BlockFigures], value: Callable[[BlockFigures], float]) -> float:
    return float(np.mean([value(block) for block in blocks]))


def _record(
    name: str, method: str, metric: str, value: float, floor: float | None, runs: int
) -> Record:
    return {
        "case": f"split {name}, {method}",
        "metric": metric,
        "unit": "s" if "seconds" in metric else "nats" if "KL" in metric else "1",
        "ours": round(value, 4),
        "baseline": None if floor is None else round(floor, 4),
        "baseline_name": "" if floor is None else "real against real",
        "ratio": None if not floor else round(value / floor, 2),
        "runs": runs,
    }
