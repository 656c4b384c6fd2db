"""What lies on the ground of a site: carriageways, pavements, paths, markings, walks to doors.

Roads are united before they are drawn, so that bends have no gaps and crossings are one piece.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import lru_cache

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.building.outlines import rings
from scenewright.core.scene import GroundSurface
from scenewright.core.space import Points
from scenewright.ground.outlines import GRID, MITRE
from scenewright.ground.plan import SitePlan, Way
from scenewright.ground.streetside.bays import list_bay_lines
from scenewright.ground.ways.junctions import (
    LANE_RADIUS,
    STREET_RADIUS,
    Crossing,
    list_crossings,
    paint,
    round_corners,
)
from scenewright.ground.ways.kerbs import edge_pavement
from scenewright.ground.works import GroundWorks, Pathway

HEIGHTS = {
    "asphalt": 0.03,
    "marking": 0.035,
    "lane": 0.036,
    "park": 0.015,
    "court": 0.02,
    "parking": 0.032,
    "walk": 0.04,
    "square": 0.045,
    "path": 0.05,
    "pavement": 0.13,
    "kerb": 0.14,
}
"""How far the top of each lies above the ground, in metres."""
DASH, GAP, STRIPE = 3.0, 5.0, 0.16
"""Length, distance and width of the dashes of a road's middle line, in metres."""
SPECK = 0.02
"""Areas smaller than this, in square metres, are left out."""
REMEMBERED = 8192
"""Areas whose rings are remembered."""


def surfaces(
    plans: Sequence[SitePlan],
    works: Sequence[GroundWorks],
    built: Sequence[shapely.Geometry] | NDArray[np.object_] = (),
) -> tuple[GroundSurface, ...]:
    """What lies on the ground of all sites, a row for each kind that occurs; ``works`` are the
    ways laid out on each, and corners of ways are round where none of what is ``built`` stands."""
    solids = shapely.STRtree(np.array(built, object))
    pairs = zip(plans, works, strict=True)
    return tuple(row for plan, one in pairs for row in _of_plan(plan, one, solids))


def _of_plan(
    plan: SitePlan, works: GroundWorks, solids: shapely.STRtree
) -> Iterator[GroundSurface]:
    floor = shapely.Polygon(plan.outline, plan.holes)
    driven = [way for way in plan.roads if way.kind == "road"]
    roads, paths = (
        _union_areas(driven),
        _union_areas(way for way in plan.roads if way.kind == "path"),
    )
    lanes = round_corners(_lanes(driven), STREET_RADIUS, solids)
    lanes = shapely.intersection(lanes, floor, grid_size=GRID)
    shapely.prepare(lanes)
    roads = shapely.union(roads, lanes, grid_size=GRID)
    ways = _join(roads, paths)
    drives = _join(pave(works.pathways, "lane"), ways)
    drives = _less(round_corners(drives, LANE_RADIUS, solids), ways)
    squares = _less(_paved_areas(works, "square", "forecourt"), ways)
    lots = _less(_paved_areas(works, "parking"), ways)
    hard = _join(ways, drives, squares, lots)
    strips = _less(pave(works.pathways, "walk"), hard)
    hard = _join(hard, strips)
    courts = _less(_paved_areas(works, "court"), hard)
    parks = _less(_paved_areas(works, "park"), _join(hard, courts))
    drives = _less(drives, _join(squares, lots))
    zebras = list_zebras(plan)
    edged = edge_pavement(_less(roads, lanes), lanes, zebras, works.pathways)
    found = {
        "asphalt": lanes,
        "pavement": edged.pavement,
        "kerb": edged.kerb,
        "path": _less(paths, roads),
        "lane": _lie_on(drives, floor),
        "walk": _lie_on(strips, floor),
        "marking": shapely.union_all(
            [_markings(driven, lanes, zebras), paint(zebras), _bay_markings(works)]
        ),
        "square": _lie_on(squares, floor),
        "parking": _lie_on(lots, floor),
        "court": _lie_on(courts, floor),
        "park": _lie_on(parks, floor),
    }
    for kind, shape in found.items():
        areas = tuple(_ring_again(part.wkb) for part in _polygons(shape))
        if areas:
            top = HEIGHTS[kind]
            base, fall = top if kind == "marking" else -0.01, edged.fall if kind == "kerb" else None
            yield GroundSurface(f"{kind} of {plan.id}", plan.id, kind, areas, base, top, fall)


@lru_cache(REMEMBERED)
def _ring_again(area: bytes) -> tuple[Points, tuple[Points, ...]]:
    """The rings of an area: most dashes, kerbs and streets of one layout are those of another."""
    return rings(shapely.from_wkb(area))


def _areal(shape: shapely.Geometry) -> shapely.Geometry:
    """What of a shape is area: overlays also leave lines where borders meet, and fail on them."""
    if shape.geom_type in ("Polygon", "MultiPolygon"):
        return shape
    parts = shapely.get_parts(shapely.get_parts(shape))
    return shapely.union_all([part for part in parts if part.geom_type == "Polygon"])


def _less(shape: shapely.Geometry, other: shapely.Geometry) -> shapely.Geometry:
    return _areal(shapely.difference(_areal(shape), _areal(other), grid_size=GRID))


def _join(*shapes: shapely.Geometry) -> shapely.Geometry:
    return _areal(shapely.union_all([_areal(shape) for shape in shapes], grid_size=GRID))


def pave(pathways: Sequence[Pathway], kind: str) -> shapely.Geometry:
    """The ground that ways of a kind cover, with round bends. The ends of lanes are round too:
    there is room for a disc of their width.

    >>> round(pave([Pathway("walk", 2.0, ((0, 0), (10, 0)))], "walk").area)
    20
    """
    rows = [row for row in pathways if row.kind == kind]
    lines = np.array([shapely.LineString(row.line) for row in rows], object)
    half = np.array([row.width / 2 for row in rows])
    ends = "round" if kind == "lane" else "flat"
    return shapely.union_all(shapely.buffer(lines, half, cap_style=ends, quad_segs=4))


def _paved_areas(works: GroundWorks, *kinds: str) -> shapely.Geometry:
    """The ground of areas of some kinds."""
    shapes = [shapely.Polygon(row.outline) for row in works.areas if row.kind in kinds]
    return shapely.union_all(np.array(shapes, object))


def _bay_markings(works: GroundWorks) -> shapely.Geometry:
    """The lines between the bays of all car parks."""
    lines = np.concatenate([np.zeros((0, 2, 2)), *(list_bay_lines(row) for row in works.areas)])
    stripes = shapely.buffer(shapely.linestrings(lines), STRIPE / 2, cap_style="flat")
    return shapely.union_all(stripes)


def kerb(width: float) -> float:
    """Width in metres of the pavement on each side of a road of some width.

    >>> kerb(4.0), round(kerb(10.0), 2)
    (0.0, 1.5)
    """
    return min(max(0.15 * width, 0.9), 3.0) if width >= 5.5 else 0.0


def _lie_on(shape: shapely.Geometry, floor: shapely.Polygon) -> shapely.Geometry:
    """The part of some ground on a floor, without lines and points that overlays leave."""
    ground = shapely.union_all(np.array(_polygons(shape), object))
    return shapely.intersection(ground, floor, grid_size=GRID)


def list_zebras(plan: SitePlan) -> list[Crossing]:
    """The crossings of the streets of a site that have pavements."""
    wide = [way.width - 2.0 * kerb(way.width) if kerb(way.width) else 0.0 for way in plan.roads]
    return list_crossings(plan.roads, wide)


def _union_areas(ways: Iterable[Way]) -> shapely.Geometry:
    """The ground of ways, inside the site."""
    parts = [shapely.Polygon(a.outline, a.holes) for way in ways for a in way.areas]
    return shapely.union_all(np.array(parts, object), grid_size=GRID)


def _lanes(ways: Sequence[Way]) -> shapely.Geometry:
    """The carriageways, without the pavement beside them."""
    lines = np.array([shapely.LineString(way.line) for way in ways], object)
    half = np.array([way.width / 2 - kerb(way.width) for way in ways])
    wide = shapely.buffer(lines, half, cap_style="flat", join_style="mitre", mitre_limit=MITRE)
    return shapely.union_all(wide, grid_size=GRID)


def _markings(
    ways: Sequence[Way], lanes: shapely.Geometry, zebras: Sequence[Crossing]
) -> shapely.Geometry:
    """Dashes along the middle of roads of two lanes, none where another road or a crossing lies or
    the lanes end."""
    wide = [number for number, way in enumerate(ways) if way.width - 2 * kerb(way.width) >= 5.0]
    dashes = [_dashes(ways[number].line) for number in wide]
    if not sum(map(len, dashes)):
        return shapely.Polygon()
    owner = np.repeat(wide, [len(rows) for rows in dashes])
    stripes = shapely.buffer(
        shapely.linestrings(np.concatenate(dashes)), STRIPE / 2, cap_style="flat"
    )
    ground = [shapely.LineString(way.line).buffer(way.width / 2, cap_style="flat") for way in ways]
    dash, road = shapely.STRtree(ground).query(stripes, predicate="intersects")
    drawn = shapely.covers(lanes, stripes)
    drawn[dash[road != owner[dash]]] = False
    near = shapely.STRtree([row.area() for row in zebras]).query(
        stripes, predicate="dwithin", distance=GAP / 2
    )
    drawn[near[0]] = False
    return shapely.multipolygons(stripes[drawn])


def _dashes(line: Points) -> Points:
    """Both ends (n, 2, 2) of every dash along a line."""
    whole = shapely.LineString(line)
    starts = np.arange(GAP / 2, whole.length - DASH, DASH + GAP)
    ends = shapely.line_interpolate_point(whole, np.stack([starts, starts + DASH], 1))
    found: Points = shapely.get_coordinates(ends).reshape(-1, 2, 2)
    return found


def _polygons(shape: shapely.Geometry) -> list[shapely.Polygon]:
    parts = shapely.get_parts(shapely.get_parts(shape))
    return [p for p in parts if p.geom_type == "Polygon" and p.area > SPECK]
