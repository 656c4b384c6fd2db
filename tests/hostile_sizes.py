"""Documents that are costly for their size: many, deep, long, far apart or huge things."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator
from typing import Any

from hostile_files import Files, zipped

Json = Any
SQUARE = [[0, 0], [5, 0], [5, 4], [0, 4]]
HEAD = b"<?xml version='1.0'?><home version='7000'>"
MEBIBYTE = 2**20


def room(x: float = 0.0, y: float = 0.0, **more: Json) -> Json:
    """A room of 5 m by 4 m."""
    return {"outline": [[a + x, b + y] for a, b in SQUARE], "function": "other", **more}


def text(document: Json) -> bytes:
    """A document as bytes."""
    return json.dumps(document).encode()


def stars(count: int, corners: int = 24, function: str = "other") -> Json:
    """Rooms in a grid, each a star."""
    radius = [3.0 if k % 2 else 2.4 for k in range(corners)]
    angle = [math.tau * k / corners for k in range(corners)]
    ring = [(r * math.cos(a), r * math.sin(a)) for r, a in zip(radius, angle, strict=True)]
    return {
        "rooms": [
            {
                "outline": [[x + 7 * (k % 6), y + 7 * (k // 6)] for x, y in ring],
                "function": function,
            }
            for k in range(count)
        ]
    }


def costly_homes() -> Files:
    """Homes of Sweet Home 3D whose elements, attributes or entries are beyond counting."""
    end = b"</home>"
    names = b" ".join(b"a%d=''" % k for k in range(3_000_000))
    packed = HEAD + b"<room><point x='0' y='0'/></room>" * 1_800_000 + end
    return {
        "points.sh3d": zipped({"Home.xml": HEAD + b"<room>" + b"<point x='0' y='0'/>" * 2_000_000}),
        "packed.sh3d": zipped({"Home.xml": packed[: 60 * MEBIBYTE]}),
        "unknown.xml": HEAD + b"<a/>" * 10_000_000 + end,
        "attributes.xml": HEAD + b"<room " + names + b"/>" + end,
        "comment.xml": HEAD + b"<!--" + b"x" * 50_000_000 + b"-->" + end,
        "levels.xml": HEAD + b"".join(b"<level id='%d'/>" % k for k in range(100_000)) + end,
        "groups.xml": HEAD
        + (b"<furnitureGroup x='0' y='0' width='1' depth='1'>" * 40 + b"</furnitureGroup>" * 40)
        * 20_000
        + end,
        "furniture.xml": HEAD
        + b"<room>"
        + b"".join(b"<point x='%d' y='%d'/>" % p for p in ((0, 0), (500, 0), (500, 400), (0, 400)))
        + b"</room>"
        + b"<pieceOfFurniture name='x' x='200' y='200' width='50' depth='50'"
        b" height='50' movable='false'/>" * 100_000 + end,
        "wide-piece.xml": HEAD
        + b"<room>"
        + b"".join(b"<point x='%d' y='%d'/>" % p for p in ((0, 0), (500, 0), (500, 400), (0, 400)))
        + b"</room><pieceOfFurniture name='Bookcase' x='200' y='200' width='100000' depth='50'"
        b" height='50' movable='false'/>" + end,
    }


def costly_documents() -> Files:
    """Briefs and solutions as JSON."""
    piece = {
        "id": "a",
        "category": "bookcase",
        "space": "r",
        "pose": [0, 0, 0, 0],
        "size": [1000, 0.4, 2],
    }
    solution = {
        "format": "scenewright/solution",
        "version": 1,
        "energies": {},
        "pieces": [piece],
        "patches": [],
        "left_out": [],
        "terms": [],
        "brief": {"rooms": [room(id="r")]},
    }
    shelf = {"category": "bookcase", "at": [2.5, 2], "size": [30, 0.4, 30]}
    wall = {"start": [0, 0], "end": [5, 0]}
    keys = b",".join(b'"k%07d":0' % k for k in range(3_000_000))
    many = [dict(piece, id=f"p{k}", size=[1, 1, 1]) for k in range(100_001)]
    return {
        "long-shelf.json": text({"rooms": [room(fixed=[dict(shelf, size=[1000, 0.4, 2])])]}),
        "long-shelf.solution.json": text(solution),
        "many-pieces.solution.json": text(solution | {"pieces": many}),
        "deep.solution.json": b'{"format":"scenewright/solution","pieces":' + b"[" * 2_000_000,
        "keys.json": b"{" + keys + b"}",
        "lists.json": b'{"rooms":[' + b"[]," * 15_000_000 + b"[]]}",
        "objects.json": b'{"rooms":[' + b"{}," * 15_000_000 + b"{}]}",
        "objects.solution.json": b'{"format":"scenewright/solution","pieces":['
        + b"{}," * 15_000_000
        + b"{}]}",
        "objects.geojson": b'{"type":"FeatureCollection","features":['
        + b"{}," * 15_000_000
        + b"{}]}",
        "same-walls.json": text({"rooms": [room()], "walls": [wall] * 50_000}),
        "far-wall.json": text(
            {"rooms": [room()], "walls": [wall, {"start": [9000, 9000], "end": [9005, 9000]}]}
        ),
        "long-wall.json": text(
            {"rooms": [room()], "walls": [wall, {"start": [0, 0], "end": [9000, 0]}]}
        ),
        "far-room.json": text({"rooms": [room(), room(9000, 9000)]}),
        "sites-in-home.json": text({"rooms": [room()], "sites": [{"outline": SQUARE}]}),
        "fixed.json": text(
            {
                "rooms": [
                    room(
                        fixed=[{"category": "box", "at": [2.5, 2], "size": [0.5, 0.5, 0.5]}] * 2000
                    )
                ]
                * 1
            }
        ),
        "floors.geojson": text({"type": "FeatureCollection", "features": list(_floors(10_000))}),
        "outlines.geojson": text(
            {
                "type": "FeatureCollection",
                "features": [
                    {
                        "type": "Feature",
                        "properties": {"site": "yes"},
                        "geometry": {
                            "type": "Polygon",
                            "coordinates": [
                                [
                                    [8 + k * 1e-5, 50],
                                    [8.0001 + k * 1e-5, 50],
                                    [8 + k * 1e-5, 50.0001],
                                    [8 + k * 1e-5, 50],
                                ]
                            ],
                        },
                    }
                    for k in range(20_000)
                ],
            }
        ),
    }


def _floors(count: int) -> Iterator[Json]:
    """Rooms of an indoor map that each lie on two hundred levels."""
    for k in range(count):
        x, y = 8 + 1e-4 * (k % 100), 50 + 1e-4 * (k // 100)
        ring = [[x, y], [x + 5e-5, y], [x + 5e-5, y + 5e-5], [x, y + 5e-5], [x, y]]
        yield {
            "type": "Feature",
            "properties": {"indoor": "room", "level": "0-150"},
            "geometry": {"type": "Polygon", "coordinates": [ring]},
        }


def costly_answers() -> Files:
    """Sound briefs that are costly to lay out, build and draw."""
    shelf = {"category": "bookcase", "at": [2.5, 2], "size": [30, 0.4, 30]}
    ladder = [
        {
            "outline": [[3.1 * k, 0], [3.1 * k + 3, 0], [3.1 * k + 3, 3], [3.1 * k, 3]],
            "function": "other",
        }
        for k in range(60)
    ]
    return {
        "plain.json": text({"rooms": [room()]}),
        "stars.json": text(stars(36)),
        "shelf.json": text({"rooms": [room(fixed=[shelf])]}),
        "shelves.json": text(
            {
                "rooms": [
                    room(
                        fixed=[
                            {
                                "category": "bookcase",
                                "at": [2.5, 2],
                                "size": [20 + k / 200, 0.4, 30],
                            }
                            for k in range(200)
                        ]
                    )
                ]
            }
        ),
        "ladder.json": text({"rooms": ladder}),
        "corners.json": text(
            {
                "rooms": [
                    {
                        "function": "other",
                        "outline": [
                            [9 * math.cos(math.tau * k / 4000), 9 * math.sin(math.tau * k / 4000)]
                            for k in range(4000)
                        ],
                    }
                ]
            }
        ),
        "comb.json": text(
            {
                "rooms": [
                    {
                        "function": "other",
                        "outline": [
                            *([0.02 * k, 3.0 if k % 2 else 0.5] for k in range(1000)),
                            [20, 0],
                            [0, 0],
                        ],
                    }
                ]
            }
        ),
    }
