"""Squares, parking, forecourts, sight lines and courts: is there what the brief asks for?

Judged on the areas and drives the solution says are laid out, on footprints and on the brief alone.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Flags, Floats, Shape, Shapes
from scenewright.core.report import Finding
from scenewright.domains.site.check.bodies import JudgedSite, SiteBodies
from scenewright.ground.works import GroundWorks, PavedArea

BAY = 12.0
"""Least ground of a bay in square metres, the drive not counted."""
NEAR, SHARE, COMPACT = 0.1, 0.97, 0.35
"""Metres between areas that adjoin; share of what is asked that counts as all; least radius of the
largest circle in a square, in shares of the root of its area."""
QUAD_GAP = 12.0
"""Metres of the widest opening of a quad where no other is stated."""
COURT, PACE, ASIDE, AHEAD = 25.0, 2.0, 0.2, 200.0
"""Least court in square metres; metres between the points of a street that look at a landmark, the
cosine of how far aside they may stand, and how far ahead of it its street is."""


def find_missing_areas(
    grounds: JudgedSite, bodies: SiteBodies, works: GroundWorks
) -> list[Finding]:
    """What of the squares, parking, forecourts, views and closed courts asked for is not there,
    and areas that are built over or leave the site."""
    shapes = np.array([shapely.Polygon(row.outline) for row in works.areas], object)
    sound = ~_is_built_over(bodies, shapes) & shapely.covers(
        shapely.buffer(grounds.floor, NEAR), shapes
    )
    laid = [
        (row, shape) for row, shape, good in zip(works.areas, shapes, sound, strict=True) if good
    ]
    return [
        *_find_spoilt(grounds, bodies, works.areas, shapes, sound),
        *_find_lack_of_parking(grounds, works, laid),
        *_find_lack_of_squares(grounds, works, laid),
        *_find_blocked_forecourts(grounds, bodies, laid),
        *_find_blocked_views(grounds, bodies),
        *_find_open_courts(grounds, bodies),
        *_find_open_quads(grounds, bodies),
    ]


def measure_areas(works: GroundWorks, bodies: SiteBodies, grounds: JudgedSite) -> dict[str, float]:
    """Bays, square metres of squares and of parks, the share of courts asked for that close."""
    squares = [shapely.Polygon(row.outline).area for row in works.areas if row.kind == "square"]
    parks = [shapely.Polygon(row.outline).area for row in works.areas if row.kind == "park"]
    blocks = _court_blocks(grounds, bodies)
    closed = [len(_holes(grounds, bodies, rows)) > 0 for rows in blocks]
    return {
        "bays": sum(row.bays for row in works.areas if row.kind == "parking"),
        "squares": round(float(sum(squares)), 1),
        "parks": round(float(sum(parks)), 1),
        "courts_closed": round(float(np.mean(closed)), 4) if closed else 1.0,
    }


def _find_spoilt(
    grounds: JudgedSite, bodies: SiteBodies, rows: Sequence[PavedArea], shapes: Shapes, sound: Flags
) -> list[Finding]:
    """Areas that buildings stand on, or that leave the site."""
    found = []
    for number in np.flatnonzero(~sound).tolist():
        named = f"the {rows[number].kind} {rows[number].about}".strip()
        over = [
            bodies.ids[k]
            for k in np.flatnonzero(~bodies.landmark)
            if _reach_into(bodies.footprints[k], shapes[number]) > TOLERANCE
        ]
        message = f"{', '.join(over[:3])} stands on {named}" if over else f"{named} leaves the site"
        found.append(_site_finding("blocked_area", grounds, message, over[0] if over else ""))
    return found


def _find_lack_of_parking(
    grounds: JudgedSite, works: GroundWorks, laid: list[tuple[PavedArea, Shape]]
) -> list[Finding]:
    """Fewer bays than asked for, in lots that a drive joins to a road."""
    asked = _bays_asked(grounds)
    streets = _driven_ground(grounds)
    lines = [row for row in works.pathways if row.kind == "drive"]
    drives = [
        shapely.LineString(row.line).buffer(0.5 * row.width, cap_style="flat") for row in lines
    ]
    joined = [drive for drive in drives if shapely.dwithin(drive, streets, NEAR)]
    count, unjoined = 0, 0
    for row, shape in laid:
        if row.kind != "parking":
            continue
        reached = any(_reach_into(drive, shape) > 1.0 for drive in joined)
        room = shape.area - sum(shapely.intersection(drive, shape).area for drive in joined)
        count += min(row.bays, int((room + NEAR) / BAY)) if reached else 0
        unjoined += 0 if reached else row.bays
    if count >= asked:
        return []
    message = f"{count} of {asked} parking bays are laid out"
    message += f", {unjoined} more without a drive from a road" if unjoined else ""
    return [_site_finding("lack_of_parking", grounds, message, amount=asked - count)]


def _driven_ground(grounds: JudgedSite) -> Shape:
    """Access for cars: roads, else paths as wide as a lane, else over the border."""
    there = grounds.streets
    rows = there.road if there.road.any() else there.driven
    roads = [*there.surfaces[rows], *there.crossings[rows]]
    return shapely.union_all(roads or [grounds.border])


def _bays_asked(grounds: JudgedSite) -> int:
    asked = grounds.site.parking
    if asked is None:
        return 0
    buildings = sum(row.count for row in grounds.site.buildings)
    return asked.bays or math.ceil((asked.per_building or 0.0) * buildings - 1e-9)


def _find_lack_of_squares(
    grounds: JudgedSite, works: GroundWorks, laid: list[tuple[PavedArea, Shape]]
) -> list[Finding]:
    """Squares asked for, the largest first, for which none so large adjoins a way."""
    walks = [
        shapely.LineString(row.line).buffer(0.5 * row.width, cap_style="square")
        for row in works.pathways
    ]
    there = grounds.streets
    streets = [*there.surfaces, *there.crossings]
    around = shapely.union_all([*streets, *walks] if streets else [grounds.border])
    left = [
        shape
        for row, shape in laid
        if row.kind == "square"
        and shapely.dwithin(shape, around, NEAR)
        and _radius(shape) >= COMPACT * math.sqrt(shape.area)
    ]
    left.sort(key=lambda shape: -shape.area)
    found = []
    for asked in sorted(grounds.site.squares, key=lambda row: -row.area):
        if left and left[0].area >= SHARE * asked.area:
            left.pop(0)
            continue
        message = f"no square {asked.name} of {asked.area:g} m² beside a way is laid out"
        found.append(_site_finding("lack_of_square", grounds, message.replace("  ", " ")))
    return found


def _find_blocked_forecourts(
    grounds: JudgedSite, bodies: SiteBodies, laid: list[tuple[PavedArea, Shape]]
) -> list[Finding]:
    """Landmarks whose forecourt is built on, or not laid out."""
    streets = shapely.union_all([*grounds.ways])
    own = bodies.footprints[~bodies.landmark]
    found = []
    for row, there in zip(grounds.site.landmarks, grounds.plan.landmarks, strict=True):
        if not row.forecourt:
            continue
        front, ahead, aside = _front(there.box)
        half = 0.5 * there.box[3] * aside
        far = front + row.forecourt * ahead
        box = shapely.Polygon([front + half, front - half, far - half, far + half])
        asked = shapely.difference(shapely.intersection(box, grounds.floor), streets)
        mine = [s for area, s in laid if area.kind == "forecourt" and area.about == there.id]
        laid_out = shapely.intersection(shapely.union_all(mine), asked).area if mine else 0.0
        built = bool(len(own)) and max(_reach_into(shape, asked) for shape in own) > TOLERANCE
        if built or laid_out < 0.9 * asked.area:
            message = f"the forecourt of {there.id}, {row.forecourt:g} m deep, is "
            message += "built on" if built else "not laid out"
            found.append(_site_finding("blocked_forecourt", grounds, message, there.id))
    return found


def _find_blocked_views(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Landmarks whose front is hidden from some of the street it is to be seen from."""
    own = np.flatnonzero(~bodies.landmark)
    found = []
    for row, there in zip(grounds.site.landmarks, grounds.plan.landmarks, strict=True):
        points = _viewpoints(grounds, there.box, row.view) if row.view else np.zeros((0, 2))
        if not len(points) or not len(own):
            continue
        front = _front(there.box)[0]
        lines = shapely.linestrings(np.stack([points, np.broadcast_to(front, points.shape)], 1))
        tree = shapely.STRtree(shapely.buffer(bodies.footprints[own], -0.05))
        hidden, by = tree.query(lines, predicate="intersects")
        if len(hidden):
            share = len(np.unique(hidden)) / len(points)
            name = bodies.ids[own[np.bincount(by).argmax()]]
            message = f"{name} hides {there.id} from {share:.0%} of the street before it"
            found.append(_site_finding("blocked_view", grounds, message, name, share))
    return found


def _viewpoints(grounds: JudgedSite, box: Sequence[float], reach: float) -> Floats:
    """Points of the street before a front, up to ``reach`` metres along it to either side."""
    front, ahead, _ = _front(box)
    ray = shapely.LineString([front, front + AHEAD * ahead])
    nearest, points = math.inf, np.zeros((0, 2))
    wide = shapely.buffer(grounds.floor, grounds.site.verge)
    for road in grounds.site.roads:
        whole = shapely.LineString(road.line)
        inside = _line_parts(shapely.intersection(whole, grounds.floor))
        for line in inside or _line_parts(shapely.intersection(whole, wide)):
            met = shapely.intersection(line, ray)
            other = met if not met.is_empty else shapely.Point(front)
            at = np.array(shapely.shortest_line(line, other).coords[0])
            far = float(np.hypot(*(at - front)))
            if far <= 0.0 or (at - front) @ ahead <= ASIDE * far or far >= nearest:
                continue
            along = line.project(shapely.Point(at))
            stops = np.arange(max(along - reach, 0.0), min(along + reach, line.length), PACE)
            nearest, points = far, shapely.get_coordinates(line.interpolate(stops))
    away = points - front
    kept: Floats = points[away @ ahead > (ASIDE + 0.01) * np.hypot(*away.T)]
    return kept


def _line_parts(shape: Shape) -> list[Shape]:
    parts = shapely.get_parts(shapely.line_merge(shape) if not shape.is_empty else shape)
    return [part for part in parts if part.geom_type == "LineString" and part.length > 0.0]


def _find_open_courts(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Blocks with buildings round no court, openings as wide as allowed taken for closed."""
    gap, found = grounds.site.court_gap, []
    for rows in _court_blocks(grounds, bodies):
        if not _holes(grounds, bodies, rows):
            names = ", ".join(bodies.ids[row] for row in rows[:3])
            message = f"the court of {names} … is open: no opening may be wider than {gap:g} m"
            found.append(_site_finding("open_court", grounds, message, bodies.ids[rows[0]]))
    return found


def _find_open_quads(grounds: JudgedSite, bodies: SiteBodies) -> list[Finding]:
    """Landmarks round which a quad is asked for that no buildings close."""
    gap, found = grounds.site.court_gap or QUAD_GAP, []
    own = bodies.footprints[~bodies.landmark]
    grown = shapely.get_parts(shapely.union_all(shapely.buffer(own, 0.5 * gap + TOLERANCE)))
    holes = [shapely.Polygon(ring) for part in grown for ring in part.interiors]
    for row, there in zip(grounds.site.landmarks, grounds.plan.landmarks, strict=True):
        middle = shapely.Point(there.box[:2])
        if row.quad and not any(hole.intersects(middle) for hole in holes):
            message = f"the quad round {there.id} is open: no opening may be wider than {gap:g} m"
            found.append(_site_finding("open_court", grounds, message, there.id))
    return found


def _court_blocks(grounds: JudgedSite, bodies: SiteBodies) -> list[list[int]]:
    """The buildings of each block with any that is to have a closed court."""
    site = grounds.site
    if site.court_gap is None:
        return []
    blocks = [shapely.Polygon(block.outline, block.holes) for block in grounds.plan.free]
    forms: list[str | None] = [site.form] * len(blocks)
    for row in site.blocks if blocks else ():
        far = [block.distance(shapely.Point(row.at)) for block in blocks]
        forms[int(np.argmin(far))] = row.form
    own = np.flatnonzero(~bodies.landmark)
    middles = shapely.centroid(bodies.footprints[own])
    inside = [
        own[shapely.intersects(block, middles)].tolist()
        for k, block in enumerate(blocks)
        if forms[k] == "peripheral"
    ]
    return [rows for rows in inside if rows]


def _holes(grounds: JudgedSite, bodies: SiteBodies, rows: list[int]) -> list[Shape]:
    """The courts that some buildings enclose."""
    half = 0.5 * (grounds.site.court_gap or 0.0) + TOLERANCE
    grown = shapely.union_all(shapely.buffer(bodies.footprints[rows], half))
    holes = [shapely.Polygon(ring) for part in shapely.get_parts(grown) for ring in part.interiors]
    return [hole for hole in holes if hole.area >= COURT]


def _front(box: Sequence[float]) -> tuple[Floats, Floats, Floats]:
    """Middle of a front, the direction ahead and that to its left."""
    ahead = np.array([math.cos(box[2]), math.sin(box[2])])
    return np.array(box[:2]) + 0.5 * box[4] * ahead, ahead, np.array([-ahead[1], ahead[0]])


def _is_built_over(bodies: SiteBodies, shapes: Shapes) -> Flags:
    """Which areas a building, not a landmark, stands on; courts lie between buildings."""
    own = bodies.footprints[~bodies.landmark]
    return np.array(
        [any(_reach_into(body, shape) > TOLERANCE for body in own) for shape in shapes], bool
    )


def _reach_into(one: Shape, other: Shape) -> float:
    """How far two shapes reach into each other: area over the longest side of what they share."""
    both = shapely.intersection(one, other)
    if both.area <= 0.0:
        return 0.0
    x0, y0, x1, y1 = both.bounds
    return float(both.area / max(math.hypot(x1 - x0, y1 - y0), 1e-9))


def _radius(shape: Shape) -> float:
    return float(shapely.maximum_inscribed_circle(shape, tolerance=0.1).length)


def _site_finding(
    kind: str, grounds: JudgedSite, message: str, piece: str = "", amount: float = 0.0
) -> Finding:
    return Finding(kind, "", grounds.plan.id, piece, "", message, amount)
