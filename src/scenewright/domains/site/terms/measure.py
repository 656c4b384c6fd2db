"""Sums of the terms of sites over buildings and pairs, whole or for one building that moves.

Neighbours are found in buckets, so a move costs the same on large sites as on small ones.
A building of no width is one left out.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.terms.table import (
    FACING,
    INSERT,
    LEFT,
    OVERLAP,
    QUALITY,
    ROAD,
    SITE_TERMS,
    facing_cost,
    read_site_weights,
    repaired_sum,
    share_of,
)
from scenewright.engine.whole_terms import TermData, gather, join_terms
from scenewright.geometry.boxes import (
    Frame,
    area_in_polygon,
    common_area,
    frames_of,
    make_frame,
    part_of,
    read_frame,
)
from scenewright.geometry.buckets import Buckets, column_of, insert, make_buckets, remove, row_of
from scenewright.geometry.compiled import compiled, inlined
from scenewright.geometry.rings import Rings, make_rings, ring_in_box, ring_in_polygon, ring_in_ring

Floats = NDArray[np.float64]


class SitePrepared(NamedTuple):
    """A problem ready for compiled code: ``edges`` (e, 4) of the site, ``block_edges`` (f, 4),
    ``blocks`` (b, 7) bounds x0, y0, x1, y1, first and last edge and share of all ground up to
    this one; ``landmarks`` (l, 8) frames grown by half the way round; ``buildings`` (n, 3) width,
    depth, quality; ``measures`` (3,) half the spacing, half the way round, preferred heading;
    ``weights`` (terms,) signed so that their product with the terms is to be small. ``rings`` are
    the footprints, bare, with half the spacing and with half the way round; none if all are boxes.
    ``own`` are the numbers of the terms with data of their own."""

    edges: Floats
    block_edges: Floats
    blocks: Floats
    landmarks: Floats
    buildings: Floats
    measures: Floats
    weights: Floats
    rings: Rings
    own: TermData


class SiteState(NamedTuple):
    """A layout with its terms: ``frames`` (n, 8), ``sums`` (terms,); ``old`` and ``new`` (terms,)
    what a building costs before and after the move last tried."""

    frames: Floats
    sums: Floats
    old: Floats
    new: Floats
    buckets: Buckets


def prepare_site(problem: SiteProblem) -> SitePrepared:
    """The arrays of a problem as kernels read them."""
    ground, made = problem.ground, problem.buildings
    rows = []
    for (a, b), share in zip(
        ground.block_spans,
        np.cumsum(ground.block_areas) / max(ground.block_areas.sum(), 1e-9),
        strict=True,
    ):
        xs, ys = ground.block_edges[a:b, [0, 2]], ground.block_edges[a:b, [1, 3]]
        rows.append([xs.min(), ys.min(), xs.max(), ys.max(), a, b, share])
    boxes = np.array(ground.landmarks, np.float64).reshape(-1, 5)
    boxes[:, 3:] += problem.fire_access
    weights = read_site_weights(problem.weights)
    weights[QUALITY] *= -1.0
    return SitePrepared(
        np.ascontiguousarray(ground.edges),
        np.ascontiguousarray(ground.block_edges),
        np.array(rows).reshape(-1, 7),
        frames_of(boxes),
        np.column_stack([made.sizes[:, :2], made.quality]).reshape(-1, 3),
        np.array([0.5 * problem.spacing, 0.5 * problem.fire_access, problem.facing]),
        weights,
        make_rings(
            made.outlines() if made.footprints else [],
            (0.0, 0.5 * problem.spacing, 0.5 * problem.fire_access),
        ),
        gather(SITE_TERMS, problem),
    )


building_cost = join_terms(SITE_TERMS)
"""Weighted costs of one building, of the terms with data of their own."""


def make_site_state(problem: SiteProblem) -> SiteState:
    """Room for one layout, all buildings left out."""
    sizes = problem.buildings.sizes[:, :2]
    margin = max(problem.spacing, problem.fire_access)
    radii = 0.5 * np.hypot(sizes[:, 0] + margin, sizes[:, 1] + margin)
    count = len(SITE_TERMS)
    return SiteState(
        np.zeros((len(sizes), 8)),
        np.zeros(count),
        np.zeros(count),
        np.zeros(count),
        make_buckets(problem.ground.bounds, radii),
    )


@inlined
def grow_frame(frame: Frame, by: float) -> Frame:
    """A box with ``by`` metres more on every side."""
    return part_of(frame, 0.0, 0.0, frame[4] + by, frame[5] + by)


@compiled
def inside_blocks(p: SitePrepared, frame: Frame) -> float:
    """Area of a box inside the buildable blocks, square metres."""
    total, x, y, r = 0.0, frame[0], frame[1], frame[6]
    for k in range(p.blocks.shape[0]):
        b = p.blocks[k]
        if x + r > b[0] and y + r > b[1] and x - r < b[2] and y - r < b[3]:
            total += area_in_polygon(frame, p.block_edges[int(b[4]) : int(b[5])])
    return total


@inlined
def inside_as_built(p: SitePrepared, i: int, frame: Frame) -> float:
    """Area of building ``i`` at ``frame`` inside the buildable blocks, square metres."""
    if p.rings.spans.shape[0] == 0:
        return inside_blocks(p, frame)
    total, x, y, r = 0.0, frame[0], frame[1], frame[6]
    for k in range(p.blocks.shape[0]):
        b = p.blocks[k]
        if x + r > b[0] and y + r > b[1] and x - r < b[2] and y - r < b[3]:
            total += ring_in_polygon(frame, p.rings, i, 0, p.block_edges[int(b[4]) : int(b[5])])
    return total


@inlined
def area_as_built(p: SitePrepared, i: int, frame: Frame, grown: int) -> float:
    """Area of building ``i``, bare (0), with half the spacing (1) or half the way round (2)."""
    if p.rings.spans.shape[0] > 0:
        return p.rings.facts[i, grown, 3]
    by = p.measures[grown - 1] if grown > 0 else 0.0
    return 4.0 * (frame[4] + by) * (frame[5] + by)


@compiled
def pair_of_rings(a: Frame, i: int, b: Frame, j: int, p: SitePrepared) -> tuple[float, float]:
    """:func:`pair_cost` of buildings that are no boxes."""
    first, second = p.rings.facts[i], p.rings.facts[j]
    close, near = ring_in_ring(a, i, b, j, 1, p.rings), ring_in_ring(a, i, b, j, 2, p.rings)
    shared = share_of(close, min(first[1, 3], second[1, 3]))
    return shared, share_of(near, first[2, 3]) + share_of(near, second[2, 3])


@inlined
def pair_cost(a: Frame, i: int, b: Frame, j: int, p: SitePrepared) -> tuple[float, float]:
    """Overlap and way round two buildings share.

    Overlap: area common to both, each grown by half the spacing, over the lesser of the two grown
    areas. Way round: each building owns half the width of the way on all sides; the area where
    both halves meet, as a share of the one and of the other.
    """
    if p.rings.spans.shape[0] > 0:
        return pair_of_rings(a, i, b, j, p)
    half, way = p.measures[0], p.measures[1]
    shared, blocked = 0.0, 0.0
    most = max(half, way)
    common = common_area(grow_frame(a, most), grow_frame(b, most))
    if common > 0.0:
        least = (
            common
            if half == way
            else common_area(grow_frame(a, min(half, way)), grow_frame(b, min(half, way)))
        )
        close, near = (common, least) if half >= way else (least, common)
        own = 4.0 * min((a[4] + half) * (a[5] + half), (b[4] + half) * (b[5] + half))
        shared = share_of(close, own)
        blocked = share_of(near, 4.0 * (a[4] + way) * (a[5] + way))
        blocked += share_of(near, 4.0 * (b[4] + way) * (b[5] + way))
    return shared, blocked


@compiled
def look(p: SitePrepared, s: SiteState, i: int, frame: Frame, out: Floats) -> None:
    """Write what building ``i`` would cost at ``frame`` (terms,), with all its pairs among those in
    the buckets.

    Its way round is also blocked by landmarks, grown alike, and by what lies outside the site.
    """
    for k in range(out.shape[0]):
        out[k] = 0.0
    if frame[4] <= 0.0:
        out[LEFT] = 1.0
        return
    wide = grow_frame(frame, p.measures[1])
    area, whole = area_as_built(p, i, frame, 0), area_as_built(p, i, frame, 2)
    out[INSERT] = max(1.0 - share_of(inside_as_built(p, i, frame), area), 0.0)
    out[FACING] = facing_cost(frame[7], p.measures[2])
    out[QUALITY] = p.buildings[i, 2]
    if p.rings.spans.shape[0] == 0:
        blocked = whole - area_in_polygon(wide, p.edges)
        for k in range(p.landmarks.shape[0]):
            blocked += common_area(wide, read_frame(p.landmarks, k))
    else:
        blocked = whole - ring_in_polygon(frame, p.rings, i, 2, p.edges)
        for k in range(p.landmarks.shape[0]):
            blocked += ring_in_box(frame, i, 2, p.rings, read_frame(p.landmarks, k))
    out[ROAD] = share_of(blocked, whole)
    look_around(p, s, i, frame, out)
    building_cost(s.frames, i, frame, p.weights, p.own, out)


@inlined
def look_around(p: SitePrepared, s: SiteState, i: int, frame: Frame, out: Floats) -> None:
    """Add the pairs of building ``i`` at ``frame`` to its costs ``out`` (terms,)."""
    b, x, y = s.buckets, frame[0], frame[1]
    far = grow_frame(frame, max(p.measures[0], p.measures[1]))[6] + b.reach
    left, right = column_of(b, x - far), column_of(b, x + far)
    low, high = row_of(b, y - far), row_of(b, y + far)
    across = right - left + 1
    for k in range(across * (high - low + 1) + 1):
        place = (low + k // across) * b.columns + left + k % across
        if k == across * (high - low + 1):
            place = b.columns * b.rows
        j = b.heads[place]
        while j >= 0:
            if j != i:
                shared, blocked = pair_cost(frame, i, read_frame(s.frames, j), j, p)
                out[OVERLAP] += shared
                out[ROAD] += blocked
            j = b.after[j]


@inlined
def put(p: SitePrepared, s: SiteState, i: int, frame: Frame) -> None:
    """Let building ``i`` stand at ``frame``, filed there; of no width: nowhere."""
    remove(s.buckets, i)
    for k in range(8):
        s.frames[i, k] = frame[k]
    if frame[4] > 0.0:
        radius = grow_frame(frame, max(p.measures[0], p.measures[1]))[6]
        insert(s.buckets, i, frame[0], frame[1], radius)


@compiled
def lay(p: SitePrepared, s: SiteState, boxes: Floats) -> None:
    """Let all buildings stand where ``boxes`` (n, 5) say, and sum up their terms."""
    for i in range(s.frames.shape[0]):
        remove(s.buckets, i)
    for k in range(s.sums.shape[0]):
        s.sums[k] = 0.0
    for i in range(s.frames.shape[0]):
        frame = make_frame(boxes[i, 0], boxes[i, 1], boxes[i, 2], boxes[i, 3], boxes[i, 4])
        look(p, s, i, frame, s.new)
        put(p, s, i, frame)
        for k in range(s.sums.shape[0]):
            s.sums[k] += s.new[k]


@compiled
def lay_all(p: SitePrepared, s: SiteState, population: Floats, terms: Floats) -> None:
    """Write the terms (P, terms) of many layouts (P, n, 5)."""
    for row in range(population.shape[0]):
        lay(p, s, population[row])
        for k in range(terms.shape[1]):
            terms[row, k] = s.sums[k]


@compiled
def change(p: SitePrepared, s: SiteState, i: int, frame: Frame) -> float:
    """Change of the energy if building ``i`` went to ``frame``; nothing is moved yet."""
    look(p, s, i, read_frame(s.frames, i), s.old)
    look(p, s, i, frame, s.new)
    total = 0.0
    for k in range(s.sums.shape[0]):
        total += p.weights[k] * (s.new[k] - s.old[k])
    return total


@compiled
def change_of_fitness(p: SitePrepared, s: SiteState, i: int, frame: Frame, most: float) -> float:
    """How far f_cost of (6) as printed, with E_max ``most``, falls if building ``i`` went to
    ``frame``; nothing is moved yet."""
    look(p, s, i, read_frame(s.frames, i), s.old)
    look(p, s, i, frame, s.new)
    return fitness(p, s, most, 0.0) - fitness(p, s, most, 1.0)


@compiled
def fitness(p: SitePrepared, s: SiteState, most: float, moved: float) -> float:
    """f_cost of (6) by the ratio (5), now (``moved`` 0) or after the move last looked at (1)."""
    cost, quality = 0.0, 0.0
    for k in range(s.sums.shape[0]):
        value = s.sums[k] + moved * (s.new[k] - s.old[k])
        if k == QUALITY:
            quality = -p.weights[k] * value
        elif k != LEFT:
            cost += p.weights[k] * value
    return max(most - cost / quality, 0.0) if quality > 1e-12 else 0.0


@compiled
def commit(p: SitePrepared, s: SiteState, i: int, frame: Frame) -> None:
    """Make the move last tried."""
    for k in range(s.sums.shape[0]):
        s.sums[k] += s.new[k] - s.old[k]
    put(p, s, i, frame)


@compiled
def stands(p: SitePrepared, s: SiteState, i: int, frame: Frame, loose: float) -> bool:
    """True if at ``frame`` a building lies in the blocks and keeps the spacing to all filed, give
    or take ``loose`` square metres each."""
    area = area_as_built(p, i, frame, 0)
    if frame[4] <= 0.0 or area - inside_as_built(p, i, frame) > loose:
        return False
    look(p, s, i, frame, s.new)
    return s.new[OVERLAP] * area_as_built(p, i, frame, 1) <= loose


def evaluate(problem: SiteProblem, population: Floats) -> Floats:
    """Terms (P, 6) of layouts (P, n, 5), columns as in ``SITE_TERMS``."""
    terms = np.empty((len(population), len(SITE_TERMS)))
    boxes = np.ascontiguousarray(population, np.float64)
    lay_all(prepare_site(problem), make_site_state(problem), boxes, terms)
    return terms


def energies(problem: SiteProblem, population: Floats) -> Floats:
    """Energies (P,) of layouts (P, n, 5) by the repaired sum."""
    weights = read_site_weights(problem.weights)
    return repaired_sum(evaluate(problem, population), weights, len(problem.buildings.sizes))


def energy_of(p: SitePrepared, s: SiteState) -> float:
    """The energy of the layout a state holds."""
    lost = -float(p.weights[QUALITY]) * len(p.buildings)
    return math.fsum([*(p.weights * s.sums).tolist(), lost])
