"""Rules of a site: no overlaps, nothing outside, distances kept, roads and paths free.

Everything is exact on footprints: boxes turned about the vertical, polygons where a building states
one, landmarks as they were drawn.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Floats, Indices, Shape, Shapes
from scenewright.check.shared_ground import intersect_footprints
from scenewright.core.report import Finding
from scenewright.domains.site.check.bodies import JudgedSite, SiteBodies

SUPPORT_GAP = 0.02


def find_overlaps(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Pairs that share more than 1 cm in plan and in height; landmarks among themselves do not
    count. The depth is the short side of the least rectangle about what they share."""
    i, j = pairs(bodies, 0.0)
    tall = np.minimum(bodies.high[i], bodies.high[j]) - np.maximum(bodies.low[i], bodies.low[j])
    shared = intersect_footprints(bodies.footprints[i], bodies.footprints[j])
    depth, area = thickness(shared), shapely.area(shared)
    found = []
    for row in np.flatnonzero((depth > TOLERANCE) & (tall > TOLERANCE)):
        a, b, deep = int(i[row]), int(j[row]), float(min(depth[row], tall[row]))
        message = (
            f"{bodies.ids[a]} and {bodies.ids[b]} overlap by {deep:.2f} m ({area[row]:.2f} m²)"
        )
        found.append(_pair("collision", grounds, bodies, a, b, message, deep, float(area[row])))
    return found


def find_outside(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Buildings that leave the site by more than 1 cm, float, are sunk, or are higher
    than the limit."""
    found = []
    own = np.flatnonzero(~bodies.landmark)
    wider = shapely.buffer(grounds.floor, TOLERANCE, join_style="mitre")
    shapely.prepare(wider)
    for row in own[~shapely.covers(wider, bodies.footprints[own])]:
        rest = shapely.difference(bodies.footprints[row], grounds.floor)
        points = shapely.points(shapely.get_coordinates(shapely.segmentize(rest, 0.1)))
        depth = float(shapely.distance(points, grounds.floor).max(initial=0.0))
        message = (
            f"{bodies.ids[row]} is {depth:.2f} m ({rest.area:.2f} m²) outside {grounds.plan.id}"
        )
        found.append(_one("out_of_bounds", grounds, bodies, row, message, depth, float(rest.area)))
    for row in own[np.abs(bodies.low[own]) > SUPPORT_GAP]:
        kind = "floating" if bodies.low[row] > 0 else "sunk"
        message = f"{bodies.ids[row]} stands {bodies.low[row]:+.2f} m off the ground"
        found.append(_one(kind, grounds, bodies, row, message, abs(float(bodies.low[row]))))
    limit = grounds.site.height_limit or np.inf
    for row in own[bodies.high[own] > limit + TOLERANCE]:
        message = f"{bodies.ids[row]} is {bodies.high[row]:.2f} m high, the limit is {limit:g} m"
        found.append(
            _one("too_high", grounds, bodies, row, message, float(bodies.high[row]) - limit)
        )
    return found


def find_near_edges(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Buildings nearer to the outline than the setback, and on or too near roads and paths."""
    found = []
    own = np.flatnonzero(~bodies.landmark)
    setback = grounds.site.setback
    shapely.prepare([grounds.border, grounds.floor])
    least = max(setback - TOLERANCE, 0.0)
    near = own[shapely.dwithin(grounds.border, bodies.footprints[own], least) & (least > 0.0)]
    for row in near[shapely.covers(grounds.floor, bodies.footprints[near])]:
        gap = float(shapely.distance(bodies.footprints[row], grounds.border))
        message = f"{bodies.ids[row]} stands {gap:.2f} m from the border of the site, "
        message += f"{setback:g} m are required"
        found.append(_one("setback", grounds, bodies, row, message, setback - gap))
    return found + _near_ways(grounds, bodies, own)


def _near_ways(grounds: JudgedSite, bodies: SiteBodies, own: Indices) -> list[Finding]:
    if not len(grounds.ways) or not len(own):
        return []
    asked = grounds.site.road_setback
    tree = shapely.STRtree(bodies.footprints[own])
    k, i = tree.query(grounds.ways, predicate="dwithin", distance=asked + TOLERANCE)
    shared = shapely.intersection(bodies.footprints[own[i]], grounds.ways[k])
    depth, area = thickness(shared), shapely.area(shared)
    gap = shapely.distance(bodies.footprints[own[i]], grounds.ways[k])
    worst: dict[tuple[int, str], Finding] = {}
    for row in np.flatnonzero((depth > TOLERANCE) | (gap < asked - TOLERANCE)):
        number, way = int(own[i[row]]), grounds.way_ids[k[row]]
        name, on = bodies.ids[number], depth[row] > TOLERANCE
        missing = float(depth[row] if on else asked - gap[row])
        message = f"{name} stands on {way} by {missing:.2f} m ({area[row]:.2f} m²)"
        if not on:
            message = f"{name} stands {gap[row]:.2f} m from {way}, {asked:g} m are required"
        kind = "blocked_path" if on else "setback"
        seen = worst.get((number, way))
        if seen is None or (kind == "blocked_path", missing) > (seen.kind == kind, seen.amount):
            worst[number, way] = _one(
                kind, grounds, bodies, number, message, missing, float(area[row]), way
            )
    return list(worst.values())


def find_too_close(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Pairs nearer than the spacing that do not collide, with distance and partner."""
    asked = grounds.site.spacing
    i, j = pairs(bodies, asked)
    gap = np.asarray(shapely.distance(bodies.footprints[i], bodies.footprints[j]))
    close = gap < asked - TOLERANCE
    close[close] &= (
        thickness(intersect_footprints(bodies.footprints[i[close]], bodies.footprints[j[close]]))
        <= TOLERANCE
    )
    found = []
    for row in np.flatnonzero(close):
        a, b, apart = int(i[row]), int(j[row]), float(gap[row])
        message = f"{bodies.ids[a]} and {bodies.ids[b]} are {apart:.2f} m apart, {asked:g} m are "
        found.append(_pair("spacing", grounds, bodies, a, b, message + "required", asked - apart))
    return found + _sunless(grounds, bodies)


def _sunless(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Buildings nearer behind another, on the side away from the noon sun, than the required
    multiple of its height: the footprint moved that far towards the pole passes over them."""
    times = grounds.site.sun_spacing
    if times <= 0.0 or len(bodies.ids) < 2:
        return []
    pole = 1.0 if grounds.site.latitude >= 0.0 else -1.0
    wanted = times * bodies.high
    moved = np.stack([np.zeros(len(wanted)), pole * wanted], -1)
    reach = shapely.convex_hull(
        shapely.multipoints(np.concatenate([bodies.corners, bodies.corners + moved[:, None]], 1))
    )
    for row in (k for k, piece in enumerate(bodies.pieces) if piece.footprint):
        reach[row] = _swept(bodies.footprints[row], moved[row])
    i, j = shapely.STRtree(bodies.footprints).query(reach, predicate="intersects")
    i, j = i[i != j], j[i != j]
    behind = pole * (bodies.corners[j].mean(1) - bodies.corners[i].mean(1))[:, 1] > 0
    over = thickness(shapely.intersection(reach[i], bodies.footprints[j])) > TOLERANCE
    apart = shapely.distance(bodies.footprints[i], bodies.footprints[j])
    rows = np.flatnonzero(behind & over & (apart < wanted[i] - TOLERANCE) & ~bodies.landmark[j])
    return [
        _pair(
            "spacing",
            grounds,
            bodies,
            int(j[row]),
            int(i[row]),
            f"{bodies.ids[j[row]]} stands {apart[row]:.2f} m behind {bodies.ids[i[row]]}, "
            f"{wanted[i[row]]:.2f} m are required for the sun",
            float(wanted[i[row]] - apart[row]),
        )
        for row in rows
    ]


def _swept(shape: Shape, step: Floats) -> Shape:
    """The ground a polygon sweeps on a straight way."""
    ring = shapely.get_coordinates(shape.exterior)
    ends = np.stack([ring[:-1], ring[1:]], 1)
    hulls = shapely.convex_hull(shapely.multipoints(np.concatenate([ends, ends + step], 1)))
    return shapely.union_all([shape, *hulls])


def pairs(bodies: SiteBodies, within: float) -> tuple[Indices, Indices]:
    """Index pairs (i < j) of bodies at most ``within`` metres apart, but for two landmarks."""
    if len(bodies.ids) < 2:
        return np.empty(0, np.int64), np.empty(0, np.int64)
    tree = shapely.STRtree(bodies.footprints)
    i, j = tree.query(bodies.footprints, predicate="dwithin", distance=within)
    keep = (i < j) & ~(bodies.landmark[i] & bodies.landmark[j])
    order = np.lexsort((j[keep], i[keep]))
    return i[keep][order], j[keep][order]


def thickness(shapes: Shapes) -> Floats:
    """The short side of the least rectangle about each shape; 0 where it holds no area."""
    found = np.zeros(len(shapes))
    solid = np.flatnonzero(shapely.area(shapes) > TOLERANCE**2)
    if len(solid):
        frames = shapely.minimum_rotated_rectangle(shapes[solid])
        corners = shapely.get_coordinates(frames).reshape(-1, 5, 2)
        sides = np.hypot(*np.moveaxis(np.diff(corners[:, :3], axis=1), -1, 0))
        found[solid] = sides.min(1)
    return found


def _one(
    kind: str,
    grounds: JudgedSite,
    bodies: SiteBodies,
    row: int,
    message: str,
    amount: float,
    area: float = 0.0,
    other: str = "",
) -> Finding:
    return Finding(
        kind,
        "",
        grounds.plan.id,
        bodies.ids[row],
        other,
        message,
        round(amount, 4),
        round(area, 4),
        bool(bodies.given[row]),
    )


def _pair(
    kind: str,
    grounds: JudgedSite,
    bodies: SiteBodies,
    a: int,
    b: int,
    message: str,
    amount: float,
    area: float = 0.0,
) -> Finding:
    given = bool(bodies.given[a] and bodies.given[b])
    return Finding(
        kind,
        "",
        grounds.plan.id,
        bodies.ids[a],
        bodies.ids[b],
        message,
        round(amount, 4),
        round(area, 4),
        given,
    )
