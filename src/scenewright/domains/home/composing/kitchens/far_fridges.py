"""Fridges that stand apart from their kitchen, and those under the worktop."""

from __future__ import annotations

from scenewright.catalog.assets.furniture.cooking import UNDER_WORKTOP
from scenewright.catalog.classes import RUN
from scenewright.core.scene import Piece
from scenewright.domains.home.composing.judging import Placed
from scenewright.domains.home.measures import HAIR, RAISED
from scenewright.geometry.boxes import common_area, make_frame

FRIDGE_APART = (
    0.7  # a fridge farther than this from all other units is apart from its kitchen, metres
)


def has_far_fridge(placed: Placed, far: float = FRIDGE_APART) -> bool:
    """Whether a fridge is so ``far`` and more from all other units of its kitchen, metres.

    >>> has_far_fridge(())
    False
    """
    units = [p for g in placed for p in g.pieces if p.category in RUN and p.pose.z < RAISED]
    others = [p for p in units if p.category != "fridge"]
    cold = (p for p in units if p.category == "fridge")
    return bool(others) and any(not any(_are_near(f, p, far) for p in others) for f in cold)


def has_low_fridge(placed: Placed) -> bool:
    """Whether a fridge is under the worktop."""
    pieces = (p for g in placed for p in g.pieces if p.category == "fridge")
    return any(p.size.height <= UNDER_WORKTOP for p in pieces)


def _are_near(fridge: Piece, unit: Piece, far: float) -> bool:
    """Whether a unit reaches into the floor so ``far`` round a fridge."""
    (x, y, _, turn), size = fridge.pose, fridge.size
    (a, b, _, heading), other = unit.pose, unit.size
    round_it = make_frame(x, y, turn, size.width + 2 * far, size.depth + 2 * far)
    return bool(common_area(round_it, make_frame(a, b, heading, other.width, other.depth)) > HAIR)
