"""Bare floor: where much of a zone is empty, groups that stand free move there or spread."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.retouch.places import shift, widen
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST, GUIDE, MAIN, SPEAKER, TILL
from scenewright.geometry.boxes import frames_of
from scenewright.geometry.empty_circles import find_empty_circles
from scenewright.geometry.inside import lie_inside

FLOOR_STEP, POINTS = 0.7, 20_000
"""Metres between the points at which floor is looked at, at least, and how many there are at
most."""
LEAST_CIRCLE, CIRCLE_SHARE, MOST_OF_CIRCLE = 3.0, 0.15, 2.0
"""Radius of a circle of floor that may be empty, in metres and as a share of the root of the floor
of its zone, and metres beyond which more count no more."""
PART, NEAR = (0.5, 0.75, 1.0), (-1.5, 0.0, 1.5)
"""Parts of the way to the middle of an empty circle, and metres beside it, that are tried."""
SMALL_FILLER = 2.5
"""Square metres that the objects of a group have to stand on, else they fill no floor."""
WIDER = (0.4, 0.8, 1.2)
"""Metres by which gaps of rows are made wider."""


class BareFloor(NamedTuple):
    """Points (k, 2) of the floor of a problem, the zone (k,) of each, and how far it is from walls
    and from the main entrance (k,)."""

    problem: HallProblem
    points: Floats
    zones: Ints
    walls: Floats


def find_floor(problem: HallProblem) -> BareFloor:
    """Points all over the floor of a problem that zones have, in very large halls farther apart."""
    ground = problem.ground
    x0, y0, x1, y1 = ground.bounds
    step = max(FLOOR_STEP, float(np.sqrt((x1 - x0) * (y1 - y0) / POINTS)))
    grid = np.meshgrid(np.arange(x0 + 0.5 * step, x1, step), np.arange(y0 + 0.5 * step, y1, step))
    points = np.stack([part.ravel() for part in grid], axis=1)
    zones = np.full(len(points), -1)
    for zone, (first, last) in enumerate(ground.zone_spans.astype(int)):
        zones[lie_inside(ground.zone_edges[first:last], *points.T)] = zone
    points, zones = points[zones >= 0], zones[zones >= 0]
    lines = shapely.linestrings(ground.edges[:, :4].reshape(-1, 2, 2))
    far = shapely.distance(shapely.points(points), shapely.multilinestrings(lines))
    for door in problem.visitors.entrances[:1]:
        far = np.minimum(far, np.hypot(*(points - door).T))
    return BareFloor(problem, points, zones, far)


def find_circles(floor: BareFloor, boxes: Floats) -> Floats:
    """The largest circle (z, 3) of each zone with nothing of boxes (n, 5) in it: its middle, and
    its radius in metres."""
    around = np.concatenate([boxes, floor.problem.ground.obstacles])
    circles = np.zeros((len(floor.problem.ground.zone_areas), 3))
    find_empty_circles(floor.points, floor.zones, floor.walls, frames_of(around), circles)
    return circles


def measure_bare(floor: BareFloor, kept: Kept, boxes: Floats) -> float:
    """Metres by which the largest empty circles of zones with groups that may move are too wide."""
    movable = {int(floor.problem.units.zones[unit]) for unit in _find_movable(floor.problem, kept)}
    if not movable:
        return 0.0
    beyond = find_circles(floor, boxes)[:, 2] - _find_allowed(floor.problem)
    return float(sum(min(max(beyond[zone], 0.0), MOST_OF_CIRCLE) for zone in movable))


def _find_allowed(problem: HallProblem) -> Floats:
    """The radius (z,) of an empty circle that each zone may have, in metres."""
    return np.maximum(LEAST_CIRCLE, CIRCLE_SHARE * np.sqrt(problem.ground.zone_areas))


def _find_movable(problem: HallProblem, kept: Kept) -> list[int]:
    """The units that stand free and are large enough to fill floor, and neither serve, guide nor
    look at something, nor are looked at or the main exhibit."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    floor = [float(units.sizes[slice(*span)].prod(1).sum()) for span in units.spans]
    return [
        unit
        for unit in range(len(roles))
        if floor[unit] >= SMALL_FILLER
        and not roles[unit] & (FIRST | TILL | GUIDE | SPEAKER | MAIN)
        and int(kept.rows[unit, 0]) != WALL
        and units.targets[unit] < 0
        and unit not in units.targets
    ]


def propose_moves(floor: BareFloor, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one group moved towards the largest empty circle of its zone, or its rows
    wider apart."""
    problem, circles = floor.problem, find_circles(floor, boxes)
    allowed = _find_allowed(problem)
    for unit in _find_movable(problem, kept):
        x, y, radius = circles[problem.units.zones[unit]]
        if radius <= allowed[problem.units.zones[unit]]:
            continue
        way = np.array([x, y]) - kept.pose[unit, :2]
        left = np.array([-way[1], way[0]]) / max(float(np.hypot(*way)), 1e-9)
        for form in (kept, *widen(problem, kept, unit, WIDER)):
            for part in PART if form is kept else (0.25, 0.5):
                for aside in NEAR if form is kept else (0.0,):
                    yield shift(form, unit, part * way + aside * left)
