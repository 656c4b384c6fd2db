"""What a curator or shopkeeper would miss: lanes of tills, speakers on the stage, seats round
tables, fans without a point, walls behind paintings."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely
from benchmarks.hall_measure import posed

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.patterns import FAN, NUMBER
from scenewright.domains.hall.patterns.fan import STAGE
from scenewright.domains.hall.solvers.chains import begin_chain
from scenewright.domains.hall.solvers.moves import reseed
from scenewright.engine.draws import streams

Told = dict[str, Any]


def hall(*demands: Told, **more: Any) -> Brief:
    room = {
        "id": "hall",
        "outline": [[0, 0], [14, 0], [14, 10], [0, 10]],
        "doors": [{"id": "in", "at": [7, 0], "width": 1.8, "swing": "out"}],
        "demands": list(demands),
    } | more
    told = {"format": "scenewright/brief", "version": 1, "domain": "hall", "rooms": [room]}
    return Brief.model_validate(told)


def answer(brief: Brief, seed: int = 0) -> Solution:
    return scenewright.solve(brief, seed=seed, steps=3000)


def of(solution: Solution, category: str) -> list[Piece]:
    return [piece for piece in solution.pieces if piece.category == category]


def test_tills_stand_side_by_side_with_lanes_that_lead_out() -> None:
    for seed in range(3):
        tills = of(answer(hall({"category": "checkout", "count": 3}), seed), "checkout")
        shapes = shapely.polygons(corners(np.array([_box(till) for till in tills])))
        apart = [a.distance(b) for k, a in enumerate(shapes) for b in shapes[k + 1 :]]
        assert min(apart) > 0.9
        for till in tills:
            way = np.array([7.0, 0.0]) - till.pose[:2]
            along = np.array([math.sin(till.pose.heading), -math.cos(till.pose.heading)])
            assert abs(along @ way) / np.hypot(*way) > 0.5


def _box(piece: Piece) -> tuple[float, ...]:
    return (*piece.pose[:2], piece.pose.heading, *piece.size[:2])


def test_the_lectern_stands_on_the_stage_and_looks_where_it_does() -> None:
    stage = {"category": "stage", "size": [6, 3, 0.6], "place": "wall"}
    found = answer(hall(stage, {"category": "lectern"}))
    (floor,), (desk,) = of(found, "stage"), of(found, "lectern")
    assert desk.on == floor.id
    assert desk.pose.z == pytest.approx(0.6)
    assert desk.pose.heading == pytest.approx(floor.pose.heading)
    ahead = (desk.pose.x - floor.pose.x) * math.cos(floor.pose.heading)
    ahead += (desk.pose.y - floor.pose.y) * math.sin(floor.pose.heading)
    assert 0.0 < ahead < 1.5
    assert scenewright.check(found).valid
    assert not found.left_out


def test_a_stage_too_small_to_speak_from_has_its_lectern_beside_it() -> None:
    stage = {"category": "stage", "size": [1.6, 1.3, 0.3], "place": "wall"}
    (desk,) = of(answer(hall(stage, {"category": "lectern"})), "lectern")
    assert desk.on is None


def test_lounge_seats_look_at_each_other_over_low_tables() -> None:
    found = answer(hall({"category": "lounge_seat", "count": 7}))
    seats, tables = of(found, "lounge_seat"), of(found, "coffee_table")
    assert scenewright.check(found).valid
    assert len(seats) == 7
    assert len(tables) == 2
    for seat in seats:
        far = [np.subtract(table.pose[:2], seat.pose[:2]) for table in tables]
        way = min(far, key=lambda step: float(np.hypot(*step)))
        front = math.cos(seat.pose.heading), math.sin(seat.pose.heading)
        assert np.hypot(*way) < 1.8
        assert way @ front / np.hypot(*way) > 0.8


@pytest.mark.parametrize("number", [20, 60, 140])
def test_the_first_row_of_a_fan_is_no_point(number: int) -> None:
    seats = {"category": "auditorium_seat", "count": number, "patterns": ["fan"]}
    large = [[0, 0], [30, 0], [30, 24], [0, 24]]
    ready = posed(hall(seats, outline=large)).fitted
    chain = begin_chain(ready.problem, ready.start, streams(0, 1)[0])
    for shape in (0.0, 0.5, 0.99):
        reseed(chain.p, chain.s, 0, FAN, shape, 1.0)
        assert chain.s.layers[0, NUMBER] >= min(4, number // 5)
        assert chain.p.near[0] >= STAGE


def test_what_is_to_stand_at_a_wall_is_reported_where_none_is() -> None:
    found = answer(hall({"category": "wall_exhibit", "count": 4}))
    assert scenewright.check(found).valid
    first = of(found, "wall_exhibit")[0]
    c, s = math.cos(first.pose.heading), math.sin(first.pose.heading)
    away = first.pose._replace(x=first.pose.x + 1.5 * c, y=first.pose.y + 1.5 * s)
    moved = tuple(replace(p, pose=away) if p.id == first.id else p for p in found.pieces)
    report = scenewright.check(replace(found, pieces=moved))
    assert ("no_wall", first.id) in {(f.kind, f.piece) for f in report.findings}
