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


@pytest.mark.parametrize("seed", [1])
def test_the_floor_before_the_lanes_is_free_to_queue_on(seed: int) -> None:
    room = {
        "name": "supermarket",
        "outline": [[0, 0], [16, 0], [16, 18], [0, 18]],
        "doors": [
            {"at": [4, 0], "width": 1.8, "use": "entrance", "swing": "slide"},
            {"at": [11, 0], "width": 1.8, "use": "exit", "swing": "slide"},
        ],
        "zones": [
            {"id": "front", "outline": [[0, 0], [16, 0], [16, 5], [0, 5]]},
            {"id": "goods", "outline": [[0, 5], [16, 5], [16, 18], [0, 18]]},
        ],
        "demands": [
            {"category": "gondola", "count": 32, "zone": "goods"},
            {"category": "checkout", "count": 4, "size": [2.2, 1.2, 1.3], "zone": "front"},
            {"category": "fridge_shelf", "count": 4, "zone": "goods"},
        ],
    }
    found = scenewright.solve(Brief.model_validate({"domain": "hall", "rooms": [room]}), seed=seed)
    assert scenewright.check(found).valid
    tills = [piece for piece in found.pieces if piece.category == "checkout"]
    end = max(piece.pose.y for piece in tills) + 1.1
    low, high = min(p.pose.x for p in tills) - 0.6, max(p.pose.x for p in tills) + 0.6
    goods = [p for p in found.pieces if p.category in GOODS and low < p.pose.x < high]
    near = [p.pose.y - 0.5 * abs(p.size.width * math.cos(p.pose.heading)) for p in goods]
    assert len(tills) == 4
    assert min(near) - end > 1.75
