"""Composition of sites: ``scenewright bench sites --seed S --count N``.

Real compounds (:mod:`.site_reco`) laid out anew beside what their designers built, a draw of them
or all 91: directions, buildings along the border, void ground, fronts, coverage and sun, by the
measures of :mod:`.site_composition`; the streets of samples and of ten new briefs
(:mod:`.site_ground`); and how much the layouts of two seeds differ, by the measure
of alternatives.
"""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
import shapely

from benchmarks.comparison import ratio
from benchmarks.real_data import skipped
from benchmarks.site_composition import measure_composition, share_of_podiums
from benchmarks.site_compounds import Pair, compare, file, moved_footprints
from benchmarks.site_ground import ground_records
from benchmarks.site_reco import compounds
from scenewright.core.errors import InputError
from scenewright.domains.site.alternatives import compare as differ
from scenewright.domains.site.solving import solve

Record = dict[str, Any]
Progress = Callable[[float, str], None]


def mean_of_known(values: list[float]) -> float:
    """The mean of what is no NaN; NaN of nothing."""
    known = [value for value in values if not math.isnan(value)]
    return statistics.fmean(known) if known else math.nan


QUICK, LEAST = 6, 4
"""Compounds of a quick run, and the fewest buildings of one that is looked at."""


class Figure(NamedTuple):
    """One figure: its key, what is told of it, its unit, and how compounds are put together."""

    key: str
    name: str
    unit: str
    how: Callable[[list[float]], float]


FIGURES = (
    Figure("directions", "entropy of directions, median", "nat", statistics.median),
    Figure("grids", "entropy of directions by quarters, median", "nat", statistics.median),
    Figure("along_border", "buildings along the border, median", "share", statistics.median),
    Figure("void", "ground over 25 m from a building, median", "share", statistics.median),
    Figure("bare", "of it no park, median", "share", statistics.median),
    Figure("south", "fronts to the south, mean", "share", statistics.fmean),
    Figure("coverage", "coverage, median", "share", statistics.median),
    Figure("sun", "hours of sun, median", "h", statistics.median),
    Figure("podiums", "podiums that touch a tower, mean", "share", mean_of_known),
    Figure("differ", "two seeds differ, median", "share", statistics.median),
    Figure("left_out", "buildings left out, sum", "1", sum),
    Figure("overlaps", "overlaps, sum", "1", sum),
    Figure("unreached", "buildings not reached, sum", "1", sum),
    Figure("cpu", "processor seconds of a compound, median", "s", statistics.median),
)


def records(
    quick: bool = False, progress: Progress | None = None, seed: int = 0, count: int = 0
) -> Iterator[Record]:
    """Ours beside the designers' over ``count`` compounds drawn by ``seed`` (0: all; 6 if
    ``quick``); before them the streets of samples and of new briefs."""
    yield from ground_records(quick, progress)
    try:
        rows = list(see_compounds(seed, count or (QUICK if quick else 0), progress))
    except InputError as fault:
        yield skipped("compounds", fault)
        return
    for figure in FIGURES:
        yield _record(figure, rows)


def see_compounds(
    seed: int, count: int, progress: Progress | None = None
) -> Iterator[tuple[Record, Record]]:
    """The figures of ours and of the designer, compound by compound."""
    every = [row for row in compounds(file()) if len(row[1].boxes) >= LEAST]
    drawn = np.random.default_rng(seed).permutation(len(every))[: count or None]
    for done, number in enumerate(sorted(drawn.tolist())):
        if progress:
            progress(done / len(drawn), every[number][0].name)
        yield figures_of(compare(*every[number]))


def figures_of(pair: Pair) -> tuple[Record, Record]:
    """The figures of one compound, ours and the designer's."""
    outline, designed = shapely.Polygon(pair.site.outline), pair.designed
    placed = [p for p in pair.solution.pieces if p.category == "building"]
    other = solve(pair.solution.brief, seed=pair.solution.seed + 1)
    shapes = np.array(moved_footprints(designed, placed), object)
    ours = measure_composition(
        outline,
        shapes,
        np.array([p.pose.heading for p in placed]),
        [
            shapely.Polygon(area.outline)
            for works in pair.solution.detail or ()
            for area in works.areas
            if area.kind == "park"
        ],
    )
    theirs = measure_composition(
        outline, np.array(designed.footprints, object), designed.boxes[:, 2]
    )
    ours |= {"podiums": share_of_podiums(shapes, np.array([p.size.height for p in placed]))}
    ours |= {"differ": differ(pair.solution, other)}
    drawn = np.array(designed.footprints, object)
    theirs |= {"podiums": share_of_podiums(drawn, designed.heights)}
    return pair.ours | ours, pair.theirs | theirs


def _record(figure: Figure, rows: list[tuple[Record, Record]]) -> Record:
    ours = figure.how([a[figure.key] for a, _ in rows])
    told = [b[figure.key] for _, b in rows if figure.key in b]
    theirs = figure.how(told) if told else math.nan
    return Record(
        case=f"{len(rows)} compounds",
        metric=figure.name,
        unit=figure.unit,
        ours=round(ours, 4),
        baseline=round(theirs, 4) if told else None,
        baseline_name="designer" if told else "",
        ratio=ratio(ours, theirs, figure.unit) if told else None,
        runs=len(rows),
    )
