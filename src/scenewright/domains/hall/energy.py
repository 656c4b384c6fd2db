"""Energy of halls: from a problem to arrays for kernels, one layout's energy and its parts.

Eq. 1 divides covered clearance by β, the clearance demanded, which the paper defines below it. As
printed, δ of eq. 3 sums footprints and clearances, which stay the same wherever a group stands.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.patterns.fan import ROW, near_radius
from scenewright.domains.hall.problem import HallProblem, Units, VisitorPlan
from scenewright.domains.hall.terms.measure import block_solids
from scenewright.domains.hall.terms.standing import find_reached
from scenewright.domains.hall.terms.state import (
    LINE,
    STATE_STEP,
    Floats,
    Ints,
    Kept,
    PreparedHall,
    State,
    make_scratch,
)
from scenewright.domains.hall.terms.table import HALL_TERMS, REACH, read_hall_weights
from scenewright.domains.hall.terms.visitors import MAIN
from scenewright.engine.energy import Part
from scenewright.engine.whole_terms import gather
from scenewright.geometry.boxes import frames_of
from scenewright.geometry.buckets import make_buckets
from scenewright.geometry.paths import RouteGrid, make_grid

SAME_WAY = math.radians(1.0)
"""Edges that differ by less run the same way."""


def _fresh(array: Floats | Ints, width: int) -> Floats:
    return np.array(array, np.float64, order="C").reshape(-1, width)


def prepare(problem: HallProblem) -> PreparedHall:
    """Arrays and weights of a problem, ready for compiled code."""
    ground, units = problem.ground, problem.units
    hosts = _fresh(ground.hosts, 6)
    stretches = _stretches(problem, hosts)
    loops, loop_spans = _by_zone(stretches[:, 5], len(ground.zone_areas))
    borders = _fresh(ground.borders, 5)
    counts = np.floor(np.hypot(*(borders[:, 2:4] - borders[:, :2]).T) / STATE_STEP).astype(np.int64)
    starts = np.concatenate([[0], np.cumsum(counts)[:-1]]) if len(counts) else counts
    cells = np.stack([starts, counts], 1).astype(np.int64).reshape(-1, 2)
    p = PreparedHall(
        edges=_fresh(ground.edges, 4),
        standing=frames_of(_fresh(ground.standing, 5)),
        standing_access=_fresh(ground.standing_access, 4),
        obstacles=frames_of(_fresh(ground.obstacles, 5)),
        keep_free=frames_of(_fresh(ground.keep_free, 5)),
        zone_edges=_fresh(ground.zone_edges, 4),
        zone_spans=np.array(ground.zone_spans, np.int64).reshape(-1, 2),
        zone_areas=np.array(ground.zone_areas, np.float64),
        zone_bounds=_fresh(ground.zone_bounds, 4),
        least=np.array(ground.zone_least, np.float64),
        middles=_middles(problem),
        borders=borders,
        border_cells=cells,
        blocked=np.zeros(int(counts.sum()), np.uint8),
        links=_fresh(ground.links, 3),
        hosts=hosts,
        stretches=stretches,
        loops=loops,
        loop_spans=loop_spans,
        thickness=float(ground.thickness),
        passage=float(problem.passage),
        weights=read_hall_weights(problem.weights),
        axes=_axes(ground.edges),
        host_spans=_host_spans(problem, hosts),
        host_shifts=_or_zeros(ground.host_shifts, 2 * len(hosts)).reshape(-1, 2),
        wall_needs=_or_zeros(ground.zone_walls, len(ground.zone_areas)),
        uneven=_uneven(units, ground.zone_areas),
        **_unit_arrays(units, problem.settings.printed),
        own=gather(HALL_TERMS, problem),
        **_visitor_arrays(problem.visitors, len(units.sizes), len(units.spans)),
    )
    _block(p)
    return _keep_reachable(problem, p) if len(p.standing) else p


def _keep_reachable(problem: HallProblem, p: PreparedHall) -> PreparedHall:
    """Without the locked objects that no route leads to even where nothing else stands."""
    grid, none = route_grid(problem, p), np.zeros((0, 8))
    free, reached = (np.zeros(grid.free.shape, np.uint64) for _ in range(2))
    found = np.zeros(len(p.standing))
    find_reached(p.standing, p.standing_access, none, grid, free, reached, found)
    kept = found > 0.0
    return p._replace(standing=p.standing[kept], standing_access=p.standing_access[kept])


def _stretches(problem: HallProblem, hosts: Floats) -> Floats:
    """Stretches with direction and length, and two empty ones for every host."""
    given = _fresh(problem.ground.stretches, 6)
    way = given[:, 2:4] - given[:, :2]
    length = np.maximum(np.hypot(way[:, 0], way[:, 1]), 1e-9)
    rows = np.column_stack([given[:, :2], way / length[:, None], length, given[:, 4:]])
    sides = np.zeros((2 * len(hosts), 7))
    sides[0::2, 5], sides[1::2, 5] = hosts[:, 4], hosts[:, 5]
    return np.concatenate([rows, sides])


def _by_zone(zone: Floats, zones: int) -> tuple[Ints, Ints]:
    """Row numbers sorted by zone, and the span of each zone among them."""
    order = np.argsort(zone, kind="stable").astype(np.int64)
    ends = np.searchsorted(zone[order], np.arange(zones + 1)).astype(np.int64)
    return order, np.stack([ends[:-1], ends[1:]], 1)


def _middles(problem: HallProblem) -> Floats:
    """Centroids of the zones (holes are rows of edges like the outline)."""
    found = []
    for first, last in np.asarray(problem.ground.zone_spans).reshape(-1, 2):
        x0, y0, x1, y1 = np.asarray(problem.ground.zone_edges)[first:last].T
        cross = x0 * y1 - x1 * y0
        twice = 3.0 * cross.sum()
        found.append([((x0 + x1) * cross).sum() / twice, ((y0 + y1) * cross).sum() / twice])
    return np.array(found, np.float64).reshape(-1, 2)


def capacity(counts: Ints) -> Ints:
    """How many layers units of ``counts`` objects may have.

    ``counts`` (g,) objects of each unit; the layers (g,).
    """
    rows = 6 + 3 * np.ceil(np.sqrt(counts)).astype(np.int64)
    found: Ints = np.maximum(np.minimum(counts, rows), 1)
    return found


def _axes(edges: Floats) -> Floats:
    """Directions along and across the hall (2, 3), with the least distance along each of the
    outline, a little less so that round numbers lie within cells."""
    angle = _main_angle(_fresh(edges, 4))
    ways = np.array([[math.cos(angle), math.sin(angle)], [-math.sin(angle), math.cos(angle)]])
    low = (ways @ _fresh(edges, 4)[:, :2].T).min(axis=1, initial=0.0) - 0.37 * LINE
    return np.column_stack([ways, low])


def _main_angle(edges: Floats) -> float:
    """The direction, modulo a quarter turn, of the edges (e, 4) that together are longest."""
    if not len(edges):
        return 0.0
    way = edges[:, 2:] - edges[:, :2]
    angles, quarter = np.arctan2(way[:, 1], way[:, 0]), math.pi / 2
    apart = np.abs((angles[:, None] - angles + quarter / 2) % quarter - quarter / 2)
    along = (apart < SAME_WAY) @ np.hypot(way[:, 0], way[:, 1])
    return float(angles[int(np.argmax(np.round(along, 3)))] % quarter)


def _host_spans(problem: HallProblem, hosts: Floats) -> Floats:
    if len(problem.ground.host_spans):
        return _fresh(problem.ground.host_spans, 2)
    length = np.hypot(hosts[:, 2] - hosts[:, 0], hosts[:, 3] - hosts[:, 1])
    return np.column_stack([np.zeros(len(hosts)), length])


def _uneven(units: Units, areas: Floats) -> float:
    """Eq. 8 for floor: mean over zones of abs(U_a of the zone - U_a), footprints over floor."""
    areas = np.array(areas, np.float64)
    if not len(areas) or not len(units.sizes):
        return 0.0
    zone_of = np.repeat(units.zones, np.diff(np.asarray(units.spans).reshape(-1, 2))[:, 0])
    taken = np.bincount(zone_of, np.asarray(units.sizes).prod(1), len(areas))
    shares = taken / np.maximum(areas, 1e-9)
    return float(np.abs(shares - taken.sum() / max(float(areas.sum()), 1e-9)).mean())


def _or_zeros(given: Floats, count: int) -> Floats:
    return np.array(given, np.float64) if len(given) else np.zeros(count)


def _unit_arrays(units: Units, printed: bool) -> dict[str, Any]:
    sizes, clear = _fresh(units.sizes, 2), _fresh(units.clear, 4)
    spans = np.array(units.spans, np.int64).reshape(-1, 2)
    counts = spans[:, 1] - spans[:, 0]
    rows = capacity(counts)
    ends = np.cumsum(rows)
    demanded = (sizes[:, 0] + clear[:, 1] + clear[:, 3]) * (sizes[:, 1] + clear[:, 0] + clear[:, 2])
    choices = np.array(units.choices, np.int64).reshape(len(spans), -1 if len(spans) else WALL + 1)
    beta, largest, gaps = np.zeros(len(spans)), np.zeros((len(spans), 2)), np.zeros((len(spans), 2))
    constant, near = np.full(len(spans), -1.0), np.zeros(len(spans))
    several_sides = (_fresh(units.access, 4) > 0.0).sum(1) > 1
    for u, (first, last) in enumerate(spans):
        beta[u] = (demanded - sizes.prod(1))[first:last].sum()
        constant[u] = demanded[first:last].sum() if printed else -1.0
        largest[u] = sizes[first:last].max(0)
        ahead, left, back, right = clear[first:last].max(0)
        gaps[u] = left + right, ahead + back
        wide, deep = largest[u]
        near[u] = near_radius(last - first, wide * (deep + max(gaps[u, 1], ROW)))
    return {
        "sizes": sizes,
        "clear": clear,
        "access": _fresh(units.access, 4),
        "strolled": several_sides.astype(np.int64),
        "unit_of": np.repeat(np.arange(len(spans)), counts).astype(np.int64),
        "spans": spans,
        "zones": np.array(units.zones, np.int64),
        "choices": choices,
        "wall_bound": (choices[:, WALL] * (choices.sum(axis=1) == 1)).astype(np.int64),
        "beta": np.maximum(beta, 1e-9),
        "constant": constant,
        "iota": clear.max(1, initial=0.0),
        "largest": largest,
        "gaps": gaps,
        "near": near,
        "targets": np.array(units.targets, np.int64),
        "layer_spans": np.stack([ends - rows, ends], 1).astype(np.int64),
    }


def _visitor_arrays(visitors: VisitorPlan, objects: int, groups: int) -> dict[str, Any]:
    roles = _or_zeros(visitors.roles, groups).astype(np.int64)
    main = np.flatnonzero(roles & MAIN) if len(visitors.entrances) else roles[:0]
    return {
        "entrances": _fresh(visitors.entrances, 2),
        "exits": _fresh(visitors.exits, 2),
        "ways_out": _fresh(visitors.ways_out, 2),
        "inward": _fresh(visitors.inward, 2),
        "hiding": frames_of(_fresh(visitors.hiding, 5)),
        "tall": _or_zeros(visitors.tall, objects),
        "roles": roles,
        "main": int(main[0]) if len(main) else -1,
    }


def _block(p: PreparedHall) -> None:
    """Mark what walls and obstacles block of every border."""
    work = make_scratch(p)
    way = p.edges[:, 2:] - p.edges[:, :2]
    heading = np.arctan2(way[:, 0], -way[:, 1])
    boxes = np.column_stack(
        [(p.edges[:, :2] + p.edges[:, 2:]) / 2, heading, np.hypot(*way.T), np.zeros(len(way))]
    )
    frames = frames_of(np.ascontiguousarray(boxes))
    for k, (start, count) in enumerate(p.border_cells):
        work.cells[:] = 0
        block_solids(p, k, float(p.links[int(p.borders[k, 4]), 2]), frames, work)
        p.blocked[start : start + count] = work.cells[:count]


def make_state(p: PreparedHall) -> State:
    """An empty state: nothing filed, no partitions."""
    n, g = len(p.sizes), len(p.spans)
    rows = int(p.layer_spans[-1, 1]) if g else 0
    many = max(g, len(p.zone_areas), len(p.links), 1)
    clear = p.clear
    radii = 0.5 * np.hypot(
        p.sizes[:, 0] + clear[:, 1] + clear[:, 3], p.sizes[:, 1] + clear[:, 0] + clear[:, 2]
    )
    low, high = p.edges.reshape(-1, 2).min(0), p.edges.reshape(-1, 2).max(0)
    return State(
        np.zeros(g, np.int64),
        np.zeros((g, 4)),
        np.zeros((rows, 5)),
        np.ones(g, np.int64),
        np.zeros((n, 8)),
        np.zeros((n, 8)),
        np.zeros((len(p.hosts), 2)),
        np.zeros(len(p.hosts)),
        np.zeros((len(p.hosts), 8)),
        p.stretches.copy(),
        np.zeros((g, 3)),
        np.zeros((g, 3)),
        np.zeros((len(HALL_TERMS), many)),
        np.zeros((2, int(np.hypot(*(high - low)) / LINE) + 2), np.int64),
        np.zeros(g + 1, np.int64),
        make_buckets(np.concatenate([low, high]), radii),
    )


def route_grid(problem: HallProblem, p: PreparedHall) -> RouteGrid:
    """The grid of the visitors' route: cells of 0.1 m, larger in large halls; empty if the route
    is not weighed."""
    ground = problem.ground
    doors = frames_of(_fresh(ground.doors if p.weights[REACH] else np.zeros((0, 5)), 5))
    span = np.asarray(ground.bounds, np.float64)
    area = float((span[2] - span[0]) * (span[3] - span[1]))
    cell = max(0.1, math.sqrt(area / 250_000))
    return make_grid(
        p.edges, p.obstacles, doors, span * (1.0 if len(doors) else 0.0), cell, float(problem.route)
    )


def kept_of(s: State) -> Kept:
    """A copy of what makes a state's layout."""
    rows = np.stack([s.code, s.used], 1).astype(np.float64)
    return Kept(s.pose.copy(), s.layers.copy(), rows, s.partitions.copy(), s.offsets.copy())


def parts_of(problem: HallProblem, p: PreparedHall, s: State, missed: float) -> tuple[Part, ...]:
    """Every part of the energy of a measured state, of groups, zones and links by number
    where they have no name; their costs sum to the energy."""
    found = []
    for row in HALL_TERMS:
        weight = float(p.weights[row.number])
        if weight == 0.0:
            continue
        if row.kind == "hall":
            value = missed if row.number == REACH else float(s.costs[row.number, 0])
            found.append(Part("", row.name, value, weight, weight * value))
            continue
        names = _names_of(problem, row.kind)
        values = s.costs[row.number, : len(names)]
        found += [
            Part(name, row.name, float(v), weight, weight * float(v))
            for name, v in zip(names, values, strict=True)
        ]
    return tuple(found)


def _names_of(problem: HallProblem, of: str) -> tuple[str, ...]:
    if of == "group":
        return problem.names
    if of == "zone":
        return problem.zone_names
    return tuple(
        f"{problem.zone_names[int(i)]} & {problem.zone_names[int(j)]}"
        for i, j in np.asarray(problem.ground.links).reshape(-1, 3)[:, :2]
    )
