"""glTF 2.0 binary: home -> level -> rooms with their pieces, walls, openings; one file.

Ours is z-up, glTF y-up: a point (x, y, z) is written as (x, z, -y), so importers that turn back
(Blender) show the plan as it was. Pieces of one asset and size share a mesh; materials are
metallic-roughness, with seamless textures (:mod:`scenewright.render.textures`); lamps are lights.
What moves - leaves, sashes, doors, drawers - is a node of its own with its hinge as origin.
Names leave out signs that viewers drop: ``extras`` then has the ``id``. Ceilings are left out, so
that a viewer can look in from above.
Khronos Group, *glTF 2.0 Specification* (2021).
"""

from __future__ import annotations

import json
import os
import re
import struct
from collections.abc import Hashable, Iterator, Sequence
from typing import Any

import numpy as np

from scenewright._version import __version__
from scenewright.catalog import credits as authorship
from scenewright.core.atomic_file import atomic_write
from scenewright.core.catalog import Catalog, Material, Part, transform_part
from scenewright.core.plan import Plan
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.formats.gltf.materials import list_materials
from scenewright.formats.gltf.surfaces import GlbSurface, pack_surfaces, surface
from scenewright.geometry.prisms import normals_of
from scenewright.render.bodies import Body, split_bodies
from scenewright.render.daylight import sun_at
from scenewright.render.items import RenderItem, things
from scenewright.render.lamps import lamps_of
from scenewright.render.textures.projection import coordinates_of
from scenewright.render.textures.table import texture_of

LIGHTS = "KHR_lights_punctual"
RESERVED = re.compile(r"[\[\].:/%@\"\\]+")
"""What three.js and Godot drop from the names of nodes."""
LONGEST = 63
"""Bytes of a name that Blender keeps."""
Json = dict[str, Any]


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
    for index, node in enumerate([*nodes]):
        thing = places.get(node["name"]) if node.pop("drawn", False) else None
        if thing is None:
            continue
        still, bodies = split_bodies(thing.parts)
        drawn = [(node, "", still)] if still else []
        for body in bodies:
            child = _body_node(thing, body)
            _add(nodes, index, child)
            drawn.append((child, body.joint.body, _about_pivot(body)))
        for place, name, own in drawn:
            key = (thing.key, name)
            if key not in numbers:
                numbers[key] = len(meshes)
                meshes.append(_mesh(thing, own, name, materials, parts))
            place["mesh"] = numbers[key]
    lights = _light_nodes(nodes, found, catalog)
    _add_sun(nodes, lights, scene.hour)
    names = [*_safe_names([node["name"] for node in nodes])]
    for node, name in zip(nodes, names, strict=True):
        if node["name"] != name and "extensions" not in node:
            node["extras"] = node.get("extras", {}) | {"id": node["name"]}
        node["name"] = name
    packed = pack_surfaces([*surfaces_of(parts)])
    for mesh in meshes:
        for primitive in mesh["primitives"]:
            primitive |= packed.primitives[primitive.pop("part")]
    listed, buffer = list_materials(materials).document(packed.views, packed.buffer)
    document = {
        "asset": _about(scene, catalog),
        "scene": 0,
        "scenes": [{"name": scene.name or "home", "nodes": [0]}],
        "nodes": nodes,
        "meshes": meshes,
        **listed,
        "accessors": packed.accessors,
        "bufferViews": packed.views,
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


def _add_sun(nodes: list[Json], lights: list[Json], hour: str) -> None:
    """A node with the sun of an hour, where it has risen: a light along the node's own -z."""
    sun = sun_at(hour)
    if sun is None:
        return
    x, y, z = sun.towards.tolist()
    pitch, yaw = -np.arcsin(z) / 2, np.arctan2(x, -y) / 2  # half of the turns about x, then y
    turn = [np.sin(pitch) * np.cos(yaw), np.cos(pitch) * np.sin(yaw)]
    turn += [-np.sin(pitch) * np.sin(yaw), np.cos(pitch) * np.cos(yaw)]
    color = [round(share, 4) for share in sun.color]
    lights.append({"type": "directional", "color": color, "intensity": sun.lux})
    node = {"name": "sun", "rotation": [round(float(part), 7) for part in turn]}
    _add(nodes, 0, node | {"extensions": {LIGHTS: {"light": len(lights) - 1}}})


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


def _body_node(thing: RenderItem, body: Body) -> Json:
    """A node about whose origin a body turns or from which it slides; what it may do is in its
    ``extras``: axis in glTF's frame, limits in radians or metres, and where it is ``at`` now."""
    joint = body.joint
    (x, y, z), (ax, ay, az) = joint.pivot, joint.axis
    facts = {
        "type": joint.kind,
        "axis": [ax, az, -ay if ay else 0.0],
        "lower": joint.lower,
        "upper": joint.upper,
        "at": joint.at,
    }
    place = [x, z, -y if y else 0.0]
    extras = {"category": "body", "joint": facts}
    return {"name": f"{thing.name} {joint.body}", "translation": place, "extras": extras}


def _about_pivot(body: Body) -> tuple[Part, ...]:
    return tuple(
        transform_part(part, np.eye(3), -np.array(body.joint.pivot)) for part in body.parts
    )


def _mesh(
    thing: RenderItem,
    own: Sequence[Part],
    body: str,
    materials: dict[Material, int],
    parts: list[Part],
) -> Json:
    """One mesh with a primitive a part, by its number among all ``parts``."""
    primitives = []
    for part in own:
        material = materials.setdefault(part.material, len(materials))
        primitives.append({"part": len(parts), "material": material})
        parts.append(part)
    name = thing.extras.get("asset", thing.name) if thing.kind == "piece" else thing.name
    return {"name": f"{name} {body}".strip(), "primitives": primitives}


def surfaces_of(parts: Sequence[Part]) -> Iterator[GlbSurface]:
    """The surfaces of parts, with places on the textures of their materials."""
    normals = normals_of([(part.vertices, part.faces) for part in parts])
    for part, corner in zip(parts, normals, strict=True):
        row = texture_of(part.material.name)
        places = None
        if row is not None:
            repeats = coordinates_of(part, row.laying) / np.array(row.metres)[::-1]
            places = repeats * (1.0, -1.0)
        yield surface(part, corner, places, row is not None and row.relief > 0)
