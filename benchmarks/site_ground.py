"""Streets of sites: fronts, dead ends, walks and rims of squares, of the samples and new briefs.

Measured by the geometry of :mod:`.ground_measures`, which shares nothing with what lays the ground.
Each brief with two seeds; shares over all of a group. Squares alone have a rim, courts have none.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np
import shapely
from scipy.stats import spearmanr

import scenewright as sw
from benchmarks.ground_measures import Ground, counts_of, read_ground
from benchmarks.site_briefs import new_briefs
from benchmarks.site_composition import boxes_of, list_gap_variations
from benchmarks.site_scale import sites
from scenewright.core.brief import Brief
from scenewright.domains import check, plan_of, scene_of

Record = dict[str, Any]
Progress = Callable[[float, str], None]
SEEDS = 2
FIGURES = (
    "fronts to the way",
    "dead ends among lanes",
    "long dead ends without a head",
    "doors with their walk",
    "rim of squares fronted",
    "heights step up to squares and landmarks",
    "variation of gaps in runs of equal buildings",
)


def ground_records(quick: bool, progress: Progress | None = None) -> Iterator[Record]:
    """The figures of both groups."""
    samples = [(name, sw.read(name)) for name in sites()]
    for group, briefs in (("samples of sites", samples), ("ten new sites", new_briefs())):
        if progress:
            progress(0.0, group)
        yield from _records(group, briefs, 1 if quick else SEEDS)


def _records(group: str, briefs: Sequence[tuple[str, Brief]], seeds: int) -> Iterator[Record]:
    sums = {name: np.zeros(2) for name in FIGURES}
    faulty = 0
    for _, brief in briefs:
        for seed in range(seeds):
            solution = sw.solve(brief, seed=seed)
            counts = counts_of(ground_of_site(solution))
            counts |= {FIGURES[-2]: measure_skyline(solution)}
            counts |= {FIGURES[-1]: sum_gap_variations(solution)}
            faulty += not check(solution).valid
            for name in FIGURES:
                sums[name] += counts[name]
    for name, (part, whole) in sums.items():
        yield _record(group, name, part / whole if whole else float("nan"), int(whole))
    yield _record(group, "scenes with faults", float(faulty), seeds * len(briefs))


def measure_skyline(solution: sw.Solution) -> tuple[float, float]:
    """How the heights of buildings go with their nearness to the squares of a site, without any to
    its landmarks: Spearman's rank correlation, and 1; 0 and 0 where there is neither."""
    works, houses = solution.detail or (), [p for p in solution.pieces if p.category == "building"]
    squares = [shapely.Polygon(a.outline) for w in works for a in w.areas if a.kind == "square"]
    marks = [shapely.Point(p.pose[:2]) for p in houses if p.function == "landmark"]
    free = [p for p in houses if p.function != "landmark"]
    high = np.array([p.size.height for p in free])
    if not (squares or marks) or len(set(high)) < 2:
        return 0.0, 0.0
    far = shapely.distance(
        shapely.points([p.pose[:2] for p in free]), shapely.union_all(squares or marks)
    )
    return float(-spearmanr(high, far).statistic), 1.0


def sum_gap_variations(solution: sw.Solution) -> tuple[float, float]:
    """The sum of the variations of gaps in runs of equal buildings, and how many runs there are."""
    houses = [p for p in solution.pieces if p.category == "building"]
    found = list_gap_variations(*boxes_of(houses))
    return float(sum(found)), float(len(found))


def ground_of_site(solution: sw.Solution) -> Ground:
    """The ground of a solved brief of sites, landmarks included."""
    plan = plan_of(solution.brief)
    works = solution.detail or ()
    squares = [shapely.Polygon(a.outline) for w in works for a in w.areas if a.kind == "square"]
    lanes = [
        (shapely.LineString(row.line), row.width)
        for work in works
        for row in work.pathways
        if row.kind == "lane"
    ]
    houses = [p for p in solution.pieces if p.category == "building"]
    floors = [shapely.Polygon(site.outline, site.holes) for site in plan.detail]
    return read_ground(houses, scene_of(solution, plan).surfaces, squares, lanes, {}, floors)


def _record(group: str, metric: str, value: float, runs: int) -> Record:
    return {
        "case": group,
        "metric": metric,
        "unit": "1",
        "ours": round(value, 4),
        "baseline": None,
        "baseline_name": "",
        "ratio": None,
        "runs": runs,
    }
