"""The paper's comparison: hierarchical layout after Wu, Fan, Liu, Wonka 2018 (extra ``solve``).

Zone by zone: rows along the walls, then the floor that is left is cut into one block for each
group (:mod:`.hall_blocks`), each block into one cell for each object, and the cells are fitted
(:mod:`.hall_cells`). If blocks with the full clearances find no room, less of them is asked for;
a zone that stays impossible keeps its first layout. Wall rows are ours: rooms of the original
have no objects that belong to walls. It knows neither passages nor the visitors' route.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
import shapely

from scenewright.domains.hall.energy import make_state, prepare
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.blocks import (
    GroupBlock,
    cut_blocks,
    main_direction,
    sheet_of,
    solver_module,
    to_hall,
)
from scenewright.domains.hall.solvers.cells import (
    CellObjects,
    boxes_in,
    divide,
    misfit,
    needs,
    options_for,
    perturb_cells,
)
from scenewright.domains.hall.solvers.objects import TRIES, ObjectLayout, boxes_of, drop, make_ways
from scenewright.domains.hall.solvers.wall_rows import grow_boxes, polygons_of, wall_row
from scenewright.domains.hall.terms.state import Floats, Ints, PreparedHall
from scenewright.engine.draws import streams
from scenewright.engine.solve import Budget, BudgetWatch, Cancel, Progress

ITERATIONS = 1000
SHARES = (1.0, 0.7, 0.45, 0.25, 0.1, 0.0)
"""Shares of the clearances to try, one after another."""


class MiqpZone(NamedTuple):
    """One zone to fill: its ``edges`` (e, 4), free floor, walls (k, 7), and its units that stand
    free and at walls."""

    edges: Floats
    free: Any
    walls: Floats
    blocks: list[int]
    rows: list[int]


def members_of(p: PreparedHall, unit: int) -> CellObjects:
    """The objects of a unit."""
    span = slice(*p.spans[unit])
    return CellObjects(p.sizes[span], p.clear[span])


def zone_of(problem: HallProblem, p: PreparedHall, zone: int) -> MiqpZone:
    """The floor of a zone and its objects."""
    edges = p.zone_edges[slice(*p.zone_spans[zone])]
    ground = problem.ground
    lines = shapely.multilinestrings(shapely.linestrings(edges.reshape(-1, 2, 2)))
    parts = shapely.get_parts(shapely.polygonize(list(shapely.get_parts(shapely.node(lines)))))
    floor = shapely.union_all([part for part in parts if _left_of(edges, part)])
    solids = np.concatenate(
        [np.asarray(ground.obstacles).reshape(-1, 5), np.asarray(ground.keep_free).reshape(-1, 5)]
    )
    free = floor.difference(shapely.union_all(polygons_of(solids)))
    units = np.flatnonzero(p.zones == zone).tolist()
    rows = [u for u in units if p.wall_bound[u] == 1]
    walls = p.stretches[p.loops[slice(*p.loop_spans[zone])]]
    return MiqpZone(
        edges, free, walls[walls[:, 4] > 0.0], [u for u in units if u not in rows], rows
    )


def _left_of(edges: Floats, part: Any) -> bool:
    """True if a face of the edges lies inside them, by the parity of edges to its right."""
    point = part.representative_point()
    x0, y0, x1, y1 = edges[edges[:, 1] != edges[:, 3]].T
    crossing = (y0 > point.y) != (y1 > point.y)
    return bool((crossing & (point.x < (x1 - x0) * (point.y - y0) / (y1 - y0) + x0)).sum() % 2)


def set_rows(p: PreparedHall, zone: MiqpZone, boxes: Floats, share: float) -> tuple[Any, list[int]]:
    """Place the wall rows of a zone into ``boxes`` (n, 5): the floor left free with a share of
    their clearances, and the units that found no room at the walls."""
    free, left = zone.free, []
    for unit in sorted(zone.rows, key=lambda u: -float(p.sizes[slice(*p.spans[u]), 0].sum())):
        members = members_of(p, unit)
        found = wall_row(members, zone.walls, free) if len(zone.walls) else None
        if found is None:
            left.append(unit)
            continue
        boxes[slice(*p.spans[unit])] = found
        kept = np.maximum(share * members.clear, 0.02)
        free = free.difference(shapely.union_all(polygons_of(grow_boxes(found, kept, 1.0))))
    return free, left


def set_blocks(
    p: PreparedHall,
    zone: MiqpZone,
    boxes: Floats,
    share: float,
    seed: int,
    seconds: float | None,
    cancelled: Cancel,
) -> tuple[list[tuple[int, GroupBlock]], Any] | None:
    """Blocks of the units of a zone that stand free, and the sheet they lie on; None if they find
    no room."""
    free, left = set_rows(p, zone, boxes, share)
    units = zone.blocks + left
    if not units:
        return [], None
    if free.is_empty:
        return None
    sheet = sheet_of(free, main_direction(zone.edges))
    demanded = [float(needs(members_of(p, u), 1.0).prod(axis=1).sum()) for u in units]
    target = min(0.9 * free.area / sum(demanded), 1.5)
    found = cut_blocks(
        sheet,
        [options_for(members_of(p, u), share) for u in units],
        [target * area for area in demanded],
        seed,
        seconds,
        cancelled,
    )
    return None if found is None else (list(zip(units, found, strict=True)), sheet)


def fit_cells(
    p: PreparedHall,
    placed: list[tuple[int, GroupBlock]],
    sheet: Any,
    boxes: Floats,
    rng: np.random.Generator,
    iterations: int,
) -> tuple[float, int]:
    """Divide blocks into cells, fit them in turn, write the boxes; the cost and changes tried."""
    groups = [(members_of(p, unit), block) for unit, block in placed]
    cells = [divide(block, members, rng) for members, block in groups]
    costs = [
        misfit(one, block, members) for one, (members, block) in zip(cells, groups, strict=True)
    ]
    for _ in range(iterations if groups else 0):
        k = int(rng.integers(len(groups)))
        members, block = groups[k]
        tried = perturb_cells(cells[k], rng)
        cost = misfit(tried, block, members)
        if cost <= costs[k]:
            cells[k], costs[k] = tried, cost
    for one, (unit, block), (members, _) in zip(cells, placed, groups, strict=True):
        front = 0.0 if block.option.turned else 0.5 * math.pi
        forward = _forward(block, sheet)
        local = boxes_in(one, block, members, front if forward else front + math.pi)
        boxes[slice(*p.spans[unit])] = to_hall(sheet, local)
    return sum(costs), iterations if groups else 0


def _forward(block: GroupBlock, sheet: Any) -> bool:
    """True if the middle of the zone lies ahead of a block whose objects look up or right."""
    if block.option.turned:
        return bool(2 * block.x + block.width <= sheet.width)
    return bool(2 * block.y + block.height <= sheet.height)


def miqp(
    problem: HallProblem,
    budget: Budget,
    seed: int,
    progress: Progress | None = None,
    cancel: Cancel | None = None,
    start: Floats | None = None,
) -> ObjectLayout:
    """Place the objects of a hall zone by zone, group by group, cell by cell.

    ``start`` (n, 5) is where objects stand in zones that find no room for their blocks (dropped
    at random if left out). Steps are changes of the subdivision, 1000 a zone without a budget;
    with seconds the blocks of each zone get an even share of them.
    """
    solver_module()
    p, watch, rng = (
        prepare(problem),
        BudgetWatch(budget, progress, cancel),
        np.random.default_rng(seed),
    )
    boxes = _first(problem, p, seed) if start is None else np.array(start, np.float64)
    zones: Ints = np.unique(p.zones)
    cost, done = 0.0, 0
    for k, number in enumerate(zones.tolist()):
        zone = zone_of(problem, p, number)
        seconds = budget.seconds and 0.8 * max(budget.seconds - watch.seconds(), 0.0) / (
            len(zones) - k
        )
        for share in () if watch.cancelled() else SHARES:
            found = set_blocks(p, zone, boxes, share, seed, seconds, watch.cancelled)
            if found is not None:
                each = ITERATIONS if budget.steps is None else budget.steps // len(zones)
                each = 0 if watch.cancelled() else min(each, ITERATIONS)
                more, tried = fit_cells(p, *found, boxes, rng, each)
                cost, done = cost + more, done + tried
                break
        if watch.over(done, math.inf, lambda: _turn_back(boxes)) and k + 1 < len(zones):
            break
    return ObjectLayout(_turn_back(boxes), cost, max(done, 1))


def _turn_back(boxes: Floats) -> Floats:
    """Boxes (n, 5) with headings in [0, 2π)."""
    turned = boxes.copy()
    turned[:, 2] %= 2.0 * math.pi
    return turned


def _first(problem: HallProblem, p: PreparedHall, seed: int) -> Floats:
    s = make_state(p)
    drop(p, s, make_ways(problem), TRIES, streams(seed, 1)[0])
    return boxes_of(s)
