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

from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.layout import SETTLED, Watch
from scenewright.core.passes import ALL_PASSES, PassOptions
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.alike import Alike, carry_over
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.checked import ids_of
from scenewright.domains.hall.demands.filling import fill_halls, settle_counts
from scenewright.domains.hall.demands.holdings import collect_demands
from scenewright.domains.hall.demands.shared import find_models, share_demands
from scenewright.domains.hall.demands.split import find_locked, split_demands
from scenewright.domains.hall.desks.staff_room import fit_with_staff
from scenewright.domains.hall.furnishing.assemble import Laid, assemble_solution
from scenewright.domains.hall.furnishing.varied import vary_halls
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.solvers.outcome import StartedHall
from scenewright.domains.hall.solving.contexts import hall_contexts, seed_of
from scenewright.domains.hall.solving.laying import HallTask, lay_best, lay_once
from scenewright.engine.rows import preset_named
from scenewright.engine.shared_progress import SharedProgress
from scenewright.engine.solve import Budget
from scenewright.engine.trace import Hear
from scenewright.engine.watched import show

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

__all__ = ["PRESETS", "hall_contexts", "problems", "solve"]


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
        for k, stream in ((k, seed_of(seed, rooms[k])) for k in busy)
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
            seed = seed_of(0, hall.space)
            _, fitted = fit_with_staff(hall, wishes, chosen.weights, catalog, seed)
            found.append(StartedHall(fitted.problem, fitted.start))
    return tuple(found)


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

    def once(on_progress: Progress | None, task: HallTask) -> Laid:
        return lay_once(brief, task, catalog, on_progress, cancel, watch)

    def lay(task: HallTask) -> Laid | None:
        if cancel is not None and cancel():
            return None
        on_progress = progress
        if shared is not None and not alone:
            on_progress = partial(shared.hear, task.number)
        cancelled = cancel or (lambda: False)
        laid = lay_best(brief, task, partial(once, on_progress), cancelled)
        if laid.picture:
            show(watch, task.hall.space.id, partial(tuple, laid.picture), SETTLED)
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
