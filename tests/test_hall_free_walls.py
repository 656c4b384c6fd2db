"""Walls that stand off the border of their zones, or free in a zone."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely
from benchmarks.hall_instances import example_hall

from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.hall.energy import make_state, prepare
from scenewright.domains.hall.hall_layout import Zone
from scenewright.domains.hall.solving import solve
from scenewright.domains.hall.terms.measure import passage
from scenewright.domains.hall.terms.place import build
from scenewright.domains.hall.terms.state import make_scratch
from scenewright.domains.hall.terms.whole import measure_frames, place_walls
from scenewright.domains.hall.walls.partitions import SPARE_WALL, short_of, standing_hosts


def gallery(count: int) -> Brief:
    """One room with ``count`` pictures, and a little furniture."""
    room = {
        "id": "room",
        "outline": [[0, 0], [12, 0], [12, 9], [0, 9]],
        "doors": [{"at": [6, 0], "width": 1.6, "swing": "out"}],
        "demands": [
            {"id": "pictures", "category": "wall_exhibit", "count": count, "size": [1.2, 0.4, 1.5]},
            {"id": "bench", "category": "bench", "count": 2},
        ],
    }
    head = {"format": "scenewright/brief", "version": 1, "domain": "hall"}
    return Brief.model_validate({**head, "rooms": [room]})


def test_a_free_wall_stands_in_the_middle_with_room_all_round() -> None:
    zone = Zone("z", "", "hall", np.array([[0, 0], [10, 0], [10, 6], [0, 6]], float))
    (host,) = standing_hosts((zone,), np.array([6.0]), 0.9)
    x0, y0, x1, y1, left, right = host.row
    assert (left, right) == (0.0, 0.0)
    assert (y0, y1) == pytest.approx((3.0, 3.0))
    assert min(x0, x1) == pytest.approx(0.9 + SPARE_WALL)
    assert max(x0, x1) == pytest.approx(10 - 0.9 - SPARE_WALL)
    assert host.span[1] - host.span[0] == pytest.approx(6.0 / 2 + SPARE_WALL)
    assert not standing_hosts((zone,), np.array([0.0]), 0.9)
    assert not standing_hosts((zone,), np.array([6.0]), 3.0)
    assert short_of((host,), np.array([20.0]))[0] < 20.0 - (host.most[1] - host.most[0])


def test_pictures_that_walls_cannot_take_hang_on_one_in_the_room() -> None:
    few, many = (solve(gallery(count), steps=6000) for count in (10, 24))
    assert not few.detail.layout.partitions
    for solution in (few, many):
        assert not solution.left_out
        assert not [f.message for f in check(solution).findings if not f.given]
    (wall,) = (p for p in many.pieces if p.id in many.detail.layout.partitions)
    room = shapely.Polygon(many.detail.layout.zones[0].outline)
    assert room.buffer(-0.8).contains(shapely.Point(wall.pose.x, wall.pose.y))
    close = [
        p
        for p in many.pieces
        if p.function == "pictures"
        and math.dist((p.pose.x, p.pose.y), (wall.pose.x, wall.pose.y)) < wall.size.width / 2 + 0.5
    ]
    assert close


def test_a_wall_off_its_border_leaves_the_passage_free() -> None:
    problem = example_hall()
    ground = problem.ground._replace(
        links=np.array([[0.0, 1.0, 2.4]]), host_shifts=np.array([[-4.0, 4.0]])
    )
    p = prepare(problem._replace(ground=ground))
    s, work = make_state(p), make_scratch(p)
    s.frames[:, 0] = -100.0
    s.clears[:] = s.frames
    s.partitions[0] = (1.0, 13.0)
    widths = []
    for off in (0.0, 1.0, -1.0, 3.0, -3.0):
        s.offsets[0] = off
        build(p, s, 0)
        measure_frames(p, s, work, False)
        widths.append(passage(p, s, work, 0))
    assert max(widths[:3]) < 2.4
    assert min(widths[3:]) > 10.0


def test_a_wall_off_its_border_keeps_to_its_zone() -> None:
    problem = example_hall()
    p = prepare(problem)
    s = make_state(p)
    s.partitions[0] = (2.0, 9.0)
    told = []
    for off in (0.0, 0.05, 2.0, -2.0, 11.98, 7.7):
        s.offsets[0] = off
        build(p, s, 0)
        told.append(place_walls(p, s))
    assert told == [True, False, True, True, False, False]
