"""Ground set apart before buildings are placed: squares, car parks, forecourts and sight lines.

Forecourts lie where their landmarks say. Squares are rectangles beside a street or path, as near
as may be to where they are wished for. Car parks are lots beside roads, a drive with bays on both
sides; they are chosen one by one so that the ground that can be built on is on average as near to
one as can be (greedy k-median). Among places about as good, those that cut up the ground least
are taken. No solver builds on any of it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.errors import InputError
from scenewright.domains.site.brief import Landmark, Site
from scenewright.domains.site.forecourts import find_sight, lay_forecourt, lay_quad
from scenewright.domains.site.problem import Floats
from scenewright.ground.plan import Standing, Way
from scenewright.ground.streetside.bays import BAY_DEPTH, BAY_WIDTH, DRIVE
from scenewright.ground.streetside.border import list_fronts
from scenewright.ground.streetside.lots import STRAIGHT, keep_open_lots, list_frontages, list_lots
from scenewright.ground.ways.path_raster import is_drivable
from scenewright.ground.works import Pathway, PavedArea

ASPECTS = (1.0, 1.4, 0.72)
"""Width along the street of squares against their depth, tried in turn."""
MOST_ROWS, LEAST_ROWS = 12, 2
"""Bays of a lot on each side of its drive."""
STEP, CLEAR = 3.0, 2.0
"""Metres between the places tried, and that areas keep from landmarks and each other."""
LOOKED_AT, NARROW, CUT = 16, 5.0, 0.4
"""Places whose ground is looked at; half the width in metres of ground too narrow to build on; and
what cutting up as much ground as an area takes costs, in shares of the way across the site."""
POINTS = 400


class Reserved(NamedTuple):
    """Ground set apart: areas, the drives of car parks, and the ground no building may stand on,
    areas and sight lines."""

    areas: tuple[PavedArea, ...] = ()
    drives: tuple[Pathway, ...] = ()
    kept: tuple[shapely.Geometry, ...] = ()


class OpenGround(NamedTuple):
    """Where areas may lie: the ground ``free`` of streets and buildings, its ``blocks`` that can be
    built on, the frontages (k, 2, 2) of all ways and of those that can be driven on, and the
    ground of the latter (empty: cars come over the border)."""

    free: shapely.Geometry
    blocks: shapely.Geometry
    beside_ways: Floats
    beside_roads: Floats
    span: float
    driven: shapely.Geometry


def reserve_areas(
    site: Site,
    floor: shapely.Polygon,
    ways: Sequence[Way],
    standing: Sequence[Standing],
    blocks: Sequence[shapely.Polygon],
    place: str,
) -> Reserved:
    """The ground a site sets apart; what finds no room is not in it. ``standing`` are its
    landmarks, in the order of the brief, and buildings that stay; ``blocks`` can be built on."""
    asked = [row for row in site.landmarks if row.forecourt or row.view or row.quad]
    if not (asked or site.squares or site.parking):
        return Reserved()
    found = _lay_forecourts(site.landmarks, standing, floor, ways)
    open_ = _open_ground(site, floor, ways, standing, blocks)
    for row in sorted(site.squares, key=lambda row: -row.area):
        found = _add_square(found, open_, row.area, row.at or _middle(floor), row.name)
    return _add_parking(found, open_, count_bays(site, place))


def list_missing_areas(site: Site, areas: Sequence[PavedArea]) -> list[str]:
    """What of the squares and bays a site asks for is not among some areas, in words."""
    found = []
    left = sorted(float(shapely.Polygon(a.outline).area) for a in areas if a.kind == "square")
    for row in sorted(site.squares, key=lambda row: -row.area):
        if left and left[-1] >= 0.99 * row.area:
            left.pop()
        else:
            found.append(f"{row.name or 'square'} of {row.area:g} m²")
    asked = count_bays(site)
    laid = sum(area.bays for area in areas if area.kind == "parking")
    if laid < asked:
        found.append(f"{asked - laid} of {asked} parking bays")
    return found


def count_bays(site: Site, place: str = "") -> int:
    """The bays a site asks for; InputError if it says so twice or not at all."""
    asked = site.parking
    if asked is None:
        return 0
    if (asked.bays is None) == (asked.per_building is None):
        raise InputError(
            "parking needs one of bays and per_building", "state one of them", place=place
        )
    if asked.bays is not None:
        return asked.bays
    count = sum(row.count for row in site.buildings)
    return math.ceil((asked.per_building or 0.0) * count - 1e-9)


def _lay_forecourts(
    rows: Sequence[Landmark],
    standing: Sequence[Standing],
    floor: shapely.Polygon,
    ways: Sequence[Way],
) -> Reserved:
    """Forecourts, quads and sight lines of the landmarks that ask for them."""
    found = Reserved()
    for row, there in zip(rows, standing, strict=False):
        if row.forecourt:
            court = lay_forecourt(there, row.forecourt, floor, ways)
            area = PavedArea("forecourt", _ring(court), 0, there.id)
            kept = (*found.kept, shapely.Polygon(court))
            found = found._replace(areas=(*found.areas, area), kept=kept)
        if row.quad:
            quad = lay_quad(there, row.quad, floor, ways)
            area = PavedArea(
                "court", _ring(shapely.get_coordinates(quad.exterior)[:-1]), 0, there.id
            )
            found = found._replace(areas=(*found.areas, area), kept=(*found.kept, quad))
        if row.view:
            found = found._replace(kept=(*found.kept, find_sight(there, row.view, floor, ways)))
    return found


def _open_ground(
    site: Site,
    floor: shapely.Polygon,
    ways: Sequence[Way],
    standing: Sequence[Standing],
    blocks: Sequence[shapely.Polygon],
) -> OpenGround:
    streets = [shapely.Polygon(a.outline, a.holes) for way in ways for a in way.areas]
    bodies = [shapely.buffer(shapely.Polygon(row.footprint), CLEAR) for row in standing]
    roads = [way for way in ways if way.kind == "road"]
    driven = roads or [way for way in ways if is_drivable(way, site.fire_access)]
    outline = shapely.get_coordinates(floor.exterior)[:-1]
    return OpenGround(
        shapely.difference(floor, shapely.union_all([*streets, *bodies])),
        shapely.union_all(np.array(list(blocks), object)),
        list_frontages(list_fronts(ways), outline),
        list_frontages(list_fronts(driven), outline),
        math.sqrt(floor.area),
        shapely.union_all([shapely.Polygon(a.outline, a.holes) for w in driven for a in w.areas]),
    )


def _free(open_: OpenGround, found: Reserved) -> list[shapely.Geometry]:
    """The open ground not yet set apart."""
    taken = shapely.union_all(shapely.buffer(np.array(found.kept, object), CLEAR))
    return [shapely.difference(open_.free, taken)]


def _add_square(
    found: Reserved, open_: OpenGround, area: float, at: tuple[float, float], name: str
) -> Reserved:
    """A square as near to a point as there is room for it."""
    ground, best = _free(open_, found), None
    for k, aspect in enumerate(ASPECTS):
        wide = math.sqrt(area * aspect)
        lots = list_lots(open_.beside_ways, wide, area / wide, STEP)
        lots = keep_open_lots(lots, ground)
        far = np.hypot(*(lots.mean(1) - at).T) / open_.span + 0.02 * k
        chosen = _choose(lots, far, open_, found)
        if chosen is not None and (best is None or chosen[0] < best[0]):
            best = chosen
    if best is None:
        return found
    square = PavedArea("square", _ring(best[1]), 0, name)
    kept = (*found.kept, shapely.Polygon(best[1]))
    return found._replace(areas=(*found.areas, square), kept=kept)


def _add_parking(found: Reserved, open_: OpenGround, bays: int) -> Reserved:
    """Lots for ``bays`` bays, as far as there is room."""
    points, deepest = _spread_points(open_), MOST_ROWS
    nearest = np.full(len(points), open_.span)
    while bays > 0 and deepest >= LEAST_ROWS:
        rows = min(deepest, max(math.ceil(bays / 2), LEAST_ROWS))
        wide, deep = DRIVE + 2.0 * BAY_DEPTH, BAY_WIDTH * rows
        lots = list_lots(open_.beside_roads, wide, deep, STEP)
        lots = keep_open_lots(lots, _free(open_, found))
        away = np.hypot(*(lots.mean(1)[:, None] - points).transpose(2, 0, 1))
        far = np.minimum(away, nearest).mean(1) / open_.span if len(lots) else np.zeros(0)
        chosen = _choose(lots, far, open_, found)
        if chosen is None:
            deepest = rows - 2
            continue
        lot = chosen[1]
        area = PavedArea("parking", _ring(lot), min(2 * rows, bays))
        drive = Pathway("drive", DRIVE, _drive_line(lot, open_.driven))
        kept = (*found.kept, shapely.Polygon(lot))
        found = Reserved((*found.areas, area), (*found.drives, drive), kept)
        nearest = np.minimum(nearest, np.hypot(*(lot.mean(0) - points).T))
        bays -= area.bays
    return found


def _choose(
    lots: Floats, far: Floats, open_: OpenGround, found: Reserved
) -> tuple[float, Floats] | None:
    """The best of some lots (n, 4, 2), with what it costs: how ``far`` (n,) it is from where it
    should be, and how much ground it cuts up besides what it takes."""
    if not len(lots):
        return None
    blocks = shapely.difference(open_.blocks, shapely.union_all(np.array(found.kept, object)))
    before = shapely.buffer(blocks, -NARROW, join_style="mitre").area
    best, least = 0, math.inf
    for k in np.argsort(far, kind="stable")[:LOOKED_AT].tolist():
        lot = shapely.Polygon(lots[k])
        rest = shapely.difference(blocks, lot)
        lost = before - shapely.buffer(rest, -NARROW, join_style="mitre").area
        cost = float(far[k]) + CUT * lost / lot.area * math.sqrt(lot.area) / open_.span
        if cost < least:
            best, least = k, cost
    return least, lots[best]


def _spread_points(open_: OpenGround) -> Floats:
    """At most about :data:`POINTS` points spread over the ground that can be built on."""
    x0, y0, x1, y1 = open_.blocks.bounds
    step = max(math.sqrt((x1 - x0) * (y1 - y0) / POINTS), 1.0)
    x, y = np.meshgrid(np.arange(x0, x1, step) + step / 2, np.arange(y0, y1, step) + step / 2)
    inside = shapely.contains_xy(open_.blocks, x, y)
    middle = shapely.get_coordinates(open_.blocks.representative_point())
    return np.column_stack([x[inside], y[inside]]) if inside.any() else middle


def _drive_line(lot: Floats, driven: shapely.Geometry) -> tuple[tuple[float, float], ...]:
    """The middle of a lot's drive, from the edge of the street to its end: lots lie along straight
    lines, from which a bent street is up to :data:`.lots.STRAIGHT` away."""
    start, end = 0.5 * (lot[0] + lot[1]), 0.5 * (lot[2] + lot[3])
    if not shapely.is_empty(driven):
        away = shapely.shortest_line(shapely.Point(start), driven)
        start = shapely.get_coordinates(away)[1] if away.length <= 2.0 * STRAIGHT else start
    return _ring(np.stack([start, end]))


def _middle(floor: shapely.Polygon) -> tuple[float, float]:
    return float(floor.centroid.x), float(floor.centroid.y)


def _ring(points: Floats) -> tuple[tuple[float, float], ...]:
    """Corners to the millimetre."""
    return tuple((x, y) for x, y in np.round(points, 3).tolist())
