"""The designer's layout under the printed cost (Liu et al. 2017, 4.6).

The rooms of the six furnished homes in which at least two groups are found; the groups as they
stand are a layout of the paper's problem with the same groups, sizes reaching as far as theirs.
"""

from __future__ import annotations

import statistics
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from benchmarks.comparison import ratio
from benchmarks.designer_rooms import files
from benchmarks.home_methods import lay_out
from benchmarks.home_rooms import Case
from benchmarks.papers_home import METHODS, QUICK, RUNS, solver_of
from benchmarks.papers_home_tables import EVALUATIONS, GA, tell_designer
from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.domains.home.build_problem import build_problem
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.learned.learning import FurnishedSpace, found_in
from scenewright.domains.home.paper_problem import as_in_paper
from scenewright.domains.home.presets import PAPER
from scenewright.domains.home.problem import Items
from scenewright.domains.home.programme import Wish
from scenewright.engine.solve import Budget
from scenewright.formats import read

markdown_lines = tell_designer

Floats = NDArray[np.float64]
Record = dict[str, Any]
Progress = Callable[[float, str], None]
LEAST = 2


def designed(path: Path) -> Iterator[tuple[Case, Floats]]:
    """The rooms of a furnished home as the paper's problem, and the designer's boxes (n, 5)."""
    full = read(path, keep=True)
    for room, space in zip(full.rooms, spaces(full), strict=True):
        stands = tuple(fixed_pieces(room, space, shipped()))
        found = tuple(found_in(FurnishedSpace(path.stem, space, stands), shipped()))
        if len(found) < LEAST:
            continue
        wishes = tuple(Wish(one.case.function, 0) for one in found)
        area = float(shapely.Polygon(space.outline, list(space.holes)).area)
        ground = ground_of(space, (), area)
        problem = build_problem(ground, wishes, PAPER, True, full.route_width, area)
        problem = as_in_paper(problem, wishes, space)
        boxes = np.array([(*one.box, one.case.width, one.case.depth) for one in found])
        problem = problem._replace(items=widen_sizes(problem.items, boxes[:, 3:]))
        yield Case(f"{path.stem}/{space.id}", problem, problem), boxes


def widen_sizes(items: Items, sizes: Floats) -> Items:
    """Items whose sizes ``(n, 2)`` range to the given ones too."""
    return items._replace(low=np.minimum(items.low, sizes), high=np.maximum(items.high, sizes))


def records(quick: bool = False, progress: Progress | None = None) -> Iterator[Record]:
    """Rooms of the six furnished homes: the printed cost of the designer's groups, the mean of the
    GA's and of ours for the same groups."""
    runs, furnished = (QUICK, files()[:1]) if quick else (RUNS, files())
    for number, path in enumerate(furnished):
        if progress:
            progress(number / len(furnished), path.stem)
        for case, boxes in designed(path):
            yield from _compare(case, boxes, runs)


def _compare(case: Case, boxes: Floats, runs: int) -> Iterator[Record]:
    was = float(evaluate(case.problem, boxes[None])[0])
    solvers = ((GA, METHODS[GA], Budget()), (EVALUATIONS, solver_of("anneal"), Budget(steps=4000)))
    for name, method, budget in solvers:
        run = partial(lay_out, method, case, budget._replace(threads=1))
        costs = [float(run(seed)["energy"]) for seed in range(runs)]
        yield Record(
            case=case.name,
            metric=f"printed cost, mean of the {name}" if name == GA else f"printed cost, {name}",
            unit="cost",
            ours=round(statistics.fmean(costs), 4),
            baseline=round(was, 4),
            baseline_name="designer",
            ratio=ratio(round(statistics.fmean(costs), 4), round(was, 4), "s"),
            runs=runs,
            least=round(min(costs), 4),
            most=round(max(costs), 4),
            layouts=4000,
            printed=(0.012, 0.2848, 0.2848),
        )
