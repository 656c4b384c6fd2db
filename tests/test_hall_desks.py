"""Desks look to visitors: into their zone and to the entrance."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.desks import SERVING


def welcome(found: Solution) -> list[float]:
    """Of each desk, the cosines of the angles to the middle of its zone and to the entrance."""
    assert found.detail is not None
    doors = [o for o in spaces(found.brief)[0].openings if o.kind != "window" and o.use != "exit"]
    zones = {zone.id: shapely.Polygon(zone.outline).centroid for zone in found.detail.layout.zones}
    zone_of = {name: group.zone for group in found.detail.layout.groups for name in group.objects}
    sums = []
    for desk in (piece for piece in found.pieces if piece.category in SERVING):
        middle = zones[zone_of[desk.id]]
        way = np.array([(middle.x, middle.y), (doors[0].x, doors[0].y)]) - desk.pose[:2]
        front = np.array([math.cos(desk.pose.heading), math.sin(desk.pose.heading)])
        sums.append(float((way @ front / np.hypot(*way.T)).sum()))
    return sums


@pytest.mark.parametrize("seed", [0, 1])
def test_the_desk_of_a_reading_room_looks_to_visitors(seed: int) -> None:
    found = scenewright.solve(scenewright.read("sample:hall-reading-room"), seed=seed)
    looks = welcome(found)
    assert len(looks) == 1
    assert looks[0] > 0.0
    assert scenewright.check(found).valid


@pytest.mark.parametrize("seed", [1, 2])
def test_serving_counters_stand_with_their_backs_at_the_wall_between_the_doors(seed: int) -> None:
    """Their free floor reaches into that of the doors: that is no reason to stand amid the hall."""
    box = [[0.0, 0.0], [26.0, 0.0], [26.0, 16.0], [0.0, 16.0]]
    serving = [[0.0, 0.0], [26.0, 0.0], [26.0, 5.5], [0.0, 5.5]]
    eating = [[0.0, 5.5], [26.0, 5.5], [26.0, 16.0], [0.0, 16.0]]
    room = {
        "name": "Canteen",
        "outline": box,
        "doors": [
            {"at": [4.0, 0.0], "width": 2.4, "use": "entrance"},
            {"at": [20.0, 0.0], "width": 2.4, "use": "exit"},
        ],
        "zones": [{"id": "serving", "outline": serving}, {"id": "eating", "outline": eating}],
        "demands": [
            {"category": "counter", "count": 6, "zone": "serving"},
            {"category": "checkout", "count": 2, "zone": "serving"},
            {"category": "dining_table", "count": 24, "zone": "eating"},
        ],
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    found = scenewright.solve(brief, seed=seed, threads=1)
    counters = [piece for piece in found.pieces if piece.category == "counter"]
    assert scenewright.check(found).valid
    assert len(counters) == 6
    walls = shapely.Polygon(box).exterior
    for piece in counters:
        ahead = np.array([math.cos(piece.pose.heading), math.sin(piece.pose.heading)])
        back = np.array(piece.pose[:2]) - 0.5 * piece.size.depth * ahead
        assert walls.distance(shapely.Point(back)) < 1.3
