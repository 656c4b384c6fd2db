"""What stands in a room so far, as something to keep clear of."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.building.standing import RADIATED, is_radiator
from scenewright.core.scene import Piece

Floats = NDArray[np.float64]


class StandingObstacles(NamedTuple):
    """What stands in the room so far: boxes ``(o, 5)``, underside and top ``(o, 2)``, and what
    each is called."""

    boxes: Floats
    spans: Floats
    names: tuple[str, ...]


def standing_of(pieces: tuple[Piece, ...], flat: frozenset[str]) -> StandingObstacles:
    """Pieces as something to keep clear of, without the flat ones; radiators with the air before
    them."""
    solid = [p for p in pieces if p.category not in flat]
    boxes = [_kept_clear(p) for p in solid]
    spans = [(p.pose.z, p.pose.z + p.size.height) for p in solid]
    return StandingObstacles(
        np.array(boxes, np.float64).reshape(-1, 5),
        np.array(spans, np.float64).reshape(-1, 2),
        tuple(p.category for p in solid),
    )


def _kept_clear(piece: Piece) -> tuple[float, float, float, float, float]:
    pose, size, more = piece.pose, piece.size, RADIATED if is_radiator(piece) else 0.0
    x, y = pose.x + more / 2 * np.cos(pose.heading), pose.y + more / 2 * np.sin(pose.heading)
    return float(x), float(y), pose.heading, size.width, size.depth + more


def join_standing(standing: StandingObstacles, more: StandingObstacles) -> StandingObstacles:
    """Both together."""
    return StandingObstacles(
        np.concatenate([standing.boxes, more.boxes]),
        np.concatenate([standing.spans, more.spans]),
        standing.names + more.names,
    )
