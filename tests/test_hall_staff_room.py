"""Counters at walls have room for who serves behind them, and stand in one line."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import shapely

import scenewright
from scenewright.core.brief import Brief
from scenewright.core.piece_outlines import polygons_of
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution


def hall(
    *demands: dict[str, Any],
    size: tuple[float, float] = (14.0, 9.0),
    door: float = 2.0,
    broad: float = 1.4,
) -> Brief:
    wide, deep = size
    room = {
        "name": "Hall",
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "doors": [{"at": [door, 0], "width": broad, "swing": "slide"}],
        "demands": list(demands),
    }
    return Brief.model_validate({"domain": "hall", "name": "Hall", "rooms": [room]})


def of(found: Solution, category: str) -> list[Piece]:
    return [piece for piece in found.pieces if piece.category == category]


def behind(piece: Piece, deep: float) -> shapely.Polygon:
    """The floor behind a piece, so deep."""
    x, y, _, heading = piece.pose
    ahead = np.array([math.cos(heading), math.sin(heading)])
    right = 0.5 * piece.size.width * np.array([ahead[1], -ahead[0]])
    back = np.array([x, y]) - 0.5 * piece.size.depth * ahead
    return shapely.Polygon(
        [back - right, back + right, *(back + s * right - deep * ahead for s in (1, -1))]
    )


def wall_gap(found: Solution, piece: Piece) -> float:
    """Metres from the middle of a back to the nearest wall."""
    x, y, _, heading = piece.pose
    half = 0.5 * piece.size.depth
    back = shapely.Point(x - half * math.cos(heading), y - half * math.sin(heading))
    return float(shapely.Polygon(found.brief.rooms[0].outline).exterior.distance(back))


def moved(found: Solution, piece: Piece, ahead: float) -> Solution:
    """The solution with one piece ``ahead`` metres farther ahead."""
    c, s = math.cos(piece.pose.heading), math.sin(piece.pose.heading)
    pose = piece.pose._replace(x=piece.pose.x + ahead * c, y=piece.pose.y + ahead * s)
    pieces = tuple(replace(p, pose=pose) if p.id == piece.id else p for p in found.pieces)
    return replace(found, pieces=pieces)


def astray(found: Solution) -> list[str]:
    return [finding.piece for finding in scenewright.check(found).of("no_wall")]


BAR = {"category": "counter", "count": 3, "place": "wall"}
TABLES = {"category": "dining_table", "count": 4}


@pytest.mark.parametrize("seed", [0, 1, 2])
def test_counters_at_a_wall_stand_in_line_before_room_for_their_staff(seed: int) -> None:
    found = scenewright.solve(hall(BAR, TABLES), seed=seed, steps=3000)
    counters = of(found, "counter")
    assert scenewright.check(found).valid
    assert not found.left_out
    assert len(counters) == 3
    assert {piece.size for piece in counters} == {(2.0, 0.65, 1.0)}
    assert len({round(piece.pose.heading, 6) for piece in counters}) == 1
    row = shapely.union_all(polygons_of(counters)).buffer(0.005)
    assert row.minimum_rotated_rectangle.area == pytest.approx(row.area, rel=0.01)
    others = shapely.union_all(polygons_of([p for p in found.pieces if p not in counters]))
    for piece in counters:
        assert 0.8 < wall_gap(found, piece) < 1.2
        assert behind(piece, 0.9).intersection(others).area < 1e-6


@pytest.mark.parametrize("seed", [0, 1, 2, 3])
def test_counters_go_round_no_corner_where_a_wall_is_long_enough(seed: int) -> None:
    found = scenewright.solve(hall({**BAR, "count": 4}, size=(10.0, 8.0)), seed=seed, steps=1000)
    assert len({round(piece.pose.heading, 6) for piece in of(found, "counter")}) == 1
    assert len(of(found, "counter")) == 4


@pytest.mark.parametrize("seed", [0, 1])
def test_counters_stand_at_a_wall_where_the_brief_leaves_it_open(seed: int) -> None:
    """Five in a row take more than half of the hall: before its door they bar the way in."""
    office = [
        {"category": "counter", "count": 5},
        {"category": "info_desk"},
        {"category": "bench", "count": 6},
        {"category": "desk", "count": 3, "name": "advice"},
    ]
    found = scenewright.solve(hall(*office, size=(18.0, 10.0), door=9.0), seed=seed)
    counters = of(found, "counter")
    assert scenewright.check(found).valid
    assert len(counters) == 5
    assert all(0.8 < wall_gap(found, piece) < 1.2 for piece in counters)
    assert len({round(piece.pose.heading, 6) for piece in counters}) == 1


def test_counters_that_may_stand_free_get_no_wall_built_for_them() -> None:
    brief = hall({"category": "counter", "count": 2, "zone": "bar"}, {**TABLES, "zone": "rest"})
    bar = {"id": "bar", "outline": [[1, 1.6], [13, 1.6], [13, 6], [1, 6]]}
    rest = {"id": "rest", "outline": [[0, 6], [14, 6], [14, 9], [0, 9]]}
    room = brief.rooms[0].model_dump(mode="json", exclude_defaults=True) | {"zones": [bar, rest]}
    zoned = Brief.model_validate({"domain": "hall", "rooms": [room]})
    found = scenewright.solve(zoned, seed=0, steps=2000)
    assert len(of(found, "counter")) == 2
    assert not of(found, "partition")


@pytest.mark.parametrize("seed", [0, 2])
def test_counters_stand_free_where_others_would_be_lost_before_a_wall(seed: int) -> None:
    """Ropes and showcases leave too little floor for a row with room for its staff."""
    demands = [
        {"category": "counter", "count": 3},
        {"category": "rope_barrier", "count": 16},
        {"category": "showcase", "count": 8},
    ]
    found = scenewright.solve(hall(*demands, size=(9.0, 7.0), door=3.0, broad=1.8), seed=seed)
    assert scenewright.check(found).valid
    assert len(of(found, "counter")) == 3
    assert len(of(found, "showcase")) == 8


def test_counters_too_many_for_a_wall_stand_back_to_back_with_their_staff_between() -> None:
    """Eight of two metres in a zone of twelve: two lines of four, no row behind another's back."""
    brief = hall({"category": "counter", "count": 8, "zone": "food"}, {**TABLES, "zone": "rest"})
    zones = [
        {"id": "food", "outline": [[0, 0], [12, 0], [12, 10], [0, 10]]},
        {"id": "rest", "outline": [[12, 0], [24, 0], [24, 10], [12, 10]]},
    ]
    room = brief.rooms[0].model_dump(mode="json", exclude_defaults=True) | {
        "zones": zones,
        "outline": [[0, 0], [24, 0], [24, 10], [0, 10]],
    }
    found = scenewright.solve(
        Brief.model_validate({"domain": "hall", "rooms": [room]}), seed=0, steps=2000
    )
    assert scenewright.check(found).valid
    counters = of(found, "counter")
    assert len(counters) == 8
    turned = [round(math.cos(p.pose.heading - counters[0].pose.heading), 6) for p in counters]
    assert sorted(turned) == [-1.0] * 4 + [1.0] * 4
    back = shapely.union_all([behind(piece, 0.85) for piece in counters])
    assert back.area == pytest.approx(4 * 2.0 * 0.9, rel=0.06)
    assert not any(back.buffer(-0.01).intersects(one) for one in polygons_of(found.pieces))


def test_counters_too_many_for_any_wall_stand_in_one_line_amid_the_floor() -> None:
    brief = hall({"category": "counter", "count": 3}, size=(9.0, 9.0))
    window = {"id": "w", "at": [9, 4.5], "width": 8.0, "sill": 0.3}
    others = [{"at": at, "width": 4.0, "sill": 0.3} for at in ([4.5, 9], [0, 4.5])]
    room = brief.rooms[0].model_dump(mode="json", exclude_defaults=True)
    brief = Brief.model_validate(
        {"domain": "hall", "rooms": [room | {"windows": [window, *others]}]}
    )
    found = scenewright.solve(brief, seed=0, steps=1500)
    counters = of(found, "counter")
    assert scenewright.check(found).valid
    assert len({round(piece.pose.heading, 6) for piece in counters}) == 1
    assert found.detail is not None
    assert [group.pattern for group in found.detail.layout.groups] == ["single"]


@pytest.mark.parametrize("said", [{"place": "free"}, {"patterns": ["chain"]}])
def test_counters_said_to_stand_free_have_no_room_of_their_own(said: dict[str, Any]) -> None:
    brief = hall({"category": "counter", "count": 3, **said})
    found = scenewright.solve(brief, seed=0, steps=1000)
    assert found.detail is not None
    assert [group.pattern for group in found.detail.layout.groups] == ["chain"]


@pytest.mark.parametrize("category", ["info_desk", "checkout"])
def test_desks_and_tills_at_a_wall_have_room_for_their_staff(category: str) -> None:
    asked = {"category": category, "place": "wall"}
    found = scenewright.solve(hall(asked, TABLES), seed=0, steps=2000)
    assert 0.8 < wall_gap(found, of(found, category)[0]) < 1.2
    assert scenewright.check(found).valid


def test_nobody_serves_behind_a_cupboard() -> None:
    asked = {"category": "bookcase", "count": 3, "place": "wall"}
    found = scenewright.solve(hall(asked, TABLES), seed=0, steps=2000)
    assert all(wall_gap(found, piece) < 0.05 for piece in of(found, "bookcase"))


def test_counters_without_room_for_staff_stand_at_the_wall_rather_than_nowhere() -> None:
    tight = {"category": "counter", "size": [2.0, 0.65, 1.0], "place": "wall", "clearance": 0.6}
    found = scenewright.solve(hall(tight, size=(4.4, 2.2)), seed=0, steps=1000)
    assert not found.left_out
    assert wall_gap(found, of(found, "counter")[0]) < 0.05


def test_as_printed_counters_stand_with_their_backs_at_the_wall() -> None:
    found = scenewright.solve(hall(BAR, TABLES), seed=0, preset="paper")
    assert all(wall_gap(found, piece) < 0.05 for piece in of(found, "counter"))


@pytest.mark.parametrize(
    ("ahead", "fine"), [(0.0, True), (0.9, True), (0.5, False), (1.4, False), (2.0, False)]
)
def test_the_referee_allows_a_counter_the_room_of_its_staff(ahead: float, fine: bool) -> None:
    found = scenewright.solve(hall({**BAR, "count": 1}), seed=0, preset="paper")
    counter = of(found, "counter")[0]
    assert astray(moved(found, counter, ahead)) == ([] if fine else [counter.id])


def test_the_referee_wants_a_cupboard_at_the_wall_itself() -> None:
    found = scenewright.solve(hall({"category": "bookcase", "place": "wall"}), seed=0, steps=500)
    case = of(found, "bookcase")[0]
    assert not astray(found)
    assert astray(moved(found, case, 0.9)) == [case.id]


def test_a_wall_beside_a_counter_is_none_behind_it() -> None:
    found = scenewright.solve(hall({**BAR, "count": 1}), seed=0, preset="paper")
    counter = of(found, "counter")[0]
    pose = counter.pose._replace(x=1.0, y=5.0, heading=math.pi / 2)
    turned = tuple(replace(p, pose=pose) if p.id == counter.id else p for p in found.pieces)
    assert astray(replace(found, pieces=turned)) == [counter.id]
