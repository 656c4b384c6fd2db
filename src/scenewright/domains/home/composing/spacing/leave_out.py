"""What is merely welcome and still stands too near to something is left out by name."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.core.same import once
from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing, RoomAnswer, RoomTask
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.judging import Placed, count_unmet
from scenewright.domains.home.composing.placed_faults import list_standing
from scenewright.domains.home.composing.spacing.rules import Close, list_close
from scenewright.domains.home.groups.classes import COOKING, RUNS, TABLES
from scenewright.domains.home.programme import WELCOME

NEVER = 9
OPENED = {"chest": NEVER, "shelf": WELCOME}
"""What goes only if it cannot be opened itself, below a rank of its wish."""
YIELDING = (
    {"counter": 1}
    | dict.fromkeys(OPENED, 1)
    | dict.fromkeys(("console", "plant", "reading", "sideboard", "vanity"), WELCOME)
)
"""What a room looks no emptier without than it looks crowded with, from the rank of its wish on."""
OF_ENTRY = frozenset(("shoes", "coats"))
"""What of an entrance goes where it stands hard before a kitchen or at a table."""
SHELVES, OF_ROOM = "storage", frozenset(("chest", "console", "sideboard", "vanity"))
"""What of a room goes where it stands before open shelves."""
REASON = "it would stand too near to what else is here"
MUCH = 3.0
"""Least cost of standing too near for which a group is left out."""


def leave_out_near(task: RoomTask, answer: RoomAnswer) -> RoomAnswer:
    """The answer without what nobody asked for that stands hard at chairs, doors of wardrobes or
    beds; a counter stays where it is the only worktop, and all that was learned elsewhere."""
    if not may_leave_out(task):
        return answer
    while (group := _find_near(task, answer.placed)) is not None:
        lost = Missing(group.wish, _explain(task, answer.placed, group))
        placed = tuple(p for p in answer.placed if p is not group)
        answer = answer._replace(placed=placed, missing=(*answer.missing, lost))
    return answer


@once(64)
def find_left_out(task: RoomTask, placed: Placed) -> frozenset[str]:
    """The names of the groups that :func:`leave_out_near` would leave out."""
    kept = leave_out_near(task, RoomAnswer(0.0, placed, (), (), None, 0.0, 0)).placed
    return frozenset(p.name for p in placed) - {p.name for p in kept}


def _explain(task: RoomTask, placed: Placed, group: FurnishedGroup) -> str:
    """Why a group goes, in the words of the costliest row it breaks."""
    close = list_close(placed, task.fixed, task.ground)
    own = [c for c in close if group.name in (c.group, c.other) and c.says]
    worst = max(own, key=lambda c: c.cost, default=None)
    return f"{REASON}: {worst.says}" if worst else REASON


def may_leave_out(task: RoomTask) -> bool:
    """Whether something that nobody asked for may go: not what was learned elsewhere."""
    habits = task.library.habits
    learned = bool(task.library.own or habits.clearances or habits.shares)
    return not learned and task.preset.settings.exact and not task.accessible


def _find_near(task: RoomTask, placed: Placed) -> FurnishedGroup | None:
    close = [c for c in list_close(placed, task.fixed, task.ground) if c.cost >= MUCH]
    hindered = {c.group for c in close}
    near, amiss = hindered | {c.other for c in close}, _find_amiss(placed, close)
    for group in placed:
        wish = group.wish
        spare = wish.rank >= YIELDING.get(wish.group, NEVER) and not wish.required
        opened = wish.rank < OPENED.get(wish.group, 0)
        stuck = group.name in (hindered if opened else near)
        misplaced = group.name in amiss and not wish.required
        if (misplaced or (spare and stuck)) and not _is_needed(task, group, placed):
            return group
    return None


def _find_amiss(placed: Placed, close: Sequence[Close]) -> set[str]:
    """The names of shoes and coats hard before a kitchen or at a table, and of pieces before
    open shelves."""
    of = {group.name: group.wish.group for group in placed}
    before = {c.other for c in close if of.get(c.group) in COOKING}
    beside = {c.group for c in close if of.get(c.other) in TABLES}
    shelves = {c.other for c in close if of.get(c.group) == SHELVES}
    amiss = {name for name in before | beside if of.get(name) in OF_ENTRY}
    return amiss | {name for name in shelves if of.get(name) in OF_ROOM}


def _is_needed(task: RoomTask, group: FurnishedGroup, placed: Placed) -> bool:
    """Whether a wish is met by a group alone, or a counter is all the worktop of its kitchen."""
    rest = tuple(p for p in placed if p is not group)
    if count_unmet(task, rest) > count_unmet(task, placed):
        return True
    runs = [p for p in placed if p.wish.group in RUNS]
    faults = {name for run in runs for name, _ in find_case_faults(list_standing(run))}
    return group.wish.group == "counter" and bool(faults & {"worktop", "hob_at_end"})
