"""Whether a kitchen is good enough not to be put together otherwise."""

from __future__ import annotations

from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.composing.places.forms import is_mere_kitchen
from scenewright.domains.home.rules.weigh_home import sum_rows

SHORTER_BY = 0.2
"""The share by which a sound kitchen may be shorter than its room asks."""


def is_sound(task: RoomTask, run: FurnishedGroup, placed: tuple[FurnishedGroup, ...]) -> bool:
    """Whether nothing is wrong with a kitchen, nor with a fridge of its own among those ``placed``;
    where there is more in its room, sink, hob and fridge may be off a work triangle: another
    make-up would rather take them apart."""
    rule = task.preset.settings.composing
    if not is_mere_kitchen(task):
        rule = rule._replace(costs=rule.costs._replace(triangle=0.0))
    faults = cost_of_group(run, task.ground, rule)
    faults += sum_rows(("fridge_away",), placed, task.ground, (), rule.costs)
    return faults <= SHORTER_BY * rule.costs.short_run
