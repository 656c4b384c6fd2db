"""Meshes as a few bytes: corners on a grid of a tenth of a millimetre, faces by their steps.

A line of JSON with ``low`` and ``step`` (metres, by axis) and the ``parts``, each with its numbers
of corners and faces and the joint it moves by, if any; spaces up to a multiple of four bytes and a
newline; then of each part its corners, all x, all y, all z in steps from ``low`` as unsigned
16-bit numbers, and the corners of its faces, each as the difference to the one before, as 16-bit
or, if the part is ``wide``, 32-bit numbers.
"""

from __future__ import annotations

import json
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part
from scenewright.studio.shapes import Json

FINE = 1e-4
"""Metres of the grid of corners, of meshes up to 6.5 m; of larger ones it is coarser."""
MOST = (1 << 16) - 1
WIDE = 1 << 15
"""Corners from which on the steps of faces take 32 bits."""


def encode_mesh(parts: Sequence[Part]) -> bytes:
    """The bytes of a mesh, without its materials; equal for equal parts.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.prisms import box
    >>> oak, steel = (Material(name, (0.5, 0.5, 0.5)) for name in ("oak", "steel"))
    >>> cube = box((0, 0, 0), (1, 1, 1))
    >>> encode_mesh([Part(oak, *cube)]) == encode_mesh([Part(steel, *cube)])
    True
    """
    points = np.concatenate([part.vertices for part in parts] or [np.zeros((1, 3))])
    low = np.round(points.min(0), 6)
    step = np.maximum(FINE, np.round((points.max(0) - low) / MOST + 5e-8, 7))
    head = {"low": low.tolist(), "step": step.tolist(), "parts": [_describe(p) for p in parts]}
    text = json.dumps(head, separators=(",", ":")).encode()
    text += b" " * (-(len(text) + 1) % 4) + b"\n"
    return text + b"".join(block for part in parts for block in _encode(part, low, step))


def _describe(part: Part) -> Json:
    told: Json = {"corners": len(part.vertices), "faces": len(part.faces)}
    if len(part.vertices) >= WIDE:
        told["wide"] = True
    if part.joint is not None:
        told["joint"] = {
            "body": part.joint.body,
            "kind": part.joint.kind,
            "pivot": [round(value, 5) for value in part.joint.pivot],
            "axis": [round(value, 6) for value in part.joint.axis],
            "lower": round(part.joint.lower, 5),
            "upper": round(part.joint.upper, 5),
            "at": round(part.joint.at, 5),
        }
    return told


def _encode(part: Part, low: NDArray[np.float64], step: NDArray[np.float64]) -> tuple[bytes, bytes]:
    """Corners and faces, each up to a multiple of four bytes."""
    corners = np.round((part.vertices - low) / step).clip(0, MOST).astype("<u2")
    steps = np.diff(part.faces.reshape(-1), prepend=0)
    kind = "<i4" if len(part.vertices) >= WIDE else "<i2"
    blocks = (np.ascontiguousarray(corners.T).tobytes(), steps.astype(kind).tobytes())
    first, second = (block + b"\0" * (-len(block) % 4) for block in blocks)
    return first, second
