"""GD-MH as printed, eqs. 1 and 3 as printed, and the two terms of order."""

from __future__ import annotations

import numpy as np
import pytest

from hall_chains import boxes_of, posed, two_zones
from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.chains import HallChain, anneal_hall, begin_chain, gd_mh
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.table import AISLES, ALIGNMENT, FILL
from scenewright.domains.hall.terms.whole import measure_all
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget
from scenewright.formats import read

ART = {"id": "art", "category": "wall_exhibit", "size": [1.2, 0.1, 1.5], "zone": "east"}
CASES = {"id": "cases", "category": "showcase", "count": 6, "zone": "west"}


def chain_at(problem: HallProblem, kept: Kept) -> HallChain:
    chain = begin_chain(problem, kept, streams(0, 1)[0])
    measure_all(chain.p, chain.s, chain.work)
    return chain


def test_printed_fill_never_changes() -> None:
    fitted = posed(two_zones(CASES | {"count": 9, "patterns": ["grid"]}), "paper").fitted
    printed = fitted.problem.settings
    assert printed.printed
    mended = fitted.problem._replace(settings=printed._replace(printed=False))
    found = anneal_hall(mended, fitted.start, Budget(steps=800, threads=1), 0)
    fills = []
    for kept in (fitted.start, found.layouts[0].kept):
        chain = chain_at(fitted.problem, kept)
        fills.append(chain.s.costs[FILL, :2].tolist())
    assert fills[0] == fills[1]
    repaired = [
        chain_at(mended, kept).s.costs[FILL, :2].tolist()
        for kept in (fitted.start, found.layouts[0].kept)
    ]
    assert repaired[0] != repaired[1]


def test_printed_walls_come_and_go_during_the_search() -> None:
    """The wall a zone lacks is built; one that narrows a passage is cut."""
    fitted = posed(two_zones(ART | {"count": 10}), "paper").fitted
    problem, start = fitted.problem, fitted.start
    assert len(problem.ground.hosts) == 1
    bare = start._replace(walls=np.zeros((1, 2)))
    short = problem._replace(ground=problem.ground._replace(zone_walls=np.array([0.0, 90.0])))
    built = gd_mh(short, bare, Budget(steps=200), 0).layouts[0].kept.walls
    least, most = problem.ground.host_spans[0]
    assert least <= built[0, 0] < built[0, 1] <= most
    shut = start._replace(walls=np.array([[0.0, 10.0]]))
    cut = gd_mh(problem, shut, Budget(steps=400), 0).layouts[0]
    assert cut.lacking == 0.0
    assert cut.kept.walls[0, 1] - cut.kept.walls[0, 0] < 9.0


def test_groups_at_walls_stay_in_the_wall_band_of_the_paper() -> None:
    """Two groups of equal length go to the two zones, not both to the first."""
    art = {key: value for key, value in ART.items() if key != "zone"}
    brief = two_zones(*(art | {"id": f"art {k}", "count": 5} for k in range(2)))
    assert sorted(unit.zone for unit in posed(brief, "paper").fitted.units) == [0, 1]


def test_lines_and_aisles_are_those_of_the_boxes() -> None:
    fitted = posed(read("sample:hall-exhibition")).fitted
    chain = chain_at(fitted.problem, fitted.start)
    boxes = boxes_of(chain)
    lines = sum(len(np.unique(np.floor((boxes[:, k] + 0.0037) / 0.01))) for k in range(2))
    assert chain.s.costs[ALIGNMENT, 0] == lines
    gaps = 0.0
    for u, (first, last) in enumerate(fitted.problem.units.spans):
        if fitted.problem.units.choices[u, WALL]:
            mine = boxes[first:last]
            apart = np.hypot(*np.diff(mine[:, :2], axis=0).T) - mine[1:, 3]
            straight = np.abs(np.diff(mine[:, 2])) < 1e-9
            gaps = float(np.maximum(0.6 - apart, 0.0)[straight & (apart > 0.02)].sum())
            assert chain.s.costs[AISLES, u] >= gaps - 1e-6
    assert gaps > 0.0


def test_what_hangs_back_to_back_counts_as_near_each_other() -> None:
    """Neighbours of a row at walls, and pairs on both sides of a wall, by the line of middles."""
    fitted = posed(read("sample:hall-exhibition")).fitted
    chain = chain_at(fitted.problem, fitted.start)
    boxes, pairs = boxes_of(chain), 0
    for u, (first, last) in enumerate(fitted.problem.units.spans):
        if not fitted.problem.units.choices[u, WALL]:
            continue
        lacking = 0.0
        for i in range(first, last):
            for j in range(i + 1, last):
                opposite = np.cos(boxes[i, 2] - boxes[j, 2]) < -0.99
                gap = gap_along(boxes[i], boxes[j])
                if (j == i + 1 or opposite) and gap > 0.02:
                    lacking += max(0.6 - gap, 0.0)
                    pairs += opposite and gap < 0.6
        assert chain.s.costs[AISLES, u] == pytest.approx(lacking, abs=1e-6)
    assert pairs > 0


def gap_along(a: np.ndarray, b: np.ndarray) -> float:
    """Edge to edge of two boxes along the line of their middles, each by its support."""
    way = b[:2] - a[:2]
    far = float(np.hypot(*way))
    reach = 0.0
    for box in (a, b):
        ahead = np.array([np.cos(box[2]), np.sin(box[2])])
        aside = np.array([ahead[1], -ahead[0]])
        reach += 0.5 * (box[3] * abs(aside @ way) + box[4] * abs(ahead @ way)) / far
    return far - reach


def test_groups_come_into_line_and_gaps_can_be_passed() -> None:
    fitted = posed(read("sample:hall-exhibition")).fitted
    start = chain_at(fitted.problem, fitted.start).s.costs
    found = anneal_hall(fitted.problem, fitted.start, Budget(steps=6000, threads=1), 0)
    end = chain_at(fitted.problem, found.layouts[0].kept).s.costs
    assert end[ALIGNMENT, 0] < 0.9 * start[ALIGNMENT, 0]
    assert end[AISLES].sum() < 0.5 * start[AISLES].sum()
