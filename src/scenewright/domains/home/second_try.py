"""A second try for rooms that had to give up something they are for.

Rooms are furnished one by one on a grid; the walk through the whole home (:mod:`.yielding`) is
exact. Where it takes away what a room is for, the room is furnished again from other random
numbers with wider ways kept open, and of both homes the one that lacks less is taken.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from scenewright.domains.home.attempt import Furnished, Task, penalty
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.wheelchair import furnish_by_use
from scenewright.solve import Budget

WIDER = (0.08, 0.02)
"""How much wider the ways of each further try are, metres: up to two cells of the grid they are
walked on."""
OTHERWISE = 7919  # added to the seed of a room for each
LEAST = 1.0  # a room of less floor has hardly another place for anything, square metres

Opened = Callable[[Sequence[Furnished]], list[Furnished]]


def tried_again(
    tasks: Sequence[Task], wishes: Sequence[tuple[Wish, ...]], budgets: Sequence[Budget],
    before: Sequence[Furnished], opened: Opened,
) -> list[Furnished]:  # fmt: skip
    """The answers for all rooms with their ways ``opened``, after further tries for each room
    that gives up something essential for that, one where its own grid showed it; not where seconds
    are stated: these are spent."""
    found = opened(before)
    for room, task in enumerate(tasks):
        wanted = _lacks(before[room])
        if task.ground.area < LEAST or budgets[room].seconds is not None:
            continue
        tries = WIDER[:1] if before[room].unreached else WIDER
        for number, wider in enumerate(tries, 1):
            if _lacks(found[room]) <= wanted or (task.cancel is not None and task.cancel()):
                break
            other = furnish_by_use(_otherwise(task, number, wider), wishes[room], budgets[room])
            if _lacks(other) < _lacks(found[room]):
                trial = [other if i == room else answer for i, answer in enumerate(found)]
                found = min(found, opened(trial), key=_lacking)
    return found


def _lacks(answer: Furnished) -> int:
    """How much of what is essential is missing."""
    return sum(m.wish.rank == 0 for m in answer.missing)


def _lacking(answers: Sequence[Furnished]) -> float:
    return sum(penalty(m.wish) for answer in answers for m in answer.missing)


def _otherwise(task: Task, number: int, wider: float) -> Task:
    return task._replace(
        seed=(task.seed + number * OTHERWISE) % 2**31,
        route_width=task.route_width + wider, use_width=task.use_width + wider,
    )  # fmt: skip
