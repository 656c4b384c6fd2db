"""Many equal pieces drawn at once (EXT_mesh_gpu_instancing)."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from scenewright.formats.gltf.surfaces import FLOAT
from scenewright.formats.gltf.tree import Drawn

INSTANCING = "EXT_mesh_gpu_instancing"
KINDS = (("TRANSLATION", "ROTATION"), ("VEC3", "VEC4"))
"""What an instance has, and the kinds of its accessors."""
Json = dict[str, Any]


def add_instances(
    nodes: list[Json],
    drawn: Mapping[int, Drawn],
    views: list[Json],
    accessors: list[Json],
    buffer: bytes,
) -> bytes:
    """Give nodes with many places the accessors of these; the longer buffer."""
    for number, one in drawn.items():
        attributes = {}
        for name, kind, rows in zip(*KINDS, zip(*one.places, strict=True), strict=False):
            content = np.array(rows, np.float32).tobytes()
            place = {"buffer": 0, "byteOffset": len(buffer), "byteLength": len(content)}
            held = {"bufferView": len(views), "byteOffset": 0, "componentType": FLOAT}
            attributes[name] = len(accessors)
            views.append(place)
            accessors.append(held | {"count": len(rows), "type": kind})
            buffer += content
        if attributes:
            nodes[number]["extensions"] = {INSTANCING: {"attributes": attributes}}
    return buffer
