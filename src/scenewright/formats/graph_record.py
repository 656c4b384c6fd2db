"""The scene graph and the visitors' tours of halls as written in a solution file."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import Field

from scenewright.brief.fields import Coordinate, Heading, Model, Number, Outline, Point, Whole
from scenewright.scene_graph import (
    Layer,
    Part,
    PlacedGroup,
    SceneGraph,
    Stop,
    Tour,
    Zone,
    ZoneLink,
)

Many = Field(max_length=100_000)
Index = Annotated[Whole, Field(ge=0, le=10**6)]


class ZoneRecord(Model):
    """A functional zone."""

    id: str
    name: str = ""
    space: str
    outline: Outline
    holes: Annotated[list[Outline], Many] = []


class LinkRecord(Model):
    """Two zones that must be mutually reachable, and how wide the passage must be."""

    space: str
    first: str
    second: str
    width: Number


class PartRecord(Model):
    """A pattern with its layers: count and two measures each."""

    pattern: str
    layers: Annotated[list[tuple[Index, Number, Number]], Many]
    sector: Number = 0.0


class GroupRecord(Model):
    """A group as laid out, with the ids of its pieces."""

    id: str
    demand: str
    space: str
    zone: str
    pattern: str
    pose: tuple[Coordinate, Coordinate, Heading]
    parts: Annotated[list[PartRecord], Many]
    objects: Annotated[list[str], Many]


class GraphRecord(Model):
    """The scene graph."""

    zones: Annotated[list[ZoneRecord], Many]
    links: Annotated[list[LinkRecord], Many]
    groups: Annotated[list[GroupRecord], Many]
    partitions: Annotated[list[str], Many] = []


class TourRecord(Model):
    """A visitor's route: points, clear widths, and the groups passed."""

    space: str
    points: Annotated[list[Point], Many]
    widths: Annotated[list[Number], Many]
    stops: Annotated[list[tuple[str, Index]], Many]


def graph_document(graph: SceneGraph) -> dict[str, Any]:
    """A scene graph as plain lists and numbers."""
    return {
        "zones": [zone._asdict() | _rings(zone) for zone in graph.zones],
        "links": [link._asdict() for link in graph.links],
        "groups": [
            group._asdict() | {"parts": [part._asdict() for part in group.parts]}
            for group in graph.groups
        ],
        "partitions": list(graph.partitions),
    }


def tour_document(tour: Tour) -> dict[str, Any]:
    """A tour as plain lists and numbers."""
    return {
        "space": tour.space,
        "points": np.round(tour.points, 3).tolist(),
        "widths": np.round(tour.widths, 3).tolist(),
        "stops": [list(stop) for stop in tour.stops],
    }


def graph_of(record: GraphRecord) -> SceneGraph:
    """The scene graph written in a record."""
    return SceneGraph(
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
        Part(part.pattern, tuple(Layer(*layer) for layer in part.layers), part.sector)
        for part in group.parts
    )
    values = dict(group) | {"parts": parts, "objects": tuple(group.objects)}
    return PlacedGroup(**values)


def _rings(zone: Zone) -> dict[str, Any]:
    return {"outline": zone.outline.tolist(), "holes": [hole.tolist() for hole in zone.holes]}
