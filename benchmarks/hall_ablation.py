"""What each of the paper's four energies is for: each weight zeroed in turn (its Fig. 6).

Without the space, clearances are covered; without the fill, zones stay empty; without the access,
a group blocks the passage; without the proportion, a group takes too much. Each failure is one
figure, beside the same figure with all weights: in the shipped samples, in three of which walls
are generated, and in a hall made so that all four have room to fail.
"""

from __future__ import annotations

import statistics
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from benchmarks.hall_measure import gaps_of, posed
from benchmarks.spread import SpreadTable
from scenewright.core.brief import Brief
from scenewright.domains.hall.energy import make_state, prepare
from scenewright.domains.hall.patterns import NUMBER, SINGLE, WALL
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.chains import anneal_hall, gd_mh
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.domains.hall.terms.measure import passage
from scenewright.domains.hall.terms.state import PreparedHall, State, make_scratch
from scenewright.domains.hall.terms.table import NEAR, PRINTED
from scenewright.engine.solve import Budget
from scenewright.formats import read

Row = dict[str, Any]
CASE = "crowded lobby, roomy gallery"
HALL = {
    "format": "scenewright/brief",
    "version": 1,
    "domain": "hall",
    "name": CASE,
    "rooms": [
        {
            "id": "hall",
            "height": 4.0,
            "outline": [[0, 0], [10, 0], [10, 5], [24, 5], [24, 14], [10, 14], [10, 9], [0, 9]],
            "doors": [{"id": "entrance", "at": [0, 2.0], "width": 1.8, "swing": "out"}],
            "zones": [
                {"id": "lobby", "outline": [[0, 0], [10, 0], [10, 9], [0, 9]]},
                {"id": "gallery", "outline": [[10, 5], [24, 5], [24, 14], [10, 14]]},
            ],
            "links": [{"between": ["lobby", "gallery"], "width": 2.4}],
            "demands": [
                {
                    "id": "tables",
                    "category": "display_table",
                    "count": 6,
                    "zone": "lobby",
                    "size": [1.4, 0.8, 0.9],
                    "clearance": 0.6,
                    "patterns": ["grid", "chain"],
                },
                {"id": "desk", "category": "info_desk", "zone": "lobby"},
                {
                    "id": "cases",
                    "category": "showcase",
                    "count": 6,
                    "zone": "gallery",
                    "clearance": 0.5,
                    "patterns": ["grid", "chain", "radiation"],
                },
                {
                    "id": "busts",
                    "category": "plinth",
                    "count": 4,
                    "zone": "gallery",
                    "clearance": 0.5,
                    "patterns": ["grid", "chain"],
                },
            ],
        }
    ],
}
"""A hall in which all four failures have room: a small full zone with a narrow way into a large
one that holds little."""
STEPS = 24_000
VARIANTS = ("all", *PRINTED)
"""All weights, then each of them zeroed."""
FIGURES = {
    "space": ("covered", "share of the clearance that is covered"),
    "fill": ("use", "least share of a zone that is in use"),
    "access": ("passage", "narrowest passage, of what it must be"),
    "proportion": ("gap", "widest gap of neighbours, of the widest wished for"),
}
"""For each energy the figure that shows its failure, and what it is."""


class Ablated(NamedTuple):
    """A layout found without one of the weights: the problem, the layout, and its figures."""

    problem: HallProblem
    layout: MeasuredLayout
    figures: dict[str, float]


def ablated(brief: Brief, without: str, seed: int, solver: str) -> Ablated:
    """The paper's preset (``gd-mh``), or our chains (``anneal``) on its four energies."""
    ready = posed(brief, seed, printed=True).fitted
    weights = {name: float(name != without) for name in PRINTED}
    problem = ready.problem._replace(weights=weights)
    run, steps = (gd_mh, 1000) if solver == "gd-mh" else (anneal_hall, STEPS)
    layout = run(problem, ready.start, Budget(steps=steps), seed).layouts[0]
    return Ablated(problem, layout, figures_of(problem, layout))


def figures_of(problem: HallProblem, layout: MeasuredLayout) -> dict[str, float]:
    """The four figures of a layout, the greatest share of its zone that a group takes, and how
    many walls are generated."""
    p = prepare(problem)
    s, work = make_state(p), make_scratch(p)
    bring_back(p, s, work, layout.kept)
    alpha = s.covered.sum(axis=1)
    used = np.bincount(p.zones, s.extent[:, 0], len(p.zone_areas)) / p.zone_areas
    held = np.unique(p.zones)
    wide = [passage(p, s, work, k) / link[2] for k, link in enumerate(p.links)]
    return {
        "covered": float(alpha.sum() / p.beta.sum()),
        "use": float(used[held].min()),
        "passage": float(min(wide, default=1.0)),
        "gap": max((widest_gap(p, s, layout.boxes, u) for u in range(len(p.spans))), default=0.0),
        "extent": float((s.extent[:, 0] / p.zone_areas[p.zones]).max()),
        "walls": int((layout.kept.walls[:, 1] > layout.kept.walls[:, 0]).sum()),
    }


def widest_gap(p: PreparedHall, s: State, boxes: Floats, unit: int) -> float:
    """max μ / μ_max over the neighbours of a unit; 0 for single objects and rows at walls."""
    if s.code[unit] in (SINGLE, WALL):
        return 0.0
    most, i = 0.0, int(p.spans[unit, 0])
    first = int(p.layer_spans[unit, 0])
    for k in range(int(s.used[unit])):
        number = int(s.layers[first + k, NUMBER])
        pairs = [(i + j, i + j + 1) for j in range(number - 1)]
        pairs += [(i, i + number)] if k + 1 < s.used[unit] else []
        for a, b in pairs:
            gap = float(gaps_of(boxes[[a, b]])[0, 1])
            most = max(most, gap / (p.iota[a] + p.iota[b] + NEAR))
        i += number
    return most


def rows(seeds: int, case: str = CASE, solver: str = "gd-mh") -> list[Row]:
    """A row for every variant and seed."""
    return [run(case, solver, without, seed) for without in VARIANTS for seed in range(seeds)]


def run(case: str, solver: str, without: str, seed: int) -> Row:
    """One layout of a sample, or of the hall made for it, without one of the weights."""
    row = {"case": case, "solver": solver, "without": without, "seed": seed}
    return row | ablated(brief_of(case), without, seed, solver).figures


def brief_of(case: str) -> Brief:
    """A sample, or the hall made for the ablation."""
    return Brief.model_validate(HALL) if case == CASE else read(case)


def ablation(case: str, solver: str, seeds: int) -> SpreadTable:
    """The table of one hall by one solver."""
    jobs = [
        partial(run, case, solver, without, seed) for without in VARIANTS for seed in range(seeds)
    ]
    return SpreadTable(f"ablation, {case} by {solver}", jobs, summary)


def summary(found: list[Row]) -> list[Row]:
    """Records of one hall: the failing figure without a weight against the same figure with all of
    them, and the walls generated."""
    records: list[Row] = []
    for solver in dict.fromkeys(row["solver"] for row in found):
        mine = [row for row in found if row["solver"] == solver]
        case = f"{mine[0]['case']} by {solver}"
        for name, (figure, told) in FIGURES.items():
            full = [row[figure] for row in mine if row["without"] == "all"]
            lost = [row[figure] for row in mine if row["without"] == name]
            a, b = statistics.median(full), statistics.median(lost)
            records.append(_record(case, told, a, b, f"without {name}", len(full)))
        walls = [row["walls"] for row in mine if row["without"] == "all"]
        built = statistics.median(walls)
        records.append(_record(case, "walls generated", built, built, "same", len(walls)))
    return records


def _record(case: str, metric: str, ours: float, baseline: float, by: str, runs: int) -> Row:
    return {
        "case": case,
        "metric": metric,
        "unit": "1",
        "ours": ours,
        "baseline": baseline,
        "baseline_name": by,
        "ratio": baseline / ours if ours else None,
        "runs": runs,
    }
