"""A second try for rooms that had to give up something they are for.

Rooms are furnished one by one on a grid; the walk through the whole home (:mod:`.yielding`) is
exact. Where it takes away what a room is for, the room is furnished again from other random
numbers with wider ways kept open, and of both homes the one that lacks less is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import islice

from scenewright.domains.home.attempt import RoomAnswer, RoomTask, penalty
from scenewright.domains.home.programme import Wish, is_essential
from scenewright.domains.home.room import FILL, fill_rest, share_of
from scenewright.domains.home.systematic import essential_layouts
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.engine.solve import Budget

WIDER = (0.08, 0.02)
"""How much wider the ways of each further try are, metres: up to two cells of the grid they are
walked on."""
OTHERWISE = 7919  # added to the seed of a room for each
LEAST = 0.7  # a room of less floor has hardly another place for anything, square metres

TRIALS = 6  # layouts of essentials that are walked through exactly, at most

Opened = Callable[[Sequence[RoomAnswer]], list[RoomAnswer]]


def tried_again(
    tasks: Sequence[RoomTask],
    wishes: Sequence[tuple[Wish, ...]],
    budgets: Sequence[Budget],
    before: Sequence[RoomAnswer],
    opened: Opened,
) -> list[RoomAnswer]:
    """The answers for all rooms with their ways ``opened``, after further tries for each room
    that gives up something essential for that, one where its own grid showed it (none where seconds
    are stated: these are spent), and a search along the walls for what is lacking then."""
    found = opened(before)
    for room, task in enumerate(tasks):
        wanted = _lacks(before[room])
        if task.ground.area < LEAST or task.cancelled():
            continue
        most = 0 if budgets[room].seconds is not None else 1 if before[room].unreached else None
        for number, wider in enumerate(WIDER[:most], 1):
            if _lacks(found[room]) <= wanted:
                break
            other = furnish_by_use(_otherwise(task, number, wider), wishes[room], budgets[room])
            if _lacks(other) < _lacks(found[room]):
                found = min(found, opened(_with(found, room, other)), key=_lacking)
        if _lacks(found[room]) and not task.accessible:
            found = _with_essentials(room, task, wishes[room], budgets[room], found, opened)
    return found


def _with_essentials(
    room: int,
    task: RoomTask,
    wishes: tuple[Wish, ...],
    budget: Budget,
    found: list[RoomAnswer],
    opened: Opened,
) -> list[RoomAnswer]:
    """The answers after all places along the walls of one room were tried for what it lacks: first
    what its functions fail without, then all that is essential."""
    for rank in (0, 1) if any(w.rank == 1 for w in wishes if is_essential(w)) else (0,):
        found = _at_rank(rank, room, task, wishes, budget, found, opened)
    return found


def _at_rank(
    rank: int,
    room: int,
    task: RoomTask,
    wishes: tuple[Wish, ...],
    budget: Budget,
    found: list[RoomAnswer],
    opened: Opened,
) -> list[RoomAnswer]:
    if not any(is_essential(m.wish) and m.wish.rank <= rank for m in found[room].missing):
        return found
    for bare in islice(essential_layouts(task, wishes, found[room], rank), TRIALS):
        trial = opened(_with(found, room, bare))
        if _essential(trial) >= _essential(found):
            continue
        filled = opened(_with(found, room, fill_rest(task, bare, share_of(budget, FILL))))
        found = min(trial, filled, key=lambda each: (_essential(each), _lacking(each)))
        if not _lacks(found[room]):
            break
    return found


def _with(found: Sequence[RoomAnswer], room: int, answer: RoomAnswer) -> list[RoomAnswer]:
    return [answer if i == room else other for i, other in enumerate(found)]


def _essential(answers: Sequence[RoomAnswer]) -> float:
    return sum(map(_lacks, answers))


def _lacks(answer: RoomAnswer) -> float:
    """What it costs that some of what is essential is missing."""
    return sum(penalty(m.wish) for m in answer.missing if is_essential(m.wish))


def _lacking(answers: Sequence[RoomAnswer]) -> float:
    return sum(penalty(m.wish) for answer in answers for m in answer.missing)


def _otherwise(task: RoomTask, number: int, wider: float) -> RoomTask:
    return task._replace(
        seed=(task.seed + number * OTHERWISE) % 2**31,
        route_width=task.route_width + wider,
        use_width=task.use_width + wider,
    )
