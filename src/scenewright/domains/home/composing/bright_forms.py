"""The forms in which a group is tried away from windows: none that holds less."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import zip_longest

from scenewright.core.catalog import Group
from scenewright.domains.home.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.composing.case_faults import FULL, count_seats
from scenewright.domains.home.composing.doorways import holds_as_much, list_lasting_forms
from scenewright.domains.home.composing.forms import cost_of_case, list_forms
from scenewright.domains.home.groups.classes import BED_GROUPS
from scenewright.domains.home.groups.sleeping import beside_walls
from scenewright.domains.home.measures import HAIR

HALF = 0.5
"""The share of its width that a wardrobe keeps, and the metre it has."""


def list_bright_forms(task: RoomTask, group: FurnishedGroup) -> Iterator[Group]:
    """The better forms of a group and the smaller ones by turns, each once, a bed's better ones
    first: beds no smaller than before wide doors, seats for as many, wardrobes of a metre or as
    wide as now."""
    better = list(_list_forms(task, group))
    smaller = sorted(better, key=lambda form: form.width * form.depth)
    turns = (better, smaller) if group.wish.group in BED_GROUPS else (smaller, better)
    yield from dict.fromkeys(form for both in zip_longest(*turns) for form in both if form)


def _list_forms(task: RoomTask, group: FurnishedGroup) -> Iterator[Group]:
    now = group.dressed.case
    if group.wish.group == "wardrobe":
        least = max(min(now.width, FULL), HALF * now.width) - HAIR
        return (form for form in list_forms(task, group) if form.width > least)
    lasting = list_lasting_forms(task, group)
    return (form for form in lasting if count_seats(form) >= count_seats(now))


def list_forms_of_bed(task: RoomTask, group: FurnishedGroup) -> list[Group]:
    """The forms of a bed for two that is as large as it is, or of 1.4 m, those with less wrong
    first; with one nightstand also narrow ones, unless its size is given."""
    given, now = group.wish.most is not None, group.dressed.case
    forms = [*list_forms(task, group), *(() if given else beside_walls())]
    rule, area = task.preset.settings.composing, task.ground.area
    kept = (form for form in dict.fromkeys(forms) if holds_as_much(form, now))
    return sorted(kept, key=lambda form: (cost_of_case(form, area, rule), form.width))
