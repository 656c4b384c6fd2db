"""The walking route against a slow exact reference on the same grid."""

from __future__ import annotations

from collections import deque

import numpy as np
import pytest
import shapely

from rooms import COLUMN, OUTLINE, full_problem, random_layouts, ring
from scenewright.core.layout import corners
from scenewright.domains.home.energy import evaluate, route_grid
from scenewright.domains.home.problem import Ground, Problem, empty_items
from scenewright.geometry.boxes import frames_of, make_frame
from scenewright.geometry.flood import flood
from scenewright.geometry.paths import RouteGrid, make_grid, rounded_span

CELL = 0.09  # no cell centre lies exactly at the radius from a wall


def unpacked(bits):
    """Bits (h, k) as booleans (h, 64 k), the first cell first."""
    places = np.arange(64, dtype=np.uint64)
    return ((bits[:, :, None] >> places) & np.uint64(1)).astype(bool).reshape(len(bits), -1)


def centres(grid):
    rows, words = grid.free.shape
    x = grid.x0 + (np.arange(64 * words) + 0.5) * grid.cell
    y = grid.y0 + (np.arange(rows) + 0.5) * grid.cell
    return shapely.points(*np.meshgrid(x, y))


def grown(free, start):
    """Breadth-first search over four neighbours."""
    reached, queue = start & free, deque(zip(*np.nonzero(start & free), strict=True))
    while queue:
        r, c = queue.popleft()
        for a, b in ((r + 1, c), (r - 1, c), (r, c + 1), (r, c - 1)):
            inside = 0 <= a < free.shape[0] and 0 <= b < free.shape[1]
            if inside and free[a, b] and not reached[a, b]:
                reached[a, b] = True
                queue.append((a, b))
    return reached


def shape(box):
    return shapely.Polygon(corners(np.array(box, float)))


def reference(problem, boxes):
    """Missed items and doors, by shapely distances and plain search."""
    grid, items, ground = route_grid(problem, CELL), problem.items, problem.ground
    points, door_shapes = centres(grid), [shape(box) for box in ground.doors]
    wide = ground.doors.copy()
    wide[:, 3] = np.maximum(wide[:, 3], 2 * (grid.radius + CELL))
    gaps = shapely.union_all([shape(box) for box in wide])
    walls = shapely.multilinestrings(shapely.linestrings(ground.edges.reshape(-1, 2, 2))) - gaps
    room = shapely.Polygon(OUTLINE, [COLUMN])
    free = shapely.contains(room, points) & (shapely.distance(walls, points) > grid.radius)
    doors = [shapely.contains(door, points) for door in door_shapes]
    free |= np.any(doors, axis=0)
    solids = []
    for box, (front, left, back, right) in zip(boxes, items.inset, strict=True):
        ahead = np.array([np.cos(box[2]), np.sin(box[2])])
        leftward = np.array([-ahead[1], ahead[0]])
        centre = box[:2] + ahead * (back - front) / 2 + leftward * (right - left) / 2
        solids.append([*centre, box[2], box[3] - left - right, box[4] - front - back])
    for box in [*ground.obstacles, *solids]:
        free &= shapely.distance(shape(box), points) > grid.radius
    reached = grown(free, doors[0])
    missed = sum(not (reached & door).any() for door in doors[1:])
    depth = problem.route_width / 2 + 0.2
    for box, access in zip(solids, items.access, strict=True):
        zones = []
        for side in np.flatnonzero(access):
            turn = box[2] + side * np.pi / 2
            far = (box[4] if side % 2 == 0 else box[3]) / 2 + depth / 2
            size = (box[3], depth) if side % 2 == 0 else (depth, box[4])
            x, y = box[0] + far * np.cos(turn), box[1] + far * np.sin(turn)
            zones.append(shape([x, y, box[2], *size]))
        missed += not any((reached & shapely.contains(zone, points)).any() for zone in zones)
    return missed


def test_route_agrees_with_the_reference():
    problem = full_problem()._replace(weights={"route": 1.0})
    problem = problem._replace(ground=problem.ground._replace(obstacles=np.zeros((0, 5))))
    layouts = random_layouts(problem, 60, seed=4)
    wanted = [reference(problem, boxes) for boxes in layouts]
    assert len(set(wanted)) >= 4
    assert evaluate(problem, layouts, CELL).tolist() == wanted


@pytest.mark.parametrize("words", [1, 2, 3])
def test_flood_agrees_with_breadth_first_search(words: int):
    rng = np.random.default_rng(words)
    for _ in range(20):
        free = rng.integers(0, 2**64, (2, 30, words), dtype=np.uint64)
        free = free[0] | free[1]
        start = np.zeros_like(free)
        start[rng.integers(30), rng.integers(words)] = np.uint64(2**63 + 2**40 + 1)
        wanted = grown(unpacked(free), unpacked(start))
        flood(start, free)
        assert (unpacked(start) == wanted).all()


def test_a_row_of_a_grown_box_is_its_exact_span():
    rng = np.random.default_rng(2)
    for _ in range(50):
        box = [*rng.uniform(-2, 2, 2), rng.uniform(0, 7), *rng.uniform(0.1, 3, 2)]
        radius, y = rng.uniform(0.1, 0.5), rng.uniform(-3, 3)
        row = shapely.LineString([(-9, y), (9, y)])
        cut = shape(box).buffer(radius, quad_segs=200).intersection(row)
        low, high = rounded_span(make_frame(*box), radius, y)
        if cut.is_empty:
            assert low > high or high - low < 0.02
        else:
            assert (low, high) == pytest.approx((cut.bounds[0], cut.bounds[2]), abs=0.02)


def corridor_problem(gap: float) -> tuple[Problem, np.ndarray]:
    """A room parted by two boxes with a gap between them; an item beyond."""
    edges = ring(np.array([[0, 0], [6, 0], [6, 3], [0, 3]], float))
    none = np.zeros((0, 5))
    ground = Ground(
        edges=edges,
        walls=edges,
        keep_free=none,
        use_space=none,
        obstacles=none,
        windows=np.zeros((0, 6)),
        doors=np.array([[-0.1, 1.5, 0.0, 0.9, 0.4]]),
        main_wall=np.zeros((0, 4)),
        bounds=np.array([0.0, 0, 6, 3]),
        area=18.0,
    )
    access = np.zeros((3, 4))
    access[2] = 1.0
    items = empty_items(3)._replace(access=access)
    part = 1.5 - gap / 2
    boxes = np.array(
        [[3, part / 2, 0, part, 0.5], [3, 3 - part / 2, 0, part, 0.5], [5, 1.5, 0, 1, 1]]
    )
    return Problem(ground, items, ("a", "b", "c"), {"route": 1.0}), boxes


@pytest.mark.parametrize(("gap", "missed"), [(0.55, 1), (0.75, 0), (1.2, 0), (0.0, 1)])
def test_route_needs_its_width(gap, missed):
    problem, boxes = corridor_problem(gap)
    assert evaluate(problem, boxes[None], 0.05)[0] == missed


def test_the_aisle_inside_an_item_can_be_walked():
    problem, boxes = corridor_problem(0.1)
    inset = np.zeros((3, 4))
    inset[0, 1] = 0.9  # the first box's left side, towards the gap
    walkable = problem._replace(items=problem.items._replace(inset=inset))
    assert evaluate(problem, boxes[None], 0.05)[0] == 1
    assert evaluate(walkable, boxes[None], 0.05)[0] == 0


def test_without_doors_everything_counts_as_reached():
    problem, boxes = corridor_problem(0.0)
    closed = problem._replace(ground=problem.ground._replace(doors=np.zeros((0, 5))))
    assert evaluate(closed, boxes[None])[0] == 0.0


def test_a_narrow_door_still_lets_one_in():
    problem, boxes = corridor_problem(1.2)
    narrow = np.array([[-0.1, 1.5, 0.0, 0.6, 0.3]])
    tight = problem._replace(ground=problem.ground._replace(doors=narrow))
    assert evaluate(tight, boxes[None], 0.1)[0] == 0.0


def test_grid_covers_the_doors():
    ground = full_problem().ground
    grid = make_grid(
        ground.edges, frames_of(ground.obstacles), frames_of(ground.doors), ground.bounds, 0.1, 0.6
    )
    assert isinstance(grid, RouteGrid)
    assert all(unpacked(door).sum() > 20 for door in grid.doors)
