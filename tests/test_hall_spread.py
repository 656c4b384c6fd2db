"""Groups packed in a part of their zone spread over it; long rows get an aisle; fronts show."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

import scenewright
from hall_chains import posed
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.solution import Solution
from scenewright.domains.hall import compose
from scenewright.domains.hall.patterns import RADIATION
from scenewright.domains.hall.retouch import retouch_layout
from scenewright.domains.hall.retouch.columns import find_columns
from scenewright.domains.hall.retouch.spread import measure_spread, propose_spread
from scenewright.domains.hall.retouch.weigh_rows import look_rows, measure_rows
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import StartedHall
from scenewright.domains.hall.solving import problems
from scenewright.engine.draws import streams


def one_room(wide: float, deep: float, *demands: dict[str, Any]) -> Brief:
    room = {
        "name": "Hall",
        "height": 4.0,
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "doors": [{"at": [2, 0], "width": 1.8}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "rooms": [room]})


@pytest.fixture(scope="module")
def started() -> StartedHall:
    cases = {"category": "showcase", "count": 12, "patterns": ["grid"]}
    (found,) = problems(one_room(20, 14, cases))
    return found


def rows(left: float, step: float) -> np.ndarray:
    """Twelve showcases in three rows from ``left`` on, ``step`` metres apart."""
    return np.array(
        [(left + step * k, 3.0 + 4.0 * j, 0.0, 1.2, 0.6) for j in range(3) for k in range(4)]
    )


def test_strips_beside_a_group_count_where_they_are_wider_than_its_gaps(
    started: StartedHall,
) -> None:
    columns = find_columns(started.problem)
    pose = started.start.pose.copy()
    pose[:, 2] = 0.0
    kept = started.start._replace(pose=pose)
    assert measure_spread(columns, kept, rows(2.0, 2.0)) == pytest.approx(5.0 + 3.0)
    assert measure_spread(columns, kept, rows(6.0, 2.0)) == pytest.approx(3.1 + 1.1 + 5.0 + 3.0)
    assert measure_spread(columns, kept, rows(2.5, 5.0)) == 0.0


def test_turned_groups_and_those_at_walls_are_left_alone(started: StartedHall) -> None:
    columns, pose = find_columns(started.problem), started.start.pose.copy()
    pose[:, 2] = 0.4
    kept = started.start._replace(pose=pose)
    assert measure_spread(columns, kept, rows(2.0, 2.0)) == 0.0
    assert not list(propose_spread(columns, kept, rows(2.0, 2.0)))


def middles(solution: Solution, category: str) -> np.ndarray:
    return np.array([p.pose[:2] for p in solution.pieces if p.category == category])


def measure_strips(solution: Solution) -> float:
    """The widest strip along the hall beside its tables."""
    at = middles(solution, "display_table")[:, 0]
    return float(max(at.min(), 22.0 - at.max()))


def test_tables_take_the_length_of_their_hall(monkeypatch: pytest.MonkeyPatch) -> None:
    brief = one_room(22, 9, {"category": "display_table", "count": 8, "patterns": ["grid"]})
    found = [scenewright.solve(brief, seed=seed, steps=2000, threads=1) for seed in range(4)]
    assert all(scenewright.check(one).valid for one in found)
    with monkeypatch.context() as patch:
        patch.setattr(compose, "retouch_layout", lambda *given: given[1])
        before = [scenewright.solve(brief, seed=seed, steps=2000, threads=1) for seed in range(4)]
    assert np.mean([measure_strips(one) for one in found]) < 6.0
    assert np.mean([measure_strips(one) for one in before]) > 6.5


def find_ways(solution: Solution) -> int:
    """Gaps of a metre and more within the rows of gondolas."""
    at = middles(solution, "gondola")
    along = np.unique(at[:, int(np.ptp(at[:, 1]) > np.ptp(at[:, 0]))].round(2))
    return int((np.diff(along) > 1.9).sum())


def test_a_row_of_sixteen_shelves_have_an_aisle(monkeypatch: pytest.MonkeyPatch) -> None:
    brief = one_room(24, 4.5, {"category": "gondola", "count": 16, "patterns": ["chain"]})
    found = [scenewright.solve(brief, seed=seed, steps=2000, threads=1) for seed in range(3)]
    assert all(scenewright.check(one).valid for one in found)
    assert [find_ways(one) for one in found] == [1, 1, 1]
    monkeypatch.setattr(compose, "retouch_layout", lambda *given: given[1])
    assert find_ways(scenewright.solve(brief, seed=0, steps=2000, threads=1)) == 0


def test_stands_turn_their_fronts_to_who_comes_in() -> None:
    """However six stands are turned at first, who comes in does not see their backs; those that
    look at something of their own stay."""
    stands = {"id": "stands", "category": "exhibit_island", "count": 6, "size": [3, 2, 3]}
    _, _, fitted = posed(one_room(20, 14, {**stands, "patterns": ["grid"]}))
    door, units = fitted.problem.visitors.entrances[0], fitted.problem.units
    watching = fitted.problem._replace(units=units._replace(targets=np.zeros_like(units.targets)))
    faults = []
    for turn in (0.0, math.pi):
        pose = fitted.start.pose + np.array([0.0, 0.0, turn, 0.0])
        kept = fitted.start._replace(pose=pose)
        layout = layout_of(begin_chain(fitted.problem, kept, streams(0, 1)[0]))
        seen, looking = (look_rows(("stand_away",), one) for one in (fitted.problem, watching))
        faults.append(measure_rows(seen, kept, layout.boxes))
        assert measure_rows(looking, kept, layout.boxes) == 0.0
        turned = retouch_layout(fitted.problem, layout)
        way = door - turned.boxes[:, :2]
        front = np.column_stack([np.cos(turned.boxes[:, 2]), np.sin(turned.boxes[:, 2])])
        assert (way * front).sum(1).mean() > 0.0
    assert max(faults) > 1.0


def fair(**more: Any) -> Brief:
    """Eight stands of 4 by 3 m in a hall that holds six of them singly."""
    stands = {"id": "fair stands", "category": "exhibit_island", "count": 8, "size": [4, 3, 3]}
    return one_room(19, 13, stands | more)


def count_touching(solution: Solution) -> int:
    """Pairs of stands that touch."""
    shapes = polygons_of([p for p in solution.pieces if p.category == "exhibit_island"])
    near = [(a, b) for k, a in enumerate(shapes) for b in shapes[:k]]
    return sum(a.distance(b) < 0.3 for a, b in near)


def test_stands_of_a_fair_stand_side_by_side_with_aisles_before_them() -> None:
    found = scenewright.solve(fair(), seed=0, steps=2000, threads=1)
    assert not found.left_out
    assert scenewright.check(found).valid
    assert count_touching(found) >= 4


def test_stands_that_ask_for_free_floor_have_it() -> None:
    found = scenewright.solve(fair(count=4, clearance=0.8), seed=0, steps=2000, threads=1)
    assert count_touching(found) == 0
    boats = scenewright.solve(fair(count=4, id="boats"), seed=0, steps=2000, threads=1)
    assert count_touching(boats) == 0


def test_few_objects_stand_in_no_ring_unless_it_is_asked_for() -> None:
    def may_ring(**demand: Any) -> bool:
        (one,) = problems(one_room(16, 12, {"category": "exhibit_panel", **demand}))
        return bool(one.problem.units.choices[0, RADIATION])

    assert not may_ring(count=3)
    assert may_ring(count=8)
    assert may_ring(count=3, patterns=["radiation", "chain"])
