"""What is wrong with the table of a kitchen."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.modest import find_few_places
from scenewright.domains.home.composing.placed_faults import list_standing
from scenewright.domains.home.groups.classes import TABLES
from scenewright.domains.home.problem import Ground


def cost_of_places(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with tables of fewer places than their room has by :data:`~.modest.SEATED`."""
    tables = (list_standing(group) for group in groups if group.wish.group in TABLES)
    return sum(cost * find_few_places(table, ground.area) for table in tables)
