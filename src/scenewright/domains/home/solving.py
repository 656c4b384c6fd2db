"""Homes: every room posed, solved, dressed and explained.

The composite model of Liu, Jiang, Mao, Wang (2017): functional areas (patches) are laid out first,
furniture groups are fitted into them second.
"""

from __future__ import annotations

import hashlib
import os
import time
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from itertools import chain

from scenewright._version import __version__
from scenewright.building.plan import plan_rooms
from scenewright.building.standing import fixed_pieces, reaching_in
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.core.catalog import Catalog
from scenewright.core.layout import FIT, REPAIR, ROUTES, Watch
from scenewright.core.passes import ALL_PASSES, PassOptions
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut, Solution
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import RoomAnswer, RoomTask, build_task_problem
from scenewright.domains.home.attempts.drafts import choose_open, furnish_best
from scenewright.domains.home.attempts.picturing import show_groups, show_home, show_settled
from scenewright.domains.home.attempts.second_try import tried_again
from scenewright.domains.home.attempts.variants import other_groups, vary_task
from scenewright.domains.home.cases.own_library import libraries_of, taste_of
from scenewright.domains.home.composing.compose import compose
from scenewright.domains.home.composing.home_passes import ALIGNING, MENDING, SETTLING, finish_home
from scenewright.domains.home.composing.homewide.settling import HomeState
from scenewright.domains.home.furnishing.look import apply_style
from scenewright.domains.home.grounds.closets import has_closet, list_wet_walls
from scenewright.domains.home.grounds.open_plan import share_open_plans
from scenewright.domains.home.learned.density import match_learned_density
from scenewright.domains.home.needs.household import (
    decide_household,
    explain_no_kitchen,
    seat_residents,
)
from scenewright.domains.home.needs.stated import AskedRooms, measure_shortage, meet_stated_needs
from scenewright.domains.home.presets import PRESETS, HomePreset
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.reasons import left_out, patches, terms
from scenewright.domains.home.room import count_steps
from scenewright.domains.home.shortfall import complete_account, list_short_beds
from scenewright.domains.home.tasks import add_lamps_and_curtains, task_of, wishes_of
from scenewright.domains.home.walking.entrances import entered_by
from scenewright.domains.home.walking.home_floor import HomeFloor, join_floors
from scenewright.domains.home.walking.kept_ways import find_barring_screens
from scenewright.domains.home.walking.remove_blockers import remove_blockers
from scenewright.domains.home.wheelchair import furnish_by_use, widen_library
from scenewright.domains.home.wished.requests import check_asks, check_possible
from scenewright.domains.home.wished.shared_wishes import share_wishes
from scenewright.domains.home.wished.wishes import check_wishes, list_substitutes, restrict_library
from scenewright.engine.rows import preset_named
from scenewright.engine.shared_progress import SharedProgress
from scenewright.engine.solve import Budget
from scenewright.engine.trace import Hear, hear_in

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

__all__ = ["PRESETS", "problems", "solve"]

MOST_THREADS = 16
LAST = 0.02
"""Share of the progress of all rooms that is left for the routes of the whole home."""


def solve(
    brief: Brief,
    *,
    plan: Plan | None = None,
    preset: str = "default",
    solver: str | None = None,
    seconds: float | None = None,
    steps: int | None = None,
    seed: int = 0,
    threads: int | None = None,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    watch: Watch | None = None,
    variant: int = 0,
    passes: PassOptions = ALL_PASSES,
    hear: Hear | None = None,
) -> Solution:
    """Furnish every room of a home.

    The work is at most ``steps`` layouts looked at for each item (less where several starts agree;
    more for a room tried again), or ``seconds`` for the whole home, else
    what the preset says, else what the solver does of itself. The same seed and steps give the
    same answer, whatever the number of ``threads`` (one for each processor, if not stated); each
    room has its own stream of random numbers.
    ``plan`` is that of the brief (made unless given). ``progress`` gets the share done and the
    room's name, ``watch`` the best layouts of groups in each room; when ``cancel`` answers true,
    what was found so far is returned. A ``variant`` above 0 arranges rooms around other walls and
    takes other groups for the same use; its energies are reported as those of the usual problem.
    ``passes`` switches passes off or hears of them; ``hear`` gets the steps of a traced solver.
    """
    started = time.perf_counter()
    chosen = preset_named(PRESETS, preset)
    named = solver or chosen.solver
    check_asks(brief)
    rooms = (plan or plan_rooms(brief)).spaces
    catalog = catalog_of(brief.catalogs)
    check_wishes(brief, catalog)
    tasks, usual = prepare_rooms(brief, rooms, catalog, chosen, named, seed, cancel)
    wishes = [other_groups(asked, variant) for asked in usual]
    work = [float(len(w)) ** 1.5 for w in wishes]
    threads = min(threads or os.cpu_count() or 1, MOST_THREADS)
    each = Budget(threads=1 if len(rooms) > 1 else threads, hear=hear)
    pool = min(threads, len(rooms))
    budgets = [
        _budget(
            hear_room(each, task), task, named, len(w), pool * b / (sum(work) or 1), seconds, steps
        )
        for task, w, b in zip(tasks, wishes, work, strict=True)
    ]
    turned = [vary_task(task._replace(watch=watch, passes=passes), variant) for task in tasks]
    shared = None if progress is None else SharedProgress(progress, [*work, LAST * sum(work)])
    answers = _run(turned, wishes, budgets, pool, shared)
    floors = join_floors(rooms, brief.route_width) if chosen.settings.exact else ()
    if floors:
        every = AskedRooms(turned, wishes, budgets)
        answers = _walk_home(brief, every, answers, floors, again=seconds is None)
    show_settled(turned, answers)
    if shared is not None:
        shared.ended(len(work), "routes")
    spent = time.perf_counter() - started
    return assemble_solution(brief, tasks, answers, floors, preset, seed, spent)


def _walk_home(
    brief: Brief,
    every: AskedRooms,
    answers: list[RoomAnswer],
    floors: Sequence[HomeFloor],
    again: bool,
) -> list[RoomAnswer]:
    """The answers with the ways of the whole home open, rooms tried again that lose something
    essential to that, and ``again`` those that lack what the household states it needs; then all
    passes over the whole home (:mod:`.composing.home_passes`)."""
    rooms = tuple(task.space for task in every.tasks)
    opened = partial(
        remove_blockers,
        [task.fixed for task in every.tasks],
        rooms=rooms,
        floors=floors,
        catalog=every.tasks[0].catalog,
        settings=every.tasks[0].preset.settings,
    )
    begun, show = answers, partial(show_home, every.tasks)
    answers = choose_open(every, answers, opened)
    show(begun, answers, ROUTES, "ways through the home are kept open")
    found = tried_again(every.tasks, every.wishes, every.budgets, answers, opened)
    show(answers, found, ROUTES, "furnished again: it had lost something essential to a way")
    household = decide_household(rooms, brief.residents)
    if again:
        lacking, found = found, meet_stated_needs(household, every, found, opened)
        show(lacking, found, REPAIR, "what those who live there need")
    home = HomeState(every.tasks, opened, household, not again, every.wishes, every.budgets)
    mended = finish_home(home, found, MENDING)
    if measure_shortage(household, mended) > measure_shortage(household, found):
        show(mended, found, REPAIR, "taken back: the home lacked more of what it needs")
        mended = found
    return finish_home(home, mended, (*SETTLING, *ALIGNING))


def problems(
    brief: Brief, preset: str = "default", *, plan: Plan | None = None
) -> tuple[Problem, ...]:
    """The rooms of a home that are to hold something as problems of placing their patches, for
    solvers of :data:`scenewright.domains.home.solvers.SOLVERS` run by oneself.

    >>> from scenewright.formats import read
    >>> len(problems(read("sample:home-room")))
    1
    """
    chosen, rooms = preset_named(PRESETS, preset), (plan or plan_rooms(brief)).spaces
    catalog = catalog_of(brief.catalogs)
    each = zip(*prepare_rooms(brief, rooms, catalog, chosen, chosen.solver, 0), strict=True)
    return tuple(build_task_problem(task, asked, task.ground) for task, asked in each if asked)


def prepare_rooms(
    brief: Brief,
    rooms: tuple[Space, ...],
    catalog: Catalog,
    preset: HomePreset,
    solver: str,
    seed: int,
    cancel: Cancel | None = None,
) -> tuple[list[RoomTask], list[tuple[Wish, ...]]]:
    """Every room as a task, and what it is to hold."""
    tasks = _tasks(brief, rooms, catalog, preset, solver, seed, cancel)
    tasks = share_open_plans(tasks, brief.rooms, rooms)
    tasks = [match_learned_density(*each, rooms) for each in zip(tasks, brief.rooms, strict=True)]
    wishes = [
        wishes_of(brief_room, task, rooms, task.fixed)
        for brief_room, task in zip(brief.rooms, tasks, strict=True)
    ]
    household = decide_household(rooms, brief.residents)
    seated = [
        task._replace(library=seat_residents(household, task.space.id, task.library))
        for task in tasks
    ]
    return seated, share_wishes(household, tasks, wishes)


def _tasks(
    brief: Brief,
    rooms: tuple[Space, ...],
    catalog: Catalog,
    preset: HomePreset,
    solver: str,
    seed: int,
    cancel: Cancel | None,
) -> list[RoomTask]:
    """Every room as a task, with the library that its wishes and asks leave."""
    libraries = libraries_of(brief, catalog)
    if brief.accessible:
        libraries = {taste: widen_library(library) for taste, library in libraries.items()}
    own = [restrict_library(libraries[taste_of(brief, room)], room) for room in brief.rooms]
    check_possible(brief, own)
    standing = [
        tuple(fixed_pieces(*each, catalog)) for each in zip(brief.rooms, rooms, strict=True)
    ]
    each = zip(brief.rooms, rooms, standing, own, reaching_in(standing, rooms), strict=True)
    return [
        task_of(
            brief,
            room,
            space,
            fixed,
            catalog,
            library,
            preset,
            solver,
            seed,
            cancel,
            beside,
            entered_by(space, rooms),
            has_closet(space, rooms),
            list_wet_walls(space, rooms),
        )
        for room, space, fixed, library, beside in each
    ]


def _run(
    tasks: list[RoomTask],
    wishes: list[tuple[Wish, ...]],
    budgets: list[Budget],
    threads: int,
    progress: SharedProgress | None,
) -> list[RoomAnswer]:
    """Rooms in parallel, the largest first; compiled code runs without the interpreter's lock."""
    order = sorted(range(len(tasks)), key=lambda i: -len(wishes[i]))
    answers: dict[int, RoomAnswer] = {}
    with ThreadPoolExecutor(threads) as pool:
        futures = {}
        for i in order:
            listener = None if progress is None else progress.part(i, _name(tasks[i]))
            task = tasks[i]._replace(progress=listener)
            futures[i] = pool.submit(_furnish, task, wishes[i], budgets[i])
        for i in order:
            answers[i] = futures[i].result()
            if progress is not None:
                progress.ended(i, _name(tasks[i]))
    return [answers[i] for i in range(len(tasks))]


def _name(task: RoomTask) -> str:
    return task.space.name or task.space.id


def _furnish(task: RoomTask, wishes: tuple[Wish, ...], budget: Budget) -> RoomAnswer:
    if not wishes or task.cancelled():
        return RoomAnswer(0.0, (), (), (), None, 0.0, 0)

    def furnish(draft: RoomTask) -> RoomAnswer:
        furnished = furnish_by_use(draft, wishes, budget)
        show_groups(draft, furnished.placed, FIT, "furniture fitted into its areas")
        return compose(draft, furnished)

    return furnish_best(task, wishes, furnish) if budget.seconds is None else furnish(task)


def hear_room(budget: Budget, task: RoomTask) -> Budget:
    """A budget whose listener hears of the room of a task."""
    return budget._replace(hear=hear_in(budget.hear, task.space.id))


def _budget(
    least: Budget,
    task: RoomTask,
    solver: str,
    items: int,
    share: float,
    seconds: float | None,
    steps: int | None,
) -> Budget:
    if seconds is not None:
        return least._replace(seconds=seconds * share)
    each = steps or (task.preset.steps if solver == task.preset.solver else None)
    if each is None:
        return least
    return least._replace(steps=count_steps(task, each, items))


def assemble_solution(
    brief: Brief,
    tasks: list[RoomTask],
    answers: list[RoomAnswer],
    floors: Sequence[HomeFloor],
    preset: str,
    seed: int,
    seconds: float,
) -> Solution:
    """The solution of all rooms, with lamps and curtains that leave the ways over the ``floors``
    of the home open."""
    placed = [
        (*task.fixed, *(p for item in answer.placed for p in item.pieces))
        for task, answer in zip(tasks, answers, strict=True)
    ]
    stands = [add_lamps_and_curtains(task, here) for task, here in zip(tasks, placed, strict=True)]
    rooms, catalog = [task.space for task in tasks], tasks[0].catalog
    narrow = find_barring_screens(chain(*placed), [*chain(*stands)], rooms, floors, catalog)
    stands = [[narrow.get(p.id, p) for p in here] for here in stands]
    pairs = list(zip(tasks, answers, strict=True))
    entries = {task.space.id: terms(task, answer) for task, answer in pairs}
    household = decide_household(rooms, brief.residents)
    return Solution(
        brief=brief,
        pieces=apply_style(
            (piece for here in stands for piece in here),
            brief,
            (space.id for space in rooms),
            catalog,
            seed,
        ),
        patches=tuple(p for task, answer in pairs for p in patches(task, answer)),
        terms=tuple(value for values in entries.values() for value in values),
        left_out=(
            *(
                explain_no_kitchen(household, room, out)
                for room, (task, answer), here in zip(brief.rooms, pairs, stands, strict=True)
                for out in _left_out(room, task, answer, here)
            ),
            *list_short_beds(brief.residents, rooms, chain(*stands)),
        ),
        energies={space: sum(value.cost for value in values) for space, values in entries.items()},
        preset=preset,
        solver=tasks[0].solver,
        seed=seed,
        version=__version__,
        brief_hash=hashlib.sha256(brief.model_dump_json().encode()).hexdigest(),
        seconds=seconds,
        evaluations=sum(a.evaluations for a in answers),
    )


def _left_out(
    room: Room, task: RoomTask, answer: RoomAnswer, pieces: Sequence[Piece]
) -> list[LeftOut]:
    """What is missing in a room, and what was asked for and has a substitute."""
    listed = complete_account(left_out(task, answer), room, task, answer, pieces)
    standing = [p.function for p in task.fixed] + [p.wish.group for p in answer.placed]
    return [*listed, *list_substitutes(room, task.space.id, standing, (out.what for out in listed))]
