"""Whether a kitchen is good enough not to be put together otherwise."""

from __future__ import annotations

from scenewright.domains.home.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.placed_faults import cost_of_group

SHORT = 0.2
"""The share by which a sound kitchen may be shorter than its room asks."""


def is_sound(task: RoomTask, run: FurnishedGroup) -> bool:
    """Whether nothing is wrong with a kitchen but that sink, hob and fridge are off a work
    triangle: then another make-up would rather take them apart."""
    rule = task.preset.settings.composing
    whole = rule._replace(costs=rule.costs._replace(triangle=0.0))
    return cost_of_group(run, task.ground, whole) <= SHORT * rule.costs.short_run
