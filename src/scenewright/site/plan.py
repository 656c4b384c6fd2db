"""The plan of a site: from a brief to ground that can be built on, roads and landmarks.

Everything the later stages rely on is checked here, once: an outline that is simple, a setback
that leaves something, landmarks that stand inside and apart, roads that reach the site.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import NamedTuple, Protocol

import numpy as np
import shapely

from scenewright.brief import Brief
from scenewright.brief.site import Site
from scenewright.catalog import Catalog
from scenewright.errors import InputError
from scenewright.outlines import rings
from scenewright.site import outlines as shapes
from scenewright.site.fit import main_direction
from scenewright.site.models import Standing, building_models, landmarks_of
from scenewright.space import Points
from scenewright.stock import catalog_of


class Named(Protocol):
    """What has an id and a name, either of which may be empty."""

    @property
    def id(self) -> str:
        """Given by the user, or empty."""

    @property
    def name(self) -> str:
        """What people call it."""


class Area(NamedTuple):
    """A polygon: ``outline`` (n, 2) counter-clockwise, ``holes`` clockwise, square metres."""

    outline: Points
    holes: tuple[Points, ...]
    area: float


class Block(NamedTuple):
    """One connected piece of ground that can be built on. ``direction`` is that of most of its
    edges, in [0, pi/2); ``radius`` of the largest circle in it."""

    outline: Points
    holes: tuple[Points, ...]
    area: float
    direction: float
    radius: float


class Way(NamedTuple):
    """A road or path: its middle line ``(n, 2)`` as given, the parts of it inside the site, and
    the areas of the site it covers."""

    id: str
    name: str
    kind: str
    width: float
    line: Points
    inside: tuple[Points, ...]
    areas: tuple[Area, ...]


class Entrance(NamedTuple):
    """Where a road or path crosses or meets the outline: the point and the index of the way."""

    x: float
    y: float
    way: int


class SitePlan(NamedTuple):
    """A valid site. ``area`` is that of the ground (outline less holes), ``buildable`` what is
    left of it by ``setback`` from the outline and holes, ``road_setback`` from roads and paths
    and ``spacing`` from landmarks; ``blocks`` are its connected pieces, the largest first.
    ``models`` are the assets that draw the buildings asked for, a row each."""

    id: str
    name: str
    outline: Points
    holes: tuple[Points, ...]
    area: float
    buildable: float
    blocks: tuple[Block, ...]
    roads: tuple[Way, ...]
    landmarks: tuple[Standing, ...]
    entrances: tuple[Entrance, ...]
    models: tuple[str, ...] = ()


def plans_of(brief: Brief) -> tuple[SitePlan, ...]:
    """The plans of the sites of a brief, with the models it names."""
    return site_plans(brief.sites, catalog_of(brief.catalogs))


def site_plans(sites: Sequence[Site], catalog: Catalog | None = None) -> tuple[SitePlan, ...]:
    """The plans of some sites; ``catalog`` holds the models of landmarks (else shipped ones).

    Raises InputError, with the place in the brief, for anything that cannot be built on.
    """
    models = catalog_of(()) if catalog is None else catalog
    told = named(sites, "site", "sites")
    return tuple(
        _plan(site, told[number], f"sites[{number}] '{site.name or told[number]}'", models)
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


def named(rows: Sequence[Named], word: str, key: str, place: str = "") -> tuple[str, ...]:
    """The id of every row: the one given, else its name in plain letters, else ``road-3``;
    InputError if one is given twice."""
    given = Counter(row.id for row in rows if row.id)
    taken, found = set(given), []
    for number, row in enumerate(rows):
        if row.id and given[row.id] > 1:
            told = f"{place} {key}[{number}]".strip()
            raise InputError(f"the id '{row.id}' is used twice", "give each its own", place=told)
        wish = re.sub(r"[\W_]+", "-", row.name.casefold()).strip("-") or f"{word}-{number + 1}"
        fresh = (wish if k == 1 else f"{wish}-{k}" for k in range(1, len(taken) + 2))
        found.append(row.id or next(name for name in fresh if name not in taken))
        taken.add(found[-1])
    return tuple(found)


def _plan(site: Site, name: str, place: str, catalog: Catalog) -> SitePlan:
    try:
        floor = shapes.ground(site.outline, site.holes)
        built = shapes.inset(floor, site.setback)
    except InputError as error:
        raise error.located(place=place) from None
    named(site.buildings, "building", "buildings", place)
    models = building_models(site.buildings, place, catalog)
    roads = _roads(site, floor, place)
    marks = named(site.landmarks, "landmark", "landmarks", place)
    landmarks = landmarks_of(site.landmarks, marks, floor, place, catalog)
    taken = [
        shapes.kept_free([shapes.way(road.line, road.width)[1] for road in roads],
                         site.road_setback),
        shapes.kept_free([shapely.Polygon(row.footprint) for row in landmarks], site.spacing),
    ]  # fmt: skip
    blocks = tuple(_block(part) for part in shapes.less(built, taken))
    if not blocks:
        raise InputError(
            "roads, paths and landmarks with their distances leave nothing to build on",
            "lower road_setback or spacing, or take some out", place=place,
        )  # fmt: skip
    outline, holes = rings(floor)
    return SitePlan(
        name, site.name or name, outline, holes, floor.area, sum(b.area for b in blocks),
        blocks, roads, landmarks, tuple(_entrances(floor, roads)), models,
    )  # fmt: skip


def _block(part: shapely.Polygon) -> Block:
    outline, holes = rings(part)
    return Block(outline, holes, part.area, main_direction((outline, *holes)),
                 shapes.inscribed_radius(part))  # fmt: skip


def _area(part: shapely.Polygon) -> Area:
    return Area(*rings(part), part.area)


def _roads(site: Site, floor: shapely.Polygon, place: str) -> tuple[Way, ...]:
    found = []
    if shapes.crossings([np.array(r.line) for r in site.roads]) > shapes.MOST_CROSSINGS:
        raise InputError(
            f"the roads cross each other more than {shapes.MOST_CROSSINGS} times",
            "leave some out, or make several sites", place=f"{place} roads",
        )  # fmt: skip
    shapely.prepare(floor)
    for number, name in enumerate(named(site.roads, "road", "roads", place)):
        road, told = site.roads[number], f"{place} roads[{number}]"
        try:
            line, area = shapes.way(road.line, road.width)
        except InputError as error:
            raise error.located(place=told) from None
        away = shapely.distance(floor, area)
        if away > shapes.TOUCH:
            raise InputError(f"lies {away:.2f} m outside the site", "leave it out", place=told)
        inside = shapes.lines(shapely.intersection(shapely.LineString(line), floor))
        covered = shapes.polygons(shapely.intersection(area, floor, grid_size=shapes.GRID))
        parts = tuple(_area(part) for part in covered)
        found.append(Way(name, road.name, road.kind, road.width, line, inside, parts))
    return tuple(found)


def _entrances(floor: shapely.Polygon, roads: Sequence[Way]) -> Iterator[Entrance]:
    """Where middle lines cross the outline, and their ends that stop short of it by less than
    half of their width and half a metre."""
    border = floor.exterior
    for number, road in enumerate(roads):
        line = shapely.LineString(road.line)
        met = shapely.get_coordinates(shapely.intersection(line, border))
        ends = road.line[[0, -1]]
        near = shapely.distance(shapely.points(ends), border) <= road.width / 2 + 0.5
        seen: list[Points] = []
        for point in [*met, *ends[near]]:
            if all(np.hypot(*(point - other)) > road.width for other in seen):
                seen.append(point)
                yield Entrance(float(point[0]), float(point[1]), number)
