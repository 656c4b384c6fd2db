"""The plan of a village: blocks with their street sides, lanes, and the library of houses.

Everything later stages rely on is checked here, once: outlines that are simple and apart, a street
side for each block, a house that fits.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.catalog.assets.buildings.house_looks import LOOKS, RURAL
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.brief.terrain import BANK, list_waters
from scenewright.core.errors import InputError
from scenewright.core.footprint import place_outline, read_footprint
from scenewright.core.layout import corners
from scenewright.core.plan import Plan
from scenewright.core.space import Level, Points, Space
from scenewright.domains.village.blocks import BlockPlan, StandingHouse, VillagePlan
from scenewright.domains.village.brief import LockedHouse, VillageBlock
from scenewright.domains.village.house import House
from scenewright.domains.village.learned.style import (
    VillageStyle,
    is_file,
    style_in_region,
    style_named,
)
from scenewright.domains.village.library import houses_of
from scenewright.domains.village.paper.nets_file import PaperNets, read_paper_nets
from scenewright.ground import outlines as shapes
from scenewright.ground.buildings.plain_buildings import plain_building, style_at
from scenewright.ground.names import assign_ids
from scenewright.ground.plan import Area, SitePlan, Way

LEVEL = Level("0", "", 0.0, 2.6)
SKY = 60.0
LANE = LOOKS[RURAL].street
"""Width in metres of the widest lane along street sides where the brief draws none."""
BESIDE = 6.0
"""How far beyond the edge of a lane, in metres, a side of a block may lie and be on it."""
VERGE = 1.2
"""Metres before a street side that belong to the street."""
CRACKS = (0.0, 0.02, 0.1, 0.4)
"""Widths of cracks closed one after the other, in metres."""
HOME = {
    "riviera": "monaco_hills",
    "hill": "monaco_hills",
    "alpine": "liechtenstein",
    "timbered": "bayreuth",
}
"""The region of the shipped style in which houses of a look stand."""
SPECK = 0.01
"""Square metres of the least ground of a block that a lane takes."""
OVERLAP = 1.0
"""Square metres that two blocks may share."""


def plan_village(brief: Brief) -> Plan:
    """The plan of a brief of a village: open ground, ``detail`` a :class:`VillagePlan`.

    Raises InputError, with the place in the brief, for anything that cannot be built on.
    """
    style = _in_region(style_named(brief.style), brief.part.region, HOME.get(brief.style, ""))
    look = str(style.card.get("look", "")) if is_file(brief.style) else _look(brief.style)
    look = look if look in LOOKS else style_at(brief.part.origin) or RURAL
    houses = houses_of(
        brief.part.houses,
        look,
        catalog_of(brief.catalogs),
        any(block.uses for block in brief.part.blocks),
    )
    names = assign_ids(brief.part.blocks, "block", "blocks")
    waters = shapes.kept_free(map(shapely.Polygon, list_waters(brief.part.terrain)), BANK)
    floors = [
        _floor(block, f"blocks[{k}] '{block.name or names[k]}'", houses, waters)
        for k, block in enumerate(brief.part.blocks)
    ]
    _check_apart(floors)
    everything = shapely.union_all(floors)
    lanes = _lanes(brief)
    streets = [
        _streets(block, lanes, f"blocks[{k}] '{block.name or names[k]}'")
        for k, block in enumerate(brief.part.blocks)
    ]
    lanes = lanes or _implied_lanes(streets, everything, LOOKS[look].street)
    blocks = tuple(
        _block(block, name, floor, sides, lanes, f"blocks[{k}]", look)
        for k, (block, name, floor, sides) in enumerate(
            zip(brief.part.blocks, names, floors, streets, strict=True)
        )
    )
    spaces = tuple(
        Space(block.id, block.name, ("village",), LEVEL.id, block.outline, (), SKY)
        for block in blocks
    )
    detail = VillagePlan(blocks, lanes, houses, look, style, _nets(brief))
    return Plan((LEVEL,), spaces, {block.id: block.name for block in blocks}, detail)


def _nets(brief: Brief) -> PaperNets | None:
    """The networks a brief names."""
    return read_paper_nets(Path(brief.part.nets)) if brief.part.nets else None


def use_nets(brief: Brief, plan: Plan, file: str, solver: str) -> tuple[Brief, Plan]:
    """A brief and its plan with the networks of a file for the solver ``paper``; InputError for
    another solver, and for a file that holds none."""
    if solver != "paper":
        raise InputError(f"the solver '{solver}' asks no networks", "add --preset paper")
    part = brief.part.model_copy(update={"nets": str(Path(file).absolute())})
    named = brief.model_copy(update={"part": part})
    return named, plan._replace(detail=plan.detail._replace(nets=_nets(named)))


def _look(style: str) -> str:
    """The style of the houses a brief names; empty if it names none."""
    if style and style not in LOOKS:
        raise InputError(
            f"'{style[:40]}' is no style of villages",
            f"use one of: {', '.join(LOOKS)}, or a file .npz",
            place="style",
        )
    return style


def _in_region(style: VillageStyle, region: str | None, usual: str) -> VillageStyle:
    """The style as in a region, or, where none is named, in the usual one of a look; InputError
    for one it does not know."""
    if region and region not in style.regions:
        known = ", ".join(style.regions)
        raise InputError(
            f"the style knows no region '{region[:40]}'",
            f"use one of: {known}" if known else "leave it out",
            place="region",
        )
    return style_in_region(style, region or usual)


def _floor(
    block: VillageBlock, place: str, houses: Sequence[House], waters: shapely.Geometry
) -> shapely.Polygon:
    """The ground of a block off the water, wide enough for the least house."""
    try:
        floor = shapes.ground(block.outline, [])
        floor = leave_out_water(floor, waters)
    except InputError as error:
        raise error.located(place=place) from None
    least = min(houses, key=lambda house: house.extent[1])
    radius = shapes.inscribed_radius(floor)
    if 2.02 * radius < least.extent[1] or floor.area < min(house.area for house in houses):
        raise InputError(
            f"is {2 * radius:.1f} m wide and {floor.area:.0f} m² large: no house fits "
            f"(the narrowest, '{least.name}', is {least.extent[1]:.1f} m)",
            "enlarge the outline, or add smaller houses",
            place=place,
        )
    return floor


def leave_out_water(floor: shapely.Polygon, waters: shapely.Geometry) -> shapely.Polygon:
    """The largest part of a floor off the ``waters``; InputError for one round a lake."""
    if not floor.intersects(waters):
        return floor
    rest = shapes.less([floor], [waters])
    if not rest or rest[0].interiors:
        raise InputError("surrounds water, or is all of it", "draw blocks beside the water")
    return rest[0]


def _check_apart(floors: Sequence[shapely.Polygon]) -> None:
    i, j = shapely.STRtree(floors).query(floors, predicate="intersects")
    for a, b in zip(i.tolist(), j.tolist(), strict=True):
        shared = shapely.intersection(floors[a], floors[b]).area if a < b else 0.0
        if shared > OVERLAP:
            raise InputError(
                f"overlaps blocks[{a}] by {shared:.1f} m²", "draw them apart", place=f"blocks[{b}]"
            )


def _lanes(brief: Brief) -> tuple[Way, ...]:
    """The lanes of the brief with the ground they cover."""
    found = []
    for number, name in enumerate(assign_ids(brief.part.lanes, "lane", "lanes")):
        lane = brief.part.lanes[number]
        try:
            line, area = shapes.way(lane.line, lane.width)
        except InputError as error:
            raise error.located(place=f"lanes[{number}]") from None
        found.append(_way(name, lane.name, lane.kind, lane.width, line, area))
    return tuple(found)


def _way(
    name: str, label: str, kind: str, width: float, line: Points, area: shapely.Geometry
) -> Way:
    parts = [Area(*rings(part), part.area) for part in shapes.polygons(area)]
    return Way(name, label, kind, width, line, (line,), tuple(parts))


def _streets(block: VillageBlock, lanes: Sequence[Way], place: str) -> Points:
    """The street sides (s, 2, 2) of a block: those it names, else those along lanes."""
    corners_ = np.array(block.outline, float)
    sides = np.stack([corners_, np.roll(corners_, -1, axis=0)], 1)
    if block.streets is not None:
        wrong = [k for k in block.streets if not 0 <= k < len(sides)]
        if wrong:
            raise InputError(
                f"has no side {wrong[0]}",
                f"its {len(sides)} sides are numbered from 0",
                place=f"{place} streets",
            )
        chosen = sides[sorted(set(block.streets))]
    else:
        chosen = sides[_along(sides, lanes)]
    chosen = chosen[np.hypot(*(chosen[:, 1] - chosen[:, 0]).T) > 1e-3]
    if not len(chosen):
        raise InputError(
            "no side of its outline is a street",
            'name its sides in "streets", or draw a lane along one in "lanes"',
            place=place,
        )
    return chosen


def _along(sides: Points, lanes: Sequence[Way]) -> list[int]:
    """The numbers of sides that run along a lane: both quarters of it lie near."""
    if not lanes:
        return []
    near = [
        shapely.buffer(shapely.LineString(way.line), way.width / 2 + BESIDE, cap_style="flat")
        for way in lanes
    ]
    quarters = sides[:, :1] + (sides[:, 1:] - sides[:, :1]) * np.array([0.25, 0.75])[None, :, None]
    inside = [shapely.contains_xy(area, quarters[..., 0], quarters[..., 1]).all(1) for area in near]
    return np.flatnonzero(np.any(inside, axis=0)).tolist()


def _implied_lanes(
    streets: Sequence[Points], blocks: shapely.Geometry, wide: float
) -> tuple[Way, ...]:
    """A lane before the street sides, where the brief draws none."""
    sides = shapely.linestrings(np.concatenate(streets))
    merged = shapely.line_merge(shapely.union_all(sides))
    found: list[Way] = []
    for line in shapes.lines(merged):
        strip = shapely.buffer(shapely.LineString(line), wide, cap_style="square")
        area = shapely.difference(strip, blocks, grid_size=shapes.GRID)
        middle = _outside(line, blocks, wide)
        if len(middle) > 1 and not area.is_empty:
            found.append(_way(f"lane-{len(found) + 1}", "", "road", wide, middle, area))
    return tuple(found)


def _outside(line: Points, blocks: shapely.Geometry, wide: float) -> Points:
    """The line half a lane's width to the side where no block is."""
    both = [shapely.offset_curve(shapely.LineString(line), s * wide / 2) for s in (-1, 1)]
    shares = [shapely.intersection(one, blocks).length for one in both]
    parts = shapes.lines(both[int(np.argmin(shares))])
    return max(parts, key=len) if parts else line


def _block(
    block: VillageBlock,
    name: str,
    floor: shapely.Polygon,
    streets: Points,
    lanes: Sequence[Way],
    place: str,
    look: str,
) -> BlockPlan:
    outline, _ = rings(floor)
    length = float(np.hypot(*(streets[:, 1] - streets[:, 0]).T).sum())
    fixed = tuple(
        _standing(row, floor, f"{place} fixed[{k}]", look) for k, row in enumerate(block.fixed)
    )
    label = block.name or name
    return BlockPlan(
        name,
        label,
        outline,
        floor.area,
        streets,
        length / floor.exterior.length,
        fixed,
        _ground(name, label, floor, streets, lanes),
        _covered(floor, lanes),
    )


def _covered(floor: shapely.Polygon, lanes: Sequence[Way]) -> shapely.Geometry:
    """The ground of a block that lanes cover, however narrow a strip."""
    areas = [shapely.Polygon(a.outline, a.holes) for way in lanes for a in way.areas]
    near = [area for area in areas if shapely.intersects(area, floor)]
    shared = shapely.intersection(floor, shapely.union_all(near, grid_size=shapes.GRID))
    parts = shapely.get_parts(shared)
    return shapely.union_all([p for p in parts if p.geom_type == "Polygon" and p.area > SPECK])


def _ground(
    name: str, label: str, floor: shapely.Polygon, streets: Points, lanes: Sequence[Way]
) -> SitePlan:
    """The block, its verge and the lanes beside it as one piece of open ground."""
    near = shapely.buffer(floor, BESIDE + LANE)
    sides = shapely.union_all(shapely.linestrings(streets))
    beside = [
        way for way in lanes if sides.dwithin(shapely.LineString(way.line), way.width + BESIDE)
    ]
    parts = [shapely.Polygon(a.outline, a.holes) for way in beside for a in way.areas]
    lane = shapely.intersection(shapely.union_all(parts), near, grid_size=shapes.GRID)
    verge = shapely.buffer(sides, VERGE, cap_style="flat")
    gap = _between(streets, lane)
    whole = shapely.union_all([floor, verge, lane, gap], grid_size=shapes.GRID)
    outline, holes = _sound_rings(max(shapes.polygons(whole), key=lambda part: part.area))
    ways = tuple(
        way._replace(
            inside=shapes.lines(shapely.intersection(shapely.LineString(way.line), near)),
            areas=tuple(
                Area(*rings(p), p.area)
                for a in way.areas
                for p in shapes.polygons(
                    shapely.intersection(shapely.Polygon(a.outline, a.holes), near)
                )
            ),
        )
        for way in beside
    )
    return SitePlan(name, label, outline, holes, floor.area, floor.area, (), ways, (), ())


def _sound_rings(shape: shapely.Polygon) -> tuple[Points, tuple[Points, ...]]:
    """The rings of a shape with cracks closed that are too narrow for its rings to be valid."""
    for crack in CRACKS:
        closed = shapely.buffer(shapely.buffer(shape, crack), -crack) if crack else shape
        for part in shapes.polygons(closed)[:1]:
            outline, holes = rings(part)
            if shapely.Polygon(outline, holes).is_valid:
                return outline, holes
    return rings(shapely.Polygon(shape.exterior).convex_hull)


def _between(streets: Points, lane: shapely.Geometry) -> shapely.Geometry:
    """The ground between street sides and the lane before them."""
    if lane.is_empty:
        return shapely.Polygon()
    parts = []
    for side in shapely.linestrings(streets):
        ends = shapely.points(shapely.get_coordinates(side))
        away = min(float(shapely.distance(ends, lane).max()), BESIDE)
        parts.append(shapely.buffer(side, away + VERGE, cap_style="flat"))
    return shapely.union_all(parts)


def _standing(row: LockedHouse, floor: shapely.Polygon, place: str, look: str) -> StandingHouse:
    """A house that stands; one without a model is a plain one in the ``look`` of the place."""
    width, depth, height = row.size
    box = (*row.at, row.heading, width, depth)
    local = read_footprint(row.footprint, width, depth) if row.footprint else ()
    outline = (
        place_outline(np.array(local), *row.at, row.heading)
        if local
        else corners(np.array([box]))[0]
    )
    if not shapely.Polygon(outline).intersects(floor):
        raise InputError("stands outside its block", "move it in or let it go", place=place)
    area = float(shapely.Polygon(outline).area)
    drawn = row.model or plain_building(row.size, area, look, row.use or "", row.roof or "")
    return StandingHouse(row.id, row.house, drawn, outline, box, height, local)
