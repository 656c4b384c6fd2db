"""The document of a house: rooms, walls, doors, windows, objects, lights, where an agent starts."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from scenewright.building.finishes import PLASTER, floor_of
from scenewright.core.catalog import Catalog, Material
from scenewright.core.scene import Scene
from scenewright.core.space import Opening, Space
from scenewright.formats.simulation.procthor.objects import lights_of, objects_of, vector
from scenewright.formats.simulation.procthor.walls import EXTERIOR, WallPiece, hinge_of, wall_pieces
from scenewright.formats.simulation.procthor.words import LIVING, ROOM_TYPES, nearest_asset
from scenewright.render.observations.floor import walkable_floor

Json = dict[str, Any]

SCHEMA = "1.0.0"
OWN = "scenewright"
"""The key of what the schema has no word for."""
PLAIN = "PureWhite"
"""A material of AI2-THOR's that takes a colour."""
SKY = "SkyAlbany"
STANDING = 0.95
"""Height of an agent's middle above the floor, as in ProcTHOR's houses, in metres."""
AGENTS = ("arm", "default", "locobot", "stretch")


def house_of(scene: Scene, catalog: Catalog) -> Json:
    """The document of a scene of rooms."""
    numbers = {space.id: number for number, space in enumerate(scene.spaces, 1)}
    rooms = {name: f"room|{number}" for name, number in numbers.items()} | {EXTERIOR: EXTERIOR}
    heights = {level.id: level.elevation for level in scene.levels}
    pieces = [*wall_pieces(scene)]
    names = [*_wall_names(pieces, numbers)]
    openings = [*_openings(scene, pieces, names, rooms)]
    return {
        "rooms": [_room(space, rooms[space.id], heights[space.level]) for space in scene.spaces],
        "walls": [
            _wall(piece, name, rooms[piece.owner])
            for piece, name in zip(pieces, names, strict=True)
        ],
        "doors": [row for kind, row in openings if kind != "window"],
        "windows": [row for kind, row in openings if kind == "window"],
        "objects": objects_of(scene, catalog, numbers),
        "proceduralParameters": {
            "ceilingMaterial": _material(PLASTER),
            "floorColliderThickness": 1.0,
            "lights": lights_of(scene, catalog),
            "receptacleHeight": 0.7,
            "reflections": [],
            "skyboxId": SKY,
        },
        "metadata": _metadata(scene),
    }


def _room(space: Space, name: str, floor: float) -> Json:
    corners = [vector(x, y, floor) for x, y in space.outline[::-1].tolist()]
    first = space.functions[0] if space.functions else ""
    return {
        "id": name,
        "roomType": ROOM_TYPES.get(first, LIVING),
        "floorPolygon": corners,
        "floorMaterial": _material(floor_of(space, False)),
        "ceilings": [],
        "children": [],
        OWN: {"id": space.id, "name": space.name, "functions": [*space.functions]},
    }


def _material(material: Material) -> Json:
    red, green, blue = (round(share, 4) for share in material.color)
    return {"name": PLAIN, "color": {"r": red, "g": green, "b": blue, "a": 1.0}}


def _wall_names(pieces: Sequence[WallPiece], numbers: dict[str, int]) -> Iterator[str]:
    """The ids of walls: owner and ends in plan, as in ProcTHOR's houses, unique."""
    taken: set[str] = set()
    for piece in pieces:
        low, high = np.minimum(piece.start, piece.end), np.maximum(piece.start, piece.end)
        ends = "|".join(f"{value:.2f}" for value in (*low, *high))
        wish = f"wall|{numbers.get(piece.owner, EXTERIOR)}|{ends}"
        names = (wish if count == 1 else f"{wish}|{count}" for count in range(1, len(taken) + 2))
        name = next(name for name in names if name not in taken)
        taken.add(name)
        yield name


def _wall(piece: WallPiece, name: str, room: str) -> Json:
    ends = (*piece.start.tolist(), piece.base), (*piece.end.tolist(), piece.base)
    low = [vector(*end) for end in ends]
    high = [vector(x, y, z + piece.height) for x, y, z in ends]
    return {
        "id": name,
        "roomId": room,
        "polygon": [*low, *high],
        "material": _material(PLASTER),
        "empty": False,
    }


def _openings(
    scene: Scene, pieces: Sequence[WallPiece], names: Sequence[str], rooms: dict[str, str]
) -> Iterator[tuple[str, Json]]:
    """The kind of each opening that is in a wall of a room, and its row."""
    sides: dict[str, list[tuple[WallPiece, str]]] = {}
    for piece, name in zip(pieces, names, strict=True):
        if piece.opening:
            sides.setdefault(piece.opening, []).append((piece, name))
    for one in scene.openings:
        found = sides.get(one.id, [])
        found.sort(key=lambda side: side[0].owner == EXTERIOR)  # a room comes first
        if found and found[0][0].owner != EXTERIOR:
            yield one.kind, _opening(one, found, rooms)


def _opening(one: Opening, sides: list[tuple[WallPiece, str]], rooms: dict[str, str]) -> Json:
    (piece, wall), (beyond, far) = sides[0], sides[-1]
    length = float(np.linalg.norm(piece.end - piece.start))
    low, high = (length - one.width) / 2, (length + one.width) / 2
    asset = nearest_asset(one.kind, one.width, one.head - one.sill)
    here = rooms[piece.owner]
    there = here if beyond.owner == EXTERIOR else rooms[beyond.owner]
    hinge, swing = hinge_of(one, piece)
    number, other = here.partition("|")[2], there.partition("|")[2]
    row: Json = {
        "id": f"{'window' if one.kind == 'window' else 'door'}|{number}|{other}|{one.id}",
        "assetId": asset.name,
        "room0": here,
        "room1": there,
        "wall0": wall,
        "wall1": far,
        "holePolygon": [vector(low, 0.0, one.sill), vector(high, 0.0, one.head)],
        "assetPosition": vector((low + high) / 2, 0.0, (one.sill + one.head) / 2),
        "scale": vector(one.width / asset.width, 1.0, (one.head - one.sill) / asset.height),
        "openable": one.kind == "door" and here != there,
        "openness": 0.0,
        OWN: {"id": one.id},
    }
    if one.kind != "window":
        row[OWN] |= {"hinge": hinge, "swing": swing}
    return row


def _metadata(scene: Scene) -> Json:
    """The schema, and an agent where most floor is free about it."""
    pose: Json = {
        "position": _start(scene),
        "rotation": vector(0.0, 0.0, 0.0),
        "horizon": 30,
        "standing": True,
    }
    lying = {key: value for key, value in pose.items() if key != "standing"}
    poses = {name: lying if name == "locobot" else pose for name in AGENTS}
    return {"schema": SCHEMA, "agent": pose, "agentPoses": poses, "roomSpecId": OWN, "warnings": {}}


def _start(scene: Scene) -> Json:
    level = scene.spaces[0].level
    floor = walkable_floor(scene, level, STANDING)
    free = np.where(floor.room >= 0, floor.clear.values, -np.inf)
    x, y = floor.centres(np.array([int(np.argmax(free))]))[0].tolist()
    return vector(x, y, floor.elevation + STANDING)
