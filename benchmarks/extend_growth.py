"""One half of every real compound hidden and grown from the other, by every method.

Runs are kept: one that was cut short goes on where it ended.
"""

from __future__ import annotations

import time
from collections import defaultdict
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import shapely

from benchmarks.extend_data import CutPlace, cut_compounds
from benchmarks.kept import open_runs
from scenewright.domains.extend.pattern import learn_pattern
from scenewright.domains.extend.problem import (
    ExtendProblem,
    GrownLayout,
    StandingGround,
    boxes_at,
    shapes_at,
)
from scenewright.domains.extend.settings import GrowthSettings
from scenewright.domains.extend.solvers import EXTEND_SOLVERS
from scenewright.engine.solve import Budget
from scenewright.ground.buildings.built import BuiltFrames
from scenewright.ground.likeness.excess import find_excess
from scenewright.ground.likeness.features import measure_buildings, measure_scene

Record = dict[str, Any]
Heard = Callable[[float, str], None]
METHODS = tuple(EXTEND_SOLVERS)
CODE = (
    "benchmarks/extend_data.py",
    "src/scenewright/domains/extend/**/*.py",
    "src/scenewright/ground/likeness/*.py",
    "src/scenewright/ground/built.py",
)
"""What grows and judges: runs of other code are not theirs."""


class GrownFigures(NamedTuple):
    """What one grown half comes to: coverage by that of the hidden half (which is told), excess of
    what and how against the source, and of how against the hidden half; overlaps and buildings
    that leave the ground; processor seconds."""

    coverage: float
    what: float
    how: float
    to_real: float
    faults: int
    seconds: float


def problem_of(place: CutPlace) -> ExtendProblem:
    """The problem of growing the second half of a place from its first."""
    pattern = learn_pattern([place.one], [1.0])
    outline = shapely.Polygon(place.other.outline)
    rest = shapely.difference(outline, shapely.union_all(pattern.shapes).buffer(0.01))
    count = len(pattern.boxes)
    standing = StandingGround(
        pattern.boxes, pattern.shapes, np.arange(count), np.zeros(count, np.bool_)
    )
    return ExtendProblem(
        place.name,
        rest,
        outline,
        pattern,
        standing,
        (),
        None,
        _covered(place),
        ((),),
        GrowthSettings(),
        grounds=(shapely.Polygon(place.one.outline),),
    )


def _covered(place: CutPlace) -> float:
    """The share of ground that the hidden half covers: told to every method."""
    there = sum(shapely.Polygon(one.outline).area for one in place.other.buildings)
    return float(there / shapely.Polygon(place.other.outline).area)


def growth_records(most: int | None, seeds: int, heard: Heard) -> Iterator[Record]:
    """Records of all methods over all compounds; ``most`` of them at most."""
    places = cut_compounds()
    chosen = places if most is None else [p for p in places if p.held][:most]
    found: dict[tuple[str, bool], list[GrownFigures]] = defaultdict(list)
    kept = open_runs("extend_growth", CODE)
    for number, place in enumerate(chosen):
        problem = problem_of(place)
        found["real", place.held].append(real_figures(place))
        for method in METHODS:
            for seed in range(seeds):
                make = partial(grown_figures, place, problem, method, seed)
                figures = GrownFigures(*kept.have(f"{place.name} {method} {seed}", make))
                found[method, place.held].append(figures)
        heard(0.1 + 0.85 * (number + 1) / len(chosen), place.name)
    for held, words in ((True, "held out"), (False, "looked at")):
        if found["real", held]:
            yield from _records(words, {m: found[m, held] for m in ("real", *METHODS)}, seeds)


def real_figures(place: CutPlace) -> GrownFigures:
    """The half that is really there."""
    whole = measure_scene(place.other._replace(context=place.one.buildings))
    excess = find_excess(measure_scene(place.one), whole)
    return GrownFigures(1.0, excess.what, excess.how, 0.0, 0, 0.0)


def grown_figures(place: CutPlace, problem: ExtendProblem, method: str, seed: int) -> GrownFigures:
    """The hidden half grown by a method."""
    begun = time.process_time()
    layout = EXTEND_SOLVERS[method].run(problem, Budget(threads=1), seed).layouts[0]
    took = time.process_time() - begun
    shapes = shapes_at(problem.pattern, layout.poses, layout.origin, layout.form)
    share = float(np.asarray(shapely.area(shapes)).sum() / problem.outline.area)
    if len(shapes) < 2:
        return GrownFigures(share / problem.coverage, 1.0, 1.0, 1.0, 0, took)
    grown = measure_layout(problem, layout)
    to_source = find_excess(measure_scene(place.one), grown)
    hidden = measure_scene(place.other._replace(context=place.one.buildings))
    return GrownFigures(
        share / problem.coverage,
        to_source.what,
        to_source.how,
        find_excess(hidden, grown).how,
        count_faults(problem, shapes),
        took,
    )


def measure_layout(problem: ExtendProblem, layout: GrownLayout) -> dict[str, np.ndarray]:
    """The features of grown buildings among what stands."""
    pattern, count = problem.pattern, len(layout.poses)
    height = np.array([kind.size[2] for kind in pattern.kinds])[pattern.kind]
    told = pattern, layout.poses, layout.origin, layout.form
    frames = BuiltFrames(
        np.concatenate([boxes_at(*told), problem.standing.boxes]),
        np.concatenate([shapes_at(*told), problem.standing.shapes]),
        np.concatenate([height[layout.origin], height[problem.standing.origin]]),
    )
    return measure_buildings(frames, (), count)


def count_faults(problem: ExtendProblem, shapes: np.ndarray) -> int:
    """Pairs that overlap by more than 1 cm, and buildings that leave the ground by as much."""
    every = np.concatenate([shapes, problem.standing.shapes])
    i, j = shapely.STRtree(every).query(shapes, predicate="intersects")
    pairs = i < j
    shared = shapely.intersection(shapes[i[pairs]], every[j[pairs]])
    beyond = shapely.difference(shapes, problem.outline)
    return _thick(shared) + _thick(beyond)


def _thick(slivers: np.ndarray) -> int:
    """How many shapes are more than 1 cm thick, by their area and perimeter."""
    area, around = np.asarray(shapely.area(slivers)), np.asarray(shapely.length(slivers))
    return int((area > 0.01 * around / 2 + 0.005).sum())


def _records(words: str, found: dict[str, list[GrownFigures]], seeds: int) -> Iterator[Record]:
    real = found["real"]
    for method in METHODS:
        rows = found[method]
        case = f"growing, {words}, {method}"
        if method != "random":
            pairs = list(zip(rows, found["random"], strict=True))
            for name in ("how", "to_real"):
                nearer = float(np.mean([getattr(a, name) < getattr(b, name) for a, b in pairs]))
                against = "the source" if name == "how" else "the hidden half"
                yield _record(
                    case, f"nearer to {against} than random", "share", nearer, 0.5, "chance", rows
                )
        for name, metric in (
            ("coverage", "coverage by the hidden half's"),
            ("how", "excess of how"),
            ("what", "excess of what"),
        ):
            ours = float(np.median([getattr(row, name) for row in rows]))
            base = float(np.median([getattr(row, name) for row in real]))
            yield _record(case, f"{metric}, median", "1", ours, base, "the real half", rows)
        whole = [(row.how + row.what) / 2 for row in rows]
        theirs = [(row.how + row.what) / 2 for row in real]
        yield _record(
            case,
            "excess, 75 % point",
            "1",
            float(np.percentile(whole, 75)),
            float(np.percentile(theirs, 75)),
            "the real half",
            rows,
        )
        near = float(np.mean([abs(row.coverage - 1) <= 0.1 for row in rows]))
        yield _record(
            case, "coverage within 10 % of the hidden half's", "share", near, None, "", rows
        )
        faults = float(sum(row.faults for row in rows))
        yield _record(case, "overlaps and buildings outside", "1", faults, None, "", rows)
        seconds = float(np.median([row.seconds for row in rows]))
        yield _record(case, "CPU seconds", "s", seconds, None, f"{seeds} seeds", rows)


def _record(
    case: str,
    metric: str,
    unit: str,
    ours: float,
    base: float | None,
    by: str,
    rows: list[GrownFigures],
) -> Record:
    return {
        "case": case,
        "metric": metric,
        "unit": unit,
        "ours": round(ours, 4),
        "baseline": None if base is None else round(base, 4),
        "baseline_name": by,
        "ratio": None if not base else round(ours / base, 3),
        "runs": len(rows),
    }
