"""Hand-made halls for the tests of the referee: zones, groups and tours whose truth is known."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.kind import Kind
from scenewright.core.report import Report
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.domains import check
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

NORTH, SOUTH, EAST, WEST = math.pi / 2, -math.pi / 2, 0.0, math.pi

CATALOG = Catalog(
    {
        kind.category: kind
        for kind in (
            Kind("case", access=("front", "back", "left", "right")),
            Kind("shelf", access=("front",)),
            Kind("plinth"),
            Kind("partition"),
            Kind("picture", support="wall"),
        )
    }
)


def box(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def zone(name: str, outline, space: str = "h") -> Zone:
    return Zone(name, name, space, np.array(outline, float))


def piece(category: str, x: float, y: float, w: float, d: float, h: float = 1.0, **more) -> Piece:
    named = more.pop("id", f"{category}@{x:g},{y:g}")
    pose = Pose(x, y, more.pop("z", 0.0), more.pop("heading", NORTH))
    return Piece(named, category, "", more.pop("space", "h"), pose, Size(w, d, h), **more)


def wall(x0: float, y0: float, x1: float, y1: float, thick: float = 0.2, **more) -> Piece:
    """A partition along a line."""
    heading = math.atan2(y1 - y0, x1 - x0) + math.pi / 2
    named = {"id": f"wall@{x0:g},{y0:g}", "heading": heading, "group": "h/partitions"} | more
    length = math.hypot(x1 - x0, y1 - y0)
    return piece("partition", (x0 + x1) / 2, (y0 + y1) / 2, length, thick, 2.5, **named)


def group(name: str, zone_id: str, *pieces: Piece, space: str = "h") -> PlacedGroup:
    objects = tuple(p.id for p in pieces)
    part = (PatternPart("grid", (Layer(len(objects), 1.0, 1.0),)),)
    return PlacedGroup(name, name, space, zone_id, "grid", (0.0, 0.0, 0.0), part, objects)


def tour(*points: tuple[float, float], space: str = "h") -> Tour:
    return Tour(space, np.array(points, float), np.ones(len(points)), (Stop("none", 0),))


def hall_brief(outline, doors=(), **more) -> Brief:
    wanted = {
        "id": "h",
        "name": "Gallery",
        "function": "other",
        "outline": outline,
        "doors": list(doors),
    }
    top = {key: more.pop(key) for key in ("route_width", "passage_width") if key in more}
    return Brief.model_validate({"domain": "hall", "rooms": [wanted | more], **top})


def answer(brief: Brief, pieces=(), zones=(), links=(), groups=(), tours=()) -> Solution:
    """A solution whose scene graph holds these zones, links (two ids and a width) and groups."""
    partitions = tuple(p.id for p in pieces if p.category == "partition")
    joined = tuple(ZoneLink("h", *link) for link in links)
    graph = HallLayout(tuple(zones), joined, tuple(groups), partitions)
    return Solution(
        brief,
        tuple(pieces),
        (),
        (),
        (),
        {},
        "",
        "",
        0,
        "",
        "",
        0.0,
        0,
        HallDetail(graph, tuple(tours)),
    )


def judge(solution: Solution) -> Report:
    return check(solution, catalog=CATALOG)


def kinds(report: Report) -> set[str]:
    return {found.kind for found in report.findings}


def _spun(points, angle: float, shift):
    cos, sin = math.cos(angle), math.sin(angle)
    return np.asarray(points, float) @ np.array([[cos, sin], [-sin, cos]]) + shift


def turned(solution: Solution, angle: float, shift=(0.0, 0.0)) -> Solution:
    """The same answer elsewhere: brief, pieces, zones and tours turned about the origin."""
    document = solution.brief.model_dump()
    for room in document["rooms"]:
        room["outline"] = _spun(room["outline"], angle, shift).tolist()
        for door in room["doors"]:
            door["at"] = _spun(door["at"], angle, shift).tolist()
        for listed in room["zones"]:
            listed["outline"] = _spun(listed["outline"], angle, shift).tolist()
    pieces = tuple(
        replace(p, pose=Pose(*_spun(p.pose[:2], angle, shift), p.pose.z, p.pose.heading + angle))
        for p in solution.pieces
    )
    zones = tuple(
        z._replace(outline=_spun(z.outline, angle, shift)) for z in solution.detail.layout.zones
    )
    tours = tuple(t._replace(points=_spun(t.points, angle, shift)) for t in solution.detail.tours)
    return replace(
        solution,
        brief=Brief.model_validate(document),
        pieces=pieces,
        detail=HallDetail(solution.detail.layout._replace(zones=zones), tours),
    )
