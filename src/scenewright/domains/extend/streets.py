"""Streets of the sources that end at the border of an area, continued into it."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import cycle
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.plan import SitePlan

NEAR = 25.0
"""Metres from an area within which a street that ends counts as ending at its border."""
LEAST = 15.0
"""Metres of new street that are worth building, and of a street that is worth continuing."""
CLEAR = 1.0
"""Metres kept from buildings."""
JOINED = 8.0
"""Metres from a drawn street within which a street counts as continued by it."""
BEND, COARSE = float(np.deg2rad(35.0)), 0.5
"""How far a street turns at most at one point of a bend, beyond which it is a corner, and metres
by which its line is simplified."""
ALONG, FAR, FIRST = 0.7, 3000.0, 0.5
"""The share of its length that the ends of a new street are apart at least, metres that it is
drawn before it is cut, and the share of the first straight part that it still runs."""
MEETS, APART, SPACED = 1.0, 18.0, (30.0, 90.0)
"""Metres within which one street begins at another, that new side streets keep from all others, and
between two side streets at least and at most."""


class Junction(NamedTuple):
    """A side street of a source: the angle at which it leaves (0 to π, to the left of the street
    it begins at), and the street itself."""

    angle: float
    road: BuiltRoad


def continue_streets(
    roads: Sequence[BuiltRoad],
    outline: shapely.Polygon,
    buildings: Sequence[shapely.Polygon],
    drawn: Sequence[BuiltRoad],
) -> tuple[BuiltRoad, ...]:
    """Streets that run on from the ends of ``roads`` that lie at an area's border, to its other
    side, with the bends they came with or else those of the others, and side streets at them as
    often and at the angles as in the source; none through buildings, none beside another.

    >>> street = BuiltRoad(np.array([[-50.0, 5.0], [-2.0, 5.0]]), 6.0)
    >>> (found,) = continue_streets([street], shapely.box(0, 0, 40, 30), [], [])
    >>> found.line.round(3).tolist()
    [[-2.0, 5.0], [40.0, 5.0]]
    """
    found: list[BuiltRoad] = []
    taken = shapely.union_all([b.buffer(CLEAR) for b in buildings])
    there = [shapely.LineString(road.line) for road in drawn]
    every = [bend for road in roads if road.kind == "road" for bend in read_bends(road.line)]
    pool = [bend for bend in every if bend[1]]
    for road in (one for one in roads if shapely.LineString(one.line).length >= LEAST):
        for way in (road.line, road.line[::-1]):
            if any(one.distance(shapely.Point(way[-1])) < JOINED for one in there):
                continue
            own, others = read_bends(way), pool[len(found) :] + pool[: len(found)]
            bends = own if any(turn for _, turn in own) else others
            beside = [shapely.LineString(one.line) for one in found]
            for line in (_run_on(way, outline, some) for some in (bends, [])):
                if line is None or line.length < LEAST or _is_blocked(line, road, taken):
                    continue
                if not any(one.hausdorff_distance(line) < 10 for one in beside):
                    found.append(road._replace(line=shapely.get_coordinates(line)))
                break
    return (*found, *_branch_off(roads, found, drawn, outline, taken))


def _is_blocked(line: shapely.LineString, road: BuiltRoad, taken: shapely.Geometry) -> bool:
    return bool(line.distance(taken) < road.width / 2 and line.crosses(taken))


def _run_on(
    way: Points, outline: shapely.Polygon, bends: Sequence[tuple[float, float]]
) -> shapely.LineString | None:
    """The line from the end of a street to where it leaves the area, with some bends or straight;
    ``None`` if it does not enter, or turns back."""
    end, inner = way[-1], way[-2]
    if outline.distance(shapely.Point(end)) > NEAR or np.hypot(*(end - inner)) < 1e-6:
        return None
    line = _draw_on(end, float(np.arctan2(*(end - inner)[::-1])), bends)
    inside = shapely.intersection(line, outline)
    parts = [p for p in shapely.get_parts(inside) if p.geom_type == "LineString" and p.length > 0.0]
    if not parts:
        return None
    first = min(parts, key=lambda part: part.distance(shapely.Point(end)))
    if first.distance(shapely.Point(end)) > NEAR:
        return None
    points = shapely.get_coordinates(first)
    if first.distance(shapely.Point(end)) > 1e-6:
        points = np.concatenate([end[None], points])
    apart = float(np.hypot(*(points[-1] - points[0])))
    found = shapely.simplify(shapely.LineString(points), 1e-6)
    return None if apart < ALONG * found.length else found


def read_bends(way: Points) -> list[tuple[float, float]]:
    """The bends of a street towards its end, from there backwards: metres before each, and radians
    by which the street turns, to the left positive. Corners count as none.

    >>> bends = read_bends(np.array([[0.0, 0.0], [20.0, 0.0], [40.0, 4.0], [50.0, 6.0]]))
    >>> [(round(long), round(turn, 2)) for long, turn in bends]
    [(31, 0.2)]
    """
    points = shapely.get_coordinates(shapely.simplify(shapely.LineString(way), COARSE))
    steps = np.diff(points, axis=0)
    bearing = np.arctan2(steps[:, 1], steps[:, 0])
    turns = (np.diff(bearing) + np.pi) % (2 * np.pi) - np.pi
    turns = np.where(np.abs(turns) > BEND, 0.0, turns)
    lengths = np.maximum(np.hypot(*steps[1:].T), 1.0)
    return list(zip(lengths[::-1].tolist(), turns[::-1].tolist(), strict=True))


def _draw_on(
    start: Points, bearing: float, bends: Sequence[tuple[float, float]]
) -> shapely.LineString:
    """A line of :data:`FAR` metres from a point; bends turn it by a sixth of a turn at most."""
    points, left, at, first = [start], FAR, start, bearing
    for number, (long, turn) in enumerate(cycle(bends) if bends else ((FAR, 0.0),)):
        length = long if number else long * FIRST
        at = at + length * np.array([np.cos(bearing), np.sin(bearing)])
        points.append(at)
        left -= length
        bearing += turn if abs(bearing + turn - first) < np.pi / 3 else 0.0
        if left <= 0 or len(points) > 200:
            break
    return shapely.LineString(points)


def read_junctions(roads: Sequence[BuiltRoad]) -> tuple[list[Junction], float]:
    """The side streets of some streets, and the usual metres between them along a street."""
    lines = np.array([shapely.LineString(road.line) for road in roads], object)
    ways = [way for road in roads for way in (road.line, road.line[::-1])]
    ends = shapely.points(np.array([way[0] for way in ways]).reshape(-1, 2))
    meeting = shapely.STRtree(lines).query(ends, predicate="dwithin", distance=MEETS)
    found = list[Junction]()
    for end, other in sorted(meeting.T.tolist()):
        angle = _angle_at(lines[other], ways[end])
        if other != end // 2 and min(angle, np.pi - angle) > BEND:
            found.append(Junction(angle, roads[end // 2]))
    length = sum(line.length for line in lines)
    return found, float(np.clip(length / max(len(found), 1), *SPACED))


def _angle_at(line: shapely.LineString, way: Points) -> float:
    """The angle (0 to π) at which a way leaves the line it begins at."""
    at = line.project(shapely.Point(way[0]))
    ends = [line.interpolate(max(at - 1.0, 0.0)), line.interpolate(at + 1.0)]
    along, out = np.diff(shapely.get_coordinates(ends), axis=0)[0], way[1] - way[0]
    turn = np.arctan2(out[1], out[0]) - np.arctan2(along[1], along[0])
    return float(abs((turn + np.pi) % (2 * np.pi) - np.pi))


def _branch_off(
    roads: Sequence[BuiltRoad],
    hosts: Sequence[BuiltRoad],
    drawn: Sequence[BuiltRoad],
    outline: shapely.Polygon,
    taken: shapely.Geometry,
) -> tuple[BuiltRoad, ...]:
    """Side streets of new streets, the source's own in turn, on either side in turn, each to the
    next street or the border."""
    junctions, spacing = read_junctions([road for road in roads if road.kind == "road"])
    lines = [shapely.LineString(road.line) for road in (*roads, *hosts, *drawn)]
    streets = shapely.union_all([one for one in lines if one.distance(outline) < APART])
    found, number = list[BuiltRoad](), 0
    for host in (one for one in hosts if one.kind == "road" and junctions):
        line = shapely.LineString(host.line)
        for at in np.arange(spacing / 2, line.length - APART, spacing).tolist():
            angle, side = junctions[number % len(junctions)]
            spots = shapely.get_coordinates([line.interpolate(at), line.interpolate(at + 1.0)])
            bearing = float(np.arctan2(*(spots[1] - spots[0])[::-1]))
            bearing += angle if number % 2 else -angle
            road = _side_street(spots[0], bearing, side, outline, streets)
            number += 1
            if road is not None and not _is_blocked(shapely.LineString(road.line), road, taken):
                found.append(road)
                streets = shapely.union(streets, shapely.LineString(road.line))
    return tuple(found)


def _side_street(
    start: Points,
    bearing: float,
    like: BuiltRoad,
    outline: shapely.Polygon,
    streets: shapely.Geometry,
) -> BuiltRoad | None:
    """A street like another from a point to the next street or the border; ``None`` if that is
    near, or if it runs beside another."""
    line = shapely.intersection(_draw_on(start, bearing, read_bends(like.line[::-1])), outline)
    away = shapely.Point(start).buffer(MEETS)
    met = shapely.difference(shapely.intersection(line, streets), away)
    rest = shapely.difference(line, shapely.buffer(met, 0.01)) if not met.is_empty else line
    parts = [p for p in shapely.get_parts(rest) if p.geom_type == "LineString"]
    first = min(parts, key=lambda part: part.distance(shapely.Point(start)), default=None)
    if first is None or first.length < 2 * LEAST or first.distance(shapely.Point(start)) > MEETS:
        return None
    beyond = shapely.difference(first, shapely.Point(start).buffer(1.5 * APART))
    end = shapely.Point(first.coords[-1]).buffer(1.5 * APART)
    middle = beyond if met.is_empty else shapely.difference(beyond, end)
    if not middle.is_empty and middle.distance(streets) < APART:
        return None
    points = shapely.get_coordinates(first)
    from_start = np.hypot(*(points[[0, -1]] - start).T)
    points = points if from_start[0] < from_start[1] else points[::-1]
    return BuiltRoad(points, like.width, like.kind, "")


def list_grounds(_solution: Solution, plan: Plan) -> tuple[SitePlan, ...]:
    """The ground of an extension, old and new."""
    return (plan.detail.ground,)


def list_ways(solution: Solution, plan: Plan) -> list[BuiltRoad]:
    """The middle lines of all streets of an extension, old and new."""
    del solution
    ways = plan.detail.ground.roads
    return [BuiltRoad(way.line, way.width, way.kind, way.name) for way in ways]
