"""STL, binary or text: bare triangles; z up, front to -y unless stated.

3D Systems, *StereoLithography interface specification* (1989). Normals are those of the corners.
"""

from __future__ import annotations

import re
from collections.abc import Iterator

import numpy as np

from scenewright.catalog.models.model import MOST_FACES, PLAIN, RawModel, check_count, part_of
from scenewright.core.errors import InputError

HEADER, FACE = 84, 50
ROW = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])


def read(content: bytes, stem: str, *_: object) -> Iterator[RawModel]:
    """The one model of an STL file."""
    count = int.from_bytes(content[80:HEADER], "little") if len(content) >= HEADER else -1
    if count >= 0 and len(content) == HEADER + FACE * count:
        check_count(count, MOST_FACES, "triangles")
        corners = np.frombuffer(content, ROW, count, HEADER)["corners"].astype(np.float64)
    elif content.lstrip()[:5].lower() == b"solid":
        corners = _text(content)
    else:
        raise InputError("is not STL: its length does not fit its count", "export it again")
    faces = np.arange(3 * len(corners)).reshape(-1, 3)
    yield RawModel(stem, stem, (part_of(PLAIN, corners.reshape(-1, 3), faces),), "+z", "-y")


def _text(content: bytes) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    check_count(content.count(b"vertex"), 3 * MOST_FACES, "corners")
    rows = re.findall(rb"^\s*vertex\s+(\S+)\s+(\S+)\s+(\S+)", content, re.MULTILINE)
    if len(rows) % 3:
        raise InputError("a triangle has not three corners", "export it again")
    try:
        return np.array([[float(word) for word in row] for row in rows]).reshape(-1, 3, 3)
    except ValueError:
        raise InputError("a corner is not a number", "export it again") from None
