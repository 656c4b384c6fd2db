"""Model files written by the tests: a tetrahedron, a block, a library of furniture."""

from __future__ import annotations

import base64
import json
import struct
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.model import Model
from scenewright.geometry.mesh import Mesh, merge

Floats = NDArray[np.float64]


TETRAHEDRON = np.array([[0.0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4]])


SIDES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def body(model: Model) -> Mesh:
    """All parts as one mesh."""
    return merge([Mesh(part.vertices, part.faces) for part in model.parts])


def obj_text(vertices: Floats = TETRAHEDRON, head: str = "") -> str:
    rows = [head, *("v {} {} {}".format(*row) for row in vertices.tolist())]
    return "\n".join([*rows, *("f {} {} {}".format(*(row + 1)) for row in SIDES)]) + "\n"


def gltf_of(vertices: Floats, faces: NDArray[np.int64], **more: Any) -> dict[str, Any]:
    """A glTF document with its numbers inside."""
    points, numbers = vertices.astype("<f4").tobytes(), faces.astype("<u2").tobytes()
    packed = base64.b64encode(points + numbers).decode()
    return {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(vertices), "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": faces.size, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": len(points)},
            {"buffer": 0, "byteOffset": len(points), "byteLength": len(numbers)},
        ],
        "buffers": [
            {
                "byteLength": len(points + numbers),
                "uri": "data:application/octet-stream;base64," + packed,
            }
        ],
    } | more


def glb_of(document: dict[str, Any], numbers: bytes = b"") -> bytes:
    """The document as a binary glTF file."""
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    if numbers:
        chunks += struct.pack("<I4s", len(numbers), b"BIN\0") + numbers
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


def city_of(geometry: dict[str, Any], vertices: list[list[int]], **more: Any) -> dict[str, Any]:
    return {
        "type": "CityJSON",
        "version": "2.0",
        "transform": {"scale": [0.5, 0.5, 0.5], "translate": [85000.0, 447000.0, 1.0]},
        "CityObjects": {"house": {"type": "Building", "geometry": [geometry]}},
        "vertices": vertices,
    } | more


CUBE = [[x, y, z] for x in (0, 8) for y in (0, 6) for z in (0, 10)]


SHELL = [
    [[0, 2, 6, 4]],
    [[1, 5, 7, 3]],
    [[0, 4, 5, 1]],
    [[2, 3, 7, 6]],
    [[0, 1, 3, 2]],
    [[4, 6, 7, 5]],
]


SOLID = {"type": "Solid", "lod": "2", "boundaries": [SHELL]}


def put(folder: Path, name: str, content: bytes | str | dict[str, Any]) -> Path:
    path = folder / name
    text = json.dumps(content) if isinstance(content, dict) else content
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return path


def furniture(folder: Path, catalogue: str, files: dict[str, str | bytes], **more: str) -> Path:
    path = folder / "shop.sh3f"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("PluginFurnitureCatalog.properties", catalogue.encode("latin-1"))
        for language, text in more.items():
            archive.writestr(f"PluginFurnitureCatalog_{language}.properties", text)
        for name, content in files.items():
            archive.writestr(name, content)
    return path


PIECE = """license = Public \\
    domain
name#1=Caf\\u00e9 table
category#1: Kitchen
model#1=/kit/table.obj
width#1=80
depth#1=60
height#1=74
elevation#1=10
creator#1=Jos\xe9
modelRotation#1=1 0 0 0 0 1 0 -1 0
"""
