"""Kitchens that grow, machines under a worktop, screens on the axis of a seat; counters of uses."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from benchmarks.composition_faults import list_rooms
from benchmarks.unseen_uses import USES

from every import every
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.case_faults import find_case_faults
from scenewright.domains.home.composing.kitchens.growing import lengthen
from scenewright.domains.home.composing.kitchens.slits import Slit, is_unit
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.needs.laundry import _list_with_machine
from scenewright.domains.home.needs.outlook import _order_before
from scenewright.domains.home.programme import Wish

UP = np.pi / 2
OUTLINE = np.array([[0, 0], [7, 0], [7, 5], [0, 5]], np.float64)
ROOM = Space("room", "Room", ("living", "kitchen"), "0", OUTLINE)
RUN = next(g for g in cases("kitchen").groups if g.name.startswith("3.0 m"))


def piece(category: str, x: float, y: float, width: float, depth: float, turn: float = UP) -> Piece:
    size = Size(width, depth, 0.9)
    return Piece(f"{category}{x}", category, category, "room", Pose(x, y, 0.0, turn), size)


SOFA, TABLE = piece("sofa", 2.0, 1.0, 2.0, 0.9), piece("dining_table", 3.0, 2.5, 1.2, 0.8)
TV = piece("tv", 2.0, 4.0, 1.2, 0.1, -UP)
HOB = piece("hob_cabinet", 3.0, 0.3, 0.6, 0.6)
TOPS = tuple(piece("base_cabinet", x, 0.3, 0.6, 0.6) for x in (2.4, 3.6))
CHAIR = piece("dining_chair", 3.0, 3.0, 0.45, 0.5, -UP)
PLANTED = {
    "screen off the axis of its sofa": ((SOFA, replace(TV, pose=Pose(3.0, 4, 0, -UP))), (SOFA, TV)),
    "sofa that looks at nothing": ((SOFA,), (SOFA, TV)),
    "hob without 0.3 m on both sides": ((HOB, TOPS[0]), (HOB, *TOPS)),
    "no washing machine from 30 m2": ((SOFA,), (piece("washing_machine", 1, 1, 0.6, 0.6),)),
    "cupboard that cannot be opened": (
        (piece("wardrobe", 3, 2, 1.2, 0.6), piece("sofa", 3, 2.8, 2.0, 0.9)),
        (piece("wardrobe", 3, 2, 1.2, 0.6),),
    ),
    "table with a chair that is jammed": (
        (TABLE, CHAIR, piece("wardrobe", 3.0, 3.7, 1.2, 0.6)),
        (TABLE, CHAIR),
    ),
}


@every(sorted(PLANTED), str)
def test_a_counter_of_uses_finds_what_is_planted(name: str) -> None:
    (row,) = (row for row in USES if row.name == name)
    broken, held = (row.faults(list_rooms([ROOM], pieces), 0.0) for pieces in PLANTED[name])
    assert (broken.faulty, held.faulty) == (1, 0)


@pytest.mark.parametrize("side", [-1, 1])
def test_a_run_grows_at_either_end_and_its_fridge_stays_last(side: int) -> None:
    units = [m for m in RUN.members if is_unit(m)]
    last = max(units, key=lambda m: side * m.x)
    grown = lengthen(RUN, Slit(last, side, 0.9), 0.6)
    low = [m for m in grown.members if is_unit(m)]
    assert sum(m.size.width for m in low) == pytest.approx(sum(m.size.width for m in units) + 0.6)
    end = max(low, key=lambda m: side * m.x)
    assert (end.category == "fridge") == (last.category == "fridge")
    spans = sorted((m.x - m.size.width / 2, m.x + m.size.width / 2) for m in low)
    assert all(b == pytest.approx(c) for (_, b), (c, _) in pairwise(spans))


def test_a_machine_takes_the_place_of_a_unit_and_keeps_the_worktop() -> None:
    run = next(g for g in cases("kitchen").groups if "dishwasher" in str(g.members))
    patch = FurnishedPatch(run, np.zeros(5), (True,) * len(run.members), 0)
    whole = FurnishedGroup(Wish("kitchen", 0), "kitchen", patch, ())
    found = list(_list_with_machine(whole))
    assert found
    for case in found:
        kinds = [m.category for m in case.members]
        assert kinds.count("washing_machine") == 1
        assert find_case_faults(case) == find_case_faults(run)


def test_screens_are_set_on_the_axis_of_a_seat_within_the_distance_of_sight() -> None:
    boxes = np.array([[x, y, -UP, 0.9, 0.4] for x, y in ((2.2, 4), (2.0, 4), (3.0, 4), (2.0, 1.8))])
    assert _order_before(boxes, SOFA)[:, 0].tolist() == [2.0, 2.2]
