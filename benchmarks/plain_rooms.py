"""A plain referee of homes and halls: what is grossly wrong, from the saved JSON alone.

It shares nothing with the product's referee, and looks at less: solid things that stand on the
floor, outlines, doors, ways on a raster, and what the brief says stands or asks for. Its tolerances
are wide, so that what it finds is a fault by any rule.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any

import numpy as np
import shapely
from scipy import ndimage

Document = dict[str, Any]
Fault = tuple[str, ...]

GROSS = 0.05
"""Metres by which things overlap or stick out grossly."""
CELL = 0.05
"""Side of a cell of the raster on which one walks, in metres."""
DOOR, NEAR, FAR = 0.3, 0.5, 1.0
"""Metres before a door that are kept clear; from a way within which a thing was reached, and
beyond which it no longer is."""
LEAST_ROOM = 3.0
"""Square metres of a room that one must be able to enter."""
SOFT = ("rug", "curtain", "blind", "plant", "mat", "lamp", "picture", "mirror", "pendant")
SEATS = ("chair", "stool", "bench", "pouf", "seat")
TABLES = ("table", "desk", "counter", "island", "vanity", "piano", "checkout", "lectern")
USED = ("bed", "sofa", "wardrobe", "toilet", "bathtub", "shower", "fridge", "desk", "showcase")
"""Words of categories that are stepped over, sat on, sat at, and gone to."""


def is_of(category: str, words: tuple[str, ...]) -> bool:
    """Whether one of some words is in the name of a category."""
    return any(word in category for word in words)


def outline(piece: Document) -> shapely.Polygon:
    """What a piece covers in the plan: its footprint, else its box."""
    x, y, _, heading = piece["pose"]
    w, d = piece["size"][0] / 2, piece["size"][1] / 2
    local = np.array(piece.get("footprint") or [[-w, -d], [w, -d], [w, d], [-w, d]])
    cos, sin = np.cos(heading), np.sin(heading)
    return shapely.Polygon(local @ np.array([[sin, -cos], [cos, sin]]) + (x, y))


def is_thick(shape: shapely.Geometry, metres: float) -> bool:
    """Whether a disc of so many metres across fits into a shape."""
    return not shape.is_empty and not shapely.buffer(shape, -metres / 2).is_empty


def faults(document: Document) -> set[Fault]:
    """All that is grossly wrong with a solution of rooms."""
    brief, pieces = document["brief"], [p for p in document["pieces"] if min(p["size"]) > 0]
    rooms = {room["id"]: room for room in brief["rooms"]}
    floors = {k: shapely.Polygon(r["outline"], r["holes"]) for k, r in rooms.items()}
    shapes = [outline(piece) for piece in pieces]
    found = {*_lacking(document, rooms), *_changed(pieces, rooms)}
    found |= {*_overlaps(pieces, shapes, rooms), *_outside(pieces, shapes, floors)}
    found |= {*_blocked(pieces, shapes, rooms, floors), *_unreached(brief, pieces, shapes, floors)}
    return found


def _solid(piece: Document) -> bool:
    low, tall = piece["pose"][2], piece["size"][2]
    return low < 0.1 and tall > 0.3 and not is_of(piece["category"], SOFT)


def _overlaps(pieces: list[Document], shapes: list[Any], rooms: Document) -> Iterator[Fault]:
    """Pairs of solid things of one level that share ground; seats may go under tables."""
    solid = [k for k, piece in enumerate(pieces) if _solid(piece)]
    tree = shapely.STRtree([shapes[k] for k in solid])
    pairs = tree.query([shapes[k] for k in solid], predicate="intersects").T
    for i, j in sorted({(solid[a], solid[b]) for a, b in pairs if a < b}):
        one, other = pieces[i], pieces[j]
        names = one["category"], other["category"]
        if rooms[one["space"]]["level"] != rooms[other["space"]]["level"]:
            continue
        if one["on"] == other["id"] or other["on"] == one["id"]:
            continue
        seats = [is_of(name, SEATS) for name in names]
        if any(seats) and any(is_of(name, TABLES) for name in names) and not all(seats):
            continue
        if is_thick(shapely.intersection(shapes[i], shapes[j]), GROSS):
            yield ("overlap", *sorted((one["id"], other["id"])))


def _outside(pieces: list[Document], shapes: list[Any], floors: Document) -> Iterator[Fault]:
    for piece, shape in zip(pieces, shapes, strict=True):
        rest = shapely.difference(shape, floors[piece["space"]].buffer(GROSS))
        if not rest.is_empty:
            yield ("outside", piece["id"])
        if piece["pose"][2] < -GROSS:
            yield ("sunk", piece["id"])


def _doors(rooms: Document) -> Iterator[tuple[str, Document, np.ndarray, np.ndarray]]:
    """Doors of all rooms: room, door, middle on the outline, and direction along the wall."""
    for name, room in rooms.items():
        ring = np.array(room["outline"])
        for door in room["doors"]:
            at = np.array(door["at"])
            ends = list(zip(ring, np.roll(ring, -1, axis=0), strict=True))
            sides = [shapely.LineString(pair) for pair in ends]
            k = int(np.argmin([side.distance(shapely.Point(at)) for side in sides]))
            along = (ends[k][1] - ends[k][0]) / np.hypot(*(ends[k][1] - ends[k][0]))
            yield name, door, at, along


def _strip(at: Any, along: Any, width: float, depth: float) -> shapely.Polygon:
    """A box on both sides of a wall."""
    side, out = along * width / 2, np.array([-along[1], along[0]]) * depth
    return shapely.Polygon([at - side - out, at + side - out, at + side + out, at - side + out])


def _blocked(
    pieces: list[Document], shapes: list[Any], rooms: Document, floors: Document
) -> Iterator[Fault]:
    """Solid things right before a door that is no wide passage."""
    for name, door, at, along in _doors(rooms):
        if door["width"] > 1.2:
            continue
        zone = _strip(at, along, door["width"] - 0.1, DOOR) & floors[name]
        for piece, shape in zip(pieces, shapes, strict=True):
            same = rooms[piece["space"]]["level"] == rooms[name]["level"]
            if same and _solid(piece) and is_thick(shape & zone, GROSS):
                yield ("door", piece["id"], f"{name} {at[0]:.2f} {at[1]:.2f}")


def _unreached(
    brief: Document, pieces: list[Document], shapes: list[Any], floors: Document
) -> Iterator[Fault]:
    """Rooms and used things that nobody comes to who enters by a door from outside: every cell of
    a raster that keeps half a route, less 0.1 m, off all that stands there. What no way led to in
    the bare rooms is not told."""
    rooms = {room["id"]: room for room in brief["rooms"]}
    radius = max(brief["route_width"] / 2 - 0.1, 0.1)
    for level in {room["level"] for room in rooms.values()}:
        here = [k for k, p in enumerate(pieces) if rooms[p["space"]]["level"] == level]
        whole = {k: floors[k] for k, room in rooms.items() if room["level"] == level}
        doors = [row for row in _doors(rooms) if row[0] in whole]
        bars = [k for k in here if _solid(pieces[k]) and not is_of(pieces[k]["category"], SEATS)]
        walk = _Raster(whole, doors, radius)
        bare, now = walk.flood([]), walk.flood([shapes[k] for k in bars])
        for name, floor in whole.items():
            if floor.area > LEAST_ROOM and walk.meets(bare, floor) and not walk.meets(now, floor):
                yield ("room", name)
        for k in bars:
            if is_of(pieces[k]["category"], USED) and not walk.meets(now, shapes[k].buffer(FAR)):
                yield ("reach", pieces[k]["id"])


class _Raster:
    """The floor of a level as cells, with its doors and where one enters it."""

    def __init__(self, floors: Document, doors: list[Any], radius: float) -> None:
        gaps = [_strip(at, along, door["width"], 0.35) for _, door, at, along in doors]
        self.ground = shapely.union_all([*floors.values(), *gaps])
        outer = [
            gap
            for gap in gaps
            if sum(shapely.intersects(gap, floor) for floor in floors.values()) < 2
        ]
        west, south, east, north = self.ground.bounds
        self.x = np.arange(west - CELL, east + CELL, CELL)
        self.y = np.arange(south - CELL, north + CELL, CELL)
        self.radius = radius
        self.floor, self.start = self.cover(self.ground), self.cover(shapely.union_all(outer))

    def cover(self, shape: shapely.Geometry) -> np.ndarray:
        """The cells whose middles lie in a shape."""
        grid = np.meshgrid(self.x, self.y)
        shapely.prepare(shape)
        return np.asarray(shapely.contains_xy(shape, grid[0], grid[1]))

    def flood(self, solid: list[Any]) -> np.ndarray:
        """The cells that one comes to from the entrances, off all that is solid."""
        free = self.floor & ~self.cover(shapely.union_all(solid)) if solid else self.floor
        open_ = ndimage.distance_transform_edt(free) * CELL >= self.radius
        label, _ = ndimage.label(open_, np.ones((3, 3)))
        seen = np.unique(label[self.start & open_])
        return np.isin(label, seen[seen > 0])

    def meets(self, reached: np.ndarray, shape: shapely.Geometry) -> bool:
        """Whether a cell that is reached lies in a shape."""
        return bool((reached & self.cover(shape)).any())


def _changed(pieces: list[Document], rooms: Document) -> Iterator[Fault]:
    """Fixed items of the brief that are not where it has them."""
    there = {piece["id"]: piece for piece in pieces}
    for room in rooms.values():
        for item in room["fixed"]:
            piece = there.get(item["id"]) if item["id"] else None
            apart = np.abs(np.subtract(piece["pose"][:2], item["at"])).max() if piece else np.inf
            resized = np.abs(np.subtract(piece["size"], item["size"])).max() if piece else np.inf
            if item["id"] and max(apart, resized) > GROSS:
                yield ("given", item["id"])


def _lacking(document: Document, rooms: Document) -> Iterator[Fault]:
    """Demands of halls with too few objects or too many, and bedrooms without a bed; nothing where
    the solution says that something was left out there."""
    silent = {out["space"] for out in document["left_out"]}
    for name, room in rooms.items():
        here = [p for p in document["pieces"] if p["space"] == name]
        counts = Counter(p["function"] for p in here)
        for demand in room["demands"]:
            exact = demand["count"] is not None and demand.get("most") is None
            if name not in silent and exact and demand["count"] != counts[demand["id"]]:
                yield ("count", name, demand["id"])
        uses = room["function"] if isinstance(room["function"], list) else [room["function"]]
        sleeping = any("bedroom" in (use or "") for use in uses) and room["ask"] is None
        beds = any("bed" in p["category"].split("_") for p in here)
        if sleeping and not beds and name not in silent:
            yield ("bed", name)
