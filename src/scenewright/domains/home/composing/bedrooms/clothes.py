"""A chest of drawers for half a wardrobe, where clothes hang in the closet of the room.

Where doors and windows leave less than a metre of wall for a wardrobe, and a closet opens into the
room, nobody puts half a wardrobe before it: clothes hang in the closet, and a chest of drawers
takes the rest.
"""

from __future__ import annotations

from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    Missing,
    RoomTask,
    bars_no_more,
)
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.judging import JudgedRoom, Placed, judge_of
from scenewright.domains.home.composing.places.moving import make_unplaced, with_margin
from scenewright.domains.home.composing.places.walked_places import try_places
from scenewright.domains.home.groups.least import LEAST
from scenewright.domains.home.programme import WELCOME

METRE = 20.0  # what a metre of drawers is worth
WARDROBE, CHEST = "wardrobe", "chest"
REASON = "clothes hang in the closet of the room; a chest of drawers stands instead"


def hang_instead(
    task: RoomTask, best: JudgedRoom, barred: frozenset[str], wardrobe: FurnishedGroup
) -> JudgedRoom:
    """The groups with a chest of drawers for a wardrobe, a wide one if that costs little more; as
    they were in a room without a closet, or with a chest."""
    known = any(p.wish.group == CHEST for p in best.placed)
    if not task.closet or wardrobe.wish.required or known or not _may_stand(task):
        return best
    rest = tuple(p for p in best.placed if p is not wardrobe)
    forms = (*cases(CHEST, task.library).groups, *LEAST[CHEST]())
    chest = make_unplaced(task, rest, wardrobe.wish._replace(group=CHEST), forms[0])
    whole, most = (*rest, chest), best.cost - task.preset.settings.composing.least
    found = try_places(judge_of(task, whole), whole, len(rest), forms, most, METRE)
    margin = with_margin(task)
    free = (j for j in found if bars_no_more(margin, j.placed, barred))
    return next(free, best)


def list_hung(before: Placed, after: Placed) -> tuple[Missing, ...]:
    """The wardrobe that a chest of drawers stands for, and why."""
    chests = {p.name for p in after if p.wish.group == CHEST} - {p.name for p in before}
    gone = [p for p in before if p.wish.group == WARDROBE] if chests else []
    there = {p.name for p in after}
    return tuple(
        Missing(p.wish._replace(rank=WELCOME, core=False), REASON, replaced=True)
        for p in gone
        if p.name not in there
    )


def _may_stand(task: RoomTask) -> bool:
    """Whether the household may have a chest for a wardrobe: neither is a case of its own, and a
    chest is not forbidden."""
    own = {WARDROBE, CHEST} & task.library.own.keys()
    listed = task.asked is not None and task.asked.ask is not None
    return not own and not listed and "chest_of_drawers" not in task.forbidden
