"""What stands fixed in one room and reaches into the next counts there as well."""

from __future__ import annotations

from typing import Any

import pytest

from scenewright import domains
from scenewright.building.plan import spaces
from scenewright.building.standing import fixed_pieces, reaching_in
from scenewright.catalog.assets import shipped
from scenewright.check.bodies import bodies_of, rooms_of, standing_in
from scenewright.core.brief import Brief
from scenewright.domains import check

Json = dict[str, Any]


def two_rooms(width: float = 2.0) -> Brief:
    """Two rooms side by side; a chest of the first reaches through the wall by most of itself."""
    chest: Json = {
        "id": "chest",
        "category": "box",
        "at": [3.0 + width / 2 - 0.05, 1.5],
        "size": [2.6, width, 0.9],
        "heading": 0.0,
    }
    first: Json = {
        "id": "a",
        "function": "other",
        "outline": [[0, 0], [3, 0], [3, 3], [0, 3]],
        "fixed": [chest],
        "doors": [{"at": [1.5, 0]}],
    }
    second: Json = {
        "id": "b",
        "function": "bedroom",
        "doors": [{"at": [5.5, 0]}],
        "outline": [[3.1, 0], [7, 0], [7, 3], [3.1, 3]],
    }
    return Brief.model_validate({"rooms": [first, second]})


def test_what_reaches_into_a_room_is_found() -> None:
    brief = two_rooms()
    rooms = spaces(brief)
    pairs = zip(brief.rooms, rooms, strict=True)
    standing = [fixed_pieces(room, space, shipped()) for room, space in pairs]
    own, other = reaching_in(standing, rooms)
    assert own == ()
    assert [piece.id for piece in other] == ["chest"]


def test_the_referee_sees_it_in_both_rooms() -> None:
    brief = two_rooms()
    rooms = rooms_of(spaces(brief))
    piece = fixed_pieces(brief.rooms[0], rooms.spaces[0], shipped())
    bodies, _ = bodies_of(tuple(piece), rooms, shipped())
    assert bodies.into.tolist() == [[0, 1]]
    assert standing_in(bodies, rooms.level[:1] + 1).tolist() == [True]


@pytest.mark.parametrize("seed", range(2))
def test_nothing_is_placed_where_it_stands(seed: int) -> None:
    solution = domains.solve(two_rooms(), seed=seed, steps=200, threads=1)
    assert sum(piece.id == "chest" for piece in solution.pieces) == 1
    found = [one for one in check(solution).findings if one.kind == "collision"]
    assert found == []
