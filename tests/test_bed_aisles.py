"""Beds as families have them: got into from both sides, heads at walls, wide, with a nightstand."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief, Room
from scenewright.domains import check
from scenewright.domains.home.attempts.attempt import FurnishedGroup, RoomAnswer, find_blocked
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.bed_places import cost_of_bed_places
from scenewright.domains.home.composing.bed_ways import cost_of_bed_ways, list_closing
from scenewright.domains.home.composing.case_faults import count_seats, find_case_faults
from scenewright.domains.home.composing.filling.additions import is_wanted, list_additions
from scenewright.domains.home.composing.filling.bare_walls import BARE_WALLS
from scenewright.domains.home.composing.homewide.bedsides import add_nightstands
from scenewright.domains.home.composing.judging import sum_faults
from scenewright.domains.home.composing.mend_rooms import mend_rooms
from scenewright.domains.home.composing.placed_faults import cost_of_group
from scenewright.domains.home.composing.places.forms import cost_of_case, list_further
from scenewright.domains.home.furnishing.furnish import FurnishedPatch, pieces_of
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.solving import prepare_rooms, solve
from scenewright.domains.home.walking.barred import find_barred
from scenewright.domains.home.walking.home_floor import join_floors

RULE = PRESETS["default"].settings.composing
BAY = {"id": "bay", "function": "double_bedroom"}
NARROW = next(
    c for c in list_further("sleeping") if round(c.width, 2) == 2.08 and round(c.depth, 2) == 2.08
)
AGAINST_EAST = [2.96, 1.095, np.pi]


def _brief(wide: float = 4.0, deep: float = 2.19, **more) -> Brief:
    outline = [[0, 0], [wide, 0], [wide, deep], [0, deep]]
    doors = [{"at": [0.6, deep], "width": 0.8, "swing": "out"}]
    return Brief(rooms=[Room.model_validate(BAY | {"outline": outline, "doors": doors} | more)])


def _task(wide: float = 4.0, deep: float = 2.19, **more):
    brief, preset = _brief(wide, deep, **more), PRESETS["default"]
    return prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)[0][0]


def _place(task, name: str, case, at) -> FurnishedGroup:
    box = np.array([*at, case.width, case.depth])
    stands = FurnishedPatch(case, box, (True,) * len(case.members), 0)
    space = task.space.id
    pieces = pieces_of(stands, space, f"{space}/{name}", case.function, task.catalog)
    return FurnishedGroup(Wish(case.function, 0), name, stands, pieces)


def _in_bay(at=AGAINST_EAST):
    """A bed with two narrow nightstands in a bay of 2.19 m."""
    task = _task()
    return task, _place(task, "sleeping", NARROW, at)


def _chest(task, at) -> FurnishedGroup:
    return _place(task, "chest", cases("chest").groups[0], at)


BESIDE, AT_FOOT, AWAY = [3.0, 0.23, np.pi / 2], [1.75, 0.23, np.pi / 2], [0.23, 0.7, 0.0]
"""Places of a chest in the lower aisle, at its end, and at the wall across."""


@pytest.mark.parametrize(("at", "closed"), [(AWAY, False), (BESIDE, True), (AT_FOOT, True)])
def test_bed_between_two_narrow_aisles_is_reached_from_its_foot(at, closed):
    task, bed = _in_bay()
    assert find_blocked(task, (bed,)) == ()
    assert ("sleeping" in find_blocked(task, (bed, _chest(task, at)))) == closed


def test_bed_with_one_narrow_aisle_is_not_reached():
    task, bed = _in_bay([2.96, 1.15, np.pi])
    assert find_blocked(task, (bed,)) == ()
    far = _place(task, "sleeping", NARROW, [2.96, 1.35, np.pi])
    assert "sleeping" in find_blocked(task, (far,))


@pytest.mark.parametrize(("at", "closed"), [(AWAY, False), (BESIDE, True)])
def test_walk_through_the_home_and_referee_enter_as_the_grid_does(at, closed):
    task, bed = _in_bay()
    pieces = (*bed.pieces, *_chest(task, at).pieces)
    brief = _brief(function="other")
    rooms = spaces(brief)
    barred = find_barred(pieces, rooms, join_floors(rooms, 0.6), catalog_of(()))
    found = check(replace(solve(brief, seed=0, steps=1), pieces=pieces)).findings
    missed = {f.piece for f in found if f.kind == "unreachable_piece"}
    name = next(p.id for p in bed.pieces if p.category == "double_bed")
    assert (name in {b.piece for b in barred}) == closed
    assert (name in missed) == closed


def test_narrow_bay_has_a_bed_with_two_nightstands_and_no_fault_of_the_referee():
    home = solve(_brief(4.2), seed=0, threads=1)
    kinds = [p.category for p in home.pieces]
    assert kinds.count("double_bed") == 1
    assert kinds.count("nightstand") == 2
    assert not check(home).findings


def test_shelf_at_the_foot_closes_the_way_to_its_side():
    task = _task(4.0, 4.0)
    case = next(c for c in cases("sleeping").groups if c.width == 2.3)
    bed = _place(task, "sleeping", case, [2.96, 2.0, np.pi])
    shelf = cases("shelf").groups[1]
    closing = _place(task, "shelf", shelf, [1.7, 1.0, 0.0])
    away = _place(task, "shelf", shelf, [0.17, 1.0, 0.0])
    assert cost_of_bed_ways((bed, away), task.ground, 14.0) == 0.0
    assert cost_of_bed_ways((bed, closing), task.ground, 14.0) > 7.0
    assert list_closing((bed, closing, away), task.ground) == {"sleeping", "shelf"}
    rooms = ((bed, closing), (bed, away))
    assert sum_faults(task, rooms[0]) > sum_faults(task, rooms[1]) + RULE.costs.bed_way / 2


def test_shelf_beside_the_pillow_leaves_no_place_for_a_nightstand():
    task = _task(3.0, 3.0, function="single_bedroom")
    alone = next(c for c in cases("single").groups if len(c.members) == 1 and c.width == 0.9)
    bed = _place(task, "single", alone, [0.45, 1.04, np.pi / 2])
    near = _place(task, "shelf", cases("shelf").groups[0], [1.3, 0.17, np.pi / 2])
    assert cost_of_bed_ways((bed,), task.ground, 14.0) == 0.0
    assert cost_of_bed_ways((bed, near), task.ground, 14.0) > 3.0


def test_head_off_the_wall_is_a_fault():
    task = _task(2.6, 3.0, function="single_bedroom")
    along = [c for c in list_further("single") if c.width < 2.6 and c.depth == 0.91]
    plain = next(c for c in along if len(c.members) == 1 and c.members[0].heading > 0.0)
    costs = []
    for y in (1.03, 1.43):
        bed = _place(task, "single", plain, [0.46, y, 0.0])
        boxes = bed.dressed.box[None]
        found = float(cost_of_bed_places(plain, boxes, task.ground, RULE)[0])
        assert cost_of_group(bed, task.ground, RULE) == pytest.approx(found)
        costs.append(found)
    assert costs[0] == 0.0
    assert costs[1] > RULE.costs.head_off / 2


def test_beds_for_one_are_of_full_width_from_eight_square_metres_on():
    narrow, full = (next(c for c in cases("single").groups if c.width == w) for w in (0.8, 0.9))
    assert find_case_faults(full) == ()
    assert cost_of_case(narrow, 7.5, RULE) == 0.0
    assert cost_of_case(narrow, 8.5, RULE) > RULE.costs.narrow_bed / 2


def test_narrow_living_room_has_a_sofa_for_three():
    task = _task(5.9, 2.27, function="living")
    two = next(c for c in cases("seating").groups if c.name == "1.2 m sofa, side table")
    placed = (_place(task, "seating", two, [3.0, 0.42, np.pi / 2]),)
    answer = RoomAnswer(0.0, placed, (), (), None, 0.0, 0)
    (best,) = mend_rooms([task], [answer], list)
    assert count_seats(best.placed[0].dressed.case) == 3
    small = _task(4.0, 2.27, function="living")
    (kept,) = mend_rooms([small], [answer], list)
    assert count_seats(kept.placed[0].dressed.case) == 2


def test_bedroom_takes_in_storage_at_its_bare_walls(monkeypatch):
    brief = _brief(2.9, 3.8, function="bedroom", windows=[{"at": [1.45, 0.0], "width": 1.2}])
    added = {"chest_of_drawers", "armchair", "bookcase"}
    home = solve(brief, seed=0, threads=1)
    assert added & {p.category for p in home.pieces}
    assert not check(home).findings
    monkeypatch.delitem(BARE_WALLS, "bedroom")
    assert not added & {p.category for p in solve(brief, seed=0, threads=1).pieces}


def test_bunk_has_a_nightstand_and_two_desks():
    task = _task(3.4, 4.0, function="child_bedroom")
    bunk = _place(task, "bunk", cases("bunk").groups[0], [0.5, 1.04, np.pi / 2])
    (answer,) = add_nightstands([task], [RoomAnswer(0.0, (bunk,), (), (), None, 0, 0)], list)
    assert "nightstand" in [p.category for p in answer.placed[0].pieces]
    desk = _place(task, "kids_desk", cases("kids_desk").groups[0], [2.0, 0.55, np.pi / 2])
    (wish,) = (w for w, _ in list_additions(task, (bunk, desk), ()) if w.group == "kids_desk")
    assert is_wanted(task, (bunk, desk), wish, ())
    assert not is_wanted(task, (bunk, desk, desk), wish, ())
    assert "kids_desk" not in [w.group for w, _ in list_additions(task, (desk,), ())]
