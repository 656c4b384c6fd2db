"""A scene in 3D as the page draws it: places of meshes, and what they are made of.

A mesh is told by its key and holds no material, so that flats of all palettes share it; what is
built of a level is one mesh a kind. Normals, and places on textures, are found by the page.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from scenewright.building.palettes import paint
from scenewright.core.catalog import Catalog, Material, Part
from scenewright.core.scene import Scene
from scenewright.formats.gltf.cameras import OPEN, stand_in
from scenewright.formats.gltf.sheet import keep_textures
from scenewright.geometry.mesh import Mesh, merge
from scenewright.render.items import RenderItem, things, to_level_coordinates
from scenewright.render.observations.ceilings import ceilings
from scenewright.render.public_rooms import fittings
from scenewright.render.skirting import skirting
from scenewright.render.textures.table import texture_of
from scenewright.studio.mesh_bytes import encode_mesh
from scenewright.studio.shapes import Json, Shapes
from scenewright.studio.texture_files import describe_texture

MOVABLE = ("piece", "opening", "stairs")
"""What is drawn one by one; all else of a level is one mesh a kind."""


class _Told(NamedTuple):
    """What was told so far, each once: materials, models, and models by what they are drawn of."""

    shapes: Shapes
    materials: dict[tuple[Material, bool], int]
    models: dict[Hashable, int]
    rows: list[tuple[str, list[int]]]


def tell_solid(scene: Scene, catalog: Catalog, shapes: Shapes) -> Json:
    """Rows of ``things`` (name, kind, number of the level, number of the model, x, y, z, turn,
    space), ``models`` (key of the mesh, numbers of the materials of its parts), ``materials``,
    ``textures``, and where an ``eye`` stands in each room (x, y, heading)."""
    found = [*things(replace(scene, palette=""), catalog)]
    found += [*_built(scene)]
    told = _Told(shapes, {}, {}, [])
    levels = {level.id: number for number, level in enumerate(scene.levels)}
    rows = [
        [one.name, _kind_of(one), levels[one.level], _add_model(told, one, scene.palette)]
        + [round(float(number), 4) for number in (*one.at, one.turn)]
        + ([one.space] if one.space else [])
        for one in _join_built(found)
    ]
    worn = [(material, textured) for material, textured in told.materials]
    textures = {row.name: row for m, kept in worn if kept and (row := texture_of(m.name))}
    return {
        "levels": [[level.id, level.elevation] for level in scene.levels],
        "things": rows,
        "models": told.rows,
        "materials": [_describe(material, kept) for material, kept in worn],
        "textures": {name: describe_texture(row) for name, row in textures.items()},
        "eyes": _eyes(scene),
    }


def _kind_of(one: RenderItem) -> str:
    """What a thing is: of an opening whether it is a door."""
    return str(one.extras.get("category", one.kind)) if one.kind == "opening" else one.kind


def _built(scene: Scene) -> Iterable[RenderItem]:
    inside = not any(OPEN & set(space.functions) for space in scene.spaces)
    return (*(ceilings(scene) if inside else ()), *fittings(scene), *skirting(scene))


def _eyes(scene: Scene) -> Json:
    """Where one stands best in each room."""
    found = {}
    for space in scene.spaces:
        stand = None if OPEN & set(space.functions) else stand_in(space, scene.pieces)
        if stand is not None:
            x, y, yaw = stand
            found[space.id] = [round(x, 3), round(y, 3), round(yaw + np.pi / 2, 4)]
    return found


def _join_built(found: Sequence[RenderItem]) -> Iterable[RenderItem]:
    """Things, with those that stand still for good joined by kind and level."""
    joined: dict[tuple[str, str], list[RenderItem]] = {}
    for one in found:
        if one.kind in MOVABLE:
            yield one
        else:
            joined.setdefault((one.kind, one.level), []).append(one)
    for (kind, level), rows in joined.items():
        parts: dict[Material, list[Part]] = {}
        for one in rows:
            for part in one.parts:
                moved = replace(part, vertices=to_level_coordinates(one, part.vertices))
                parts.setdefault(part.material, []).append(moved)
        whole = tuple(
            Part(material, *merge([Mesh(p.vertices, p.faces) for p in several]))
            for material, several in parts.items()
        )
        name = f"{kind} of {level}"
        yield rows[0]._replace(
            name=name, key=name, parts=whole, at=(0.0, 0.0, 0.0), turn=0.0, space=""
        )


def _add_model(told: _Told, one: RenderItem, palette: str) -> int:
    """The number of the model of a thing."""
    if one.key not in told.models:
        key = told.shapes.add_mesh(encode_mesh(one.parts))
        single = one.kind in MOVABLE  # what is built is large: all of it wears its textures
        kept = keep_textures(one.parts) if single else [True] * len(one.parts)
        worn = [
            told.materials.setdefault((part.material, textured), len(told.materials))
            for part, textured in zip(
                paint(one.parts, palette), map(_is_textured, one.parts, kept), strict=True
            )
        ]
        told.models[one.key] = len(told.rows)
        told.rows.append((key, worn))
    return told.models[one.key]


def _is_textured(part: Part, kept: bool) -> bool:
    row = texture_of(part.material.name)
    return row is not None and (kept or row.banded)


def _describe(material: Material, textured: bool) -> Json:
    """A material in sRGB, and the texture that multiplies its colour."""
    told: Json = {"name": material.name, "color": [round(c, 4) for c in material.color]}
    for name, usual in (("roughness", 0.8), ("metallic", 0.0), ("opacity", 1.0), ("emission", 0.0)):
        value = float(getattr(material, name))
        if value != usual:
            told[name] = round(value, 3)
    row = texture_of(material.name) if textured else None
    return told | ({"texture": row.name} if row is not None else {})
