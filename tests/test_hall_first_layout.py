"""First layouts of halls: of finite energy, wherever windows, doors and borders of zones lie."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import shapely
from hypothesis import given, settings
from hypothesis import strategies as st

import scenewright
from hall_chains import answer, posed, ring, two_zones
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.domains.hall.fit import Fitted
from scenewright.domains.hall.problem import THICKNESS
from scenewright.domains.hall.solvers.chains import begin_chain, first_layout
from scenewright.domains.hall.walls.clear_of_openings import clear_hosts
from scenewright.domains.hall.walls.partitions import SHORTEST, Host
from scenewright.engine.draws import streams

TENTH = st.integers(0, 10).map(lambda k: 0.1 * k)


def energy(fitted: Fitted) -> float:
    return float(begin_chain(fitted.problem, fitted.start, streams(0, 1)[0]).tally[0])


def hall_with_windows(border: float, windows: list[dict[str, Any]], count: int) -> Brief:
    """A hall of 20 by 10 metres, its two zones parted at x = ``border``; ``count`` exhibits hang in
    the smaller one."""
    zones = [
        {"id": "west", "outline": ring(0, 0, border, 10)},
        {"id": "east", "outline": ring(border, 0, 20, 10)},
    ]
    art = {
        "id": "art",
        "category": "wall_exhibit",
        "count": count,
        "size": [1.2, 0.1, 1.5],
        "zone": "west" if border <= 10.0 else "east",
    }
    tables = {"id": "tables", "category": "display_table", "count": 4}
    return two_zones(art, tables, zones=zones, windows=windows, links=[])


@st.composite
def windowed(draw: st.DrawFn) -> Brief:
    border = draw(st.integers(10, 28)) * 0.5
    over = draw(TENTH) * 2.0 - 1.0
    wide = draw(st.sampled_from((1.0, 2.4, 6.0)))
    at = float(np.clip(border + over, 0.5 * wide + 0.2, 19.8 - 0.5 * wide))
    windows = [{"at": [at, 10.0], "width": wide, "sill": 0.2}]
    if draw(st.booleans()):
        windows.append({"at": [float(np.clip(at + 0.4, 8, 18.5)), 0.0], "width": 2.0, "sill": 0.2})
    return hall_with_windows(border, windows, draw(st.integers(6, 24)))


@settings(max_examples=25, deadline=None, derandomize=True)
@given(windowed())
def test_first_layouts_have_a_finite_energy(brief: Brief) -> None:
    for preset in ("default", "paper"):
        fitted = posed(brief, preset).fitted
        assert np.isfinite(energy(fitted))
        closed = shapely.polygons(corners(fitted.problem.ground.keep_free))
        for wall in built(fitted):
            assert shapely.area(shapely.intersection(closed, wall)).max() < 1e-6


def built(fitted: Fitted) -> list[shapely.Polygon]:
    """The walls of a first layout."""
    found = []
    for host, (low, high) in zip(fitted.hosts, fitted.start.walls, strict=True):
        start, end = np.array(host.row[:2]), np.array(host.row[2:4])
        way = (end - start) / np.hypot(*(end - start))
        line = shapely.LineString([start + low * way, start + high * way])
        if high > low:
            found.append(line.buffer(0.5 * THICKNESS, cap_style="flat"))
    return found


@pytest.mark.parametrize("seed", range(3))
def test_a_border_that_ends_in_a_window_gets_a_wall_beside_it(seed: int) -> None:
    """As the shop window of a supermarket, on whose middle a border of zones ends."""
    windows = [{"at": [9.5, y], "width": 3.0, "sill": 0.2} for y in (0.0, 10.0)]
    found = answer(hall_with_windows(9.0, windows, 24), seed=seed)
    assert any(piece.category == "partition" for piece in found.pieces)
    report = scenewright.check(found)
    assert report.valid, report.findings
    assert sum(piece.function == "art" for piece in found.pieces) == 24
    assert sum(piece.function == "tables" for piece in found.pieces) == 4


def test_walls_move_or_shorten_or_are_not_built_where_openings_are() -> None:
    host = Host((0.0, 0.0, 9.0, 0.0, 0.0, 1.0), (0.0, 8.0), (0.0, 9.0))
    window = np.array([[1.0, 0.0, 0.0, 1.0, 2.0]])
    (one,) = clear_hosts((host,), window, THICKNESS)
    assert one.most == pytest.approx((2.08, 9.0))
    assert one.span == pytest.approx((2.08, 9.0))
    assert clear_hosts((host,), window + np.array([0.0, 3.0, 0.0, 0.0, 0.0]), THICKNESS) == (host,)
    assert clear_hosts((host,), np.array([[4.5, 0.0, 0.0, 1.0, 9.0 - SHORTEST]]), THICKNESS) == ()


def test_walls_that_are_refused_are_left_out_of_a_first_layout() -> None:
    brief = hall_with_windows(9.0, [], 24)
    fitted = posed(brief).fitted
    ground = fitted.problem.ground
    assert built(fitted)
    middle = shapely.centroid(built(fitted)[0])
    shut = np.array([[middle.x, middle.y, 0.0, 1.0, 1.0]])
    closed = ground._replace(keep_free=np.concatenate([ground.keep_free, shut]))
    problem = fitted.problem._replace(ground=closed)
    start, lost = first_layout(problem, fitted.start.walls, 0)
    assert not shapely.union_all(built(fitted._replace(start=start))).intersects(middle)
    assert lost or np.isfinite(energy(fitted._replace(problem=problem, start=start)))
