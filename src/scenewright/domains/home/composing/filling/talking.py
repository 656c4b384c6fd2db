"""Armchairs near enough to a sofa to talk to those who sit on it."""

from __future__ import annotations

from math import cos, hypot, sin

from scenewright.catalog.classes import SOFAS
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.judging import Placed

TALK = 2.5
"""Most metres from seat to seat at which people talk (Panero, Zelnik 1979)."""
TALKED_AT = 0.9  # where those on a sofa look at one another, metres before its middle


def joins_sofa(added: FurnishedGroup, placed: Placed) -> bool:
    """Whether an armchair is near enough to a sofa to talk, and not turned away from it."""
    chair = next(p for p in added.pieces if p.category == "armchair")
    return any(_talks(chair, sofa) for sofa in _list_sofas(placed))


def is_left_alone(added: FurnishedGroup, placed: Placed) -> bool:
    """Whether a group has an armchair in a room with a sofa, and none of the two talk."""
    seated = any(p.category == "armchair" for p in added.pieces)
    return seated and bool(_list_sofas(placed)) and not joins_sofa(added, placed)


def _list_sofas(placed: Placed) -> list[Piece]:
    return [p for group in placed for p in group.pieces if p.category in SOFAS]


def _talks(chair: Piece, sofa: Piece) -> bool:
    """Within :data:`TALK` metres and not behind its back, with what the sofa looks at before the
    armchair's sides."""
    (u, v, _, turn), (a, b, _, way) = sofa.pose, chair.pose
    x, y = u + TALKED_AT * cos(turn) - a, v + TALKED_AT * sin(turn) - b
    beside = (a - u) * cos(turn) + (b - v) * sin(turn) >= -sofa.size.depth / 2
    return hypot(u - a, v - b) <= TALK and beside and x * cos(way) + y * sin(way) >= 0.0
