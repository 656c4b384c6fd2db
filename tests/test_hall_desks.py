"""Desks look to visitors: into their zone and to the entrance."""

from __future__ import annotations

import math

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.building.plan import spaces
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
