"""The visitor's route: its parts against slow references, the whole on halls with a known way."""

from __future__ import annotations

import itertools
import math

import numpy as np
import pytest
import shapely
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import dijkstra

from scenewright.building.outlines import edges
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.scene import Piece, Pose, Size
from scenewright.domains.hall.hall_layout import HallLayout, PlacedGroup
from scenewright.domains.hall.visit.tour import tour
from scenewright.geometry.distance_raster import DistanceRaster, clearance, distances, walls_between
from scenewright.geometry.travel import make_search, round_off, shorten, spread, string_pull
from scenewright.geometry.visiting_order import shortest_path_through

CATALOG = shipped()
WIDTH = 0.9
L_SHAPE = np.array([(0, 0), (9, 0), (9, 4), (5, 4), (5, 8), (0, 8)], float)


def shape(box):
    return shapely.Polygon(corners(np.array(box, float)))


# The parts


def test_the_raster_holds_exact_distances():
    rng = np.random.default_rng(5)
    solids = np.column_stack(
        [rng.uniform(1, 7, (9, 2)), rng.uniform(0, 6, 9), rng.uniform(0.1, 2, (9, 2))]
    )
    door = np.array([[2.0, 0.0, np.pi / 2, 1.0, 0.3]])
    walls = walls_between(edges(L_SHAPE), door)
    none = np.zeros((0, 5))
    bounds = np.array([-0.3, -0.3, 9.3, 8.3])
    raster = clearance(edges(L_SHAPE), walls, none, solids, bounds, 0.1, 1.2, 0.45)
    rows, columns = raster.values.shape
    x, y = np.meshgrid(
        raster.x0 + 0.1 * (np.arange(columns) + 0.5), raster.y0 + 0.1 * (np.arange(rows) + 0.5)
    )
    ring = shapely.LinearRing(L_SHAPE) - shape(door[0])
    things = shapely.union_all([ring, *(shape(box) for box in solids)])
    away = np.minimum(shapely.distance(things, shapely.points(x, y)), 1.2)
    inside = shapely.contains_xy(shapely.Polygon(L_SHAPE), x, y)
    np.testing.assert_allclose(raster.values, np.where(inside, away, 0.0), atol=1e-9)
    points = rng.uniform(0, 8, (50, 2))
    exact = shapely.distance(things, shapely.points(points))
    np.testing.assert_allclose(distances(points, np.vstack([walls, solids])), exact, atol=1e-9)


def test_a_door_is_passed_however_narrow():
    square = edges(np.array([(0, 0), (4, 0), (4, 4), (0, 4)], float))
    gap = np.array([[2.0, 0.0, np.pi / 2, 0.6, 0.3]])
    strip = np.array([[2.0, 0.0, np.pi / 2, 0.21, 1.1]])
    bounds = np.array([-1.0, -1.0, 5.0, 5.0])
    args = (square, walls_between(square, gap), strip, np.zeros((0, 5)), bounds, 0.1, 1.2, 0.45)
    raster = clearance(*args)
    column = int((2.0 - raster.x0) / 0.1)
    assert (
        raster.values[int((-0.4 - raster.y0) / 0.1) : int((2 - raster.y0) / 0.1), column].min()
        >= 0.45
    )
    desk = np.array([[2.0, 0.3, 0.0, 1.0, 0.4]])  # but not if something stands in it
    blocked = clearance(*args[:3], desk, *args[4:])
    assert blocked.values[int((0.3 - raster.y0) / 0.1), column] == 0.0


def graph_of(slow, cell):
    """The same graph of eight neighbours as a sparse matrix."""
    rows, columns = slow.shape
    number = np.arange(rows * columns).reshape(slow.shape)
    links = []
    for dr, dc in ((0, 1), (1, 0), (1, 1), (1, -1)):
        a = number[: rows - dr, max(-dc, 0) : columns - max(dc, 0)].ravel()
        b = number[dr:, max(dc, 0) : columns + min(dc, 0)].ravel()
        cost = 0.5 * cell * math.hypot(dr, dc) * (slow.ravel()[a] + slow.ravel()[b])
        links.append((a, b, cost))
    a, b, cost = (np.concatenate(column) for column in zip(*links, strict=True))
    open_ = np.isfinite(cost)
    return csr_matrix((cost[open_], (a[open_], b[open_])), (rows * columns,) * 2)


@pytest.mark.parametrize("seed", range(4))
def test_travel_times_are_those_of_dijkstra(seed):
    rng = np.random.default_rng(seed)
    slow = rng.uniform(1.0, 3.0, (30, 41))
    slow[rng.random(slow.shape) < 0.35] = np.inf
    starts = rng.choice(np.flatnonzero(np.isfinite(slow)), 3, replace=False).astype(np.int32)
    expected = dijkstra(graph_of(slow, 0.1), directed=False, indices=starts)
    search = make_search(slow.size)
    spread(search, slow, 0.1, starts, -1)
    np.testing.assert_allclose(search.times, expected.min(axis=0), rtol=1e-12)
    reached = np.isfinite(search.times)
    nearest = expected[search.source[reached], np.flatnonzero(reached)]
    np.testing.assert_allclose(nearest, search.times[reached], rtol=1e-12)
    for goal in np.flatnonzero(np.isfinite(expected[0]))[::37]:  # A* finds the same
        spread(search, slow, 0.1, starts[:1], int(goal))
        assert search.times[goal] == pytest.approx(expected[0, goal], rel=1e-12)


def test_ways_are_pulled_straight_only_where_that_is_no_slower():
    slow = np.ones((20, 40))
    path = np.array([*(5 * 40 + np.arange(4, 20)), *((5 + np.arange(1, 10)) * 40 + 19)], np.int32)
    times = 0.1 * np.arange(len(path), dtype=float)
    kept = np.empty(len(path), np.int32)
    assert string_pull(path, slow, times, 0.1, kept) == 2
    assert kept[:2].tolist() == [path[0], path[-1]]
    slow[7:15, 5:18] = 30.0  # mud in the corner that would be cut
    count = string_pull(path, slow, times, 0.1, kept)
    assert count > 2
    line = shapely.LineString([(c % 40, c // 40) for c in kept[:count]])
    assert line.distance(shapely.box(5, 7, 17, 14)) > 0.4
    slow[:, 10] = np.inf
    both = np.full((2, 2), np.inf)
    shorten(both, slow, 0.1, np.array([3 * 40 + 3, 3 * 40 + 30], np.int32))
    assert not np.isfinite(both[0, 1])


def test_rounding_off_keeps_ends_reach_and_clearance():
    y, x = np.mgrid[0:60, 0:60] * 0.1 + 0.05
    values = np.minimum(np.hypot(x - 3.0, y - 3.0), 1.2)  # a post in the middle
    clear = DistanceRaster(0.0, 0.0, 0.1, values)
    t = np.linspace(0, 1, 12)[:, None]
    home = np.vstack([(1, 2.0) + t * (2.5, 0), (3.5, 2.0) + t[1:] * (0.3, 2.4)])
    points = home.copy()
    round_off(points, home, clear, 0.5, 0.6, 60)
    assert (points[[0, -1]] == home[[0, -1]]).all()
    assert np.hypot(*(points - home).T).max() <= 0.6 + 1e-9
    assert np.hypot(*(points - 3.0).T).min() >= 0.49
    close = np.column_stack([np.linspace(1, 5, 20), np.full(20, 2.7)])
    moved = close.copy()
    round_off(moved, close, clear, 0.5, 0.4, 60)
    assert np.hypot(*(moved - 3.0).T).min() > np.hypot(*(close - 3.0).T).min() + 0.15

    def turning(line):
        heading = np.unwrap(np.arctan2(*np.diff(line, axis=0).T[::-1]))
        return np.abs(np.diff(heading)).max()

    assert turning(points) < 0.5 * turning(home)


@pytest.mark.parametrize("seed", range(8))
def test_rounds_are_short(seed):
    rng = np.random.default_rng(seed)
    spots = rng.uniform(0, 10, (8, 2))
    costs = np.hypot(*(spots[:, None] - spots).transpose(2, 0, 1))
    order = shortest_path_through(costs)
    assert sorted(order.tolist()) == list(range(8))
    assert (order[0], order[-1]) == (0, 7)

    def length(o):
        return costs[list(o[:-1]), list(o[1:])].sum()

    best = min(length((0, *middle, 7)) for middle in itertools.permutations(range(1, 7)))
    assert length(order) <= 1.02 * best


# The whole


def hall(outline, doors, holes=()):
    room = {"id": "h", "outline": outline, "holes": list(holes), "doors": doors}
    return spaces(Brief.model_validate({"domain": "hall", "rooms": [room]}))[0]


def group(name, poses, size=(1.0, 1.0, 1.0), category="kitchen_island", zone="z"):
    pieces = tuple(
        Piece(f"h/{name}/{category}_{k}", category, "", "h", Pose(x, y, 0.0, heading), Size(*size))
        for k, (x, y, heading) in enumerate(poses)
    )
    row = PlacedGroup(
        f"h/{name}", name, "h", zone, "chain", (0.0, 0.0, 0.0), (), tuple(p.id for p in pieces)
    )
    return pieces, row


def partition(x0, y0, x1, y1):
    length, heading = math.hypot(x1 - x0, y1 - y0), math.atan2(y1 - y0, x1 - x0) + math.pi / 2
    pose = Pose((x0 + x1) / 2, (y0 + y1) / 2, 0.0, heading)
    return Piece(f"w{x0}{y0}{x1}{y1}", "partition", "", "h", pose, Size(length, 0.15, 2.5))


def walk(space, groups, walls=(), width=WIDTH):
    pieces = tuple(piece for pieces, _ in groups for piece in pieces)
    graph = HallLayout((), (), tuple(row for _, row in groups))
    return tour(space, (*pieces, *walls), graph, CATALOG, width), (*pieces, *walls)


def names(found):
    return [stop.group.removeprefix("h/") for stop in found.stops]


def check_tour(found, space, pieces):
    """Close points, on the floor, off everything, and widths that shapely confirms."""
    steps = np.hypot(*np.diff(found.points, axis=0).T)
    assert steps.max() <= 0.5 + 1e-9
    assert [s.at for s in found.stops] == sorted(s.at for s in found.stops)
    floor = shapely.Polygon(space.outline, space.holes)
    boxes = [shape([*p.pose[:2], p.pose.heading, *p.size[:2]]) for p in pieces]
    across = [(o, math.atan2(o.ux, -o.uy)) for o in space.openings]
    gaps = shapely.union_all([shape([o.x, o.y, h, o.width, o.thickness + 0.02]) for o, h in across])
    walls = shapely.union_all([floor.exterior, *floor.interiors]) - gaps
    things = shapely.union_all([walls, *boxes])
    inner = shapely.contains_xy(floor, *found.points.T)
    assert shapely.intersects(gaps, shapely.points(found.points[~inner])).all()
    exact = 2 * shapely.distance(things, shapely.points(found.points[inner]))
    np.testing.assert_allclose(found.widths[inner], exact, atol=1e-6)


def test_a_corridor_is_walked_round_what_stands_in_it():
    space = hall([(0, 0), (12, 0), (12, 4), (0, 4)], [{"at": (0, 2)}, {"at": (12, 2)}])
    block = group("block", [(6, 1.0, 0.0)], (2.0, 2.4, 1.0))  # leaves 1.8 m to the north
    found, pieces = walk(space, [block])
    check_tour(found, space, pieces)
    assert found.widths[3:-3].min() >= WIDTH
    np.testing.assert_allclose(found.points[0], [-0.125, 2.0], atol=0.01)
    np.testing.assert_allclose(found.points[-1], [12.125, 2.0], atol=0.01)
    past = found.points[np.abs(found.points[:, 0] - 6) < 1]
    assert (past[:, 1] > 2.2 + WIDTH / 2 - 0.02).all()
    length = np.hypot(*np.diff(found.points, axis=0).T).sum()
    assert 12.25 < length < 14.5  # straight on, and round the corners at most


def test_wide_ways_are_preferred():
    space = hall([(0, 0), (12, 0), (12, 6), (0, 6)], [{"at": (0, 2.6)}, {"at": (12, 2.6)}])
    walls = [partition(4, 0, 4, 1.4), partition(4, 2.4, 4, 3.2)]  # gaps of 1.0 and 2.8 m
    found, pieces = walk(
        space,
        [],
        [
            *walls,
            *(partition(x, 0, x, 1.4) for x in (5, 6, 7)),
            *(partition(x, 2.4, x, 3.2) for x in (5, 6, 7)),
        ],
    )
    check_tour(found, space, pieces)
    middle = found.points[(found.points[:, 0] > 4) & (found.points[:, 0] < 7)]
    assert (middle[:, 1] > 3.2).all()


def test_the_one_gap_in_a_wall_is_found_and_its_width_told():
    space = hall([(0, 0), (12, 0), (12, 8), (0, 8)], [{"at": (2, 0), "width": 1.2}])
    far = group("far", [(10, 2, 0.0)])
    for gap in (1.3, 0.9, 0.6):
        walls = [partition(6, 0, 6, 6), partition(6, 6 + gap, 6, 8)]
        found, pieces = walk(space, [far], walls)
        check_tour(found, space, pieces)
        assert names(found) == ["far"]
        through = shapely.intersection(
            shapely.LineString(found.points), shapely.LineString([(6, 0), (6, 8)])
        )
        crossed = shapely.get_coordinates(through)[:, 1]
        assert len(crossed) == 2  # there and back
        assert ((crossed > 6) & (crossed < 6 + gap)).all()
        assert min(gap, WIDTH) - 0.06 < found.widths.min() < min(gap, 1.2) + 0.06


def test_groups_nobody_can_reach_have_no_stop():
    space = hall([(0, 0), (12, 0), (12, 8), (0, 8)], [{"at": (2, 0), "width": 1.2}])
    near, shut = group("near", [(3, 5, 0.0)]), group("shut", [(10, 6, 0.0)])
    found, pieces = walk(space, [near, shut], [partition(8, 0, 8, 8)])
    check_tour(found, space, pieces)
    assert names(found) == ["near"]
    assert found.points[:, 0].max() < 8


def test_without_a_door_or_a_destination_there_is_no_tour():
    square = [(0, 0), (6, 0), (6, 6), (0, 6)]
    one = group("one", [(3, 3, 0.0)])
    assert walk(hall(square, []), [one])[0] is None
    assert walk(hall(square, [{"at": (3, 0)}]), [])[0] is None
    assert walk(hall(square, [{"at": (3, 0), "use": "exit"}]), [one])[0] is None
    blocked = group("desk", [(3, 0.2, 0.0)], (0.4, 2.0, 1.0))
    assert walk(hall(square, [{"at": (3, 0)}]), [one, blocked])[0] is None


def test_visitors_use_doors_as_the_brief_says():
    square = [(0, 0), (12, 0), (12, 8), (0, 8)]
    things = [group("one", [(6, 4, 0.0)])]

    def ends(*uses):
        spots = ((3, 0), (9, 0), (12, 4))
        doors = [{"at": at, "use": use} for at, use in zip(spots, uses, strict=True)]
        space = hall(square, doors)
        assert tuple(door.use for door in space.openings) == uses
        found, _ = walk(space, things)
        at = np.array(spots, float)
        return [int(np.hypot(*(at - found.points[k]).T).argmin()) for k in (0, -1)]

    assert ends("exit", "both", "entrance") == [2, 0]
    assert ends("both", "entrance", "both")[0] == 1
    first, last = ends("both", "both", "both")
    assert first != last
    assert ends("exit", "entrance", "entrance")[1] == 0


def test_a_single_door_is_entrance_and_exit():
    space = hall([(0, 0), (8, 0), (8, 6), (0, 6)], [{"at": (4, 0), "width": 1.2}])
    found, pieces = walk(space, [group("one", [(4, 4, 0.0)])])
    check_tour(found, space, pieces)
    assert (found.points[0] == found.points[-1]).all()


def test_objects_are_seen_from_the_side_they_are_used_from():
    space = hall([(0, 0), (12, 0), (12, 8), (0, 8)], [{"at": (2, 0), "width": 1.2}])
    shelves = group("shelves", [(4 + k, 5, math.pi / 2) for k in range(4)], (1, 0.4, 2), "bookcase")
    found, pieces = walk(space, [shelves], [])
    check_tour(found, space, pieces)
    assert all(found.points[stop.at][1] > 5.2 for stop in found.stops)
    assert walk(space, [shelves], [partition(3.5, 5.4, 7.5, 5.4)])[0] is None  # a wall before them


def test_a_long_row_is_walked_along():
    space = hall([(0, 0), (30, 0), (30, 6), (0, 6)], [{"at": (15, 0), "width": 1.2}])
    row = group("row", [(2 + k, 5.8, -math.pi / 2) for k in range(27)], (1, 0.4, 2), "bookcase")
    found, pieces = walk(space, [row])
    check_tour(found, space, pieces)
    places = np.array([p.pose[:2] for p in pieces])
    near = np.hypot(*(places[:, None] - found.points).transpose(2, 0, 1)).min(axis=1)
    assert near.max() < 4.5


def test_nobody_crawls_through_rows_of_seats():
    space = hall([(0, 0), (16, 0), (16, 12), (0, 12)], [{"at": (2, 0)}, {"at": (14, 0)}])
    spots = [(4 + 0.6 * c, 3 + 1.6 * r, math.pi / 2) for c in range(12) for r in range(5)]
    seats = group("seats", spots, (0.5, 0.5, 0.9), "dining_chair")  # rows one could walk along
    found, pieces = walk(space, [seats])
    check_tour(found, space, pieces)
    assert names(found) == ["seats"]
    rows = shapely.box(4.0, 3.3, 10.4, 9.1)
    assert not shapely.contains_xy(rows, *found.points.T).any()


def test_a_coarse_raster_still_sees_what_stands_in_a_huge_hall():
    doors = [{"at": (5, 0), "width": 3}, {"at": (270, 0), "width": 3}]
    space = hall([(0, 0), (280, 0), (280, 250), (0, 250)], doors)
    spots = [(100 + 1.3 * k, 100, math.pi / 2) for k in range(9)]
    found, pieces = walk(space, [group("row", spots, (1.2, 0.5, 2), "display_cabinet")])
    check_tour(found, space, pieces)
    assert names(found) == ["row"]
    assert 100.2 < found.points[found.stops[0].at][1] < 103


def test_zones_are_seen_in_one_go():
    space = hall([(0, 0), (20, 0), (20, 10), (0, 10)], [{"at": (0, 5)}, {"at": (20, 5)}])
    spots = [(4 + 4 * k, y) for k in range(4) for y in (2, 8)]
    things = [
        group(f"{'ab'[y > 5]}{k}", [(x, y, 0.0)], zone="ab"[y > 5])
        for k, (x, y) in enumerate(spots)
    ]
    found, pieces = walk(space, things)
    check_tour(found, space, pieces)
    zones = [name[0] for name in names(found)]
    assert len(zones) == 8
    assert sum(a != b for a, b in itertools.pairwise(zones)) == 1
    again = walk(space, things)[0]
    assert (again.points == found.points).all()


@pytest.mark.parametrize("quarters", [1, 2, 3])
def test_turning_the_hall_turns_the_tour(quarters):
    turn = np.array([[0.0, -1.0], [1.0, 0.0]])
    turn = np.linalg.matrix_power(turn, quarters)

    def turned(points):
        return (np.array(points, float) @ turn.T).round(9)

    def build(by, heading):
        outline = by([(0, 0), (14, 0), (14, 8), (0, 8)]).tolist()
        ends = by([(0, 2.03), (14, 5.53)]).tolist()
        space = hall(outline, [{"at": at, "width": 1.3} for at in ends])
        spots = by([(4.02, 2.51), (9.53, 5.04)]).tolist()
        things = [group(f"g{k}", [(*at, heading)]) for k, at in enumerate(spots)]
        ends = by([(7, 0), (7, 4.6), (7, 6.4), (7, 8)]).tolist()
        return walk(space, things, [partition(*ends[0], *ends[1]), partition(*ends[2], *ends[3])])

    (plain, _), (other, _) = build(np.array, 0.0), build(turned, quarters * np.pi / 2)
    assert names(plain) == names(other)
    lines = shapely.LineString(turned(plain.points)), shapely.LineString(other.points)
    assert shapely.length(lines[0]) == pytest.approx(shapely.length(lines[1]), rel=0.01)
    assert shapely.hausdorff_distance(*lines) < 0.2
