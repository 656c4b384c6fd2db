"""What does not change while an area is filled, found once for all its layouts."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.extend.problem import ExtendProblem, Floats, PreparedSources
from scenewright.ground.buildings.built import BuiltFrames
from scenewright.ground.likeness.features import join_measures, measure_buildings

ROUGH = 0.1
"""Metres by which the circle within a footprint may be smaller than the largest."""


def prepare_sources(problem: ExtendProblem) -> ExtendProblem:
    """The problem with its sources measured. It stays right for other gaps, weights and coverage:
    whoever fills an area many times over prepares it once."""
    local = np.empty(len(problem.pattern.kinds), object)
    local[:] = [shapely.Polygon(kind.local) for kind in problem.pattern.kinds]
    circles = find_circles(local)[problem.pattern.kind]
    standing = find_circles(problem.standing.shapes)
    return problem._replace(prepared=PreparedSources(measure_sources(problem), circles, standing))


def find_circles(shapes: NDArray[np.object_]) -> Floats:
    """A large circle within each of some polygons (n,), as x, y, radius (n, 3).

    >>> find_circles(np.array([shapely.box(0, 0, 9, 4)]))[0, 1:].round(1).tolist()
    [2.0, 2.0]
    """
    lines = shapely.maximum_inscribed_circle(shapes, tolerance=ROUGH)
    middles = shapely.get_coordinates(shapely.get_point(lines, 0))
    return np.column_stack([middles, shapely.length(lines)]) if len(shapes) else np.zeros((0, 3))


def measure_sources(problem: ExtendProblem) -> dict[str, Floats]:
    """The features of all sources, each measured separately."""
    pattern = problem.pattern
    heights = np.array([kind.size[2] for kind in pattern.kinds])[pattern.kind]
    rows = []
    for number, roads in enumerate(problem.source_roads):
        mine = pattern.source == number
        frames = BuiltFrames(pattern.boxes[mine], pattern.shapes[mine], heights[mine])
        rows.append(measure_buildings(frames, roads))
    return join_measures(rows)


def prepared_of(problem: ExtendProblem) -> PreparedSources:
    """What is prepared of a problem, prepared now if it was not."""
    return problem.prepared or prepared_of(prepare_sources(problem))
