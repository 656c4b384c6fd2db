"""Stairs and the walls of the level they begin on."""

from __future__ import annotations

from math import pi
from typing import Any

import pytest

from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError

HALL = [[0, 0], [4, 0], [4, 3.4], [0, 3.4]]
BEHIND = [[0, 3.52], [4, 3.52], [4, 6.5], [0, 6.5]]


def house(doors: list[dict[str, Any]], function: str) -> Brief:
    """Two floors; straight stairs from the hall over the room behind it."""
    rooms = [
        {"id": "hall", "function": "hall", "level": "0", "outline": HALL, "doors": doors},
        {"id": "study", "function": function, "level": "0", "outline": BEHIND},
        {
            "id": "landing",
            "function": "hall",
            "level": "1",
            "outline": [[0, 0], [4, 0], [4, 6.5], [0, 6.5]],
        },
    ]
    levels = [{"id": "0"}, {"id": "1", "elevation": 2.8}]
    stairs = [{"at": [0.6, 1.2], "heading": pi / 2, "going": 0.22}]
    return Brief.model_validate({"levels": levels, "stairs": stairs, "rooms": rooms})


def test_stairs_run_through_no_wall_of_their_level() -> None:
    with pytest.raises(InputError, match="runs through the wall between 'hall' and 'study'"):
        spaces(house([], "study"))


def test_a_closet_may_lie_beneath_stairs() -> None:
    assert len(spaces(house([], "storage"))) == 3


def test_stairs_may_go_through_an_open_passage() -> None:
    passage = {"at": [0.6, 3.4], "width": 1.1, "to": "study", "swing": "none"}
    assert len(spaces(house([passage], "study"))) == 3
    with pytest.raises(InputError, match="through the wall"):
        spaces(house([passage | {"swing": "in"}], "study"))
