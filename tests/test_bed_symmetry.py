"""The term of symmetry about a bed: the same as plain rays, and beds come to stand by it."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from rooms import full_problem, random_layouts
from scenewright.core.brief import Brief, Room
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.presets import PRESETS
from scenewright.domains.home.problem import Problem
from scenewright.domains.home.solvers.anneal import anneal
from scenewright.domains.home.solving import solve
from scenewright.domains.home.terms.bed_symmetry import AHEAD, FARTHEST, PARALLEL
from scenewright.engine.solve import Budget


def only() -> Problem:
    return full_problem()._replace(weights={"bed_symmetry": 1.0})


def plain(problem: Problem, boxes: np.ndarray) -> float:
    """The nearest edge along a ray to either side, by shapely; windows by their own axes."""
    edges = shapely.MultiLineString([(e[:2], e[2:]) for e in problem.ground.edges])
    windows = problem.ground.strips[problem.ground.strips[:, 5] == 1.0]
    total = 0.0
    for weight, box in zip(problem.items.symmetry, boxes, strict=True):
        ahead = np.array([np.cos(box[2]), np.sin(box[2])])
        aside = np.array([ahead[1], -ahead[0]])
        head = box[:2] + ahead * (AHEAD - box[4] / 2)
        gaps = [_gap(edges, head, way) for way in (aside, -aside)]
        off = [abs(gaps[0] - gaps[1]) / 2 if max(gaps) < np.inf else FARTHEST, FARTHEST]
        for window in windows:
            looks = np.array([np.cos(window[2]), np.sin(window[2])])
            if abs(looks @ ahead) > PARALLEL:
                off.append(abs((window[:2] - head) @ aside))
        total += weight * min(off)
    return total


def _gap(edges: shapely.MultiLineString, start: np.ndarray, way: np.ndarray) -> float:
    met = shapely.LineString([start, start + 50.0 * way]).intersection(edges)
    return float("inf") if met.is_empty else float(met.distance(shapely.Point(start)))


def test_it_is_what_plain_rays_find() -> None:
    problem = only()
    layouts = random_layouts(problem, 60)
    layouts[::2, :, 2] = np.round(layouts[::2, :, 2] / (np.pi / 2)) * np.pi / 2
    wanted = [plain(problem, boxes) for boxes in layouts]
    assert evaluate(problem, layouts) == pytest.approx(wanted, abs=1e-9)
    assert np.ptp(wanted) > 0.1


def test_small_rooms_have_no_floor_to_spare_beside_a_bed() -> None:
    problem = only()
    small = problem._replace(ground=problem.ground._replace(area=8.9))
    assert evaluate(small, random_layouts(problem, 20)) == pytest.approx(np.zeros(20))


def test_a_chain_arrives_at_the_energy_measured_afresh_and_in_symmetry() -> None:
    found = anneal(only(), Budget(steps=20_000, threads=1), 1).layouts[0]
    assert found.energy == pytest.approx(evaluate(only(), found.boxes[None])[0], abs=1e-9)
    assert found.energy < 1e-3


def test_a_double_bed_stands_in_the_middle_of_its_wall_between_two_nightstands() -> None:
    room = {
        "id": "bedroom",
        "function": "double_bedroom",
        "outline": [[0, 0], [4.0, 0], [4.0, 3.6], [0, 3.6]],
        "doors": [{"at": [0.0, 0.6], "width": 0.8}],
        "windows": [{"at": [4.0, 1.8], "width": 1.4}],
    }
    solution = solve(Brief(rooms=[Room.model_validate(room)]), seed=3, steps=3000)
    bed = next(p for p in solution.pieces if p.category == "double_bed")
    stands = [p for p in solution.pieces if p.category == "nightstand"]
    (first, second), at = stands, np.array(bed.pose[:2])
    gaps = [np.hypot(*(np.array(s.pose[:2]) - at)) for s in (first, second)]
    assert gaps[0] == pytest.approx(gaps[1], abs=1e-6)
    along = 1 if abs(np.cos(bed.pose.heading)) > 0.5 else 0
    middle = (2.0, 1.8)[along]
    assert at[along] == pytest.approx(middle, abs=0.25)


def test_the_default_weighs_it_and_the_papers_do_not() -> None:
    assert PRESETS["default"].weights["bed_symmetry"] > 0
    assert "bed_symmetry" not in PRESETS["paper"].weights
    assert "bed_symmetry" not in PRESETS["paper-repaired"].weights
