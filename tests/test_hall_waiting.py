"""Chairs at walls, and seats to wait on."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import scenewright
from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.demands.holdings import collect_demands
from scenewright.domains.hall.retouch.waiting import AMONG_STAFF, RATE, _measure
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


def test_seats_wait_before_a_desk_not_where_its_staff_stands() -> None:
    desk = np.array([[0.0, 0.0, math.pi / 2, 3.0, 0.8]])
    seat = np.array([[0.0, 0.0, 0.0, 1.2, 0.4]])
    at = {
        point: _measure(desk, seat + np.array([*point, 0.0, 0.0, 0.0]))
        for point in ((0.0, 2.0), (0.0, -1.5), (3.0, 0.5), (0.0, 7.4), (20.0, 0.4))
    }
    assert at[0.0, 2.0] == 0.0
    assert at[0.0, -1.5] == at[3.0, 0.5] == AMONG_STAFF
    assert at[0.0, 7.4] == pytest.approx(3.0 * RATE)
    assert at[20.0, 0.4] == pytest.approx((18.5 - 4.0) * RATE)


@pytest.mark.parametrize("name", ["Chairs to wait", "Wartebank", "Banc d'attente"])
def test_seats_are_to_wait_on_by_their_name(name: str) -> None:
    bench = {"category": "bench", "name": name}
    asked = collect_demands(shop(bench, {"category": "bench"}, CHAIRS), 0, (), catalog_of([]))
    assert [is_to_wait_on(one) for one in asked] == [True, False, True]


@pytest.mark.parametrize("seed", [59, 61])
def test_a_bench_to_wait_on_has_its_back_at_a_wall_and_the_desk_before_it(seed: int) -> None:
    bench = {"id": "bench", "category": "bench", "name": "Waiting", "size": [1.4, 0.45, 0.45]}
    tables = {"category": "display_table", "count": 4, "size": [1.2, 0.8, 0.9]}
    found = scenewright.solve(shop(bench, COUNTER, tables), seed=seed, threads=1)
    (seat,), (desk,) = find(found, "bench"), find(found, "counter")
    x, y = seat.pose.x, seat.pose.y
    assert min(x, 10 - x, y, 7 - y) < 0.5 * seat.size.depth + 0.1
    front = math.cos(desk.pose.heading), math.sin(desk.pose.heading)
    assert (x - desk.pose.x) * front[0] + (y - desk.pose.y) * front[1] > 0.0
