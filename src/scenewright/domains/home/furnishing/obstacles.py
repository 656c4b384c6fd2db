"""What stands in a room so far, as something to keep clear of."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.standing import RADIATED, is_radiator
from scenewright.core.catalog import Catalog
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece

Floats = NDArray[np.float64]


class StandingObstacles(NamedTuple):
    """What stands in the room so far: boxes ``(o, 5)``, several where a piece covers less than its
    own, underside and top ``(o, 2)``, and what each is called."""

    boxes: Floats
    spans: Floats
    names: tuple[str, ...]


@lru_cache(maxsize=64)
def flat_kinds(catalog: Catalog) -> frozenset[str]:
    """The kinds of a catalog that other things stand on."""
    return frozenset(category for category, kind in catalog.kinds.items() if kind.flat)


def standing_of(pieces: tuple[Piece, ...], flat: frozenset[str]) -> StandingObstacles:
    """Pieces as something to keep clear of, without the flat ones; radiators with the air before
    them."""
    solid = [p for p in pieces if p.category not in flat]
    parts = [(p, box) for p in solid for box in _kept_clear(p)]
    boxes = [box for _, box in parts]
    spans = [(p.pose.z, p.pose.z + p.size.height) for p, _ in parts]
    return StandingObstacles(
        np.array(boxes, np.float64).reshape(-1, 5),
        np.array(spans, np.float64).reshape(-1, 2),
        tuple(p.category for p, _ in parts),
    )


def _kept_clear(piece: Piece) -> list[list[float]]:
    """The boxes ``(k, 5)`` a piece keeps clear."""
    if not is_radiator(piece):
        return boxes_of(piece)
    pose, size = piece.pose, piece.size
    x, y = (
        pose.x + RADIATED / 2 * np.cos(pose.heading),
        pose.y + RADIATED / 2 * np.sin(pose.heading),
    )
    return [[float(x), float(y), pose.heading, size.width, size.depth + RADIATED]]


def join_standing(standing: StandingObstacles, more: StandingObstacles) -> StandingObstacles:
    """Both together."""
    return StandingObstacles(
        np.concatenate([standing.boxes, more.boxes]),
        np.concatenate([standing.spans, more.spans]),
        standing.names + more.names,
    )
