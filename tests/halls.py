"""Halls built by hand: an exhibition of three zones, and one of any number of objects."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from shapely import LineString, Point, Polygon, box, union_all

from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
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

EAST, NORTH, WEST, SOUTH = 0.0, np.pi / 2, np.pi, -np.pi / 2
THICK = 0.15

Row = tuple[float, float, float]

ZONES = {
    "intro": ("Introduction", (0.0, 3.0, 8.0, 16.0)),
    "rome": ("The Roman town", (8.0, 3.0, 18.0, 16.0)),
    "shop": ("Museum shop", (18.0, 3.0, 24.0, 16.0)),
}
DEMANDS: dict[str, tuple[str, str, Size, str, str]] = {
    "cases": ("intro", "display_cabinet", Size(1.2, 0.45, 2.0), "wall", "Wall cases"),
    "model": ("intro", "box", Size(2.0, 1.4, 0.9), "single", "Model of the town"),
    "coins": ("rome", "display_cabinet", Size(0.9, 0.48, 1.8), "radiation", "Coins"),
    "stones": ("rome", "box", Size(0.7, 0.7, 1.1), "grid", ""),
    "books": ("shop", "bookcase", Size(1.2, 0.4, 1.6), "chain", ""),
    "till": ("shop", "desk", Size(1.8, 0.8, 0.76), "single", "Till"),
}
"""Zone, category, size, pattern and name of every group of the exhibition."""


def exhibition_brief(name: str = "Vindonissa · the camp and its town") -> Brief:
    """A hall of 24 by 16 metres; what lies in no zone is the foyer along its south side."""
    return Brief.model_validate(
        {
            "domain": "hall",
            "name": name,
            "rooms": [
                {
                    "id": "hall",
                    "name": "Exhibition hall",
                    "outline": [[0, 0], [24, 0], [24, 16], [0, 16]],
                    "holes": [[[12.8, 1.6], [13.2, 1.6], [13.2, 2.0], [12.8, 2.0]]],
                    "height": 4.5,
                    "doors": [
                        {"id": "way-in", "at": [3, 0], "width": 1.8, "use": "entrance"},
                        {
                            "id": "way-out",
                            "at": [21, 0],
                            "width": 1.8,
                            "use": "exit",
                            "swing": "out",
                        },
                        {"id": "delivery", "at": [24, 13.5], "width": 2.4, "swing": "slide"},
                    ],
                    "windows": [
                        {"at": [x, 16], "width": 2.0, "sill": 2.2, "height": 1.6}
                        for x in (4.0, 10.0, 13.0, 16.0, 21.0)
                    ],
                    "zones": [
                        {"id": key, "name": words, "outline": _ring(*bounds)}
                        for key, (words, bounds) in ZONES.items()
                    ],
                    "links": [
                        {"between": ["intro", "rome"], "width": 1.8},
                        {"between": ["rome", "shop"]},
                    ],
                    "demands": [
                        {
                            "id": key,
                            "name": row[4],
                            "category": row[1],
                            "zone": row[0],
                            "count": len(exhibition_rows()[key]),
                            "size": list(row[2]),
                        }
                        for key, row in DEMANDS.items()
                    ],
                    "people": 120,
                }
            ],
        }
    )


def exhibition_rows() -> dict[str, list[Row]]:
    """Pose x, y and heading of the objects of every group."""
    ring = np.arange(12) * np.pi / 6
    return {
        "cases": [(0.225, 5.0 + 1.5 * k, EAST) for k in range(6)],
        "model": [(4.6, 9.4, SOUTH)],
        "coins": [(13.0 + 2.3 * np.cos(a), 11.6 + 2.3 * np.sin(a), a) for a in ring.tolist()],
        "stones": [(9.9 + 2.0 * i, 4.4 + 1.7 * j, SOUTH) for j in range(2) for i in range(4)],
        "books": [(20.95 + 1.3 * i, 7.2 + 2.2 * j, SOUTH) for j in range(3) for i in range(2)],
        "till": [(22.2, 4.2, WEST)],
    }


def exhibition(name: str = "Vindonissa · the camp and its town") -> Solution:
    """A finished answer to :func:`exhibition_brief`."""
    pieces, groups = _placed(exhibition_rows())
    walls = [
        _partition(1, (8.0, 3.0), (8.0, 6.6)),
        _partition(2, (8.0, 9.0), (8.0, 16.0)),
        _partition(3, (18.0, 3.0), (18.0, 9.9)),
        _partition(4, (18.0, 12.1), (18.0, 16.0)),
    ]
    links = (ZoneLink("hall", "intro", "rome", 1.8), ZoneLink("hall", "rome", "shop", 1.2))
    zones = tuple(
        Zone(key, words, "hall", np.array(_ring(*bounds))) for key, (words, bounds) in ZONES.items()
    )
    everything = (*pieces, *walls)
    graph = HallLayout(zones, links, groups, tuple(wall.id for wall in walls))
    brief = exhibition_brief(name)
    return _solution(brief, everything, graph, (_tour(brief, everything, groups),))


def large_hall(count: int = 2000) -> Solution:
    """A hall of two zones with ``count`` like objects in rows."""
    across = int(np.ceil(np.sqrt(1.6 * count)))
    number = np.arange(count)
    places = np.column_stack([1.5 + 1.1 * (number % across), 3.0 + 1.8 * (number // across)])
    wide, deep = 1.1 * across + 2.0, 1.8 * (count // across + 1) + 4.0
    half = float(np.round(deep / 2, 1))
    outlines = {"south": (0.0, 0.0, wide, half), "north": (0.0, half, wide, deep)}
    brief = Brief.model_validate(
        {
            "domain": "hall",
            "name": "Reading room",
            "rooms": [
                {
                    "id": "hall",
                    "name": "Reading room",
                    "outline": _ring(0, 0, wide, deep),
                    "doors": [{"at": [wide / 2, 0], "width": 2.4, "id": "door"}],
                    "zones": [{"id": key, "outline": _ring(*row)} for key, row in outlines.items()],
                    "demands": [{"id": "seats", "category": "dining_chair", "count": count}],
                }
            ],
        }
    )
    pieces = tuple(
        Piece(
            f"hall/seats/dining_chair_{k}",
            "dining_chair",
            "dining_chair",
            "hall",
            Pose(x, y, 0.0, SOUTH),
            Size(0.5, 0.55, 0.9),
            "hall/seats",
            "seats",
        )
        for k, (x, y) in enumerate(places.tolist())
    )
    zones = tuple(Zone(k, k, "hall", np.array(_ring(*row))) for k, row in outlines.items())
    rows = tuple(Layer(across, 0.6, 1.25) for _ in range(count // across))
    group = PlacedGroup(
        "hall/seats",
        "seats",
        "hall",
        "south",
        "chain",
        (wide / 2, deep / 2, 0.0),
        (PatternPart("chain", rows),),
        tuple(piece.id for piece in pieces),
    )
    return _solution(brief, pieces, HallLayout(zones, (), (group,)), ())


def _placed(rows: dict[str, list[Row]]) -> tuple[list[Piece], tuple[PlacedGroup, ...]]:
    pieces: list[Piece] = []
    groups: list[PlacedGroup] = []
    for key, places in rows.items():
        zone, category, size, pattern, _ = DEMANDS[key]
        mine = [
            Piece(
                f"hall/{key}/{category}_{k}",
                category,
                "" if category == "box" else category,
                "hall",
                Pose(x, y, 0.0, heading),
                size,
                f"hall/{key}",
                key,
            )
            for k, (x, y, heading) in enumerate(places)
        ]
        pieces += mine
        middle = np.mean(np.array(places)[:, :2], axis=0)
        pose = (float(middle[0]), float(middle[1]), places[0][2])
        part = PatternPart(pattern, (Layer(len(places), 0.3, 2.0),))
        ids = tuple(piece.id for piece in mine)
        groups.append(PlacedGroup(f"hall/{key}", key, "hall", zone, pattern, pose, (part,), ids))
    return pieces, tuple(groups)


def _partition(number: int, start: tuple[float, float], end: tuple[float, float]) -> Piece:
    """A wall along a border, its back to the right of the way from start to end."""
    (x0, y0), (x1, y1) = start, end
    heading = float(np.arctan2(y1 - y0, x1 - x0) + np.pi / 2)
    pose = Pose((x0 + x1) / 2, (y0 + y1) / 2, 0.0, heading)
    size = Size(float(np.hypot(x1 - x0, y1 - y0)), THICK, 3.2)
    return Piece(
        f"hall/partitions/partition_{number}",
        "partition",
        "partition",
        "hall",
        pose,
        size,
        "hall/partitions",
        "partition",
    )


WAY = (
    (3.0, -0.1),
    (3.0, 1.6),
    (2.6, 4.0),
    (2.2, 7.0),
    (2.2, 10.5),
    (3.0, 12.8),
    (5.0, 13.2),
    (6.6, 12.0),
    (6.8, 9.6),
    (7.4, 7.9),
    (8.8, 7.8),
    (10.2, 7.9),
    (9.3, 9.6),
    (9.2, 12.0),
    (10.2, 14.3),
    (13.0, 15.1),
    (15.9, 14.2),
    (16.7, 11.6),
    (15.8, 8.7),
    (13.0, 7.9),
    (12.6, 7.3),
    (15.0, 7.4),
    (16.9, 8.4),
    (17.2, 10.6),
    (18.6, 11.1),
    (19.1, 13.0),
    (21.0, 13.7),
    (23.2, 13.4),
    (23.42, 11.6),
    (23.42, 8.0),
    (23.3, 6.0),
    (21.0, 5.9),
    (20.0, 4.9),
    (20.2, 3.2),
    (21.0, 1.6),
    (21.0, -0.1),
)
"""The way of a visitor, as a few points."""


def _tour(brief: Brief, pieces: Sequence[Piece], groups: Iterable[PlacedGroup]) -> Tour:
    points = smooth(WAY, 0.5)
    room = brief.rooms[0]
    bodies = [
        Polygon(corners(np.array([[p.pose.x, p.pose.y, p.pose.heading, *p.size[:2]]]))[0])
        for p in pieces
    ]
    doors = [Point(3.0, 0.0).buffer(0.9), Point(21.0, 0.0).buffer(0.9)]
    walls = Polygon(room.outline).exterior.difference(union_all(doors))
    solid = union_all([*bodies, *(Polygon(hole) for hole in room.holes), walls])
    widths = np.array([2.0 * solid.distance(Point(point)) for point in points])
    stops = []
    for group in groups:
        mine = union_all([b for b, p in zip(bodies, pieces, strict=True) if p.group == group.id])
        away = [mine.distance(Point(point)) for point in points]
        stops.append(Stop(group.id, int(np.argmin(away))))
    return Tour("hall", points, widths, tuple(sorted(stops, key=lambda stop: stop.at)))


def smooth(way: Sequence[tuple[float, float]], step: float) -> NDArray[np.float64]:
    """Points at most ``step`` metres apart on a line that cuts the corners of ``way`` (Chaikin
    1974), its ends kept."""
    line = np.asarray(way, dtype=float)
    for _ in range(3):
        quarters = [0.75 * line[:-1] + 0.25 * line[1:], 0.25 * line[:-1] + 0.75 * line[1:]]
        inner = np.stack(quarters, axis=1).reshape(-1, 2)
        line = np.vstack([line[:1], inner[1:-1], line[-1:]])
    whole = LineString(line)
    count = int(np.ceil(whole.length / step)) + 1
    return np.array([whole.interpolate(s).coords[0] for s in np.linspace(0, whole.length, count)])


def _ring(west: float, south: float, east: float, north: float) -> list[list[float]]:
    return [
        list(map(float, point))
        for point in box(west, south, east, north).normalize().exterior.coords[:0:-1]
    ]


def _solution(
    brief: Brief, pieces: Sequence[Piece], graph: HallLayout, tours: tuple[Tour, ...]
) -> Solution:
    values: dict[str, Any] = {"preset": "default", "solver": "guided-metropolis", "seed": 3}
    return Solution(
        brief=brief,
        pieces=tuple(pieces),
        patches=(),
        terms=(),
        left_out=(),
        energies={"hall": 1.5},
        version="0.1.0",
        brief_hash="0f" * 8,
        seconds=2.0,
        evaluations=1000,
        detail=HallDetail(graph, tours),
        **values,
    )
