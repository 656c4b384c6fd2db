"""A second try for rooms that had to give up something they are for.

Rooms are furnished one by one on a grid; the walk through the whole home
(:mod:`.remove_blockers`) is exact. Where it takes away what a room is for, the room is furnished
again from other random numbers with wider ways kept open, and of both homes the one that lacks
less is taken.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from itertools import chain, islice

from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask, penalty
from scenewright.domains.home.attempts.bed_first import list_beds_first
from scenewright.domains.home.attempts.kitchen_first import has_gap, list_kitchens_first
from scenewright.domains.home.attempts.systematic import essential_layouts
from scenewright.domains.home.composing.compose import compose
from scenewright.domains.home.programme import Wish, is_essential
from scenewright.domains.home.room import fill_rest, share_of
from scenewright.domains.home.settings import FaultCosts
from scenewright.domains.home.walking.remove_blockers import Opened
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.engine.solve import Budget

OTHERWISE = 7919
"""Added to the seed of a room for each further try."""
LEAST_FLOOR = 0.7
"""A room of less floor has hardly another place for anything, square metres."""


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
        rule, costs = task.preset.settings.retry, task.costs
        wanted = _lacks(before[room], costs)
        if task.ground.area < LEAST_FLOOR or task.cancelled():
            continue
        most = 0 if budgets[room].seconds is not None else 1 if before[room].unreached else None
        for number, wider in enumerate(rule.wider[:most], 1):
            if _lacks(found[room], costs) <= wanted:
                break
            anew = _otherwise(task, number, wider)
            other = furnish_by_use(anew, wishes[room], budgets[room], roomy=False)
            other = compose(anew, other)
            if _lacks(other, costs) < _lacks(found[room], costs):
                found = min(
                    found, opened(_with(found, room, other)), key=partial(sum_lacks, costs=costs)
                )
        if _lacks(found[room], costs) and not task.accessible:
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
    what its functions fail without, a bed at last before all else, then all that is essential."""
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
    rule, costs = task.preset.settings, task.costs
    usual = islice(essential_layouts(task, wishes, found[room], rank), rule.retry.walked)
    beds = islice(list_beds_first(task, wishes, found[room]), rule.retry.walked)
    runs = islice(list_kitchens_first(task, wishes, found[room]), rule.retry.walked)
    for bare in chain(usual, beds, runs):
        if _lacks(bare, costs) >= _lacks(found[room], costs):
            continue
        trial = opened(_with(found, room, bare))
        if _essential(trial, costs) >= _essential(found, costs) or has_gap(trial[room]):
            continue
        part = share_of(budget, rule.tries.fill, rule.tries)
        filled = opened(_with(found, room, compose(task, fill_rest(task, bare, part))))
        better = [a for a in (filled, trial) if not has_gap(a[room])]
        found = min(better, key=lambda a: (_essential(a, costs), sum_lacks(a, costs)))
        if not _lacks(found[room], costs):
            break
    return found


def _with(found: Sequence[RoomAnswer], room: int, answer: RoomAnswer) -> list[RoomAnswer]:
    return [answer if i == room else other for i, other in enumerate(found)]


def _essential(answers: Sequence[RoomAnswer], costs: FaultCosts) -> float:
    return sum(_lacks(answer, costs) for answer in answers)


def lacks_essentials(answer: RoomAnswer, costs: FaultCosts) -> float:
    """What it costs that essentials are missing that nobody required by name."""
    return sum(
        penalty(m.wish, costs)
        for m in answer.missing
        if is_essential(m.wish) and not m.wish.required
    )


def try_otherwise(task: RoomTask, number: int, wider: float) -> RoomTask:
    """A room to be furnished from other random numbers, the same for the same ``number``, with ways
    ``wider`` metres wider."""
    return _otherwise(task, number, wider)


def _lacks(answer: RoomAnswer, costs: FaultCosts) -> float:
    """What it costs that some of what is essential is missing."""
    return sum(penalty(m.wish, costs) for m in answer.missing if is_essential(m.wish))


def sum_lacks(answers: Sequence[RoomAnswer], costs: FaultCosts) -> float:
    """What it costs that something is missing for which nothing else stands."""
    lacks = (m for answer in answers for m in answer.missing if not m.replaced)
    return sum(penalty(m.wish, costs) for m in lacks)


def _otherwise(task: RoomTask, number: int, wider: float) -> RoomTask:
    return task._replace(
        seed=(task.seed + number * OTHERWISE) % 2**31,
        route_width=task.route_width + wider,
        use_width=task.use_width + wider,
    )
