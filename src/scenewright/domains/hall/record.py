"""The scene graph and the visitors' tours of halls as written in a solution file."""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any

import numpy as np
from pydantic import Field

from scenewright.building.plan import room_ids
from scenewright.building.standing import locked_rooms
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.fields import (
    Coordinate,
    Heading,
    Number,
    Outline,
    Point,
    StrictModel,
    Whole,
)
from scenewright.core.solution import Solution
from scenewright.domains.hall.hall_layout import (
    HallDetail,
    HallLayout,
    Layer,
    PatternPart,
    PlacedGroup,
    Stop,
    Tour,
    Zone,
    ZoneLink,
)

Many = Field(max_length=100_000)
Index = Annotated[Whole, Field(ge=0, le=10**6)]


class ZoneRecord(StrictModel):
    """A functional zone."""

    id: str
    name: str = ""
    space: str
    outline: Outline
    holes: Annotated[list[Outline], Many] = []


class LinkRecord(StrictModel):
    """Two zones that must be mutually reachable, and how wide the passage must be."""

    space: str
    first: str
    second: str
    width: Number


class PartRecord(StrictModel):
    """A pattern with its layers: count and two measures each."""

    pattern: str
    layers: Annotated[list[tuple[Index, Number, Number]], Many]
    sector: Number = 0.0
    aisle: Number = 0.0


class GroupRecord(StrictModel):
    """A group as laid out, with the ids of its pieces."""

    id: str
    demand: str
    space: str
    zone: str
    pattern: str
    pose: tuple[Coordinate, Coordinate, Heading]
    parts: Annotated[list[PartRecord], Many]
    objects: Annotated[list[str], Many]


class GraphRecord(StrictModel):
    """The scene graph."""

    zones: Annotated[list[ZoneRecord], Many]
    links: Annotated[list[LinkRecord], Many]
    groups: Annotated[list[GroupRecord], Many]
    partitions: Annotated[list[str], Many] = []


class TourRecord(StrictModel):
    """A visitor's route: points, clear widths, and the groups passed."""

    space: str
    points: Annotated[list[Point], Many]
    widths: Annotated[list[Number], Many]
    stops: Annotated[list[tuple[str, Index]], Many]


class DetailRecord(StrictModel):
    """What only solutions of halls hold: the layout of zones and groups, the tours, the least the
    energy of each space could be, and how far borders of zones were moved."""

    graph: GraphRecord | None = None
    tours: Annotated[list[TourRecord], Field(max_length=10_000)] = []
    floors: Annotated[dict[str, Number], Many] = {}
    shifts: Annotated[list[tuple[str, str, Number]], Many] = []


def detail_document(detail: HallDetail) -> dict[str, Any]:
    """The keys a solution of halls adds to its document."""
    tours = [tour_document(tour) for tour in detail.tours]
    shifts = {"shifts": [list(shift) for shift in detail.shifts]} if detail.shifts else {}
    graph = graph_document(detail.layout)
    return {"graph": graph, "tours": tours, "floors": dict(detail.floors)} | shifts


def detail_of(record: DetailRecord) -> HallDetail | None:
    """The halls of a document; ``None`` if it holds no layout."""
    if record.graph is None:
        return None
    tours = tuple(tour_of(tour) for tour in record.tours)
    floors = tuple(record.floors.items())
    return HallDetail(graph_of(record.graph), tours, floors, tuple(record.shifts))


def lock_halls(solution: Solution) -> Brief:
    """The brief to solve again: locked pieces are fixed items, and zones lie where they lay."""
    brief = locked_rooms(solution)
    ids = room_ids(brief)
    restore_zones = _make_zone_filler(solution)
    return brief.model_copy(update={"rooms": [*map(restore_zones, brief.rooms, ids)]})


def graph_document(graph: HallLayout) -> dict[str, Any]:
    """A scene graph as plain lists and numbers."""
    return {
        "zones": [zone._asdict() | _rings(zone) for zone in graph.zones],
        "links": [link._asdict() for link in graph.links],
        "groups": [
            group._asdict() | {"parts": [_part_document(part) for part in group.parts]}
            for group in graph.groups
        ],
        "partitions": list(graph.partitions),
    }


def _part_document(part: PatternPart) -> dict[str, Any]:
    """A pattern as plain lists and numbers; without aisles where it has none."""
    whole = part._asdict()
    return whole if part.aisle else {key: whole[key] for key in whole if key != "aisle"}


def tour_document(tour: Tour) -> dict[str, Any]:
    """A tour as plain lists and numbers."""
    return {
        "space": tour.space,
        "points": np.round(tour.points, 3).tolist(),
        "widths": np.round(tour.widths, 3).tolist(),
        "stops": [list(stop) for stop in tour.stops],
    }


def graph_of(record: GraphRecord) -> HallLayout:
    """The scene graph written in a record."""
    return HallLayout(
        tuple(
            Zone(z.id, z.name, z.space, np.array(z.outline), tuple(map(np.array, z.holes)))
            for z in record.zones
        ),
        tuple(ZoneLink(**dict(link)) for link in record.links),
        tuple(_group_of(group) for group in record.groups),
        tuple(record.partitions),
    )


def tour_of(record: TourRecord) -> Tour:
    """The tour written in a record."""
    points = np.array(record.points, np.float64).reshape(-1, 2)
    stops = tuple(Stop(*stop) for stop in record.stops)
    return Tour(record.space, points, np.array(record.widths, np.float64), stops)


def _group_of(group: GroupRecord) -> PlacedGroup:
    parts = tuple(
        PatternPart(
            part.pattern, tuple(Layer(*layer) for layer in part.layers), part.sector, part.aisle
        )
        for part in group.parts
    )
    values = dict(group) | {"parts": parts, "objects": tuple(group.objects)}
    return PlacedGroup(**values)


def _rings(zone: Zone) -> dict[str, Any]:
    return {"outline": zone.outline.tolist(), "holes": [hole.tolist() for hole in zone.holes]}


def _make_zone_filler(solution: Solution) -> Callable[[Room, str], Room]:
    """Gives a room the zones of the solution where its brief leaves them open."""
    zones = () if solution.detail is None else solution.detail.layout.zones
    outlines = {(zone.space, zone.id): zone.outline.tolist() for zone in zones}

    def restore_zones(room: Room, space: str) -> Room:
        drawn = [
            zone
            if (zone.outline is not None and not zone.slack) or (space, zone.id) not in outlines
            else zone.model_copy(update={"outline": [tuple(p) for p in outlines[space, zone.id]]})
            for zone in room.zones
        ]
        return room.model_copy(update={"zones": drawn})

    return restore_zones
