"""One room of a home after a change."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import chain
from typing import NamedTuple

from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask
from scenewright.domains.home.changes.least_change import Rest
from scenewright.domains.home.programme import Wish
from scenewright.engine.solve import Budget

NOTHING = RoomAnswer(0.0, (), (), (), None, 0.0, 0)
"""The answer for a room in which nothing is to be placed."""


class Revised(NamedTuple):
    """One room after the edits: its task with all that is fixed, the same without the groups that
    are ``held``, the other groups, what of a moved group had to be given up, and why groups
    changed, by their ids; in a room furnished again also what it is to hold and the budget."""

    task: RoomTask
    bare: RoomTask
    held: tuple[FurnishedGroup, ...]
    rest: Rest
    given_up: tuple[LeftOut, ...]
    reasons: Mapping[str, str]
    anew: tuple[Wish, ...]
    budget: Budget


def list_placed(revised: Revised) -> tuple[Piece, ...]:
    """What stands in a revised room, without lamps and curtains."""
    groups = (group.pieces for group in revised.rest.answer.placed)
    return (*revised.task.fixed, *chain(*groups))
