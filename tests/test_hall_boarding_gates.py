"""Gates in a zone that people only leave by stand in a row before its exit."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.solution import Solution

GATES: dict[str, Any] = {"id": "gates", "category": "ticket_gate", "count": 2, "zone": "gate"}
SEATS: dict[str, Any] = {"category": "bench", "count": 8, "zone": "gate", "size": [2, 0.5, 0.45]}


def lounge(*demands: dict[str, Any], use: str = "exit") -> Brief:
    room = {
        "name": "Lounge",
        "outline": [[0, 0], [18, 0], [18, 12], [0, 12]],
        "doors": [
            {"id": "way in", "at": [14, 0], "width": 3.0, "use": "entrance"},
            {"id": "gate", "at": [4, 12], "width": 2.0, "swing": "slide", "use": use},
        ],
        "zones": [
            {"id": "gate", "outline": [[0, 0], [9, 0], [9, 12], [0, 12]]},
            {"id": "shop", "outline": [[9, 0], [18, 0], [18, 12], [9, 12]]},
        ],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Lounge", "rooms": [room]})


def find_gates(found: Solution) -> list[tuple[float, float]]:
    return [(p.pose.x, p.pose.y) for p in found.pieces if p.function == "gates"]


@pytest.mark.parametrize("seed", [59, 61])
def test_boarding_gates_stand_side_by_side_before_the_exit(seed: int) -> None:
    found = scenewright.solve(lounge(GATES, SEATS), seed=seed, threads=1)
    (x0, y0), (x1, y1) = find_gates(found)
    assert y0 == pytest.approx(y1)
    assert 9.0 < y0 < 11.0
    assert 0.5 * (x0 + x1) == pytest.approx(4.0, abs=0.01)
    assert not found.left_out
    assert scenewright.check(found).valid
    group = next(g for g in found.detail.layout.groups if g.demand == "gates")
    assert group.zone == "gate"
    assert {p.id for p in found.pieces if p.function == "gates"} <= set(group.objects)


def test_boarding_gates_are_fenced_back_to_the_wall_of_the_exit() -> None:
    """But for the wide gate with its post: nobody walks round them to the door."""
    found = scenewright.solve(lounge(GATES, SEATS), seed=59, threads=1)
    fence = [p for p in found.pieces if p.function == "gates/barriers"]
    assert Counter(p.category for p in fence) == {
        "glass_barrier": 3,
        "gate_post": 1,
        "gate_leaf": 1,
    }
    (leaf,) = (p for p in fence if p.category == "gate_leaf")
    solid = [p for p in found.pieces if (p in fence or p.function == "gates") and p is not leaf]
    low, high = min(p.pose.x for p in solid), max(p.pose.x for p in solid)
    taken = shapely.union_all(polygons_of(solid))
    reach = [x for x in np.linspace(low, high, 200) if not taken.intersects(_line(x))]
    assert 0.8 < (high - low) * len(reach) / 200 < 1.3
    assert leaf.size.width == pytest.approx((high - low) * len(reach) / 200, abs=0.15)
    assert scenewright.check(found).valid


def _line(x: float) -> shapely.LineString:
    return shapely.LineString([(x, 9.0), (x, 10.69)])


def test_gates_where_people_come_in_are_not_boarding_gates() -> None:
    found = scenewright.solve(lounge(GATES, SEATS, use="both"), seed=59, threads=1)
    named = {p.category for p in found.pieces if p.function.startswith("gates")}
    assert named <= {"ticket_gate", "glass_barrier", "gate_post", "gate_leaf"}
    assert "glass_barrier" in named or found.left_out


def test_locked_boarding_gates_stay_where_they_are(tmp_path: Path) -> None:
    found, path = scenewright.solve(lounge(GATES, SEATS), seed=59, threads=1), tmp_path / "a.json"
    scenewright.write(found, path)
    document = json.loads(path.read_text())
    for piece in document["pieces"]:
        piece["fixed"] = piece["function"] == "gates"
    path.write_text(json.dumps(document))
    again = scenewright.solve(scenewright.read(path), seed=61, threads=1)
    assert find_gates(again) == find_gates(found)


def test_gates_that_find_no_room_say_what_to_do() -> None:
    full = {"category": "counter", "size": [2.2, 2.2, 1.0], "count": 6, "zone": "gate"}
    found = scenewright.solve(lounge(GATES | {"count": 9}, full, use="both"), seed=59, threads=1)
    told = [lost.reason for lost in found.left_out if "close the way in" in lost.reason]
    assert all("draw a zone at the entrance" in reason for reason in told)


@pytest.mark.parametrize("seed", [3, 4])
def test_cash_machines_stand_at_a_wall_beside_the_way_in(seed: int) -> None:
    machines = {"category": "cash_machine", "count": 3}
    desks = {"category": "counter", "count": 3}
    found = scenewright.solve(lounge(machines, desks, use="both"), seed=seed, threads=1)
    mine = [p for p in found.pieces if p.category == "cash_machine"]
    assert len(mine) == 3
    near = shapely.LineString([(12.5, 0.0), (15.5, 0.0)])  # the wider of the doors
    assert all(0.5 <= shape.distance(near) < 4.0 for shape in polygons_of(mine))
    assert scenewright.check(found).valid
