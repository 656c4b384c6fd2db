"""Chairs at walls, and seats to wait on."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import pytest

import scenewright
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.demands.holdings import collect_demands
from scenewright.domains.hall.visit.visitor_plan import is_to_wait_on

CHAIRS: dict[str, Any] = {"id": "chairs", "category": "dining_chair", "count": 4, "place": "wall"}
COUNTER: dict[str, Any] = {"id": "counter", "category": "counter", "size": [4.0, 0.7, 1.0]}


def shop(*demands: dict[str, Any]) -> Brief:
    room = {
        "name": "Shop",
        "outline": [[0, 0], [10, 0], [10, 7], [0, 7]],
        "doors": [{"id": "way in", "at": [2, 0], "width": 1.6, "swing": "slide"}],
        "zones": [],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Shop", "rooms": [room]})


def find(solution: Solution, function: str) -> list[Piece]:
    return [piece for piece in solution.pieces if piece.function == function]


@pytest.mark.parametrize("seed", [59, 61, 67])
def test_chairs_at_a_wall_stand_in_one_row_and_are_reached_from_the_front(seed: int) -> None:
    gondolas = {"category": "gondola", "count": 4}
    found = scenewright.solve(shop(CHAIRS, COUNTER, gondolas), seed=seed, threads=1)
    chairs = find(found, "chairs")
    assert len(chairs) == 4
    assert not found.left_out
    assert scenewright.check(found).valid
    steps = [math.dist(a.pose[:2], b.pose[:2]) for a, b in pairwise(chairs)]
    assert max(steps) < chairs[0].size.width + 0.1
    assert len({round(chair.pose.heading, 3) for chair in chairs}) == 1


@pytest.mark.parametrize("name", ["Chairs to wait", "Wartebank", "Banc d'attente"])
def test_seats_are_to_wait_on_by_their_name(name: str) -> None:
    bench = {"category": "bench", "name": name}
    asked = collect_demands(shop(bench, {"category": "bench"}, CHAIRS), 0, (), catalog_of([]))
    assert [is_to_wait_on(one) for one in asked] == [True, False, True]
