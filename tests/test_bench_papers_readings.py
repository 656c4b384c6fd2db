"""Readings of the homes' paper: as we run it is the printed cost, others change what they say."""

from __future__ import annotations

import statistics

import numpy as np
import pytest
from benchmarks.papers_home_readings import (
    AGAINST,
    AS_RUN,
    LIVING,
    READINGS,
    first_layouts,
    genetic,
    make_cost,
    markdown_lines,
    records,
    turned,
    wall_gaps,
)
from benchmarks.papers_home_rooms import case_of

from scenewright.domains.home.encodings.boxes import gene_bounds, to_boxes
from scenewright.domains.home.energy import evaluate
from scenewright.domains.home.problem import Problem

WALL = np.array([[0.0, 0.0, 4.0, 0.0]])


@pytest.fixture(scope="module")
def problem() -> Problem:
    return case_of(LIVING[0]).problem


def test_as_run_is_the_printed_cost(problem: Problem) -> None:
    genes = first_layouts(problem, AS_RUN, 20, np.random.default_rng(3))
    assert make_cost(problem, AS_RUN)(genes) == pytest.approx(evaluate(problem, to_boxes(genes)))


def test_distances_of_c5() -> None:
    turned_away = np.array([[[2.0, 1.5, 0.0, 1.0, 2.0], [2.0, 0.45, np.pi / 2, 1.0, 0.8]]])
    of_edge = wall_gaps(turned_away, WALL, "edge")[0]
    assert of_edge == pytest.approx([1.0 - (0.1 / 1.0) ** 2, 0.0])
    through = np.array([[[2.0, 0.4, 0.0, 1.0, 2.0]]])
    assert wall_gaps(through, WALL, "edge")[0, 0] == wall_gaps(through, WALL, "patch")[0, 0] == 0.0
    ahead = np.array([[[2.0, 1.2, -np.pi / 2, 1.0, 2.0]]])
    assert wall_gaps(ahead, WALL, "edge")[0, 0] > 0.9
    assert wall_gaps(ahead, WALL, "patch")[0, 0] == pytest.approx(1.0 - (0.1 / 0.2) ** 2)


def test_first_layouts_at_walls_cost_nothing_there(problem: Problem) -> None:
    walls = AS_RUN._replace(start="walls")
    rng = np.random.default_rng(1)
    only = problem._replace(weights={AGAINST: 1.0})
    backed = first_layouts(problem, walls, 30, rng)
    assert make_cost(only, AS_RUN)(backed) == pytest.approx(0.0)
    assert ((backed[..., 2] >= 0.0) & (backed[..., 2] <= 2.0 * np.pi)).all()
    one = first_layouts(problem, AS_RUN._replace(start="one"), 30, rng)
    assert ((one != np.median(one, axis=0)).sum(axis=(1, 2)) <= 1).all()
    low, high = gene_bounds(problem)
    drawn = first_layouts(problem, AS_RUN, 30, rng)
    assert ((low <= drawn) & (drawn <= high)).all()
    quarter = turned(problem, AS_RUN._replace(quarters=True), drawn)[..., 2] / (np.pi / 2)
    assert np.allclose(quarter, np.round(quarter))


def test_first_layouts_at_walls_end_lower(problem: Problem) -> None:
    walls = AS_RUN._replace(start="walls")
    ends = [
        statistics.fmean(genetic(problem, r, seed) for seed in range(3)) for r in (AS_RUN, walls)
    ]
    assert ends[1] < 0.5 * ends[0]


def test_every_reading_has_its_line() -> None:
    assert len({reading.name for reading in READINGS}) == len(READINGS)
    told = list(records(quick=True))
    assert len(told) == 4
    assert len(list(markdown_lines(told))) == 4
