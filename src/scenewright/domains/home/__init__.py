"""Homes: every room posed, solved, dressed and told about.

The composite model of Liu, Jiang, Mao, Wang (2017): functional areas (patches) are laid out first,
furniture groups are fitted into them second.
"""

from __future__ import annotations

import hashlib
import os
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial

from scenewright._version import __version__
from scenewright.brief import Brief, Room
from scenewright.catalog import Catalog
from scenewright.domains.home.asked import check_asks, check_possible
from scenewright.domains.home.attempt import Furnished, Task
from scenewright.domains.home.cases.own_library import libraries_of, taste_of
from scenewright.domains.home.learned.amount import accustomed
from scenewright.domains.home.presets import PRESETS, Preset, preset_named
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.reasons import left_out, patches, terms
from scenewright.domains.home.second_try import tried_again
from scenewright.domains.home.tasks import completed, task_of, wishes_of
from scenewright.domains.home.variants import other_groups, varied
from scenewright.domains.home.wheelchair import furnish_by_use, widened
from scenewright.domains.home.wished.wishes import allowed, check_wishes, substituted
from scenewright.domains.home.yielding import yielded
from scenewright.domains.standing import fixed_pieces
from scenewright.plan import spaces
from scenewright.scene import Piece
from scenewright.solution import LeftOut, Solution
from scenewright.solve import Budget
from scenewright.space import Space
from scenewright.stock import catalog_of

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

__all__ = ["PRESETS", "solve"]

MOST_THREADS = 16
MANY = 9
"""Items from which on a room takes more steps for each: they are in one another's way."""


def solve(
    brief: Brief,
    *,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    variant: int = 0,
) -> Solution:
    """Furnish every room of a home.

    The work is at most ``steps`` layouts looked at for each item (less where several starts agree;
    more for a room tried again), or ``seconds`` for the whole home, else
    what the preset says, else what the solver does of itself. The same seed and steps give the
    same answer, whatever the number of ``threads`` (one for each processor, if not stated); each
    room has its own stream of random numbers.
    ``progress`` hears the share done and the room's name; when ``cancel`` answers true, what was
    found so far is returned. A ``variant`` above 0 arranges rooms around other walls and takes
    other groups for the same use; its energies are told as those of the usual problem.
    """
    started = time.perf_counter()
    chosen = preset_named(preset)
    named = solver or chosen.solver
    check_asks(brief)
    rooms = spaces(brief)
    catalog = catalog_of(brief.catalogs)
    check_wishes(brief, catalog)
    tasks = _tasks(brief, rooms, catalog, chosen, named, seed, cancel)
    tasks = [accustomed(*each, rooms) for each in zip(tasks, brief.rooms, strict=True)]
    wishes = [
        other_groups(wishes_of(brief_room, task, rooms, task.fixed), variant)
        for brief_room, task in zip(brief.rooms, tasks, strict=True)
    ]
    work = [float(len(w)) ** 1.5 for w in wishes]
    threads = min(threads or os.cpu_count() or 1, MOST_THREADS)
    each = Budget(threads=1 if len(rooms) > 1 else threads)
    pool = min(threads, len(rooms))
    budgets = [_budget(each, chosen, named, len(w), pool * b / (sum(work) or 1), seconds, steps)
               for w, b in zip(wishes, work, strict=True)]  # fmt: skip
    turned = [varied(task, variant) for task in tasks]
    answers = _run(turned, wishes, budgets, pool, progress)
    if chosen.exact:
        standing = [task.fixed for task in tasks]
        opened = partial(yielded, standing, rooms=rooms, catalog=catalog, width=brief.route_width)
        answers = tried_again(turned, wishes, budgets, answers, opened)
    return _solution(brief, tasks, answers, preset, seed, time.perf_counter() - started)


def _tasks(
    brief: Brief, rooms: tuple[Space, ...], catalog: Catalog, preset: Preset, solver: str,
    seed: int, cancel: Cancel | None,
) -> list[Task]:  # fmt: skip
    """Every room as a task, with the library that its wishes and asks leave."""
    libraries = libraries_of(brief, catalog)
    if brief.accessible:
        libraries = {taste: widened(library) for taste, library in libraries.items()}
    own = [allowed(libraries[taste_of(brief, room)], room) for room in brief.rooms]
    check_possible(brief, own)
    return [
        task_of(
            brief, room, space, tuple(fixed_pieces(room, space, catalog)), catalog, library,
            preset, solver, seed, cancel,
        )
        for room, space, library in zip(brief.rooms, rooms, own, strict=True)
    ]  # fmt: skip


def _run(
    tasks: list[Task], wishes: list[tuple[Wish, ...]], budgets: list[Budget], threads: int,
    progress: Progress | None,
) -> list[Furnished]:  # fmt: skip
    """Rooms in parallel, the largest first; compiled code runs without the interpreter's lock."""
    order = sorted(range(len(tasks)), key=lambda i: -len(wishes[i]))
    answers: dict[int, Furnished] = {}
    with ThreadPoolExecutor(threads) as pool:
        futures = {i: pool.submit(_furnish, tasks[i], wishes[i], budgets[i]) for i in order}
        for done, i in enumerate(order, 1):
            answers[i] = futures[i].result()
            if progress:
                progress(done / len(tasks), tasks[i].space.name or tasks[i].space.id)
    return [answers[i] for i in range(len(tasks))]


def _furnish(task: Task, wishes: tuple[Wish, ...], budget: Budget) -> Furnished:
    if not wishes or (task.cancel is not None and task.cancel()):
        return Furnished(0.0, (), (), (), None, 0.0, 0)
    return furnish_by_use(task, wishes, budget)


def _budget(
    least: Budget, preset: Preset, solver: str, items: int, share: float, seconds: float | None,
    steps: int | None,
) -> Budget:  # fmt: skip
    if seconds is not None:
        return least._replace(seconds=seconds * share)
    each = steps or (preset.steps if solver == preset.solver else None)
    if each is None:
        return least
    return least._replace(steps=int(each * max(items, 1) * max(items / MANY, 1.0)))


def _solution(
    brief: Brief, tasks: list[Task], answers: list[Furnished], preset: str, seed: int,
    seconds: float,
) -> Solution:  # fmt: skip
    pieces: list[Piece] = []
    for task, answer in zip(tasks, answers, strict=True):
        pieces += completed(
            task, (*task.fixed, *(p for item in answer.placed for p in item.pieces))
        )
    pairs = list(zip(tasks, answers, strict=True))
    told = {task.space.id: terms(task, answer) for task, answer in pairs}
    return Solution(
        brief=brief,
        pieces=tuple(pieces),
        patches=tuple(p for task, answer in pairs for p in patches(task, answer)),
        terms=tuple(value for values in told.values() for value in values),
        left_out=tuple(
            out
            for room, (task, answer) in zip(brief.rooms, pairs, strict=True)
            for out in _left_out(room, task, answer)
        ),
        energies={space: sum(value.cost for value in values) for space, values in told.items()},
        preset=preset,
        solver=tasks[0].solver,
        seed=seed,
        version=__version__,
        brief_hash=hashlib.sha256(brief.model_dump_json().encode()).hexdigest(),
        seconds=seconds,
        evaluations=sum(a.evaluations for a in answers),
    )


def _left_out(room: Room, task: Task, answer: Furnished) -> list[LeftOut]:
    """What is missing in a room, and what was asked for and has a substitute."""
    told = left_out(task, answer)
    standing = [p.function for p in task.fixed] + [p.wish.group for p in answer.placed]
    return [*told, *substituted(room, task.space.id, standing, (out.what for out in told))]
