"""Halls: exhibitions, shops, reading rooms, auditoria.

Graph-driven Metropolis-Hastings after Cao, Cheng, Zhang 2024: groups of like objects follow
patterns, patterns stand in functional zones; the parameters of the patterns are optimised.
"""

from __future__ import annotations

import os
import time
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import NamedTuple
from zlib import crc32

import numpy as np

from scenewright.building.plan import plan_rooms
from scenewright.building.standing import fixed_pieces, reaching_in
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.layout import SETTLED, BestLayout, Watch
from scenewright.core.passes import ALL_PASSES, PassOptions
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.hall.accessories import count_groups
from scenewright.domains.hall.alike import Alike, carry_over
from scenewright.domains.hall.build_problem import HallContext, hall_of
from scenewright.domains.hall.compose import compose
from scenewright.domains.hall.demands.checked import ids_of
from scenewright.domains.hall.demands.filling import fill_halls, settle_counts
from scenewright.domains.hall.demands.holdings import collect_demands, restrict_patterns
from scenewright.domains.hall.demands.open_numbers import with_theme
from scenewright.domains.hall.demands.shared import find_models, share_demands
from scenewright.domains.hall.demands.split import find_locked, split_demands
from scenewright.domains.hall.desks.staff_room import fit_with_staff
from scenewright.domains.hall.desks.unserved import count_unserved
from scenewright.domains.hall.furnishing.assemble import Laid, assemble_solution
from scenewright.domains.hall.furnishing.layout import furnish_guided
from scenewright.domains.hall.furnishing.on_stage import put_on_stage
from scenewright.domains.hall.furnishing.standing import keep_standing
from scenewright.domains.hall.furnishing.varied import vary_halls
from scenewright.domains.hall.gates.boarding import set_at_doors
from scenewright.domains.hall.gates.leaves import with_leaves
from scenewright.domains.hall.presets import PRESETS, HallPreset, count_steps
from scenewright.domains.hall.search import HallSearch, may_retry, name_objects, search_layout
from scenewright.domains.hall.settings import USUAL_ZONING, ZoningSettings
from scenewright.domains.hall.shortfall.measures import (
    falls_short,
    leaves_open,
    measure_shortfall,
    measure_shortfall_and_staff,
)
from scenewright.domains.hall.shortfall.unplaceable import left_out
from scenewright.domains.hall.shortfall.unreached import drop_unreached
from scenewright.domains.hall.solvers.outcome import StartedHall
from scenewright.domains.hall.zoning.move_borders import (
    move_borders,
    read_slack,
    search_with_borders,
)
from scenewright.domains.hall.zoning.zones import HallPlan, borders_of, zones_of
from scenewright.engine.rows import preset_named
from scenewright.engine.shared_progress import SharedProgress
from scenewright.engine.solve import Budget
from scenewright.engine.trace import Hear, hear_in

AFRESH, AGAIN = 3, 104_729
"""How often a hall is laid out again where nobody can serve at some of its desks, once where
something was given up for want of a way to it, and the distance of the seeds."""
Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

__all__ = ["PRESETS", "problems", "solve"]


class HallTask(NamedTuple):
    """One hall to lay out, and how."""

    hall: HallContext
    number: int
    preset: HallPreset
    solver: str
    budget: Budget
    seed: int
    lean: int
    passes: PassOptions = ALL_PASSES


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
    lean: int = 0,
    passes: PassOptions = ALL_PASSES,
    hear: Hear | None = None,
) -> Solution:
    """Lay out every hall of a brief.

    The work is ``steps`` looked-at layouts for each hall, or ``seconds`` for all, else what the
    preset says. The same seed and steps give the same answer on any number of ``threads``.
    ``plan`` is that of the brief (made unless given).
    ``variant`` takes another proposal of zones where the brief leaves them open; ``lean`` above 0
    narrows every demand to one of its patterns, another for another number. ``progress`` gets
    the share done and what is done, ``watch`` the best layouts of objects; when ``cancel`` answers
    true, what was found so far is returned. ``passes`` switches retouches off or hears of them;
    ``hear`` gets the steps of a traced solver.
    """
    started, chosen = time.perf_counter(), preset_named(PRESETS, preset)
    named = solver or chosen.solver
    passes = passes._replace(cancelled=cancel) if cancel is not None else passes
    catalog, rooms = catalog_of(brief.catalogs), (plan or plan_rooms(brief)).spaces
    threads = min(threads or os.cpu_count() or 1, 16)
    zoning = chosen.settings.zoning
    models, brief = find_models(brief), share_demands(brief)
    halls = hall_contexts(brief, rooms, catalog, seed, variant, zoning)
    brief = fill_halls(brief, halls, catalog, chosen.settings.whole)
    busy = [k for k, room in enumerate(brief.rooms) if room.demands]
    each = Budget(threads=threads if len(busy) == 1 else 1, hear=hear)
    share = min(threads, max(len(busy), 1)) / max(len(busy), 1)
    if seconds is not None:
        each = each._replace(seconds=seconds * share)
    tasks = {
        k: HallTask(halls[k], k, chosen, named, each._replace(steps=steps), stream, lean, passes)
        for k, stream in ((k, _stream(seed, rooms[k])) for k in busy)
    }
    first = {k: task for k, task in tasks.items() if k not in models}
    laid = _run(brief, first, catalog, threads, progress, cancel, watch)
    run = partial(_run, brief, catalog=catalog, threads=threads, progress=progress, cancel=cancel)
    others = {k: task for k, task in tasks.items() if models.get(k) in laid}
    told = _lay_alike(brief, others, halls, laid, models, partial(run, watch=watch))
    notes = list(dict.fromkeys([*brief.notes, *told]))
    brief = brief.model_copy(update={"notes": notes}) if told else brief
    stand = {k: (*halls[k].fixed, *answer.pieces) for k, answer in laid.items()}
    brief = settle_counts(brief, halls, stand)
    laid = laid if chosen.settings.printed else vary_halls(laid, catalog, seed)
    return assemble_solution(brief, halls, laid, preset, named, seed, time.perf_counter() - started)


def _lay_alike(
    brief: Brief,
    tasks: dict[int, HallTask],
    halls: list[HallContext],
    laid: dict[int, Laid],
    models: Mapping[int, int],
    run: Callable[[dict[int, HallTask]], dict[int, Laid]],
) -> list[str]:
    """Lay out the halls of ``tasks`` like their models and say how they differ; ``halls`` and
    ``laid`` get what is placed there. Where that leaves out more than laying one out alone, it
    is."""
    alike = {
        k: carry_over(
            halls[models[k]].space, halls[k], laid[models[k]].pieces, ids_of(brief.rooms[k].demands)
        )
        for k in tasks
    }
    around = {k: _with_fixed(halls[k], one.pieces) for k, one in alike.items()}
    found = run({k: t._replace(hall=around[k]) for k, t in tasks.items()}) if tasks else {}
    again = {k: tasks[k] for k, one in found.items() if alike[k].pieces and one.left_out}
    for k, other in (run(again) if again else {}).items():
        if len(other.left_out) < len(found[k].left_out):
            found[k], around[k] = other, halls[k]
            alike[k] = Alike((), f"{halls[k].space.id} is laid out by itself: more has room so")
    laid |= found
    for k in found:
        halls[k] = around[k]
    return [alike[k].told for k in found]


def _with_fixed(hall: HallContext, pieces: tuple[Piece, ...]) -> HallContext:
    return hall._replace(fixed=(*hall.fixed, *pieces))


def problems(
    brief: Brief, preset: str = "default", *, plan: Plan | None = None
) -> tuple[StartedHall, ...]:
    """The halls of a brief that are to hold something as problems of placing their groups, each
    with a first layout, for solvers of :data:`scenewright.domains.hall.solvers.HALL_SOLVERS` run
    by oneself.

    >>> from scenewright.formats import read
    >>> len(problems(read("sample:hall-shop")))
    1
    """
    chosen, rooms = preset_named(PRESETS, preset), (plan or plan_rooms(brief)).spaces
    catalog = catalog_of(brief.catalogs)
    found = []
    halls = hall_contexts(brief, rooms, catalog, 0, 0, chosen.settings.zoning)
    brief = fill_halls(brief, halls, catalog, chosen.settings.whole)
    for number, one in enumerate(halls):
        hall = one._replace(settings=chosen.settings)
        asked = collect_demands(brief, number, find_locked(hall), catalog)
        wishes = split_demands(hall, asked, catalog, chosen.settings.whole, []).wishes
        if wishes:
            seed = _stream(0, hall.space)
            _, fitted = fit_with_staff(hall, wishes, chosen.weights, catalog, seed)
            found.append(StartedHall(fitted.problem, fitted.start))
    return tuple(found)


def _stream(seed: int, space: Space) -> int:
    sequence = np.random.SeedSequence([seed, crc32(space.id.encode())])
    return int(sequence.generate_state(1)[0]) % 2**31


def hall_contexts(
    brief: Brief,
    rooms: tuple[Space, ...],
    catalog: Catalog,
    seed: int,
    variant: int,
    zoning: ZoningSettings = USUAL_ZONING,
) -> list[HallContext]:
    """Every hall of a brief: its zones, walls and fixed objects."""
    pairs = zip(brief.rooms, rooms, strict=True)
    standing = [tuple(fixed_pieces(room, space, catalog)) for room, space in pairs]
    beside = reaching_in(standing, rooms)
    plans = [zones_of(brief, k, space, seed, variant, zoning) for k, space in enumerate(rooms)]
    return [
        _hall(brief, plan, *there)
        for plan, there in zip(plans, zip(rooms, standing, beside, strict=True), strict=True)
    ]


def _hall(
    brief: Brief, plan: HallPlan, space: Space, fixed: tuple[Piece, ...], beside: tuple[Piece, ...]
) -> HallContext:
    borders, passage = borders_of(plan, space), brief.passage_width
    return hall_of(space, plan, borders, fixed, brief.route_width, beside, passage)


def may_lay_again(task: HallTask) -> bool:
    """Whether a hall may be laid out once more: not as printed, nor where time is measured."""
    return not task.preset.settings.whole and task.budget.seconds is None


def _run(
    brief: Brief,
    tasks: dict[int, HallTask],
    catalog: Catalog,
    threads: int,
    progress: Progress | None,
    cancel: Cancel | None,
    watch: Watch | None,
) -> dict[int, Laid]:
    """Halls in parallel; compiled code runs without the interpreter's lock."""
    work = [float(number in tasks) for number in range(len(brief.rooms))]
    shared = None if progress is None else SharedProgress(progress, work)
    alone = len(tasks) == 1

    def lay_once(on_progress: Progress | None, task: HallTask) -> Laid:
        return _lay(brief, task, catalog, on_progress, cancel, watch)

    def lay(task: HallTask) -> Laid | None:
        if cancel is not None and cancel():
            return None
        on_progress = progress
        if shared is not None and not alone:
            on_progress = partial(shared.hear, task.number)
        cancelled = cancel or (lambda: False)
        laid = _lay_best(brief, task, partial(lay_once, on_progress), cancelled)
        if watch is not None and laid.picture:
            rows = partial(tuple, laid.picture)
            watch(BestLayout(task.hall.space.id, 1.0, laid.energy, rows, SETTLED))
        return laid

    answers: dict[int, Laid] = {}
    with ThreadPoolExecutor(max(min(threads, len(tasks)), 1)) as pool:
        futures = {number: pool.submit(lay, task) for number, task in tasks.items()}
        for done, (number, future) in enumerate(futures.items(), 1):
            found = future.result()
            if found is not None:
                answers[number] = found
            if shared and done < len(tasks):
                shared.ended(number, tasks[number].hall.space.name)
    if progress and tasks:
        progress(1.0, tasks[number].hall.space.name)
    return answers


def _lay_best(
    brief: Brief, task: HallTask, lay: Callable[[HallTask], Laid], cancelled: Cancel
) -> Laid:
    """A hall laid out, again where nobody can serve at some of its desks or something was given
    up, until it is ``cancelled``."""
    laid = _lay_free(brief, task, lay)
    for number in range(1, AFRESH + 1):
        unserved = count_unserved(task.hall.space, laid.pieces) > 0
        wanted = unserved or (number == 1 and laid.given_up)
        may = may_lay_again(task) and task.solver == task.preset.solver
        if not wanted or not may or cancelled():
            break
        other = _lay_free(brief, task._replace(seed=task.seed + AGAIN * number), lay)
        laid = min((laid, other), key=partial(measure_shortfall_and_staff, task.hall.space))
    return laid


def _lay_free(brief: Brief, task: HallTask, lay: Callable[[HallTask], Laid]) -> Laid:
    """A hall laid out, with its counters in other forms where it falls_short something."""
    laid = lay(task)
    open_ = leaves_open(brief.rooms[task.number].demands)
    if not (open_ and falls_short(laid) and may_lay_again(task)):
        return laid
    free = task.preset._replace(settings=task.preset.settings._replace(lined=False))
    return min((laid, lay(task._replace(preset=free))), key=measure_shortfall)


def _lay(
    brief: Brief,
    task: HallTask,
    catalog: Catalog,
    progress: Progress | None,
    cancel: Cancel | None,
    watch: Watch | None,
) -> Laid:
    preset = task.preset
    hall = task.hall._replace(settings=preset.settings)
    asked = collect_demands(brief, task.number, find_locked(hall), catalog)
    asked = restrict_patterns(asked, task.lean)
    together = preset.settings.whole or task.solver != "anneal"
    hall, roles = with_theme(brief, task.number, hall, together)
    hall, asked, boarding, played = set_at_doors(hall, asked, catalog, roles)
    locked, weights, seed = find_locked(hall), preset.weights, task.seed
    wishes, carried, small = split_demands(hall, asked, catalog, together, played)
    wishes, fitted = fit_with_staff(hall, wishes, weights, catalog, seed, cancel, small)
    if not fitted.units:
        laid = keep_standing(hall, locked, carried, left_out(hall, wishes, []), catalog)
        return laid._replace(pieces=(*boarding, *laid.pieces))
    budget = task.budget._replace(hear=hear_in(task.budget.hear, task.hall.space.id))
    if budget.steps is None and budget.seconds is None and task.solver == preset.solver:
        budget = budget._replace(steps=count_steps(preset, len(fitted.units) + count_groups(small)))
    search = HallSearch(
        hall,
        wishes,
        preset,
        task.solver,
        budget,
        task.seed,
        catalog,
        task.budget.steps is not None,
        watch,
        task.passes,
    )
    slack = read_slack(brief.rooms[task.number], hall)
    begun = search_with_borders(search, slack)
    fitted, found = search_layout(begun, fitted, progress, cancel)
    given_up, crowding = frozenset[int](), frozenset[int]()
    shifts: tuple[tuple[str, float], ...] = ()
    if may_retry(search) and not (cancel is not None and cancel()):
        fitted, found, given_up, crowding = drop_unreached(search, fitted, found)
        hall, fitted, found, shifts = move_borders(search, fitted, found, slack, progress, cancel)
    missing = left_out(hall, wishes, fitted.units, given_up, crowding)
    best = found.layouts[0]
    if may_retry(search):
        fitted, best, missing = compose(search._replace(hall=hall), fitted, best, missing)
    search = search._replace(hall=hall, wishes=[*wishes, *small])
    laid = furnish_guided(search, fitted, best, locked, missing, found.evaluations)
    on, groups, out = put_on_stage(hall, carried, (*hall.fixed, *laid.pieces), catalog)
    return laid._replace(
        pieces=with_leaves(hall.space, (*boarding, *laid.pieces, *on), catalog),
        groups=(*laid.groups, *groups),
        left_out=(*laid.left_out, *out),
        zones=hall.plan.zones,
        shifts=shifts,
        given_up=bool(given_up or crowding),
        picture=name_objects(search, fitted, best.boxes),
    )
