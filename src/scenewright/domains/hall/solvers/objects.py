"""Halls object by object, without patterns: what the baselines start from and what they return."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.moves import drawn_edge
from scenewright.domains.hall.terms.guidelines import Ways, put, stamp
from scenewright.domains.hall.terms.measure import meets, within
from scenewright.domains.hall.terms.state import Floats, PreparedHall, State
from scenewright.engine.draws import Stream, below, uniform
from scenewright.geometry.boxes import Frame, common_area, make_frame, read_frame
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.inside import lie_inside

TRIES = 400
CELLS = 10_000


class ObjectLayout(NamedTuple):
    """Boxes (n, 5) of all objects, the solver's own cost of them, and layouts looked at."""

    boxes: Floats
    energy: float
    evaluations: int


def make_ways(problem: HallProblem) -> Ways:
    """The cells of the hall people can stand in, as far as walls are concerned."""
    x0, y0, x1, y1 = map(float, problem.ground.bounds)
    cell, radius = max(0.2, math.sqrt((x1 - x0) * (y1 - y0) / CELLS)), 0.5 * problem.route
    columns, rows = int((x1 - x0) / cell) + 1, int((y1 - y0) / cell) + 1
    x, y = np.meshgrid(np.arange(columns) + 0.5, np.arange(rows) + 0.5)
    points = shapely.points(x0 + cell * x, y0 + cell * y)
    edges = np.asarray(problem.ground.edges, np.float64)
    walls = shapely.multilinestrings(shapely.linestrings(edges.reshape(-1, 2, 2)))
    inside = lie_inside(edges, x0 + cell * x, y0 + cell * y)
    cover = np.where(inside & ~shapely.dwithin(points, walls, radius), 0, 1).astype(np.int64)
    return Ways(
        x0,
        y0,
        cell,
        radius,
        rows,
        columns,
        cover.ravel(),
        np.zeros(cover.size, np.int64),
        np.zeros(cover.size + 4, np.int64),
    )


@inlined
def at_wall(p: PreparedHall, i: int, stream: Stream) -> tuple[bool, Frame]:
    """A drawn place at a wall of the object's zone, its back to it; false if it has no wall."""
    zone, total, w, d = p.zones[p.unit_of[i]], 0.0, p.sizes[i, 0], p.sizes[i, 1]
    nowhere = make_frame(0.0, 0.0, 0.0, w, d)
    first, last = p.loop_spans[zone, 0], p.loop_spans[zone, 1]
    for k in range(first, last):
        total += max(p.stretches[p.loops[k], 4] - w, 0.0)
    if total <= 0.0:
        return False, nowhere
    rest = uniform(stream) * total
    for k in range(first, last):
        row = p.loops[k]
        room = max(p.stretches[row, 4] - w, 0.0)
        if room > 0.0 and rest <= room:
            dx, dy, off = p.stretches[row, 2], p.stretches[row, 3], 0.5 * d + 0.003
            along = rest + 0.5 * w
            x, y = p.stretches[row, 0] + dx * along, p.stretches[row, 1] + dy * along
            return True, make_frame(x - dy * off, y + dx * off, math.atan2(dx, -dy), w, d)
        rest -= room
    return False, nowhere


@inlined
def anywhere(p: PreparedHall, i: int, stream: Stream) -> Frame:
    """A drawn place in the object's zone, parallel to one of its edges."""
    zone, bounds = p.zones[p.unit_of[i]], p.zone_bounds
    x = bounds[zone, 0] + uniform(stream) * (bounds[zone, 2] - bounds[zone, 0])
    y = bounds[zone, 1] + uniform(stream) * (bounds[zone, 3] - bounds[zone, 1])
    heading = drawn_edge(p, zone, stream) + 0.5 * math.pi * below(stream, 4)
    return make_frame(x, y, heading, p.sizes[i, 0], p.sizes[i, 1])


@inlined
def drawn_place(p: PreparedHall, i: int, stream: Stream) -> Frame:
    """At a wall for objects that belong there, else anywhere."""
    if p.wall_bound[p.unit_of[i]] == 1:
        found, frame = at_wall(p, i, stream)
        if found:
            return frame
    return anywhere(p, i, stream)


@compiled
def drop(p: PreparedHall, s: State, ways: Ways, tries: int, stream: Stream) -> int:
    """Put every object somewhere in its zone, clear of all others if such a place is found in
    ``tries`` tries; how many were not."""
    failed, n = 0, s.frames.shape[0]
    for i in range(n):
        zone, good = p.zones[p.unit_of[i]], False
        frame = drawn_place(p, i, stream)
        for _ in range(tries):
            good = within(frame, p, zone) and not meets(frame, p.obstacles)
            good = good and not meets(frame, p.keep_free)
            for j in range(i):
                if good and common_area(frame, read_frame(s.frames, j)) > 1e-4:
                    good = False
            if good:
                break
            frame = drawn_place(p, i, stream)
        put(p, s, ways, i, frame)
        failed += 0 if good else 1
    return failed


@compiled
def lay(p: PreparedHall, s: State, ways: Ways, boxes: Floats) -> None:
    """Put every object where a box (n, 5) says."""
    for i in range(s.frames.shape[0]):
        put(
            p,
            s,
            ways,
            i,
            make_frame(boxes[i, 0], boxes[i, 1], boxes[i, 2], p.sizes[i, 0], p.sizes[i, 1]),
        )


@compiled
def cover_obstacles(p: PreparedHall, ways: Ways) -> None:
    """Stamp the fixed objects of the hall."""
    for k in range(p.obstacles.shape[0]):
        stamp(ways, read_frame(p.obstacles, k), 1)


def boxes_of(s: State) -> Floats:
    """Boxes (n, 5) of the footprints of a state, headings in [0, 2π)."""
    boxes: Floats = s.frames[:, [0, 1, 7, 4, 5]] * np.array([1.0, 1.0, 1.0, 2.0, 2.0])
    boxes[:, 2] %= 2.0 * math.pi
    return boxes
