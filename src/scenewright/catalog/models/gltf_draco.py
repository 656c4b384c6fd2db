"""Draco: the numbers of compressed primitives, put where those of plain ones are.

KHR_draco_mesh_compression (Khronos Group, 2018); decoded by the library DracoPy, the extra
``draco``. Only what the materials and places read here need is unpacked.
"""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.conversions import PLAIN_GLTF
from scenewright.catalog.models.gltf_accessors import COMPONENTS, Store, pick_row, view
from scenewright.catalog.models.gltf_record import Accessor, BufferView, Primitive
from scenewright.catalog.models.model import MOST_FACES, MOST_VERTICES, check_count
from scenewright.core.errors import InputError

DRACO = "KHR_draco_mesh_compression"


class _Unpacked(NamedTuple):
    """Rows of numbers that belong to the accessor of a number."""

    accessor: int
    rows: NDArray[Any]


def unpack_draco(held: Store) -> Store:
    """The store with every compressed primitive's numbers in buffers of their own."""
    packed = [
        one for mesh in held.document.meshes for one in mesh.primitives if _is_packed(held, one)
    ]
    if not packed:
        return held
    accessors = list(held.document.accessors)
    views, buffers = list(held.document.bufferViews), list(held.buffers)
    for primitive in packed:
        for number, rows in _unpack(held, primitive):
            accessor = accessors[number]
            with np.errstate(invalid="ignore"):
                own = rows.astype(COMPONENTS[accessor.componentType]).tobytes()
            views.append(BufferView(buffer=len(buffers), byteLength=len(own)))
            buffers.append(own)
            accessors[number] = accessor.model_copy(
                update={"bufferView": len(views) - 1, "byteOffset": 0, "sparse": None}
            )
    document = held.document.model_copy(update={"accessors": accessors, "bufferViews": views})
    return held._replace(document=document, buffers=tuple(buffers))


def _is_packed(held: Store, primitive: Primitive) -> bool:
    """Whether a primitive has no numbers but compressed ones."""
    number = primitive.attributes.get("POSITION")
    if DRACO not in primitive.extensions or number is None:
        return False
    return pick_row(held.document.accessors, number, "accessors").bufferView is None


def _unpack(held: Store, primitive: Primitive) -> Iterator[_Unpacked]:
    told = primitive.extensions[DRACO]
    names = told.get("attributes") if isinstance(told, dict) else None
    number = told.get("bufferView") if isinstance(told, dict) else None
    if not isinstance(names, dict) or not isinstance(number, int) or number < 0:
        raise _broken("does not say where its numbers are")
    points = _accessor(held, primitive.attributes["POSITION"])
    check_count(points.count, MOST_VERTICES, "vertices")
    buffer, start, length, _ = view(held, number)
    mesh = _decode(buffer[start : start + length])
    if primitive.indices is not None:
        faces = np.asarray(mesh.faces).reshape(-1, 1)
        check_count(len(faces), 3 * MOST_FACES, "corners")
        yield _matched(held, primitive.indices, faces)
    rows = {one["unique_id"]: np.asarray(one["data"]) for one in mesh.attributes}
    for name, own in names.items():
        if name in primitive.attributes:
            if not isinstance(own, int) or own not in rows:
                raise _broken(f"lacks {name[:40]}")
            yield _matched(held, primitive.attributes[name], rows[own])


def _matched(held: Store, number: int, rows: NDArray[Any]) -> _Unpacked:
    if len(rows) != _accessor(held, number).count:
        raise _broken(f"holds {len(rows)} rows of accessors[{number}]")
    return _Unpacked(number, rows)


def _accessor(held: Store, number: int) -> Accessor:
    found = pick_row(held.document.accessors, number, "accessors")
    if found.componentType not in COMPONENTS:
        raise _broken(f"has numbers of the unknown type {found.componentType}")
    return found


def _decode(content: bytes) -> Any:
    try:
        library = import_module("DracoPy")
    except ImportError:
        raise InputError(
            f"is compressed ({DRACO})",
            f"pip install 'scenewright[draco]', or unpack it: {PLAIN_GLTF}",
        ) from None
    try:
        mesh = library.decode(content)
    except Exception as error:  # whatever the library raises for bytes that are no mesh
        raise _broken(f"cannot be unpacked ({type(error).__name__})") from None
    if not hasattr(mesh, "faces"):
        raise _broken("is a cloud of points")
    return mesh


def _broken(fault: str) -> InputError:
    return InputError(f"its compressed part {fault}", "export the model again")
