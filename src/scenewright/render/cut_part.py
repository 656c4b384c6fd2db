"""The part of a thing below the height a picture cuts it at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from scenewright.core.catalog import Part

APART = 0.3  # gap below a part from which it hangs on the wall, metres


def cut_part(part: Part, cut: float | None) -> Part | None:
    """A part made of boxes without what is above ``cut``; those it goes through are shortened."""
    if cut is None:
        return part
    low = part.vertices[:, 2].copy()
    for _ in range(3):
        least = low[part.faces].min(1)
        np.minimum.at(low, part.faces, least[:, None])
    faces = part.faces[low[part.faces[:, 0]] < cut - 1e-6]
    short = part.vertices * [1, 1, 0] + np.minimum(part.vertices[:, 2:], cut) * [0, 0, 1]
    return replace(part, vertices=short, faces=faces) if len(faces) else None


def leave_out_hanging(parts: Sequence[Part]) -> tuple[Part, ...]:
    """The parts of pieces on the floor, without those that hang on the wall over it: a picture
    over its rail, a mirror over its table."""
    kept, top = list[Part](), 0.0
    for part in sorted(parts, key=lambda part: float(part.vertices[:, 2].min())):
        if part.vertices[:, 2].min() <= top + APART:
            kept.append(part)
            top = max(top, float(part.vertices[:, 2].max()))
    return tuple(kept)
