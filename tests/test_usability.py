"""The figures of the occupancy grid, against plain references and rooms measured by hand."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from judged_rooms import EAST, SOUTH, judge, piece
from scenewright.check.occupancy import label_parts, lead_from, measure_widths

GRIDS = st.integers(0, 2**32 - 1).map(
    lambda seed: np.random.default_rng(seed).random((9, 11)) < 0.75
)


def neighbours(cell, shape):
    r, c = cell
    near = ((r + 1, c), (r - 1, c), (r, c + 1), (r, c - 1))
    return [(y, x) for y, x in near if 0 <= y < shape[0] and 0 <= x < shape[1]]


@settings(max_examples=25, deadline=None)
@given(GRIDS)
def test_parts_are_those_of_a_plain_flood(free):
    parts = label_parts(free)
    assert ((parts >= 0) == free).all()
    for first in np.argwhere(free).tolist():
        seen, waiting = {tuple(first)}, [tuple(first)]
        while waiting:
            for cell in neighbours(waiting.pop(), free.shape):
                if free[cell] and cell not in seen:
                    seen.add(cell)
                    waiting.append(cell)
        assert {tuple(c) for c in np.argwhere(parts == parts[tuple(first)]).tolist()} == seen


@settings(max_examples=25, deadline=None)
@given(GRIDS)
def test_widths_are_those_of_the_nearest_cell_of_all(free):
    widths = measure_widths(free, 60)
    rows, columns = free.shape
    blocked = [
        (r, c)
        for r in range(-1, rows + 1)
        for c in range(-1, columns + 1)
        if not (0 <= r < rows and 0 <= c < columns) or not free[r, c]
    ]
    for r, c in np.ndindex(free.shape):
        near = min(math.hypot(r - y, c - x) for y, x in blocked)
        assert widths[r, c] == (math.floor(2 * near - 1 + 1e-9) if free[r, c] else 0)
    assert (measure_widths(free, 3) == np.minimum(widths, 3)).all()


@settings(max_examples=25, deadline=None)
@given(GRIDS)
def test_ways_lead_where_a_plain_flood_does(free):
    starts = np.zeros(free.shape, bool)
    starts[4, 3:6] = True
    waiting = [(4, c) for c in (3, 4, 5) if free[4, c]]
    seen = set(waiting)
    while waiting:
        for cell in neighbours(waiting.pop(), free.shape):
            if free[cell] and cell not in seen:
                seen.add(cell)
                waiting.append(cell)
    assert {tuple(cell) for cell in np.argwhere(lead_from(free, starts)).tolist()} == seen


def usability(*pieces):
    return judge(*pieces).figures["usability"]


def test_an_empty_room_is_all_free():
    found = usability()
    assert (found["nav"], found["wfr"], found["e_nav"]) == (1.0, 1.0, 1.0)
    assert found["acc"] is None
    assert found["cell"] == 0.05


def test_a_wall_of_boxes_parts_the_floor():
    """Four metres by three (and the doorway): the row takes 0.5 m of the depth and leaves more on
    one side."""
    found = usability(piece("box", 2, 1.25, 4, 0.5))
    assert found["wfr"] == pytest.approx(2.5 / 3.0, abs=0.01)
    assert found["nav"] == pytest.approx(1.5 / 2.5, abs=0.03)
    assert usability(piece("rug", 2, 1.25, 4, 0.5, 0.01))["wfr"] == 1.0


@pytest.mark.parametrize("gap", [0.35, 0.55, 0.75])
def test_the_narrowest_way_is_the_gap(gap):
    row = piece("box", (4 - gap) / 2, 1.2, 4 - gap, 0.5, id="row")
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH, id="w")
    assert usability(row, wardrobe)["mcw"] == pytest.approx(gap, abs=0.1)
    assert usability(row, wardrobe)["mcw"] <= gap + 1e-9


def test_what_no_way_leads_to_counts_as_none():
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH)
    assert usability(piece("box", 2, 1.2, 4, 0.5), wardrobe)["mcw"] == 0.0


def test_ways_lead_to_the_stage_not_to_what_stands_on_it():
    stage = piece("stage", 1.5, 2.3, 3, 1.4, 0.5, heading=SOUTH, id="stage")
    speaker = piece("wardrobe", 1.5, 2.4, 0.5, 0.5, z=0.5, heading=SOUTH, on="stage", id="w")
    assert usability(stage)["mcw"] == usability(stage, speaker)["mcw"] > 0.5
    assert usability(stage, replace(speaker, on=None))["mcw"] == 0.0


def test_sides_are_clear_or_not():
    wardrobe = piece("wardrobe", 1, 2.75, 1, 0.5, 2, heading=SOUTH)
    assert usability(wardrobe)["acc"] == usability(wardrobe)["acc_area"] == 1.0
    half = usability(wardrobe, piece("box", 0.75, 2.25, 0.5, 0.5))
    assert half["acc"] == 0.0
    assert half["acc_area"] == pytest.approx(0.5, abs=0.05)
    beside = usability(wardrobe, piece("box", 2.0, 2.25, 0.5, 0.5))
    assert beside["acc"] == 1.0
    chair = usability(wardrobe, piece("chair", 1.0, 2.25, 0.5, 0.5))
    assert chair["acc"] == 1.0


def test_what_is_out_of_bounds_lowers_e_nav():
    found = usability(piece("box", 4.0, 1.5, 0.5, 0.5), piece("box", 1.0, 1.0, 0.5, 0.5))
    assert found["e_nav"] == pytest.approx(0.5 * found["nav"], abs=1e-3)


def test_figures_do_not_depend_on_the_order_of_pieces():
    pieces = [piece("box", 1, 1, 0.6, 0.4), piece("bed", 3, 2, 1.6, 2.0, 0.5, heading=EAST)]
    assert usability(*pieces) == usability(*pieces[::-1])
