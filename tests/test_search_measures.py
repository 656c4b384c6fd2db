"""The search has measures of its own; they say what the referee says of the finished rooms."""

from __future__ import annotations

import math
import random
from collections.abc import Iterator
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import scenewright as sw
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.check.bodies import bodies_of, rooms_of
from scenewright.check.outlets import connections_of
from scenewright.check.reach import find_unreachable
from scenewright.check.routes import grounds_of, walk_in
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.space import Space
from scenewright.domains import plan_of
from scenewright.domains.home.check.complete import find_incomplete
from scenewright.domains.home.check.wishes import wishes_told
from scenewright.domains.home.shortfall import list_lacking
from scenewright.domains.home.walking.barred import find_barred
from scenewright.domains.home.walking.home_floor import join_floors
from scenewright.domains.home.wished.gaps import (
    distance_between,
    distance_to_segments,
    sees_any,
    sides_of,
)
from scenewright.domains.home.wished.unmet import count_unmet_wishes, is_met
from thoroughness import few_or_many

HOMES = [name for name in sw.samples() if name.startswith("sample:home")]
COARSE = st.integers(-6, 6).map(lambda k: k / 2)  # many that touch or lie in line
FINE = st.floats(-4, 4).map(lambda v: round(v, 3))
BOX = st.tuples(
    COARSE | FINE,
    COARSE | FINE,
    st.sampled_from([0.0, math.pi / 2, math.pi, 0.3, -2.0]),
    st.sampled_from([0.5, 1.0, 2.0]),
    st.sampled_from([0.5, 1.0]),
)
SEGMENT = st.tuples(*[COARSE | FINE] * 4)


def polygons(boxes: list[tuple[float, ...]]) -> shapely.Geometry:
    return shapely.union_all(shapely.polygons(corners(np.array(boxes))))


def line(segment: tuple[float, ...]) -> shapely.Geometry:
    start, end = segment[:2], segment[2:]
    return shapely.Point(start) if start == end else shapely.LineString([start, end])


@given(st.lists(BOX, min_size=1, max_size=3), st.lists(SEGMENT, min_size=1, max_size=3))
def test_distances_to_segments_are_those_of_polygons(
    boxes: list[tuple[float, ...]], segments: list[tuple[float, ...]]
) -> None:
    lines = shapely.union_all([line(segment) for segment in segments])
    found = distance_to_segments(np.array(boxes), np.array(segments))
    assert found == pytest.approx(shapely.distance(polygons(boxes), lines), abs=1e-7)


@given(st.lists(BOX, min_size=1, max_size=3), st.lists(BOX, min_size=1, max_size=3))
def test_distances_between_boxes_are_those_of_polygons(
    boxes: list[tuple[float, ...]], others: list[tuple[float, ...]]
) -> None:
    found = distance_between(np.array(boxes), np.array(others))
    assert found == pytest.approx(shapely.distance(polygons(boxes), polygons(others)), abs=1e-7)


@given(st.tuples(FINE, FINE), st.floats(-4, 4), st.floats(0.1, 1.5), SEGMENT)
def test_what_is_seen_lies_in_the_wedge(
    eye: tuple[float, float], look: float, within: float, segment: tuple[float, ...]
) -> None:
    reach = 1e3
    ends = [
        (eye[0] + reach * math.cos(a), eye[1] + reach * math.sin(a))
        for a in (look - within, look + within)
    ]
    wedge = shapely.Polygon([eye, *ends])
    there = line(segment)
    seen = sees_any(np.array(eye), look, within, np.array([segment]))
    touching = wedge.buffer(1e-6).intersects(there) != wedge.buffer(-1e-6).intersects(there)
    assert touching or seen == wedge.intersects(there)


def test_nothing_is_infinitely_far() -> None:
    none, one = np.zeros((0, 5)), np.array([[0.0, 0.0, 0.0, 1.0, 1.0]])
    assert distance_between(one, none) == distance_between(none, one) == math.inf
    assert distance_to_segments(one, sides_of(none)) == math.inf
    assert not sees_any(np.zeros(2), 0.0, 0.5, np.zeros((0, 4)))


WISHES = [
    {"what": "desk", "by": "window"},
    {"what": "desk", "face": "door"},
    {"what": "desk", "face": "window"},
    {"what": "bookcase", "by": "corner"},
    {"what": "bookcase", "by": "wall"},
    {"what": "armchair", "by": "door"},
    {"what": "armchair", "near": "bookcase"},
    {"what": "armchair", "face": "desk"},
    {"what": "armchair", "away_from": "window"},
    {"what": "plant", "away_from": "desk", "metres": 1.0},
]
KINDS = ("desk", "armchair", "bookcase", "floor_lamp", "rug")


@cache
def wished_room() -> tuple[Brief, Space]:
    asked = {
        "id": "r",
        "outline": [(0, 0), (4, 0), (4, 3), (2.4, 3), (2.4, 4), (0, 4)],
        "wishes": WISHES,
        "doors": [{"at": (3.2, 0), "width": 0.9}],
        "windows": [{"at": (0, 2.2), "width": 1.2}],
        "outlets": [{"at": (4, 1), "kind": "power"}, {"at": (0, 0.5), "kind": "power"}],
    }
    brief = Brief.model_validate({"rooms": [asked]})
    return brief, spaces(brief)[0]


def piece(number: int, box: tuple[float, ...]) -> Piece:
    kind = KINDS[number % len(KINDS)]
    height = 0.02 if kind == "rug" else 0.8
    pose = Pose(2 + box[0] / 2, 2 + box[1] / 2, 0.0, box[2])
    size = Size(box[3] + number / 100, box[4], height)  # one of each kind is the largest
    return Piece(f"r/{number}", kind, "", "r", pose, size, "", kind)


@settings(derandomize=True)
@given(st.lists(BOX, min_size=1, max_size=7))
def test_wishes_and_outlets_are_met_as_the_referee_says(boxes: list[tuple[float, ...]]) -> None:
    brief, space = wished_room()
    pieces = tuple(piece(k, box) for k, box in enumerate(boxes))
    rooms = rooms_of((space,))
    bodies, _ = bodies_of(pieces, rooms, shipped())
    told = [row["fulfilled"] for row in wishes_told(bodies, rooms, brief.rooms)]
    solid = [p for p in pieces if p.category != "rug"]
    assert [is_met(wish, space, solid) for wish in brief.rooms[0].wishes] == told
    unserved = sum(not each.reached for each in connections_of(bodies, rooms))
    counted = count_unmet_wishes(brief.rooms[0], space, pieces, shipped())
    assert counted == told.count(False) + unserved


@cache
def furnished(name: str) -> sw.Solution:
    return sw.solve(sw.read(name), seed=1, steps=300)


def parts_of(pieces: tuple[Piece, ...]) -> Iterator[tuple[Piece, ...]]:
    """All pieces, and all but those of one kind."""
    yield pieces
    for kind in sorted({p.category for p in pieces}):
        yield tuple(p for p in pieces if p.category != kind)


@pytest.mark.parametrize("name", HOMES)
def test_rooms_lack_what_the_referee_misses(name: str) -> None:
    solution = furnished(name)
    for space in plan_of(solution.brief).spaces:
        rooms, here = rooms_of((space,)), tuple(p for p in solution.pieces if p.space == space.id)
        for pieces in parts_of(here):
            notes = find_incomplete(bodies_of(pieces, rooms, shipped())[0], rooms)
            lacking = [need.name for need in list_lacking(space, pieces, shipped())]
            assert lacking == [note.missing for note in notes]


@pytest.mark.parametrize("name", HOMES)
def test_finished_samples_meet_the_wishes_the_referee_counts(name: str) -> None:
    solution = furnished(name)
    report = sw.check(solution)
    rows = zip(solution.brief.rooms, plan_of(solution.brief).spaces, strict=True)
    unmet = sum(
        count_unmet_wishes(
            room, space, tuple(p for p in solution.pieces if p.space == space.id), shipped()
        )
        for room, space in rows
    )
    wishes = [row for row in report.figures.get("wishes", []) if not row["wish"].startswith("no ")]
    fixed = {p.id for p in solution.pieces if p.fixed}
    outlets = [o for o in report.figures.get("outlets", []) if o["piece"] not in fixed]
    assert unmet == sum(not w["fulfilled"] for w in wishes) + sum(not o["within"] for o in outlets)


def shaken(pieces: tuple[Piece, ...], seed: int) -> tuple[Piece, ...]:
    """Pieces, some of them moved, the farther the greater the seed; 0: unchanged."""
    rng = random.Random(seed)
    off = 0.1 * 2 ** (seed % 4)

    def moved(piece: Piece) -> Piece:
        pose = piece.pose
        x, y = pose.x + rng.gauss(0, off), pose.y + rng.gauss(0, off)
        return replace(piece, pose=pose._replace(x=x, y=y))

    return tuple(moved(p) if seed and rng.random() < 0.5 else p for p in pieces)


@pytest.mark.parametrize("seed", range(few_or_many(2, 4)))
@pytest.mark.parametrize("name", HOMES)
def test_routes_reach_what_those_of_the_referee_reach(name: str, seed: int) -> None:
    solution = furnished(name)
    rooms = rooms_of(plan_of(solution.brief).spaces)
    pieces, width = shaken(solution.pieces, seed), solution.brief.route_width
    bodies, _ = bodies_of(pieces, rooms, shipped())
    grounds = grounds_of(rooms, width)
    walks = [walk_in(bodies, ground, width / 2) for ground in grounds]
    told = {(f.space, f.piece) for f in find_unreachable(bodies, rooms, grounds, walks)}
    floors = join_floors(rooms.spaces, width)
    barred = find_barred(pieces, rooms.spaces, floors, shipped())
    assert {(each.space, each.piece) for each in barred} == told
    assert all(each.piece not in each.openers for each in barred)


def test_what_would_open_a_way_is_any_one_piece_or_the_least_set() -> None:
    rooms = [{"id": "r", "outline": [(0, 0), (2, 0), (2, 5), (0, 5)], "doors": [{"at": (1, 0)}]}]
    spaces_ = spaces(Brief.model_validate({"rooms": rooms}))
    desk = Piece("r/desk", "desk", "", "r", Pose(1, 4.6, 0, -math.pi / 2), Size(1, 0.6, 0.7))

    def bar(name: str, y: float, width: float = 2.0) -> Piece:
        pose = Pose(width / 2, y, 0.0, math.pi / 2)
        return Piece(name, "bookcase", "", "r", pose, Size(width, 0.3, 2.0))

    def openers(*pieces: Piece) -> list[tuple[str, ...]]:
        floors = join_floors(spaces_, 0.6)
        barred = find_barred((desk, *pieces), spaces_, floors, shipped())
        return [each.openers for each in barred if each.piece == "r/desk"]

    assert openers() == openers(bar("half", 2.5, 1.0)) == []
    assert openers(bar("one", 2.5)) == [("one",)]
    assert openers(bar("one", 2.5), bar("half", 1.5, 1.0)) == [("one",)]
    assert [set(names) for names in openers(bar("a", 1.5), bar("b", 3.0))] == [{"a", "b"}]
