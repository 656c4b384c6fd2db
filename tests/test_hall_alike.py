"""Rooms like another, things of one's own, and companies of what is shown singly."""

from __future__ import annotations

import math

import numpy as np
import pytest

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.solution import Solution
from scenewright.domains import check, plan_of, solve
from scenewright.domains.hall.demands.checked import usual_clearance
from scenewright.domains.hall.zoning.zones import check_halls

BEDS = [{"category": "single_bed", "count": 2}, {"category": "lockers", "count": 1}]


def room(number: int, x: float, width: float, door: float, **more: object) -> dict[str, object]:
    """A room of a ward, its door in the south."""
    outline = [[x, 0], [x + width, 0], [x + width, 6], [x, 6]]
    doors = [{"id": f"d{number}", "at": [door, 0], "width": 1.1}]
    return {"id": f"room-{number}", "outline": outline, "height": 3, "doors": doors, **more}


def ward(*rooms: dict[str, object]) -> Brief:
    return Brief.model_validate({"domain": "hall", "name": "ward", "rooms": list(rooms)})


def solve_ward(*rooms: dict[str, object]) -> Solution:
    return solve(ward(*rooms), steps=600, threads=1)


MODEL = room(1, 0.0, 5.0, 1.2, demands=BEDS)


def places(solution: Solution, space: str) -> dict[str, tuple[float, float]]:
    found = [piece for piece in solution.pieces if piece.space == space]
    return {p.id.partition("/")[2]: (p.pose.x, p.pose.y) for p in found}


def test_a_room_like_another_is_its_mirror_image_where_its_door_is() -> None:
    solution = solve_ward(MODEL, room(2, 5.2, 5.0, 9.0, like="room-1"))
    one, other = places(solution, "room-1"), places(solution, "room-2")
    assert set(one) == set(other)
    assert len(one) >= 3
    for name, (x, y) in one.items():
        assert other[name] == pytest.approx((10.2 - x, y), abs=0.05)
    assert any("like room-1, mirrored" in note for note in solution.brief.notes)
    assert not check(solution).findings
    assert not solution.left_out


def test_a_little_wider_room_has_its_pieces_at_its_walls_and_says_which() -> None:
    solution = solve_ward(MODEL, room(2, 5.2, 5.4, 6.4, like="room-1"))
    assert not check(solution).findings
    assert not solution.left_out
    assert len(places(solution, "room-2")) == len(places(solution, "room-1"))
    assert any(note.startswith("room-2 is laid out like room-1") for note in solution.brief.notes)


def test_a_room_of_another_form_is_laid_out_by_itself() -> None:
    long = room(2, 5.2, 22.0, 16.0, like="room-1")
    solution = solve_ward(MODEL, long)
    assert len(places(solution, "room-2")) == len(places(solution, "room-1"))
    assert any("is not laid out like" in note for note in solution.brief.notes)
    assert not solution.left_out


def test_what_was_solved_can_be_solved_again() -> None:
    solution = solve_ward(MODEL, room(2, 5.2, 5.0, 9.0, like="room-1"))
    again = solve(solution.brief, steps=600, threads=1)
    assert again.brief.notes == solution.brief.notes
    for name, at in places(solution, "room-2").items():
        assert places(again, "room-2")[name] == pytest.approx(at)


@pytest.mark.parametrize(
    ("like", "told"),
    [("room-9", "not the id of another room"), ("room-2", "not the id"), ("room-3", "itself like")],
)
def test_what_a_room_cannot_be_like_is_refused(like: str, told: str) -> None:
    third = room(3, 10.4, 5.0, 12.0, like="room-1")
    brief = ward(MODEL, room(2, 5.2, 5.0, 9.0, like=like), third)
    with pytest.raises(InputError, match=told):
        check_halls(brief, plan_of(brief))


def shop(*demands: dict[str, object]) -> Brief:
    outline = [[0, 0], [14, 0], [14, 10], [0, 10]]
    doors = [{"id": "front", "at": [2, 0], "width": 1.8}]
    hall = {"id": "hall", "outline": outline, "height": 4, "doors": doors, "demands": list(demands)}
    return ward(hall)


RACK = {"category": "box", "name": "kayak rack", "count": 4, "size": [2.4, 0.8, 1.8]}


def test_a_kind_of_ones_own_is_free_where_it_is_used() -> None:
    brief = shop({**RACK, "used_from": ["front", "back"]})
    assert usual_clearance(brief.rooms[0].demands[0]) == (0.75, 0.0, 0.75, 0.0)
    solution = solve(brief, steps=1500, threads=1)
    racks = [piece for piece in solution.pieces if piece.category == "box"]
    assert len(racks) == 4
    assert not check(solution).findings
    for rack in racks:
        front = np.array([math.cos(rack.pose.heading), math.sin(rack.pose.heading)])
        for side in (1.0, -1.0):
            x, y = np.array(rack.pose[:2]) + side * 0.85 * front
            assert 0 < x < 14
            assert 0 < y < 10


def test_unknown_sides_are_refused() -> None:
    with pytest.raises(ValueError, match="used_from"):
        shop({**RACK, "used_from": ["top"]})


@pytest.mark.parametrize(("count", "least"), [(13, 0.5), (5, 0.0)])
def test_many_mannequins_stand_in_companies(count: int, least: float) -> None:
    solution = solve(shop({"category": "mannequin", "count": count}), steps=1000, threads=1)
    at = np.array([piece.pose[:2] for piece in solution.pieces if piece.category == "mannequin"])
    assert len(at) == count
    far = np.sort(np.hypot(*(at[:, None] - at[None]).transpose(2, 0, 1)), axis=1)
    assert not solution.left_out
    if count >= 6:
        near = (far < 1.4).sum(1)
        assert ((near >= 3) & (near <= 5)).all()
        assert (far[:, 5] > far[:, 2] + least).all()
