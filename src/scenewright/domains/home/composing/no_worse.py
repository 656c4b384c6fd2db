"""Whether a finished room is no worse for a change that mends something else."""

from __future__ import annotations

from scenewright.domains.home.attempt import RoomTask
from scenewright.domains.home.composing.held import holds_less, measure_held
from scenewright.domains.home.composing.judging import Placed, judge_of
from scenewright.domains.home.composing.placed_faults import cost_of_screen
from scenewright.domains.home.composing.spacing.rules import measure_closeness
from scenewright.domains.home.composing.views import cost_of_view
from scenewright.domains.home.composing.windows import count_faults

NEARER, SIGHT_WORSE = 4.5, 1.0
"""By how much groups may stand nearer to one another for it, and screens be seen less well."""


def is_no_worse(task: RoomTask, before: Placed, after: Placed, worth: float) -> bool:
    """Whether nothing that is counted is worse (:func:`~.windows.count_faults`), the room holds no
    less (:func:`~.held.measure_held`) and costs hardly more: what the change is ``worth``."""
    faults = [count_faults(task, placed) for placed in (after, before)]
    if any(a > b for a, b in zip(*faults, strict=True)):
        return False
    if holds_less(measure_held(after), measure_held(before)):
        return False
    near = [measure_closeness(placed, task.fixed, task.ground) for placed in (after, before)]
    if near[0] > near[1] + NEARER:
        return False
    sight = [_cost_of_sight(task, placed) for placed in (after, before)]
    costs = [judge_of(task, placed).cost_of(placed).cost for placed in (after, before)]
    return sight[0] <= sight[1] + SIGHT_WORSE and costs[0] + near[0] <= costs[1] + near[1] + worth


def _cost_of_sight(task: RoomTask, placed: Placed) -> float:
    """What is wrong with the screen of a room and with how it is seen."""
    costs = task.preset.settings.composing.costs
    view = cost_of_view(placed, costs, task.ground.edges)
    return view + cost_of_screen(placed, task.ground, costs.screen)
