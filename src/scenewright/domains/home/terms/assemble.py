"""Where terms meet: what one box, one pair and the whole layout cost, weighted.

Each line calls one term if its weight is not zero. Costs per box come in two sums, because
areas are divided by the summed area of all items: ``shared`` (weight times square metres) and
``own`` (weight times value). Energy = Σ shared / Σ area + Σ own + whole.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.home.terms import (
    clearance,
    openings,
    orientation,
    packing,
    places,
    relations,
)
from scenewright.domains.home.terms.table import (
    AGAINST_WALL,
    AGAINST_WALL_PRINTED,
    ALIGNMENT,
    BOUNDARY,
    CLEAR_ITEMS,
    CLEAR_ROOM,
    CORRIDORS,
    DAYLIGHT,
    DAYLIGHT_KEPT,
    MAIN_WALL,
    MAIN_WALL_PRINTED,
    NESTLE,
    OPENINGS_KEPT,
    OVERLAP,
    PAIRS,
    PAIRS_PRINTED,
    PLACES,
    SIZE,
    TERMS,
    WISH,
)
from scenewright.engine.whole_terms import TermData, join_terms
from scenewright.geometry.boxes import (
    Floats,
    Frame,
    area_in_polygon,
    common_area,
    read_frame,
    read_sides,
)
from scenewright.geometry.compiled import inlined

Ints = NDArray[np.int64]


class PreparedHome(NamedTuple):
    """A problem ready for compiled code, in few arrays.

    ``zones`` (k, 10): frame of a box to be kept free, its term, the height it starts from.
    ``clear``, ``access``, ``inset`` (n, 4) as of the items. ``traits`` (n, 9): height,
    back to wall, main wall, daylight, nestle, preferred width and depth, how far clear zones
    stick out, how much it shades.
    ``limits`` (n, 4): least width and depth, greatest width and depth. ``pairs`` (p, 2) and
    ``targets`` (p, 4) with the weight last. ``related`` (2p,) lists the relations item i is in
    from ``related_start[i]`` to ``related_start[i + 1]``; ``places`` (s, 6) those it wants from
    ``place_start[i]`` on, of the ``spots`` (k, 4). ``normal`` is the main wall's inward
    direction (NaN without one), ``span`` the diagonal of the bounds. ``paths`` (m, 4) are the
    directed edges of the ways from door to door, ``strips`` (k, 10) what
    :func:`scenewright.domains.home.terms.openings.covered_width` takes, ``own`` the numbers of the
    terms that bring data of their own. A back is at its wall within ``flush`` metres.
    """

    edges: Floats
    walls: Floats
    zones: Floats
    clear: Floats
    access: Floats
    inset: Floats
    traits: Floats
    limits: Floats
    pairs: Ints
    targets: Floats
    related_start: Ints
    related: Ints
    place_start: Ints
    places: Floats
    spots: Floats
    weights: Floats
    bounds: Floats
    paths: Floats
    strips: Floats
    own: TermData
    area: float
    normal: float
    span: float
    flush: float


@inlined
def box_cost(
    frame: Frame, i: int, p: PreparedHome, area: float, most: float
) -> tuple[float, float, float, float]:
    """Weighted costs of item ``i`` standing at ``frame``: shared, own, its area, and its printed
    main-wall turn. Once shared + own * ``area`` is over ``most`` the rest is not looked at and
    shared is infinite: what is cheap to find and often wrong comes first."""
    w, shared, own, turn = p.weights, 0.0, 0.0, 0.0
    back, role, mine = p.traits[i, 1], p.traits[i, 2], 4.0 * frame[4] * frame[5]
    if w[BOUNDARY] != 0.0:
        shared += w[BOUNDARY] * packing.outside(frame, p.edges)
    if w[MAIN_WALL] != 0.0 and role != 0.0:
        own += w[MAIN_WALL] * orientation.main_wall(frame[7], role, p.normal)
    if w[MAIN_WALL_PRINTED] != 0.0 and role != 0.0:
        turn = orientation.main_wall_turn(frame[7], role, p.normal)
    if shared + own * area > most:
        return math.inf, own, mine, turn
    if w[AGAINST_WALL] != 0.0 and back != 0.0:
        own += w[AGAINST_WALL] * back * orientation.against_wall(frame, p.walls, p.flush)
    if w[AGAINST_WALL_PRINTED] != 0.0 and back != 0.0:
        own += w[AGAINST_WALL_PRINTED] * back * orientation.against_wall_printed(frame, p.walls)
    if shared + own * area > most:
        return math.inf, own, mine, turn
    shared += clearance.measure_entered_area(frame, p.traits[i, 0], p.zones, w)
    if shared + own * area > most:
        return math.inf, own, mine, turn
    if w[CORRIDORS] != 0.0 and p.paths.shape[0] > 0:
        shared += w[CORRIDORS] * area_in_polygon(frame, p.paths)
    if w[CLEAR_ROOM] != 0.0 and p.traits[i, 7] > 0.0:
        clear = read_sides(p.clear, i)
        shared += w[CLEAR_ROOM] * clearance.zone_blocked(frame, clear, p.edges, p.zones)
    return shared, add_place_cost(own, frame, i, p), mine, turn


@inlined
def add_place_cost(own: float, frame: Frame, i: int, p: PreparedHome) -> float:
    """The ``own`` costs so far and those of what item ``i`` has about it at ``frame``: nearest
    wall, windows, corners, its size, openings, and the places it wants."""
    w, back, light, snug = p.weights, p.traits[i, 1], p.traits[i, 3], p.traits[i, 4]
    if w[ALIGNMENT] != 0.0 and back < 1.0:
        own += w[ALIGNMENT] * (1.0 - back) * orientation.alignment(frame, p.walls)
    if w[DAYLIGHT] != 0.0 and light != 0.0:
        own += w[DAYLIGHT] * light * relations.daylight(frame, p.zones, p.span)
    if w[NESTLE] != 0.0 and snug != 0.0:
        own += w[NESTLE] * snug * relations.nestle(frame, p.walls, p.zones)
    if w[WISH] != 0.0:
        own += w[WISH] * packing.wish(frame, p.traits[i, 5], p.traits[i, 6])
    if w[OPENINGS_KEPT] != 0.0:
        own += w[OPENINGS_KEPT] * openings.covered_width(frame, p.strips, 0.0)
    if w[DAYLIGHT_KEPT] != 0.0 and p.traits[i, 8] != 0.0:
        own += w[DAYLIGHT_KEPT] * p.traits[i, 8] * openings.covered_width(frame, p.strips, 1.0)
    for k in range(p.place_start[i], p.place_start[i + 1]):
        own += w[PLACES] * places.place(frame, k, p.places, p.spots)
    return own


@inlined
def pair_cost(a: Frame, b: Frame, i: int, j: int, p: PreparedHome) -> float:
    """Weighted shared cost of items ``i`` at ``a`` and ``j`` at ``b``."""
    beyond_box = max(p.traits[i, 7], p.traits[j, 7])
    dx, dy, reach = b[0] - a[0], b[1] - a[1], a[6] + b[6] + beyond_box
    if dx * dx + dy * dy >= reach * reach:
        return 0.0
    shared = 0.0
    if p.weights[OVERLAP] != 0.0:
        shared += p.weights[OVERLAP] * common_area(a, b)
    if p.weights[CLEAR_ITEMS] != 0.0 and beyond_box > 0.0:
        clear_a, clear_b = read_sides(p.clear, i), read_sides(p.clear, j)
        shared += p.weights[CLEAR_ITEMS] * clearance.zones_covered(a, b, clear_a, clear_b)
    return shared


@inlined
def relation_cost(a: Frame, b: Frame, r: int, p: PreparedHome) -> float:
    """Weighted own cost of relation ``r`` between its first item at ``a`` and second at ``b``."""
    own, distance, angle = 0.0, p.targets[r, 0], p.targets[r, 1]
    if p.weights[PAIRS] != 0.0:
        own += p.weights[PAIRS] * relations.pair(a, b, distance, angle, p.targets[r, 2])
    if p.weights[PAIRS_PRINTED] != 0.0:
        own += p.weights[PAIRS_PRINTED] * relations.pair_printed(a, b, distance, angle)
    return own * p.targets[r, 3]


@inlined
def whole_cost(shared: float, own: float, area: float, turn: float, p: PreparedHome) -> float:
    """Energy from the sums over boxes and pairs; all but the route."""
    energy = own + p.weights[MAIN_WALL_PRINTED] * abs(turn)
    if area > 0.0:
        energy += shared / area
    if p.weights[SIZE] != 0.0:
        energy += p.weights[SIZE] * packing.size(area, p.area)
    return energy


layout_cost = join_terms(TERMS)
"""Weighted costs of the whole layout, of the terms with data of their own."""


class Costs(NamedTuple):
    """All parts of a layout's energy but the route: of ``boxes`` (n, 4) as :func:`box_cost` gives
    them, ``pairs`` (n, n) symmetric, ``relations`` (r,), and the ``sums`` (4,) of the columns of
    boxes with pairs and relations added."""

    boxes: Floats
    pairs: Floats
    relations: Floats
    sums: Floats


def make_costs(count: int, n: int, relations: int) -> Costs:
    """Room for the parts ``(count, ...)`` of layouts of ``n`` items."""
    return Costs(*map(np.zeros, ((count, n, 4), (count, n, n), (count, relations), (count, 4))))


@inlined
def part_of(costs: Costs, k: int) -> Costs:
    """The parts of layout ``k`` of several."""
    return Costs(costs.boxes[k], costs.pairs[k], costs.relations[k], costs.sums[k])


@inlined
def keep_box(frames: Floats, i: int, p: PreparedHome, costs: Costs) -> None:
    """Write what item ``i`` of frames (n, 8) costs alone."""
    boxes = costs.boxes
    cost = box_cost(read_frame(frames, i), i, p, 0.0, math.inf)
    boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3] = cost


@inlined
def keep_pair(frames: Floats, i: int, j: int, p: PreparedHome, costs: Costs) -> None:
    """Write what items ``i`` and ``j`` of frames (n, 8) cost together."""
    value = pair_cost(read_frame(frames, i), read_frame(frames, j), i, j, p)
    costs.pairs[i, j] = costs.pairs[j, i] = value


@inlined
def keep_relation(frames: Floats, r: int, p: PreparedHome, costs: Costs) -> None:
    """Write what relation ``r`` between items of frames (n, 8) costs."""
    first, second = read_frame(frames, p.pairs[r, 0]), read_frame(frames, p.pairs[r, 1])
    costs.relations[r] = relation_cost(first, second, r, p)


@inlined
def sum_parts(frames: Floats, p: PreparedHome, costs: Costs) -> float:
    """Energy without the route of frames (n, 8) whose parts are in ``costs``; their sums are
    written there."""
    shared, own, area, turn, boxes = 0.0, 0.0, 0.0, 0.0, costs.boxes
    for i in range(frames.shape[0]):
        shared, own = shared + boxes[i, 0], own + boxes[i, 1]
        area, turn = area + boxes[i, 2], turn + boxes[i, 3]
        for j in range(i):
            shared += costs.pairs[i, j]
    for r in range(p.pairs.shape[0]):
        own += costs.relations[r]
    costs.sums[0], costs.sums[1], costs.sums[2], costs.sums[3] = shared, own, area, turn
    nowhere = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    energy = whole_cost(shared, own, area, turn, p)
    return energy + layout_cost(frames, -1, nowhere, p.weights, p.own, p.weights[:0])


@inlined
def is_as_before(population: Floats, k: int, i: int) -> bool:
    """Whether item ``i`` of layout ``k`` > 0 of a population (P, n, 8) stands as in the one before
    it."""
    same = True
    for c in range(8):
        same &= population[k, i, c] == population[k - 1, i, c]
    return same


@inlined
def measure(population: Floats, k: int, p: PreparedHome, costs: Costs, anew: bool) -> float:
    """Energy without the route of layout ``k`` of a population (P, n, 8); all its parts are
    written to ``costs``. If not ``anew``, these are those of the layout before it, and only what
    moved is looked at again.

    The terms are compiled into a kernel as often as they are called in it: so both are one.
    """
    frames = population[k]
    for i in range(frames.shape[0]):
        stays = not anew and is_as_before(population, k, i)
        if not stays:
            keep_box(frames, i, p, costs)
        for j in range(i):
            if not (stays and is_as_before(population, k, j)):
                keep_pair(frames, i, j, p, costs)
    for r in range(p.pairs.shape[0]):
        i, j = p.pairs[r, 0], p.pairs[r, 1]
        if anew or not (is_as_before(population, k, i) and is_as_before(population, k, j)):
            keep_relation(frames, r, p, costs)
    return sum_parts(frames, p, costs)
