"""Desks look to visitors: into their zone and to the entrance."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.building.plan import spaces
from scenewright.core.brief import Brief
from scenewright.core.solution import Solution
from scenewright.domains.hall.classes import SERVING
from scenewright.domains.hall.retouch.desk_groups import find_desks, first_desks
from scenewright.domains.hall.retouch.desks import desks_adrift, propose_desks
from scenewright.domains.hall.retouch.places import find_axes
from scenewright.domains.hall.rules.serving import SAT
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solving import problems
from scenewright.engine.draws import streams


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
    """Their free floor reaches into that of the doors: that is no reason to stand free in the
    hall."""
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


def bank(*more: dict[str, Any]) -> Brief:
    """A lobby and, beyond it, a waiting zone with a desk."""
    room = {
        "name": "Bank",
        "outline": [[0, 0], [18, 0], [18, 8], [0, 8]],
        "doors": [{"at": [0, 4], "width": 1.8}],
        "zones": [
            {"id": "lobby", "outline": [[0, 0], [6, 0], [6, 8], [0, 8]]},
            {"id": "waiting", "outline": [[6, 0], [18, 0], [18, 8], [6, 8]]},
        ],
        "demands": [
            {"category": "cash_machine", "count": 3, "zone": "lobby"},
            {"id": "desk", "category": "info_desk", "zone": "waiting"},
            {"category": "lounge_seat", "count": 8, "zone": "waiting"},
            *more,
        ],
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


def test_a_desk_to_ask_at_is_first_where_none_is_in_the_zone_of_the_entrance() -> None:
    nearer = {"id": "nearer", "category": "info_desk", "zone": "lobby"}
    bar = {"id": "bar", "category": "counter", "zone": "waiting"}
    for more, name in ([], "desk"), ([nearer], "nearer"), ([bar], "desk"):
        (one,) = problems(bank(*more))
        first = find_desks(first_desks(one.problem), one.start)
        assert [one.problem.names[unit].split("/")[-1] for unit in first] == [name]


def test_a_reception_with_its_back_to_the_door_is_turned_where_there_is_room() -> None:
    (one,) = problems(bank())
    unit = next(k for k, name in enumerate(one.problem.names) if name.endswith("desk"))
    pose = one.start.pose.copy()
    pose[unit, :3] = 14.0, 4.0, 0.0
    chain = begin_chain(one.problem, one.start._replace(pose=pose), streams(0, 1)[0])
    layout, desks = layout_of(chain), first_desks(one.problem)
    before = desks_adrift(desks, layout.kept, layout.boxes)
    (desk,) = layout.boxes[slice(*one.problem.units.spans[unit])]
    assert before > 6.0
    poses = [kept.pose[unit] for kept in propose_desks(desks, layout.kept, layout.boxes)]
    assert any(x < 9.0 and abs(math.cos(turn) + 1.0) < 1e-6 for x, _, turn, _ in poses)
    assert desk[0] == 14.0


@pytest.mark.parametrize("seed", [59, 61])
def test_a_reception_in_another_zone_looks_to_the_door(seed: int) -> None:
    found = scenewright.solve(bank(), seed=seed, threads=1)
    (desk,) = (piece for piece in found.pieces if piece.function == "desk")
    way = np.array([0.0, 4.0]) - desk.pose[:2]
    front = math.cos(desk.pose.heading), math.sin(desk.pose.heading)
    assert way @ front > -0.3 * math.hypot(*way)
    assert scenewright.check(found).valid


@pytest.mark.parametrize("seed", [1, 5])
def test_no_lounge_lies_on_the_side_of_those_who_serve(seed: int) -> None:
    room = {
        "name": "Bank",
        "outline": [[0, 0], [16, 0], [16, 9], [11, 9], [11, 12], [0, 12]],
        "doors": [
            {"id": "in", "at": [3, 0], "width": 2.0, "swing": "slide"},
            {"at": [0, 11], "width": 0.9, "use": "exit"},
        ],
        "zones": [
            {"id": "foyer", "area": 32, "door": "in"},
            {"id": "hall", "beside": ["foyer", "advice"]},
            {"id": "advice", "area": 60},
        ],
        "demands": [
            {"category": "info_desk", "zone": "hall"},
            {"category": "counter", "count": 3, "zone": "hall", "size": [1.8, 0.8, 1.1]},
            {"category": "rope_barrier", "count": 4, "zone": "hall", "required": False},
            {"category": "lounge_seat", "count": 6, "zone": "hall"},
            {"category": "desk", "count": 4, "zone": "advice"},
        ],
    }
    found = scenewright.solve(
        Brief.model_validate({"domain": "hall", "rooms": [room]}), seed=seed, threads=1
    )
    counters = [piece for piece in found.pieces if piece.category == "counter"]
    seats = [piece for piece in found.pieces if piece.category == "lounge_seat"]
    assert (len(counters), len(seats)) == (3, 6)
    desks = np.array([(*c.pose[:2], c.pose.heading, *c.size[:2]) for c in counters])
    places = np.array([(*s.pose[:2], s.pose.heading, *s.size[:2]) for s in seats])
    for x, y, heading, wide, deep in desks:
        right, ahead = find_axes(heading) @ (places[:, :2] - (x, y)).T
        behind = (ahead < 0.0) & (ahead > -0.5 * deep - SAT) & (np.abs(right) < 0.5 * wide)
        assert not behind.any()
