"""Sites by every method on the same scenes: at equal evaluations, and at equal wall time.

An evaluation is a layout looked at; annealing looks at one a move. Our default looks at few
layouts whatever it is given, so at equal evaluations it does less than the others, and at equal
time it stops early. A population has converged in the first generation whose best energy is
within 1 % of the final one; ``settled`` is where its global search ended by (12) in Zhang, Yang
2023. Timings are of warm kernels.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

from benchmarks.comparison import figure, ratio, record
from benchmarks.site_scenes import SIZES, Scene, judged, posed, scene_brief
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.solvers import SITE_SOLVERS
from scenewright.engine.solve import Budget

Row = dict[str, Any]
Progress = Callable[[float, str], None]
METHODS = ("default", "quick", "fine", "paper", "vp", "sga", "sa", "sa-free", "pso", "random")
"""Presets (three of ours, the paper's as printed), then solvers on the default's problem: ``vp`` is
the paper's, repaired."""
EVALUATIONS, SECONDS = 2000, 1.0
"""What the paper's algorithm looks at, 10 layouts in 200 generations, and the equal time."""
BUDGETS = {"evaluations": Budget(steps=EVALUATIONS), "seconds": Budget(seconds=SECONDS)}
FIGURES = (
    ("value", "1"),
    ("use", "1"),
    ("shown", "1"),
    ("texture", "1"),
    ("height", "1"),
    ("seen", "1"),
    ("sun", "h"),
    ("valid", "share"),
    ("overlaps", "1"),
    ("outside", "1"),
    ("near", "1"),
    ("unreached", "1"),
    ("left_out", "share"),
    ("converged", "1"),
    ("settled", "1"),
    ("seconds", "s"),
    ("cpu", "s"),
)
MAIN = tuple(
    row for row in FIGURES if row[0] in ("value", "seen", "sun", "valid", "left_out", "cpu")
)
"""Those that a quick run tells."""
MEANS = ("valid", "overlaps", "outside", "near", "unreached", "left_out")
"""Figures that are means over the runs; all others are medians."""


def run(scene: Scene, method: str, equal: str, seed: int) -> Row:
    """One scene by one method: a row."""
    budget, solver = BUDGETS[equal], method
    problem = scene.problems[method if method in PRESETS else "default"]
    if method in PRESETS:
        solver = PRESETS[method].solver
        budget = Budget(budget.seconds, PRESETS[method].steps if solver == "fill" else budget.steps)
    heard: list[float] = []
    begun = time.perf_counter(), time.process_time()
    row = SITE_SOLVERS[solver]
    found = row.run(problem, budget, seed, lambda report: heard.append(report.energy))
    took = {"seconds": time.perf_counter() - begun[0], "cpu": time.process_time() - begun[1]}
    count = len(scene.wishes)
    case: Row = {"buildings": count, "method": method, "equal": equal, "seed": seed} | took
    told = judged(scene, found)
    told |= {"settled": told["generations"], "converged": converged(heard)}
    return case | told | {"left_out": told["left_out"] / count}


def converged(heard: list[float]) -> int:
    """The first round of those heard that was within 1 % of the best; 0 if none was told.

    >>> converged([-0.2, -0.5, -0.796, -0.8])
    3
    """
    if not heard:
        return 0
    bar = min(heard) + 0.01 * abs(min(heard))
    return next(number for number, best in enumerate(heard, 1) if best <= bar)


def rows(
    seeds: int,
    sizes: tuple[int, ...] = SIZES,
    equal: tuple[str, ...] = tuple(BUDGETS),
    progress: Progress | None = None,
) -> list[Row]:
    """Every scene by every method with so many seeds, methods in turn so that a busy machine
    hinders all alike."""
    scenes = {size: posed(scene_brief(size)) for size in sizes}
    for method in METHODS:
        run(scenes[sizes[0]], method, equal[0], 0)
    found = []
    for k, size in enumerate(sizes):
        for seed in range(seeds):
            for name in equal:
                found += [run(scenes[size], method, name, seed) for method in METHODS]
            if progress:
                progress((k + (seed + 1) / seeds) / len(sizes), f"{size} buildings")
    return found


def chosen(found: list[Row], **wanted: Any) -> list[Row]:
    """The rows that have these values."""
    return [row for row in found if all(row[name] == value for name, value in wanted.items())]


def summary(found: list[Row], figures: tuple[tuple[str, str], ...] = FIGURES) -> list[Row]:
    """Records: our default against each other method, by scene, budget and figure."""
    records: list[Row] = []
    cases = dict.fromkeys((row["buildings"], row["equal"]) for row in found)
    for size, equal in cases:
        mine = chosen(found, buildings=size, equal=equal)
        for method in dict.fromkeys(row["method"] for row in mine):
            if method != "default":
                ours, theirs = (chosen(mine, method=name) for name in ("default", method))
                case = f"{size} buildings, equal {equal}"
                records += [
                    record(case, name, unit, ours, theirs, method, MEANS) for name, unit in figures
                ]
    return records + falls(found)


def falls(found: list[Row]) -> list[Row]:
    """How much F_eva falls from the smallest scene to the largest, by method and budget."""
    sizes = sorted({row["buildings"] for row in found})
    records = []
    for equal in dict.fromkeys(row["equal"] for row in found):
        for method in dict.fromkeys(row["method"] for row in found):
            mine = chosen(found, method=method, equal=equal)
            ends = [
                figure(chosen(mine, buildings=size), "value", MEANS)
                for size in (sizes[0], sizes[-1])
            ]
            records.append(
                {
                    "case": f"{method}, equal {equal}",
                    "metric": f"F_eva, {sizes[-1]} against {sizes[0]} buildings",
                    "unit": "1",
                    "ours": round(ends[1], 4),
                    "baseline": round(ends[0], 4),
                    "baseline_name": f"{sizes[0]} buildings",
                    "ratio": ratio(ends[1], ends[0], "1"),
                    "runs": len(chosen(mine, buildings=sizes[0])),
                }
            )
    return records
