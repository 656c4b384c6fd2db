"""Bare floor: where much of a zone is empty, groups that stand free move there or spread."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.hall.patterns import ACROSS, ALONG, CHAIN, GRID, WALL
from scenewright.domains.hall.problem import Floats, HallProblem, Ints
from scenewright.domains.hall.retouch.lines import find_layers
from scenewright.domains.hall.retouch.places import fill_floor, find_axes, shift, widen
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST, GUIDE, MAIN, SPEAKER, TILL
from scenewright.geometry.boxes import frames_of
from scenewright.geometry.empty_circles import add_far_floor, find_empty_circles
from scenewright.geometry.inside import lie_inside

FLOOR_STEP, POINTS = 0.7, 20_000
"""Metres between the points at which floor is looked at, at least, and how many there are at
most."""
LEAST_CIRCLE, CIRCLE_SHARE = 2.4, 0.076
"""Radius of a circle of floor that may be empty, in metres and as a share of the root of the floor
of its zone."""
PART, NEAR = (0.5, 0.75, 1.0), (-1.5, 0.0, 1.5)
"""Parts of the way to the middle of an empty circle, and metres beside it, that are tried."""
SMALL_FILLER = 1.2
"""Square metres that the objects of a group have to stand on, else they fill no floor."""
WIDER = (0.4, 0.8, 1.2)
"""Metres by which gaps of rows are made wider."""
INSETS, STRETCHED, MOST_STRETCHED, LOOSE_GAP = (0.9, 1.6, 2.4), (1.0, 0.6, 0.3), 4.0, 0.1
"""Metres off the bounds of a zone to which all that may move is stretched, parts of that, and how
many times as wide it becomes at most; the least that is a gap, in metres."""


class BareFloor(NamedTuple):
    """Points (k, 2) of the floor of a problem, the zone (k,) of each, how far it is from walls
    and from the main entrance (k,), and square metres of floor for each."""

    problem: HallProblem
    points: Floats
    zones: Ints
    walls: Floats
    each: float


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
    return BareFloor(problem, points, zones, far, step * step)


def find_circles(floor: BareFloor, boxes: Floats) -> Floats:
    """The largest circle (z, 3) of each zone with nothing of boxes (n, 5) in it: its middle, and
    its radius in metres."""
    around = np.concatenate([boxes, floor.problem.ground.obstacles])
    circles = np.zeros((len(floor.problem.ground.zone_areas), 3))
    find_empty_circles(floor.points, floor.zones, floor.walls, frames_of(around), circles)
    return circles


def measure_bare(floor: BareFloor, kept: Kept, boxes: Floats) -> float:
    """How wide empty circles of zones with groups that may move are beyond what they may be, in
    metres: 2 ∛(Σ (r - r_0) a), where floor of a square metres is r from everything; of one circle
    about its own excess, of several more."""
    movable = {int(floor.problem.units.zones[unit]) for unit in _find_movable(floor.problem, kept)}
    if not movable:
        return 0.0
    around = frames_of(np.concatenate([boxes, floor.problem.ground.obstacles]))
    sums, allowed = np.zeros(len(floor.problem.ground.zone_areas)), _find_allowed(floor.problem)
    add_far_floor(floor.points, floor.zones, floor.walls, around, allowed, sums)
    return float(sum(2.0 * np.cbrt(floor.each * sums[zone]) for zone in movable))


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
    allowed, movable = _find_allowed(problem), _find_movable(problem, kept)
    for zone in np.flatnonzero(circles[:, 2] > allowed):
        mine = [unit for unit in movable if int(problem.units.zones[unit]) == zone]
        yield from _stretch(problem, kept, boxes, int(zone), mine)
    for unit in movable:
        x, y, radius = circles[problem.units.zones[unit]]
        if radius <= allowed[problem.units.zones[unit]]:
            continue
        way = np.array([x, y]) - kept.pose[unit, :2]
        left = np.array([-way[1], way[0]]) / max(float(np.hypot(*way)), 1e-9)
        for form in (kept, *widen(problem, kept, unit, WIDER)):
            for part in PART if form is kept else (0.25, 0.5):
                for aside in NEAR if form is kept else (0.0,):
                    yield shift(form, unit, part * way + aside * left)
        yield from fill_floor(problem, kept, boxes, unit)


def _stretch(
    problem: HallProblem, kept: Kept, boxes: Floats, zone: int, units: list[int]
) -> Iterator[Kept]:
    """Layouts with some units drawn apart over their zone, along x and y, their gaps as well."""
    if not units:
        return
    mine = np.concatenate([boxes[slice(*problem.units.spans[unit])] for unit in units])
    seen = corners(mine).reshape(-1, 2)
    low, high = seen.min(0), seen.max(0)
    bounds = problem.ground.zone_bounds[zone].reshape(2, 2)
    for inset, part, axes in product(INSETS, STRETCHED, ((1, 1), (1, 0), (0, 1))):
        wide = np.ptp(bounds, axis=0) - 2.0 * inset
        most = np.clip(wide / np.maximum(high - low, 0.1), 1.0, MOST_STRETCHED)
        by = 1.0 + part * np.array(axes) * (most - 1.0)
        if by.max() > 1.0:
            to = 0.5 * (low + high) + part * (bounds.mean(0) - 0.5 * (low + high))
            pose, layers = kept.pose.copy(), kept.layers.copy()
            pose[units, :2] = to + by * (pose[units, :2] - 0.5 * (low + high))
            for unit in units:
                _draw_apart(problem, kept, boxes, unit, by, layers)
            yield kept._replace(pose=pose, layers=layers)


def _draw_apart(
    problem: HallProblem, kept: Kept, boxes: Floats, unit: int, by: Floats, layers: Floats
) -> None:
    """Widen the gaps of a unit in rows until it is ``by`` (2,) times as long along x and y, those
    between its objects only where they have gaps."""
    if int(kept.rows[unit, 0]) not in (CHAIN, GRID):
        return
    span, first = slice(*problem.units.spans[unit]), find_layers(problem, unit)[0]
    axes = find_axes(float(kept.pose[unit, 2]))
    long = np.ptp(boxes[span, :2] @ axes.T, axis=0) * (np.abs(axes) @ (by - 1.0))
    rows = int(kept.rows[unit, 1])
    many = np.array([-(-(span.stop - span.start) // rows), rows])
    more = long / np.maximum(many - 1, 1)
    mine = slice(first, first + rows)
    layers[mine, ACROSS] += more[1]
    layers[mine, ALONG] += more[0] * (kept.layers[mine, ALONG] > LOOSE_GAP)
