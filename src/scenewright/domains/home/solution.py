"""From patches placed by hand or by another program to the solution of a home."""

from __future__ import annotations

import time
from collections.abc import Sequence

import numpy as np

from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.layout import Layouts, NamedBox, check_layouts
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.home.attempts.attempt import (
    Missing,
    RoomAnswer,
    RoomTask,
    build_task_problem,
    furnish_layout,
)
from scenewright.domains.home.composing.kitchens.relaid import refit_kitchen
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import assemble_solution, prepare_rooms
from scenewright.domains.home.walking.home_floor import join_floors
from scenewright.domains.home.wished.requests import check_asks
from scenewright.domains.home.wished.wishes import check_wishes
from scenewright.engine.rows import preset_named


def solution_of(
    brief: Brief, layouts: Layouts, *, plan: Plan | None = None, seed: int = 0
) -> Solution:
    """The solution whose furniture groups stand in the patches given, by the name of the group.

    Groups are furnished as those of a solver: drawn in to the case that fits, pushed to their
    walls where that loses nothing. What has no patch, or cannot be furnished in it, is left out.
    """
    started = time.perf_counter()
    made = plan or plan_rooms(brief)
    check_layouts(layouts, [space.id for space in made.spaces])
    check_asks(brief)
    catalog, preset = catalog_of(brief.catalogs), preset_named(PRESETS, "default")
    check_wishes(brief, catalog)
    tasks, wishes = prepare_rooms(brief, made.spaces, catalog, preset, preset.solver, seed)
    answers = [
        _furnish(task, asked, layouts.get(task.space.id, ()))
        for task, asked in zip(tasks, wishes, strict=True)
    ]
    floors = join_floors(made.spaces, brief.route_width)
    spent = time.perf_counter() - started
    return assemble_solution(brief, tasks, answers, floors, "default", seed, spent)


def _furnish(task: RoomTask, asked: tuple[Wish, ...], rows: Sequence[NamedBox]) -> RoomAnswer:
    """One room with the groups of its patches."""
    chosen, rest = _match_boxes(task, asked, rows)
    missing = tuple(Missing(wish, "the layout has no place for it") for wish in rest)
    if not chosen:
        return RoomAnswer(0.0, (), missing, (), None, 0.0, 0)
    problem = build_task_problem(task, chosen, task.ground)
    boxes = np.array([row.box for row in rows], np.float64)
    energy = float(evaluate(problem, boxes[None])[0])
    answer = refit_kitchen(task, furnish_layout(task, chosen, problem, boxes, energy), rows)
    return answer._replace(missing=(*answer.missing, *missing))


def _match_boxes(
    task: RoomTask, asked: tuple[Wish, ...], rows: Sequence[NamedBox]
) -> tuple[tuple[Wish, ...], list[Wish]]:
    """The wish each row answers (a welcome one where it was not asked for), and those that none
    does."""
    left, found = list(asked), []
    for number, row in enumerate(rows):
        wish = next((wish for wish in left if wish.group == row.name), None)
        if wish is None and row.name not in GROUPS:
            raise InputError(
                "is not a furniture group",
                f"use one of: {', '.join(GROUPS)}",
                place=f"{task.space.id}[{number}] '{row.name}'",
            )
        if wish is None:
            found.append(Wish(row.name, 2))
            continue
        left.remove(wish)
        found.append(wish)
    return tuple(found), left
