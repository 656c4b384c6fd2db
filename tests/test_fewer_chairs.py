"""A chair that cannot be drawn back may leave its table, a chest the wall of a wardrobe; both are
told."""

from __future__ import annotations

import numpy as np

from scenewright.arranging.verdict import better
from scenewright.domains.home.composing.room_moves import MOVES
from scenewright.domains.home.composing.verdict import FEWER, judge_room
from test_windows_cleared import DOOR, NORTH, answer_of, stand, task_of

ROOM = {
    "id": "eat",
    "function": "dining",
    "outline": [[0, 0], [4, 0], [4, 3], [0, 3]],
    "doors": [DOOR],
    "windows": [{"at": [2.0, 3.0], "width": 1.4, "sill": 0.9}],
}


def count_chairs(answer):
    return sum(p.category == "dining_chair" for g in answer.placed for p in g.pieces)


def wedged():
    """A table for three whose end is at a side wall, and its task."""
    task = task_of(ROOM)
    table = stand(
        task, "dining_wall", 3.0, 3.0, -NORTH, lambda c: c.name == "1.0 m wall table for 3"
    )
    return task, answer_of(table)


def test_every_room_with_a_chair_less_says_so():
    task, answer = wedged()
    assert judge_room(task, answer).findings["near"] > 0
    rooms = list(MOVES["fewer"](task, answer, "near"))
    assert rooms
    for room in rooms:
        assert count_chairs(room) == count_chairs(answer) - 1
        assert [missing.reason for missing in room.missing] == [FEWER]
        assert np.isfinite(judge_room(task, room, answer.placed).total)


def test_a_chair_less_is_a_loss_where_it_is_not_told():
    task, answer = wedged()
    before = judge_room(task, answer, answer.placed)
    for room in MOVES["fewer"](task, answer, "near"):
        told = judge_room(task, room, answer.placed)
        silent = judge_room(task, room._replace(missing=()), answer.placed)
        assert told.findings["less places"] == 0.0
        assert silent.findings["less places"] == 1.0
        assert not better(silent, before)


NARROW = ROOM | {
    "id": "bed",
    "function": "bedroom",
    "outline": [[0, 0], [2.0, 0], [2.0, 2.6], [0, 2.6]],
    "windows": [],
}


def test_a_chest_makes_room_for_a_whole_wardrobe_and_is_told():
    task = task_of(NARROW)
    half = stand(task, "wardrobe", 0.4, 2.6, -NORTH, lambda c: c.width < 0.9)
    chest = stand(task, "chest", 1.4, 2.6, -NORTH, lambda c: c.width <= 1.2)
    before = answer_of(half, chest)
    now = judge_room(task, before, before.placed)
    assert now.findings["wardrobe"] == 1.0
    rooms = list(MOVES["spare"](task, before, "wardrobe"))
    assert any(better(judge_room(task, room, before.placed), now) for room in rooms)
    for room in rooms:
        assert [group.name for group in room.placed] == ["wardrobe"]
        assert [missing.wish.group for missing in room.missing] == ["chest"]
    required = before._replace(
        placed=(half, chest._replace(wish=chest.wish._replace(required=True)))
    )
    assert not list(MOVES["spare"](task, required, "wardrobe"))
