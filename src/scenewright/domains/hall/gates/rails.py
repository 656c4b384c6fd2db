"""Rails beside a row of gates: from its ends back to the wall on both sides of the door they belong
to, or on to the walls; at one end a wide gate for wheelchairs and prams, open, a post beyond it."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.core.same import once
from scenewright.domains.hall.measures import DOOR_OUTSIDE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.terms.visitors import FIRST

RAIL_BESIDE_DOOR, RAIL_TO_WALL, SHORTEST_RAIL, RAIL_THICK = 0.4, 1.6, 0.2, 0.06
"""How far beside a door rails begin, how near a wall lies to which they run on instead of turning
back, the shortest of them, and how thick they are; metres."""
POST = 0.2
"""How thick the post of the wide gate is, in metres."""
RAIL_BARE = 0.25
"""Cost of a row without rails, as metres of rails on floor that others need."""
RAIL_GAP = 0.01
"""Gap of rails to walls, gates and one another, in metres."""
LANE, RAIL_MARGIN, THROUGH = 0.9, 0.2, 3.0
"""How wide the wide gate behind a door is at least, by how much it is wider than the route, and how
long the floor on which one goes through it; metres. Wheelchairs need 0.9 m (DIN 18040-1)."""


class WayIn(NamedTuple):
    """Where people come into a zone: a point and the unit direction of their way (2,), half the
    width of the door there (0: a border), and the clear width that stays open: of a wide gate, or
    of the passage on a border."""

    start: Floats
    way: Floats
    half: float
    width: float


@once(64)
def find_way_in(problem: HallProblem, unit: int) -> WayIn:
    """The way into the zone of a unit: by the main entrance, else another door of it, else over the
    middle of the linked border nearest to the entrance; where a zone has several doors people come
    in by, each unit of gates there has one of its own."""
    zone, ground = int(problem.units.zones[unit]), problem.ground
    bounds, lane = ground.zone_bounds[zone], max(LANE, problem.route)
    ahead = np.column_stack([np.cos(ground.doors[:, 2]), np.sin(ground.doors[:, 2])])
    points = ground.doors[:, :2] + (0.5 * ground.doors[:, 4:] + 0.4) * ahead
    inside = (points >= bounds[:2] - DOOR_OUTSIDE) & (points <= bounds[2:] + DOOR_OUTSIDE)
    door = problem.visitors.entrances[0]
    if inside.all(1).any():
        far = np.hypot(*(points - door).T) + 1e3 * ~inside.all(1)
        comes = _find_entrances(problem, points)
        ranked = [int(k) for k in np.argsort(far, kind="stable") if int(k) in comes]
        own = [k for k in ranked if inside[k].all()] or [int(far.argmin())]
        near = own[_count_before(problem, unit) % len(own)]
        return WayIn(points[near], ahead[near], 0.5 * float(ground.doors[near, 3]), lane)
    rows = [row for row in ground.borders if zone in ground.links[int(row[4]), :2].astype(int)]
    if not rows:
        return WayIn(door, problem.visitors.inward[0], 0.0, lane)
    row = min(rows, key=lambda row: float(np.hypot(*(0.5 * (row[:2] + row[2:4]) - door))))
    middle, along = 0.5 * (row[:2] + row[2:4]), row[2:4] - row[:2]
    across = np.array([-along[1], along[0]]) / max(float(np.hypot(*along)), 1e-9)
    inward = 1.0 if (0.5 * (bounds[:2] + bounds[2:]) - middle) @ across >= 0.0 else -1.0
    return WayIn(middle, across * inward, 0.0, float(ground.links[int(row[4]), 2]))


def _find_entrances(problem: HallProblem, points: Floats) -> set[int]:
    """Which of some points inside doors (d, 2) are those of doors people come in by."""
    off = np.hypot(*(points[:, None] - problem.visitors.entrances).transpose(2, 0, 1))
    return set(off.argmin(0).tolist())


def _count_before(problem: HallProblem, unit: int) -> int:
    """How many units of gates in the zone of a unit come before it."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    return sum(
        bool(roles[k] & FIRST and units.access[units.spans[k, 0], ::2].all())
        for k in range(unit)
        if units.zones[k] == units.zones[unit]
    )


class RowOfGates(NamedTuple):
    """A row of gates (5,), the way in it stands across, and the boxes (n, 5) of all else and of
    what that needs free."""

    box: Floats
    way_in: WayIn
    others: Floats
    needed: Floats


def find_stops(problem: HallProblem, row: RowOfGates) -> Floats:
    """The directed edges (e, 4) of walls and of objects beside a row, at which rails end."""
    return np.concatenate([problem.ground.edges, sides_of(_solid(problem, row))])


def lay_rails(edges: Floats, row: RowOfGates, side: int) -> Floats:
    """Boxes (k, 5) of the rails of a row of gates with the wide gate on one ``side`` (-1 or 1) of
    it: to the ``edges`` (e, 4) of walls, or of objects at them; last the post beyond that gate,
    like the housing of one."""
    way_in, way, centre = row.way_in, row.way_in.way, row.box[:2]
    right = np.array([way[1], -way[0]])
    aside, half = float((centre - way_in.start) @ right), 0.5 * float(row.box[3])
    found, post = list[tuple[Floats, Floats]](), list[list[float]]()
    for end in (-1, 1):
        begin = half + RAIL_GAP + (way_in.width + RAIL_MARGIN if end == side else 0.0)
        wall = reach(edges, centre + end * (half + RAIL_GAP) * right, end * right) + half + RAIL_GAP
        beyond = max(begin, way_in.half + RAIL_BESIDE_DOOR - end * aside)
        turns = way_in.half > 0.0 and wall - beyond > RAIL_TO_WALL
        stop = beyond if turns else wall
        if end == side and way_in.half > 0.0 and stop >= begin:
            bears = turns or stop - begin > POST + SHORTEST_RAIL
            inner = begin if bears else stop - POST - RAIL_GAP
            off = end * (inner + 0.5 * POST)
            post.append([*(centre + off * right), _turn_across(way), float(row.box[4]), POST])
            begin, stop = (begin + POST + RAIL_GAP, stop) if bears else (begin, inner - RAIL_GAP)
        if stop - begin > SHORTEST_RAIL:
            found.append((centre + end * begin * right, centre + end * stop * right))
        if turns:
            corner = (
                centre + end * (max(beyond, begin - RAIL_GAP) + 0.5 * RAIL_THICK + RAIL_GAP) * right
            )
            back = reach(edges, corner, -way)
            found += [(corner, corner - back * way)] * (back > SHORTEST_RAIL)
    return np.array([*(_rail(*line) for line in found), *post]).reshape(-1, 5)


def find_open_end(row: RowOfGates, side: int) -> Floats:
    """The box (5,) of the floor in the wide gate of a row, and before and behind it."""
    way, wide = row.way_in.way, row.way_in.width
    off = 0.5 * float(row.box[3]) + RAIL_GAP + 0.5 * (wide + RAIL_MARGIN)
    x, y = row.box[:2] + side * off * np.array([way[1], -way[0]])
    return np.array([x, y, np.arctan2(way[1], way[0]), wide, max(2.0 * wide, THROUGH)])


def _solid(problem: HallProblem, row: RowOfGates) -> Floats:
    """Boxes (n, 5) of the objects beside a row."""
    return np.concatenate([row.others, problem.ground.obstacles])


def sides_of(boxes: Floats) -> Floats:
    """The directed edges (4 n, 4) of boxes (n, 5)."""
    rings = corners(boxes)
    return np.concatenate([rings, np.roll(rings, -1, axis=1)], axis=2).reshape(-1, 4)


def reach(edges: Floats, point: Floats, way: Floats) -> float:
    """Metres from a point along a unit direction to the first of the directed edges (e, 4)."""
    start, end = edges[:, :2] - point, edges[:, 2:] - point
    one, two = (way[0] * v[:, 1] - way[1] * v[:, 0] for v in (start, end))
    crossed = (one * two <= 0.0) & (np.abs(one - two) > 1e-12)
    share = one[crossed] / (one - two)[crossed]
    far = (start[crossed] + share[:, None] * (end - start)[crossed]) @ way
    return float(far[far > 1e-6].min(initial=100.0))


def measure_rails(problem: HallProblem, row: RowOfGates, side: int) -> tuple[float, float]:
    """What bars the rails of a row with its wide gate on one ``side`` (:func:`measure_barred`), and
    metres of them on floor that others need free; a wide gate without a post counts as some."""
    rails = lay_rails(find_stops(problem, row), row, side)
    bare = RAIL_BARE * (row.way_in.half > 0.0 and not has_post(rails))
    return measure_barred(problem, row, side, rails), _measure_crowded(row, rails) + bare


def has_post(rails: Floats) -> bool:
    """Whether the wide gate has a post among some rails (k, 5): where the wall is too near for one,
    what is left open looks like a gap."""
    return bool((rails[:, 4] >= POST).any())


def measure_barred(problem: HallProblem, row: RowOfGates, side: int, rails: Floats) -> float:
    """Metres of the ``rails`` (k, 5) of a row that cannot stand, and square metres of others on the
    floor they close and in its wide gate on one ``side``."""
    if not len(rails):
        return 0.0
    solid = shapely.polygons(corners(_solid(problem, row)))
    strips = shapely.union_all(shapely.polygons(corners(rails)))
    gates, end = shapely.polygons(corners(np.stack([row.box, find_open_end(row, side)])))
    closed = shapely.union(shapely.convex_hull(shapely.union(strips, gates)), end)
    inside = shapely.area(shapely.intersection(solid, closed)).sum()
    return float(inside) + measure_blocked(problem, row, rails)


def measure_blocked(problem: HallProblem, row: RowOfGates, rails: Floats) -> float:
    """Metres of some rails (k, 5) that cannot stand where others do, or before doors."""
    taken = np.concatenate([_solid(problem, row), problem.ground.keep_free])
    strips = shapely.union_all(shapely.polygons(corners(rails)))
    return float(strips.intersection(_join_near(taken, strips)).area / RAIL_THICK)


def _measure_crowded(row: RowOfGates, rails: Floats) -> float:
    """Metres of the rails (k, 5) of a row on floor that others need free."""
    strips = shapely.polygons(corners(rails))
    needed = _join_near(row.needed, shapely.multipolygons(strips))
    return float(shapely.area(shapely.intersection(strips, needed)).sum() / RAIL_THICK)


def _join_near(boxes: Floats, strips: shapely.Geometry) -> shapely.Geometry:
    """The floor of those boxes (n, 5) that come near some strips: to join all takes long."""
    shapes = shapely.polygons(corners(boxes))
    return shapely.union_all(shapes[shapely.intersects(shapely.envelope(shapes), strips)])


def _rail(start: Floats, end: Floats) -> list[float]:
    """The box (5,) of a rail between two points."""
    along = end - start
    x, y = 0.5 * (start + end)
    return [x, y, _turn_across(along), float(np.hypot(*along)) - 2 * RAIL_GAP, RAIL_THICK]


def _turn_across(along: Floats) -> float:
    """The heading of what is as wide as some way is long."""
    return float(np.arctan2(-along[0], along[1]))
