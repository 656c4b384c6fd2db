"""The methods halls are compared with: what they cost adds up, what they return stands."""

from __future__ import annotations

import math
import sys

import numpy as np
import pytest
import shapely
import shapely.affinity
from benchmarks.hall_instances import example_hall
from benchmarks.shapely_hall import ShapelyHall, grown
from benchmarks.shapely_home import rectangle

from deadline import within
from scenewright.core.errors import InputError
from scenewright.domains.hall.energy import make_state, prepare
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.blocks import UNIT, GroupBlock, main_direction, sheet_of
from scenewright.domains.hall.solvers.cells import (
    CellObjects,
    boxes_in,
    divide,
    misfit,
    options_for,
    rooms_of,
)
from scenewright.domains.hall.solvers.chains import begin_chain, first_layout
from scenewright.domains.hall.solvers.genetic import decode, evaluate_genes, genetic_hall, violation
from scenewright.domains.hall.solvers.merrell import merrell, sweep
from scenewright.domains.hall.solvers.miqp import miqp
from scenewright.domains.hall.solvers.objects import (
    TRIES,
    boxes_of,
    cover_obstacles,
    drop,
    lay,
    make_ways,
)
from scenewright.domains.hall.solvers.outcome import HallRun
from scenewright.domains.hall.solvers.random_search import random_hall
from scenewright.domains.hall.terms.guidelines import off_balance, regions, whole_cost
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams
from scenewright.engine.guidelines import BALANCE, CIRCULATION
from scenewright.engine.solve import Budget
from thoroughness import only_thorough

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
    tally = np.array(
        [energy, BALANCE * off_balance(s, MIDDLE), CIRCULATION * (regions(ways) - 1), energy]
    )
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


def test_blocks_and_cells_keep_every_rule_and_their_clearances() -> None:
    pytest.importorskip("ortools", reason="needs the extra 'solve'")
    problem = example_hall()
    found = miqp(problem, Budget(), 0)
    assert found.evaluations == 2000
    assert broken(problem, found.boxes) < 2e-4
    assert np.allclose(found.boxes[:, 3:], problem.units.sizes)
    clears = [rectangle(grown(b, c)) for b, c in zip(found.boxes, problem.units.clear, strict=True)]
    shared = sum(a.intersection(b).area for k, a in enumerate(clears) for b in clears[:k])
    assert shared < 0.5  # of more than 100 m²
    assert np.array_equal(found.boxes, miqp(problem, Budget(), 0).boxes)
    row = found.boxes[slice(*problem.units.spans[1])]
    backs = row[:, :2] - 0.5 * row[:, 4:] * np.stack([np.cos(row[:, 2]), np.sin(row[:, 2])], 1)
    walls = shapely.LinearRing([(0, 0), (24, 0), (24, 10), (20, 14), (0, 14)])
    assert shapely.distance(shapely.points(backs), walls).max() < 0.005


@pytest.mark.parametrize("turned", [False, True])
def test_objects_stand_in_the_middle_of_their_cells_with_their_clearances(turned: bool) -> None:
    members = CellObjects(np.array([[1.0, 0.5]] * 3), np.array([[0.8, 0.4, 0.2, 0.0]] * 3))
    options = [o for o in options_for(members, 1.0) if o.turned == turned and o.columns == 2]
    block = GroupBlock(5, 7, options[0].width, options[0].height, options[0])
    cells = divide(block, members, np.random.default_rng(0))
    even = tuple(np.linspace(cut[0], cut[-1], len(cut)) for cut in cells.cuts)
    cells = cells._replace(levels=np.linspace(0.0, cells.levels[-1], 3), cuts=even)
    for quarter in (0, 2) if turned else (1, 3):
        boxes = boxes_in(cells, block, members, quarter * math.pi / 2)
        for box, clear, (x, y, w, h) in zip(
            boxes[cells.order], members.clear, rooms_of(cells), strict=True
        ):
            whole = rectangle(grown(box, clear))
            cell = shapely.box(x, y, x + w, y + h)
            cell = shapely.affinity.translate(cell, UNIT * block.x, UNIT * block.y)
            assert whole.difference(cell).area < 0.02
            assert whole.centroid.distance(cell.centroid) < 1e-6


def test_cells_an_object_does_not_fit_are_refused() -> None:
    members = CellObjects(np.ones((2, 2)), np.zeros((2, 4)))
    block = GroupBlock(0, 0, 30, 12, options_for(members, 0.0)[-1]._replace(columns=2, rows=1))
    cells = divide(block, members, np.random.default_rng(1))
    assert math.isfinite(misfit(cells, block, members))
    narrow = cells._replace(cuts=(np.array([0.0, 0.9, 3.0]),))
    assert misfit(narrow, block, members) == math.inf


def test_blocks_follow_a_turned_hall() -> None:
    pytest.importorskip("ortools", reason="needs the extra 'solve'")
    problem, angle = example_hall(), 0.4
    turn = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    edges = problem.ground.zone_edges.copy()
    for columns in (slice(0, 2), slice(2, 4)):
        edges[:, columns] = edges[:, columns] @ turn
    assert main_direction(edges) == pytest.approx(angle, abs=0.05)
    floor = shapely.Polygon([(0, 0), (6, 0), (9, 4), (0, 4)])
    sheet = sheet_of(shapely.affinity.rotate(floor, angle, (0, 0), use_radians=True), angle)
    taken = [shapely.box(*row) for row in sheet.taken]
    free = shapely.box(0, 0, sheet.width, sheet.height).difference(shapely.union_all(taken))
    free = shapely.affinity.scale(free, UNIT, UNIT, origin=(0, 0))
    moved = shapely.affinity.translate(floor, -sheet.x, -sheet.y)
    assert free.difference(moved.buffer(1e-6)).area < 1e-4  # on the safe side
    assert free.area > 0.9 * floor.area


def test_a_zone_without_room_keeps_its_first_layout() -> None:
    pytest.importorskip("ortools", reason="needs the extra 'solve'")
    problem = example_hall()
    units = problem.units._replace(sizes=problem.units.sizes * 4.0)
    start = np.column_stack([np.full((38, 2), 3.0), np.zeros(38), units.sizes])
    kept = miqp(problem._replace(units=units), Budget(), 0, start=start)
    assert np.array_equal(kept.boxes[9 + 8 :], start[9 + 8 :])


def test_without_ortools_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in ("ortools", "ortools.sat", "ortools.sat.python"):
        monkeypatch.setitem(sys.modules, name, None)
    with pytest.raises(InputError, match=r"ortools.*scenewright\[solve\]"):
        miqp(example_hall(), Budget(), 0)


def started(seed: int) -> tuple[HallProblem, Kept, float]:
    """The example with the route weighed, a first layout and its energy."""
    problem = example_hall()
    problem = problem._replace(weights=problem.weights | {"reach": 30.0})
    start, left = first_layout(problem, np.zeros((1, 2)), seed)
    assert not left
    return problem, start, float(begin_chain(problem, start, streams(0, 1)[0]).tally[0])


@pytest.mark.parametrize(("solve", "steps"), [(random_hall, 2000), (genetic_hall, 20_000)])
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=only_thorough)])
def test_random_and_genetic_layouts_stand_and_are_better_than_the_first(
    solve: HallRun, steps: int, seed: int
) -> None:
    problem, start, first = started(seed)
    found = solve(problem, start, Budget(steps=steps), seed, None, None)
    assert 0.9 * steps < found.evaluations <= steps, "what was known is not asked again"
    assert broken(problem, found.layouts[0].boxes) < 2e-4
    assert found.layouts[0].energy < first
    again = solve(problem, start, Budget(steps=steps), seed, None, None)
    assert np.array_equal(found.layouts[0].boxes, again.layouts[0].boxes)


def test_broken_layouts_cost_by_the_area_that_breaks_rules() -> None:
    problem, start, _ = started(0)
    chain, hall = begin_chain(problem, start, streams(0, 1)[0]), ShapelyHall(problem)
    genes = np.random.default_rng(0).random((8, 5 * 6))
    for row, cost in zip(genes, evaluate_genes(chain, genes), strict=True):
        decode(chain.p, chain.s, row.reshape(5, 6))
        area = violation(chain.p, chain.s, chain.work)
        shapes = [rectangle(box) for box in boxes_of(chain.s)]
        zones = [hall.zones[problem.units.zones[unit]] for unit in hall.owner]
        exact = sum(s.difference(z).area for s, z in zip(shapes, zones, strict=True))
        exact += sum(a.intersection(b).area for k, a in enumerate(shapes) for b in shapes[:k])
        exact += sum(a.intersection(b).area for a in shapes for b in hall.obstacles)
        exact += sum(a.intersection(b).area for a in shapes for b in hall.keep_free)
        assert area == pytest.approx(exact, abs=1e-6)
        assert cost == pytest.approx(1e5 * (1.0 + area))


def test_budgets_in_seconds_are_kept() -> None:
    problem, start, _ = started(0)
    for solve in (random_hall, genetic_hall):
        with within(60):
            solve(problem, start, Budget(seconds=0.1), 0)
