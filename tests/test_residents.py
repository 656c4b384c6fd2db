"""Stated residents: beds and seats follow, what is short is told; unstated, nothing changes."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from benchmarks.briefs import state
from benchmarks.briefs_households import BRIEFS

from flat import flat_brief, flat_solution
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains import check, plan_of, solve
from scenewright.domains.home.cases.library import SHIPPED, cases
from scenewright.domains.home.needs.household import (
    BED_PLACES,
    SEATED,
    count_places,
    decide_household,
    seat_residents,
    share_out,
    tell_programme,
)
from scenewright.domains.home.programme import Wish
from scenewright.formats import read_planned


def space(name: str, use: str, w: float, d: float) -> Space:
    outline = np.array([[0, 0], [w, 0], [w, d], [0, d]], float)
    return Space(name, name, (use,), "0", outline)


ROOMS = (
    space("big", "bedroom", 4, 3),
    space("small", "single_bedroom", 3, 2.6),
    space("tiny", "single_bedroom", 2.2, 2.6),
    space("living", "living", 6, 5),
)


@pytest.mark.parametrize(
    ("stated", "bunks"), [(None, ()), (3, ()), (5, ("small",)), (9, ("small",))]
)
def test_bunks_stand_where_beds_are_short_and_the_room_is_large_enough(
    stated: int | None, bunks: tuple[str, ...]
) -> None:
    household = decide_household(ROOMS, stated)
    assert household.bunks == bunks
    asked = (Wish("single", 0), Wish("wardrobe", 0))
    groups = [wish.group for wish in share_out(household, "small", asked, frozenset())]
    assert groups == ["bunk" if bunks else "single", "wardrobe"]


@pytest.mark.parametrize("people", [1, 2, 4, 6, 8])
@pytest.mark.parametrize("group", SEATED)
def test_tables_and_sofas_have_a_place_for_each(group: str, people: int) -> None:
    household = decide_household(ROOMS, people)
    kept = cases(group, seat_residents(household, "living", SHIPPED)).groups
    chairs = ("dining_chair", "sofa", "loveseat", "corner_sofa", "armchair")
    assert kept
    share, most = SEATED[group]
    for case in kept:
        assert case.width * case.depth <= share * 30.0
        seats = sum(m.category in chairs for m in case.members)
        if group == "dining":
            assert seats >= min(people, most)


def test_without_a_number_nothing_changes() -> None:
    household = decide_household(ROOMS)
    assert seat_residents(household, "living", SHIPPED) is SHIPPED
    asked = (Wish("single", 0), Wish("dining_wall", 1))
    assert share_out(household, "small", asked, frozenset(("dining",))) == asked


def test_a_number_stays_in_the_file_and_is_told() -> None:
    brief, plan = read_planned("sample:home-room")
    two = brief.model_copy(update={"residents": 2})
    assert "residents" not in json.loads(brief.model_dump_json())
    again = Brief.model_validate_json(two.model_dump_json())
    assert again.residents == 2
    told = tell_programme(solve(two, plan=plan, steps=200), plan)
    assert told.startswith("2 people in")
    assert "short)" in told or "beds for 2" in told


@pytest.mark.parametrize(
    ("beds", "told"),
    [
        (("single_bed",), "1 person in 1 bedroom"),
        (("single_bed", "bunk_bed"), "3 people in 1 bedroom"),
        ((), "no bed"),
    ],
)
def test_unstated_residents_are_those_who_have_a_bed(beds: tuple[str, ...], told: str) -> None:
    """A room for two in which a single bed was asked for is a bedroom for one."""
    plan = plan_of(flat_brief())
    stood = [
        Piece(f"{k}", kind, "", "bedroom", Pose(0, 0, 0, 0), Size(1, 2, 1), "", "")
        for k, kind in enumerate(beds)
    ]
    paragraph = tell_programme(replace(flat_solution(), pieces=tuple(stood)), plan)
    assert paragraph.split(";")[0] == told


@pytest.mark.parametrize("number", [0, -1, 21, 1.5, "two"])
def test_other_numbers_are_refused(number: object) -> None:
    document = json.loads(read_planned("sample:home-room")[0].model_dump_json())
    with pytest.raises(ValueError, match="residents"):
        Brief.model_validate(document | {"residents": number})


@pytest.mark.parametrize(
    ("rooms", "cooks_in", "fitted"),
    [
        ({"living+kitchen": 20.0, "kitchen+washroom": 9.0}, "living+kitchen", False),
        ({"kitchen": 5.0, "kitchen+washroom": 9.0}, "kitchen", False),
        ({"living": 20.0, "kitchen+washroom": 9.0}, "kitchen+washroom", True),
        ({"kitchen": 1.5, "kitchen+washroom": 4.0}, "kitchen+washroom", True),  # no room to cook
        ({"kitchen+washroom": 4.0, "kitchen+bathroom": 9.0}, "kitchen+bathroom", False),
    ],
)
def test_a_wet_room_is_no_second_kitchen(
    rooms: dict[str, float], cooks_in: str, fitted: bool
) -> None:
    spaces = [
        replace(space(name, "", area, 1.0), functions=tuple(name.split("+")))
        for name, area in rooms.items()
    ]
    household = decide_household(spaces)
    assert household.cooks_in == cooks_in
    for required in (False, True):
        wish = Wish("kitchen", 0, required=required)
        found = share_out(household, "kitchen+washroom", (wish,), frozenset())
        assert (wish in found) == (fitted or required)


def test_halls_have_no_residents() -> None:
    brief, _ = read_planned("sample:hall-shop")
    with pytest.raises(InputError, match="residents"):
        plan_of(brief.model_copy(update={"residents": 3}))


def test_thirty_households_state_what_they_need() -> None:
    assert len(BRIEFS) == 30
    assert len({row.words for row in BRIEFS}) == 30
    assert all(len(row.needs) >= 3 and 1 <= row.residents <= 5 for row in BRIEFS)


def test_a_wish_goes_to_the_largest_room_of_its_function() -> None:
    brief, plan = read_planned("sample:home-flat")
    row = next(row for row in BRIEFS if row.words == "a couple, one works from home")
    stated = state(row, brief, plan.spaces)
    wished = [room.name for room in stated.rooms if any(w.what == "desk" for w in room.wishes)]
    assert stated.residents == 2
    assert wished == ["Living and dining"]


def flat(**keys: object) -> Brief:
    """A flat for four: 18 m² to live and cook in, two small bedrooms."""

    def room(name: str, use: object, x0: float, y0: float, x1: float, y1: float, **more: object):
        outline = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
        return {"id": name, "function": use, "outline": outline, **more}

    living = {"doors": [{"at": [1, 0]}], "windows": [{"at": [3, 4], "width": 1.6}]}
    living |= {"wishes": [{"what": "piano", "required": True}]} if keys.pop("piano", 0) else {}
    rooms = [
        room("live", ["living", "kitchen"], 0, 0, 5, 4, **living),
        room("a", "bedroom", 5.1, 0, 8.5, 2.7, doors=[{"at": [5.05, 0.6]}]),
        room("b", "bedroom", 5.1, 2.8, 8.3, 5.6, doors=[{"at": [5.05, 3.4]}]),
    ]
    return Brief.model_validate({"name": "flat", "rooms": rooms, **keys})


@pytest.mark.parametrize("piano", [False, True])
def test_what_is_stated_stands_before_what_is_welcome(piano: bool) -> None:
    brief = flat(residents=4, piano=piano)
    solution = solve(brief, threads=1)
    held = [piece.category for piece in solution.pieces]
    assert sum(BED_PLACES.get(category, 0) for category in held) >= 4
    assert held.count("dining_chair") >= 4
    assert ("piano" in held) is piano
    assert not check(solution).findings


def test_a_table_is_chosen_that_seats_all() -> None:
    household = decide_household((space("live", "living", 4, 4),), 5)
    (wish,) = share_out(household, "live", (Wish("dining", 1),), frozenset(("dining",)))
    kept = cases(wish.group, seat_residents(household, "live", SHIPPED)).groups
    assert wish.group == "dining_wall"
    assert min(count_places(case.members) for case in kept) >= 5


def test_beds_that_residents_lack_are_left_out_by_name() -> None:
    solution = solve(flat(residents=9), threads=1)
    held = sum(BED_PLACES.get(piece.category, 0) for piece in solution.pieces)
    assert held < 9
    assert any(f"beds for {held} of 9" in out.reason for out in solution.left_out if out.required)
    assert any(f"beds for {held} of the 9" in note.message for note in check(solution).notes)


def test_a_home_without_a_kitchen_is_said_to_have_none() -> None:
    """Plans that name no kitchen get none, and the programme says so; a single room is no home."""

    def told(functions: list[str]) -> str:
        sides = [4.0 * k for k in range(len(functions) + 1)]
        rooms = [
            {"function": f, "outline": [[a + 0.1, 0], [b, 0], [b, 3], [a + 0.1, 3]], "ask": []}
            for f, a, b in zip(functions, sides, sides[1:], strict=False)
        ]
        home = Brief.model_validate({"rooms": rooms})
        plan = plan_of(home)
        return tell_programme(solve(home, plan=plan, steps=10), plan)

    assert "no room is a kitchen" in told(["living", "bedroom", "bathroom"])
    assert "no room is a kitchen" not in told(["living", "bedroom", "bathroom", "kitchen"])
    assert "no room is a kitchen" not in told(["bedroom"])


def test_one_child_in_a_large_room_sleeps_alone_where_beds_suffice() -> None:
    """A room of 16 m² holds two children; of a family of three only one sleeps there."""
    rooms = (space("parents", "bedroom", 4, 4), space("child", "child_bedroom", 4, 4))
    asked = (Wish("bunk", 0), Wish("wardrobe", 0))

    def beds(stated: int | None) -> str:
        return share_out(decide_household(rooms, stated), "child", asked, frozenset())[0].group

    assert [beds(stated) for stated in (None, 3, 4, 6)] == ["bunk", "single", "bunk", "bunk"]


def test_chairs_are_told_room_by_room() -> None:
    """Chairs of the kitchen are not added to those of the room in which they eat."""
    rooms = [
        {
            "id": "live",
            "function": ["living", "dining"],
            "outline": [[0, 0], [6, 0], [6, 5], [0, 5]],
        },
        {"id": "cook", "function": ["kitchen"], "outline": [[6.1, 0], [10, 0], [10, 4], [6.1, 4]]},
    ]
    rooms[1]["wishes"] = [{"what": "dining_wall", "required": True}]
    home = Brief.model_validate({"rooms": rooms})
    plan = plan_of(home)
    solution = solve(home, plan=plan, threads=1)
    held = {
        room: sum(p.category == "dining_chair" and p.space == room for p in solution.pieces)
        for room in ("live", "cook")
    }
    assert min(held.values()) >= 2
    told = tell_programme(solution, plan)
    assert all(f"{plan.names[room]} ({n} chairs)" in told for room, n in held.items())


def test_further_beds_stand_where_residents_would_have_none() -> None:
    """Six in one bedroom of 22 m² and one of 8 m²: bunks come before a vanity and armchairs."""
    rooms = [
        {
            "id": "big",
            "function": "double_bedroom",
            "outline": [[0, 0], [5.5, 0], [5.5, 4], [0, 4]],
        },
        {
            "id": "small",
            "function": "single_bedroom",
            "outline": [[5.6, 0], [8.6, 0], [8.6, 2.7], [5.6, 2.7]],
        },
    ]
    rooms[0]["doors"] = [{"at": [1, 0], "width": 0.85}]
    rooms[1]["doors"] = [{"at": [7.8, 0], "width": 0.85}]
    solution = solve(Brief.model_validate({"rooms": rooms, "residents": 6}), threads=1)
    held = [p.category for p in solution.pieces]
    assert sum(BED_PLACES.get(category, 0) for category in held) >= 6
    assert "double_bed" in held
    assert held.count("wardrobe") == 2
    assert not any(out.required for out in solution.left_out)
    assert not check(solution).findings
