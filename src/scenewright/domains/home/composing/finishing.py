"""What is mended in furnished rooms once the ways of their home are open, in this order."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.domains.home.attempt import RoomAnswer, RoomTask
from scenewright.domains.home.composing.bedsides import add_nightstands
from scenewright.domains.home.composing.doorways import clear_doorways
from scenewright.domains.home.composing.kitchens.loose_cabinets import join_cabinets
from scenewright.domains.home.composing.kitchens.mend import mend_kitchens
from scenewright.domains.home.composing.kitchens.remade import remake_kitchens
from scenewright.domains.home.composing.mend_bedrooms import mend_bedrooms
from scenewright.domains.home.composing.windows import clear_windows
from scenewright.domains.home.second_try import Opened


def mend_rooms(
    tasks: Sequence[RoomTask], answers: list[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers for rooms with kitchens that had a fault made to measure, bedrooms mended, doors
    and windows cleared and nightstands added, each where the home, its ways ``opened``, allows."""
    found = mend_kitchens(tasks, answers, opened)
    found = mend_bedrooms(tasks, found, opened)
    found = clear_doorways(tasks, found, opened)
    found = clear_windows(tasks, found, opened)
    found = remake_kitchens(tasks, found, opened)
    found = join_cabinets(tasks, found, opened)
    return add_nightstands(tasks, found, opened)
