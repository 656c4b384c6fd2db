"""Armchairs stand round low tables, not in rows, unless a brief asks for these."""

from __future__ import annotations

from typing import Any

import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution


def lounge(count: int, **more: Any) -> Brief:
    """Armchairs and two tables to read at in a hall of 12 by 9 m."""
    room = {
        "name": "Lounge",
        "outline": [[0, 0], [12, 0], [12, 9], [0, 9]],
        "doors": [{"at": [2, 0], "width": 1.8}],
        "demands": [
            {"id": "chairs", "category": "armchair", "count": count, **more},
            {"category": "bookcase", "count": 6},
            {"category": "reading_table", "count": 2},
        ],
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


def read_pattern(solution: Solution) -> str:
    return next(g.pattern for g in solution.detail.layout.groups if g.demand == "chairs")


@pytest.mark.parametrize(("count", "tables"), [(5, 2), (6, 2)])
def test_armchairs_stand_round_low_tables(count: int, tables: int) -> None:
    found = scenewright.solve(lounge(count), seed=1, threads=1)
    assert read_pattern(found) == "around"
    assert sum(piece.category == "coffee_table" for piece in found.pieces) == tables
    assert scenewright.check(found).valid
    assert not found.left_out


def test_a_pattern_that_is_asked_for_stays() -> None:
    found = scenewright.solve(lounge(5, patterns=["grid"]), seed=1, threads=1)
    assert read_pattern(found) == "grid"
