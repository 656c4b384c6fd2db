"""What is set right once a hall stands: columns, rings, desks, curved walls, screens and plants."""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

import numpy as np
import pytest

import scenewright
from hall_briefs import box
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall import compose
from scenewright.domains.hall.walls.curved import WallNeed, find_runs, space_places
from scenewright.domains.hall.zoning.borders import WallStretch


def column(x: float, y: float, half: float = 0.25) -> list[list[float]]:
    return box(x - half, y - half, x + half, y + half)[::-1]


def laid(seed: int = 0, steps: int = 2000, **room: Any) -> Solution:
    doors = [{"id": "front", "at": [2, 0], "width": 1.8}]
    whole = {"id": "hall", "outline": box(0, 0, 16, 12), "height": 4, "doors": doors} | room
    brief = Brief.model_validate({"domain": "hall", "name": "hall", "rooms": [whole]})
    return scenewright.solve(brief, seed=seed, steps=steps, threads=1)


def of(solution: Solution, category: str) -> list[Piece]:
    return [piece for piece in solution.pieces if piece.category == category]


def on_circle(count: int, radius: float, span: float = 2 * math.pi) -> list[list[float]]:
    turns = np.arange(count) * span / count
    return [[radius * math.cos(t), radius * math.sin(t)] for t in turns]


COLUMNS = [column(x, y) for x in (4, 8, 12) for y in (4, 8)]


def in_aisle(cases: list[Piece], x: float, y: float) -> bool:
    """Whether a column stands among rows of cases and in the line of none."""
    heading = cases[0].pose.heading
    right = np.array([math.sin(heading), -math.cos(heading)])
    ahead = np.array([math.cos(heading), math.sin(heading)])
    at = np.array([case.pose[:2] for case in cases])
    rows, along = at @ ahead, at @ right
    v, u = float(ahead @ (x, y)), float(right @ (x, y))
    among = rows.min() < v < rows.max() and along.min() < u < along.max()
    return among and bool((np.abs(rows - v) > 0.5 * cases[0].size.depth + 1e-6).all())


@pytest.mark.parametrize("seed", range(4))
def test_columns_stand_in_the_line_of_a_row(seed: int) -> None:
    demand = {"category": "showcase", "count": 12, "patterns": ["grid", "chain"]}
    solution = laid(seed, holes=COLUMNS, demands=[demand])
    cases = of(solution, "showcase")
    assert len(cases) == 12
    assert not any(in_aisle(cases, x, y) for x in (4, 8, 12) for y in (4, 8))
    assert scenewright.check(solution).valid


def test_without_the_touch_a_column_stands_in_an_aisle(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(compose, "retouch_layout", lambda *given: given[1])
    demand = {"category": "showcase", "count": 12, "patterns": ["grid", "chain"]}
    found = [of(laid(seed, holes=COLUMNS, demands=[demand]), "showcase") for seed in range(4)]
    assert any(in_aisle(cases, x, y) for cases in found for x in (4, 8, 12) for y in (4, 8))


@pytest.mark.parametrize("seed", range(4))
def test_the_ticket_desk_stands_at_a_wall_beside_the_way_in(seed: int) -> None:
    demands = [
        {"category": "counter", "name": "tickets"},
        {"category": "bench", "count": 4},
        {"category": "showcase", "count": 6},
    ]
    solution = laid(seed, demands=demands)
    (desk,) = of(solution, "counter")
    front = np.array([math.cos(desk.pose.heading), math.sin(desk.pose.heading)])
    right = np.array([front[1], -front[0]])
    at = np.array(desk.pose[:2])
    ends = [
        at - 0.5 * desk.size.depth * front - 0.9 * front,
        *(at + side * 0.5 * desk.size.width * right for side in (-1, 1)),
    ]
    room = min(min(x, y, 16 - x, 12 - y) for x, y in ends)
    assert room < 0.35, "the back, where one serves, or a side is at a wall"
    assert np.hypot(at[0] - 2.0, at[1]) < 7.0
    assert abs(at[0] - 2.0) > 0.9 or at[1] > 2.5, "not across the way in"
    assert scenewright.check(solution).valid


@pytest.mark.parametrize("seed", range(3))
def test_a_ring_has_the_middle_of_the_main_exhibit(seed: int) -> None:
    demands = [
        {"category": "exhibit_island", "size": [2.4, 2.4, 1.5]},
        {"category": "showcase", "count": 8, "patterns": ["radiation"]},
    ]
    doors = [{"id": "front", "at": [8.0, 0.0], "width": 1.6}]
    solution = laid(seed, outline=box(0, 0, 16, 16), doors=doors, demands=demands)
    (hero,) = of(solution, "exhibit_island")
    cases = np.array([case.pose[:2] for case in of(solution, "showcase")])
    assert np.hypot(*(cases.mean(0) - hero.pose[:2])) < 0.2
    far = np.hypot(*(cases - hero.pose[:2]).T)
    assert far.max() - far.min() < 0.3


@pytest.mark.parametrize(("corners", "uneven"), [(24, 1.9), (72, 1.3), (180, 1.3)])
def test_exhibits_stand_evenly_round_a_round_room(corners: int, uneven: float) -> None:
    """Where pieces of wall are long enough to hold one, none stands across their corner."""
    outline = on_circle(corners, 8.0)
    demands = [{"category": "wall_exhibit", "count": 12}]
    solution = laid(0, 300, outline=outline, doors=[], demands=demands)
    turns = sorted(math.atan2(p.pose.y, p.pose.x) for p in of(solution, "wall_exhibit"))
    assert len(turns) == 12
    gaps = np.array([b - a for a, b in pairwise([*turns, turns[0] + 2 * math.pi])])
    assert gaps.max() < uneven * gaps.min()
    kinds = {finding.kind for finding in scenewright.check(solution).findings}
    assert not kinds & {"no_wall", "collision", "out_of_bounds"}


def curve(count: int, radius: float, bend: float) -> list[WallStretch]:
    """Stretches of a curve that bends to the left (1) or right (-1) by a right angle."""
    turns = np.linspace(0.0, 0.5 * math.pi, count + 1)
    points = np.column_stack([radius * np.sin(turns), bend * radius * (1 - np.cos(turns))])
    return [
        WallStretch(float(a[0]), float(a[1]), float(b[0]), float(b[1])) for a, b in pairwise(points)
    ]


@pytest.mark.parametrize("bend", [1.0, -1.0])
@pytest.mark.parametrize("count", [5, 12, 60])
def test_places_on_a_curve_are_even_and_touch_it(count: int, bend: float) -> None:
    walls = curve(count, 10.0, bend)
    places = space_places(walls, WallNeed(1.2, 0.4, 6, True))
    assert len(places) == 6
    middles = np.array([((p.x0 + p.x1) / 2, (p.y0 + p.y1) / 2) for p in places])
    centre = np.array([0.0, bend * 10.0])
    off = np.hypot(*(middles - centre).T) - 10.0
    assert np.abs(off).max() < 0.2
    steps = np.hypot(*np.diff(middles, axis=0).T)
    assert steps.max() < (1.6 if count < 10 else 1.1) * steps.min()


def test_what_stands_side_by_side_fills_a_curve_and_straight_walls_stay() -> None:
    straight = WallStretch(-6.0, 0.0, 0.0, 0.0)
    walls = [straight, *curve(30, 10.0, 1.0)]
    assert [len(run) for run in find_runs(walls)] in ([1, 30], [31])
    packed = space_places(walls[1:], WallNeed(1.0, 0.4, 4, False))
    assert len(packed) > 12
    assert space_places([straight], WallNeed(1.0, 0.4, 4, True)) == [straight]
    assert space_places(walls, WallNeed(0.0, 0.0, 0, False)) == walls


def test_a_screen_stands_along_the_back_of_its_stage_and_seats_look_at_both() -> None:
    zones = [
        {"id": "seats", "outline": box(0, 0, 16, 8)},
        {"id": "front", "outline": box(0, 8, 16, 12)},
    ]
    demands = [
        {"category": "screen", "zone": "front"},
        {"category": "stage", "size": [7, 3, 0.5], "zone": "front", "place": "wall"},
        {"category": "auditorium_seat", "count": 40, "zone": "seats", "patterns": ["chain"]},
    ]
    solution = laid(zones=zones, demands=demands)
    (stage,), (screen,) = of(solution, "stage"), of(solution, "screen")
    assert screen.on == stage.id
    assert screen.pose.z == stage.size.height
    away = np.array(screen.pose[:2]) - stage.pose[:2]
    front = np.array([math.cos(stage.pose.heading), math.sin(stage.pose.heading)])
    assert away @ front == pytest.approx(-0.5 * (stage.size.depth - screen.size.depth))
    assert abs(away[0] * front[1] - away[1] * front[0]) < 1e-6
    seats = of(solution, "auditorium_seat")
    assert np.mean([math.sin(seat.pose.heading) for seat in seats]) > 0.9
    assert scenewright.check(solution).valid


def test_plants_and_bins_stand_at_walls() -> None:
    demands = [{"category": "potted_tree", "count": 4}, {"category": "litter_bin", "count": 3}]
    solution = laid(demands=demands)
    for piece in (*of(solution, "potted_tree"), *of(solution, "litter_bin")):
        x, y = piece.pose[:2]
        assert min(x, y, 16 - x, 12 - y) < 0.3


@pytest.mark.parametrize("seed", [0, 2])
def test_low_tables_that_would_bar_the_way_are_left_out(seed: int) -> None:
    """In a foyer full of lounge seats a table stands only where one gets to it."""
    document = scenewright.read("sample:hall-auditorium").model_dump(mode="json")
    for demand in document["rooms"][0]["demands"]:
        if demand["category"] in ("auditorium_seat", "lounge_seat"):
            demand["fill"] = 0.3
    solution = scenewright.solve(Brief.model_validate(document), seed=seed, threads=1)
    assert len(of(solution, "lounge_seat")) > 20
    assert len(of(solution, "coffee_table")) > 2
    report = scenewright.check(solution)
    assert report.valid, report.findings


def turns_back(solution: Solution) -> int:
    """At how many points of the tour one comes back, 1.6 m on, to where one was 1.6 m before."""
    assert solution.detail is not None
    points = solution.detail.tours[0].points
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    middle = np.arange(2.0, along[-1] - 2.0, 0.25)
    before, after = (
        np.column_stack([np.interp(middle + off, along, points[:, axis]) for axis in (0, 1)])
        for off in (-1.6, 1.6)
    )
    return int((np.hypot(*(after - before).T) < 0.7).sum())


@pytest.mark.parametrize("seed", range(3))
def test_a_tour_goes_on_round_a_free_wall(seed: int) -> None:
    demands = [{"category": "wall_exhibit", "count": 32}, {"category": "bench", "count": 2}]
    solution = laid(seed, outline=box(0, 0, 14, 10), demands=demands)
    assert of(solution, "partition")
    assert turns_back(solution) == 0


def test_a_tour_walks_aisles_through() -> None:
    demands = [{"category": "book_stack", "count": 40}, {"category": "info_desk"}]
    solution = laid(4, 1000, outline=box(0, 0, 18, 12), demands=demands)
    assert turns_back(solution) == 0


@pytest.mark.parametrize("seed", range(3))
def test_the_first_row_of_a_cinema_is_not_under_the_screen(seed: int) -> None:
    demands = [
        {"category": "screen", "size": [5, 0.5, 3]},
        {"category": "auditorium_seat", "count": 60, "patterns": ["chain"]},
    ]
    doors = [{"id": "left", "at": [0.0, 1.5], "width": 1.6}]
    solution = laid(seed, outline=box(0, 0, 12, 14), doors=doors, demands=demands)
    (screen,) = of(solution, "screen")
    front = np.array([math.cos(screen.pose.heading), math.sin(screen.pose.heading)])
    seats = np.array([seat.pose[:2] for seat in of(solution, "auditorium_seat")])
    assert len(seats) == 60
    assert ((seats - screen.pose[:2]) @ front).min() > 0.6 * 5
    report = scenewright.check(solution)
    assert report.valid, report.findings
