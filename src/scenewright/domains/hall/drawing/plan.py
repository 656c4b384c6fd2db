"""Marks of halls beyond the scene: zones, links, groups and tours."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from typing import NamedTuple

import numpy as np
import shapely
from shapely import Geometry, LineString, Polygon

from scenewright.building.outlines import rings
from scenewright.building.plan import room_ids
from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.hall.drawing.narrow import length, narrow_places
from scenewright.domains.hall.drawing.route import route_mark
from scenewright.domains.hall.drawing.zones import (
    Key,
    borders_mark,
    links_mark,
    shape_of,
    tints,
    zones_mark,
)
from scenewright.domains.hall.hall_layout import HallLayout, Tour, Zone
from scenewright.domains.hall.measures import HEAD_HEIGHT
from scenewright.drawing.layers import PlanLayer
from scenewright.drawing.marks import PaperView, group, to_paper
from scenewright.drawing.pieces import footprint
from scenewright.drawing.signs import bubble

LEAST, STOPS = 0.01, 500
"""The least area and length worth drawing, in metres, and how many stops of a tour are drawn."""


class Halls(NamedTuple):
    """The scene graph and tours of a solution, ready to be drawn.

    ``colours`` of the zones by space and id; ``numbers`` of the groups, in the order of the
    tours; ``names`` given to groups in the brief; ``passage`` the least clear width wanted.
    """

    graph: HallLayout
    tours: tuple[Tour, ...]
    colours: dict[Key, str]
    numbers: dict[str, int]
    names: dict[str, str]
    passage: float


def halls_of(solution: Solution) -> Halls | None:
    """What to draw of a solution's scene graph; ``None`` if it has none."""
    detail, brief = solution.detail, solution.brief
    if detail is None:
        return None
    graph = detail.layout
    graph = graph._replace(zones=sound_zones(graph.zones))
    tours = sound_tours(detail.tours)
    stops = [stop.group for tour in tours for stop in tour.stops]
    known = {group.id for group in graph.groups}
    order = dict.fromkeys([*(s for s in stops if s in known), *(g.id for g in graph.groups)])
    demands = {
        (space, demand.id or demand.category): demand.name
        for space, room in zip(room_ids(brief), brief.rooms, strict=True)
        for demand in room.demands
        if demand.name
    }
    names = {g.id: demands.get((g.space, g.demand), "") for g in graph.groups}
    numbers = {name: number for number, name in enumerate(order, 1)}
    return Halls(graph, tours, tints(graph.zones), numbers, names, brief.passage_width)


def sound_zones(zones: Iterable[Zone]) -> tuple[Zone, ...]:
    """Zones as simple polygons: a file may hold outlines that cross themselves."""
    found = []
    for zone in zones:
        parts = [
            p
            for p in shapely.get_parts(shapely.make_valid(shape_of(zone))).tolist()
            if p.geom_type == "Polygon"
        ]
        whole = max(parts, key=lambda part: float(part.area), default=Polygon())
        if whole.area > LEAST:
            outline, holes = rings(whole)
            found.append(zone._replace(outline=outline, holes=holes))
    return tuple(found)


def sound_tours(tours: Iterable[Tour]) -> tuple[Tour, ...]:
    """Tours with a width at every point; those without a way are left out."""
    found = []
    for tour in tours:
        count = min(len(tour.points), len(tour.widths))
        stops = tuple(s for s in tour.stops if s.at < count)[:STOPS]
        cut = Tour(tour.space, tour.points[:count], np.maximum(tour.widths[:count], 0.0), stops)
        if count > 1 and length(cut) > LEAST:
            found.append(cut)
    return tuple(found)


def part_of(halls: Halls, spaces: Collection[str]) -> Halls:
    """The part within some spaces (those of a storey)."""
    graph = halls.graph
    part = HallLayout(
        tuple(zone for zone in graph.zones if zone.space in spaces),
        tuple(link for link in graph.links if link.space in spaces),
        tuple(group for group in graph.groups if group.space in spaces),
        graph.partitions,
    )
    tours = tuple(tour for tour in halls.tours if tour.space in spaces)
    return halls._replace(graph=part, tours=tours)


def floor_layers(
    view: PaperView, halls: Halls, walls: Geometry, pieces: Sequence[Piece]
) -> list[PlanLayer]:
    """Under the furniture: zones and their borders."""
    zones = halls.graph.zones
    standing = [Polygon(footprint(piece)) for piece in pieces if piece.category == "partition"]
    solid = shapely.union_all([walls, *standing])
    return [
        PlanLayer("Zones", zones_mark(view, zones, halls.colours)),
        PlanLayer("Borders of zones", borders_mark(view, zones, solid)),
    ]


def ways_layers(view: PaperView, halls: Halls, solid: Geometry) -> list[PlanLayer]:
    """Over the furniture: passages, routes, and the numbers of groups no route stops at;
    ``solid`` is what people cannot walk through."""
    graph = halls.graph
    links = links_mark(view, graph.links, graph.zones, solid, route_of(halls))
    routes = [
        route_mark(view, tour, halls.numbers, narrow_places(tour, halls.passage, solid))
        for tour in halls.tours
    ]
    stopped = {stop.group for tour in halls.tours for stop in tour.stops}
    others = [g for g in graph.groups if g.id not in stopped]
    bubbles = [
        bubble(halls.numbers[g.id], to_paper(view, g.pose[:2]), filled=False) for g in others
    ]
    return [
        PlanLayer("Passages", links),
        PlanLayer("Route", group(routes)),
        PlanLayer("Numbers", group(bubbles)),
    ]


def solid_of(walls: Geometry, pieces: Sequence[Piece], catalog: Catalog) -> Geometry:
    """Walls and objects, except carpets and swinging leaves, in plan metres."""
    flat = {name for name, kind in catalog.kinds.items() if kind.flat or kind.swings}
    bodies = [
        Polygon(footprint(piece))
        for piece in pieces
        if piece.pose.z < HEAD_HEIGHT and piece.category not in flat
    ]
    return shapely.union_all([walls, *bodies])


def route_of(halls: Halls) -> Geometry:
    """The tours as lines in plan metres."""
    return shapely.union_all([LineString(tour.points) for tour in halls.tours])


def list_labelled_spaces(halls: Halls, spaces: Sequence[Space]) -> list[tuple[Space, str]]:
    """What gets a label, with the colour under it: the zones, and spaces that have none."""
    zoned = {zone.space for zone in halls.graph.zones}
    height = {space.id: (space.level, space.height) for space in spaces}
    zones = [
        (
            Space(z.id, z.name or z.id, (), height[z.space][0], z.outline, z.holes),
            halls.colours[z.space, z.id],
        )
        for z in halls.graph.zones
        if z.space in height
    ]
    return zones + [(space, "#ffffff") for space in spaces if space.id not in zoned]
