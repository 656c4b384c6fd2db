"""A washing machine for a home that owes one: where there is water, under a worktop, in a closet.

It stands in a wet room beside all else; else in the place of a cabinet or dishwasher under the
worktop of a kitchen, which costs no floor; else beside the kitchen or in a room behind a door.
"""

from __future__ import annotations

from collections.abc import Iterator

from scenewright.catalog.classes import PLAIN_CABINETS
from scenewright.core.catalog import Group, Member
from scenewright.domains.home.attempts.attempt import FurnishedGroup, Missing, RoomAnswer
from scenewright.domains.home.composing.filling.beside_others import list_others
from scenewright.domains.home.composing.homewide.settling import HomeState
from scenewright.domains.home.composing.places.moving import dress_group
from scenewright.domains.home.groups.bath import fitted_machines
from scenewright.domains.home.groups.classes import RUNS
from scenewright.domains.home.needs.searching import (
    STAGES,
    Tiers,
    list_need_rooms,
    may_settle,
    settle_need,
)
from scenewright.domains.home.needs.table import WASH_FROM

MACHINE, WASHER = "washing_machine", "washer"
WATER: Tiers = ((frozenset(("bathroom", "washroom")), 0.0), (frozenset(("toilet",)), 1.4))
BEHIND_DOOR: Tiers = ((frozenset(("kitchen",)), 6.0), (frozenset(("storage", "hall")), 0.0))
"""Rooms for it, and their least area in m², the more fitting first."""
SLOT = (0.6, 0.7)
"""Metres of width of a cabinet in whose place a machine stands under the worktop."""
GIVES_WAY = ("dishwasher", *sorted(PLAIN_CABINETS))
"""What it takes the place of there, in this order."""


def add_washing_machine(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    """The answers with a washing machine in a home that owes one and has none."""
    pieces = [p for a in answers for group in a.placed for p in group.pieces]
    pieces += [p for task in home.tasks for p in task.fixed]
    floor = sum(task.ground.area for task in home.tasks)
    there = any(piece.category == MACHINE for piece in pieces)
    if there or home.household is None or floor < WASH_FROM or not may_settle(home):
        return answers
    if any(MACHINE in task.forbidden for task in home.tasks):
        return answers
    found = _set_in(home, answers, WATER)
    found = _put_under_worktop(home, answers) if found is answers else found
    found = _set_in(home, answers, BEHIND_DOOR) if found is answers else found
    return answers if found is answers else [_without_reason(a) for a in found]


def _set_in(home: HomeState, answers: list[RoomAnswer], tiers: Tiers) -> list[RoomAnswer]:
    rooms = list_need_rooms(home, answers, tiers, WASHER, frozenset())
    return settle_need(home, answers, rooms, STAGES[:2], lambda *_: fitted_machines(), None)


def _put_under_worktop(home: HomeState, answers: list[RoomAnswer]) -> list[RoomAnswer]:
    for room, (task, answer) in enumerate(zip(home.tasks, answers, strict=True)):
        for at, run in enumerate(answer.placed):
            given = run.wish.group in task.library.own or run.wish.required or task.accessible
            if run.wish.group not in RUNS or given or run.dressed.lost:
                continue
            for case in _list_with_machine(run):
                standing = list_others(task, answer.placed, run)
                dressed = dress_group(task, run, case, run.dressed.box, standing)
                if dressed is not None and len(dressed.pieces) == len(run.pieces):
                    placed = (*answer.placed[:at], dressed, *answer.placed[at + 1 :])
                    whole = answer._replace(placed=placed)
                    return [whole if k == room else a for k, a in enumerate(answers)]
    return answers


def _list_with_machine(run: FurnishedGroup) -> Iterator[Group]:
    """A kitchen with a machine in the place of one of its units."""
    case = run.dressed.case
    for kind in GIVES_WAY:
        for unit in case.members:
            if unit.category == kind and SLOT[0] <= unit.size.width + 1e-9 <= SLOT[1]:
                machine = unit._replace(category=MACHINE)
                yield case._replace(members=tuple(_swap(m, unit, machine) for m in case.members))


def _swap(member: Member, unit: Member, machine: Member) -> Member:
    return machine if member is unit else member


def _without_reason(answer: RoomAnswer) -> RoomAnswer:
    """The answer without a machine told as missing, as one stands elsewhere."""
    kept: tuple[Missing, ...] = tuple(m for m in answer.missing if m.wish.group != WASHER)
    return answer if len(kept) == len(answer.missing) else answer._replace(missing=kept)
