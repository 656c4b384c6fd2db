"""Between desks of one group people pass; desks for advice have room on both sides."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.solution import Solution


def hall(*demands: dict[str, Any], wide: float = 20.0) -> Brief:
    room = {
        "name": "Hall",
        "outline": [[0, 0], [wide, 0], [wide, 12], [0, 12]],
        "doors": [{"at": [2, 0], "width": 1.6}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Hall", "rooms": [room]})


def least_gap(found: Solution) -> float:
    """Metres between the two nearest desks."""
    shapes = polygons_of([piece for piece in found.pieces if piece.category == "desk"])
    return min(float(shapely.distance(a, b)) for a, b in combinations(shapes, 2))


@pytest.mark.parametrize(("name", "way"), [("exam desks", 0.6), ("sales desks", 1.2)])
@pytest.mark.parametrize("seed", [0, 1])
def test_desks_stand_singly_with_a_way_between(name: str, way: float, seed: int) -> None:
    asked = {"category": "desk", "count": 6, "name": name}
    found = scenewright.solve(hall(asked), seed=seed, steps=2000)
    assert sum(piece.category == "desk" for piece in found.pieces) == 6
    assert least_gap(found) > way - 1e-6
    assert np.all([piece.size.width == 1.4 for piece in found.pieces if piece.category == "desk"])
    assert not found.left_out
    assert scenewright.check(found).valid


def test_all_chairs_of_desks_for_advice_stand() -> None:
    asked = {"category": "desk", "count": 4, "name": "advice"}
    found = scenewright.solve(hall(asked, wide=14.0), seed=0, steps=2000)
    assert sum(piece.category == "dining_chair" for piece in found.pieces) == 8
    assert sum(piece.category == "office_chair" for piece in found.pieces) == 4


@pytest.mark.parametrize("own", [{"patterns": ["chain"]}, {"count": 40}])
def test_stated_patterns_and_crowded_halls_stay_as_they_are(own: dict[str, Any]) -> None:
    asked = {"category": "desk", "count": 8, **own}
    found = scenewright.solve(hall(asked, wide=14.0), seed=0, steps=1000)
    count = sum(piece.category == "desk" for piece in found.pieces)
    assert count == asked["count"]
    assert least_gap(found) < 0.6


def test_desks_for_advice_part_also_where_they_take_more_than_half_of_their_floor() -> None:
    asked = {"category": "desk", "count": 5, "name": "advice", "size": [1.6, 0.8, 0.74]}
    room = {
        "name": "Bank",
        "outline": [[0, 0], [11, 0], [11, 6], [0, 6]],
        "doors": [{"at": [1, 0], "width": 1.6}],
        "demands": [asked],
    }
    brief = Brief.model_validate({"domain": "hall", "name": "Bank", "rooms": [room]})
    found = scenewright.solve(brief, seed=59, threads=1)
    assert sum(piece.category == "desk" for piece in found.pieces) == 5
    assert sum(piece.category == "dining_chair" for piece in found.pieces) == 10
    assert least_gap(found) > 1.2 - 1e-6
    assert scenewright.check(found).valid
