"""Rays against triangles without a tree: every ray against every triangle, in double precision."""

from __future__ import annotations

import io
import json
import re
import struct

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
ADDED = ("ceiling", "skirting")


def meet_slowly(triangles: Floats, eye: Floats, ways: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """Distance, in lengths of the direction, and index of the first of ``triangles`` (m, 3, 3)
    each ray from ``eye`` meets, infinite and -1 if none: T. Moeller and B. Trumbore (1997)."""
    a, b, c = triangles[:, 0], triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]
    from_eye = eye - a
    turned = np.cross(from_eye, b)
    best, which = np.full(len(ways), np.inf), np.full(len(ways), -1)
    for start in range(0, len(ways), 128):
        way = ways[start : start + 128]
        p = np.cross(way[:, None], c[None])
        with np.errstate(divide="ignore", invalid="ignore"):
            inverse = 1.0 / np.einsum("rmk,mk->rm", p, b)
            u = np.einsum("rmk,mk->rm", p, from_eye) * inverse
            v = way @ turned.T * inverse
            t = np.einsum("mk,mk->m", turned, c) * inverse
            met = (u >= 0) & (v >= 0) & (u + v <= 1) & (t > 1e-6)
        away = np.where(met, t, np.inf)
        nearest = away.argmin(1)
        best[start : start + 128] = away[np.arange(len(way)), nearest]
        which[start : start + 128] = np.where(np.isfinite(best[start : start + 128]), nearest, -1)
    return best, which


def triangles_of_glb(data: bytes) -> tuple[Floats, list[str]]:
    """Triangles (m, 3, 3) of a GLB file with z up, as trimesh reads it, and the id of the node
    each belongs to; without ceilings and skirting, which are of files only."""
    import trimesh

    loaded = trimesh.load(io.BytesIO(data), file_type="glb")
    (size,) = struct.unpack_from("<I", data, 12)
    nodes = json.loads(data[20 : 20 + size])["nodes"]
    above = {child: node for node in nodes for child in node.get("children", ())}
    owners = {
        node["name"]: above[k] if node.get("extras", {}).get("category") == "body" else node
        for k, node in enumerate(nodes)
    }
    ids = {name: node.get("extras", {}).get("id", node["name"]) for name, node in owners.items()}
    added = {node["name"] for node in nodes if node.get("extras", {}).get("category") in ADDED}
    found, names = [], []
    for node in loaded.graph.nodes_geometry:
        if re.sub(r"_[0-9a-f]{6}$", "", node) in added:
            continue
        place, geometry = loaded.graph[node]
        corners = trimesh.transform_points(loaded.geometry[geometry].vertices, place)
        faces = loaded.geometry[geometry].faces
        found.append(corners[faces][..., [0, 2, 1]] * [1, -1, 1])
        names += [ids[re.sub(r"_[0-9a-f]{6}$", "", node)]] * len(faces)
    return np.concatenate(found), names
