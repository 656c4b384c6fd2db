"""Halls: exhibitions, shops, reading rooms, auditoria.

Graph-driven Metropolis-Hastings after Cao, Cheng, Zhang 2024: groups of like objects follow
patterns, patterns stand in functional zones; the parameters of the patterns are optimised.
"""

from __future__ import annotations

import hashlib
import os
import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple
from zlib import crc32

import numpy as np

from scenewright._version import __version__
from scenewright.brief import Brief
from scenewright.catalog import Catalog
from scenewright.domains.hall.chairs import grown, with_chairs
from scenewright.domains.hall.desks import turned
from scenewright.domains.hall.dress import dressed, kept_groups, partitions, placed_groups
from scenewright.domains.hall.fit import fit
from scenewright.domains.hall.pose import Hall, hall_of
from scenewright.domains.hall.presets import PRESETS, USUAL, HallPreset
from scenewright.domains.hall.search import Search, searched
from scenewright.domains.hall.shortfall import left_out
from scenewright.domains.hall.tour import tour
from scenewright.domains.hall.wanted import leaning, wanted
from scenewright.domains.standing import fixed_pieces
from scenewright.energy import Part
from scenewright.errors import InputError
from scenewright.hall_energy import parts_of
from scenewright.plan import spaces
from scenewright.scene import Piece
from scenewright.scene_graph import PlacedGroup, SceneGraph, Tour
from scenewright.solution import LeftOut, Solution, TermValue
from scenewright.solve import Budget
from scenewright.solvers.hall_found import measured
from scenewright.space import Space
from scenewright.stock import catalog_of
from scenewright.zones import borders_of, zones_of

Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]

__all__ = ["PRESETS", "solve"]


class Task(NamedTuple):
    """One hall to lay out, and how."""

    hall: Hall
    number: int
    preset: HallPreset
    solver: str
    budget: Budget
    seed: int
    lean: int


class Laid(NamedTuple):
    """One hall laid out."""

    pieces: tuple[Piece, ...]
    groups: tuple[PlacedGroup, ...]
    partitions: tuple[str, ...]
    parts: tuple[Part, ...]
    left_out: tuple[LeftOut, ...]
    energy: float
    evaluations: int
    tour: Tour | None


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
    lean: int = 0,
) -> Solution:
    """Lay out every hall of a brief.

    The work is ``steps`` looked-at layouts for each hall, or ``seconds`` for all, else what the
    preset says. The same seed and steps give the same answer on any number of ``threads``.
    ``variant`` takes another proposal of zones where the brief leaves them open; ``lean`` above 0
    narrows every demand to one of its patterns, another for another number. ``progress`` hears
    the share done and what is done; when ``cancel`` answers true, what was found so far is
    returned.
    """
    started = time.perf_counter()
    chosen = _preset(preset)
    named = solver or chosen.solver
    catalog, rooms = catalog_of(brief.catalogs), spaces(brief)
    threads = min(threads or os.cpu_count() or 1, 16)
    halls = [_hall(brief, k, space, catalog, seed, variant) for k, space in enumerate(rooms)]
    busy = [k for k, room in enumerate(brief.rooms) if room.demands]
    each = Budget(threads=threads if len(busy) == 1 else 1)
    share = min(threads, max(len(busy), 1)) / max(len(busy), 1)
    if seconds is not None:
        each = each._replace(seconds=seconds * share)
    tasks = {
        k: Task(halls[k], k, chosen, named, each._replace(steps=steps), stream, lean)
        for k, stream in ((k, _stream(seed, rooms[k])) for k in busy)
    }
    laid = _run(brief, tasks, catalog, threads, progress, cancel)
    return _solution(brief, halls, laid, preset, named, seed, time.perf_counter() - started)


def _preset(name: str) -> HallPreset:
    if name not in PRESETS:
        raise InputError(f"there is no preset '{name}'", "one of " + ", ".join(PRESETS))
    return PRESETS[name]


def _stream(seed: int, space: Space) -> int:
    sequence = np.random.SeedSequence([seed, crc32(space.id.encode())])
    return int(sequence.generate_state(1)[0]) % 2**31


def _hall(
    brief: Brief, number: int, space: Space, catalog: Catalog, seed: int, variant: int
) -> Hall:
    plan = zones_of(brief, number, space, seed=seed, variant=variant)
    fixed = tuple(fixed_pieces(brief.rooms[number], space, catalog))
    return hall_of(space, plan, borders_of(plan, space), fixed, brief.route_width)


def _run(
    brief: Brief, tasks: dict[int, Task], catalog: Catalog, threads: int,
    progress: Progress | None, cancel: Cancel | None,
) -> dict[int, Laid]:  # fmt: skip
    """Halls in parallel; compiled code runs without the interpreter's lock."""
    alone = len(tasks) == 1

    def lay(task: Task) -> Laid | None:
        if cancel is not None and cancel():
            return None
        inner = progress if alone else None
        return _lay(brief, task, catalog, inner, cancel)

    answers: dict[int, Laid] = {}
    with ThreadPoolExecutor(max(min(threads, len(tasks)), 1)) as pool:
        futures = {number: pool.submit(lay, task) for number, task in tasks.items()}
        for done, (number, future) in enumerate(futures.items(), 1):
            found = future.result()
            if found is not None:
                answers[number] = found
            if progress:
                progress(done / len(tasks), tasks[number].hall.space.name)
    return answers


def _lay(
    brief: Brief, task: Task, catalog: Catalog, progress: Progress | None, cancel: Cancel | None
) -> Laid:
    hall, preset = task.hall, task.preset
    locked = tuple(piece for piece in hall.fixed if piece.function not in ("", "fixed"))
    wishes = leaning(wanted(brief, task.number, locked, catalog), task.lean)
    fitted = fit(hall, wishes, preset.weights, catalog, task.seed, preset.whole)
    if not fitted.units:
        missing = left_out(hall, wishes, fitted.units)
        return Laid((), kept_groups(hall, locked), (), (), missing, 0.0, 0, None)
    budget = task.budget
    if budget.steps is None and budget.seconds is None and task.solver == preset.solver:
        scale = 1.0 if preset.whole else max(len(fitted.units) / USUAL, 1.0)
        budget = budget._replace(steps=int(preset.steps * scale))
    search = Search(hall, wishes, preset, task.solver, budget, task.seed, catalog,
                    task.budget.steps is not None)  # fmt: skip
    fitted, found = searched(search, fitted, progress, cancel)
    missing = left_out(hall, wishes, fitted.units)
    best = turned(hall, wishes, fitted.units, fitted.problem, found.layouts[0])
    p, s, lost = measured(fitted.problem, best)
    objects = dressed(hall, wishes, fitted.units, fitted.problem, best.boxes, catalog)
    walls = partitions(hall, fitted.problem, best.kept, catalog)
    chairs = with_chairs(objects, (*hall.fixed, *walls), catalog)
    groups = (
        *kept_groups(hall, locked),
        *placed_groups(hall, wishes, fitted.units, fitted.problem, best.kept, objects),
    )
    parts = parts_of(fitted.problem, p, s, lost)
    graph = SceneGraph(hall.plan.zones, hall.plan.links, groups, tuple(w.id for w in walls))
    out = {wish.id: wish.chairs for wish in wishes}
    seated = (grown(piece, out[piece.function]) for piece in objects)
    every = (*hall.fixed, *walls, *seated)
    way = tour(hall.space, every, graph, catalog, hall.route)
    return Laid((*walls, *objects, *chairs), groups, graph.partitions, parts, missing,
                sum(part.cost for part in parts), found.evaluations, way)  # fmt: skip


def _solution(
    brief: Brief, halls: list[Hall], laid: dict[int, Laid], preset: str, solver: str, seed: int,
    seconds: float,
) -> Solution:  # fmt: skip
    found = [laid.get(number) for number in range(len(halls))]
    done = [answer for answer in found if answer is not None]
    pieces = [
        piece
        for hall, answer in zip(halls, found, strict=True)
        for piece in (*hall.fixed, *(answer.pieces if answer else ()))
    ]
    graph = SceneGraph(
        tuple(zone for hall in halls for zone in hall.plan.zones),
        tuple(link for hall in halls for link in hall.plan.links),
        tuple(group for answer in done for group in answer.groups),
        tuple(wall for answer in done for wall in answer.partitions),
    )
    terms = tuple(
        TermValue(hall.space.id, part.item, part.term, part.value, part.weight, part.cost)
        for hall, answer in zip(halls, found, strict=True)
        for part in (answer.parts if answer else ())
    )
    return Solution(
        brief=brief,
        pieces=tuple(pieces),
        patches=(),
        terms=terms,
        left_out=tuple(out for answer in done for out in answer.left_out),
        energies={
            hall.space.id: answer.energy
            for hall, answer in zip(halls, found, strict=True)
            if answer is not None
        },
        preset=preset,
        solver=solver,
        seed=seed,
        version=__version__,
        brief_hash=hashlib.sha256(brief.model_dump_json().encode()).hexdigest(),
        seconds=seconds,
        evaluations=sum(answer.evaluations for answer in done),
        graph=graph,
        tours=tuple(answer.tour for answer in done if answer.tour is not None),
    )
