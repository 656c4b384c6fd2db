"""Rooms in which one sleeps, cooks and sits, and large ones that lack something essential, are
furnished several times, and the best is kept.

Rooms of one or two uses come out much alike from other random numbers. In a studio a bed, seats and
their screen, a table and a kitchen compete for the same walls; what is laid out first decides what
is left for the rest, and no single group moved later makes up for it. Ways through the whole home
are walked later and exactly: a draft that loses something to them gives way to another.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from scenewright.domains.home.attempts.attempt import (
    DOOR,
    RoomAnswer,
    RoomTask,
    find_blocked,
    penalty,
)
from scenewright.domains.home.attempts.bed_first import with_narrow_ways
from scenewright.domains.home.attempts.second_try import try_otherwise
from scenewright.domains.home.composing.judging import sum_faults
from scenewright.domains.home.composing.spacing.rules import measure_closeness
from scenewright.domains.home.composing.views import is_unseen
from scenewright.domains.home.groups.classes import BED_GROUPS, RUNS
from scenewright.domains.home.needs.stated import AskedRooms
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.walking.remove_blockers import Opened

DRAFTS, GOOD = 8, 60.0
"""How often a studio is furnished at most, and from which cost on once more."""
USUAL, FAIR = 4, 100.0
"""After this many drafts one that costs less than ``FAIR`` is good enough."""
FIRST = 11
"""Drafts are numbered from here on; smaller numbers are those of second tries."""
DRAFTED_FROM = 24.0  # square metres from which on a room is furnished several times
UNSEEN = 20.0  # what it costs that nobody sees the screen of a room

Furnish = Callable[[RoomTask], RoomAnswer]


def furnish_best(task: RoomTask, wishes: tuple[Wish, ...], furnish: Furnish) -> RoomAnswer:
    """The answer for a room, of a studio, or a room as large that lacks something essential, the
    best of several drafts, with the others: the one that lacks least and has least wrong with it,
    the first of equals; a good one is not tried to be bettered."""
    first = furnish(task)
    if not (is_studio(task, wishes) or (is_composed(task) and _lacks(wishes, first))):
        return first
    drafts = [(cost_of_draft(task, wishes, first), first)]
    for number in range(FIRST, FIRST + DRAFTS - 1):
        enough = GOOD if len(drafts) < USUAL else FAIR
        if min(cost for cost, _ in drafts) < enough or task.cancelled():
            break
        other = furnish(try_otherwise(task._replace(progress=None), number, 0.0))
        drafts.append((cost_of_draft(task, wishes, other), other))
    best, *others = (answer for _, answer in sorted(drafts, key=lambda draft: draft[0]))
    return best._replace(drafts=tuple(others))


def choose_open(
    every: AskedRooms, answers: Sequence[RoomAnswer], opened: Opened
) -> list[RoomAnswer]:
    """The answers with another draft for each studio that loses something when the ways of its home
    are ``opened``: the one that is best then, the first of equals."""
    found = list(answers)
    for room, (task, wishes) in enumerate(zip(every.tasks, every.wishes, strict=True)):
        if not found[room].drafts or task.cancelled():
            continue
        walked = list[tuple[float, RoomAnswer]]()
        for draft in (found[room], *found[room].drafts):
            after = opened([*found[:room], draft, *found[room + 1 :]])[room]
            walked.append((cost_of_draft(task, wishes, after), draft))
            if len(after.missing) == len(draft.missing) and not after.gone:
                break
        found[room] = min(walked, key=lambda draft: draft[0])[1]
    return found


def is_studio(task: RoomTask, wishes: tuple[Wish, ...]) -> bool:
    """Whether a room that is composed is to hold a bed, seats and a kitchen and has floor for
    them."""
    groups = {wish.group for wish in wishes}
    several = all(groups.intersection(each) for each in (BED_GROUPS, RUNS, ("seating",)))
    return several and is_composed(task)


def is_composed(task: RoomTask) -> bool:
    """Whether a room is one of those that are composed by us, and large."""
    exact = task.preset.settings.exact
    composed = exact and not task.accessible and not task.library.own
    return composed and task.ground.area >= DRAFTED_FROM


def _lacks(wishes: tuple[Wish, ...], answer: RoomAnswer) -> bool:
    """Whether something essential is missing, or another kind of it stands there."""
    there = {p.wish.group for p in answer.placed}
    return any(wish.rank == 0 and wish.group not in there for wish in wishes)


def cost_of_draft(task: RoomTask, wishes: tuple[Wish, ...], answer: RoomAnswer) -> float:
    """What is missing or there in another kind, out of reach, wished for in vain, wrong, too near
    to something, unseen. What is out of reach costs less than elsewhere: ways are opened yet."""
    costs, placed = task.costs, answer.placed
    there = {p.wish.group for p in placed} | {
        m.wish.group for m in answer.missing if not m.replaced
    }
    lacks = sum(penalty(m.wish, costs) for m in answer.missing if not m.replaced)
    lacks += sum(
        costs.unreached if w.core else costs.fallback
        for w in wishes
        if w.rank == 0 and w.group not in there
    )
    blocked = find_blocked(with_narrow_ways(task), placed)
    far = sum(costs.in_the_way if b.startswith(DOOR) else costs.missing[1] for b in blocked)
    wrong = sum_faults(task, placed) + measure_closeness(placed, task.fixed, task.ground)
    hidden = UNSEEN * is_unseen(placed, task.ground.edges)
    return lacks + far + costs.unmet * answer.unmet + wrong + hidden
