"""Buildings of a saved extension that stay where they stand when it is solved again."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.brief import LockedGrowth
from scenewright.ground.edits.locks import Lockable, kept_values, lock_brief


def locked_growth(piece: Piece) -> LockedGrowth:
    """A building as the brief keeps it."""
    return LockedGrowth(kind=piece.function, **kept_values(piece))


GROWTH = Lockable("areas", "area", locked_growth, "roads", "buildings")


def lock_extension(solution: Solution) -> Brief:
    """The brief to solve again: locked buildings are ``fixed`` in their area and count for what is
    asked; all others are free. What stood before stands by the brief."""
    return lock_brief(solution, GROWTH)
