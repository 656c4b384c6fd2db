"""Chairs at walls, seats to wait on, and what stands under windows."""

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
from scenewright.domains.hall.holdings import collect_demands
from scenewright.domains.hall.retouch.mending import weigh_layout
from scenewright.domains.hall.retouch.waiting import RATE, STAFF, _measure
from scenewright.domains.hall.solvers.chains import begin_chain
from scenewright.domains.hall.solving import problems
from scenewright.domains.hall.visitor_plan import is_to_wait_on
from scenewright.engine.draws import streams

CHAIRS: dict[str, Any] = {"id": "chairs", "category": "dining_chair", "count": 4, "place": "wall"}
COUNTER: dict[str, Any] = {"id": "counter", "category": "counter", "size": [4.0, 0.7, 1.0]}


def shop(*demands: dict[str, Any], windows: list[dict[str, Any]] | None = None) -> Brief:
    room = {
        "name": "Shop",
        "outline": [[0, 0], [10, 0], [10, 7], [0, 7]],
        "doors": [{"id": "way in", "at": [2, 0], "width": 1.6, "swing": "slide"}],
        "windows": windows or [],
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


@pytest.mark.parametrize(("sill", "height", "may"), [(1.2, 1.0, True), (0.6, 1.0, False)])
def test_what_is_lower_than_a_sill_may_stand_under_the_window(
    sill: float, height: float, may: bool
) -> None:
    window = {"at": [5, 7], "width": 4.0, "sill": sill, "height": 1.0}
    counter = COUNTER | {"size": [3.0, 0.6, height]}
    ((problem, start),) = problems(shop(counter, windows=[window]))
    pose = start.pose.copy()
    pose[0] = 5.0, 6.68, -0.5 * math.pi, 0.0
    chain = begin_chain(problem, start, streams(0, 1)[0])
    energy = weigh_layout(chain, [], start._replace(pose=pose)).cost
    assert np.isfinite(energy) == may


def test_seats_wait_before_a_desk_not_where_its_staff_stands() -> None:
    desk = np.array([[0.0, 0.0, math.pi / 2, 3.0, 0.8]])
    seat = np.array([[0.0, 0.0, 0.0, 1.2, 0.4]])
    at = {
        point: _measure(desk, seat + np.array([*point, 0.0, 0.0, 0.0]))
        for point in ((0.0, 2.0), (0.0, -1.5), (3.0, 0.5), (0.0, 7.4), (20.0, 0.4))
    }
    assert at[0.0, 2.0] == 0.0
    assert at[0.0, -1.5] == at[3.0, 0.5] == STAFF
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
