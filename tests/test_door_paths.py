"""The ways from door to door: over the floor, through the doors, each square metre once."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from deadline import HANGS, within
from scenewright.building.door_approach import gates
from scenewright.building.plan import plan_rooms
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.space import Space
from scenewright.domains.home.energy import explain
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.problem import Problem, empty_items
from scenewright.domains.home.walking.door_paths import WIDTH, door_paths
from scenewright.formats import read

NONE = np.zeros((0, 5))
L = [(0, 0), (6, 0), (6, 2), (2, 2), (2, 6), (0, 6)]


def room_with(outline, *doors) -> Space:
    found = [{"at": at, "width": 0.8, "swing": "slide"} for at in doors]
    brief = {"rooms": [{"id": "r", "function": "hall", "outline": outline, "doors": found}]}
    return plan_rooms(Brief.model_validate(brief)).spaces[0]


def paths_of(space: Space, solids=NONE):
    doors = tuple(g for g in gates(space) if g.opening.kind != "window")
    return door_paths(space, doors, solids)


def shape_of(edges) -> shapely.Geometry:
    """The region within rings of directed edges; what lies in two of them is a hole."""
    shape, ring = shapely.Polygon(), []
    for edge in edges:
        ring.append(edge[:2])
        if np.array_equal(edge[2:], ring[0]):
            shape, ring = shape.symmetric_difference(shapely.Polygon(ring)), []
    assert not ring
    return shape


def area_of(edges) -> float:
    return 0.5 * float((edges[:, 0] * edges[:, 3] - edges[:, 2] * edges[:, 1]).sum())


@pytest.mark.parametrize("sample", ["home-flat", "home-acute", "home-curved", "home-l-shape"])
def test_ways_lie_in_the_room_and_touch_every_door(sample):
    for space in plan_rooms(read(f"sample:{sample}")).spaces:
        doors = tuple(g for g in gates(space) if g.opening.kind != "window")
        if len(doors) < 2:
            assert len(door_paths(space, doors, NONE)) == 0
            continue
        shape = shape_of(door_paths(space, doors, NONE))
        room = shapely.Polygon(space.outline, list(space.holes))
        assert shape.difference(room.buffer(1e-6)).area < 1e-6
        assert all(shape.distance(shapely.Point(door.face)) < 0.05 for door in doors)
        assert isinstance(shape, shapely.Polygon)


def test_doors_that_face_each_other_are_joined_by_a_straight_strip():
    edges = paths_of(room_with([(0, 0), (4, 0), (4, 3), (0, 3)], (1.5, 0), (1.5, 3)))
    assert area_of(edges) == pytest.approx(WIDTH * 3)
    assert shape_of(edges).bounds == pytest.approx((1.15, 0, 1.85, 3))


def test_floor_on_several_ways_counts_once():
    doors = (1.0, 0), (2.2, 0), (1.0, 2), (2.2, 2)
    edges = paths_of(room_with([(0, 0), (3.2, 0), (3.2, 2), (0, 2)], *doors))
    shape = shape_of(edges)
    assert area_of(edges) == pytest.approx(shape.area)
    assert shape.area < 6.4 < 6 * WIDTH * 1.2 + 2 * WIDTH * 2


def test_a_way_goes_round_the_corner_and_round_what_stands():
    space = room_with(L, (5.5, 0), (0, 5.5))
    room = shapely.Polygon(L)
    bent = shape_of(paths_of(space))
    assert bent.difference(room.buffer(1e-6)).area < 1e-9
    stands = np.array([[1.5, 1.5, 0.0, 0.4, 0.4]])
    round_it = shape_of(paths_of(space, stands))
    assert bent.intersects(shapely.box(1.31, 1.31, 1.69, 1.69))
    assert not round_it.intersects(shapely.box(1.31, 1.31, 1.69, 1.69))


def test_the_cost_is_the_area_on_the_united_ways():
    space = room_with(L, (5.5, 0), (0, 5.5), (0, 0.8))
    ground = ground_of(space, (), 20.0)
    shape = shape_of(ground.paths)
    problem = Problem(ground, empty_items(1), ("a",), {"corridors": 1.0})
    box = np.array([[1.4, 1.1, 0.3, 1.6, 1.2]])
    (part,) = explain(problem, box)
    covered = shapely.Polygon(corners(box)[0]).intersection(shape).area
    assert (part.term, part.value) == ("corridors", pytest.approx(covered / (1.6 * 1.2)))


def test_a_passage_narrower_than_a_way_is_used_as_wide_as_it_is():
    narrow = [
        (0, 0),
        (2, 0),
        (2, 2),
        (1.2, 2),
        (1.2, 4),
        (2, 4),
        (2, 6),
        (0, 6),
        (0, 4),
        (0.8, 4),
        (0.8, 2),
        (0, 2),
    ]
    shape = shape_of(paths_of(room_with(narrow, (1, 0), (1, 6))))
    assert shape.intersection(shapely.box(0, 2.5, 2, 3.5)).area == pytest.approx(0.4)


def test_ways_among_hundreds_of_columns_are_found_in_time() -> None:
    """Every corner is one a way may bend at, and the search is cubic in them."""
    side = 62.0
    at = np.stack(np.meshgrid(np.arange(2.0, 60.0, 3.0), np.arange(2.0, 60.0, 3.0)), -1)
    solids = np.column_stack([at.reshape(-1, 2), np.tile([0.0, 0.6, 0.4], (at.size // 2, 1))])
    outline = [(0, 0), (side, 0), (side, side), (0, side)]
    space = room_with(outline, (1.2, 0.0), (side - 1.2, side))
    with within(HANGS):
        edges = paths_of(space, solids)
    assert area_of(edges) == pytest.approx(WIDTH * np.hypot(side - 2.4, side), rel=0.05)
    taken = shapely.union_all(shapely.polygons(corners(solids)))
    assert shape_of(edges).intersection(taken).area < 0.01
