"""Pieces as objects, those that stand on another among its children; lamps as lights."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from scenewright.core.catalog import Catalog, asset_of
from scenewright.core.scene import STAIRS, Piece, Scene
from scenewright.formats.simulation.procthor.words import object_type
from scenewright.render.items import things, to_level_coordinates
from scenewright.render.lamps import lamps_of

Json = dict[str, Any]

OWN = "scenewright"
FULL = 1000.0
"""Lumens of a light of intensity 1."""
REACH = 15.0
"""How far a light reaches, as in ProcTHOR's houses, in metres."""
SHADOW = {
    "type": "Soft",
    "strength": 1.0,
    "normalBias": 0.0,
    "bias": 0.05,
    "nearPlane": 0.2,
    "resolution": "FromQualitySettings",
}
WHITE = {"r": 1.0, "g": 1.0, "b": 1.0, "a": 1.0}


def vector(x: float, y: float, z: float) -> Json:
    """A point of ours in their axes, to a tenth of a millimetre.

    >>> vector(1.0, 2.0, 0.5)
    {'x': 1.0, 'y': 0.5, 'z': 2.0}
    """
    return {"x": round(x, 4) + 0.0, "y": round(z, 4) + 0.0, "z": round(y, 4) + 0.0}


def yaw_of(heading: float) -> float:
    """The turn about y, in degrees clockwise seen from above, of a front along a heading.

    >>> yaw_of(0.0), yaw_of(np.pi / 2), round(yaw_of(np.pi), 6)
    (90.0, 0.0, 270.0)
    """
    return round(float((90.0 - np.rad2deg(heading)) % 360.0), 4) % 360.0


def objects_of(scene: Scene, catalog: Catalog, rooms: Mapping[str, int]) -> list[Json]:
    """The objects of all rooms; ``rooms`` gives their numbers by id."""
    spaces = {space.id: space for space in scene.spaces}
    heights = {level.id: level.elevation for level in scene.levels}
    standing = {piece.id for piece in scene.pieces}
    counts: Counter[int] = Counter()
    rows: dict[str, Json] = {}
    for piece in scene.pieces:
        if piece.function != STAIRS and piece.space in spaces:
            number = rooms[piece.space]
            floor = heights[spaces[piece.space].level]
            rows[piece.id] = _object(piece, catalog, number, counts[number], floor)
            counts[number] += 1
    tops: list[Json] = []
    for piece in scene.pieces:
        if piece.id in rows:
            bearer = rows.get(piece.on or "") if piece.on in standing else None
            (bearer["children"] if bearer else tops).append(rows[piece.id])
    return tops


def _object(piece: Piece, catalog: Catalog, room: int, count: int, floor: float) -> Json:
    """The middle of the box a piece fills, and how it is turned."""
    x, y, z, heading = piece.pose
    asset = asset_of(piece, catalog)
    return {
        "id": f"{object_type(piece.category)}|{room}|{count}",
        "assetId": asset.id if asset else piece.category,
        "position": vector(x, y, floor + z + piece.size.height / 2),
        "rotation": {"x": 0.0, "y": yaw_of(heading), "z": 0.0},
        "kinematic": piece.on is None,
        "children": [],
        OWN: {
            "id": piece.id,
            "category": piece.category,
            "asset": piece.asset,
            "size": [round(length, 4) for length in piece.size],
            "group": piece.group,
            "function": piece.function,
        },
    }


def lights_of(scene: Scene, catalog: Catalog) -> list[Json]:
    """The sun, and a point of light in every lamp."""
    sun: Json = {
        "id": "DirectionalLight",
        "type": "directional",
        "position": vector(0.84, -1.09, 0.1855),
        "rotation": {"x": 43.375, "y": -3.902, "z": -63.618},
        "intensity": 0.35,
        "indirectMultiplier": 1.0,
        "rgb": WHITE,
        "shadow": SHADOW | {"bias": 0.0},
    }
    return [sun, *_lamps(scene, catalog)]


def _lamps(scene: Scene, catalog: Catalog) -> Iterator[Json]:
    heights = {level.id: level.elevation for level in scene.levels}
    for number, lamp in enumerate(lamps_of(things(scene, catalog), catalog)):
        x, y, z = to_level_coordinates(lamp.item, np.array([lamp.at]))[0].tolist()
        top = max(lamp.color)
        red, green, blue = (round(share / top, 4) for share in lamp.color)
        yield {
            "id": f"light_{number}",
            "type": "point",
            "position": vector(x, y, heights[lamp.item.level] + z),
            "intensity": round(lamp.lumens / FULL, 4),
            "range": REACH,
            "rgb": {"r": red, "g": green, "b": blue, "a": 1.0},
            "shadow": SHADOW,
        }
