"""The term of balance: the same as a plain sum, also while a chain moves items one by one."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from rooms import full_problem, random_layouts
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.anneal import anneal
from scenewright.engine.solve import Budget


def only() -> Problem:
    return full_problem()._replace(weights={"balance": 1.0})


def plain(problem: Problem, boxes: np.ndarray) -> float:
    """Areas and middles of items and fixed pieces about the centroid of the exact polygon."""
    floor = shapely.get_parts(
        shapely.polygonize([shapely.LineString([e[:2], e[2:]]) for e in problem.ground.edges])
    )
    room = max(floor, key=lambda part: part.envelope.area)
    everything = np.concatenate([boxes, problem.ground.obstacles])
    areas = everything[:, 3] * everything[:, 4]
    middle = areas @ everything[:, :2] / areas.sum() - np.array(room.centroid.coords[0])
    return float(np.hypot(*middle) / np.sqrt(room.area))


def test_it_is_the_plain_sum() -> None:
    problem = only()
    layouts = random_layouts(problem, 50)
    told = evaluate(problem, layouts)
    assert told == pytest.approx([plain(problem, boxes) for boxes in layouts], rel=1e-9)


def test_pieces_about_the_middle_are_in_balance() -> None:
    """Two like pieces on either side of the centroid; a third one beside them is not."""
    problem = only()
    ground = problem.ground._replace(obstacles=np.zeros((0, 5)))
    boxes = np.array([[1.0, 1.0, 0.0, 1, 1], [2.0, 3.0, 0.5, 1, 1]] * 2)
    edges = ground.edges
    cross = edges[:, 0] * edges[:, 3] - edges[:, 2] * edges[:, 1]
    middle = cross @ (edges[:, :2] + edges[:, 2:]) / (3 * cross.sum())
    boxes[2:, :2] = 2 * middle - boxes[:2, :2]
    balanced = problem._replace(ground=ground)
    assert evaluate(balanced, boxes[None])[0] == pytest.approx(0.0, abs=1e-12)
    boxes[3, 0] += 0.5
    assert evaluate(balanced, boxes[None])[0] > 0.01


def test_a_chain_arrives_at_the_energy_measured_afresh_and_in_balance() -> None:
    """The solver's own sums while it moves one item at a time; alone, the term is brought to 0."""
    found = anneal(only(), Budget(steps=20_000, threads=1), 1).layouts[0]
    assert found.energy == pytest.approx(evaluate(only(), found.boxes[None])[0], abs=1e-9)
    assert found.energy < 1e-3


def test_the_default_weighs_it_and_the_papers_do_not() -> None:
    assert PRESETS["default"].weights["balance"] > 0
    assert "balance" not in PRESETS["paper"].weights
    assert "balance" not in PRESETS["paper-repaired"].weights
