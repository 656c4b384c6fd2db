"""How much the groups of a room hold: worktop, storage, seats, places at tables."""

from __future__ import annotations

from scenewright.catalog.assets.cooking import UNDER_WORKTOP
from scenewright.catalog.classes import TABLE_SEATS, WORKTOP
from scenewright.core.scene import Piece
from scenewright.domains.home.composing.case_faults import count_seats
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.composing.placed_faults import list_standing
from scenewright.domains.home.household import STORING
from scenewright.domains.home.measures import HAIR, RAISED

LESS = (0.1, 0.0, 0.0, 0.0)
"""By how much less of each is not less, metres and places."""

Held = tuple[float, ...]


def measure_held(placed: Placed) -> Held:
    """Metres of worktop and of storage, places on sofas and armchairs, and at tables.

    >>> measure_held(())
    (0, 0, 0, 0)
    """
    pieces = [p for g in placed for p in g.pieces]
    return (
        sum(p.size.width for p in pieces if _has_worktop(p)),
        sum(p.size.width for p in pieces if p.category in STORING),
        sum(count_seats(list_standing(g)) for g in placed),
        sum(p.category in TABLE_SEATS for p in pieces),
    )


def _has_worktop(piece: Piece) -> bool:
    """Whether a piece has worktop on it, as a fridge no higher has."""
    low = piece.category == "fridge" and piece.size.height <= UNDER_WORKTOP
    return (low or piece.category in WORKTOP) and piece.pose.z < RAISED


def holds_less(after: Held, before: Held) -> bool:
    """Whether hardly less (:data:`LESS`) of everything is held ``after`` than ``before``."""
    return any(a < b - less - HAIR for a, b, less in zip(after, before, LESS, strict=True))
