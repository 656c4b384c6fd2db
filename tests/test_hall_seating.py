"""Chairs asked for beside desks and tables stand at them."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright import domains
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.seats.seating import TUCK


def seminar(*demands: dict[str, Any]) -> Brief:
    room = {
        "name": "Seminar",
        "outline": [[0, 0], [12, 0], [12, 9], [0, 9]],
        "doors": [{"at": [0, 1.5], "width": 1.2}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Seminar", "rooms": [room]})


DESKS: dict[str, Any] = {"category": "desk", "count": 6}
CHAIRS: dict[str, Any] = {"category": "office_chair", "count": 6}
SCREEN: dict[str, Any] = {"category": "screen"}


def of(found: Solution, category: str) -> list[Piece]:
    return [piece for piece in found.pieces if piece.category == category]


def at_front(chair: Piece, desk: Piece) -> bool:
    """Whether a chair stands before the front of a desk, pushed in, and looks at it."""
    ahead = np.array([math.cos(desk.pose.heading), math.sin(desk.pose.heading)])
    off = np.array(chair.pose[:2]) - np.array(desk.pose[:2])
    far = 0.5 * (desk.size.depth + chair.size.depth) - TUCK
    looks = math.cos(chair.pose.heading - desk.pose.heading)
    return bool(np.allclose(off, far * ahead, atol=1e-6) and looks < -0.999)


@pytest.mark.parametrize("seed", [0, 1])
def test_every_desk_has_its_chair_before_its_front(seed: int) -> None:
    found = scenewright.solve(seminar(DESKS, CHAIRS), seed=seed)
    desks, chairs = of(found, "desk"), of(found, "office_chair")
    assert len(desks) == len(chairs) == 6
    assert all(sum(at_front(chair, desk) for chair in chairs) == 1 for desk in desks)
    assert scenewright.check(found).valid
    assert not found.left_out


def test_who_sits_at_desks_looks_at_the_screen() -> None:
    found = scenewright.solve(seminar(DESKS, CHAIRS, SCREEN), seed=1)
    screen = np.array(of(found, "screen")[0].pose[:2])
    for chair in of(found, "office_chair"):
        way = screen - np.array(chair.pose[:2])
        look = math.cos(chair.pose.heading), math.sin(chair.pose.heading)
        assert way @ look > 0.6 * math.hypot(*way)


@pytest.mark.parametrize("seed", [1, 2])
def test_a_lectern_stands_beside_the_screen_and_looks_at_the_audience(seed: int) -> None:
    found = scenewright.solve(seminar(DESKS, CHAIRS, SCREEN, {"category": "lectern"}), seed=seed)
    ((screen,), (lectern,)) = of(found, "screen"), of(found, "lectern")
    front = np.array([math.cos(screen.pose.heading), math.sin(screen.pose.heading)])
    off = np.array(lectern.pose[:2]) - np.array(screen.pose[:2])
    assert 0.3 < off @ front < 3.0
    assert 0.5 * screen.size.width < abs(off @ (front[1], -front[0])) < screen.size.width + 1.5
    assert math.cos(lectern.pose.heading - screen.pose.heading) > 0.99


def test_chairs_beyond_the_desks_stand_by_themselves() -> None:
    found = scenewright.solve(seminar(DESKS, CHAIRS | {"count": 8}), seed=1)
    chairs = of(found, "office_chair")
    seated = [any(at_front(chair, desk) for desk in of(found, "desk")) for chair in chairs]
    assert (len(chairs), sum(seated)) == (8, 6)


def test_tables_share_the_chairs_asked_for_evenly() -> None:
    tables = {"category": "dining_table", "count": 3}
    found = scenewright.solve(seminar(tables, {"category": "dining_chair", "count": 6}), seed=1)
    each = [
        sum(p.id.startswith(f"{table.id}/") for p in found.pieces)
        for table in of(found, "dining_table")
    ]
    assert each == [2, 2, 2]
    assert all(piece.function == "dining_chair" for piece in of(found, "dining_chair"))


def test_chairs_with_a_pattern_of_their_own_stay_where_it_puts_them() -> None:
    found = scenewright.solve(seminar(DESKS, CHAIRS | {"patterns": ["grid"]}), seed=1)
    assert not any(
        at_front(chair, desk) for chair in of(found, "office_chair") for desk in of(found, "desk")
    )


def test_a_desk_moved_by_hand_takes_its_chair_along() -> None:
    found = scenewright.solve(seminar(DESKS, CHAIRS), seed=1)
    name = of(found, "desk")[0].id
    moved = domains.adjust(found, move={name: (6.0, 4.0)}).solution
    desk = next(piece for piece in of(moved, "desk") if piece.id == name)
    assert sum(at_front(chair, desk) for chair in of(moved, "office_chair")) == 1
    assert len(of(moved, "office_chair")) == 6


def test_chairs_for_which_no_desk_is_left_are_named() -> None:
    found = scenewright.solve(seminar(DESKS | {"count": 60}, CHAIRS | {"count": 60}), seed=1)
    lacking = 60 - len(of(found, "desk"))
    assert lacking > 0
    assert len(of(found, "office_chair")) == len(of(found, "desk"))
    assert f"{lacking} of 60 office chair" in {row.what for row in found.left_out}


@pytest.mark.parametrize("seed", [0, 2])
def test_chairs_are_shared_by_tables_of_several_kinds(seed: int) -> None:
    tables = [{"category": kind, "count": 3} for kind in ("round_table", "dining_table")]
    found = scenewright.solve(
        seminar(*tables, {"category": "dining_chair", "count": 24}), seed=seed, steps=3000
    )
    chairs = of(found, "dining_chair")
    at = [sum(chair.id.startswith(f"{table.id}/") for chair in chairs) for table in found.pieces]
    assert sorted(count for count in at if count) == [4] * 6
    assert scenewright.check(found).valid
    assert not found.left_out


def test_a_hall_nobody_can_enter_is_noted() -> None:
    brief = seminar(DESKS)
    shut = brief.model_copy(update={"rooms": [brief.rooms[0].model_copy(update={"doors": []})]})
    for one, noted in ((brief, False), (shut, True)):
        notes = scenewright.check(scenewright.solve(one, steps=500)).notes
        assert any("nobody can enter it" in str(note) for note in notes) is noted
