"""Buildings along edges: the streets and the border of a source have theirs, and so do new ones.

An edge is a street, seen from either side, or the border of the ground, seen from within. The
buildings that stand along the source's edges, parallel to them, are read off in order with their
setbacks and gaps; along the edges of an area they follow in the same order, until as large a share
of each kind of edge is built along as in the source.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.domains.extend.problem import ExtendProblem, Floats
from scenewright.domains.extend.solvers.canvas import Canvas
from scenewright.ground.buildings.built import BuiltRoad

NEAR, PARALLEL = 14.0, float(np.deg2rad(12.0))
"""Metres from an edge within which a building stands along it, and by how much it may turn."""
SHARED, SHORTEST, STEP = 8.0, 12.0, 2.0
"""Metres from the source within which a border is none, of the shortest straight edge, and moved on
where a building cannot stand."""
FEWEST = 3
"""Fewer buildings along edges are no rule."""


class EdgeMember(NamedTuple):
    """A building along an edge: its number among those of the sources, its heading from the
    edge's direction, the distance of its middle from the edge, its extent along it, and the gap to
    the next along it, in metres and radians."""

    origin: int
    turn: float
    setback: float
    extent: float
    gap: float


class EdgeRule(NamedTuple):
    """Buildings along one kind of edge: its members in order, and the share of the edge's length
    they take."""

    members: tuple[EdgeMember, ...]
    share: float


class EdgeGround(NamedTuple):
    """The straight edges (2, 2) of one kind in an area, and the rule of the sources for them."""

    runs: tuple[Floats, ...]
    rule: EdgeRule


def read_edges(problem: ExtendProblem) -> tuple[EdgeGround, ...]:
    """The streets and the outer border of the area, as far as the sources build along theirs."""
    found = []
    for theirs, ours in ((source_streets, area_streets), (source_borders, area_borders)):
        runs = tuple(run for line in ours(problem) for run in straight_runs(line))
        rule = learn_rule(problem, theirs(problem)) if runs else EdgeRule((), 0.0)
        if len(rule.members) >= FEWEST:
            found.append(EdgeGround(runs, rule))
    return tuple(found)


def lay_edges(canvas: Canvas, edges: Sequence[EdgeGround], rng: np.random.Generator) -> int:
    """Build along the edges of the area as the sources do; how many."""
    made = 0
    for runs, rule in edges:
        length = sum(float(np.hypot(*(run[1] - run[0]))) for run in runs)
        left = rule.share * length
        for k in rng.permutation(len(runs)).tolist():
            taken, count = _lay_run(canvas, runs[k], rule, left, rng)
            left, made = left - taken, made + count
    return made


def _lay_run(
    canvas: Canvas, run: Floats, rule: EdgeRule, left: float, rng: np.random.Generator
) -> tuple[float, int]:
    """Build along one straight edge (2, 2); metres taken, and how many buildings."""
    way = run[1] - run[0]
    length = float(np.hypot(*way))
    way = way / length
    k, at, taken, made = int(rng.integers(len(rule.members))), 0.0, 0.0, 0
    while at < length and taken < left and not canvas.full():
        one = rule.members[k]
        pose = edge_pose(run[0], way, at + one.extent / 2, one)
        here = np.array([one.origin])
        if (
            at + one.extent <= length
            and canvas.room_for(one.origin)
            and canvas.legal(pose[None], here)[0]
        ):
            canvas.add(pose, one.origin, "edge")
            taken, made = taken + one.extent, made + 1
            at, k = at + one.extent + one.gap, (k + 1) % len(rule.members)
        else:
            at, k = at + STEP, int(rng.integers(len(rule.members)))
    return taken, made


def edge_pose(start: Floats, way: Floats, at: float, one: EdgeMember) -> Floats:
    """The pose (3,) of a building whose middle is ``at`` metres along an edge that starts at
    ``start`` in direction ``way``, to its left.

    >>> one = EdgeMember(0, -np.pi / 2, 6.0, 10.0, 3.0)
    >>> edge_pose(np.zeros(2), np.array([1.0, 0.0]), 5.0, one).round(3).tolist()
    [5.0, 6.0, -1.571]
    """
    spot = start + way * at + np.array([-way[1], way[0]]) * one.setback
    return np.array([*spot, float(np.arctan2(way[1], way[0])) + one.turn])


def learn_rule(problem: ExtendProblem, lines: list[NDArray[np.float64]]) -> EdgeRule:
    """Buildings along the source's edges, each line (n, 2) with its buildings on the left."""
    pattern = problem.pattern
    edges = [run for line in lines for run in straight_runs(line, 1.0)]
    total = sum(float(np.hypot(*(run[1] - run[0]))) for run in edges)
    found: list[tuple[int, float, EdgeMember]] = []
    for number in range(len(pattern.boxes)):
        near = [(side, k) for k, run in enumerate(edges) if (side := _along(problem, number, run))]
        if near:
            (_, start, one), k = min(near, key=lambda pair: pair[0][0])
            found.append((k, start, one))
    if not found:
        return EdgeRule((), 0.0)
    found.sort(key=lambda row: (row[0], row[1]))
    gaps = [max(b[1] - a[1] - a[2].extent, 0.0) for a, b in pairwise(found) if a[0] == b[0]]
    usual = float(np.median(gaps)) if gaps else max(problem.pattern.gaps.side, 3.0)
    members = []
    for a, b in zip(found, [*found[1:], None], strict=True):
        gap = b[1] - a[1] - a[2].extent if b is not None and b[0] == a[0] else usual
        members.append(a[2]._replace(gap=float(np.clip(gap, 0.0, 3 * usual + 5.0))))
    share = min(sum(one.extent for one in members) / max(total, 1.0), 0.9)
    return EdgeRule(tuple(members), share)


def _along(
    problem: ExtendProblem, number: int, run: Floats
) -> tuple[float, float, EdgeMember] | None:
    """How far a building is from a straight edge it stands along, where it begins on it, and how
    it stands; none if it does not."""
    box = problem.pattern.boxes[number]
    way = run[1] - run[0]
    length = float(np.hypot(*way))
    way = way / length
    step = box[:2] - run[0]
    at, aside = float(step @ way), float(way[0] * step[1] - way[1] * step[0])
    turn = float(box[2] - np.arctan2(way[1], way[0]))
    odd = abs((turn + np.pi / 4) % (np.pi / 2) - np.pi / 4)
    if odd > PARALLEL:
        return None
    level = abs(np.sin(turn)) > 0.7
    extent, deep = (box[3], box[4]) if level else (box[4], box[3])
    away = aside - deep / 2
    if not (-1.0 <= away <= NEAR and -extent / 4 <= at <= length + extent / 4):
        return None
    snapped = float(np.round(turn / (np.pi / 2)) * (np.pi / 2))
    one = EdgeMember(number, snapped, aside, float(extent), 0.0)
    return float(away), at - float(extent) / 2, one


def straight_runs(line: NDArray[np.float64], least: float = SHORTEST) -> list[Floats]:
    """The straight parts (2, 2) of a line (n, 2) that are long enough.

    >>> bent = np.array([[0, 0], [20, 0.1], [40, 0], [40, 5], [90, 5.0]])
    >>> [part.tolist() for part in straight_runs(bent)]
    [[[0.0, 0.0], [40.0, 0.0]], [[40.0, 5.0], [90.0, 5.0]]]
    """
    points = shapely.get_coordinates(shapely.simplify(shapely.LineString(line), 0.8))
    length = np.hypot(*np.diff(points, axis=0).T)
    return [points[k : k + 2] for k in np.flatnonzero(length >= least).tolist()]


def source_streets(problem: ExtendProblem) -> list[Floats]:
    """The streets of the sources, in both directions."""
    return [side for roads in problem.source_roads for side in _both_sides(roads)]


def area_streets(problem: ExtendProblem) -> list[Floats]:
    """The streets in the area, in both directions."""
    inside = []
    for road in problem.roads:
        for part in shapely.get_parts(
            shapely.intersection(shapely.LineString(road.line), problem.outline)
        ):
            if part.geom_type == "LineString":
                inside.append(road._replace(line=shapely.get_coordinates(part)))
    return list(_both_sides(inside))


def _both_sides(roads: list[BuiltRoad] | tuple[BuiltRoad, ...]) -> Iterator[Floats]:
    for road in roads:
        if road.kind == "road":
            yield road.line
            yield road.line[::-1]


def source_borders(problem: ExtendProblem) -> list[Floats]:
    """The borders of the sources' grounds where they do not adjoin the area."""
    found = []
    for ground in problem.grounds:
        if ground is not None:
            found += _apart(ground, problem.outline)
    return found


def area_borders(problem: ExtendProblem) -> list[Floats]:
    """The border of the area where it does not adjoin a source."""
    grounds = [ground for ground in problem.grounds if ground is not None]
    return _apart(problem.outline, shapely.union_all(grounds)) if grounds else []


def _apart(ring: shapely.Polygon, other: shapely.Geometry) -> list[Floats]:
    """The parts of the border of ``ring``, counter-clockwise, that are apart from ``other``."""
    border = shapely.LineString(shapely.orient_polygons(ring).exterior.coords)
    left = shapely.difference(border, shapely.buffer(other, SHARED))
    parts = [part for part in shapely.get_parts(left) if part.geom_type == "LineString"]
    return [shapely.get_coordinates(shapely.line_merge(part)) for part in parts]
