"""glTF 2.0, binary (.glb) or text (.gltf): the default scene as one model.

y is up and the front of an asset looks along +z (Khronos Group, *glTF 2.0 Specification*, 2021).
Skins, morph targets and animations are left at rest; points and lines are passed over.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models import gltf_accessors as gltf_numbers
from scenewright.catalog.models import gltf_record
from scenewright.catalog.models.conversions import PLAIN_GLTF
from scenewright.catalog.models.files import MEBIBYTE, Beside, json_of
from scenewright.catalog.models.gltf_accessors import Store, pick_row
from scenewright.catalog.models.gltf_draco import DRACO, unpack_draco
from scenewright.catalog.models.gltf_instances import INSTANCING, places_of, turns_of
from scenewright.catalog.models.gltf_materials import SurfacePaint, assign_materials, paints
from scenewright.catalog.models.gltf_record import Document, GltfNode, Primitive
from scenewright.catalog.models.model import (
    MOST_FACES,
    MOST_VERTICES,
    ImportOptions,
    RawModel,
    SkippedModel,
    check_count,
    clean,
    merge_parts,
)
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

MOST_JSON = 32 * MEBIBYTE
TRIANGLES, STRIP, FAN = 4, 5, 6
COMPRESSIONS = ("EXT_meshopt_compression", "KHR_meshopt_compression")
KNOWN = (
    DRACO,
    INSTANCING,
    "KHR_materials_",
    "KHR_texture_transform",
    "KHR_mesh_quantization",
    "KHR_lights_punctual",
    "KHR_texture_basisu",
    "EXT_texture_webp",
    "KHR_animation_pointer",
)
"""Extensions a model may need: those that only change light, and what is read here."""


class SceneBody(NamedTuple):
    """A node with a mesh: its name, what its ``extras`` say that it is, its parts where they
    stand, in the axes and units of the file, the number of its ``mesh``, and the matrix (4, 4)
    that places it."""

    name: str
    category: str
    parts: tuple[Part, ...]
    mesh: int
    place: Floats


def read(
    content: bytes, stem: str, beside: Beside, options: ImportOptions
) -> Iterator[RawModel | SkippedModel]:
    """The one model of a glTF file; with ``options.buildings`` every building that stands in it."""
    if options.buildings:
        from scenewright.catalog.models import gltf_scene

        yield from gltf_scene.read(content, stem, beside)
        return
    held = open_scene(content, beside)
    parts = merge_parts([part for body in scene_bodies(held) for part in body.parts])
    author, licence, title = _credits(held.document)
    yield RawModel(stem, title or stem, parts, "+y", "+z", author, licence)


def read_credits(content: bytes, beside: Beside) -> tuple[str, str, str]:
    """Author, licence and title of a file, where it tells them."""
    return _credits(open_scene(content, beside).document)


def open_scene(content: bytes, beside: Beside) -> Store:
    """A checked document with its numbers."""
    text, inside = chunks(content) if content[:4] == b"glTF" else (content, None)
    if len(text) > MOST_JSON:
        raise InputError(f"its JSON is larger than {MOST_JSON // MEBIBYTE} MiB", "simplify it")
    raw = json_of(text, "glTF")
    _check_version(raw)
    _check_needs(raw.get("extensionsRequired"))
    document = gltf_record.check_document(raw)
    return unpack_draco(gltf_numbers.store(document, inside, beside))


def chunks(content: bytes) -> tuple[bytes, bytes | None]:
    """The JSON and the binary chunk of a .glb."""
    if len(content) < 20:
        raise InputError("ends within its header", "export the model again")
    version, total = struct.unpack_from("<II", content, 4)
    if version != 2:
        raise InputError(f"is version {version} of binary glTF", "export it as glTF 2.0")
    found: list[tuple[bytes, bytes]] = []
    place, end = 12, min(total, len(content))
    if total > len(content):
        raise InputError(f"is cut off: {len(content)} of {total} bytes", "copy the file again")
    while place + 8 <= end and len(found) < 2:
        length, kind = struct.unpack_from("<I4s", content, place)
        if place + 8 + length > end:
            raise InputError("a chunk reaches beyond the file", "export the model again")
        found.append((kind, content[place + 8 : place + 8 + length]))
        place += 8 + length
    if not found or found[0][0] != b"JSON":
        raise InputError("does not begin with a JSON chunk", "export the model again")
    binary = found[1][1] if len(found) > 1 and found[1][0] == b"BIN\0" else None
    return found[0][1], binary


def _check_version(raw: Mapping[str, object]) -> None:
    asset = raw.get("asset")
    version = asset.get("version") if isinstance(asset, dict) else None
    if not isinstance(version, str):
        raise InputError("is not glTF: it states no version", "give a glTF 2.0 file")
    if not version.startswith("2."):
        raise InputError(f"is glTF {clean(version)[:8]}", "export it as glTF 2.0")


def _check_needs(needs: object) -> None:
    for name in needs if isinstance(needs, list) else []:
        if name in COMPRESSIONS:
            raise InputError(f"is compressed ({name})", f"unpack it: {PLAIN_GLTF}")
        if not isinstance(name, str) or not name.startswith(KNOWN):
            raise InputError(f"needs the extension '{clean(name)}'", "export it without")


def scene_bodies(held: Store) -> Iterator[SceneBody]:
    """Every node of the scene that has a mesh."""
    coats = paints(held)
    faces = vertices = 0
    copies = (
        (node, above @ own)
        for node, above in _placed_nodes(held.document)
        for own in places_of(held, node)
    )
    for node, place in copies:
        found = []
        body = pick_row(held.document.meshes, node.mesh or 0, "meshes")
        for primitive in body.primitives:
            if primitive.mode not in (TRIANGLES, STRIP, FAN):
                continue
            for part in _of_primitive(held, primitive, place, coats):
                faces, vertices = faces + len(part.faces), vertices + len(part.vertices)
                check_count(faces, MOST_FACES, "triangles")
                check_count(vertices, MOST_VERTICES, "vertices")
                found.append(part)
        extras = node.extras if isinstance(node.extras, dict) else {}
        yield SceneBody(
            clean(node.name), clean(extras.get("category")), tuple(found), node.mesh or 0, place
        )


def _placed_nodes(document: Document) -> Iterator[tuple[GltfNode, Floats]]:
    """Each node of the scene that has a mesh, with the matrix ``(4, 4)`` of its place; every
    node counts once."""
    waiting = [(root, np.eye(4)) for root in reversed(_roots(document))]
    seen: set[int] = set()
    while waiting:
        number, above = waiting.pop()
        node = pick_row(document.nodes, number, "nodes")
        if number in seen:
            raise InputError(
                "is reached twice: the nodes are no tree",
                "export the model again",
                place=f"nodes[{number}]",
            )
        seen.add(number)
        with np.errstate(over="ignore", invalid="ignore"):
            place = above @ matrix(node)
        if node.mesh is not None:
            yield node, place
        check_count(len(waiting) + len(node.children), gltf_record.MOST_NODES, "nodes")
        waiting += [(child, place) for child in reversed(node.children)]


def _roots(document: Document) -> list[int]:
    if document.scenes:
        return pick_row(document.scenes, document.scene or 0, "scenes").nodes
    below = {child for node in document.nodes for child in node.children}
    return [k for k in range(len(document.nodes)) if k not in below]


def matrix(node: GltfNode) -> Floats:
    """The matrix of a node, from its own or from scale, then rotation (x, y, z, w), then shift.

    >>> matrix(GltfNode(rotation=(0, 0, 1, 0), scale=(2, 1, 1)))[0].tolist()
    [-2.0, 0.0, 0.0, 0.0]
    """
    if node.matrix is not None:
        return np.array(node.matrix, np.float64).reshape(4, 4).T
    turn = turns_of(np.array([node.rotation], np.float64))[0]
    found = np.eye(4)
    found[:3, :3] = turn * np.array(node.scale)
    found[:3, 3] = node.translation
    return found


def _of_primitive(
    held: Store, primitive: Primitive, place: Floats, coats: tuple[SurfacePaint, ...]
) -> list[Part]:
    if "POSITION" not in primitive.attributes:
        return []
    local = gltf_numbers.floats(held, primitive.attributes["POSITION"], 3)
    if primitive.indices is None:
        numbers = np.arange(len(local))
    else:
        numbers = gltf_numbers.whole_numbers(held, primitive.indices)
    if len(numbers) and numbers.max() >= len(local):
        raise InputError("a face has a corner that is not there", "export the model again")
    faces = faces_of(numbers, primitive.mode)
    with np.errstate(over="ignore", invalid="ignore"):
        points = local @ place[:3, :3].T + place[:3, 3]
        mirrored = np.linalg.det(place[:3, :3]) < 0.0
    return assign_materials(held, primitive, points, faces[:, ::-1] if mirrored else faces, coats)


def faces_of(numbers: Ints, mode: int) -> Ints:
    """Triangles ``(m, 3)`` of a list, strip or fan of corners.

    >>> faces_of(np.arange(5), STRIP).tolist()
    [[0, 1, 2], [2, 1, 3], [2, 3, 4]]
    """
    count = len(numbers) // 3 if mode == TRIANGLES else max(len(numbers) - 2, 0)
    k = np.arange(count)
    if mode == TRIANGLES:
        return numbers[: 3 * count].reshape(-1, 3)
    if mode == FAN:
        return numbers[np.stack([np.zeros_like(k), k + 1, k + 2], 1)]
    odd = k % 2
    return numbers[np.stack([k + odd, k + 1 - odd, k + 2], 1)]


def _credits(document: Document) -> tuple[str, str, str]:
    """Author, licence and title, where the file tells them."""
    extras = document.asset.extras if isinstance(document.asset.extras, dict) else {}
    author = clean(extras.get("author"), clean(document.asset.copyright))
    return author, clean(extras.get("license")), clean(extras.get("title"))
