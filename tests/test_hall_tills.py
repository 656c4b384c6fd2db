"""Tills stand between the goods and the way out."""

from __future__ import annotations

import math

import numpy as np
import pytest

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece

WAY_OUT = (9.0, 0.0)
GOODS = ("gondola", "wall_shelving", "fridge_shelf")


def off(piece: Piece) -> float:
    return math.dist(piece.pose[:2], WAY_OUT)


@pytest.mark.parametrize("seed", [1, 4])
def test_no_goods_lie_between_the_tills_and_the_way_out(seed: int) -> None:
    room = {
        "name": "supermarket",
        "outline": [[0, 0], [24, 0], [24, 16], [0, 16]],
        "doors": [
            {"at": [4, 0], "width": 1.8, "use": "entrance", "swing": "slide"},
            {"at": WAY_OUT, "width": 1.8, "use": "exit", "swing": "slide"},
        ],
        "demands": [
            {"category": "gondola", "count": 14},
            {"category": "wall_shelving", "count": 14},
            {"category": "checkout", "count": 4},
            {"category": "fridge_shelf", "count": 6},
            {"id": "bakery", "category": "counter", "count": 2, "place": "wall"},
            {"category": "litter_bin", "count": 2},
        ],
    }
    found = scenewright.solve(Brief.model_validate({"domain": "hall", "rooms": [room]}), seed=seed)
    tills = float(np.mean([off(piece) for piece in found.pieces if piece.category == "checkout"]))
    goods = [off(piece) for piece in found.pieces if piece.category in GOODS]
    assert scenewright.check(found).valid
    assert len(goods) == 34
    assert tills < 7.0
    assert min(goods) > tills
