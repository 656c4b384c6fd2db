"""The contract of every term in the table, and what sets the printed and repaired forms apart."""

from __future__ import annotations

import numpy as np
import pytest
import shapely

from rooms import full_problem, random_layouts, ring, turned_boxes, turned_problem
from scenewright.core.errors import InputError
from scenewright.core.layout import corners
from scenewright.domains.home.energy import energies_of, evaluate, explain, prepare, route_grid
from scenewright.domains.home.terms import orientation, relations
from scenewright.domains.home.terms.table import TERMS, default_weights, read_weights
from scenewright.engine.rows import load_function
from scenewright.geometry.boxes import make_frame

ROWS = pytest.mark.parametrize("row", TERMS, ids=lambda row: f"{row.name}-{row.form}")


def only(row):
    """The full problem with one term weighed 1."""
    problem = full_problem(printed=row.form == "printed")
    return problem._replace(weights={row.name: 1.0})


@ROWS
def test_row_names_a_function_and_its_place(row):
    assert load_function(row.function).__doc__
    assert TERMS[row.number] is row


@ROWS
def test_term_matters(row):
    problem = only(row)
    energies = evaluate(problem, random_layouts(problem, 40))
    assert energies.min() >= 0.0
    assert np.ptp(energies) > 0.0


@ROWS
def test_term_does_not_care_where_the_world_lies(row):
    problem, shift = only(row), np.array([3.0, -7.0])
    layouts = random_layouts(problem, 30)
    angle = np.pi / 2 if row.name in ("route", "daylight") else 0.7  # the grid and span have axes
    moved = turned_problem(problem, angle, shift)
    there = evaluate(moved, turned_boxes(layouts, angle, shift))
    here = evaluate(problem, layouts)
    if row.name == "route":
        assert np.mean(there == here) > 0.8
    else:
        assert there == pytest.approx(here, abs=1e-9)


@ROWS
def test_term_does_not_care_about_the_order_of_items(row):
    problem, order = only(row), np.array([2, 0, 3, 1])
    items = problem.items
    arrays = {
        name: getattr(items, name)[order]
        for name in items._fields
        if name not in ("pairs", "pair_targets", "pair_weights", "placed", "places", "spots")
    }
    place = np.argsort(order)
    renamed = items._replace(**arrays, pairs=place[items.pairs], placed=place[items.placed])
    layouts = random_layouts(problem, 20)
    names = tuple(problem.names[k] for k in order)
    other = evaluate(problem._replace(items=renamed, names=names), layouts[:, order])
    assert other == pytest.approx(evaluate(problem, layouts), abs=1e-9)


@pytest.mark.parametrize("printed", [False, True])
def test_batch_is_the_same_as_one_at_a_time(printed):
    problem = full_problem(printed)
    layouts = random_layouts(problem, 20)
    alone = [float(evaluate(problem, layout[None])[0]) for layout in layouts]
    assert evaluate(problem, layouts).tolist() == alone


@pytest.mark.parametrize("printed", [False, True])
def test_explained_costs_sum_to_the_energy(printed):
    problem = full_problem(printed)
    for layout in random_layouts(problem, 10):
        parts = explain(problem, layout, cell=0.1)
        assert sum(part.cost for part in parts) == pytest.approx(evaluate(problem, layout[None])[0])
        assert {part.term for part in parts} <= set(default_weights(printed))
        assert all(part.cost == pytest.approx(part.value * part.weight) for part in parts)


def test_explanation_names_items_and_pairs():
    problem = full_problem()._replace(weights={"overlap": 600.0, "boundary": 5000.0})
    boxes = np.array([[1, 1, 0, 1, 1], [1.5, 1, 0, 1, 1], [9, 9, 0, 1, 1], [3, 1, 0, 1, 1]], float)
    found = {(part.item, part.term): part.value for part in explain(problem, boxes)}
    assert found == {
        ("seating & screen", "overlap"): pytest.approx(0.5 / 4),
        ("shelf", "boundary"): pytest.approx(1 / 4),
    }


def test_unknown_weight_is_told():
    with pytest.raises(InputError, match="no term is called 'overlapp'"):
        read_weights({"overlapp": 1.0}, printed=False)


def test_printed_main_wall_lets_errors_cancel_and_repaired_does_not():
    problem = full_problem(printed=True)._replace(weights={"main_wall": 1.0})
    boxes = random_layouts(problem, 1)[0]
    normal = np.pi  # the wall at x = 6 looks to -x
    boxes[0, 2], boxes[1, 2] = normal + np.pi + 0.4, normal + 0.4  # r = +1 and r = -1, both off
    assert evaluate(problem, boxes[None])[0] == pytest.approx(0.0, abs=1e-9)
    repaired = problem._replace(printed=False)
    assert evaluate(repaired, boxes[None])[0] == pytest.approx(0.8)


def test_printed_against_wall_lets_a_box_stand_askew_and_repaired_does_not():
    walls = ring(np.array([[0.0, 0.0], [6.0, 0.0], [6.0, 5.0], [0.0, 5.0]]))
    askew = make_frame(2.25, 0.3, np.pi / 4, 1.0, 0.7)
    assert orientation.against_wall_printed(askew, walls) == 0.0
    assert orientation.against_wall(askew, walls) > 0.9
    flush = make_frame(2.0, 0.35, np.pi / 2, 1.0, 0.7)
    assert orientation.against_wall(flush, walls) == 0.0


def test_repaired_pair_knows_in_front_from_behind():
    sofa = make_frame(0.0, 0.0, 0.0, 2.0, 1.0)
    ahead, behind = make_frame(2.5, 0.0, np.pi, 1.0, 0.4), make_frame(-2.5, 0.0, np.pi, 1.0, 0.4)
    assert relations.pair_printed(sofa, behind, 2.5, np.pi) == pytest.approx(0.0)
    assert relations.pair(sofa, ahead, 2.5, np.pi, 0.0) == pytest.approx(0.0)
    assert relations.pair(sofa, behind, 2.5, np.pi, 0.0) == pytest.approx(np.pi)


def plain_distance(box, spot):
    """Metres between a box (5,) and a segment (4,), exact."""
    line = shapely.LineString(spot.reshape(2, 2))
    line = line if line.length else shapely.Point(spot[:2])
    return shapely.Polygon(corners(box[None])[0]).distance(line)


def plain_miss(box, spot, back):
    """Radians by which the look from a box's middle misses a segment, on a fine fan of points."""
    points = spot[:2] + np.linspace(0, 1, 20001)[:, None] * (spot[2:] - spot[:2])
    ways = np.arctan2(points[:, 1] - box[1], points[:, 0] - box[0]) - box[2] - np.pi * back
    return np.abs((ways + np.pi) % (2 * np.pi) - np.pi).min()


def test_places_agree_with_exact_shapes():
    problem = full_problem()._replace(weights={"places": 1.0})
    for layout in random_layouts(problem, 60):
        plain = 0.0
        for item, row in zip(problem.items.placed, problem.items.places, strict=True):
            spots = problem.items.spots[int(row[0]) : int(row[1])]
            far = min(plain_distance(layout[item], spot) for spot in spots)
            miss = min(plain_miss(layout[item], spot, row[4] < 0) for spot in spots)
            off = max(0.0, far - row[3]) + max(0.0, row[2] - far) + abs(row[4]) * miss
            plain += row[5] * off
        assert evaluate(problem, layout[None])[0] == pytest.approx(plain, abs=0.02)


def test_a_distance_below_zero_is_the_least():
    sofa, near = make_frame(0.0, 0.0, 0.0, 2.0, 1.0), make_frame(1.5, 0.0, 0.0, 1.0, 1.0)
    nan = float("nan")
    assert relations.pair_printed(sofa, near, -2.0, nan) == pytest.approx(0.5)
    assert relations.pair_printed(sofa, near, -1.0, nan) == 0.0
    assert relations.pair_printed(sofa, near, 1.0, nan) == pytest.approx(0.5)


def test_nothing_asked_costs_nothing():
    problem = full_problem()._replace(weights={})
    p, grid = prepare(problem), route_grid(problem, 0.1)
    assert energies_of(p, grid, random_layouts(problem, 3))[0].tolist() == [0.0, 0.0, 0.0]
