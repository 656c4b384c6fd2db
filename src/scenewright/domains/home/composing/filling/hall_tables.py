"""Halls that have no cabinet for shoes: a console table with a vase and a picture.

A home keeps its shoes in one hall; another of 4 m² and more would hold a coat rack and nothing
else. The table stands at the middle of a free stretch of wall where 0.9 m stay free before it.
"""

from __future__ import annotations

from scenewright.domains.home.attempt import RoomAnswer, RoomTask, bars_no_more
from scenewright.domains.home.composing.filling.amid_walls import list_amid_walls
from scenewright.domains.home.composing.filling.bare_floor import is_left_to_us
from scenewright.domains.home.composing.filling.widths import CONSOLE
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.composing.places.moving import with_margin
from scenewright.domains.home.programme import WELCOME, Wish

TABLE_FROM = 4.0  # square metres of a hall from which on it has a table
WAY = 0.9  # left free before it, metres
LOW = frozenset(("shoes", "console", "chest", "shelf", "storage"))
"""What else stands along the walls of a hall."""


def furnish_hall(task: RoomTask, answer: RoomAnswer, barred: frozenset[str]) -> RoomAnswer:
    """The answer for a hall without a cabinet with a console table, where that bars no way."""
    bare = task.space.functions == ("hall",) and task.ground.area >= TABLE_FROM
    if not bare or not is_left_to_us(task) or "console_table" in task.forbidden:
        return answer
    if LOW.intersection(p.wish.group for p in answer.placed) or task.cancelled():
        return answer
    margin, rule = with_margin(task), task.preset.settings.composing
    wish = Wish("console", WELCOME)
    for table in list_amid_walls(task, answer.placed, wish, CONSOLE, WAY):
        whole = (*answer.placed, table)
        sound = cost_of_group(table, task.ground, rule) == 0.0
        if sound and bars_no_more(margin, whole, barred):
            return answer._replace(placed=whole)
    return answer
