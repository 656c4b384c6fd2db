"""The one verdict on a furnished room: what is missing, what an eye finds, what it costs."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping

import numpy as np

from scenewright.arranging.verdict import LEAST, Verdict
from scenewright.catalog.assets.furniture.cooking import has_worktop
from scenewright.catalog.classes import BEDS, TABLE_SEATS
from scenewright.core.same import once
from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, RoomTask, penalty
from scenewright.domains.home.composing.bed_sides import count_closed_beds
from scenewright.domains.home.composing.case_faults import count_seats, find_case_faults
from scenewright.domains.home.composing.judging import Placed, cost_by_row, count_unmet, judge_of
from scenewright.domains.home.composing.kitchens.far_fridges import has_far_fridge
from scenewright.domains.home.composing.kitchens.loose_cabinets import list_loose
from scenewright.domains.home.composing.placed_faults import (
    DARK,
    cost_of_screen,
    list_adrift,
    list_standing,
    measure_before_doors,
    measure_before_windows,
)
from scenewright.domains.home.composing.seats.unseen import hangs_in_doorway, is_screen_unseen
from scenewright.domains.home.composing.spacing.rules import list_close
from scenewright.domains.home.composing.views import is_off_axis
from scenewright.domains.home.least_sizes import LEAST_SIZES
from scenewright.domains.home.measures import RAISED
from scenewright.domains.home.needs.household import STORING
from scenewright.domains.home.programme import WELCOME

STUCK = 2.5
"""What it costs from which on an eye finds two groups too near to one another."""
NEAR = 3.0
"""What a room may cost more by its energy for each unit that its groups stand less near."""
OF_CASES = (
    *("nightstand", "one_side", "wardrobe", "seats", "worktop", "hob_at_sink", "hob_at_end"),
    "split",
)
"""Faults of cases that nothing else is worth."""
LESS = {"worktop": 0.1, "storage": 0.1}
"""By how much less of each is not less, metres."""
HELD = ("worktop", "storage", "seats", "places", "bed")
"""What rooms are to hold no less of."""
FEWER = "a chair less stands at it: it could not be drawn back"


def judge_room(task: RoomTask, answer: RoomAnswer, before: Placed = ()) -> Verdict:
    """The verdict on a room as it is furnished; of what the groups ``before`` held and that are
    still there nothing is to be lost."""
    placed, costs, energy = answer.placed, task.costs, 0.0
    if placed:
        layout = np.array([[p.dressed.box for p in placed]])
        energy = float(judge_of(task, placed).energies_of(layout)[0])
    near = sum(close.cost for close in list_close(placed, task.fixed, task.ground))
    return Verdict(
        lost=sum(penalty(m.wish, costs) for m in answer.missing if m.wish.rank < WELCOME)
        + costs.piece * (len(answer.gone) + sum(p.dressed.lost for p in placed)),
        findings=dict(_list_findings(task, answer, before)),
        cost={
            **cost_by_row(task, placed),
            "energy": costs.energy * energy,
            "nearness": NEAR * near,
        },
    )


def finds_more(
    task: RoomTask, answer: RoomAnswer, before: Placed, findings: Mapping[str, float]
) -> bool:
    """Whether there is more of something in a room than there is in ``findings``: what a room is
    refused for, whatever it costs."""
    return any(
        found > findings.get(row, 0.0) + LEAST
        for row, found in _list_findings(task, answer, before)
    )


def _list_findings(
    task: RoomTask, answer: RoomAnswer, before: Placed
) -> Iterator[tuple[str, float]]:
    """What an eye finds in a room, and what its groups hold less than before, by row."""
    yield from _find_less(answer, before).items()
    yield from _list_rows(task, answer.placed)


def find_rows(task: RoomTask, placed: Placed) -> dict[str, float]:
    """What an eye finds in a room, by row."""
    return dict(_list_rows(task, placed))


def _list_rows(task: RoomTask, placed: Placed) -> Iterator[tuple[str, float]]:
    """The same, what is told at once first."""
    cases = Counter(name for p in placed for name, _ in find_case_faults(list_standing(p)))
    yield from ((name, float(cases[name])) for name in OF_CASES)
    yield from ((name, count(task, placed)) for name, count in FINDINGS.items())


def _count_near(task: RoomTask, placed: Placed) -> float:
    close = list_close(placed, task.fixed, task.ground)
    return float(sum(each.cost >= STUCK for each in close))


def _count_windows(task: RoomTask, placed: Placed) -> float:
    dark = [measure_before_windows(p, task.ground) > DARK for p in placed]
    return float(sum(any(window) for window in zip(*dark, strict=True)))


FINDINGS: Mapping[str, Callable[[RoomTask, Placed], float]] = {
    "window": _count_windows,
    "adrift": lambda task, placed: float(len(list_adrift(placed, task.ground))),
    "door": lambda task, placed: sum(measure_before_doors(p, task.ground) for p in placed),
    "doorway": lambda task, placed: float(sum(hangs_in_doorway(task, p) for p in placed)),
    "closed bed": lambda task, placed: float(count_closed_beds(placed, task.ground)),
    "unseen": lambda task, placed: float(is_screen_unseen(task, placed)),
    "off axis": lambda _, placed: float(is_off_axis(placed)),
    "small screen": lambda task, placed: cost_of_screen(placed, task.ground, 1.0),
    "far fridge": lambda _, placed: float(has_far_fridge(placed)),
    "loose cabinet": lambda _, placed: float(len(list_loose(placed))),
    "wish": lambda task, placed: float(count_unmet(task, placed)),
    "near": _count_near,
}
"""What an eye finds in a room whatever it costs: how many there are, of doors metres."""


def _find_less(answer: RoomAnswer, before: Placed) -> dict[str, float]:
    """How much less the groups hold than those of the same names held before, chairs apart that are
    told as missing."""
    there = {p.name for p in answer.placed}
    old = measure_held(tuple(p for p in before if p.name in there))
    new = measure_held(answer.placed)
    told = {"places": float(sum(m.reason == FEWER for m in answer.missing))}
    return {f"less {k}": max(old[k] - new[k] - (LESS | told).get(k, 0.0), 0.0) for k in old}


def measure_held(placed: Placed) -> dict[str, float]:
    """Metres of worktop and of storage, places on sofas and armchairs and at tables, pieces, and
    metres of beds as far as these are wanted.

    >>> measure_held(())["seats"]
    0
    """
    held = [_measure_held(group) for group in placed]
    return {name: sum(each[k] for each in held) for k, name in enumerate(HELD)}


@once(1024)
def _measure_held(group: FurnishedGroup) -> tuple[float, ...]:
    """What one group holds, in the order of :data:`HELD`."""
    return (
        sum(p.size.width for p in group.pieces if _is_top(p)),
        sum(p.size.width for p in group.pieces if p.category in STORING),
        count_seats(list_standing(group)),
        sum(p.category in TABLE_SEATS for p in group.pieces),
        sum(map(_measure_bed, group.pieces)),
    )


def _measure_bed(piece: Piece) -> float:
    """By how much a bed is as wide and long as one is enough, metres."""
    wide, long, _ = LEAST_SIZES[piece.category] if piece.category in BEDS else (0.0, 0.0, "")
    return min(piece.size.width, wide) + min(piece.size.depth, long)


def _is_top(piece: Piece) -> bool:
    """Whether a piece has worktop on it."""
    return has_worktop(piece.category, piece.size.height) and piece.pose.z < RAISED
