"""Terms of the picture a room makes, against slow exact references."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from rooms import full_problem, random_layouts
from scenewright.core.layout import corners
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.terms.focus import HIDING, TALL


def _only(name: str):
    return full_problem()._replace(weights={name: 1.0})


def _shapes(boxes):
    return [shapely.Polygon(c) for c in corners(boxes)]


def _floor(problem):
    rings = shapely.polygonize([shapely.LineString(e.reshape(2, 2)) for e in problem.ground.edges])
    whole = max(rings.geoms, key=lambda g: g.area)
    return whole.difference(shapely.union_all(_shapes(problem.ground.obstacles)))


def test_largest_void_is_the_largest_empty_circle_but_for_the_grid():
    problem = _only("largest_void")
    floor = _floor(problem)
    whole = shapely.maximum_inscribed_circle(floor, tolerance=0.005).length
    for boxes in random_layouts(problem, 25):
        free = floor.difference(shapely.union_all(_shapes(boxes)))
        exact = shapely.maximum_inscribed_circle(free, tolerance=0.005).length / whole
        assert evaluate(problem, boxes[None])[0] == pytest.approx(exact, abs=0.11)


def test_a_piece_in_the_widest_place_makes_the_void_smaller():
    problem = _only("largest_void")
    boxes = np.tile((-9.0, -9.0, 0.0, 1.0, 1.0), (4, 1))
    assert evaluate(problem, boxes[None])[0] == pytest.approx(1.0)
    boxes[0, :2] = 3.0, 1.6
    assert evaluate(problem, boxes[None])[0] < 0.95


def test_focal_sight_is_the_length_of_sight_within_tall_pieces():
    problem = _only("focal_sight")
    ground, items = problem.ground, problem.items
    for boxes in random_layouts(problem, 40):
        shapes, total = _shapes(boxes), 0.0
        spots = [(None, tuple(w[:2])) for w in ground.windows]
        spots += [(k, tuple(boxes[k, :2])) for k in np.flatnonzero(items.main_wall)]
        for door in ground.doors:
            hidden = [
                sum(
                    shapely.LineString([door[:2], at]).intersection(shapes[j]).length
                    for j in np.flatnonzero(items.height > TALL)
                    if j != goal
                )
                for goal, at in spots
            ]
            total += min(1.0, min(hidden) / HIDING) / len(ground.doors)
        assert evaluate(problem, boxes[None])[0] == pytest.approx(total, abs=1e-6)


def _mirrored(points, axis):
    """Points (n, 2) over the line through a box along its heading, by a matrix."""
    way = np.array([np.cos(axis[2]), np.sin(axis[2])])
    return axis[:2] + (points - axis[:2]) @ (2 * np.outer(way, way) - np.eye(2))


def test_axis_symmetry_looks_for_the_nearest_counterpart():
    problem = _only("axis_symmetry")
    (axis,) = np.flatnonzero(problem.items.main_wall < 0)
    others = [k for k in range(4) if k != axis]
    for boxes in random_layouts(problem, 40):
        images, areas = _mirrored(boxes[:, :2], boxes[axis]), boxes[:, 3:].prod(1)
        miss = [
            min(
                1.0,
                *(
                    np.hypot(*(images[j] - boxes[k, :2]))
                    + np.abs(boxes[j, 3:] - boxes[k, 3:]).sum()
                    for k in others
                ),
            )
            for j in others
        ]
        wanted = np.average(miss, weights=areas[others])
        assert evaluate(problem, boxes[None])[0] == pytest.approx(wanted, abs=1e-9)


HEARTH = np.array([[2.0, 0.5, np.cos(0.4), np.sin(0.4)]])


def test_the_axis_of_a_fireplace_counts_before_that_of_the_screen():
    problem = _only("axis_symmetry")
    problem = problem._replace(ground=problem.ground._replace(hearths=HEARTH))
    axis = np.array([2.0, 0.5, 0.4])
    for boxes in random_layouts(problem, 20):
        images, areas = _mirrored(boxes[:, :2], axis), boxes[:, 3:].prod(1)
        off = np.hypot(*(images[:, None] - boxes[None, :, :2]).transpose(2, 0, 1))
        unlike = np.abs(boxes[:, None, 3:] - boxes[None, :, 3:]).sum(2)
        wanted = np.average(np.minimum(1.0, (off + unlike).min(1)), weights=areas)
        assert evaluate(problem, boxes[None])[0] == pytest.approx(wanted, abs=1e-9)


def test_a_fireplace_is_something_to_look_at():
    problem = _only("focal_sight")
    bare = problem.ground._replace(windows=np.zeros((0, 6)))
    roles = problem.items._replace(main_wall=np.zeros(4))
    lit = problem._replace(items=roles, ground=bare._replace(hearths=HEARTH))
    apart = np.tile((-9.0, -9.0, 0.0, 1.0, 1.0), (4, 1))
    assert evaluate(lit, apart[None])[0] == 0.0
    tall = int(np.argmax(problem.items.height))
    apart[tall] = (2.0, 0.5, 0.0, 1.0, 1.0)
    assert evaluate(lit, apart[None])[0] == pytest.approx(1.0)


def test_pieces_in_pairs_about_the_screen_cost_nothing():
    problem = _only("axis_symmetry")
    boxes = np.array([[2, 3, 0, 1, 1], [0.2, 3, 0, 1, 0.4], [1, 4, 0, 1, 0.5], [1, 2, 0, 1, 0.5]])
    assert evaluate(problem, boxes[None])[0] == pytest.approx(0.0, abs=1e-9)
    boxes[3, 1] -= 0.5
    assert evaluate(problem, boxes[None])[0] > 0.1


@pytest.mark.parametrize(
    "name", ["largest_void", "focal_sight", "axis_symmetry", "shared_lines", "wall_proportion"]
)
def test_they_count_where_they_are_asked_for_only(name):
    from scenewright.domains.home.presets import PRESETS

    assert name not in PRESETS["default"].weights
    problem = full_problem()
    without = problem._replace(weights={k: w for k, w in problem.weights.items() if k != name})
    boxes = random_layouts(problem, 5)
    difference = evaluate(problem, boxes) - evaluate(without, boxes)
    alone = evaluate(_only(name), boxes)
    assert difference == pytest.approx(60.0 * alone, abs=1e-6)


def _lines(box):
    """Where the left edge, axis and right edge of a box are, across its heading."""
    across = np.array([-np.sin(box[2]), np.cos(box[2])])
    return box[:2] @ across + np.array([-0.5, 0.0, 0.5]) * box[3], across


def test_shared_lines_is_the_least_distance_of_edges_and_axes():
    problem = _only("shared_lines")
    lit = problem.ground.strips[problem.ground.strips[:, 5] == 1.0]
    rng = np.random.default_rng(3)
    for boxes in random_layouts(problem, 40):
        boxes[:, 2] = rng.integers(0, 4, len(boxes)) * np.pi / 2
        total = 0.0
        for j, box in enumerate(boxes):
            mine, across = _lines(box)
            others = [b for k, b in enumerate(boxes) if k != j]
            near = [b for b in others if abs(np.cos(b[2] - box[2])) > 0.99]
            theirs = [b[:2] @ across + e * b[3] for b in near for e in (-0.5, 0.0, 0.5)]
            theirs += [w[:2] @ across for w in lit if abs(np.cos(w[2] - box[2])) > 0.99]
            gaps = np.abs(mine[:, None] - np.array(theirs)[None])
            total += min(1.0, gaps.min() / 0.5) if theirs else 0.0
        assert evaluate(problem, boxes[None])[0] == pytest.approx(total / len(boxes), abs=1e-9)


def test_conversation_asks_for_distance_and_for_looks():
    names = ("seating", "screen", "reading", "table")
    problem = full_problem()._replace(weights={"conversation": 1.0}, names=names)
    boxes = np.tile((3.0, 3.0, 0.0, 1.0, 1.0), (4, 1))
    boxes[0], boxes[2] = (0.5, 1.0, 0.0, 1.0, 1.0), (3.0, 1.0, np.pi, 1.0, 1.0)
    together = evaluate(problem, boxes[None])[0]
    boxes[2, 0] += 3.0
    far = evaluate(problem, boxes[None])[0]
    boxes[2, 2] = 0.0
    turned = evaluate(problem, boxes[None])[0]
    assert together == pytest.approx(0.0, abs=1e-9)
    assert far == pytest.approx(2 * (4.5 - 2.4) / 2.4, abs=1e-9)
    assert turned > far
    alone = problem._replace(names=("seating", "screen", "shelf", "table"))
    assert evaluate(alone, boxes[None])[0] == 0.0


def test_wall_proportion_is_right_from_half_to_five_sixths():
    problem = _only("wall_proportion")
    roles = np.flatnonzero(problem.items.main_wall)
    walls = [shapely.LineString(w.reshape(2, 2)) for w in problem.ground.walls]
    along = problem.ground.walls[:, 2:] - problem.ground.walls[:, :2]
    normals = np.arctan2(along[:, 0], -along[:, 1])
    for boxes in random_layouts(problem, 40):
        backs = boxes[:, :2] - np.stack([np.cos(boxes[:, 2]), np.sin(boxes[:, 2])], 1) * (
            boxes[:, 4:] / 2
        )
        off = []
        for j in roles:
            far = [wall.distance(shapely.Point(backs[j])) for wall in walls]
            turn = 1.0 - np.cos(boxes[j, 2] - normals)
            share = boxes[j, 3] / walls[int(np.argmin(far + turn))].length
            off.append(min(1.0, 2 * max(0.0, 0.5 - share, share - 5 / 6)))
        assert evaluate(problem, boxes[None])[0] == pytest.approx(np.mean(off), abs=1e-9)
