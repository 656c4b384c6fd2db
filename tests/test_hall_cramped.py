"""Who serves at a single till has room to stand behind it."""

from __future__ import annotations

import math
from typing import Any

import pytest
import shapely

import scenewright
from scenewright.core.brief import Brief

SHOP: dict[str, Any] = {
    "name": "Bookshop",
    "outline": [[0, 0], [10, 0], [10, 9], [0, 9]],
    "doors": [{"at": [2.6, 0], "width": 1.6, "swing": "slide"}],
    "demands": [
        {"category": "checkout"},
        {"category": "display_table", "count": 3},
        {"category": "book_stack", "count": 6},
    ],
}


@pytest.mark.parametrize("seed", [0, 2])
def test_nobody_serves_between_a_till_and_a_wall(seed: int) -> None:
    brief = Brief.model_validate({"domain": "hall", "rooms": [SHOP]})
    found = scenewright.solve(brief, seed=seed, threads=1)
    (till,) = (piece for piece in found.pieces if piece.category == "checkout")
    x, y, heading = till.pose.x, till.pose.y, till.pose.heading
    far = 0.5 * till.size.depth + 0.7
    behind = shapely.Point(x - far * math.cos(heading), y - far * math.sin(heading))
    assert scenewright.check(found).valid
    assert shapely.Polygon(SHOP["outline"]).contains(behind)
