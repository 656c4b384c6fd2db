"""Chairs come with desks without being asked for: behind them, at their front, on both sides."""

from __future__ import annotations

import math
from collections import Counter
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution


def hall(*demands: dict[str, Any], wide: float = 12.0) -> Brief:
    room = {
        "name": "Hall",
        "outline": [[0, 0], [wide, 0], [wide, 9], [0, 9]],
        "doors": [{"at": [2, 0], "width": 1.6}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Hall", "rooms": [room]})


def chairs_at(found: Solution, desk: Piece) -> list[Piece]:
    return [piece for piece in found.pieces if piece.id.startswith(f"{desk.id}/")]


def ahead_of(desk: Piece, chair: Piece) -> float:
    """Metres by which a chair lies before the middle of a desk."""
    front = np.array([math.cos(desk.pose.heading), math.sin(desk.pose.heading)])
    return float(np.subtract(chair.pose[:2], desk.pose[:2]) @ front)


def looks_at(desk: Piece, chair: Piece) -> bool:
    turned = math.cos(chair.pose.heading - desk.pose.heading)
    return turned * ahead_of(desk, chair) < -0.99 * abs(ahead_of(desk, chair))


def of(found: Solution, category: str) -> list[Piece]:
    return [piece for piece in found.pieces if piece.category == category]


@pytest.mark.parametrize(
    ("demand", "front", "behind"),
    [
        ({"category": "info_desk"}, {}, {"office_chair": 2}),
        ({"category": "info_desk", "size": [1.4, 0.9, 1.1]}, {}, {"office_chair": 1}),
        ({"category": "carrel", "count": 4}, {"reading_chair": 1}, {}),
        ({"category": "desk", "count": 2}, {"office_chair": 1}, {}),
        (
            {"category": "desk", "count": 2, "name": "Beratungstisch"},
            {"office_chair": 1},
            {"dining_chair": 2},
        ),
        ({"category": "lectern"}, {}, {}),
    ],
)
def test_every_desk_has_the_chairs_of_its_kind(
    demand: dict[str, Any], front: dict[str, int], behind: dict[str, int]
) -> None:
    found = scenewright.solve(hall(demand, {"category": "plinth", "count": 3}), seed=1, steps=2000)
    desks = of(found, demand["category"])
    assert desks
    for desk in desks:
        chairs = chairs_at(found, desk)
        assert all(looks_at(desk, chair) for chair in chairs)
        sides = [ahead_of(desk, chair) > 0.0 for chair in chairs]
        counts = Counter(zip((chair.category for chair in chairs), sides, strict=True))
        asked = {(k, True): n for k, n in front.items()} | {
            (k, False): n for k, n in behind.items()
        }
        assert counts == asked
    report = scenewright.check(found)
    assert report.valid, report.findings


def test_chairs_asked_for_stand_at_desks_instead() -> None:
    asked = {"category": "dining_chair", "count": 4}
    found = scenewright.solve(hall({"category": "desk", "count": 4}, asked), seed=1, steps=2000)
    assert len(of(found, "dining_chair")) == 4
    assert not of(found, "office_chair")


def test_chairs_move_nothing_and_the_printed_presets_have_none() -> None:
    brief = scenewright.read("sample:hall-reading-room")
    found = scenewright.solve(brief, seed=0, steps=2000)
    (desk,) = of(found, "info_desk")
    assert len(chairs_at(found, desk)) == 2
    assert all(
        piece.id not in group.objects
        for group in found.detail.layout.groups
        for piece in chairs_at(found, desk)
    )
    printed = scenewright.solve(brief, seed=0, preset="paper")
    assert not of(printed, "office_chair")


def test_a_desk_at_a_wall_has_no_chair_where_nobody_gets_behind_it() -> None:
    desk = {"category": "info_desk", "place": "wall", "size": [2.0, 0.6, 1.1]}
    brief = hall(desk)
    room = brief.rooms[0].model_copy(update={"outline": [(0, 0), (4.2, 0), (4.2, 2.3), (0, 2.3)]})
    found = scenewright.solve(brief.model_copy(update={"rooms": [room]}), seed=0, steps=1000)
    assert of(found, "info_desk")[0].pose.y > 2.3 - 0.35
    assert not of(found, "office_chair")
    assert scenewright.check(found).valid
