"""Places on a texture for every corner of a part: its faces seen along the axis they face.

In metres. *Grain*: the part falls into boards (faces joined by corners); each face is seen along
the axis that its normal is nearest to, and the texture runs along the longer side of the board;
every board is cut from another place. *Upright*: along the level line of the face and up its
slope, faces that lie flat by x and y. *Whole*: as upright, stretched once over the board.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part
from scenewright.geometry.prisms import face_normals
from scenewright.render.textures.table import Laying

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

LEVEL = 0.93
"""Faces with a normal steeper than this lie flat: slopes below 21 degrees."""
CUTS = np.array([0.7548776662466927, 0.5698402909980532])
"""Steps of the sequence R2 (M. Roberts 2018): boards after one another are cut far apart."""


def coordinates_of(part: Part, laying: Laying) -> Floats:
    """Places ``(m, 3, 2)`` of the corners of each face: across and up the texture, in metres.

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.prisms import box
    >>> part = Part(Material("oak", (1, 1, 1)), *box((0, 0, 0), (0.5, 2.0, 0.1)))
    >>> place = coordinates_of(part, "grain")
    >>> np.ptp(place[np.isclose(part.vertices[part.faces][:, :, 2], 0.1).all(1)], (0, 1)).tolist()
    [2.0, 0.5]
    """
    if laying == "grain":
        return _along_grain(part)
    return _by_level_lines(part) if laying == "upright" else _once_over(part)


def _along_grain(part: Part) -> Floats:
    board = boards_of(part.faces, len(part.vertices))
    low, high = (np.full((int(board.max()) + 1, 3), sign * np.inf) for sign in (1, -1))
    np.minimum.at(low, board, part.vertices)
    np.maximum.at(high, board, part.vertices)
    mine = board[part.faces[:, 0]]
    seen = np.abs(face_normals(part.vertices, part.faces)).argmax(1)
    extent = (high - low)[mine]
    extent[np.arange(len(seen)), seen] = -1.0
    along = extent.argmax(1)
    across = 3 - seen - along
    points = part.vertices[part.faces] - low[mine][:, None]
    rows = np.arange(len(seen))
    place = np.stack([points[rows, :, along], points[rows, :, across]], -1)
    return np.asarray(place + 2.0 * np.modf((mine[:, None] + 1) * CUTS)[0][:, None])


def _by_level_lines(part: Part) -> Floats:
    normal = face_normals(part.vertices, part.faces)
    flat = np.abs(normal[:, 2]) > LEVEL
    level = np.column_stack([-normal[:, 1], normal[:, 0], np.zeros(len(normal))])
    level[flat] = (1.0, 0.0, 0.0)
    level /= np.maximum(np.linalg.norm(level, axis=1), 1e-9)[:, None]
    up = np.cross(normal, level)
    up[flat] = (0.0, 1.0, 0.0)
    points = part.vertices[part.faces]
    return np.stack([np.einsum("mki,mi->mk", points, way) for way in (level, up)], -1)


def _once_over(part: Part) -> Floats:
    """Shares of the span of each board's faces that look the same way: 0 to 1, a metre long."""
    place = _by_level_lines(part)
    board = boards_of(part.faces, len(part.vertices))[part.faces[:, 0]]
    way = np.sign(face_normals(part.vertices, part.faces).round(1)) @ (1, 3, 9)
    group = np.unique(np.column_stack([board, way]), axis=0, return_inverse=True)[1].ravel()
    low, high = (np.full((int(group.max()) + 1, 2), sign * np.inf) for sign in (1, -1))
    np.minimum.at(low, group, place.min(1))
    np.maximum.at(high, group, place.max(1))
    span = np.maximum(high - low, 1e-9)[group][:, None]
    return np.asarray((place - low[group][:, None]) / span)


def boards_of(faces: Ints, count: int) -> Ints:
    """The number of the board ``(n,)`` each of ``count`` corners belongs to: corners that faces
    join have one number. Labels are lowered over faces until none changes.

    >>> boards_of(np.array([[0, 1, 2], [3, 4, 5], [2, 6, 7]]), 8).tolist()
    [0, 0, 0, 1, 1, 1, 0, 0]
    """
    label = np.arange(count)
    while True:
        least = label[faces].min(1)
        lower = label.copy()
        for k in range(3):
            np.minimum.at(lower, faces[:, k], least)
        lower = lower[lower]
        if (lower == label).all():
            return np.asarray(np.unique(label, return_inverse=True)[1])
        label = lower
