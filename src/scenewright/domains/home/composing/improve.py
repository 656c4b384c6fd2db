"""Groups of a furnished room in better sizes and places, one after the other.

The search lays out all groups at once and furnishes its best layouts; where a room is tight it
ends with the smallest forms wherever they fit. Here each group with a fault of composition is taken
out and tried anew along all walls in its better forms, beside all others as they stand. A change
stays if it costs less, counting energy and faults (:mod:`.placed_faults`), and bars no way.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.composing.bed_ways import list_closing
from scenewright.domains.home.composing.judging import (
    JudgedRoom,
    Placed,
    RoomJudge,
    count_unmet,
    judge_of,
)
from scenewright.domains.home.composing.placed_faults import (
    cost_of_group,
    cost_of_hearth,
    cost_of_screen,
    cost_of_shelves,
)
from scenewright.domains.home.composing.places.forms import list_forms
from scenewright.domains.home.composing.places.trials import take_first, try_forms
from scenewright.domains.home.composing.views import cost_of_view, list_between
from scenewright.domains.home.rules.weigh_home import compile_table, list_faults, list_together

IN_SIGHT = 100.0  # added to the cost of pieces between seats and screen: they are tried first


def improve_groups(task: RoomTask, best: JudgedRoom, barred: frozenset[str]) -> JudgedRoom:
    """The groups with each faulty one in a better form or place, the worst first."""
    judge, rule = judge_of(task, best.placed), task.preset.settings.composing
    for _ in range(rule.rounds):
        before = best.cost
        for name in list_worst_first(task, best.placed):
            if not task.cancelled():
                best = _improve(judge, best, name, barred)
        if best.cost > before - rule.least:
            break
    return best


def list_worst_first(task: RoomTask, placed: Placed) -> list[str]:
    """The names of groups with a fault, the costliest first, pieces between seats and screen
    before these; all groups where a wish is not met."""
    rule = task.preset.settings.composing
    view = 0.0 if len(task.ground.hearths) else cost_of_view(placed, rule.costs, task.ground.edges)
    whole = {
        "storage": cost_of_shelves(placed, task.ground, rule.costs.shelves),
        "media": cost_of_screen(placed, task.ground, rule.costs.screen) + view,
        "seating": cost_of_hearth(placed, task.ground, rule.costs.screen) + view,
    }
    table = compile_table(list_together(task.space.functions), rule.costs)
    together = defaultdict[str, float](float)
    for fault in list_faults(table, placed, (), task.ground):
        together[fault.group] += fault.cost * fault.row.moves
    unmet = float(count_unmet(task, placed) > 0)
    between = list_between(placed) if view > 0.0 else frozenset()
    closing = list_closing(placed, task.ground)
    costs = {
        p.name: cost_of_group(p, task.ground, rule)
        + whole.get(p.wish.group, 0.0)
        + together[p.name]
        + unmet
        + IN_SIGHT * (p.name in between)
        + rule.costs.bed_way * (p.name in closing)
        for p in placed
        if p.wish.group not in task.library.own
    }
    return sorted((name for name, cost in costs.items() if cost > 0.0), key=lambda n: -costs[n])


def _improve(judge: RoomJudge, best: JudgedRoom, name: str, barred: frozenset[str]) -> JudgedRoom:
    """The groups with one of them in a better form or place, or as they were."""
    rule = judge.task.preset.settings.composing
    most = best.cost - rule.least
    found = _elsewhere(judge, best.placed, _number_of(best.placed, name), rule.forms, most)
    return take_first(judge.task, best, found, barred)


def _number_of(placed: Placed, name: str) -> int:
    return next(i for i, p in enumerate(placed) if p.name == name)


def _elsewhere(
    judge: RoomJudge, placed: Placed, at: int, forms: int, most: float
) -> Iterator[JudgedRoom]:
    """The groups with one of them in its better forms wherever along the walls it stands free, the
    cheapest first; of those that cost over ``most`` not all."""
    return try_forms(judge, placed, at, list_forms(judge.task, placed[at]), forms, most)
