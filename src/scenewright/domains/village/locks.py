"""Houses of a saved village that stay where they stand when it is solved again."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.brief import LockedHouse
from scenewright.ground.edits.locks import Lockable, kept_values, lock_brief


def _keep_house(piece: Piece) -> LockedHouse:
    return LockedHouse(house=piece.function, **kept_values(piece))


HOUSES = Lockable("blocks", "block", _keep_house, "trees", "houses")


def lock_village(solution: Solution) -> Brief:
    """The brief to solve again: locked houses are ``fixed`` in their block and count for what is
    asked; all others are free."""
    return lock_brief(solution, HOUSES)
