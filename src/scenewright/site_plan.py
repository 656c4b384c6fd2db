"""The plan of a site: from a brief to ground that can be built on, roads and landmarks.

Everything the later stages rely on is checked here, once: an outline that is simple, a setback
that leaves something, landmarks that stand inside and apart, roads that reach the site.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple, Protocol

import numpy as np
import shapely

from scenewright import site_outlines as shapes
from scenewright.brief_site import Landmark, Site
from scenewright.errors import InputError
from scenewright.outlines import rings
from scenewright.site_fit import corners_of, main_direction
from scenewright.space import Points

OVERLAP = 0.02
LANDMARK_HEIGHT = 9.0
"""Height in metres of a landmark that does not say."""

Sizes = Callable[[str], tuple[float, float, float] | None]


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


class Standing(NamedTuple):
    """A landmark: its footprint, the box (x, y, heading, width, depth) of its model, height."""

    id: str
    name: str
    model: str
    footprint: Points
    box: tuple[float, float, float, float, float]
    height: float


class Entrance(NamedTuple):
    """Where a road or path crosses or meets the outline: the point and the index of the way."""

    x: float
    y: float
    way: int


class SitePlan(NamedTuple):
    """A valid site. ``area`` is that of the ground (outline less holes), ``buildable`` what is
    left of it by ``setback`` from the outline and holes, ``road_setback`` from roads and paths
    and ``spacing`` from landmarks; ``blocks`` are its connected pieces, the largest first."""

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


def site_plans(sites: Sequence[Site], sizes: Sizes | None = None) -> tuple[SitePlan, ...]:
    """The plans of the sites of a brief; ``sizes`` tells width, depth and height of a model.

    Raises InputError, with the place in the brief, for anything that cannot be built on.
    """
    told = named(sites, "site", "sites")
    return tuple(
        _plan(site, told[number], f"sites[{number}] '{site.name or told[number]}'", sizes)
        for number, site in enumerate(sites)
    )


def site_plan(site: Site, sizes: Sizes | None = None) -> SitePlan:
    """The plan of one site.

    >>> plan = site_plan(Site(outline=[(0, 0), (100, 0), (100, 60), (0, 60)],
    ...                       roads=[{"line": [(50, 0), (50, 60)], "width": 8}]))
    >>> [round(block.area) for block in plan.blocks], len(plan.entrances)
    ([2160, 2160], 2)
    """
    return site_plans([site], sizes)[0]


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


def _plan(site: Site, name: str, place: str, sizes: Sizes | None) -> SitePlan:
    try:
        floor = shapes.ground(site.outline, site.holes)
        built = shapes.inset(floor, site.setback)
    except InputError as error:
        raise error.located(place=place) from None
    named(site.buildings, "building", "buildings", place)
    roads = _roads(site, floor, place)
    landmarks = _landmarks(site, floor, place, sizes)
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
        blocks, roads, landmarks, tuple(_entrances(floor, roads)),
    )  # fmt: skip


def _block(part: shapely.Polygon) -> Block:
    outline, holes = rings(part)
    return Block(outline, holes, part.area, main_direction((outline, *holes)),
                 shapes.inscribed_radius(part))  # fmt: skip


def _area(part: shapely.Polygon) -> Area:
    return Area(*rings(part), part.area)


def _roads(site: Site, floor: shapely.Polygon, place: str) -> tuple[Way, ...]:
    found = []
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


def _landmarks(
    site: Site, floor: shapely.Polygon, place: str, sizes: Sizes | None
) -> tuple[Standing, ...]:
    found: list[Standing] = []
    for number, name in enumerate(named(site.landmarks, "landmark", "landmarks", place)):
        told = f"{place} landmarks[{number}]"
        try:
            found.append(_landmark(site.landmarks[number], name, sizes))
        except InputError as error:
            raise error.located(place=told) from None
        out = shapely.difference(shapely.Polygon(found[-1].footprint), floor)
        if out.area > OVERLAP:
            raise InputError(f"stands with {out.area:.2f} m² outside the site",
                             "move it in or leave it out", place=told)  # fmt: skip
    footprints = np.array([shapely.Polygon(row.footprint) for row in found], object)
    pairs = shapely.STRtree(footprints).query(footprints, predicate="intersects").T if found else ()
    for a, b in pairs:
        shared = shapely.intersection(footprints[a], footprints[b]).area if a < b else 0.0
        if shared > OVERLAP:
            raise InputError(
                f"overlaps landmarks[{a}] '{found[a].id}' by {shared:.2f} m²", "move one of them",
                place=f"{place} landmarks[{b}]",
            )  # fmt: skip
    return tuple(found)


def _landmark(row: Landmark, name: str, sizes: Sizes | None) -> Standing:
    """The footprint given, or that of a box of its own or its model's size where it stands."""
    size = row.size or (sizes or _shipped_size)(row.model) if row.at else None
    if row.at is not None and size is not None:
        box = (*row.at, row.heading, size[0], size[1])
        footprint = corners_of(box)
    elif row.outline is not None:
        footprint = rings(shapes.simple(row.outline, "its outline", 0.01))[0]
        box = _box_about(footprint, row.heading)
    else:
        fault = "has no outline, and its size is not known" if row.at else "has no place"
        raise InputError(fault, 'give "at" and "size", or "outline"')
    if row.outline is not None:
        footprint = rings(shapes.simple(row.outline, "its outline", 0.01))[0]
    height = row.height or (size[2] if size else LANDMARK_HEIGHT)
    return Standing(name, row.name or name, row.model, footprint, box, height)


def _shipped_size(model: str) -> tuple[float, float, float] | None:
    from scenewright.assets import shipped

    asset = shipped().assets.get(model)
    return (*asset.usual,) if asset else None


def _box_about(footprint: Points, heading: float) -> tuple[float, float, float, float, float]:
    """The least rectangle about a footprint; of its four fronts that nearest to ``heading``."""
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapely.Polygon(footprint)))
    x, y = frame[:4].mean(0)
    along, across = frame[1] - frame[0], frame[2] - frame[1]
    angle, long, wide = np.arctan2(along[1], along[0]), np.hypot(*along), np.hypot(*across)
    quarter = np.round((heading - angle) / (np.pi / 2))
    turned = (angle + quarter * np.pi / 2 + np.pi) % (2 * np.pi) - np.pi
    width, depth = (wide, long) if quarter % 2 == 0 else (long, wide)
    return float(x), float(y), float(turned), float(width), float(depth)
