"""Gates close the way in, ropes stand before the desk they serve, seats before their stage."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains.hall.gates.rails import (
    RowOfGates,
    find_stops,
    find_way_in,
    lay_rails,
    reach,
)
from scenewright.domains.hall.retouch.audience import measure_audience as sits_aside
from scenewright.domains.hall.retouch.gates import find_gates, list_steps
from scenewright.domains.hall.retouch.lines import line_up
from scenewright.domains.hall.retouch.ropes import Anchor, forms_lane, measure_before
from scenewright.domains.hall.retouch.tills import measure_tills
from scenewright.domains.hall.solving import problems


def _solve(demands: list[dict[str, Any]], size: tuple[float, float], at: float) -> Any:
    room = {
        "id": "hall",
        "name": "Hall",
        "outline": [[0, 0], [size[0], 0], list(size), [0, size[1]]],
        "height": 4.0,
        "doors": [{"id": "in", "at": [at, 0], "width": 1.8, "swing": "slide"}],
        "demands": demands,
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    return scenewright.solve(brief, seed=1, threads=1)


def _problems(demands: list[dict[str, Any]]) -> Any:
    room = {
        "name": "Hall",
        "outline": [[0, 0], [14, 0], [14, 11], [0, 11]],
        "doors": [{"id": "in", "at": [7, 0], "width": 1.8, "swing": "slide"}],
        "demands": demands,
    }
    return problems(Brief.model_validate({"domain": "hall", "rooms": [room]}))


def test_a_ray_ends_at_the_first_edge() -> None:
    edges = np.array([[0.0, 0, 4, 0], [4, 0, 4, 3], [4, 3, 0, 3], [0, 3, 0, 0]])
    assert reach(edges, np.array([1.0, 1.0]), np.array([1.0, 0.0])) == pytest.approx(3.0)
    assert reach(edges, np.array([1.0, 1.0]), np.array([0.0, -1.0])) == pytest.approx(1.0)


def test_barriers_run_from_gates_to_the_wall_of_their_door() -> None:
    demands = [
        {"id": "gates", "category": "ticket_gate", "count": 3},
        {"category": "showcase", "count": 6},
    ]
    solution = _solve(demands, (14, 11), 7)
    gates = [p for p in solution.pieces if p.function == "gates"]
    rails = [p for p in solution.pieces if p.function == "gates/barriers"]
    assert scenewright.check(solution).valid
    assert len(gates) == 3
    ends = [p.pose.y - 0.5 * p.size.width for p in rails if abs(math.sin(p.pose.heading)) < 0.1]
    assert sum(end < 0.05 for end in ends) == 2
    low, high = min(p.pose.x for p in rails), max(p.pose.x for p in rails)
    assert low < 7 - 0.9
    assert high > 7 + 0.9
    for piece in solution.pieces:
        inside = low < piece.pose.x < high and piece.pose.y < min(p.pose.y for p in gates) - 0.7
        assert piece in rails or not inside


def test_no_rail_runs_back_to_what_stands_right_behind_its_end() -> None:
    """A desk touches the end of a row of gates: between them no rail has a length."""
    demands = [{"category": "ticket_gate", "count": 2}, {"category": "showcase", "count": 2}]
    door = {"id": "in", "at": [7, 0], "width": 1.8, "swing": "slide"}
    outline = [[0, 0], [14, 0], [14, 11], [0, 11]]
    room = {"outline": outline, "doors": [door], "demands": demands}
    (one,) = problems(Brief.model_validate({"domain": "hall", "rooms": [room]}))
    way_in = find_way_in(one.problem, 0)
    row = np.array([7.0, 3.0, -0.5 * np.pi, 2.0, 1.2])
    desks = np.array([[x, 2.0, 0.0, 1.99, 3.0] for x in (4.0, 10.0)])
    for side in (-1, 1):
        gates = RowOfGates(row, way_in, desks, desks)
        rails = lay_rails(find_stops(one.problem, gates), gates, side)
        assert (rails[:, 3] > 0.1).all()


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_gates_leave_open_no_more_than_a_wide_gate(seed: int) -> None:
    """From wall to wall behind the door nothing is open but the lane of a wheelchair, 1.1 m, and
    slits nobody gets through."""
    demands = [
        {"id": "gates", "category": "ticket_gate", "count": 3},
        {"category": "showcase", "count": 6},
    ]
    room = {
        "name": "Hall",
        "outline": [[0, 0], [14, 0], [14, 11], [0, 11]],
        "doors": [{"id": "in", "at": [7, 0], "width": 1.8, "swing": "slide"}],
        "demands": demands,
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    found = scenewright.solve(brief, seed=seed, steps=3000, threads=1)
    assert scenewright.check(found).valid
    row = [p for p in found.pieces if p.function.startswith("gates")]
    (leaf,) = (p for p in row if p.category == "gate_leaf")
    bodies = shapely.union_all(polygons_of([p for p in row if p is not leaf]))
    line = np.mean([p.pose.y for p in row if p.function == "gates"])
    wings = [p for p in row if p.category == "glass_barrier" and p.pose.y < line - 0.7]
    across = shapely.LineString(
        [[min(p.pose.x for p in wings), line], [max(p.pose.x for p in wings), line]]
    )
    gaps = [part.length for part in shapely.get_parts(across.difference(bodies.buffer(0.02)))]
    assert sum(gap > 0.5 for gap in gaps) == 1
    assert 0.9 < max(gaps) < 1.2
    assert leaf.size.width == pytest.approx(max(gaps), abs=0.1)


def test_gates_that_close_nothing_are_left_out_by_name() -> None:
    demands = [
        {"id": "gates", "category": "ticket_gate", "count": 2},
        {"category": "stage", "size": [6, 3, 0.6], "place": "wall"},
        {"id": "seats", "category": "auditorium_seat", "count": 96, "patterns": ["chain"]},
    ]
    solution = _solve(demands, (10, 14), 5)
    gates = [p for p in solution.pieces if p.function == "gates"]
    barriers = [p for p in solution.pieces if p.function == "gates/barriers"]
    told = [left.what for left in solution.left_out if "gate" in left.what]
    assert bool(gates) == bool(barriers)
    assert bool(gates) != bool(told)


def test_ropes_stand_in_lines_before_the_counters() -> None:
    demands = [
        {"id": "counters", "category": "counter", "count": 3},
        {"id": "ropes", "category": "rope_barrier", "count": 4},
        {"category": "wall_exhibit", "count": 4},
    ]
    pieces = _solve(demands, (14, 10), 3).pieces
    counters = [p for p in pieces if p.function == "counters"]
    ropes = [p for p in pieces if p.function == "ropes"]
    heading = counters[0].pose.heading
    front = np.array([math.cos(heading), math.sin(heading)])
    middle = np.mean([p.pose[:2] for p in counters], axis=0)
    off = np.array([p.pose[:2] for p in ropes]) - middle
    assert (off @ front > 0.5).all()
    assert (off @ front < 5.5).all()
    assert np.abs(off @ (front[1], -front[0])).max() < 3.5


def test_seats_beside_their_stage_are_at_fault() -> None:
    stage = np.array([0.0, 0.0, math.pi / 2, 6.0, 3.0])
    rows = np.array([(x, y, -math.pi / 2, 0.5, 0.5) for y in (4, 5) for x in range(-3, 4)], float)
    assert sits_aside(rows, stage, -math.pi / 2) == pytest.approx(0.0)
    assert sits_aside(rows + np.array([6.0, 0, 0, 0, 0]), stage, -math.pi / 2) > 2.0
    assert sits_aside(rows - np.array([0, 4.5, 0, 0, 0]), stage, -math.pi / 2) > 2.0
    assert sits_aside(rows, stage, math.pi / 2) > 3.0


def test_pews_stand_on_the_axis_of_the_altar() -> None:
    demands = [
        {"id": "altar", "category": "stage", "size": [6, 3, 0.3]},
        {
            "id": "pews",
            "category": "bench",
            "count": 24,
            "size": [4, 0.6, 0.9],
            "patterns": ["chain"],
            "facing": "altar",
        },
    ]
    pieces = _solve(demands, (14, 26), 7).pieces
    (altar,) = [p for p in pieces if p.function == "altar"]
    pews = np.array([p.pose[:2] for p in pieces if p.function == "pews"])
    heading = altar.pose.heading
    front = np.array([math.cos(heading), math.sin(heading)])
    off = pews - altar.pose[:2]
    assert (off @ front > 1.5).all()
    assert abs((off @ (front[1], -front[0])).mean()) < 1.0


def test_ropes_with_no_room_before_their_counter_are_left_out_by_name() -> None:
    demands = [
        {"id": "counters", "category": "counter", "count": 3},
        {"id": "ropes", "category": "rope_barrier", "count": 16},
        {"category": "showcase", "count": 8},
    ]
    solution = _solve(demands, (9, 7), 3)
    standing = [p for p in solution.pieces if p.function == "ropes"]
    told = [left for left in solution.left_out if "rope" in left.what]
    gone = sum(int(left.what.split(" of ")[0]) for left in told)
    assert gone > 0
    assert len(standing) + gone == 16
    assert all("before what they guide" in left.reason for left in told)


def _bank(seed: int, **more: Any) -> Any:
    """Counters in a hall too narrow for two lines of ropes before them."""
    room = {
        "name": "Counters",
        "outline": [[0, 0], [3.5, 0], [3.5, 10], [0, 10]],
        "doors": [{"id": "in", "at": [0.9, 0], "width": 1.2, "swing": "slide"}],
        "demands": [
            {"category": "counter", "count": 3, "size": [1.6, 0.7, 1.1], "place": "wall"},
            {"id": "ropes", "category": "rope_barrier", "count": 2, **more},
        ],
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    return scenewright.solve(brief, seed=seed, threads=1)


@pytest.mark.parametrize("seed", [59, 61, 67])
def test_ropes_that_may_be_left_out_form_a_lane_or_are_left_out_by_name(seed: int) -> None:
    found = _bank(seed, required=False)
    groups = [g for g in found.detail.layout.groups if g.demand == "ropes"]
    lines = [len(part.layers) for group in groups for part in group.parts]
    told = [left.reason for left in found.left_out if "rope" in left.what]
    assert all(count > 1 for count in lines)
    assert bool(told) != bool(lines)
    assert scenewright.check(found).valid


def test_ropes_that_must_stand_do_so_in_one_line_too() -> None:
    found = _bank(61)
    assert sum(piece.function == "ropes" for piece in found.pieces) == 2
    assert not found.left_out


def test_one_line_of_ropes_is_no_lane() -> None:
    demands = [{"category": "counter", "count": 3}, {"category": "rope_barrier", "count": 4}]
    outline = [[0, 0], [14, 0], [14, 11], [0, 11]]
    room = {"outline": outline, "doors": [{"at": [7, 0], "width": 1.8}], "demands": demands}
    (one,) = problems(Brief.model_validate({"domain": "hall", "rooms": [room]}))
    unit = next(k for k, name in enumerate(one.problem.names) if "rope" in name)
    pose, boxes = (3.0, 5.0, 0.0), np.zeros((int(one.problem.units.spans.max()), 5))
    for lines, lane in ((1, False), (2, True)):
        kept = line_up(one.problem, one.start, unit, pose, lines, 1.0)
        assert forms_lane(one.problem, kept, boxes, unit) == lane


@pytest.mark.parametrize("seed", [0, 1])
def test_every_door_people_come_in_by_has_gates(seed: int) -> None:
    """Three street doors of a lobby and six gates: two before each, none walks in past them."""
    doors = [
        {"id": f"street {k}", "at": [x, 0], "width": 1.8, "swing": "slide"}
        for k, x in enumerate((5, 14, 23))
    ]
    zones = [
        {"id": "lobby", "outline": [[0, 0], [28, 0], [28, 7], [0, 7]]},
        {"id": "foyer", "outline": [[0, 7], [28, 7], [28, 16], [0, 16]]},
    ]
    demands = [
        {"id": "gates", "category": "ticket_gate", "count": 6, "zone": "lobby"},
        {"category": "bench", "count": 6, "zone": "foyer"},
    ]
    outline = [[0, 0], [28, 0], [28, 16], [0, 16]]
    room = {"name": "Hall", "outline": outline, "doors": doors, "zones": zones, "demands": demands}
    found = scenewright.solve(
        Brief.model_validate({"domain": "hall", "rooms": [room]}), seed=seed, steps=3000
    )
    assert scenewright.check(found).valid
    assert not found.left_out
    gates = np.array([p.pose[:2] for p in found.pieces if p.function == "gates"])
    for door in doors:
        near = np.abs(gates[:, 0] - door["at"][0]) < 3.0
        assert near.sum() == 2
        assert (gates[near, 1] < 5.0).all()


def test_ropes_go_before_the_longest_row_of_desks_of_their_zone() -> None:
    """Tellers and a reception in one room: people queue for the tellers."""
    demands = [
        {"id": "tellers", "category": "counter", "count": 4},
        {"id": "reception", "category": "info_desk"},
        {"id": "ropes", "category": "rope_barrier", "count": 4},
    ]
    pieces = _solve(demands, (16, 11), 3).pieces
    tellers = [p for p in pieces if p.function == "tellers"]
    heading = tellers[0].pose.heading
    front = np.array([math.cos(heading), math.sin(heading)])
    middle = np.mean([p.pose[:2] for p in tellers], axis=0)
    off = np.array([p.pose[:2] for p in pieces if p.function == "ropes"]) - middle
    assert len(off) == 4
    assert (off @ front > 0.9).all()
    assert np.abs(off @ (front[1], -front[0])).max() < 4.5


def test_lanes_of_tills_lead_to_the_way_out() -> None:
    demands = [
        {"id": "tills", "category": "checkout", "count": 4},
        {"category": "gondola", "count": 24},
        {"category": "wall_shelving", "count": 10},
    ]
    solution = _solve(demands, (22, 16), 5)
    tills = np.array(
        [(*p.pose[:2], p.pose.heading) for p in solution.pieces if p.function == "tills"]
    )
    assert scenewright.check(solution).valid
    assert len(tills) == 4
    assert np.allclose(np.abs(np.cos(tills[:, 2])), 1.0, atol=1e-3)
    assert math.hypot(*(tills[:, :2].mean(0) - (5.0, 0.0))) < 9.0


def test_tills_along_the_flow_or_on_the_way_in_are_at_fault() -> None:
    demands = [{"id": "tills", "category": "checkout", "count": 3}, {"category": "gondola"}]
    room = {
        "id": "hall",
        "name": "Hall",
        "outline": [[0, 0], [20, 0], [20, 16], [0, 16]],
        "doors": [{"id": "in", "at": [4, 0], "width": 1.8, "swing": "slide"}],
        "demands": demands,
    }
    brief = Brief.model_validate({"domain": "hall", "rooms": [room]})
    (started,) = problems(brief)
    tills = np.array([(x, 3.5, 0.0, 2.4, 1.2) for x in (7.0, 9.4, 11.8)])
    clear = measure_tills(started.problem, tills)
    for fault, change in (
        (2.0, np.array([0.0, 0.0, 0.5 * math.pi, 0.0, 0.0])),
        (2.0, np.array([-3.0, 0.0, 0.0, 0.0, 0.0])),
    ):
        assert measure_tills(started.problem, tills + change) > clear + fault


def test_where_not_all_ropes_find_room_fewer_stand_before_their_desk() -> None:
    demands = [{"category": "counter"}, {"category": "rope_barrier", "count": 6}]
    solution = _solve(demands, (7, 5), 2)
    (desk,) = (p for p in solution.pieces if p.category == "counter")
    ropes = [p for p in solution.pieces if p.category == "rope_barrier"]
    assert scenewright.check(solution).valid
    assert 2 <= len(ropes) < 6
    assert [out.what for out in solution.left_out] == [f"{6 - len(ropes)} of 6 rope barrier"]
    front = np.array([math.cos(desk.pose.heading), math.sin(desk.pose.heading)])
    ahead = [(np.array(p.pose[:2]) - desk.pose[:2]) @ front for p in ropes]
    assert min(ahead) > 0.5 * desk.size.depth + 0.6


def test_ropes_in_several_lines_before_an_exhibit_guard_nothing_more_than_one() -> None:
    whale = Anchor(np.array([0.0, 0.0, 0.0, 12.0, 3.0]), queue=False)
    line = np.array([(2.7, y, 0.0, 1.5, 0.3) for y in (-1.5, 0.0, 1.5)])
    lines = np.concatenate([line, line + np.array([1.5, 0, 0, 0, 0])])
    assert measure_before(line, whale) == pytest.approx(0.0)
    assert measure_before(lines, whale) > 1.0


def test_rows_of_gates_before_one_door_step_back_from_one_line() -> None:
    """Each row is held against those before it; rows far apart along the way are two lines."""
    row = {"category": "ticket_gate", "count": 2}
    ((problem, start),) = _problems([row | {"id": "first"}, row | {"id": "second"}])
    boxes = np.array([[x, 3.0, -0.5 * math.pi, 0.95, 1.4] for x in (5.0, 6.0, 8.0, 9.0)])
    units = find_gates(problem, start)
    assert list_steps(problem, boxes, 1, units) == [pytest.approx(0.0)]
    boxes[2:, 1] = 3.4
    assert list_steps(problem, boxes, 1, units) == [pytest.approx(-0.4)]
    assert list_steps(problem, boxes, 0, units) == []
    boxes[2:, 1] = 5.0
    assert list_steps(problem, boxes, 1, units) == []
