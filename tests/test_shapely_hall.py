"""The slow reference of the hall's energies, on cases small enough to work out by hand."""

from __future__ import annotations

import math

import numpy as np
import pytest
from benchmarks.hall_instances import PAPER, example_hall, ring
from benchmarks.shapely_hall import Laid, ShapelyHall, barrier, energies, grown, neighbours, polygon
from benchmarks.shapely_hall_steps import draw_hall, judge, metropolis

from scenewright.domains.hall.problem import HallGround, HallProblem, Units

NONE = np.zeros((0, 5))
AHEAD = (1.0, 0.0, 0.0, 0.0)


def hall(
    spans: list[tuple[int, int]],
    zones: list[int],
    clear: tuple[float, ...] = AHEAD,
    **changed: object,
) -> HallProblem:
    """10 m by 6 m, zones of 5 m each side by side, unit squares as objects."""
    n = spans[-1][1]
    west, east = ring([(0, 0), (5, 0), (5, 6), (0, 6)]), ring([(5, 0), (10, 0), (10, 6), (5, 6)])
    ground = HallGround(
        edges=ring([(0, 0), (10, 0), (10, 6), (0, 6)]),
        obstacles=NONE,
        keep_free=NONE,
        doors=NONE,
        zone_edges=np.vstack([west, east]),
        zone_spans=np.array([[0, 4], [4, 8]]),
        zone_areas=np.array([30.0, 30.0]),
        zone_bounds=np.array([[0, 0, 5, 6], [5, 0, 10, 6.0]]),
        zone_least=np.array([0.05, 0.05]),
        stretches=np.zeros((0, 6)),
        borders=np.array([[5.0, 0.0, 5.0, 6.0, 0.0]]),
        links=np.array([[0.0, 1.0, 1.2]]),
        hosts=np.zeros((0, 6)),
        bounds=np.array([0, 0, 10, 6.0]),
    )._replace(**changed)
    units = Units(
        np.ones((n, 2)),
        np.tile(clear, (n, 1)),
        np.ones((n, 4), np.int64),
        np.array(spans),
        np.array(zones),
        np.ones((len(spans), 8), np.int64),
        np.arange(len(spans)),
        np.full(len(spans), -1),
    )
    return HallProblem(ground, units, ("a", "b")[: len(spans)], ("w", "e"), dict(PAPER), 0.9)


def boxes(*poses: tuple[float, float, float]) -> np.ndarray:
    return np.array([[*pose, 1.0, 1.0] for pose in poses])


def space(share: float) -> float:
    """E_s for a share of the clearance that is covered."""
    return barrier(1.5 - 3.0 / (1.0 + math.exp(-share)))


def test_barrier_and_growth() -> None:
    assert barrier(0.0) == pytest.approx(20.0)
    assert barrier(-2.0) == pytest.approx(1.0 / (math.hypot(2.0, 0.05) - 2.0), rel=1e-9)
    box = grown(np.array([1.0, 2.0, math.pi / 2, 1.0, 1.0]), np.array([1.0, 0.4, 0.0, 0.2]))
    assert box == pytest.approx([0.9, 2.5, math.pi / 2, 1.6, 2.0])  # left of north is west


def test_polygons_keep_their_holes() -> None:
    edges = np.vstack(
        [ring([(0, 0), (4, 0), (4, 4), (0, 4)]), ring([(1, 1), (1, 2), (2, 2), (2, 1)])]
    )
    assert polygon(edges).area == pytest.approx(15.0)


def test_neighbours_in_layers_and_first_to_first() -> None:
    assert sorted(neighbours((3, 2), 4)) == [(4, 5), (4, 7), (5, 6), (7, 8)]


def test_clearance_shared_with_others_walls_and_solids() -> None:
    problem = hall([(0, 1), (1, 2)], [0, 0])
    free = energies(problem, boxes((2, 1, 0), (2, 4, 0)), [Laid("chain", 0, (1,))] * 2, NONE)
    assert free["space/0"] == pytest.approx(20.0)
    # both look at each other over 1.5 m: clearances of 1 m² overlap by 0.5 m²
    facing = [Laid("chain", 0, (1,)), Laid("chain", math.pi, (1,))]
    met = energies(problem, boxes((1, 3, 0), (3.5, 3, math.pi)), facing, NONE)
    assert met["space/0"] == met["space/1"] == pytest.approx(space(0.5))
    # 0.25 m of the clearance lies behind the north wall
    wall = energies(problem, boxes((2, 4.75, math.pi / 2), (2, 1, 0)), facing, NONE)
    assert wall["space/0"] == pytest.approx(space(0.25))
    door = hall([(0, 1), (1, 2)], [0, 0], keep_free=np.array([[2.9, 1.0, 0.0, 1.0, 0.6]]))
    kept = energies(door, boxes((2, 1, 0), (2, 4, 0)), facing, NONE)
    assert kept["space/0"] == pytest.approx(space(0.6))
    built = energies(problem, boxes((2, 1, 0), (2, 4, 0)), facing, np.array([[3.0, 1, 0, 2, 0.2]]))
    assert built["space/0"] == pytest.approx(space(0.2))


def test_clearance_shared_within_a_unit_counts_once() -> None:
    problem = hall([(0, 2)], [0])
    found = energies(problem, boxes((1, 3, 0), (3.5, 3, math.pi)), [Laid("grid", 0, (2,))], NONE)
    assert found["space/0"] == pytest.approx(space(0.5 / 2.0))


def test_fill_uses_the_extent_of_patterns_and_clearances_of_rows() -> None:
    problem = hall([(0, 2)], [0])
    placed = boxes((1, 1, 0), (3, 3, 0))  # clearances to x = 4.5 and y = 3.5 from 0.5
    rows = energies(problem, placed, [Laid("chain", 0, (2,))], NONE)
    loose = energies(problem, placed, [Laid("wall", 0, (2,))], NONE)
    assert rows["fill/0"] == pytest.approx(barrier(1.0 - 0.05 / (12.0 / 30.0)))
    assert loose["fill/0"] == pytest.approx(barrier(1.0 - 0.05 / (4.0 / 30.0)))
    assert "fill/1" not in rows
    turned = energies(problem, placed, [Laid("chain", math.pi / 2, (2,))], NONE)
    assert turned["fill/0"] == pytest.approx(rows["fill/0"])


def test_access_is_the_longest_free_run_of_the_border() -> None:
    problem = hall([(0, 2)], [0])
    laid = [Laid("chain", 0, (2,))]
    open_ = energies(problem, boxes((1, 3, 0), (1, 1, 0)), laid, NONE)
    assert open_["access"] == 0.0
    # a wall over the border leaves 0.7 m at its south and 0.5 m at its north end
    wall = np.array([[5.0, 3.1, 0.0, 4.8, 0.2]])
    shut = energies(problem, boxes((1, 3, 0), (1, 1, 0)), laid, wall)
    assert shut["access/0"] == pytest.approx(math.exp(1.2 - 0.7) - 1.0)
    near = energies(problem, boxes((3.31, 3, 0), (1, 1, 0)), laid, NONE)  # 1.19 m off: in the way
    assert near["access"] == 0.0  # 2.5 m remain at either side
    narrow = hall([(0, 2)], [0], links=np.array([[0.0, 1.0, 3.0]]))
    met = energies(narrow, boxes((1.6, 3, 0), (1.51, 1, 0)), laid, NONE)
    assert met["access/0"] == pytest.approx(math.exp(3.0 - 2.5) - 1.0)


def test_proportion_grows_when_neighbours_part() -> None:
    problem = hall([(0, 2)], [0])
    laid = [Laid("chain", 0, (2,))]
    near = energies(problem, boxes((1, 1, 0), (1, 4, 0)), laid, NONE)
    assert near["proportion/0"] == pytest.approx(barrier(1.0))
    far = energies(problem, boxes((1, 1, 0), (7, 1, 0)), laid, NONE)  # 5 m apart, 3 m allowed
    assert far["proportion/0"] == pytest.approx(barrier(1.0 - 2.0 / 3.0))
    assert (
        energies(problem, boxes((1, 1, 0), (7, 1, 0)), [Laid("wall", 0, (2,))], NONE)["proportion"]
        == 0.0
    )


def test_hard_rules_tell_the_greatest_areas() -> None:
    problem = hall([(0, 2)], [0], obstacles=np.array([[1.0, 1.0, 0.0, 1.0, 1.0]]))
    laid = [Laid("chain", 0, (2,))]
    found = energies(problem, boxes((4.75, 3, 0), (4.5, 3.5, 0)), laid, NONE)
    assert found["outside"] == pytest.approx(0.25)
    assert found["overlap"] == pytest.approx(0.75 * 0.5)
    assert found["blocked"] == 0.0
    assert energies(problem, boxes((1.5, 1, 0), (3, 3, 0)), laid, NONE)["blocked"] == 0.5


def test_the_total_weighs_the_sums() -> None:
    problem = hall([(0, 2)], [0])._replace(weights={"space": 2.0, "fill": 0.5})
    found = energies(problem, boxes((1, 1, 0), (3, 3, 0)), [Laid("chain", 0, (2,))], NONE)
    assert found["total"] == pytest.approx(2.0 * found["space"] + 0.5 * found["fill"])
    assert found["space"] == pytest.approx(found["space/0"])


def test_plain_metropolis_keeps_the_rules_and_improves() -> None:
    problem = example_hall()
    reference = ShapelyHall(problem)
    before = judge(reference, problem, draw_hall(problem, reference, 1))
    best, energy, _ = metropolis(problem, 1, 60)
    after = judge(reference, problem, best)
    assert after["total"] == pytest.approx(energy)
    assert energy < before["total"]
    assert max(after[rule] for rule in ("outside", "overlap", "blocked")) < 1e-4
