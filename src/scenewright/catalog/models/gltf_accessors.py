"""Numbers of a glTF file: buffers, and accessors over them, within their bounds.

Every length is checked against the bytes that are there before anything is taken.
"""

from __future__ import annotations

import base64
import binascii
from collections.abc import Sequence
from typing import NamedTuple, TypeVar
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.files import MEBIBYTE, Beside
from scenewright.catalog.models.gltf_record import Accessor, Document, Sparse
from scenewright.catalog.models.model import MOST_FACES, check_count
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Row = TypeVar("Row")

MOST_BYTES = 256 * MEBIBYTE
"""Bytes of all buffers."""
MOST_NUMBERS = 3 * MOST_FACES
COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class Store(NamedTuple):
    """A document, the bytes of its buffers, and what lies beside the file."""

    document: Document
    buffers: tuple[bytes, ...]
    beside: Beside


def store(document: Document, inside: bytes | None, beside: Beside) -> Store:
    """The document with its buffers; ``inside`` is the binary chunk of a .glb."""
    buffers: list[bytes] = []
    left = MOST_BYTES
    for number, buffer in enumerate(document.buffers):
        place = f"buffers[{number}]"
        if buffer.byteLength > left:
            raise InputError(
                f"buffers hold more than {MOST_BYTES // MEBIBYTE} MiB",
                "simplify the model",
                place=place,
            )
        own = inside if buffer.uri is None else fetch_bytes(buffer.uri, beside, left)
        if own is None:
            fault = "has no bytes" if buffer.uri is None else f"'{buffer.uri[:40]}' is missing"
            raise InputError(fault, "keep the buffer with the file", place=place)
        if len(own) < buffer.byteLength:
            raise InputError(
                f"is {buffer.byteLength} bytes long but holds {len(own)}",
                "export the model again",
                place=place,
            )
        left -= buffer.byteLength
        buffers.append(own)
    return Store(document, tuple(buffers), beside)


def fetch_bytes(uri: str, beside: Beside, limit: int) -> bytes | None:
    """The bytes of a ``data:`` address or of a file beside the model."""
    if not uri.startswith("data:"):
        return beside(unquote(uri), limit)
    head, comma, body = uri.partition(",")
    if not comma or not head.endswith(";base64"):
        raise InputError("a data address is not base64", "export the model as .glb")
    try:
        return base64.b64decode(body, validate=True)
    except (binascii.Error, ValueError):
        raise InputError("a data address is not base64", "export the model again") from None


def pick_row(rows: Sequence[Row], number: int, what: str) -> Row:
    """A row of a table of the document."""
    if number >= len(rows):
        raise InputError(
            f"{what}[{number}] is not there", f"the file has {len(rows)}: export it again"
        )
    return rows[number]


def view(held: Store, number: int) -> tuple[bytes, int, int, int]:
    """Bytes of a buffer, start and length of a view of them, and its stride (0: none stated)."""
    found = pick_row(held.document.bufferViews, number, "bufferViews")
    buffer = pick_row(held.buffers, found.buffer, "buffers")
    if found.byteOffset + found.byteLength > len(buffer):
        raise InputError(
            "reaches beyond its buffer", "export the model again", place=f"bufferViews[{number}]"
        )
    return buffer, found.byteOffset, found.byteLength, found.byteStride or 0


def floats(held: Store, number: int, width: int) -> Floats:
    """An accessor of vectors ``(n, width)``; whole numbers are scaled if it says so."""
    accessor = pick_row(held.document.accessors, number, "accessors")
    try:
        raw = _raw(held, accessor, width)
    except InputError as error:
        raise error.located(place=f"accessors[{number}]") from None
    values = raw.astype(np.float64)
    if accessor.normalized and raw.dtype.kind in "iu":
        bits = 8 * raw.dtype.itemsize - (raw.dtype.kind == "i")
        values = np.maximum(values / (2.0**bits - 1.0), -1.0)
    return values


def whole_numbers(held: Store, number: int) -> Ints:
    """An accessor of indices ``(n,)``."""
    accessor = pick_row(held.document.accessors, number, "accessors")
    try:
        raw = _raw(held, accessor, 1)
        if raw.dtype.kind not in "iu":
            raise InputError("indices are not whole numbers", "export the model again")
    except InputError as error:
        raise error.located(place=f"accessors[{number}]") from None
    return raw.astype(np.int64).reshape(-1)


def _raw(held: Store, accessor: Accessor, width: int) -> NDArray[np.generic]:
    """The numbers ``(count, width)`` as they are kept."""
    code = COMPONENTS.get(accessor.componentType)
    if code is None:
        raise InputError(
            f"has numbers of the unknown type {accessor.componentType}", "export the model again"
        )
    if WIDTHS.get(accessor.type) != width:
        raise InputError(
            f"holds {accessor.type[:20]}, not vectors of {width}", "export the model again"
        )
    check_count(accessor.count, MOST_NUMBERS, "numbers in a row")
    if accessor.bufferView is None:
        found = np.zeros((accessor.count, width), code)
    else:
        found = _taken(held, accessor.bufferView, accessor.byteOffset, code, accessor.count, width)
    return _with_exceptions(held, accessor.sparse, found) if accessor.sparse else found


def _taken(
    held: Store, number: int, offset: int, code: str, count: int, width: int
) -> NDArray[np.generic]:
    buffer, start, length, stride = view(held, number)
    dtype = np.dtype(code)
    packed = dtype.itemsize * width
    step = stride or packed
    if count and (count - 1) * step + packed + offset > length:
        raise InputError(
            f"says it has {count} entries, more than its bytes hold", "export the model again"
        )
    found: NDArray[np.generic] = np.ndarray(
        (count, width), dtype, buffer, start + offset, (step, dtype.itemsize)
    )
    return found


def _with_exceptions(
    held: Store, sparse: Sparse, found: NDArray[np.generic]
) -> NDArray[np.generic]:
    """The numbers with those of a sparse accessor put in their places."""
    check_count(sparse.count, len(found), "exceptions than numbers")
    kind = COMPONENTS.get(sparse.indices.componentType, "")
    if kind not in ("<u1", "<u2", "<u4"):
        raise InputError("has exceptions at places of an unknown type", "export the model again")
    where = (
        _taken(held, sparse.indices.bufferView, sparse.indices.byteOffset, kind, sparse.count, 1)
        .reshape(-1)
        .astype(np.int64)
    )
    values = _taken(
        held,
        sparse.values.bufferView,
        sparse.values.byteOffset,
        found.dtype.str,
        sparse.count,
        found.shape[1],
    )
    if len(where) and where.max() >= len(found):
        raise InputError("has exceptions at places beyond its end", "export the model again")
    full = found.copy()
    full[where] = values
    return full
