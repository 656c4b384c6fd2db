"""The methods halls are compared with: what they cost adds up, what they return stands."""

from __future__ import annotations

import math

import numpy as np
import pytest
from benchmarks.hall_instances import example_hall
from benchmarks.shapely_hall import ShapelyHall
from benchmarks.shapely_home import rectangle

from scenewright.hall_energy import make_state, prepare
from scenewright.hall_problem import HallProblem
from scenewright.solve import Budget
from scenewright.solvers.draws import streams
from scenewright.solvers.hall_merrell import merrell, sweep
from scenewright.solvers.hall_objects import TRIES, boxes_of, cover_obstacles, drop, lay, make_ways
from scenewright.terms.guidelines import BALANCE, CIRCULATION, off_balance, regions, whole_cost

MIDDLE = np.array([12.0, 7.0])


def broken(problem: HallProblem, boxes: np.ndarray) -> float:
    """The greatest area by which a hard rule is broken, by exact polygons."""
    hall = ShapelyHall(problem)
    shapes = [rectangle(box) for box in boxes]
    return max(hall.violations(shapes, hall.obstacles + hall.keep_free).values())


def test_objects_are_dropped_clear_of_each_other() -> None:
    problem = example_hall()
    p, ways = prepare(problem), make_ways(problem)
    s = make_state(p)
    assert drop(p, s, ways, TRIES, streams(3, 1)[0]) == 0
    boxes = boxes_of(s)
    assert broken(problem, boxes) < 2e-4
    assert np.allclose(boxes[:, 3:], problem.units.sizes)


def test_regions_are_counted_where_walls_and_objects_part_them() -> None:
    problem = example_hall()
    p, ways = prepare(problem), make_ways(problem)
    assert regions(ways) == 1
    barrier = np.tile([6.0, 20.0, 0.0, 1.0, 1.0], (38, 1))
    s = make_state(p)
    lay(p, s, ways, barrier)
    assert regions(ways) == 1  # they lie outside
    p.sizes[0] = 14.0, 0.4  # one object from wall to wall
    barrier[0] = 8.0, 7.0, 0.0, 14.0, 0.4
    lay(p, s, ways, barrier)
    assert regions(ways) == 2
    barrier[0, 1] = 20.0
    lay(p, s, ways, barrier)
    assert regions(ways) == 1


@pytest.mark.parametrize("heat", [1000.0, 1.0])
def test_moves_add_up_to_the_cost_of_the_whole(heat: float) -> None:
    problem = example_hall()
    p, ways, stream = prepare(problem), make_ways(problem), streams(5, 1)[0]
    s, doors = make_state(p), np.asarray(problem.ground.doors)
    cover_obstacles(p, ways)
    drop(p, s, ways, TRIES, stream)
    energy = whole_cost(p, s, ways, MIDDLE, doors)
    tally = np.array([energy, BALANCE * off_balance(s, MIDDLE),
                      CIRCULATION * (regions(ways) - 1), energy])  # fmt: skip
    best = s.frames.copy()
    sweep(p, s, ways, stream, 3000, heat, 1.0, MIDDLE, doors, tally, best)
    assert tally[0] == pytest.approx(whole_cost(p, s, ways, MIDDLE, doors), abs=1e-6)
    assert tally[3] <= energy
    lay(p, s, ways, boxes_of(s._replace(frames=best)))
    assert tally[3] == pytest.approx(whole_cost(p, s, ways, MIDDLE, doors), abs=1e-6)


def test_annealing_ends_with_what_stands_and_depends_on_the_seed_alone() -> None:
    problem = example_hall()
    found = merrell(problem, Budget(steps=40_000), 2)
    assert found.evaluations == 40_000
    assert broken(problem, found.boxes) < 0.01
    again = merrell(problem, Budget(steps=40_000), 2)
    assert np.array_equal(found.boxes, again.boxes)
    assert found.energy == again.energy
    rows = found.boxes[slice(*problem.units.spans[1])]  # wall cases
    assert np.minimum(rows[:, 2] % (math.pi / 2), -rows[:, 2] % (math.pi / 2)).max() < 0.05


def test_annealing_starts_from_the_boxes_it_is_given() -> None:
    problem = example_hall()
    first = merrell(problem, Budget(steps=38), 0)
    kept = merrell(problem, Budget(steps=1), 1, start=first.boxes)
    assert kept.energy <= first.energy + 1e-9
