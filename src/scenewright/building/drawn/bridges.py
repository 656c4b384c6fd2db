"""Gaps in walls: lines from jamb to facing jamb, and to the wall opposite where a door is drawn."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Point, STRtree

from scenewright.building.drawn.drawing import Drawn

THICK, NARROW, WIDE = 0.65, 0.45, 3.2
"""Metres: the thickest wall, the narrowest and the widest gap that is bridged."""
DRAWN, GLAZED = 8.0, 20.0
"""The widest gap that a line on a layer of doors closes, and that what is drawn all along it does.
"""
ALONE = 1.35
"""The widest gap to a wall opposite, where no door is drawn."""
SQUARE, AHEAD, FACING = 0.35, 0.94, 0.87
"""The greatest cosine of a square corner, the least of a way straight ahead, and that of ends of a
curved wall that face each other."""
JUST, MISSED = 0.25, 0.03
"""Metres by which a line ends before the one it was meant to reach: ahead of it, and beside it."""
NEAR_DOOR, TOUCH = 0.2, 0.15
"""Metres around a gap in which its door is drawn, and from a door's line to the wall it meets."""
MOST_JAMBS = 1500
"""The most ends of walls: where there are more, lines of letters and hatches are among them, and
those that end the longest lines are taken."""
Vector = NDArray[np.float64]


class Jamb(NamedTuple):
    """The end of a wall: its two corners (alike where the wall is a single line), and the unit
    vector out of the wall."""

    left: Vector
    right: Vector
    out: Vector

    @property
    def middle(self) -> Vector:
        """The middle of the end."""
        return np.asarray((self.left + self.right) / 2)


class Gap(NamedTuple):
    """An opening in a wall: its four corners, going round, and its middle, direction along the
    wall, width and the wall's thickness."""

    corners: Vector
    middle: Vector
    along: Vector
    width: float
    thickness: float


def find_gaps(lines: shapely.Geometry, drawn: Drawn) -> list[Gap]:
    """The gaps in noded wall ``lines``, each closed from jamb to jamb, or from a jamb to the wall
    opposite where a door is drawn (anywhere near, where the drawing has no doors at all)."""
    parts = [p for p in shapely.get_parts(lines) if p.length > 0.005]
    if not parts:
        return []
    jambs = _jambs(parts)
    tree = STRtree(parts)
    doors = door_marks(drawn)
    others = shapely.linestrings(np.concatenate([drawn.windows, drawn.marks]))
    gaps, used = _between_jambs(jambs, tree, parts, (doors, shapely.union_all(others)))
    gaps += _drawn_across(drawn, tree, parts)
    for number, jamb in enumerate(jambs):
        if number not in used:
            gap = _to_wall(jamb, tree, doors)
            if gap is not None:
                gaps.append(gap)
    return gaps


def door_marks(drawn: Drawn) -> shapely.Geometry:
    """All that is drawn of doors: leaves, their arcs, lines on layers of doors."""
    lines = [LineString([a.start, a.middle, a.end]) for a in drawn.arcs]
    lines += [LineString(pair) for pair in drawn.doors if not np.allclose(*pair)]
    return shapely.union_all(lines)


class Graph(NamedTuple):
    """Noded lines: the points ``(k, 2)`` they join, and at each point those it is joined to."""

    points: Vector
    beside: list[list[int]]


def _graph(parts: list[LineString]) -> Graph:
    ends = np.array([[p.coords[0], p.coords[-1]] for p in parts])[..., :2]
    points, inverse = np.unique(np.round(ends.reshape(-1, 2), 4), axis=0, return_inverse=True)
    beside: list[list[int]] = [[] for _ in points]
    for a, b in inverse.reshape(-1, 2).tolist():
        if a != b and b not in beside[a]:
            beside[a].append(b)
            beside[b].append(a)
    return Graph(points, beside)


def extend_loose_ends(parts: list[LineString]) -> list[LineString]:
    """Short lines from loose ends straight ahead, or to the side, to a line they just miss."""
    parts = [part for part in parts if part.length > 0.005]
    graph = _graph(parts)
    tree = STRtree(parts)
    loose = [point for point, others in enumerate(graph.beside) if len(others) == 1]
    if not loose:
        return []
    starts = graph.points[loose]
    ways = starts - graph.points[[graph.beside[point][0] for point in loose]]
    feet = _hits(starts, ways / np.hypot(*ways.T)[:, None], JUST, tree, 1e-4)
    found = []
    for here, foot in zip(starts, feet, strict=True):
        if np.isnan(foot).any():
            near = tree.query(Point(here), predicate="dwithin", distance=MISSED).tolist()
            lines = [parts[k] for k in near if Point(here).distance(parts[k]) > 1e-6]
            foot = _onto(here, lines) if lines else here
        found.append(LineString([here, foot]))
    return [line for line in found if line.length > 1e-6]


def _jambs(parts: list[LineString]) -> list[Jamb]:
    """Ends of walls: straight lines, as long as walls are thick, whose corners both turn squarely
    to the same side with nothing on the other; and loose ends."""
    graph = _graph(parts)
    found: list[Jamb] = []
    lengths: list[float] = []
    seen: set[tuple[int, int]] = set()
    for a, others in enumerate(graph.beside):
        if len(others) == 1:
            way = graph.points[a] - graph.points[others[0]]
            lengths.append(float(np.hypot(*way)))
            found.append(Jamb(graph.points[a], graph.points[a], way / lengths[-1]))
        for b in others:
            jamb = _capped(graph, a, b)
            if jamb is not None and (jamb[0], jamb[1]) not in seen:
                seen |= {(jamb[0], jamb[1]), (jamb[1], jamb[0])}
                lengths.append(np.inf)
                found.append(jamb[2])
    kept = sorted(np.argsort(-np.array(lengths), kind="stable")[:MOST_JAMBS].tolist())
    return [found[k] for k in kept]


def _capped(graph: Graph, a: int, b: int) -> tuple[int, int, Jamb] | None:
    """The end of a wall whose straight line starts at ``a`` towards ``b``: its corners."""
    points = graph.points
    way = points[b] - points[a]
    unit = way / np.hypot(*way)
    side = np.array([-unit[1], unit[0]])
    first = _turn_side(graph, a, unit, side)
    if first is None:
        return None
    end, length = b, float(np.hypot(*way))
    while length <= THICK:
        sides = [float((points[k] - points[end]) @ side) for k in graph.beside[end]]
        if any(first * value < -0.01 for value in sides):
            return None
        ahead = [k for k in graph.beside[end] if _straight(points[k] - points[end], unit)]
        if not ahead:
            break
        length += float(np.hypot(*(points[ahead[0]] - points[end])))
        end = ahead[0]
    last = _turn_side(graph, end, -unit, side)
    if last is None or last != first or not 0.03 <= length <= THICK:
        return None
    out = -first * side
    left = np.array([-out[1], out[0]])
    one, two = points[a], points[end]
    ordered = (one, two) if one @ left > two @ left else (two, one)
    return a, end, Jamb(*ordered, out)


def _turn_side(graph: Graph, corner: int, unit: Vector, side: Vector) -> float | None:
    """To which side the wall's face leaves a corner of its end: 1 left of the line, -1 right;
    ``None`` where the line goes on, or lines leave to both sides or askew."""
    found: set[float] = set()
    for k in graph.beside[corner]:
        way = graph.points[k] - graph.points[corner]
        length = float(np.hypot(*way))
        if way @ unit > AHEAD * length:
            continue
        if abs(way @ unit) > SQUARE * length:
            return None
        if length >= 0.02:
            found.add(float(np.sign(way @ side)))
    return found.pop() if len(found) == 1 else None


def _straight(way: Vector, unit: Vector) -> bool:
    return bool(way @ unit > 0.999 * np.hypot(*way))


def _between_jambs(
    jambs: list[Jamb],
    tree: STRtree,
    parts: list[LineString],
    marked: tuple[shapely.Geometry, shapely.Geometry],
) -> tuple[list[Gap], set[int]]:
    """Gaps between ends of walls that face each other with nothing between them, nearest first;
    wide ones only where a door or window is ``marked``, or none is in the whole drawing."""
    gaps: list[Gap] = []
    used: set[int] = set()
    for i, j in _facing(jambs):
        if i in used or j in used:
            continue
        one, other = jambs[i], jambs[j]
        if not _is_meant(one.middle, other.middle, marked):
            continue
        if _is_free(one.middle, other.middle, tree, parts):
            corners = np.array([one.left, one.right, other.left, other.right])
            gaps.append(_gap(corners))
            used |= {i, j}
    return gaps, used


def _facing(jambs: list[Jamb]) -> list[tuple[int, int]]:
    """Pairs of ends that face each other, no farther apart than gaps are wide, nearest first."""
    if not jambs:
        return []
    places = np.array([jamb.middle for jamb in jambs])
    outs = np.array([jamb.out for jamb in jambs])
    points = shapely.points(places)
    i, j = STRtree(points).query(points, predicate="dwithin", distance=GLAZED)
    keep = (i < j) & ((outs[i] * outs[j]).sum(1) <= -FACING)
    i, j = i[keep], j[keep]
    ways = places[j] - places[i]
    far = np.hypot(*ways.T)
    ahead = ((outs[i] * ways).sum(1) > AHEAD * far) & ((outs[j] * ways).sum(1) < -AHEAD * far)
    keep = ahead & (far >= NARROW)
    order = np.lexsort((j[keep], i[keep], far[keep]))
    return list(zip(i[keep][order].tolist(), j[keep][order].tolist(), strict=True))


def _is_meant(a: Vector, b: Vector, marked: tuple[shapely.Geometry, shapely.Geometry]) -> bool:
    """Whether a gap is as narrow as doors are, or something is drawn along it: a part of a door, or
    all along whatever it is where the gap is wider than doors are."""
    far = float(np.hypot(*(b - a)))
    if far <= ALONE or all(drawn.is_empty for drawn in marked):
        return far <= WIDE
    place = LineString([a, b]).buffer(NEAR_DOOR)
    doors, others = (shapely.intersection(drawn, place) for drawn in marked)
    if far <= WIDE:
        return bool(doors.length + others.length >= 0.3 * far)
    parts = np.concatenate([shapely.get_parts(doors), shapely.get_parts(others)])
    hung = far <= DRAWN and doors.length >= 0.3 * far
    return hung or _covered(a, b, parts) >= 0.9 * far


def _covered(a: Vector, b: Vector, parts: NDArray[np.object_]) -> float:
    """How much of the way from a to b lines lie beside."""
    way = (b - a) / np.hypot(*(b - a))
    ends = sorted(
        sorted(((np.asarray(part.coords)[[0, -1]] - a) @ way).tolist())
        for part in parts
        if part.geom_type == "LineString" and not part.is_empty
    )
    covered, reach = 0.0, 0.0
    for low, high in ends:
        covered += max(high - max(low, reach), 0.0)
        reach = max(reach, high)
    return covered


def _gap(corners: Vector) -> Gap:
    """A gap from its corners: left and right of one jamb, left and right of the other."""
    one, other = corners[:2].mean(0), corners[2:].mean(0)
    way = other - one
    width = float(np.hypot(*way))
    thick = max(float(np.hypot(*(corners[k] - corners[k + 1]))) for k in (0, 2))
    return Gap(corners, (one + other) / 2, way / max(width, 1e-12), width, thick)


def _is_free(a: Vector, b: Vector, tree: STRtree, parts: list[LineString]) -> bool:
    """Whether no line crosses the way from a to b, a little in from its ends."""
    step = (b - a) / np.hypot(*(b - a)) * 0.02
    ray = LineString([a + step, b - step])
    return not len(tree.query(ray, predicate="intersects")) and bool(parts)


def _drawn_across(drawn: Drawn, tree: STRtree, parts: list[LineString]) -> list[Gap]:
    """Lines on layers of doors that reach from wall to wall."""
    gaps = []
    for a, b in drawn.doors:
        if NARROW <= np.hypot(*(b - a)) <= DRAWN:
            near = [tree.query(Point(p), predicate="dwithin", distance=TOUCH) for p in (a, b)]
            if len(near[0]) and len(near[1]) and not set(near[0]) & set(near[1]):
                feet = [
                    _onto(p, [parts[k] for k in found])
                    for p, found in zip((a, b), near, strict=True)
                ]
                gaps.append(_gap(np.array([feet[0], feet[0], feet[1], feet[1]])))
    return gaps


def _onto(point: Vector, lines: list[LineString]) -> Vector:
    """The point of the nearest of some lines, an end of it if that is near."""
    here = Point(point)
    nearest = min(lines, key=here.distance)
    ends = [Point(nearest.coords[k]) for k in (0, -1)]
    end = min(ends, key=here.distance)
    foot = end if end.distance(here) <= TOUCH else nearest.interpolate(nearest.project(here))
    return np.array(foot.coords[0])[:2]


def _to_wall(jamb: Jamb, tree: STRtree, doors: shapely.Geometry) -> Gap | None:
    """The gap from a jamb to the wall ahead, where a door is drawn between them."""
    most = ALONE if doors.is_empty else WIDE
    feet = [_hit(corner, jamb.out, most, tree) for corner in (jamb.left, jamb.right)]
    if feet[0] is None or feet[1] is None:
        return None
    gap = _gap(np.array([jamb.left, jamb.right, feet[1], feet[0]]))
    if gap.width < NARROW:
        return None
    place = LineString([jamb.middle, gap.corners[2:].mean(0)]).buffer(NEAR_DOOR)
    drawn = shapely.intersection(doors, place).length
    return gap if doors.is_empty or drawn >= 0.3 * gap.width else None


def _hit(start: Vector, way: Vector, most: float, tree: STRtree) -> Vector | None:
    """Where a ray first meets a line, from a little ahead of its start."""
    foot = _hits(start[None], way[None], most, tree, 0.02)[0]
    return None if np.isnan(foot).any() else foot


def _hits(starts: Vector, ways: Vector, most: float, tree: STRtree, away: float) -> Vector:
    """Where rays (n, 2) first meet lines, no nearer than ``away`` and no farther than ``most``
    along their unit vectors; not numbers where they meet none."""
    rays = shapely.linestrings(np.stack([starts + away * ways, starts + most * ways], 1))
    ray, part = tree.query(rays)
    ends = shapely.get_coordinates(tree.geometries[part]).reshape(-1, 2, 2)
    far = _crossing(starts[ray], ways[ray], ends)
    met = (far >= away) & (far <= most)
    owner, far = ray[met], far[met]
    order = np.lexsort((far, owner))
    owners, first = np.unique(owner[order], return_index=True)
    found: Vector = np.full(starts.shape, np.nan)
    found[owners] = starts[owners] + far[order[first], None] * ways[owners]
    return found


def _crossing(starts: Vector, ways: Vector, lines: Vector) -> Vector:
    """How far along rays (n, 2) each crosses its line (n, 2, 2), at the nearer end of one that lies
    along it; infinite where it does not."""
    along = lines[:, 1] - lines[:, 0]
    to = lines[:, 0] - starts
    turn = _cross(ways, along)
    length = np.hypot(*along.T)
    flat = np.abs(turn) <= 1e-9 * length
    safe = np.where(flat, 1.0, turn)
    share = _cross(to, ways) / safe
    slack = 1e-6 / np.maximum(length, 1e-9)
    crossed = ~flat & (share >= -slack) & (share <= 1 + slack)
    beside = flat & (np.abs(_cross(to, ways)) < 1e-6)
    nearer = ((lines - starts[:, None]) * ways[:, None]).sum(-1).min(1)
    return np.where(crossed, _cross(to, along) / safe, np.where(beside, nearer, np.inf))


def _cross(a: Vector, b: Vector) -> Vector:
    product: Vector = a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]
    return product


def bridge_lines(gaps: list[Gap]) -> list[LineString]:
    """Both faces of the wall across each gap."""
    found = []
    for gap in gaps:
        left, right, other_left, other_right = gap.corners
        found += [LineString([left, other_right]), LineString([right, other_left])]
    return [line for line in found if line.length > 1e-6]


def point_of(gap: Gap) -> Point:
    """The middle of a gap."""
    return Point(gap.middle)
