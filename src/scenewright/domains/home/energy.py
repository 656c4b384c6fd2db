"""Energy: the weighted terms of a layout, for whole populations, and where each part comes from."""

from __future__ import annotations

import math
from functools import lru_cache
from typing import NamedTuple

import numpy as np

from scenewright.building.ceiling import BENDING, low_floor, strips
from scenewright.core.layout import Layout
from scenewright.core.same import once
from scenewright.domains.home.problem import Ground, Items, KnownGround, Problem, known_ground
from scenewright.domains.home.terms.assemble import (
    Costs,
    Ints,
    PreparedHome,
    make_costs,
    measure,
    part_of,
)
from scenewright.domains.home.terms.orientation import inward
from scenewright.domains.home.terms.table import (
    CLEAR_ITEMS,
    CLEAR_ROOM,
    CORRIDORS,
    KEEP_FREE,
    OBSTACLES,
    ROUTE,
    SLOPE,
    TERMS,
    WINDOW,
    read_weights,
)
from scenewright.engine.energy import Evaluation, Part
from scenewright.engine.rows import TermRow
from scenewright.engine.whole_terms import gather
from scenewright.geometry.boxes import Floats, frames_of
from scenewright.geometry.circulation import route
from scenewright.geometry.compiled import compiled
from scenewright.geometry.flood import Bits
from scenewright.geometry.paths import RouteGrid, make_grid


def _fresh(array: Floats, *shape: int) -> Floats:
    return np.array(array, np.float64, order="C").reshape(-1, *shape)


def _zones(ground: Ground, tops: Floats) -> Floats:
    """Boxes to be kept free ``(k, 10)``: frame, term, the height it starts from; the slopes are
    cut for items as high as ``tops``."""
    windows = _fresh(ground.windows, 6)
    low = strips(_fresh(ground.slopes, 6), tops, ground.bounds)
    kinds = (
        (KEEP_FREE, ground.keep_free),
        (KEEP_FREE, ground.fronts),
        (CORRIDORS, ground.use_space),
        (OBSTACLES, ground.obstacles),
        (WINDOW, windows[:, :5]),
        (SLOPE, low[:, :5]),
    )
    boxes = np.concatenate([_fresh(boxes, 5) for _, boxes in kinds])
    zones = np.empty((len(boxes), 10))
    zones[:, :8], zones[:, 9] = frames_of(boxes), -np.inf
    zones[:, 8] = np.repeat([term for term, _ in kinds], [len(boxes) for _, boxes in kinds])
    glass = len(boxes) - len(windows) - len(low)
    zones[glass:, 9] = np.concatenate([windows[:, 5], low[:, 5]])
    return zones


def _traits(items: Items, reach: Floats, role: Floats) -> Floats:
    traits = np.empty((len(items.height), 9))
    columns = (items.height, items.back_to_wall, role, items.daylight, items.nestle)
    for k, column in enumerate(columns):
        traits[:, k] = column
    traits[:, 5:7], traits[:, 7], traits[:, 8] = items.wish, reach, items.shades
    return traits


def _strips(ground: Ground) -> Floats:
    """The floor before windows and wide openings ``(k, 10)``: frame, kind, depth."""
    strips = _fresh(ground.strips, 6)
    return np.column_stack([frames_of(strips[:, :5]), strips[:, 5], strips[:, 4]])


def _index_relations(pairs: Ints, n: int) -> tuple[Ints, Ints]:
    """For each item the relations it is in, as one list, and where each item's part starts."""
    if not len(pairs):
        return np.zeros(n + 1, np.int64), np.zeros(0, np.int64)
    items = pairs.ravel()
    order = np.argsort(items, kind="stable").astype(np.int64)
    start = np.searchsorted(items[order], np.arange(n + 1)).astype(np.int64)
    return start, order // 2


class PreparedGround(NamedTuple):
    """What :class:`PreparedHome` holds of the ground alone; the zones where nothing slopes."""

    edges: Floats
    walls: Floats
    zones: Floats
    bounds: Floats
    paths: Floats
    strips: Floats
    main: Floats
    normal: float
    span: float


@lru_cache(maxsize=256)
def _prepare_ground(known: KnownGround) -> PreparedGround:
    ground = known.ground
    main, bounds = _fresh(ground.main_wall, 4), _fresh(ground.bounds, 4)[0].copy()
    return PreparedGround(
        _fresh(ground.edges, 4),
        _fresh(ground.walls, 4),
        _zones(ground._replace(slopes=np.zeros((0, 6))), np.zeros(0)),
        bounds,
        _fresh(ground.paths, 4),
        np.ascontiguousarray(_strips(ground)),
        main,
        float(inward(main[0])) if len(main) else float("nan"),
        float(np.hypot(bounds[2] - bounds[0], bounds[3] - bounds[1])),
    )


@once(64)
def prepare(problem: Problem) -> PreparedHome:
    """Arrays and weights of a problem, ready for compiled code; of the same value made once."""
    ground, items = problem.ground, problem.items
    weights = read_weights(problem.weights, problem.printed)
    fixed = _prepare_ground(known_ground(ground))
    zoned = weights[CLEAR_ROOM] != 0.0 or weights[CLEAR_ITEMS] != 0.0
    reach = items.clear.max(axis=1, initial=0.0) if zoned else np.zeros(len(items.clear))
    pairs = np.array(items.pairs, np.int64, order="C").reshape(-1, 2)
    placed = np.argsort(items.placed, kind="stable")
    start, related = _index_relations(pairs, len(items.low))
    return PreparedHome(
        edges=fixed.edges,
        walls=fixed.walls,
        zones=_zones(ground, items.height) if len(ground.slopes) else fixed.zones,
        clear=_fresh(items.clear, 4),
        access=_fresh(items.access, 4),
        inset=_fresh(items.inset, 4),
        traits=_traits(items, reach, items.main_wall * (1.0 if len(fixed.main) else 0.0)),
        limits=np.concatenate([_fresh(items.low, 2), _fresh(items.high, 2)], axis=1),
        pairs=pairs,
        targets=np.concatenate(
            [_fresh(items.pair_targets, 3), _fresh(items.pair_weights, 1)], axis=1
        ),
        related_start=start,
        related=related,
        place_start=np.searchsorted(items.placed[placed], np.arange(len(items.low) + 1)),
        places=_fresh(items.places[placed], 6),
        spots=_fresh(items.spots, 4),
        weights=weights,
        bounds=fixed.bounds,
        own=gather(TERMS, problem, weights),
        paths=fixed.paths,
        strips=fixed.strips,
        area=float(ground.area),
        normal=fixed.normal,
        span=fixed.span,
        flush=float(problem.flush),
    )


def route_grid(problem: Problem, cell: float) -> RouteGrid:
    """The grid the walking route is looked for on; empty if the route is not weighed."""
    wanted = problem.weights.get("route", 0.0) != 0.0
    return _make_grid(known_ground(problem.ground), wanted, problem.route_width, float(cell))


@lru_cache(maxsize=256)
def _make_grid(known: KnownGround, wanted: bool, width: float, cell: float) -> RouteGrid:
    ground = known.ground
    doors = frames_of(_fresh(ground.doors if wanted else np.zeros((0, 5)), 5))
    bounds = _fresh(ground.bounds, 4)[0] * (1.0 if len(doors) else 0.0)
    low = low_floor(_fresh(ground.slopes, 6), width, ground.bounds, BENDING)
    solid = np.concatenate([_fresh(ground.obstacles, 5), low])
    return make_grid(_fresh(ground.edges, 4), frames_of(solid), doors, bounds, cell, float(width))


@compiled
def fill_energies(
    p: PreparedHome,
    grid: RouteGrid,
    population: Floats,
    weights: Floats,
    energies: Floats,
    routes: Floats,
    costs: Costs,
    free: Bits,
    reached: Bits,
) -> None:
    """Write energies and, of these, what the route costs ``(P,)`` for layouts ``(P, n, 8)``; with
    ``weights`` (P, terms), each layout by its own, which replace those of ``p``. With ``routes``
    (0,) the route is not looked at.

    The rest is scratch; ``costs`` (c, ...) keeps the parts of the last layouts. Where there is room
    for one, and all are weighed alike, items that stand as in the layout before are not looked at
    again.
    """
    alike = costs.sums.shape[0] == 1 and weights.shape[0] == 0
    for k in range(population.shape[0]):
        for t in range(weights.shape[1] if k < weights.shape[0] else 0):
            p.weights[t] = weights[k, t]
        parts = part_of(costs, k % costs.sums.shape[0])
        energies[k] = measure(population, k, p, parts, not alike or k == 0)
        if k < routes.shape[0]:
            routes[k] = 0.0
            if p.weights[ROUTE] != 0.0:
                routes[k] = p.weights[ROUTE] * route(
                    population[k], p.access, p.inset, grid, free, reached, math.inf
                )
                energies[k] += routes[k]


def energies_of(
    p: PreparedHome, grid: RouteGrid, population: Floats
) -> tuple[Floats, Floats, Costs]:
    """Energies ``(P,)``, the route's share in them, and the parts ``(1, ...)`` of the last
    layout."""
    return _measure_all(p, grid, population, np.zeros((0, 0)), 1)


def _measure_all(
    p: PreparedHome, grid: RouteGrid, population: Floats, weights: Floats, kept: int
) -> tuple[Floats, Floats, Costs]:
    """What :func:`fill_energies` writes, with the parts of the last ``kept`` layouts."""
    count, n = len(population), len(p.limits)
    energies, routes, costs = np.empty(count), np.empty(count), make_costs(kept, n, len(p.pairs))
    free, reached = np.empty_like(grid.free), np.empty_like(grid.free)
    boxes = np.ascontiguousarray(population, np.float64).reshape(count * n, 5)
    frames = frames_of(boxes).reshape(count, n, 8)
    fill_energies(p, grid, frames, weights, energies, routes, costs, free, reached)
    return energies, routes, costs


def costs_of(p: PreparedHome, grid: RouteGrid, frames: Floats) -> Costs:
    """All parts of the energies of layouts (P, n, 8) but the route's."""
    costs = make_costs(len(frames), frames.shape[1], len(p.pairs))
    scratch = (np.empty(len(frames)), np.empty(0), costs, grid.free[:0], grid.free[:0])
    fill_energies(p, grid, frames, np.zeros((0, 0)), *scratch)
    return costs


def evaluate(problem: Problem, boxes: Floats, cell: float = 0.1) -> Floats:
    """Energies ``(P,)`` of a population of layouts ``(P, n, 5)``; lower is better.

    ``cell`` is the size of the cells of the walking route's grid.
    """
    grid = route_grid(problem, cell)
    return energies_of(prepare(problem), grid, boxes)[0]


def empty_layout(problem: Problem) -> Layout:
    """The only layout of a problem without items."""
    return Layout(np.zeros((0, 5)), float(evaluate(problem, np.zeros((1, 0, 5)))[0]))


def _parts(
    row: TermRow, weight: float, energy: float, costs: Costs, pairs: Ints, names: tuple[str, ...]
) -> list[Part]:
    """The parts of one term, from the energy and its parts where it alone counts, with weight
    1."""
    divisor = float(costs.boxes[:, 2].sum()) if row.per_area else 1.0
    if row.kind in ("whole", "layout"):
        found = [("", energy)]
    elif row.kind == "box":
        found = list(zip(names, costs.boxes[:, 0 if row.per_area else 1] / divisor, strict=True))
    else:
        places = np.argwhere(np.triu(costs.pairs)) if row.per_area else pairs
        values = costs.pairs[tuple(places.T)] if row.per_area else costs.relations
        labels = [f"{names[i]} & {names[j]}" for i, j in places]
        found = list(zip(labels, values / divisor, strict=True))
    return [
        Part(item, row.name, float(value), weight, weight * float(value))
        for item, value in found
        if value != 0.0
    ]


def explain(problem: Problem, boxes: Floats, cell: float = 0.05) -> list[Part]:
    """Every part of the energy of a layout ``(n, 5)`` that is not zero, term by term; the costs
    sum to the energy."""
    prepared, grid = prepare(problem), route_grid(problem, cell)
    rows = [row for row in TERMS if prepared.weights[row.number] != 0.0]
    only = np.eye(len(TERMS))[[row.number for row in rows]]
    layouts = np.repeat(np.array(boxes, np.float64)[None], len(rows), axis=0)
    alone = prepared._replace(weights=np.zeros(len(TERMS)))
    energies, _, costs = _measure_all(alone, grid, layouts, only, max(len(rows), 1))
    parts: list[Part] = []
    for k, row in enumerate(rows):
        weight, mine = float(prepared.weights[row.number]), Costs(*(part[k] for part in costs))
        parts += _parts(row, weight, float(energies[k]), mine, prepared.pairs, problem.names)
    return parts


def judge(problem: Problem, boxes: Floats, cell: float = 0.05) -> Evaluation:
    """Energy and parts of one layout ``(n, 5)``."""
    parts = tuple(explain(problem, boxes, cell))
    return Evaluation(float(evaluate(problem, boxes[None], cell)[0]), parts)
