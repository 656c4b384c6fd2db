"""One hall laid out: its demands split into groups, searched, furnished, and again where it
falls short."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import NamedTuple

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.layout import Watch
from scenewright.core.passes import ALL_PASSES, PassOptions
from scenewright.domains.hall.accessories import count_groups
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.compose import compose
from scenewright.domains.hall.demands.holdings import collect_demands, restrict_patterns
from scenewright.domains.hall.demands.open_numbers import with_theme
from scenewright.domains.hall.demands.split import find_locked, split_demands
from scenewright.domains.hall.desks.staff_room import fit_with_staff
from scenewright.domains.hall.desks.unserved import count_unserved
from scenewright.domains.hall.furnishing.assemble import Laid
from scenewright.domains.hall.furnishing.layout import furnish_guided
from scenewright.domains.hall.furnishing.on_stage import put_on_stage
from scenewright.domains.hall.furnishing.standing import keep_standing
from scenewright.domains.hall.gates.boarding import set_at_doors
from scenewright.domains.hall.gates.leaves import with_leaves
from scenewright.domains.hall.presets import HallPreset, count_steps
from scenewright.domains.hall.search import HallSearch, may_retry, name_objects, search_layout
from scenewright.domains.hall.shortfall.measures import (
    falls_short,
    leaves_open,
    measure_shortfall,
    measure_shortfall_and_staff,
)
from scenewright.domains.hall.shortfall.unplaceable import left_out
from scenewright.domains.hall.shortfall.unreached import drop_unreached
from scenewright.domains.hall.zoning.move_borders import (
    move_borders,
    read_slack,
    search_with_borders,
)
from scenewright.engine.solve import Budget
from scenewright.engine.trace import hear_in

AFRESH, AGAIN = 3, 104_729
"""How often a hall is laid out again where nobody can serve at some of its desks, once where
something was given up for want of a way to it, and the distance of the seeds."""
Progress = Callable[[float, str], None]
Cancel = Callable[[], bool]


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


def may_lay_again(task: HallTask) -> bool:
    """Whether a hall may be laid out once more: not as printed, nor where time is measured."""
    return not task.preset.settings.whole and task.budget.seconds is None


def lay_best(
    brief: Brief, task: HallTask, lay: Callable[[HallTask], Laid], cancelled: Cancel
) -> Laid:
    """A hall laid out, again where nobody can serve at some of its desks or something was given
    up, until it is ``cancelled``."""
    laid = _lay_free(brief, task, lay, cancelled)
    for number in range(1, AFRESH + 1):
        unserved = count_unserved(task.hall.space, laid.pieces) > 0
        wanted = unserved or (number == 1 and laid.given_up)
        may = may_lay_again(task) and task.solver == task.preset.solver
        if not wanted or not may or cancelled():
            break
        other = _lay_free(brief, task._replace(seed=task.seed + AGAIN * number), lay, cancelled)
        laid = min((laid, other), key=partial(measure_shortfall_and_staff, task.hall.space))
    return laid


def _lay_free(
    brief: Brief, task: HallTask, lay: Callable[[HallTask], Laid], cancelled: Cancel
) -> Laid:
    """A hall laid out, with its counters in other forms where it falls_short something."""
    laid = lay(task)
    open_ = leaves_open(brief.rooms[task.number].demands)
    if cancelled() or not (open_ and falls_short(laid) and may_lay_again(task)):
        return laid
    free = task.preset._replace(settings=task.preset.settings._replace(lined=False))
    return min((laid, lay(task._replace(preset=free))), key=measure_shortfall)


def lay_once(
    brief: Brief,
    task: HallTask,
    catalog: Catalog,
    progress: Progress | None,
    cancel: Cancel | None,
    watch: Watch | None,
) -> Laid:
    """A hall laid out once, by a seed and settings."""
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
