"""The plan of an extension: sources read and cleaned, areas with their ground and streets.

Everything later stages rely on is checked here, once.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.core.brief import Brief
from scenewright.core.brief.terrain import BANK, list_waters
from scenewright.core.errors import InputError
from scenewright.core.footprint import place_outline, read_footprint
from scenewright.core.layout import corners
from scenewright.core.plan import Plan
from scenewright.core.space import Level, Space
from scenewright.domains.extend.areas import OLD, AreaPlan, ExtendPlan, StandingLock
from scenewright.domains.extend.brief import (
    ExtendPart,
    GrowthArea,
    LockedGrowth,
    SourceBuilding,
    SourceScene,
    StreetLine,
)
from scenewright.domains.extend.pattern import STOREY, learn_pattern
from scenewright.domains.extend.streets import continue_streets
from scenewright.ground import outlines as shapes
from scenewright.ground.buildings.built import BuiltBuilding, BuiltRoad, BuiltScene, ground_of
from scenewright.ground.names import assign_ids
from scenewright.ground.plan import Area, SitePlan, Way
from scenewright.ground.reading import read_built
from scenewright.ground.reading.cleaning import clean_outline, drop_overlaps

LEVEL = Level("0", "", 0.0, 3.0)
SKY = 400.0
BESIDE = 80.0
"""Metres from an area within which a source stands beside it."""
LEAST_SOURCE = 2
LEAST_ROW = 1.0
"""Metres of a drawn row."""
ROOFED = 2.5
"""Metres of a roof over the storeys of a building that states these alone."""
GAP = 30.0
"""Metres between old and new ground that are closed."""
MARGIN = 8.0
"""Metres of ground around old buildings."""


def plan_extend(brief: Brief) -> Plan:
    """The plan of a brief of an extension: open ground, ``detail`` an :class:`ExtendPlan`.

    Raises InputError, with the place in the brief, for anything that cannot be built.
    """
    part: ExtendPart = brief.part
    sources = [_source(row, number, part.origin) for number, row in enumerate(part.sources)]
    outlines = [_outline(row, number) for number, row in enumerate(part.areas)]
    _check_apart(outlines)
    stands = tuple(
        _stands(row, scene, outlines) for row, scene in zip(part.sources, sources, strict=True)
    )
    shares = tuple(row.share for row in part.sources)
    pattern = learn_pattern(sources, shares)
    _check_storeys(part.areas, max(kind.size[2] for kind in pattern.kinds))
    old = [scene for scene, there in zip(sources, stands, strict=True) if there]
    names = assign_ids(part.areas, "area", "areas")
    waters = shapes.kept_free(map(shapely.Polygon, list_waters(part.terrain)), BANK)
    areas = tuple(
        _area(row, name, floor, old, waters, f"areas[{number}]")
        for number, (row, name, floor) in enumerate(zip(part.areas, names, outlines, strict=True))
    )
    notes = tuple(f"{s.name or 'source'}: {line}" for s in sources for line in s.left_out)
    ground = _ground(brief.name, old, areas)
    detail = ExtendPlan(tuple(sources), shares, stands, pattern, areas, ground, notes)
    spaces = _spaces(old, areas)
    return Plan((LEVEL,), spaces, {space.id: space.name for space in spaces}, detail)


def _source(row: SourceScene, number: int, origin: tuple[float, float] | None) -> BuiltScene:
    """One source, read and cleaned."""
    place = f"sources[{number}]"
    if (row.path is None) == (not row.buildings):
        fault = "names a file and draws buildings" if row.path else "has no buildings"
        raise InputError(fault, 'give either "path" or "buildings"', place=place)
    try:
        scene = (
            _build_source(row)
            if row.path is None
            else read_built(Path(row.path), origin, row.scale)
        )
    except InputError as error:
        raise error.located(place=place) from None
    roads = (*scene.roads, *(_road(one, place) for one in row.roads)) if row.path else scene.roads
    scene = scene._replace(
        name=row.name or scene.name,
        roads=roads,
        trees=(*scene.trees, *row.trees),
        lamps=(*scene.lamps, *row.lamps),
    )
    if row.outline is not None:
        floor = shapes.ground(row.outline, [])
        scene = scene._replace(outline=rings(floor)[0])
    if len(scene.buildings) < LEAST_SOURCE:
        raise InputError(
            f"has {len(scene.buildings)} building that can be used: no arrangement can be learned",
            f"give a neighbourhood of at least {LEAST_SOURCE} buildings",
            place=place,
        )
    return scene


def _build_source(row: SourceScene) -> BuiltScene:
    found, left_out = [], list[str]()
    for number, one in enumerate(row.buildings):
        name = one.id or f"building-{number + 1}"
        outline = clean_outline(np.array(one.outline, float))
        if outline is None:
            left_out.append(f"{name}: has no usable footprint")
            continue
        high = _height(one)
        built = BuiltBuilding(name, one.name, outline, high, one.heading, one.model)
        found.append(built._replace(use=one.use or "", roof=one.roof or ""))
    kept, overlapping = drop_overlaps(found) if found else ((), ())
    roads = tuple(_road(one, "") for one in row.roads)
    return BuiltScene(row.name, kept, roads, None, (*left_out, *overlapping))


def _height(row: SourceBuilding) -> float:
    """The height of a drawn building; by its storeys and a roof where it states these alone."""
    if row.levels is None or "height" in row.model_fields_set:
        return row.height
    return row.levels * STOREY + (0.5 if row.roof == "flat" else ROOFED)


def _road(row: StreetLine, place: str) -> BuiltRoad:
    try:
        line, _ = shapes.way(row.line, row.width)
    except InputError as error:
        raise error.located(place=place) from None
    return BuiltRoad(line, row.width, row.kind, row.name)


def _outline(row: GrowthArea, number: int) -> shapely.Polygon:
    try:
        return shapes.ground(row.outline, row.holes)
    except InputError as error:
        raise error.located(place=f"areas[{number}]") from None


def _check_apart(floors: Sequence[shapely.Polygon]) -> None:
    for b, floor in enumerate(floors):
        for a in range(b):
            shared = shapely.intersection(floors[a], floor).area
            if shared > 1.0:
                raise InputError(
                    f"overlaps areas[{a}] by {shared:.1f} m²",
                    "draw them apart",
                    place=f"areas[{b}]",
                )


def _stands(row: SourceScene, scene: BuiltScene, outlines: Sequence[shapely.Polygon]) -> bool:
    """Whether a source stands where it is drawn: as it says, else if it lies beside an area."""
    if row.stands is not None:
        return row.stands
    built = shapely.multipolygons([shapely.Polygon(one.outline) for one in scene.buildings])
    return any(shapely.distance(built, outline) < BESIDE for outline in outlines)


def _area(
    row: GrowthArea,
    name: str,
    outline: shapely.Polygon,
    old: Sequence[BuiltScene],
    waters: shapely.Geometry,
    place: str,
) -> AreaPlan:
    drawn = tuple(_road(one, f"{place} roads") for one in row.roads)
    _check_rows(row, place)
    built = [shapely.Polygon(one.outline) for scene in old for one in scene.buildings]
    theirs = [road for scene in old for road in scene.roads]
    continued: tuple[BuiltRoad, ...] = ()
    if row.continue_streets:
        continued = continue_streets(theirs, outline, built, drawn)
    roads = (*drawn, *continued)
    taken = [
        shapely.buffer(shapely.LineString(road.line), road.width / 2, cap_style="flat")
        for road in (*theirs, *roads)
    ]
    rest = shapes.less([outline], [*taken, *shapely.buffer(built, 0.01), *shapes.polygons(waters)])
    if not rest:
        raise InputError(
            "nothing of it is free to build on", "move its outline off the source", place=place
        )
    floor = shapely.multipolygons(rest)
    fixed = tuple(_lock(one, outline, f"{place} fixed[{k}]") for k, one in enumerate(row.fixed))
    return AreaPlan(name, row.name or name, outline, floor, roads, continued, fixed, row)


def _check_storeys(areas: Sequence[GrowthArea], tallest: float) -> None:
    """No area lowers what is grown there below one storey: of the ``tallest`` building, in metres,
    one must be left."""
    for number, row in enumerate(areas):
        if tallest + row.storeys * STOREY < STOREY:
            least = -int(max(tallest / STOREY - 1, 0))
            raise InputError(
                f"{row.storeys} storeys leave nothing of its tallest building, {tallest:.1f} m",
                f"give at least {least}",
                place=f"areas[{number}].storeys",
            )


def _check_rows(row: GrowthArea, place: str) -> None:
    """Every drawn row has a line along which houses can stand."""
    for number, one in enumerate(row.rows):
        if shapely.LineString(one.line).length < LEAST_ROW:
            raise InputError(
                "its line has no length",
                f"draw it from end to end, at least {LEAST_ROW:g} m",
                place=f"{place}.rows[{number}]",
            )


def _lock(row: LockedGrowth, outline: shapely.Polygon, place: str) -> StandingLock:
    width, depth, height = row.size
    box = (*row.at, row.heading, width, depth)
    local = read_footprint(row.footprint, width, depth) if row.footprint else ()
    ring = (
        place_outline(np.array(local), *row.at, row.heading)
        if local
        else corners(np.array([box]))[0]
    )
    if not shapely.Polygon(ring).intersects(outline):
        raise InputError("stands outside its area", "move it in or let it go", place=place)
    return StandingLock(row.id, row.kind, row.model, ring, box, height, local)


def _spaces(old: Sequence[BuiltScene], areas: Sequence[AreaPlan]) -> tuple[Space, ...]:
    """The areas, and the ground of old buildings beside them."""
    found = [
        Space(area.id, area.name, ("extend",), LEVEL.id, *rings(area.outline), SKY)
        for area in areas
    ]
    new = shapely.union_all([area.outline for area in areas])
    whole = _close_gaps(shapely.union_all([_old_ground(old), new], grid_size=shapes.GRID))
    rest = shapes.polygons(shapely.difference(whole, new, grid_size=shapes.GRID)) if old else []
    for number, part in enumerate(rest):
        name = OLD if number == 0 else f"{OLD}-{number + 1}"
        found.append(Space(name, "What stood before", ("extend",), LEVEL.id, *rings(part), SKY))
    return tuple(found)


def _old_ground(old: Sequence[BuiltScene]) -> shapely.Geometry:
    """The ground of the sources that stand, with their streets."""
    parts = []
    for scene in old:
        parts.append(shapely.buffer(ground_of(scene), MARGIN, join_style="mitre"))
        parts += [
            shapely.buffer(shapely.LineString(road.line), road.width / 2, cap_style="flat")
            for road in scene.roads
        ]
    return shapely.union_all(parts, grid_size=shapes.GRID)


def _close_gaps(ground: shapely.Geometry) -> shapely.Geometry:
    """Ground without the gaps and notches that are narrower than :data:`GAP`."""
    grown = shapely.buffer(ground, GAP / 2, join_style="mitre")
    back = shapely.buffer(grown, -GAP / 2, join_style="mitre")
    return shapely.union(back, ground, grid_size=shapes.GRID)


def _ground(name: str, old: Sequence[BuiltScene], areas: Sequence[AreaPlan]) -> SitePlan:
    """All ground with all streets, as pictures and surfaces take it."""
    new = [area.outline for area in areas]
    whole = _close_gaps(shapely.union_all([_old_ground(old), *new], grid_size=shapes.GRID))
    hull = shapely.convex_hull(whole)
    parts = shapes.polygons(whole)
    floor = parts[0] if len(parts) == 1 else hull
    outline, holes = rings(floor)
    roads = [
        *((road, "old") for scene in old for road in scene.roads),
        *((road, "new") for area in areas for road in area.roads),
    ]
    ways = tuple(_way(road, f"{age}-{k + 1}", floor) for k, (road, age) in enumerate(roads))
    return SitePlan("ground", name, outline, holes, floor.area, floor.area, (), ways, (), ())


def _way(road: BuiltRoad, name: str, floor: shapely.Polygon) -> Way:
    line, area = shapes.way(road.line, road.width)
    inside = shapes.lines(shapely.intersection(shapely.LineString(line), floor))
    areas = tuple(
        Area(*rings(part), part.area)
        for part in shapes.polygons(shapely.intersection(area, floor, grid_size=shapes.GRID))
    )
    return Way(name, road.name, road.kind, road.width, line, inside, areas)
