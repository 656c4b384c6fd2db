"""Ropes leave a way to each of a row of counters, which the search takes for one object."""

from __future__ import annotations

import numpy as np
import pytest

from hall_chains import Posed, posed, two_zones
from scenewright.catalog.assets import shipped
from scenewright.domains.hall.gates.fewer_ropes import place_fewer_of_each
from scenewright.domains.hall.gates.idle_guides import BARRING, find_barring
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.retouch.lines import line_up
from scenewright.domains.hall.search import HallSearch
from scenewright.domains.hall.solvers.chains import begin_chain, layout_of
from scenewright.domains.hall.solvers.outcome import MeasuredLayout
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget

COUNTERS = np.array([[0.6, y, 0.0, 1.6, 0.8] for y in (3.4, 5.0, 6.6)])
"""Three of them at the west wall, their fronts at x = 1 m."""


@pytest.fixture(scope="module")
def hall() -> Posed:
    return posed(
        two_zones(
            {"id": "tellers", "category": "counter", "zone": "west", "size": [4.8, 0.8, 1.1]},
            {"id": "ropes", "category": "rope_barrier", "count": 2, "zone": "west"},
        )
    )


def search_of(hall: Posed) -> HallSearch:
    budget, rows = Budget(steps=100), (PRESETS["default"], "anneal")
    return HallSearch(hall.hall, hall.wishes, *rows, budget, 0, shipped(), True, None)


def stand(hall: Posed, x: float) -> MeasuredLayout:
    """The row of counters at its wall, and ropes along its middle ``x`` metres from that wall."""
    problem = hall.fitted.problem
    tellers, ropes = (problem.names.index(f"hall/{name}") for name in ("tellers", "ropes"))
    kept = line_up(problem, hall.fitted.start, tellers, (0.6, 5.0, 0.0))
    kept = line_up(problem, kept, ropes, (x, 5.0, 0.0))
    return layout_of(begin_chain(problem, kept, streams(0, 1)[0]))


def test_ropes_close_to_the_middle_counter_bar_its_way(hall: Posed) -> None:
    ropes = hall.fitted.problem.names.index("hall/ropes")
    search = search_of(hall)
    assert find_barring(search, hall.fitted, stand(hall, 1.4), COUNTERS) == {ropes: BARRING}
    assert find_barring(search, hall.fitted, stand(hall, 2.6), COUNTERS) == {}


def test_ropes_that_bar_a_way_stand_where_they_bar_none(hall: Posed) -> None:
    ropes = hall.fitted.problem.names.index("hall/ropes")
    search, layout = search_of(hall), stand(hall, 1.4)
    fitted, found, idle, missing = place_fewer_of_each(
        search, hall.fitted, layout, {ropes: BARRING}, COUNTERS
    )
    assert (idle, missing) == ({}, ())
    assert find_barring(search, fitted, found, COUNTERS) == {}
