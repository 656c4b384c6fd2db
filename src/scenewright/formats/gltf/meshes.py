"""Meshes of a document: the parts of each thing as few primitives as its materials allow."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np

from scenewright.core.catalog import Material, Part
from scenewright.formats.gltf.materials import MaterialTable, list_materials
from scenewright.formats.gltf.sheet import Sheet, keep_textures, lay_out, places_on
from scenewright.formats.gltf.surfaces import (
    GlbSurface,
    PackedSurfaces,
    join_surfaces,
    pack_surfaces,
    surface,
)
from scenewright.geometry.prisms import normals_of
from scenewright.render.textures.projection import coordinates_of
from scenewright.render.textures.table import texture_of

Json = dict[str, Any]
Key = Material | None
"""A material of its own, None for the sheet."""


class GlbMeshes(NamedTuple):
    """The meshes with their primitives, what these refer to, and the materials."""

    meshes: list[Json]
    packed: PackedSurfaces
    materials: MaterialTable


def make_meshes(named: Sequence[tuple[str, Sequence[Part]]], small: bool = False) -> GlbMeshes:
    """Meshes of lists of parts, each with a name: a primitive for the sheet and for every material
    of its own; ``small``: normals as bytes."""
    parts = [part for _, listed in named for part in listed]
    own = [kept for _, listed in named for kept in keep_textures(listed)]
    sheet = lay_out(part for part, kept in zip(parts, own, strict=True) if not kept)
    keys: list[Key] = [p.material if kept else None for p, kept in zip(parts, own, strict=True)]
    numbers = {key: number for number, key in enumerate(dict.fromkeys(keys))}
    surfaces = _surfaces(parts, own, sheet)
    meshes: list[Json] = []
    joined: list[GlbSurface] = []
    start = 0
    for name, listed in named:
        mine: dict[Key, list[GlbSurface]] = {}
        for key in keys[start : (start := start + len(listed))]:
            mine.setdefault(key, []).append(next(surfaces))
        primitives = [
            {"part": len(joined) + k, "material": numbers[key]} for k, key in enumerate(mine)
        ]
        joined += [join_surfaces(found) for found in mine.values()]
        meshes.append({"name": name, "primitives": primitives})
    packed = pack_surfaces(joined, small)
    for mesh in meshes:
        for primitive in mesh["primitives"]:
            primitive |= packed.primitives[primitive.pop("part")]
    return GlbMeshes(meshes, packed, list_materials(numbers, sheet))


def surfaces_of(parts: Sequence[Part]) -> Iterator[GlbSurface]:
    """The surfaces of parts, with places on the textures of their materials."""
    return _surfaces(parts, [True] * len(parts), lay_out(()))


def _surfaces(parts: Sequence[Part], own: Sequence[bool], sheet: Sheet) -> Iterator[GlbSurface]:
    """The surfaces of parts, with places on their own textures or on the sheet."""
    normals = normals_of([(part.vertices, part.faces) for part in parts])
    for part, kept, corner in zip(parts, own, normals, strict=True):
        row = texture_of(part.material.name) if kept else None
        if row is not None:
            repeats = coordinates_of(part, row.laying) / np.array(row.metres)[::-1]
            yield surface(part, corner, repeats * (1.0, -1.0), row.relief > 0)
        else:
            yield surface(part, corner, None if kept else places_on(sheet, part))
