"""What did not move is not looked at again, and the answers are those of looking at everything."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.building.plan import plan_rooms
from scenewright.catalog.loading import catalog_of
from scenewright.domains.home.energy import energies_of, prepare, route_grid
from scenewright.domains.home.solvers.anneal import scatter_boxes
from scenewright.domains.home.solving import problems, solve
from scenewright.domains.home.walking.home_floor import (
    SLACK,
    join_floors,
    list_obstacles,
    reach_without,
    walk,
)
from scenewright.formats import read


def test_energies_of_layouts_in_a_row_are_those_of_each_by_itself() -> None:
    problem = max(problems(read("sample:home-flat")), key=lambda p: len(p.items.low))
    prepared, grid, rng = prepare(problem), route_grid(problem, 0.1), np.random.default_rng(3)
    layouts = np.repeat(scatter_boxes(prepared, 1, rng), 40, axis=0)
    for k, moved in enumerate(scatter_boxes(prepared, 39, rng), start=1):
        i = rng.integers(len(prepared.limits))
        layouts[k] = layouts[k - 1]
        layouts[k, i] = moved[i]
    together = energies_of(prepared, grid, layouts)[0]
    alone = [energies_of(prepared, grid, one[None])[0][0] for one in layouts]
    assert len(set(alone)) > 30
    assert together.tolist() == alone


def test_what_is_reached_without_an_obstacle_is_what_a_walk_without_it_reaches() -> None:
    brief = read("sample:home-flat")
    spaces, catalog = plan_rooms(brief).spaces, catalog_of(brief.catalogs)
    floor = join_floors(spaces, 0.6)[0]
    obstacles = list_obstacles(solve(brief, seed=0, threads=1).pieces, catalog)
    walked = walk(floor, obstacles)
    parts, opened = shapely.get_parts(walked.free), 0.0
    for k in range(len(obstacles)):
        found = shapely.union_all(reach_without(walked, parts, (k,)))
        whole = walk(floor, tuple(o for j, o in enumerate(obstacles) if j != k)).reached
        assert found.symmetric_difference(whole).buffer(-SLACK / 2).is_empty
        opened = max(opened, whole.area - walked.reached.area)
    assert opened > 0.5
