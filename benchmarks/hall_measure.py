"""One measure for all halls, whatever laid them out: the paper's four energies of final boxes.

Solvers differ in how they group objects: ours splits demands, some place objects one by one and
have no patterns. So here a unit is what of one demand stands in one zone; the fill counts
footprints and clearances, as printed; neighbours are those of the least spanning tree of gaps. All
weights are 1. Small objects that belong beside others (benches before pictures, bins, planters)
form no group: whichever method placed them, they cover floor of others, and count no further.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.building import plan
from scenewright.building.standing import fixed_pieces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.hall.accessories import split_accessories
from scenewright.domains.hall.build_problem import HallContext, build_problem, hall_of
from scenewright.domains.hall.demands.holdings import HallDemand, collect_demands
from scenewright.domains.hall.energy import capacity
from scenewright.domains.hall.fit import Fitted, fit
from scenewright.domains.hall.furnishing.on_stage import split_carried
from scenewright.domains.hall.patterns import SINGLE, WALL
from scenewright.domains.hall.presets import OURS, PAPER
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.solvers.outcome import MeasuredLayout, measure_layout
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.table import (
    ACCESS,
    FILL,
    NEAR,
    PRINTED,
    SPACE,
    proportion_cost,
    space_cost,
)
from scenewright.domains.hall.zoning.assign import Unit
from scenewright.domains.hall.zoning.zones import HallPlan, borders_of, zones_of


class Energies(NamedTuple):
    """The four energies of a layout, and the least they could be: 20 a unit for the space, 0.5
    for each pair of neighbours."""

    space: float
    fill: float
    access: float
    proportion: float
    least: float

    @property
    def total(self) -> float:
        """Their sum."""
        return self.space + self.fill + self.access + self.proportion


class Posed(NamedTuple):
    """A hall of a brief, what it is to hold, and the problem with its first layout."""

    hall: HallContext
    wishes: list[HallDemand]
    fitted: Fitted


def posed(brief: Brief, seed: int = 0, printed: bool = False) -> Posed:
    """The first hall of a brief ready to be solved, by the paper's preset if ``printed``."""
    hall = hall_in(brief, 0, None)
    wishes, _ = split_carried(collect_demands(brief, 0, (), shipped()), hall.fixed)
    weights = PAPER if printed else OURS
    return Posed(hall, wishes, fit(hall, wishes, weights, shipped(), seed, printed))


def hall_in(brief: Brief, number: int, solution: Solution | None) -> HallContext:
    """A hall of a brief, with the zones and generated walls of a solution if there is one."""
    space = plan.spaces(brief)[number]
    fixed = list(fixed_pieces(brief.rooms[number], space, shipped()))
    zones = zones_of(brief, number, space)
    if solution is not None and solution.detail is not None:
        graph = solution.detail.layout
        built = {piece.id: piece for piece in solution.pieces}
        fixed += [built[name] for name in graph.partitions if built[name].space == space.id]
        zones = HallPlan(
            tuple(zone for zone in graph.zones if zone.space == space.id),
            tuple(link for link in graph.links if link.space == space.id),
        )
    return hall_of(space, zones, borders_of(zones, space), tuple(fixed), brief.route_width)


def energies_of(solution: Solution, number: int = 0) -> Energies:
    """The four energies of a hall of a solution, by the measure of this module."""
    hall = hall_in(solution.brief, number, solution)
    wishes = collect_demands(solution.brief, number, (), shipped())
    placed = _placed(solution, hall, wishes)
    small = {wish.id for wish in split_accessories(wishes, False, [])[1]}
    beside = [key for key in placed if wishes[key[0]].id in small]
    standing = tuple(piece for key in beside for piece in placed.pop(key))
    hall = hall._replace(fixed=(*hall.fixed, *standing))
    held = [_with_sizes(wish, placed, k) for k, wish in enumerate(wishes)]
    problem = build_problem(hall, held, _units(placed), (), dict(PAPER), shipped())
    boxes = _boxes([piece for pieces in placed.values() for piece in pieces])
    boxes[:, 3:] = problem.units.sizes
    p, s, _ = measure_layout(
        problem, MeasuredLayout(_single(problem), boxes, 0.0, 0.0, 0.0, loose=True)
    )
    proportion, pairs = _proportion(problem, boxes)
    least = len(p.spans) * space_cost(0.0, 1.0) + 0.5 * pairs
    space, fill, access = (float(s.costs[term].sum()) for term in (SPACE, FILL, ACCESS))
    return Energies(space, fill, access, proportion, least)


def own_energy(solution: Solution) -> float:
    """Σ of the paper's four terms as the solver itself counts them, weights 1."""
    return sum(part.value for part in solution.terms if part.term in PRINTED)


_Placed = dict[tuple[int, int], list[Piece]]


def _placed(solution: Solution, hall: HallContext, wishes: list[HallDemand]) -> _Placed:
    """Pieces by number of their demand and of their zone, in order."""
    assert solution.detail is not None
    numbers = {wish.id: k for k, wish in enumerate(wishes)}
    pieces = {piece.id: piece for piece in solution.pieces}
    placed: _Placed = {}
    for group in solution.detail.layout.groups:
        if group.space == hall.space.id:
            key = numbers[group.demand], hall.names.index(group.zone)
            here = [pieces[name] for name in group.objects if pieces[name].on is None]
            placed.setdefault(key, []).extend(here)
    return {key: here for key, here in sorted(placed.items()) if here}


def _units(placed: _Placed) -> list[Unit]:
    units: list[Unit] = []
    for (demand, zone), pieces in placed.items():
        before = units[-1] if units and units[-1].demand == demand else None
        first = before.last if before else 0
        units.append(Unit(demand, zone, first, first + len(pieces)))
    return units


def _with_sizes(wish: HallDemand, placed: _Placed, number: int) -> HallDemand:
    sizes = [p.size for (demand, _), pieces in placed.items() if demand == number for p in pieces]
    return wish._replace(sizes=tuple(s._replace(depth=s.depth + 2 * wish.chairs) for s in sizes))


def _boxes(pieces: list[Piece]) -> Floats:
    rows = [(*p.pose[:2], p.pose.heading, p.size.width, p.size.depth) for p in pieces]
    return np.array(rows, np.float64).reshape(-1, 5)


def _single(problem: HallProblem) -> Kept:
    """A layout of single objects, all taken as they stand."""
    units = len(problem.units.spans)
    rows = np.tile([float(SINGLE), 1.0], (units, 1))
    depth = int(capacity(np.diff(problem.units.spans).ravel()).sum())
    return Kept(np.zeros((units, 4)), np.zeros((depth, 5)), rows, np.zeros((0, 2)))


def _proportion(problem: HallProblem, boxes: Floats) -> tuple[float, int]:
    """E_p over the least spanning trees of the units that stand free, and its pairs."""
    reach, total, pairs = problem.units.clear.max(axis=1), 0.0, 0
    for unit, (first, last) in enumerate(problem.units.spans):
        if last - first < 2 or problem.units.choices[unit, WALL]:
            continue
        gaps = gaps_of(boxes[first:last])
        for i, j in least_tree(gaps):
            most = float(reach[first + i] + reach[first + j]) + NEAR
            total, pairs = total + proportion_cost(float(gaps[i, j]), most), pairs + 1
    return total, pairs


def least_tree(gaps: Floats) -> list[tuple[int, int]]:
    """The pairs of the tree of least sum (Prim) over distances (n, n).

    >>> least_tree(np.array([[0, 1, 5], [1, 0, 2], [5, 2, 0.0]]))
    [(0, 1), (1, 2)]
    """
    near, source = gaps[0].copy(), np.zeros(len(gaps), np.int64)
    near[0], pairs = np.inf, []
    for _ in range(len(gaps) - 1):
        new = int(np.argmin(near))
        pairs.append((int(source[new]), new))
        joined = np.isinf(near)
        closer = ~joined & (gaps[new] < near)
        near, source = np.where(closer, gaps[new], near), np.where(closer, new, source)
        near[new] = np.inf
    return pairs


def gaps_of(boxes: Floats) -> Floats:
    """μ of all pairs (n, n): distance along the line of centres, edge to edge.

    >>> float(gaps_of(np.array([[0, 0, 0, 2, 1], [3, 0, 0, 2, 1.0]]))[0, 1])
    2.0
    """
    step = boxes[None, :, :2] - boxes[:, None, :2]
    far = np.hypot(step[..., 0], step[..., 1])
    along = step / np.maximum(far, 1e-9)[..., None]
    cos, sin = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    ahead = np.abs(along[..., 0] * cos[:, None] + along[..., 1] * sin[:, None])
    aside = np.abs(along[..., 0] * sin[:, None] - along[..., 1] * cos[:, None])
    own = 0.5 * (aside * boxes[:, 3, None] + ahead * boxes[:, 4, None])
    gaps: Floats = far - own - own.T
    np.fill_diagonal(gaps, 0.0)
    return gaps
