"""Stands of a fair turn their closed backs to walls, not to who comes in."""

from __future__ import annotations

import math

import pytest

import scenewright
from scenewright.core.brief import Brief

FAIR = Brief.model_validate(
    {
        "domain": "hall",
        "rooms": [
            {
                "name": "Trade fair hall",
                "outline": [[0, 0], [30, 0], [30, 20], [0, 20]],
                "doors": [{"id": "main", "at": [15, 0], "width": 3.6, "swing": "slide"}],
                "demands": [
                    {"category": "info_desk", "size": [4.0, 0.9, 1.1]},
                    {
                        "category": "exhibit_island",
                        "count": 12,
                        "name": "stands of the fair",
                        "size": [4.0, 3.0, 2.5],
                    },
                    {"category": "round_table", "count": 5, "size": [0.8, 0.8, 0.74]},
                ],
            }
        ],
    }
)


@pytest.mark.parametrize("seed", [6, 8])
def test_the_last_row_of_stands_faces_who_comes_in(seed: int) -> None:
    found = scenewright.solve(FAIR, seed=seed, threads=1)
    stands = [piece for piece in found.pieces if piece.category == "exhibit_island"]
    farthest = max(piece.pose.y for piece in stands)
    last = [piece for piece in stands if piece.pose.y > farthest - 1.0]
    assert scenewright.check(found).valid
    assert len(stands) == 12
    assert all(math.sin(piece.pose.heading) < 0.1 for piece in last)
