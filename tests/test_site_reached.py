"""Buildings that no way leads to are left out, and the referee agrees on which those are."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

import sites
from scenewright.core.brief import Brief
from scenewright.domains import check
from scenewright.domains.site.access import find_reached_buildings
from scenewright.domains.site.check import figures as referee
from scenewright.domains.site.plan import site_plan, site_plans
from scenewright.domains.site.solving import solve

SOUTH = -math.pi / 2


def judge_sites(sites, pieces):
    return referee.judge_sites(sites, pieces, site_plans(sites))


def court(gap: float) -> np.ndarray:
    """Four long buildings round a court with a fifth in it; ``gap`` metres open at one corner."""
    return np.array(
        [
            [40, 10, SOUTH, 60, 10],
            [40, 70, SOUTH, 60, 10],
            [15, 40, SOUTH, 10, 49.99],
            [65, 40 - gap / 2, SOUTH, 10, 50 - gap],
            [40, 40, SOUTH, 10, 10],
        ]
    )


@pytest.mark.parametrize(("gap", "open_"), [(0.0, False), (3.9, False), (4.0, True), (6.0, True)])
def test_a_court_is_reached_through_a_gap_as_wide_as_the_way(gap: float, open_: bool) -> None:
    plan = site_plan(sites.site(80.0, 80.0))
    assert find_reached_buildings(plan, court(gap), 4.0).tolist() == [True, True, True, True, open_]


@example(200, True, 4.0)
@example(1348, True, 5.88624283384632)
@given(st.integers(0, 10_000), st.booleans(), st.floats(2.0, 6.0))
def test_what_is_reached_the_referee_finds_reached(seed: int, road: bool, width: float) -> None:
    rng = np.random.default_rng(seed)
    roads = [{"line": [(0, 4), (120, 4)], "width": 6.0}] if road else []
    ground = sites.site(fire_access=width, roads=roads)
    boxes = np.column_stack(
        [
            rng.uniform(10, 110, 14),
            rng.uniform(15, 70, 14),
            rng.uniform(-3, 3, 14),
            rng.uniform(6, 30, (14, 2)),
        ]
    )
    got = find_reached_buildings(site_plan(ground), boxes, width)
    pieces = [
        sites.building(f"b{k}", x, y, wide, depth, heading=heading)
        for k, (x, y, heading, wide, depth) in enumerate(boxes.tolist())
    ]
    findings = judge_sites([ground], pieces).findings
    lost = {f.piece for f in findings if f.kind == "unreachable_building"}
    assert lost <= {f"b{k}" for k in np.flatnonzero(~got)}
    assert abs(len(lost) - int((~got).sum())) <= 1


def test_what_no_way_leads_to_is_left_out_by_name() -> None:
    outline = [(-30, -20), (60, -50), (70, 10), (20, 25), (25, 70), (-15, 80), (-70, 10)]
    ground = {
        "id": "s",
        "outline": outline,
        "setback": 0.0,
        "road_setback": 0.0,
        "spacing": 1.0,
        "fire_access": 9.0,
        "roads": [{"line": [(-100, -60), (100, 60)], "width": 4.0}],
        "buildings": [{"model": "pavilion", "count": 60}],
    }
    brief = Brief.model_validate({"domain": "site", "name": "Ragged", "sites": [ground]})
    solution = solve(brief)
    assert check(solution).valid
    placed = sum(piece.category == "building" for piece in solution.pieces)
    assert placed > 0
    told = " ".join(out.reason for out in solution.left_out)
    assert "no way 9 m wide" in told
