"""Rooms drawn side by side without a wall are one open space when furniture is chosen."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import scenewright as sw
from scenewright import formats
from scenewright.building.open_spaces import find_open_spaces
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution

SCREENS, SEATS = {"tv", "fireplace"}, {"sofa", "loveseat", "corner_sofa"}


def rooms_of(*widths: float, names: tuple[str, ...], passage: float = 4.0) -> list[dict[str, Any]]:
    """Rooms 4.4 m deep from west to east, touching, each open to the next over ``passage``."""
    found, x = [], 0.0
    for number, (name, width) in enumerate(zip(names, widths, strict=True)):
        room: dict[str, Any] = {
            "name": name,
            "outline": [[x, 0], [x + width, 0], [x + width, 4.4], [x, 4.4]],
            "windows": [{"at": [x + width / 2, 4.4], "width": 1.6}],
            "doors": [],
        }
        if number == 0:
            room["doors"].append({"at": [0.7, 0], "width": 0.9})
        if number < len(names) - 1:
            side = {"at": [x + width, 2.2], "width": passage, "swing": "none"}
            room["doors"].append(side)
        found.append(room)
        x += width
    return found


def solved(rooms: list[dict[str, Any]], **more: Any) -> Solution:
    return sw.solve(Brief.model_validate({"rooms": rooms} | more), steps=600)


def count(solution: Solution, kinds: set[str], space: str = "") -> int:
    return sum(p.category in kinds and p.space.startswith(space) for p in solution.pieces)


HALVES = ("Living room A", "Living room B")


@pytest.mark.parametrize(("passage", "one"), [(4.4, True), (2.8, True), (2.4, False), (1.0, False)])
def test_an_open_space_is_open_over_most_of_its_border(passage: float, one: bool) -> None:
    brief = Brief.model_validate({"rooms": rooms_of(5, 4, names=HALVES, passage=passage)})
    assert len(find_open_spaces(spaces(brief))) == one


def test_a_chain_of_open_rooms_is_one_space() -> None:
    rooms = rooms_of(4, 3, 3, names=("Living", "Dining", "Kitchen"))
    assert [
        len(ids) for ids in find_open_spaces(spaces(Brief.model_validate({"rooms": rooms})))
    ] == [3]


def test_two_halves_of_a_living_room_have_one_seating_with_one_screen() -> None:
    solution = solved(rooms_of(5, 4, names=HALVES))
    assert count(solution, SEATS) == count(solution, SCREENS) == 1
    assert count(solution, SEATS | SCREENS, "living-room-a") == 2
    assert count(solution, {"dining_table", "round_table"}, "living-room-b") == 1
    report = sw.check(solution)
    assert report.valid
    assert not report.notes
    assert not any(out.required for out in solution.left_out)


def test_rooms_with_a_wall_between_them_have_their_own() -> None:
    solution = solved(rooms_of(5, 4, names=HALVES, passage=1.0))
    assert count(solution, SEATS) == count(solution, SCREENS) == 2


def test_the_three_parts_of_an_open_plan_hold_each_thing_once() -> None:
    names = ("Living and dining", "Dining", "Open kitchen and dining")
    solution = solved(rooms_of(5, 3.4, 3.6, names=names))
    assert count(solution, SEATS) == count(solution, SCREENS) == 1
    tables = {"dining_table", "round_table"}
    assert count(solution, tables) == count(solution, tables, "dining") == 1
    assert count(solution, {"sideboard"}) == count(solution, {"sideboard"}, "dining") == 1
    assert count(solution, {"hob_cabinet"}) == 1
    assert not sw.check(solution).notes


def test_who_asks_for_seating_in_one_half_has_it_there() -> None:
    rooms = rooms_of(5, 4, names=HALVES)
    rooms[1]["wishes"] = [{"what": "seating", "by": "window"}]
    solution = solved(rooms)
    assert count(solution, SEATS, "living-room-b") == count(solution, SEATS) == 1


def test_where_a_screen_is_forbidden_the_other_half_has_both() -> None:
    rooms = rooms_of(5, 4, names=HALVES)
    rooms[0]["wishes"] = [{"what": "tv", "forbid": True}]
    solution = solved(rooms)
    assert count(solution, SEATS, "living-room-b") == count(solution, SCREENS) == 1


def test_a_sofa_that_stands_is_the_one() -> None:
    rooms = rooms_of(5, 4, names=HALVES)
    sofa = {"category": "sofa", "at": [8.5, 2.2], "heading": 3.1416, "size": [2.0, 0.9, 0.8]}
    rooms[1]["fixed"] = [sofa]
    solution = solved(rooms)
    assert count(solution, SEATS) == 1
    assert count(solution, SCREENS, "living-room-b") == count(solution, SCREENS)


def test_what_is_listed_for_both_halves_stands_in_both() -> None:
    rooms = rooms_of(5, 4, names=HALVES)
    for room in rooms:
        room["ask"] = [{"group": "seating"}]
    assert count(solved(rooms), SEATS) == 2


def test_the_referee_misses_what_stands_nowhere_in_an_open_space_once() -> None:
    rooms = rooms_of(5, 4, names=HALVES)
    for room in rooms:
        room["ask"] = [{"group": "plant"}]
    notes = [note for note in sw.check(solved(rooms)).notes if note.missing == "seat"]
    assert [note.space for note in notes] == ["living-room-a"]


def test_a_half_arranged_again_brings_no_second_seating() -> None:
    solution = solved(rooms_of(5, 4, names=HALVES))
    again = sw.resolve(solution, again=["Living room B"], steps=300, seed=3)
    assert count(again, SEATS) == count(again, SCREENS) == 1


HOME = """<home name='h'>
<room name='Living room'><point x='0' y='0'/><point x='450' y='0'/><point x='450' y='440'/>
<point x='0' y='440'/></room>
<room name='Salon'><point x='450' y='0'/><point x='850' y='0'/><point x='850' y='440'/>
<point x='450' y='440'/></room></home>"""


def test_rooms_of_a_drawn_home_that_touch_without_a_wall(tmp_path: Path) -> None:
    path = tmp_path / "home.xml"
    path.write_text(HOME)
    solution = sw.solve(formats.read(path), steps=600)
    assert count(solution, SEATS) == count(solution, SCREENS) == 1
