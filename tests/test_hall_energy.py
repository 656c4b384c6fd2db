"""The compiled energies of halls against the slow ones on shapely, and moves against afresh."""

from __future__ import annotations

import math

import numpy as np
import pytest
from benchmarks.hall_instances import example_hall
from benchmarks.shapely_hall import Laid, energies

from scenewright.domains.hall.energy import make_state, prepare
from scenewright.domains.hall.patterns import NUMBER, PATTERNS
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.guided_metropolis import move_wall
from scenewright.domains.hall.solvers.moves import reseed, scatter
from scenewright.domains.hall.solvers.start import copy_frames, place_units
from scenewright.domains.hall.terms.place import build
from scenewright.domains.hall.terms.state import PreparedHall, Scratch, State, make_scratch
from scenewright.domains.hall.terms.table import ACCESS, FILL, PROPORTION, SPACE
from scenewright.domains.hall.terms.trial import begin, judge, settle, undo
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import Stream, below, streams

ROWS = {"space": SPACE, "fill": FILL, "access": ACCESS, "proportion": PROPORTION}


def narrow(width: float) -> HallProblem:
    """The example with a passage so wide that rows and partitions block it."""
    problem = example_hall()
    return problem._replace(ground=problem.ground._replace(links=np.array([[0.0, 1.0, width]])))


def drawn(problem: HallProblem, seed: int) -> tuple[PreparedHall, State, Scratch, Stream] | None:
    """A random valid layout, with a partition for odd seeds."""
    p = prepare(problem)
    s, work, stream = make_state(p), make_scratch(p), streams(seed, 1)[0]
    s.partitions[0] = (1.0 + 0.1 * seed, 9.0) if seed % 2 else (0.0, 0.0)
    build(p, s, 0)
    placed = np.zeros(5)
    place_units(p, s, work, np.array([4, 3, 2, 0, 1]), 0, 3000, True, stream, placed)
    return (p, s, work, stream) if placed.all() else None


def told(problem: HallProblem, p: PreparedHall, s: State) -> dict[str, float]:
    """What the slow reference says of a state."""
    boxes, names = np.zeros((len(p.sizes), 5)), list(PATTERNS)
    copy_frames(s, boxes)
    laid = []
    for u, (row, _) in enumerate(p.layer_spans):
        numbers = s.layers[row : row + s.used[u], NUMBER]
        laid.append(Laid(names[s.code[u]], s.pose[u, 2], tuple(int(v) for v in numbers)))
    walls = s.walls[s.walls[:, 4] > 0.0]
    partitions = np.column_stack([walls[:, :2], walls[:, 7], 2 * walls[:, 4], 2 * walls[:, 5]])
    return energies(problem, boxes, laid, partitions)


@pytest.mark.parametrize("seed", range(12))
def test_kernels_agree_with_shapely(seed: int) -> None:
    problem = narrow(1.2 if seed < 6 else 4.0)
    found = drawn(problem, seed)
    if found is None:
        pytest.skip("no room for a first layout with this seed")
    p, s, work, _ = found
    total, slow = measure_all(p, s, work), told(problem, p, s)
    for name, row in ROWS.items():
        for key, cost in slow.items():
            if key.startswith(f"{name}/"):
                assert s.costs[row, int(key.split("/")[1])] == pytest.approx(cost, rel=1e-6), key
    assert total == pytest.approx(slow["total"], rel=1e-6)
    assert max(slow["outside"], slow["overlap"], slow["blocked"]) < 1e-4 + 1e-6 * 2.25


def test_blocked_passages_are_among_the_cases() -> None:
    costs = []
    for seed in range(6, 12):
        if found := drawn(narrow(4.0), seed):
            p, s, work, _ = found
            measure_all(p, s, work)
            costs.append(s.costs[ACCESS, 0])
    assert max(costs) > 0.1


@pytest.mark.parametrize("seed", [0, 1])
def test_what_moves_change_adds_up(seed: int) -> None:
    problem = narrow(3.0)
    found = drawn(problem, seed)
    assert found is not None
    p, s, work, stream = found
    energy, accepted = measure_all(p, s, work), 0
    for step in range(400):
        unit = below(stream, len(p.spans))
        begin(p, s, work, unit)
        if step % 3:
            scatter(p, s, unit, stream)
        else:
            codes = p.choices[unit].nonzero()[0]
            reseed(p, s, unit, codes[below(stream, len(codes))], step / 400, 1.0)
        change = judge(p, s, work, unit)
        if math.isfinite(change) and (change < 0.0 or step % 2):
            settle(p, s, work, unit)
            energy, accepted = energy + change, accepted + 1
        else:
            undo(p, s, work, unit)
    assert accepted > 5
    assert energy == pytest.approx(measure_all(p, s, work), rel=1e-9)
    assert energy == pytest.approx(told(problem, p, s)["total"], rel=1e-6)


def test_a_wall_that_stays_what_it_is_is_no_move() -> None:
    problem = narrow(1.2)
    found = drawn(problem, 1)
    assert found is not None
    p, s, work, stream = found
    s.partitions[0] = p.host_spans[0]
    build(p, s, 0)
    hosts = [move_wall(p, s, work, 0.0, stream, problem.settings.moves) for _ in range(50)]
    assert -1 in hosts
    for _ in range(200):
        before = s.partitions[0].copy()
        host = move_wall(p, s, work, 1.0, stream, problem.settings.moves)
        assert (host < 0) == bool((s.partitions[0] == before).all())
