"""What a filled area is worth: coverage, and how far it is from its sources beyond chance."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import shapely

from scenewright.domains.extend.prepared import prepared_of
from scenewright.domains.extend.problem import (
    ExtendProblem,
    Floats,
    GrownLayout,
    boxes_at,
    shapes_at,
)
from scenewright.ground.buildings.built import BuiltFrames
from scenewright.ground.likeness.excess import Excess, find_excess, wasserstein
from scenewright.ground.likeness.features import ROWS, measure_buildings

MEANINGS: dict[str, str] = {
    "missing": "buildings asked for without a place",
    "coverage": "share by which the ground covered misses what the sources cover",
    "what": "how far sizes and shapes are from the sources' beyond chance (excess)",
    "how": "how far gaps, rows and directions are from the sources' beyond chance (excess)",
}
WEIGHTS = {"missing": 1.0, "coverage": 2.0, "what": 0.5, "how": 1.0}
FEW = 3
"""Fewer buildings have no distribution."""


def rate_layout(problem: ExtendProblem, layout: GrownLayout) -> GrownLayout:
    """The layout with its score: each of :data:`MEANINGS`, and their weighted sum ``energy``."""
    values = measure_layout(problem, layout)
    energy = sum(WEIGHTS[name] * max(values[name], 0.0) for name in WEIGHTS)
    return layout._replace(score={"energy": energy, **values})


def measure_layout(problem: ExtendProblem, layout: GrownLayout) -> dict[str, float]:
    """The value of each of :data:`MEANINGS`."""
    missing = float(max(layout.asked - len(layout.poses), 0))
    shapes = shapes_at(problem.pattern, layout.poses, layout.origin, layout.form)
    inside = problem.standing.shapes[problem.standing.inside]
    built = float(np.asarray(shapely.area(shapes)).sum() + np.asarray(shapely.area(inside)).sum())
    wanted = problem.coverage * problem.outline.area
    short = abs(built - wanted) / max(wanted, 1.0) if problem.number is None else 0.0
    excess = likeness_of(problem, layout)
    return {
        "missing": missing,
        "coverage": short,
        "what": excess.what if excess else 0.0,
        "how": excess.how if excess else 0.0,
    }


def measure_grown(problem: ExtendProblem, layout: GrownLayout) -> dict[str, Floats]:
    """The features of the added buildings among all that stands."""
    pattern, standing, count = problem.pattern, problem.standing, len(layout.poses)
    told = pattern, layout.poses, layout.origin, layout.form
    boxes = np.concatenate([boxes_at(*told), standing.boxes])
    shapes = np.concatenate([shapes_at(*told), standing.shapes])
    heights = np.array([kind.size[2] for kind in pattern.kinds])[pattern.kind]
    grown = BuiltFrames(
        boxes, shapes, np.concatenate([heights[layout.origin], heights[standing.origin]])
    )
    return measure_buildings(grown, problem.roads, count)


def misfit_of(source: Mapping[str, Floats], measured: Mapping[str, Floats]) -> float:
    """The mean W₁ between the features of sources and of what was grown, in spreads of the
    sources: what annealing lowers, without the null that hardly changes from move to move."""
    found = []
    for row in ROWS:
        if row.name in source and row.name in measured:
            a, b = (side[row.name][np.isfinite(side[row.name])] for side in (source, measured))
            if len(a) and len(b):
                found.append(float(wasserstein(a, b)) / max(float(a.std()), row.scale))
    return float(np.mean(found)) if found else 0.0


def likeness_of(problem: ExtendProblem, layout: GrownLayout) -> Excess | None:
    """How far the added buildings, measured among all that stand, are from the sources."""
    if len(layout.poses) < FEW or len(problem.pattern.boxes) < FEW:
        return None
    return find_excess(prepared_of(problem).measured, measure_grown(problem, layout))
