"""Fronts to the street: buildings by a street that look away from it are turned round.

A copy keeps the front its original has towards its neighbours, and where the streets of the area
run otherwise that may look away. Turned by half a circle a rectangle covers the same ground, so
nothing else changes.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.domains.extend.problem import ExtendProblem, GrownLayout, shapes_at
from scenewright.ground.buildings.built import wrap_angles

BY, SAME = 16.0, 0.001
"""Metres from a street within which a front looks at it, and the share of a footprint that may
differ once it is turned round."""


def turn_fronts(problem: ExtendProblem, layout: GrownLayout) -> GrownLayout:
    """The layout with the front of every rectangle by a street on the side towards it, where it has
    been on the one away."""
    lines = [shapely.LineString(road.line) for road in problem.roads]
    if not lines or not len(layout.poses):
        return layout
    streets = shapely.union_all(lines)
    shapes = shapes_at(problem.pattern, layout.poses, layout.origin)
    turned = layout.poses + np.array([0.0, 0.0, np.pi])
    after = shapes_at(problem.pattern, turned, layout.origin)
    alike = shapely.area(shapely.symmetric_difference(shapes, after)) < SAME * shapely.area(shapes)
    steps = shapely.get_coordinates(shapely.shortest_line(shapely.centroid(shapes), streets))
    step = np.diff(steps.reshape(-1, 2, 2), axis=1)[:, 0]
    ahead = np.stack([np.cos(layout.poses[:, 2]), np.sin(layout.poses[:, 2])], 1)
    away = (step * ahead).sum(1) < -0.5 * np.hypot(*step.T)
    wrong = alike & away & (shapely.distance(shapes, streets) < BY)
    poses = np.where(wrong[:, None], turned, layout.poses)
    poses[:, 2] = wrap_angles(poses[:, 2])
    return layout._replace(poses=poses)
