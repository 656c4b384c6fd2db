"""The scene state of SceneEval (3DLG-HCVC), so that others' judges can score our scenes.

z up, metres. ``arch`` has a floor and a ceiling a room and its walls, with their openings as
``holes`` in the wall's frame: along it from its first point, and up. Each of ``object`` has a
model and a transform, a 4 x 4 matrix column by column, from the model's frame: y up and z to the
front, as in glTF, with the origin in the middle of the model's underside. The models are those of
our catalog at the sizes they stand in: ``modelId`` is ``scenewright.ASSET@WIDTHxDEPTHxHEIGHT``.
H. I. I. Tam and others, *SceneEval: Evaluating Semantic Coherence in Text-Conditioned 3D Indoor
Scene Synthesis* (2025); formats ``scene@1.0.2``, ``arch@1.0.2``.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from typing import Any

import numpy as np

from scenewright.core.atomic_file import write_atomically
from scenewright.core.catalog import Catalog, asset_of
from scenewright.core.plan import Plan
from scenewright.core.scene import STAIRS, Piece, Scene
from scenewright.core.solution import Solution
from scenewright.core.space import Opening, Space
from scenewright.formats.simulation.procthor import check
from scenewright.formats.simulation.procthor.walls import EXTERIOR, WallPiece, wall_pieces

__all__ = ["check", "state_of", "write"]

Json = dict[str, Any]
SOURCE = "scenewright"
THIN = 0.05
"""Thickness of floors, ceilings and one side of a wall, in metres."""
FRONT = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
"""From a model that is y up to ours, z up; its front, +z, looks along -y."""


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the state of a solution to ``path``; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of

    check(solution.brief)
    state = state_of(scene_of(solution, plan), catalog_of(solution.brief.catalogs))
    write_atomically(path, json.dumps(state, ensure_ascii=False, indent=1) + "\n")


def state_of(scene: Scene, catalog: Catalog) -> Json:
    """The scene state of a scene of rooms."""
    axes = {"up": [0, 0, 1], "front": [0, 1, 0]}
    name = scene.name or "scene"
    return {
        "format": "sceneState",
        "scene": {
            "version": "scene@1.0.2",
            "id": name,
            "unit": 1.0,
            **axes,
            "assetSource": [SOURCE],
            "arch": {"version": "arch@1.0.2", "id": name, **axes, **_architecture(scene)},
            "object": [*_objects(scene, catalog)],
            "modifications": [],
        },
        "selected": [],
    }


def _architecture(scene: Scene) -> Json:
    """Floors, ceilings and walls with numbers for ids, and the rooms they make."""
    heights = {level.id: level.elevation for level in scene.levels}
    elements: list[Json] = []
    for space in scene.spaces:
        for kind, z in (("Floor", 0.0), ("Ceiling", space.height)):
            points = [[*point, heights[space.level] + z] for point in space.outline.tolist()]
            elements.append({"type": kind, "roomId": space.id, "points": points, "depth": THIN})
    known = {one.id: one for one in scene.openings}
    for piece in wall_pieces(scene):
        if piece.owner != EXTERIOR:
            elements.append(_wall(piece, known))
    for number, element in enumerate(elements):
        element |= {"id": number, "materials": []}
    return {
        "coords2d": [0, 1],
        "scaleToMeters": 1,
        "defaults": {
            "Wall": {"depth": THIN, "extraHeight": 0.0},
            "Floor": {"depth": THIN},
            "Ceiling": {"depth": THIN},
        },
        "elements": elements,
        "regions": [_region(space, elements) for space in scene.spaces],
        **{key: [] for key in ("holes", "images", "materials", "textures")},
    }


def _wall(piece: WallPiece, known: dict[str, Opening]) -> Json:
    """A wall by two points on its inner face; its room lies on the left of the way."""
    ends = [[*end.tolist(), piece.base] for end in (piece.end, piece.start)]
    one = known.get(piece.opening)
    return {
        "type": "Wall",
        "roomId": piece.owner,
        "points": [[round(value, 5) for value in end] for end in ends],
        "height": piece.height,
        "depth": THIN,
        "holes": [] if one is None else [_hole(piece, one)],
    }


def _hole(piece: WallPiece, one: Opening) -> Json:
    length = float(np.linalg.norm(piece.end - piece.start))
    low, high = (length - one.width) / 2, (length + one.width) / 2
    return {
        "id": one.id,
        "type": "Window" if one.kind == "window" else "Door",
        "box": {"min": [round(low, 5), one.sill], "max": [round(high, 5), one.head]},
    }


def _region(space: Space, elements: list[Json]) -> Json:
    walls = [e["id"] for e in elements if e["type"] == "Wall" and e["roomId"] == space.id]
    return {"id": space.id, "type": ", ".join(space.functions) or "Other", "walls": walls}


def _objects(scene: Scene, catalog: Catalog) -> Iterator[Json]:
    heights = {level.id: level.elevation for level in scene.levels}
    floors = {space.id: heights[space.level] for space in scene.spaces}
    placed = [p for p in scene.pieces if p.function != STAIRS and p.space in floors]
    numbers = {piece.id: number for number, piece in enumerate(placed)}
    for piece in placed:
        number = numbers[piece.id]
        bearer = numbers.get(piece.on or "")
        yield {
            "id": piece.id,
            "index": number,
            "modelId": model_id(piece, catalog),
            "parentId": "" if bearer is None else piece.on,
            "parentIndex": number if bearer is None else bearer,
            "transform": transform_of(piece, floors[piece.space]),
        }


def model_id(piece: Piece, catalog: Catalog) -> str:
    """The model of a piece at its size, in millimetres."""
    asset = asset_of(piece, catalog)
    size = "x".join(str(round(1000 * length)) for length in piece.size)
    return f"{SOURCE}.{asset.id if asset else piece.category}@{size}"


def transform_of(piece: Piece, floor: float) -> Json:
    """From the model's frame to the scene's: its columns one after the other.

    The front, +z of the model, looks along the heading h: the turn about z is h + 90°.
    """
    half = (piece.pose.heading + np.pi / 2) / 2
    turn = np.array([[np.cos(2 * half), -np.sin(2 * half)], [np.sin(2 * half), np.cos(2 * half)]])
    matrix = np.eye(4)
    matrix[:3, :3] = np.block([[turn, np.zeros((2, 1))], [np.zeros((1, 2)), 1.0]]) @ FRONT
    matrix[:3, 3] = piece.pose.x, piece.pose.y, floor + piece.pose.z
    lying = np.sqrt(0.5)  # a quarter turn about x, and then one about z
    rotation = lying * np.array([np.cos(half), np.sin(half), np.sin(half), np.cos(half)])
    return {
        "rows": 4,
        "cols": 4,
        "data": (matrix.T.round(9) + 0.0).reshape(-1).tolist(),
        "rotation": (rotation.round(9) + 0.0).tolist(),
        "translation": (matrix[:3, 3] + 0.0).tolist(),
        "scale": [1.0, 1.0, 1.0],
    }
