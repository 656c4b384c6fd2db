"""Textures of a scene as arrays for kernels: every size of each, halved until one row is left."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part
from scenewright.render.textures.projection import coordinates_of
from scenewright.render.textures.table import TEXTURES, bake, texture_of

Singles = NDArray[np.float32]
PLAIN = -1


class WornTextures(NamedTuple):
    """``worn`` (f,) the row of each face's texture, -1 for none, and ``places`` (f, 3, 2) of its
    corners in repeats, across and down; ``rows`` (k, 3): the first of its texels, height and
    width; ``fine`` (k,) texels a metre; ``texels`` (n, 3) multipliers of linear colour."""

    worn: NDArray[np.int32]
    places: Singles
    rows: NDArray[np.int64]
    fine: Singles
    texels: Singles


def wear_textures(parts: Iterable[Part], faces: int) -> WornTextures:
    """The textures of parts, their faces in a row; of ``faces`` (those after them are plain).

    >>> from scenewright.core.catalog import Material
    >>> from scenewright.geometry.prisms import box
    >>> cube = box((0, 0, 0), (1, 1, 1))
    >>> found = wear_textures([Part(Material(name, (1, 1, 1)), *cube) for name in ("oak", "x")], 24)
    >>> found.worn.tolist() == [0] * 12 + [-1] * 12, found.rows[0].tolist()
    (True, [0, 256, 1024])
    """
    worn = np.full(faces, PLAIN, np.int32)
    places = np.zeros((faces, 3, 2), np.float32)
    numbers: dict[str, int] = {}
    kept: dict[int, Singles] = {}
    start = 0
    for part in parts:
        here = slice(start, start := start + len(part.faces))
        row = texture_of(part.material.name)
        if row is not None:
            if id(part) not in kept:
                repeats = coordinates_of(part, row.laying) / np.array(row.metres)[::-1]
                kept[id(part)] = (repeats * (1.0, -1.0)).astype(np.float32)
            worn[here] = numbers.setdefault(row.name, len(numbers))
            places[here] = kept[id(part)]
    return WornTextures(worn, places, *_stack(list(numbers)))


def _stack(names: Sequence[str]) -> tuple[NDArray[np.int64], Singles, Singles]:
    """Rows, texels a metre, and texels of textures: each size behind the last."""
    rows, sizes, first = [], [np.zeros((0, 3), np.float32)], 0
    for name in names:
        tone = bake(name).tone
        rows.append((first, *tone.shape[:2]))
        while True:
            sizes.append(tone.reshape(-1, 3))
            first += tone.shape[0] * tone.shape[1]
            if min(tone.shape[:2]) == 1:
                break
            pairs = tone[::2] + tone[1::2]
            tone = np.asarray((pairs[:, ::2] + pairs[:, 1::2]) / 4, np.float32)
    fine = [TEXTURES[name].pixels[1] / TEXTURES[name].metres[1] for name in names]
    kept = np.array(rows, np.int64).reshape(-1, 3)
    return kept, np.array(fine, np.float32), np.concatenate(sizes)
