"""glTF 2.0 binary: home -> level -> rooms with their pieces, walls, openings; one file.

Ours is z-up, glTF y-up: a point (x, y, z) is written as (x, z, -y), so importers that turn back
(Blender) show the plan as it was. Pieces of one asset and size share a mesh, many equal ones are
instances; woods and plain colours share one material (:mod:`.gltf.sheet`), other textures have
theirs. Lamps and the sun are lights; every room has a camera. Ceilings look down only, so that a
viewer sees in from above, and hang below one node that can be hidden. Names leave out signs that
viewers drop: ``extras`` then has the ``id``.
Khronos Group, *glTF 2.0 Specification* (2021).
"""

from __future__ import annotations

import json
import os
import struct
from collections.abc import Hashable, Iterable, Iterator, Sequence
from typing import Any

from scenewright._version import __version__
from scenewright.catalog import credits as authorship
from scenewright.core.atomic_file import atomic_write
from scenewright.core.catalog import Catalog, Part
from scenewright.core.georeference import Georeference, georeference_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Scene
from scenewright.core.solution import Solution
from scenewright.formats.gltf.cameras import OPEN, add_cameras
from scenewright.formats.gltf.handover import add_forms, extensions_used, name_forms
from scenewright.formats.gltf.instances import INSTANCING, add_instances
from scenewright.formats.gltf.lights import LIGHTS, add_lamps, add_rows, add_sun
from scenewright.formats.gltf.materials import WEBP
from scenewright.formats.gltf.meshes import make_meshes
from scenewright.formats.gltf.surfaces import QUANTISED
from scenewright.formats.gltf.tree import Drawn, build_tree, name_safely
from scenewright.geometry.prisms import face_normals
from scenewright.render.items import RenderItem, things
from scenewright.render.lamps import lamps_of
from scenewright.render.light_rows import LightRow, dark_rows, row_item
from scenewright.render.observations.ceilings import ceilings
from scenewright.render.public_rooms import fittings
from scenewright.render.skirting import skirting

MOST_LIGHTS = 12
"""Lights of the rows of a room: a viewer reckons with each of them at every pixel."""
Json = dict[str, Any]


def write(solution: Solution, path: str | os.PathLike[str], plan: Plan | None = None) -> None:
    """Write the scene of a solution to ``path``; the file appears whole or not at all."""
    write_scene(solution, path, plan, batched=True)


def write_scene(
    solution: Solution,
    path: str | os.PathLike[str],
    plan: Plan | None,
    batched: bool,
    for_engines: bool = False,
    webp: bool = False,
) -> None:
    """Write a scene, ``batched`` or with everything a mesh of its own; ``for_engines`` with levels
    of detail and collision meshes; its textures as ``webp``."""
    from scenewright.catalog.loading import catalog_of
    from scenewright.domains import scene_of

    with atomic_write(path) as partial:
        scene, catalog = scene_of(solution, plan), catalog_of(solution.brief.catalogs)
        where = georeference_of(solution.brief)
        domain = solution.brief.domain
        partial.write_bytes(encode_scene(scene, catalog, domain, batched, where, for_engines, webp))


def encode_scene(
    scene: Scene,
    catalog: Catalog,
    domain: str = "home",
    batched: bool = True,
    where: Georeference | None = None,
    for_engines: bool = False,
    webp: bool = False,
) -> bytes:
    """The bytes of a GLB file: a header, a chunk of JSON, a chunk of numbers. ``where`` its origin
    lies on a map, if that is known, is said at its root."""
    document, numbers = document_of(scene, catalog, domain, batched, for_engines, webp)
    if where is not None and where.system:
        stated = {"crs": where.system, "origin": list(where.origin)}
        document["nodes"][0]["extras"] |= {"georeference": stated}
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


def document_of(
    scene: Scene,
    catalog: Catalog,
    domain: str = "home",
    batched: bool = True,
    for_engines: bool = False,
    webp: bool = False,
) -> tuple[Json, bytes]:
    """The JSON document of a scene and the binary buffer it refers to. Its root is named after the
    scene or its ``domain``; unless ``batched`` everything draws its own mesh, and may have levels
    of detail and collision meshes ``for_engines``."""
    found = things(scene, catalog)
    rows = [*_dark_rows(scene, found, catalog)]
    seen = (*_seen_ceilings(scene), *fittings(scene))
    built = (*seen, *skirting(scene), *map(row_item, rows))
    tree = build_tree(scene, (*found, *built), domain, batched)
    added = add_forms(tree, found, [level.id for level in scene.levels]) if for_engines else []
    unique: dict[Hashable, Drawn] = {}
    for one in tree.drawn.values():
        unique.setdefault(one.key, one)
    numbers = {key: number for number, key in enumerate(unique)}
    for number, one in tree.drawn.items():
        tree.nodes[number]["mesh"] = numbers[one.key]
    meshes = make_meshes([(one.name, one.parts) for one in unique.values()], small=batched)
    lights: list[Json] = []
    add_lamps(tree, lights, found, catalog)
    add_rows(tree, lights, rows)
    add_sun(tree, lights, scene.hour)
    cameras = add_cameras(tree, scene)
    views, accessors = meshes.packed.views, meshes.packed.accessors
    buffer = add_instances(tree.nodes, tree.drawn, views, accessors, meshes.packed.buffer)
    listed, buffer = meshes.materials.document(views, buffer, webp)
    name_safely(tree.nodes)
    name_forms(tree.nodes, added)
    document = {
        "asset": _about(scene, catalog),
        "scene": 0,
        "scenes": [{"name": tree.nodes[0]["name"], "nodes": [0]}],
        "nodes": tree.nodes,
        "meshes": meshes.meshes,
        **listed,
        "cameras": cameras,
        "accessors": accessors,
        "bufferViews": views,
        "buffers": [{"byteLength": len(buffer)}],
    }
    many = any(one.places for one in tree.drawn.values())
    needs = [INSTANCING] * many + [QUANTISED] * batched + [WEBP] * webp
    return document | _extensions(needs, lights, extensions_used(added)), buffer


def _extensions(needs: list[str], lights: list[Json], others: Iterable[str]) -> Json:
    """What of glTF's extensions is used, and what of them a reader ``needs`` to know."""
    used = [LIGHTS] * bool(lights) + needs + [*others]
    found: Json = {"extensionsUsed": used} if used else {}
    if needs:
        found["extensionsRequired"] = needs
    return found | ({"extensions": {LIGHTS: {"lights": lights}}} if lights else {})


def _seen_ceilings(scene: Scene) -> Iterator[RenderItem]:
    """Ceilings of rooms as they are seen from below: their faces that look down; panes in them."""
    if any(OPEN & set(space.functions) for space in scene.spaces):
        return
    for item in ceilings(scene):
        if item.kind == "ceiling":
            parts = []
            for part in item.parts:
                down = face_normals(part.vertices, part.faces)[:, 2] < -0.05
                parts.append(Part(part.material, part.vertices, part.faces[down]))
            yield item._replace(parts=tuple(part for part in parts if len(part.faces)))
        else:
            yield item


def _dark_rows(scene: Scene, found: Sequence[RenderItem], catalog: Catalog) -> Iterator[LightRow]:
    if not any(OPEN & set(space.functions) for space in scene.spaces):
        yield from dark_rows(scene.spaces, lamps_of(found, catalog), MOST_LIGHTS)


def _about(scene: Scene, catalog: Catalog) -> Json:
    """The version, and who made the models on what terms."""
    found: Json = {"version": "2.0", "generator": f"Scenewright {__version__}"}
    made = authorship.credits_of(scene.pieces, catalog)
    authors = authorship.with_sources(made, scene.sources)
    if authors:
        found["copyright"] = authorship.line(authors)
        found["extras"] = {"credits": authorship.document(authors)}
    return found
