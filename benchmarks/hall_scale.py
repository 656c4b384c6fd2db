"""Halls of 20 to 2000 objects at one density: what a step takes, and a plan without findings.

Zones stand in a grid, twenty objects and 130 m² each (two zones of half the size for 20 objects):
showcases and plinths that belong to them, exhibits along outer walls, benches anywhere.
"""

from __future__ import annotations

import math
import statistics
import time
from typing import Any

import numpy as np

from benchmarks.hall_measure import posed
from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.chains import advance, begin_chain
from scenewright.domains.hall.solving import solve
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams

Row = dict[str, Any]
SIZES = (20, 100, 500, 2000)
EACH = 20
SHAPE = (13.0, 10.0)
LIMIT = 60.0
"""Seconds in which 2000 objects must stand without a finding."""


def scaled_brief(objects: int) -> Brief:
    """A hall of so many objects."""
    number = max(objects // EACH, 2)
    share = objects / number / EACH
    width, depth = SHAPE[0] * math.sqrt(share), SHAPE[1] * math.sqrt(share)
    columns = math.ceil(math.sqrt(number * depth / width))
    columns = next(c for c in range(columns, number + 1) if number % c == 0)
    rows = number // columns
    zones, demands, outer = [], [], []
    for k in range(number):
        i, j = k % columns, k // columns
        x0, y0, x1, y1 = i * width, j * depth, (i + 1) * width, (j + 1) * depth
        outline = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
        zones.append({"id": f"z{k}", "outline": outline})
        demands += [
            _demand("showcase", k, round(8 * share)),
            _demand("plinth", k, round(6 * share)),
        ]
        if 0 in (i, j) or i == columns - 1 or j == rows - 1:
            outer.append(f"z{k}")
    benches, left = round(3 * share * number), objects - sum(d["count"] for d in demands)
    demands += [
        {"id": "benches", "category": "bench", "count": benches},
        {
            "id": "pictures",
            "category": "wall_exhibit",
            "count": left - benches,
            "place": "wall",
            "zone": outer,
        },
    ]
    room = _room(columns * width, rows * depth) | {"zones": zones, "demands": demands}
    told = {"domain": "hall", "name": f"{objects} objects", "rooms": [room]}
    return Brief.model_validate({"format": "scenewright/brief", "version": 1} | told)


def _demand(category: str, zone: int, count: int) -> Row:
    return {"id": f"{category}-{zone}", "category": category, "count": count, "zone": f"z{zone}"}


def _room(width: float, depth: float) -> Row:
    """The outline, with an entrance or exit for every 30 m of its long walls."""
    number = max(round(width / 30.0), 1)
    at = [(k + 0.37) / number * width for k in range(number)]
    doors = [
        {"id": f"{use}-{k}", "at": [x, y], "width": 1.8, "swing": "out", "use": use}
        for use, y in (("entrance", 0.0), ("exit", depth))
        for k, x in enumerate(at)
    ]
    outline = [[0, 0], [width, 0], [width, depth], [0, depth]]
    return {"id": "hall", "outline": outline, "height": 4.0, "doors": doors}


def step_seconds(problem: HallProblem, start: Kept, steps: int) -> float:
    """Seconds of one step of our default's chain at the middle of its schedule, one thread."""
    chain = begin_chain(problem, start, streams(0, 1)[0])
    schedule = np.array([0.05, 20.0, 4.0 * steps, 0.6])
    advance(chain, schedule, 0, steps)
    begun = time.perf_counter()
    advance(chain, schedule, 2 * steps, steps)
    return (time.perf_counter() - begun) / steps


def rows(sizes: tuple[int, ...] = SIZES, runs: int = 3, steps: int = 2000) -> list[Row]:
    """A row a size and run: seconds of the first layout, of a step with and without the route
    and by the paper's weights, of the whole plan and of judging it."""
    found = []
    step_seconds(*posed(scaled_brief(SIZES[0])).fitted[2:4], steps)
    for objects in sizes:
        brief = scaled_brief(objects)
        for seed in range(runs):
            begun = time.perf_counter()
            ready = posed(brief, seed).fitted
            first = time.perf_counter() - begun
            bare = ready.problem._replace(weights={**ready.problem.weights, "reach": 0.0})
            found.append(
                {
                    "objects": objects,
                    "seed": seed,
                    "units": len(ready.units),
                    "first layout": first,
                    "step": step_seconds(ready.problem, ready.start, steps),
                    "step without the route": step_seconds(bare, ready.start, steps),
                }
                | _plan(brief, seed)
            )
    return found


def _plan(brief: Brief, seed: int) -> Row:
    solution = solve(brief, seed=seed)
    begun = time.perf_counter()
    report = check(solution)
    found = [finding for finding in report.findings if not finding.given]
    return {
        "plan": solution.seconds,
        "judging": time.perf_counter() - begun,
        "valid": not found,
        "left out": len(solution.left_out),
        "evaluations": solution.evaluations,
        "told": [finding.message for finding in found][:6],
    }


def growth(sizes: list[float], values: list[float]) -> float:
    """The exponent of n: slope of the line through log n and log value.

    >>> round(growth([10.0, 100.0, 1000.0], [2.0, 20.0, 200.0]), 6)
    1.0
    """
    return float(np.polyfit(np.log(sizes), np.log(values), 1)[0])


def summary(found: list[Row]) -> list[Row]:
    """Records: medians by size, valid plans, growth exponents, and the limit for the largest."""
    sizes = sorted({row["objects"] for row in found})
    records: list[Row] = []
    for name in ("step", "step without the route", "first layout", "plan"):
        medians = []
        for size in sizes:
            values = [row[name] for row in found if row["objects"] == size]
            medians.append(statistics.median(values))
            records.append(_record(f"{size} objects", name, "s", medians[-1], len(values)))
        if len(sizes) > 1:
            slope = growth([float(size) for size in sizes], medians)
            records.append(_record("all sizes", f"{name}, growth exponent", "1", slope, len(found)))
    for size in sizes:
        mine = [row for row in found if row["objects"] == size]
        good = [row["valid"] and row["plan"] <= LIMIT for row in mine]
        share = sum(good) / len(good)
        records.append(
            _record(f"{size} objects", f"valid within {LIMIT:.0f} s", "share", share, len(mine))
            | {"baseline": 1.0, "ratio": share}
        )
    return records


def _record(case: str, metric: str, unit: str, ours: float, runs: int) -> Row:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": ours,
        "baseline": None,
        "baseline_name": "aim",
        "ratio": None,
        "runs": runs,
    }
