"""How far pieces, and those of a case, are from the outlets they need."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.kinds import services_of
from scenewright.core.catalog import Catalog, Member
from scenewright.core.scene import Piece
from scenewright.core.space import Outlet

Floats = NDArray[np.float64]

SPARE = 0.01  # by how much a lead may be too short unseen, metres


def out_of_reach(members: Sequence[Member], boxes: Floats, outlets: Sequence[Outlet]) -> float:
    """Metres, summed, by which leads and hoses of members standing on ``boxes`` (m, 5) are too
    short for the nearest of the outlets; 0 for kinds of outlets the room does not list."""
    total = 0.0
    for member, box in zip(members, boxes, strict=True):
        for need in services_of(member.category):
            at = np.array([(o.x, o.y) for o in outlets if o.kind == need.outlet])
            if len(at):
                total += max(float(_distances(at, box).min()) - need.reach, 0.0)
    return total


def count_unplugged(pieces: Sequence[Piece], outlets: Sequence[Outlet], catalog: Catalog) -> int:
    """How many leads and hoses of pieces that were not fixed are too short for the nearest outlet;
    of kinds of outlets the room lists."""
    found = 0
    for piece in pieces:
        kind = catalog.kinds.get(piece.category)
        for need in kind.services if kind and not piece.fixed else ():
            at = np.array([(o.x, o.y) for o in outlets if o.kind == need.outlet])
            box = np.array([*piece.pose[:2], piece.pose.heading, *piece.size[:2]])
            found += bool(len(at) and _distances(at, box).min() > need.reach + SPARE)
    return found


def _distances(points: Floats, box: Floats) -> Floats:
    """Of points (k, 2) to a box (5,)."""
    c, s = np.cos(box[2]), np.sin(box[2])
    off = points - box[:2]
    own = np.abs(np.stack([off[:, 0] * s - off[:, 1] * c, off[:, 0] * c + off[:, 1] * s], 1))
    found: Floats = np.hypot(*np.maximum(own - box[3:] / 2, 0.0).T)
    return found
