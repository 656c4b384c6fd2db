"""Surfaces as a graphics card gets them, and the buffer they are packed in."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part
from scenewright.geometry.prisms import face_normals, row_keys

FLOAT, SHORT, INT, BYTE = 5126, 5123, 5125, 5120
VERTICES, INDICES = 34962, 34963
STRIDES = (12, 12, 8, 16, 0, 0)
"""Bytes of a row in each block of the buffer; 0 of indices, which are no rows."""
QUANTISED = "KHR_mesh_quantization"
"""Lets normals be bytes: 0.3 degrees at most off, and a third of the bytes."""
Json = dict[str, Any]
Floats = NDArray[np.float32]
Floats64 = NDArray[np.float64]


class GlbSurface(NamedTuple):
    """What the graphics card gets: positions and normals ``(n, 3)``, indices ``(3 m,)``, and
    ``places`` (n, 2) on a texture, in shares of it from its upper left corner; ``tangents`` (n, 4)
    if it has a normal map: the way across the picture, and 1 where its other way is up, else -1."""

    positions: Floats
    normals: Floats
    indices: NDArray[np.uint32]
    places: Floats | None = None
    tangents: Floats | None = None


class PackedSurfaces(NamedTuple):
    """The buffer, its views and accessors, and of each surface what its primitive refers to."""

    buffer: bytes
    views: list[Json]
    accessors: list[Json]
    primitives: list[Json]


def surface(
    part: Part, normals: Floats64, places: Floats64 | None = None, relief: bool = False
) -> GlbSurface:
    """Vertices split where normals or ``places`` (m, 3, 2) differ, in glTF's axes, with tangents
    for ``relief``; faces without area are left out.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.prisms import box, corner_normals
    >>> cube = box((0, 0, 0), (1, 1, 1))
    >>> cube = surface(Part(Material("grey", (0.5, 0.5, 0.5)), *cube), corner_normals(*cube[:2]))
    >>> cube.positions.shape, cube.indices.shape
    ((24, 3), (36,))
    """
    real = np.abs(face_normals(part.vertices, part.faces)).sum(1) > 0
    corners = part.vertices[part.faces[real]]
    columns = [corners.reshape(-1, 3), normals[real].reshape(-1, 3)]
    scales = [1e5, 1e3]
    if places is not None:
        columns.append(places[real].reshape(-1, 2))
        scales.append(1e4)
        if relief:
            columns.append(_tangents(corners, normals[real], places[real]).reshape(-1, 4))
            scales.append(1e2)
    keys = row_keys(np.column_stack([c * scale for c, scale in zip(columns, scales, strict=True)]))
    _, first, inverse = np.unique(keys, return_index=True, return_inverse=True)
    rows = inverse.astype(np.uint32).reshape(-1, 3)
    whole = (rows != rows[:, [1, 2, 0]]).all(1)
    rows = rows[whole if whole.any() else slice(1)]
    found = [column[first] for column in columns]
    for column in (found[0], found[1], *found[3:]):
        column[:, :3] = column[:, [0, 2, 1]] * [1, 1, -1]
    kept = [np.ascontiguousarray(column, np.float32) for column in found]
    return GlbSurface(kept[0], kept[1], rows.reshape(-1), *kept[2:])


def join_surfaces(surfaces: Sequence[GlbSurface]) -> GlbSurface:
    """Several surfaces of one material as one."""
    if len(surfaces) == 1:
        return surfaces[0]
    starts = np.cumsum([0, *(len(one.positions) for one in surfaces)])[:-1].astype(np.uint32)
    indices = [one.indices + start for one, start in zip(surfaces, starts, strict=True)]
    places = [one.places for one in surfaces if one.places is not None]
    tangents = [one.tangents for one in surfaces if one.tangents is not None]
    return GlbSurface(
        np.concatenate([one.positions for one in surfaces]),
        np.concatenate([one.normals for one in surfaces]),
        np.concatenate(indices),
        np.concatenate(places) if places else None,
        np.concatenate(tangents) if tangents else None,
    )


def _tangents(corners: Floats64, normals: Floats64, places: Floats64) -> Floats64:
    """Tangents ``(m, 3, 4)`` at corners of faces, by how places change over each face: with sides
    p, q of a face and their places (a, b), (c, d), the way across is (p d - q b) / (a d - b c)."""
    p, q = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    (a, b), (c, d) = (places[:, 1] - places[:, 0]).T, (places[:, 2] - places[:, 0]).T
    turned = np.sign(a * d - b * c)[:, None]
    across, up = (
        turned * (p * d[:, None] - q * b[:, None]),
        turned * (p * c[:, None] - q * a[:, None]),
    )
    across = across[:, None] - normals * np.einsum("mi,mki->mk", across, normals)[..., None]
    length = np.linalg.norm(across, axis=-1, keepdims=True)
    spare = np.cross(normals, np.where(np.abs(normals[..., 2:]) > 0.9, [1.0, 0, 0], [0, 0, 1.0]))
    spare /= np.maximum(np.linalg.norm(spare, axis=-1, keepdims=True), 1e-12)
    across = np.where(length > 1e-9, across / np.maximum(length, 1e-9), spare)
    side = np.einsum("mki,mi->mk", np.cross(normals, across), up)
    return np.concatenate([across, np.where(side < 0, -1.0, 1.0)[..., None]], -1)


def pack_surfaces(surfaces: Sequence[GlbSurface], small: bool = False) -> PackedSurfaces:
    """One buffer: positions, normals (bytes, if ``small``), places, tangents, then 16-bit indices,
    then 32-bit ones."""
    blocks: list[list[bytes]] = [[] for _ in STRIDES]
    ends = [0] * len(STRIDES)
    accessors: list[Json] = []

    def add(block: int, rows: NDArray[Any], component: int, kind: str) -> int:
        accessors.append(
            {
                "bufferView": block,
                "byteOffset": ends[block],
                "componentType": component,
                "count": len(rows),
                "type": kind,
            }
        )
        blocks[block].append(rows.tobytes())
        ends[block] += rows.nbytes
        return len(accessors) - 1

    primitives: list[Json] = []
    for one in surfaces:
        attributes = {"POSITION": add(0, one.positions, FLOAT, "VEC3")}
        accessors[-1]["min"] = [float(str(value)) for value in one.positions.min(0)]
        accessors[-1]["max"] = [float(str(value)) for value in one.positions.max(0)]
        if small:
            attributes["NORMAL"] = add(1, _as_bytes(one.normals), BYTE, "VEC3")
            accessors[-1]["normalized"] = True
        else:
            attributes["NORMAL"] = add(1, one.normals, FLOAT, "VEC3")
        if one.places is not None:
            attributes["TEXCOORD_0"] = add(2, one.places, FLOAT, "VEC2")
        if one.tangents is not None:
            attributes["TANGENT"] = add(3, one.tangents, FLOAT, "VEC4")
        if len(one.positions) < 65535:
            indices = add(4, one.indices.astype(np.uint16), SHORT, "SCALAR")
        else:
            indices = add(5, one.indices, INT, "SCALAR")
        primitives.append({"attributes": attributes, "indices": indices})
    strides = (STRIDES[0], 4 if small else STRIDES[1], *STRIDES[2:])
    buffer, views = _join_blocks([b"".join(rows) for rows in blocks], strides, accessors)
    return PackedSurfaces(buffer, views, accessors, primitives)


def _as_bytes(normals: Floats) -> NDArray[np.int8]:
    """Normals as shares of 127, each on four bytes."""
    rows = np.zeros((len(normals), 4), np.int8)
    rows[:, :3] = np.round(normals * 127)
    return rows


def _join_blocks(
    blocks: Sequence[bytes], strides: Sequence[int], accessors: Sequence[Json]
) -> tuple[bytes, list[Json]]:
    """The blocks end to end on four-byte bounds, with a view each; empty ones are skipped."""
    views: list[Json] = []
    moved: dict[int, int] = {}
    buffer = b""
    for number, block in enumerate(blocks):
        if block:
            moved[number] = len(views)
            place = {"buffer": 0, "byteOffset": len(buffer), "byteLength": len(block)}
            stride = strides[number]
            kept = {"target": VERTICES, "byteStride": stride} if stride else {"target": INDICES}
            views.append(place | kept)
            buffer += block + b"\0" * (-len(block) % 4)
    for accessor in accessors:
        accessor["bufferView"] = moved[accessor["bufferView"]]
    return buffer, views
