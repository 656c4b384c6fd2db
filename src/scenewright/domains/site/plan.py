"""The plan of a site: from a brief to ground that can be built on, roads and landmarks.

Everything the later stages rely on is checked here, once: an outline that is simple, a setback
that leaves something, landmarks that stand inside and apart, roads that have a length.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.brief.terrain import BANK, list_waters
from scenewright.core.catalog import Catalog
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.space import Level, Points, Space
from scenewright.domains.site.brief import Site, rows_of
from scenewright.domains.site.models import building_models, fixed_of, landmarks_of, style_of
from scenewright.domains.site.paving import Reserved, reserve_areas
from scenewright.ground import outlines as shapes
from scenewright.ground.fit import main_direction
from scenewright.ground.names import assign_ids
from scenewright.ground.plan import Area, Block, Entrance, SitePlan, Standing, Way
from scenewright.ground.streetside.border import open_border

LEVEL = Level("0", "", 0.0, 2.6)
ACROSS = 4.0
"""Metres of a street by which it is seen whether it crosses the border or runs along it."""
SKY = 600.0
"""Height limit of a site that states none, in metres."""


def plan_sites(brief: Brief) -> Plan:
    """The plan of a brief of sites: open ground without walls; ``detail`` holds the
    :class:`~scenewright.ground.plan.SitePlan` of each."""
    plans = plans_of(brief)
    spaces = tuple(
        Space(plan.id, plan.name, ("site",), LEVEL.id, plan.outline, plan.holes, SKY)
        for plan in plans
    )
    return Plan((LEVEL,), spaces, {plan.id: plan.name for plan in plans}, plans)


def plans_of(brief: Brief) -> tuple[SitePlan, ...]:
    """The plans of the sites of a brief, with the models it names."""
    waters = list_waters(brief.part.terrain)
    return site_plans(brief.part.sites, catalog_of(brief.catalogs), waters)


def site_plans(
    sites: Sequence[Site], catalog: Catalog | None = None, waters: Sequence[Points] = ()
) -> tuple[SitePlan, ...]:
    """The plans of some sites; ``catalog`` holds the models of landmarks (else shipped ones),
    ``waters`` are rivers and lakes.

    Raises InputError, with the place in the brief, for anything that cannot be built on.
    """
    models = catalog_of(()) if catalog is None else catalog
    ids = assign_ids(sites, "site", "sites")
    return tuple(
        _plan(site, ids[number], f"sites[{number}] '{site.name or ids[number]}'", models, waters)
        for number, site in enumerate(sites)
    )


def site_plan(site: Site, catalog: Catalog | None = None) -> SitePlan:
    """The plan of one site.

    >>> plan = site_plan(Site(outline=[(0, 0), (100, 0), (100, 60), (0, 60)],
    ...                       roads=[{"line": [(50, 0), (50, 60)], "width": 8}]))
    >>> [round(block.area) for block in plan.blocks], len(plan.entrances)
    ([2160, 2160], 2)
    """
    return site_plans([site], catalog)[0]


def _plan(
    site: Site, name: str, place: str, catalog: Catalog, waters: Sequence[Points]
) -> SitePlan:
    try:
        floor = shapes.ground(site.outline, site.holes)
        built = shapes.inset(floor, site.setback)
    except InputError as error:
        raise error.located(place=place) from None
    assign_ids(site.buildings, "building", "buildings", place)
    if site.library and site.buildings:
        raise InputError(
            "has both buildings and a library",
            "state what is to stand, or a library with coverage or floor_area_ratio",
            place=place,
        )
    models = building_models(rows_of(site), place, catalog)
    roads = _roads(site, floor, place)
    marks = assign_ids(site.landmarks, "landmark", "landmarks", place)
    landmarks = landmarks_of(site.landmarks, marks, floor, place, catalog, style_of(site))
    fixed = fixed_of(site.fixed, floor, place, catalog)
    taken = [
        shapes.kept_free(
            [shapes.way(road.line, road.width)[1] for road in roads], site.road_setback
        ),
        shapes.kept_free([shapely.Polygon(row.footprint) for row in landmarks], site.spacing),
    ]
    if waters:
        taken.append(shapes.kept_free(map(shapely.Polygon, waters), BANK))
    blocks = tuple(_block(part) for part in shapes.less(built, taken))
    if not blocks:
        raise InputError(
            "roads, paths and landmarks with their distances leave nothing to build on",
            "lower road_setback or spacing, or take some out",
            place=place,
        )
    _check_block_forms(site, blocks, place)
    whole = [shapely.Polygon(block.outline, block.holes) for block in blocks]
    kept = reserve_areas(site, floor, roads, (*landmarks, *fixed), whole, place)
    free = _beside(blocks, fixed, kept, site)
    outline, holes = rings(floor)
    return SitePlan(
        name,
        site.name or name,
        outline,
        holes,
        floor.area,
        sum(b.area for b in blocks),
        blocks,
        roads,
        landmarks,
        tuple(_entrances(floor, roads)),
        models,
        fixed,
        free,
        kept.areas,
        kept.drives,
        tuple(waters),
    )


def _check_block_forms(site: Site, blocks: Sequence[Block], place: str) -> None:
    """InputError for a form asked for where nothing can be built."""
    shapes = [shapely.Polygon(block.outline, block.holes) for block in blocks]
    for number, row in enumerate(site.blocks):
        if not shapely.intersects(shapes, shapely.Point(row.at)).any():
            raise InputError(
                f"({row.at[0]:g}, {row.at[1]:g}) lies in no block that can be built on",
                f"give a point of one, such as ({', '.join(_point_in(shapes[0]))})",
                place=f"{place} blocks[{number}]",
            )


def _point_in(shape: shapely.Polygon) -> tuple[str, str]:
    point = shape.representative_point()
    return f"{point.x:.0f}", f"{point.y:.0f}"


def _block(part: shapely.Polygon) -> Block:
    outline, holes = rings(part)
    return Block(
        outline, holes, part.area, main_direction((outline, *holes)), shapes.inscribed_radius(part)
    )


def _beside(
    blocks: tuple[Block, ...], fixed: Sequence[Standing], kept: Reserved, site: Site
) -> tuple[Block, ...]:
    """The parts of blocks at a distance from buildings that stay and from ground set apart."""
    if not fixed and not kept.kept:
        return blocks
    areas = [shapely.Polygon(area.outline) for area in kept.areas]
    taken = [
        shapes.kept_free([shapely.Polygon(row.footprint) for row in fixed], site.spacing),
        shapes.kept_free(areas, site.road_setback),
        shapes.kept_free(kept.kept, 0.0),
    ]
    whole = [shapely.Polygon(block.outline, block.holes) for block in blocks]
    return tuple(_block(part) for part in shapes.less(whole, taken))


def _area(part: shapely.Polygon) -> Area:
    return Area(*rings(part), part.area)


def _roads(site: Site, floor: shapely.Polygon, place: str) -> tuple[Way, ...]:
    found = []
    if shapes.crossings([np.array(r.line) for r in site.roads]) > shapes.MOST_CROSSINGS:
        raise InputError(
            f"the roads cross each other more than {shapes.MOST_CROSSINGS} times",
            "leave some out, or make several sites",
            place=f"{place} roads",
        )
    shapely.prepare(floor)
    for number, name in enumerate(assign_ids(site.roads, "road", "roads", place)):
        road, where = site.roads[number], f"{place} roads[{number}]"
        try:
            line, area = shapes.way(road.line, road.width)
        except InputError as error:
            raise error.located(place=where) from None
        inside = shapes.lines(shapely.intersection(shapely.LineString(line), floor))
        covered = shapes.polygons(shapely.intersection(area, floor, grid_size=shapes.GRID))
        parts = tuple(_area(part) for part in covered)
        way = Way(name, road.name, road.kind, road.width, line, inside, parts)
        found.append(open_border(floor, way, site.verge, site.fire_access))
    return tuple(found)


def _entrances(floor: shapely.Polygon, roads: Sequence[Way]) -> Iterator[Entrance]:
    """Where middle lines cross the outline, and their ends that stop short of it by less than
    half of their width and half a metre; not where streets beside the border run along it."""
    border = floor.exterior
    for number, road in enumerate(roads):
        line = shapely.LineString(road.line)
        parts = shapely.get_parts(shapely.intersection(line, border))
        met = shapely.get_coordinates(
            [part for part in parts if not road.mouths or part.geom_type == "Point"]
        )
        ends = road.line[[0, -1]]
        near = shapely.distance(shapely.points(ends), border) <= road.width / 2 + 0.5
        seen: list[Points] = []
        if road.mouths:
            near &= [_runs_across(line, point, border) for point in ends]
        for point in [*met, *ends[near]]:
            if all(np.hypot(*(point - other)) > road.width for other in seen):
                seen.append(point)
                yield Entrance(float(point[0]), float(point[1]), number)


def _runs_across(line: shapely.LineString, point: Points, border: shapely.LinearRing) -> bool:
    """Whether a line comes from farther off the border to a point of it."""
    at = line.project(shapely.Point(point))
    before, after = line.interpolate([max(at - ACROSS, 0.0), min(at + ACROSS, line.length)])
    return max(border.distance(before), border.distance(after)) > 0.5 * ACROSS
