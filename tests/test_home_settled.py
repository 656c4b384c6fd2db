"""Finished homes: a table for all who live there, a soft seat, no screen without a seat."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice
from math import pi

import numpy as np
import pytest

from scenewright.building.plan import spaces
from scenewright.catalog.classes import SOFT_SEATS
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.explanation import find_remedy
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains import check
from scenewright.domains.home.advice import REMEDIES
from scenewright.domains.home.attempts.attempt import (
    FurnishedGroup,
    RoomAnswer,
    RoomTask,
    find_blocked,
)
from scenewright.domains.home.cases.library import cases
from scenewright.domains.home.composing.homewide.settling import (
    HomeState,
    is_home,
    measure_case,
    wait,
)
from scenewright.domains.home.composing.homewide.used_floor import measure_taken
from scenewright.domains.home.composing.places.moving import dress_group, make_unplaced
from scenewright.domains.home.furnishing.obstacles import flat_kinds, standing_of
from scenewright.domains.home.needs.forms import list_seats, list_tables, measure_places
from scenewright.domains.home.needs.household import decide_household
from scenewright.domains.home.needs.jointly import list_jointly
from scenewright.domains.home.needs.proof import name_way, tell_proof
from scenewright.domains.home.needs.settle import add_kitchen_tables, add_soft_seat, set_table
from scenewright.domains.home.needs.solve_for import holds_no_less
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.programme import WELCOME, Wish
from scenewright.domains.home.solving import prepare_rooms, solve

NORTH = pi / 2


def _room(name: str, function: str, x: float, width: float, depth: float = 4.0, **more) -> dict:
    """A room from ``x`` on with a door to the outside in the north, in its right corner."""
    outline = [[x, 0], [x + width, 0], [x + width, depth], [x, depth]]
    doors = [{"at": [x + width - 0.6, depth], "width": 0.8, "swing": "out"}]
    return {"id": name, "function": function, "outline": outline, "doors": doors} | more


def _flat(*rooms: dict, **more) -> Brief:
    return Brief.model_validate({"rooms": list(rooms), **more})


def _tasks(brief: Brief) -> list[RoomTask]:
    preset = PRESETS["default"]
    return prepare_rooms(brief, spaces(brief), catalog_of(()), preset, preset.solver, 0)[0]


def _serve(brief: Brief, *placed: tuple[FurnishedGroup, ...], opened=list) -> list[RoomAnswer]:
    """The answers with the table of a home of whose rooms the first hold what is ``placed``."""
    tasks = _tasks(brief)
    held = (*placed, *((),) * (len(tasks) - len(placed)))
    answers = [RoomAnswer(0.0, groups, (), (), None, 0.0, 0) for groups in held]
    household = decide_household([task.space for task in tasks], brief.residents)
    return set_table(HomeState(tasks, opened, household), answers)


def _stand(task: RoomTask, name: str, case_name: str, at: tuple[float, float]) -> FurnishedGroup:
    """A group in one of its forms, the middle of its back ``at`` a point, facing north."""
    case = next(c for c in cases(name).groups if c.name == case_name)
    box = np.array([at[0], at[1] + case.depth / 2, NORTH, case.width, case.depth])
    group = make_unplaced(task, (), Wish(name, 1), case)
    dressed = dress_group(task, group, case, box, standing_of((), flat_kinds(task.catalog)))
    assert dressed is not None
    return dressed


def _places(answers: list[RoomAnswer]) -> list[float]:
    return [max((measure_places(g.pieces) for g in a.placed), default=0.0) for a in answers]


BATH = _room("bath", "bathroom", 20, 2, 2)
KITCHEN = _room("kitchen", "kitchen", 0, 4)
BEDROOMS = (_room("first", "bedroom", 5, 4), _room("second", "bedroom", 10, 4))


def test_a_home_has_one_table_with_a_place_for_each_who_sleeps_there():
    assert _places(_serve(_flat(KITCHEN, *BEDROOMS, BATH))) == [4.0, 0.0, 0.0, 0.0]
    three = (*BEDROOMS, _room("third", "bedroom", 15, 4))
    assert _places(_serve(_flat(KITCHEN, *three, BATH)))[0] == 6.0


@pytest.mark.parametrize(("function", "width", "served"), [("hall", 3.0, 1), ("storage", 3.0, 0)])
def test_they_eat_in_the_hall_where_the_kitchen_is_too_small_else_where_they_sleep(
    function, width, served
):
    kitchen = _room("kitchen", "kitchen", 0, 1.2, 1.4)
    other = _room("other", function, 2, width)
    answers = _serve(_flat(kitchen, other, BEDROOMS[0], BATH))
    assert [bool(places) for places in _places(answers)] == [False, bool(served), not served, False]


def test_a_table_for_two_grows_where_it_stands_and_is_not_doubled():
    task = _tasks(_flat(KITCHEN, *BEDROOMS, BATH))[0]
    two = _stand(task, "dining_wall", "0.8 m wall table for 2", (2.0, 0.0))
    answers = _serve(_flat(KITCHEN, *BEDROOMS, BATH), (two,))
    assert [measure_places(g.pieces) for g in answers[0].placed] == [4.0]
    assert not find_blocked(task, answers[0].placed)


@pytest.mark.parametrize(("timed", "gone"), [(False, ["plant", "vanity"]), (True, ["plant"])])
def test_what_is_welcome_and_holds_nothing_makes_room(timed, gone):
    task = _tasks(_flat(KITCHEN, *BEDROOMS, BATH))[1]
    names = ("plant", "vanity", "chest", "wardrobe")
    each = [_stand(task, name, cases(name).groups[0].name, (7.0, 0.0)) for name in names]
    placed = tuple(g._replace(wish=g.wish._replace(rank=WELCOME)) for g in each)
    rest, waiting = wait(placed, timed)
    assert [group.wish.group for group in waiting] == gone
    assert [g.wish.group for g in rest] == [name for name in names if name not in gone]
    asked = tuple(g._replace(wish=g.wish._replace(required=True)) for g in placed)
    needed = tuple(g._replace(wish=g.wish._replace(rank=1)) for g in placed[1:])
    assert wait(asked + needed, timed)[1] == ()


def test_a_table_that_was_asked_for_in_its_size_stays():
    task = _tasks(_flat(KITCHEN, *BEDROOMS, BATH))[0]
    two = _stand(task, "dining_wall", "0.8 m wall table for 2", (2.0, 0.0))
    asked = two._replace(wish=two.wish._replace(required=True))
    assert _serve(_flat(KITCHEN, *BEDROOMS, BATH), (asked,))[0].placed == (asked,)


def test_a_home_without_room_for_any_table_says_so():
    kitchen = _room("kitchen", "kitchen", 0, 1.2, 1.4)
    bedroom = _room("bed", "bedroom", 5, 2.2, 2.2)
    answers = _serve(_flat(kitchen, bedroom, BATH))
    assert _places(answers) == [0.0, 0.0, 0.0]
    (lost,) = [m for answer in answers for m in answer.missing]
    assert lost.wish.group == "dining_wall"
    assert lost.reason == "no room of the home is large enough for a table with two stools"


def test_a_table_that_takes_something_away_from_the_ways_of_the_home_is_not_set():
    def shut(trial):
        return [a._replace(missing=(*a.missing, *a.placed)) for a in trial]

    assert _places(_serve(_flat(KITCHEN, *BEDROOMS, BATH), opened=shut)) == [0.0] * 4


def test_rooms_that_are_listed_get_nothing_and_single_rooms_are_no_home():
    listed = KITCHEN | {"ask": [{"group": "kitchen"}]}
    bed = BEDROOMS[0] | {"ask": [{"group": "sleeping"}]}
    brief = _flat(listed, bed, BATH)
    assert _places(_serve(brief)) == [0.0] * 3
    assert not is_home(_tasks(_flat(BEDROOMS[0])))
    assert _places(_serve(_flat(BEDROOMS[0]))) == [0.0]


def test_a_bare_kitchen_gets_a_table_of_its_own():
    brief = _flat(KITCHEN, _room("dining", "dining", 5, 4), BEDROOMS[1], BATH)
    tasks = _tasks(brief)
    table = _stand(tasks[1], "dining", "1.2 m table for 4", (7.0, 1.0))
    held = ((), (table,), (), ())
    answers = [RoomAnswer(0.0, groups, (), (), None, 0.0, 0) for groups in held]
    found = add_kitchen_tables(HomeState(tasks, list), answers)
    assert _places(found) == [4.0, 4.0, 0.0, 0.0]
    again = add_kitchen_tables(HomeState(tasks, list), found)
    assert all(a is b for a, b in zip(again, found, strict=True))


def test_tables_for_so_many_are_listed_with_the_freestanding_first():
    assert {measure_places(case.members) for case in list_tables(4)} == {4.0}
    kinds = [case.function for case in list_tables(4)]
    assert kinds == sorted(kinds)
    stools = list_tables(1)
    assert stools
    assert all(any(m.category == "stool" for m in case.members) for case in stools)


def test_a_home_without_a_living_room_has_a_soft_seat_where_it_sleeps():
    brief = _flat(KITCHEN, BEDROOMS[0], BATH)
    tasks = _tasks(brief)
    answers = [RoomAnswer(0.0, (), (), (), None, 0.0, 0) for _ in tasks]
    found = add_soft_seat(HomeState(tasks, list), answers)
    seats = [
        [p.category for g in a.placed for p in g.pieces if p.category in SOFT_SEATS] for a in found
    ]
    assert seats == [[], ["armchair"], []]
    again = add_soft_seat(HomeState(tasks, list), found)
    assert all(a is b for a, b in zip(again, found, strict=True))


def _seat_beside(*pieces: Piece) -> list[tuple[float, float]]:
    """Where armchairs are put in a bedroom of 5 by 4 m beside its pieces."""
    kitchen = _room("kitchen", "kitchen", 0, 1.2, 1.4)
    tasks = _tasks(_flat(kitchen, _room("bed", "bedroom", 10.0, 5.0), BATH))
    bed = next(k for k, task in enumerate(tasks) if task.space.id == "bed")
    tasks[bed] = tasks[bed]._replace(fixed=(*tasks[bed].fixed, *pieces))
    answers = [RoomAnswer(0.0, (), (), (), None, 0.0, 0) for _ in tasks]
    found = add_soft_seat(HomeState(tasks, list), answers)
    seats = [p for a in found for g in a.placed for p in g.pieces if p.category in SOFT_SEATS]
    return [p.pose[:2] for p in seats]


def test_no_armchair_stands_amid_the_floor_by_itself():
    """With all walls taken two stand there."""
    taken = [
        *(_piece("chest_of_drawers", x, y, 0.3, d) for x, y, d in ((12.5, 0.15, 5), (12, 3.85, 4))),
        *(_piece("chest_of_drawers", x, 2.0, 3.0, 0.3) for x in (10.15, 14.85)),
    ]
    assert [len(_seat_beside()), len(_seat_beside(*taken))] == [1, 2]


def _piece(category: str, x: float, y: float, width: float, depth: float) -> Piece:
    return Piece(category, category, "", "a", Pose(x, y, 0.0, 0.0), Size(width, depth, 0.5))


def test_the_floor_others_are_used_from_is_beside_beds_and_before_doors():
    bed = _piece("double_bed", 0.0, 0.0, 1.6, 2.0)
    chair = _piece("armchair", 0.5, 1.2, 0.6, 0.6)
    assert measure_taken([chair], [bed]) > 0.1
    assert measure_taken([replace(chair, pose=Pose(-0.7, 1.2, 0, 0))], [bed]) == 0.0
    chest = _piece("chest_of_drawers", 0.0, 0.0, 1.0, 0.4)
    assert measure_taken([_piece("armchair", 0.8, 0.0, 0.6, 0.6)], [chest]) > 0.05
    assert measure_taken([_piece("armchair", 1.1, 0.0, 0.6, 0.6)], [chest]) == 0.0


def test_whole_homes_eat_and_sit_and_stay_valid():
    """Two bedrooms round a hall and a small kitchen, which bring no table by themselves."""
    hall = {
        "id": "hall",
        "function": "hall",
        "outline": [[0, 4.12], [6.6, 4.12], [6.6, 5.6], [0, 5.6]],
        "doors": [{"at": [0.6, 5.6], "width": 0.9, "swing": "out"}],
    }

    def room(name: str, function: str, x: float, width: float) -> dict:
        outline = [[x, 0], [x + width, 0], [x + width, 4], [x, 4]]
        door = {"at": [x + width - 0.7, 4.06], "width": 0.8, "to": "hall"}
        return {"id": name, "function": function, "outline": outline, "doors": [door]}

    rooms = [
        room("kitchen", "kitchen", 0, 1.7),
        room("bed", "bedroom", 1.82, 2.9),
        room("bath", "bathroom", 4.84, 1.76),
        hall,
    ]
    home = solve(_flat(*rooms), seed=3, threads=1)
    assert check(home).valid
    there = [p.category for p in home.pieces]
    assert "dining_table" in there or "round_table" in there
    assert set(there) & SOFT_SEATS


def test_what_moves_for_a_need_stands_elsewhere_and_holds_no_less():
    """A chair that takes all the wall on which alone it fits: the wardrobe there moves on."""
    task = next(t for t in _tasks(_flat(KITCHEN, *BEDROOMS, BATH)) if t.space.id == "first")
    chest = _stand(task, "chest", "1.2 m chest of drawers", (7.0, 0.0))
    wish, forms = Wish("reading", 1), list_seats(False)[-1:]
    for placed in islice(list_jointly(task, (chest,), (chest,), wish, forms, 0.0, 0.0), 5):
        stands, seat = placed
        assert measure_case(stands.dressed.case) == measure_case(chest.dressed.case)
        assert {p.category for p in seat.pieces} == {"armchair"}
        assert not find_blocked(task, placed)
    asked = chest._replace(wish=chest.wish._replace(required=True))
    jointly = list_jointly(task, (asked,), (asked,), wish, forms, 0.0, 0.0)
    assert all(placed[0] is asked for placed in jointly)


def test_storage_goes_for_a_need_only_within_what_is_spare():
    """A bedroom so small that a chair stands in it only in place of the chest."""
    small = _room("bed", "bedroom", 5, 1.7, 1.8)
    task = next(t for t in _tasks(_flat(KITCHEN, small, BATH)) if t.space.id == "bed")
    chest = _stand(task, "chest", "1.2 m chest of drawers", (5.7, 0.0))
    wish, forms = Wish("reading", 1), list_seats(False)[-1:]

    def find(shrunk: float) -> list[list[str]]:
        found = list_jointly(task, (chest,), (chest,), wish, forms, 20.0, shrunk)
        return [[g.wish.group for g in placed] for placed in found]

    assert ["reading"] not in find(1.1)
    assert ["reading"] in find(1.2)


def test_a_room_laid_out_anew_may_lose_storage_only_within_what_is_spare():
    task = next(t for t in _tasks(_flat(KITCHEN, *BEDROOMS, BATH)) if t.space.id == "first")
    forms = {
        c.dressed.case.width: c
        for c in (_stand(task, "chest", form.name, (7.0, 0.0)) for form in cases("chest").groups)
    }
    small, large = forms[min(forms)], forms[max(forms)]
    wide, less = [RoomAnswer(0.0, (g,), (), (), None, 0.0, 0) for g in (large, small)]
    gap = max(forms) - min(forms)
    assert not holds_no_less(wide, less)
    assert not holds_no_less(wide, less, gap - 0.05)
    assert holds_no_less(wide, less, gap + 0.01)
    assert holds_no_less(less, wide)
    table = _stand(task, "dining_wall", "0.9 m wall table for 2", (7.0, 0.0))
    assert not holds_no_less(wide._replace(placed=(large, table)), wide)


def test_a_proof_names_what_was_tried_and_what_stands_in_the_way():
    tasks = _tasks(_flat(KITCHEN, *BEDROOMS, BATH))
    kitchen, bath = (
        next(k for k, task in enumerate(tasks) if task.space.id == name)
        for name in ("kitchen", "bath")
    )
    text = tell_proof(tasks, [(bath, ())], list_tables(6)[0], "a table for 6")
    assert (
        text
        == "tried a table for 6 (2.6 x 1.9 m of floor) in bath, no wall or floor is long enough"
    )
    assert name_way(tasks[kitchen], "door 1") == "the door outside"
    assert name_way(tasks[kitchen], "kitchen") == "the kitchen run"
    helps = find_remedy(f"{text} (16.0 m² of floor)", REMEDIES)
    assert helps == "make 2.6 x 1.9 m of floor free for a table for 6 in one of these rooms"
