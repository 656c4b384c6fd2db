"""glTF 2.0 binary: home -> level -> rooms with their pieces, walls, openings; one file.

Ours is z-up, glTF y-up: a point (x, y, z) is written as (x, z, -y), so importers that turn back
(Blender) show the plan as it was. Pieces of one asset and size share a mesh; materials are plain
metallic-roughness; lamps are lights. Names leave out signs that viewers drop: ``extras`` then has
the ``id``. Ceilings are left out, so that a viewer can look in from above.
Khronos Group, *glTF 2.0 Specification* (2021).
"""

from __future__ import annotations

import json
import os
import re
import struct
from collections.abc import Hashable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright._version import __version__
from scenewright.catalog import credits as authorship
from scenewright.core.atomic_file import atomic_write
from scenewright.core.catalog import Catalog, Material, Part
from scenewright.core.plan import Plan
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.geometry.prisms import face_normals, normals_of, row_keys
from scenewright.render.colour import linear_of
from scenewright.render.items import RenderItem, things
from scenewright.render.lamps import lamps_of

FLOAT, SHORT, INT = 5126, 5123, 5125
LIGHTS = "KHR_lights_punctual"
RESERVED = re.compile(r"[\[\].:/%@\"\\]+")
"""What three.js and Godot drop from the names of nodes."""
LONGEST = 63
"""Bytes of a name that Blender keeps."""
Json = dict[str, Any]
Floats = NDArray[np.float32]
Floats64 = NDArray[np.float64]


class GlbSurface(NamedTuple):
    """What the graphics card gets: positions and normals ``(n, 3)``, indices ``(3 m,)``."""

    positions: Floats
    normals: Floats
    indices: NDArray[np.uint32]


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path``; the file appears whole or not at all."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of

    with atomic_write(path) as partial:
        scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
        partial.write_bytes(encode_scene(scene, catalog))


def encode_scene(scene: Scene, catalog: Catalog) -> bytes:
    """The bytes of a GLB file: a header, a chunk of JSON, a chunk of numbers."""
    document, numbers = document_of(scene, catalog)
    text = json.dumps(document, ensure_ascii=False, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    total = 12 + 8 + len(text) + 8 + len(numbers)
    return b"".join(
        [
            struct.pack("<4sII", b"glTF", 2, total),
            struct.pack("<I4s", len(text), b"JSON"),
            text,
            struct.pack("<I4s", len(numbers), b"BIN\0"),
            numbers,
        ]
    )


def document_of(scene: Scene, catalog: Catalog) -> tuple[Json, bytes]:
    """The JSON document of a scene and the binary buffer it refers to."""
    found = things(scene, catalog)
    nodes = _tree(scene, found)
    meshes: list[Json] = []
    materials: dict[Material, int] = {}
    parts: list[Part] = []
    numbers: dict[Hashable, int] = {}
    places = {thing.name: thing for thing in found}
    for node in nodes:
        thing = places.get(node["name"]) if node.pop("drawn", False) else None
        if thing is None:
            continue
        if thing.key not in numbers:
            numbers[thing.key] = len(meshes)
            meshes.append(_mesh(thing, materials, parts))
        node["mesh"] = numbers[thing.key]
    lights = _light_nodes(nodes, found, catalog)
    names = [*_safe_names([node["name"] for node in nodes])]
    for node, name in zip(nodes, names, strict=True):
        if node["name"] != name and "extensions" not in node:
            node["extras"] = node.get("extras", {}) | {"id": node["name"]}
        node["name"] = name
    normals = normals_of([(part.vertices, part.faces) for part in parts])
    buffer, views, accessors = _pack_surfaces(
        [surface(part, corner) for part, corner in zip(parts, normals, strict=True)]
    )
    document = {
        "asset": _about(scene, catalog),
        "scene": 0,
        "scenes": [{"name": scene.name or "home", "nodes": [0]}],
        "nodes": nodes,
        "meshes": meshes,
        "materials": [_material(material) for material in materials],
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(buffer)}],
    }
    if lights:
        document |= {"extensionsUsed": [LIGHTS], "extensions": {LIGHTS: {"lights": lights}}}
    return document, buffer


def _safe_names(names: Sequence[str]) -> Iterator[str]:
    """Names that viewers keep as they are: unique, without signs they drop, not too long.

    >>> list(_safe_names(["living/wall-1", "living-wall-1", "sofa"]))
    ['living-wall-1', 'living-wall-1 2', 'sofa']
    """
    taken: set[str] = set()
    for name in names:
        plain, count = RESERVED.sub("-", name), 1
        safe = plain.encode()[:LONGEST].decode(errors="ignore")
        while safe in taken:
            count += 1
            end = f" {count}"
            safe = plain.encode()[: LONGEST - len(end)].decode(errors="ignore") + end
        taken.add(safe)
        yield safe


def _light_nodes(nodes: list[Json], found: Sequence[RenderItem], catalog: Catalog) -> list[Json]:
    """A node with a light below each lamp; the lights, each once. A ball of light gives its flux
    evenly: candela are lumens by 4 pi."""
    index = {node["name"]: number for number, node in enumerate(nodes)}
    lights: list[Json] = []
    for lamp in lamps_of(found, catalog):
        top = max(lamp.color)
        light = {
            "type": "point",
            "color": [round(share / top, 4) for share in lamp.color],
            "intensity": round(lamp.lumens * top / (4 * np.pi), 3),
        }
        if light not in lights:
            lights.append(light)
        x, y, z = lamp.at
        node = {"name": f"{lamp.item.name} light", "translation": [x, z, -y if y else 0.0]}
        _add(
            nodes,
            index[lamp.item.name],
            node | {"extensions": {LIGHTS: {"light": lights.index(light)}}},
        )
    return lights


def _about(scene: Scene, catalog: Catalog) -> Json:
    """The version, and who made the models on what terms."""
    found: Json = {"version": "2.0", "generator": f"Scenewright {__version__}"}
    made = authorship.credits_of(scene.pieces, catalog)
    authors = authorship.with_sources(made, scene.sources)
    if authors:
        found["copyright"] = authorship.line(authors)
        found["extras"] = {"credits": authorship.document(authors)}
    return found


def _tree(scene: Scene, found: Sequence[RenderItem]) -> list[Json]:
    """All nodes, the home first; children by index."""
    taken = {thing.name for thing in found}
    nodes: list[Json] = [
        {"name": _free(scene.name or "home", taken), "extras": {"category": "home"}}
    ]
    for level in scene.levels:
        extras = {"category": "level", "height": level.height, "elevation": level.elevation}
        name = _free(level.name or f"level {level.id or 1}", taken)
        node: Json = {"name": name, "extras": extras}
        if level.elevation:
            node["translation"] = [0.0, float(level.elevation), 0.0]
        _add(nodes, 0, node)
        _storey(nodes, len(nodes) - 1, [t for t in found if t.level == level.id], taken, name)
    return nodes


def _storey(
    nodes: list[Json], top: int, found: Sequence[RenderItem], taken: set[str], name: str
) -> None:
    """One level's branch: slab, spaces with their pieces, walls, openings, stairs."""
    rooms: dict[str, int] = {}
    for thing in found:
        if thing.kind in ("slab", "space"):
            index = _add(nodes, top, _node(thing))
            rooms[thing.space] = index
    for kind, label in (("wall", "walls"), ("opening", "openings"), ("stairs", "stairs")):
        mine = [thing for thing in found if thing.kind == kind]
        if mine:
            branch = _add(nodes, top, {"name": _free(f"{label} of {name}", taken)})
            for thing in mine:
                _add(nodes, branch, _node(thing))
    for thing in found:
        if thing.kind in ("surface", "piece"):
            _add(nodes, rooms.get(thing.space, top), _node(thing))


def _free(wish: str, taken: set[str]) -> str:
    """A name nobody has yet."""
    names = (wish if count == 1 else f"{wish} {count}" for count in range(1, len(taken) + 2))
    name = next(name for name in names if name not in taken)
    taken.add(name)
    return name


def _add(nodes: list[Json], parent: int, node: Json) -> int:
    nodes.append(node)
    nodes[parent].setdefault("children", []).append(len(nodes) - 1)
    return len(nodes) - 1


def _node(thing: RenderItem) -> Json:
    """A node at its place; a turn about our z is the same turn about glTF's y."""
    x, y, z = (float(v) for v in thing.at)
    node: Json = {"name": thing.name, "drawn": bool(thing.parts)}
    if thing.extras:
        node["extras"] = thing.extras
    if x or y or z:
        node["translation"] = [x, z, -y if y else 0.0]
    if thing.turn:
        half = thing.turn / 2
        node["rotation"] = [0.0, float(np.sin(half)), 0.0, float(np.cos(half))]
    return node


def _mesh(thing: RenderItem, materials: dict[Material, int], parts: list[Part]) -> Json:
    """One mesh with a primitive a part; the parts are put in a row, three accessors each."""
    primitives = []
    for part in thing.parts:
        accessor = 3 * len(parts)
        parts.append(part)
        primitives.append(
            {
                "attributes": {"POSITION": accessor, "NORMAL": accessor + 1},
                "indices": accessor + 2,
                "material": materials.setdefault(part.material, len(materials)),
            }
        )
    name = thing.extras.get("asset", thing.name) if thing.kind == "piece" else thing.name
    return {"name": str(name), "primitives": primitives}


def surface(part: Part, normals: Floats64) -> GlbSurface:
    """Vertices split where normals differ, in glTF's axes; faces without area are left out.

    >>> from scenewright.geometry.prisms import box, corner_normals
    >>> cube = box((0, 0, 0), (1, 1, 1))
    >>> cube = surface(Part(Material("grey", (0.5, 0.5, 0.5)), *cube), corner_normals(*cube))
    >>> cube.positions.shape, cube.indices.shape
    ((24, 3), (36,))
    """
    real = np.abs(face_normals(part.vertices, part.faces)).sum(1) > 0
    faces = part.faces[real]
    normals = normals[real].reshape(-1, 3)
    points = part.vertices[faces.reshape(-1)]
    keys = row_keys(np.column_stack([points * 1e5, normals * 1e3]))
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    rows = inverse.astype(np.uint32).reshape(-1, 3)
    whole = (rows != rows[:, [1, 2, 0]]).all(1)
    rows = rows[whole if whole.any() else slice(1)]
    turned = [
        np.ascontiguousarray(array[first][:, [0, 2, 1]] * [1, 1, -1], np.float32)
        for array in (points, normals)
    ]
    return GlbSurface(turned[0], turned[1], rows.reshape(-1))


def _pack_surfaces(surfaces: Sequence[GlbSurface]) -> tuple[bytes, list[Json], list[Json]]:
    """One buffer: all positions and normals, then 16-bit indices, then 32-bit ones."""
    vertices: list[bytes] = []
    narrow: list[bytes] = []
    wide: list[bytes] = []
    accessors: list[Json] = []
    ends = [0, 0, 0]
    for found in surfaces:
        for rows in (found.positions, found.normals):
            accessors.append(_accessor(0, ends[0], FLOAT, len(rows), "VEC3"))
            vertices.append(rows.tobytes())
            ends[0] += rows.nbytes
        accessors[-2]["min"] = found.positions.min(0).tolist()
        accessors[-2]["max"] = found.positions.max(0).tolist()
        short = len(found.positions) < 65535
        listed = found.indices.astype(np.uint16) if short else found.indices
        view, where = (1, narrow) if short else (2, wide)
        accessors.append(
            _accessor(view, ends[view], SHORT if short else INT, len(listed), "SCALAR")
        )
        where.append(listed.tobytes())
        ends[view] += listed.nbytes
    return _buffer([b"".join(rows) for rows in (vertices, narrow, wide)], accessors)


def _buffer(blocks: list[bytes], accessors: list[Json]) -> tuple[bytes, list[Json], list[Json]]:
    """The blocks end to end on four-byte bounds, with a view each; empty ones are skipped."""
    views: list[Json] = []
    moved: dict[int, int] = {}
    buffer = b""
    for number, block in enumerate(blocks):
        if block:
            moved[number] = len(views)
            view: Json = {
                "buffer": 0,
                "byteOffset": len(buffer),
                "byteLength": len(block),
                "target": 34963 if number else 34962,
            }
            views.append(view if number else view | {"byteStride": 12})
            buffer += block + b"\0" * (-len(block) % 4)
    for accessor in accessors:
        accessor["bufferView"] = moved[accessor["bufferView"]]
    return buffer, views, accessors


def _accessor(view: int, offset: int, component: int, count: int, kind: str) -> Json:
    return {
        "bufferView": view,
        "byteOffset": offset,
        "componentType": component,
        "count": count,
        "type": kind,
    }


def _material(material: Material) -> Json:
    """Plain metallic-roughness; sRGB colours become linear."""
    linear = [round(float(value), 5) for value in linear_of(np.array(material.color))]
    found: Json = {
        "name": material.name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [*linear, float(material.opacity)],
            "metallicFactor": float(material.metallic),
            "roughnessFactor": float(material.roughness),
        },
    }
    if material.opacity < 1:
        found["alphaMode"] = "BLEND"
    if material.emission > 0:
        glow = min(float(material.emission), 1.0)
        found["emissiveFactor"] = [round(value * glow, 5) for value in linear]
    return found
