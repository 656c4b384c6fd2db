"""Villages against real ones: blocks of places held out, filled by every method.

Three splits by place; tables, net and library are of the training places only; outlines are
treated alike; every method is told the region of a block. ``real`` is the other half of the real
blocks against the one half, the floor of every figure. Annealing knows the real density and
near-road values and the real number of houses; ours draws its own number. Time is the processor's.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.kept import KeptRuns, open_runs
from benchmarks.spread import SpreadTable, spread_tables
from benchmarks.village_annealing import STEPS, anneal_block
from benchmarks.village_data import SPLITS, split
from benchmarks.village_foretelling import location_figures, tell_locations, tell_more
from benchmarks.village_metrics import BlockFigures, classifier_auc, divergences, figures
from scenewright.domains.village.choosing import choose_houses
from scenewright.domains.village.grow import layout_of
from scenewright.domains.village.learned.style import SHIPPED, VillageStyle, read_style
from scenewright.domains.village.learning.examples import problem_of_block
from scenewright.domains.village.learning.paper.batches import PRINTED
from scenewright.domains.village.learning.real_blocks import library_of
from scenewright.domains.village.learning.tables import RealBlock
from scenewright.domains.village.paper.filling import fill_as_paper
from scenewright.domains.village.paper.nets_file import PRINTED as PRINTED_SIZES
from scenewright.domains.village.paper.nets_file import SHIPPED as PAPER
from scenewright.domains.village.paper.nets_file import (
    read_paper_nets,
    shapes_of_nets,
    shipped_nets,
)
from scenewright.domains.village.settings import VillageSettings
from scenewright.domains.village.solvers import VILLAGE_SOLVERS
from scenewright.domains.village.solvers.growing import standing_of
from scenewright.engine.solve import Budget

Record = dict[str, Any]
Progress = Callable[[float, str], None]
METHODS = ("grow", "paper", "tables", "proposals", "annealing", "brief annealing")
MOVES = {"annealing": STEPS, "brief annealing": 4000}
"""Moves of a block; the short one takes as long as ours."""
USUAL = {"paper": 24, "tables": 40, "proposals": 40, "annealing": 6, "brief annealing": 24}
"""Blocks of a split that are filled, the same first ones; ours fills all. 40,000 moves take four
seconds."""
HOUSES = 70
"""Houses of a split whose places are foretold."""
QUICK, QUICK_HOUSES, QUICK_MOVES = 6, 10, 1000
ROOT = Path(__file__).parent.parent
STYLES = Path(__file__).parent / "styles"
CODE = (
    "benchmarks/village*.py",
    *(
        f"src/scenewright/domains/village/{name}.py"
        for name in (
            "choosing",
            "doors",
            "grow",
            "house",
            "measures",
            "proposals",
            "relations",
            "settings",
            "standing",
            "weights",
            "learned/*",
            "learning/examples",
            "learning/more_training",
            "learning/real_blocks",
            "learning/tables",
            "paper/*",
            "solvers/*",
        )
    ),
)
"""What blocks are filled and measured by: what is kept of other code is not measured again."""


def records(quick: bool, progress: Progress | None = None, full: bool = False) -> Iterator[Record]:
    """A record for every split, method and measure; ``full`` takes every block and house. Blocks
    and houses once done are kept."""
    tables = []
    for name in list(SPLITS)[:1] if quick else SPLITS:
        jobs: list[Callable[[], Any]] = []
        for method in methods_of_split(name):
            usual = 2 if method == "annealing" else QUICK
            most = usual if quick else USUAL.get(method)
            moves = QUICK_MOVES if quick else MOVES.get(method, 0)
            jobs.append(partial(fill_split, name, method, None if full else most, moves, True))
        jobs.append(partial(foretell_split, name, QUICK_HOUSES if quick else HOUSES, quick, full))
        tables.append(SpreadTable(name, jobs, partial(_records, name)))
    yield from spread_tables(tables, progress)


def foretell_split(name: str, houses: int, quick: bool, full: bool) -> list[Record]:
    """Where the next house stands, and whether there is one, on held-out blocks."""
    train, test = split(name)
    style = style_of_split(name)
    few, told = train[:40] if quick else train, 10**9 if full else houses
    nets = read_paper_nets(path_of_paper(name)) if path_of_paper(name).exists() else None
    kept = open_runs(f"village-{name}-places{'-quick' * quick}", (*CODE, *_files(name, "places")))
    found = tell_locations(style, few, test, told, 3, nets, kept)
    rows = list(location_figures(found))
    even = {metric: value for method, metric, value in rows if method == "proposals"}
    runs = len(found["net"])
    made = [_record(name, m, f, v, even.get(f), runs, "proposals") for m, f, v in rows]
    law, number = tell_more(style, test, 3)
    made.append(_record(name, "law of more", "continue AUC", law, number, 4 * len(test), "number"))
    return made


def path_of_style(name: str) -> Path:
    """The style learned from the training places of a split: that of A ships, those of the others
    lie beside the benchmark."""
    return SHIPPED if name == "A" else STYLES / f"village_{name}.npz"


def path_of_paper(name: str) -> Path:
    """The paper's networks learned from the training places of a split, as those of styles."""
    return PAPER if name == "A" else STYLES / f"paper_{name}.npz"


def methods_of_split(name: str) -> list[str]:
    """The methods that can be measured on a split."""
    return [m for m in METHODS if m != "paper" or path_of_paper(name).exists()]


def style_of_split(name: str) -> VillageStyle:
    """The style of a split."""
    return read_style(path_of_style(name))


def fill_split(
    name: str, method: str, most: int | None, steps: int, keep: bool = False
) -> tuple[list[BlockFigures], list[BlockFigures], float, float]:
    """Held-out blocks of a split as they are and, the same ones, as filled; processor seconds a
    block, and the median ratio of void to real."""
    train, test = split(name)
    houses = library_of(train)
    style = style_of_split(name)
    order = np.random.default_rng(7).permutation(len(test))[:most]
    kept = KeptRuns(Path(), {})
    if keep:
        kept = open_runs(f"village-{name}-{method}-{steps}", (*CODE, *_files(name, method)))
    both, took = [], []
    for k, number in enumerate(order.tolist()):
        make = partial(_fill_and_measure, name, test[number], houses, style, method, k, steps)
        real, made, seconds = kept.have(f"{k}", make) if keep else make()
        took.append(seconds)
        if len(made[0]):
            both.append((_figures_of(real), _figures_of(made)))
    ratios = [made.void / real.void for real, made in both if real.void > 0]
    every = [real for real, _ in both], [made for _, made in both]
    return *every, float(np.mean(took)), float(np.median(ratios))


def _figures_of(row: Sequence[Any]) -> BlockFigures:
    return BlockFigures(np.array(row[0]), *row[1:])


def _fill_and_measure(
    name: str,
    block: RealBlock,
    houses: Sequence[Any],
    style: VillageStyle,
    method: str,
    seed: int,
    steps: int,
) -> tuple[list[Any], list[Any], float]:
    """The figures of a block as it is and as filled, as plain lists, and processor seconds."""
    begun = time.process_time()
    filled = _fill(name, block, houses, style, method, seed, steps)
    took = time.process_time() - begun
    rows: list[list[Any]] = []
    for standing in (block.standing, filled):
        told = figures(block.floor, block.streets, standing) if len(standing.shapes) else None
        rows.append([[], 0.0, 0.0, 0.0] if told is None else [told.rows.tolist(), *told[1:]])
    return rows[0], rows[1], took


def _files(name: str, method: str) -> list[str]:
    """What else than code a method is read from, relative to the checkout: a trained net. (The
    tables and houses of a style follow from the code and the training places.)"""
    nets = {"grow": [path_of_style(name)], "paper": [path_of_paper(name)]}
    nets["places"] = [*nets["grow"], *nets["paper"]]
    return [str(path.relative_to(ROOT)) for path in nets.get(method, []) if path.exists()]


def _fill(
    name: str,
    block: RealBlock,
    houses: Sequence[Any],
    style: VillageStyle,
    method: str,
    seed: int,
    steps: int,
) -> Any:
    rng = np.random.default_rng(seed)
    problem = problem_of_block(block, houses, style, VillageSettings())
    if method in MOVES:
        counted = problem._replace(asked=len(block.houses))
        picked = choose_houses(counted, rng)
        return anneal_block(block, [houses[k] for k in picked], seed, steps)
    if method == "paper":
        filled = fill_as_paper(read_paper_nets(path_of_paper(name)), problem, rng)
        layout = layout_of(problem, filled.houses, filled.poses)
    else:
        layout = VILLAGE_SOLVERS[method].run(problem, Budget(steps=3), seed).layouts[0]
    return standing_of(problem, layout)


def _records(name: str, results: list[Any]) -> Iterator[Record]:
    *found, foretold = results
    real = found[0][0]
    half = np.random.default_rng(1).permutation(len(real))
    one, other = ([real[k] for k in part] for part in np.array_split(half, 2))
    floor = {**divergences(one, other), "AUC": classifier_auc(one, other)}
    for method, (truth, made, took, ratio) in zip(methods_of_split(name), found, strict=True):
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
    yield from foretold


def _mean(blocks: Sequence[BlockFigures], value: Callable[[BlockFigures], float]) -> float:
    return float(np.mean([value(block) for block in blocks]))


def _record(
    name: str,
    method: str,
    metric: str,
    value: float,
    floor: float | None,
    runs: int,
    floor_name: str = "real against real",
) -> Record:
    return {
        "case": f"split {name}, {method}",
        "metric": metric,
        "unit": _unit(metric),
        "ours": round(value, 4),
        "baseline": None if floor is None else round(floor, 4),
        "baseline_name": "" if floor is None else floor_name,
        "ratio": None if not floor else round(value / floor, 2),
        "runs": runs,
    }


def _unit(metric: str) -> str:
    units = {"seconds": "s", "KL": "nats", "nats": "nats", "places": "m"}
    return next((unit for word, unit in units.items() if word in metric), "1")


def markdown_lines(found: Sequence[Record]) -> list[str]:
    """Means of the splits: one row a measure, one column a method."""
    methods = list(dict.fromkeys(str(row["case"]).split(", ", 1)[1] for row in found))
    metrics = list(dict.fromkeys(str(row["metric"]) for row in found))
    heads = [f"{name}, {tell_share()}" if name.startswith("paper") else name for name in methods]
    lines = [f"| measure | {' | '.join(heads)} | against |", "|---" * (len(methods) + 2) + "|"]
    for metric in metrics:
        rows = [row for row in found if row["metric"] == metric]
        cells = [
            _mean_cell([r["ours"] for r in rows if r["case"].endswith(f", {m}")]) for m in methods
        ]
        told = _mean_cell([r["baseline"] for r in rows if r["baseline"] is not None])
        lines.append(f"| {metric} | {' | '.join(cells)} | {told} |")
    return lines


def tell_share() -> str:
    """How much of what is printed the shipped networks of the paper had.

    >>> tell_share()
    '1/73 of the weights, 0.3–3.3 % of the epochs'
    """
    nets = shipped_nets()
    shares = [100 * epochs / PRINTED.epochs[name] for name, epochs in nets.card["epochs"].items()]
    whole, own = (
        sum(math.prod(shape) for _, shape in shapes_of_nets(sizes))
        for sizes in (PRINTED_SIZES, nets.sizes)
    )
    most = f"{min(shares):.1f}–{max(shares):.1f} % of the epochs"
    return f"1/{whole / own:.0f} of the weights, {most}"


def _mean_cell(values: Sequence[float]) -> str:
    return f"{np.mean(values):.3f}" if values else "–"
