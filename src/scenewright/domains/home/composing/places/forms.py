"""The forms a group is tried in while a room is composed, the better first."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cache, lru_cache
from itertools import zip_longest
from math import sqrt

from scenewright.core.catalog import Group
from scenewright.core.same import Same
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomTask
from scenewright.domains.home.build_problem import select_allowed
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.modest import find_few_places, find_shortage
from scenewright.domains.home.groups.classes import RUNS, TABLES
from scenewright.domains.home.groups.dining import further_tables, kitchen_tables
from scenewright.domains.home.groups.entry import fitted_storage
from scenewright.domains.home.groups.kitchen import long_kitchenettes
from scenewright.domains.home.groups.living import further_seats, hung_screens
from scenewright.domains.home.groups.outdoor import folding_chair
from scenewright.domains.home.groups.sleeping import along_wall, fitted_wardrobes, narrow_sides
from scenewright.domains.home.rules.kitchen import IN_SMALL, WHOLE_FROM
from scenewright.domains.home.settings import MERE_KITCHEN, ComposingSettings

FURTHER: dict[str, Callable[[], Iterator[Group]]] = {
    "dining_wall": further_tables,
    "kitchenette": long_kitchenettes,
    "lounger": folding_chair,
    "media": hung_screens,
    "seating": further_seats,
    "single": along_wall,
    "sleeping": narrow_sides,
    "storage": fitted_storage,
    "wardrobe": fitted_wardrobes,
}
"""Forms beside the cases of a group, for a place that is found for them."""
IN_KITCHEN: dict[str, Callable[[], Iterator[Group]]] = {"dining_wall": kitchen_tables}
"""Forms beside those in a room that is a kitchen and nothing else."""
WIDEST = frozenset(("storage",))
"""Groups that take all of their wall."""
IN_TURN = frozenset(("media", "single"))
"""Groups whose usual and further forms are tried in turn."""
SCREEN = 0.38
"""Width of a screen watched from wall to wall of a square room, as a share of its side."""
SEATS_FROM = 14.0
"""Area in m² from which a living room has seats for more than two."""


RINGS_FROM = 8.0
"""Area in m² from which a kitchen has a hob of four rings."""
TALL_FROM = 8.0
"""Area in m² from which a kitchen has a tall fridge."""
BED_FROM = 8.0
"""Area in m² from which a bed for one is of full width."""
FROM = {
    "seats": SEATS_FROM,
    "narrow_bed": BED_FROM,
    "few_rings": RINGS_FROM,
    "triangle": WHOLE_FROM,
    "small_sink": WHOLE_FROM,
    "sink_alone": WHOLE_FROM,
    "fridge_at_sink": TALL_FROM,
    "fridge_alone": WHOLE_FROM,
    "low_fridge": TALL_FROM,
    "across": WHOLE_FROM,
    "split": WHOLE_FROM,
}
"""Area in m² of a room from which these faults count."""
TIGHT = {
    "fridge_at_sink": 0.25,
    "fridge_alone": IN_SMALL,
    "low_fridge": 0.25,
    "across": 0.4,
    "split": 0.6,
}
"""By how much less faults of them count in smaller rooms, instead of not at all."""
GRADED = frozenset(("triangle",))
"""Faults that a little of hardly costs anything."""


def is_mere_kitchen(task: RoomTask) -> bool:
    """Whether a room is a kitchen and nothing else."""
    return task.space.functions == MERE_KITCHEN


def share_in(area: float, fault: str) -> float:
    """How much of its usual cost a fault has in a room of ``area`` square metres."""
    return 1.0 if area >= FROM.get(fault, 0.0) else TIGHT.get(fault, 0.0)


@lru_cache(maxsize=16384)
def cost_of_case(case: Group, area: float, rule: ComposingSettings) -> float:
    """What is wrong with a case wherever it stands in a room of ``area`` square metres: each fault
    half for being there, half by its degree; what it falls short of its room's size, and what is
    :data:`GRADED`, by its degree."""
    faults = sum(
        share_in(area, name)
        * float(getattr(rule.costs, name))
        * (degree if name in GRADED else (1.0 + degree) / 2)
        for name, degree in find_case_faults(case)
    )
    return faults + _cost_of_size(case.function, rule) * find_shortage(case, area)


def _cost_of_size(function: str, rule: ComposingSettings) -> float:
    """What it costs that a group is small for its room."""
    if function in RUNS:
        return rule.costs.short_run
    return rule.costs.places if function in TABLES else rule.costs.modest


def list_forms(task: RoomTask, group: FurnishedGroup) -> Iterator[Group]:
    """The forms of a group that stands, those with less wrong first, then those most like it; of
    what fills its wall the widest first."""
    rule, case, area = task.preset.settings.composing, group.dressed.case, task.ground.area
    few = rule.costs.few_places if is_mere_kitchen(task) and case.function in TABLES else 0.0

    def worth(row: tuple[Group, tuple[float, float]]) -> tuple[float, float, float]:
        form, (wrong, off) = row
        wrong += few * find_few_places(form, area) if few else 0.0
        return wrong, off, abs(form.width - case.width) + abs(form.depth - case.depth)

    known, fits = cases(group.wish.group, task.library), select_allowed(group.wish, task.library)
    rated = zip(known.groups, _rate(Same(known.groups), area, rule), fits, strict=True)
    usual = [(form, rate) for form, rate, fit in rated if fit]
    given = group.wish.most is not None or group.wish.group in task.library.seated
    more = () if given else list_further(group.wish.group, is_mere_kitchen(task))
    further = list(zip(more, _rate(Same(more), area, rule), strict=True))
    if group.wish.group not in IN_TURN:
        yield from (form for form, _ in sorted([*usual, *further], key=worth))
        return
    for both in zip_longest(sorted(further, key=worth), sorted(usual, key=worth)):
        yield from (row[0] for row in both if row is not None)


@lru_cache(maxsize=256)
def _rate(
    same: Same[tuple[Group, ...]], area: float, rule: ComposingSettings
) -> tuple[tuple[float, float], ...]:
    """What is wrong with each of some forms, and how far it is off what the room asks for."""
    return tuple((cost_of_case(form, area, rule), _off_goal(form, area)) for form in same.value)


def _off_goal(form: Group, area: float) -> float:
    """The less the better a form suits a room of ``area`` square metres: what fills its wall by its
    width, a stand by how near its width is to that of the screen the room asks for."""
    if form.function == "media":
        return abs(form.width - SCREEN * sqrt(area))
    return -form.width if form.function in WIDEST else 0.0


@cache
def list_further(function: str, in_kitchen: bool = False) -> tuple[Group, ...]:
    """The forms of a group beside its cases, ``in_kitchen`` those of mere kitchens as well."""
    tables = (FURTHER, IN_KITCHEN) if in_kitchen else (FURTHER,)
    return tuple(form for table in tables if function in table for form in table[function]())
