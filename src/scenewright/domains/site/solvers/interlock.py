"""Buildings that are no boxes set into each other's corners: what rows of boxes leave over.

Where the middle of a polygon can stand, turned some way, is exact: the block less the sums
(Minkowski) of the turned polygon with the edges of the block and with what keeps it away, both cut
into convex parts, whose sums are the hulls of the sums of their corners. Buildings are set one by
one, the largest first, at the corner of that region where all that stands stays most compact.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.footprint import Footprint, place_outline
from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.blocks.block import wrap_angle
from scenewright.domains.site.solvers.blocks.distances import noon
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.engine.solve import BudgetWatch

HAIR = 1e-3
"""Metres that buildings stand farther apart than asked for, so that rounding leaves the gap."""
SLACK = 4e-4
"""Metres by which a polygon is drawn in, so that what just fits does."""
MITRE = 2.0
LOOKED, NEAR = 4, math.radians(2.0)
"""Longest edges of a block that buildings may stand along where they fit no other way, and radians
within which two headings are one."""


FreeRegions = dict[tuple[bytes, float], tuple[shapely.Geometry, int]]
"""Where the middle of buildings alike (outline as turned, height) can stand in a block, and how
many of those that stand were cut out of it."""


class StandingBuilding(NamedTuple):
    """A building that stands: its polygon in the plan, and its height."""

    shape: shapely.Polygon
    height: float


def interlock(
    problem: SiteProblem,
    found: SiteLayout,
    watch: BudgetWatch,
    rng: np.random.Generator,
    begun: float = 0.0,
) -> tuple[SiteLayout, int]:
    """A layout with more on the ground, and how many were tried: what was left out is set between
    the buildings placed, or all is set anew, whichever holds most floor. Sites of boxes, and what
    is complete, stay as they are. ``begun`` is the share of the run done before."""
    made, rule = problem.buildings, problem.settings.interlock
    if not made.footprints or found.present.all() or len(made.sizes) > rule.many:
        return found, 0
    areas = np.array([shapely.Polygon(ring).area for ring in made.outlines()])
    best, attempt = found, 0
    for attempt in range(rule.tried):
        if watch.reached(begun, best._replace):
            break
        start = found if attempt == 0 else _clear(found)
        order = np.argsort(-areas * rng.uniform(0.9, 1.1, len(areas)), kind="stable")
        fresh = _set_all(problem, start, order.tolist(), attempt % 4, watch)
        if areas[fresh.present].sum() > areas[best.present].sum() + 1e-6:
            best = fresh
        if best.present.all():
            break
    return best, attempt + 1


def _clear(found: SiteLayout) -> SiteLayout:
    """The answer with nothing placed."""
    count = len(found.present)
    return found._replace(
        boxes=np.zeros((count, 5)), present=np.zeros(count, np.bool_), forms=("",) * count
    )


def _set_all(
    problem: SiteProblem, start: SiteLayout, order: list[int], corner: int, watch: BudgetWatch
) -> SiteLayout:
    """Everything of an order that is not there yet set where it fits, block by block."""
    made, outlines = problem.buildings, problem.buildings.outlines()
    boxes, present = start.boxes.copy(), start.present.copy()
    forms = list(start.forms or ("",) * len(present))
    standing = [
        _make_standing(outlines[i], boxes[i], made.sizes[i, 2]) for i in np.flatnonzero(present)
    ]
    for block in blocks_of(problem):
        free: FreeRegions = {}
        for i in order:
            free_form = not made.forms or not made.forms[i]
            if present[i] or not free_form:
                continue
            if watch.cancelled() or watch.share(0) >= 1.0:
                break
            box = _best_place(problem, block, outlines[i], made.sizes[i], standing, corner, free)
            if box is not None:
                boxes[i], present[i], forms[i] = box, True, ""
                standing.append(_make_standing(outlines[i], boxes[i], made.sizes[i, 2]))
    return start._replace(boxes=boxes, present=present, forms=tuple(forms), score={})


def _make_standing(outline: Floats, box: Floats, height: float) -> StandingBuilding:
    return StandingBuilding(shapely.Polygon(place_outline(outline, *box[:3])), float(height))


def _best_place(
    problem: SiteProblem,
    block: shapely.Polygon,
    outline: Floats,
    size: Floats,
    standing: Sequence[StandingBuilding],
    corner: int,
    free: FreeRegions,
) -> Floats | None:
    """The box of a building where it fits and takes least ground, its front to the preferred
    heading or a quarter off it, else along an edge of the block; None if it fits nowhere. ``free``
    keeps what was found for buildings alike: only what was set since is cut out of it."""
    best, least = None, math.inf
    usual = [wrap_angle(problem.facing + quarter * math.pi / 2) for quarter in range(4)]
    for number, heading in enumerate([*usual, *_headings_along(block, usual)]):
        if number == len(usual) and best is not None:
            break
        turned = place_outline(outline, 0.0, 0.0, heading)
        key = (turned.tobytes(), float(size[2]))
        region, known = free.get(key) or (places_in(block, turned), 0)
        region = clear_of(region, turned, keep_away(problem, standing[known:], float(size[2])))
        free[key] = region, len(standing)
        points = shapely.get_coordinates(region)
        if not len(points):
            continue
        off = abs(wrap_angle(heading - problem.facing)) / math.pi
        costs = _costs(problem, points, turned, [one.shape for one in standing], corner)
        costs *= 1.0 + problem.settings.interlock.turn * off
        k = int(np.argmin(costs))
        if costs[k] < least - 1e-9:
            best, least = np.array([*points[k], heading, size[0], size[1]]), float(costs[k])
    return best


def _headings_along(block: shapely.Polygon, usual: Sequence[float]) -> list[float]:
    """Headings, by quarters, along the longest edges of a block, which none of the usual ones is
    near to."""
    corners = shapely.get_coordinates(block.exterior)
    along = np.diff(corners, axis=0)
    found: list[float] = []
    for k in np.argsort(-np.hypot(*along.T), kind="stable")[:LOOKED]:
        heading = math.atan2(along[k, 1], along[k, 0])
        off = [abs(wrap_angle(4.0 * (heading - other))) for other in (*usual, *found)]
        if min(off) > 4.0 * NEAR:
            found += [wrap_angle(heading + quarter * math.pi / 2) for quarter in range(4)]
    return found


def _costs(
    problem: SiteProblem,
    points: Floats,
    turned: Floats,
    shapes: Sequence[shapely.Polygon],
    corner: int,
) -> Floats:
    """Square metres of the upright rectangle from a corner of the site about all that stands, with
    a building at each of some points (k, 2); equal ones by how far they lie from the corner."""
    c, s = math.cos(problem.facing), math.sin(problem.facing)
    sign = np.array([1 if corner % 2 else -1, 1 if corner // 2 else -1])
    frame = np.array([[s, c], [-c, s]])
    site = np.asarray(problem.ground.edges)[:, :2] @ frame * sign
    far = points @ frame * sign + (turned @ frame * sign).max(0) - site.min(0)
    stood = [shapely.get_coordinates(shape) @ frame * sign - site.min(0) for shape in shapes]
    reach = np.max([row.max(0) for row in stood], 0) if stood else np.zeros(2)
    whole = np.maximum(far, reach)
    costs: Floats = whole.prod(1) + 1e-3 * far.sum(1)
    return costs


def middles(
    block: shapely.Polygon, turned: Floats, kept: Sequence[shapely.Polygon]
) -> shapely.Geometry:
    """Where the origin of a polygon (k, 2) can stand so that it lies in a block and shares nothing
    with what is ``kept`` free, give or take :data:`SLACK`.

    >>> ell = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], float)
    >>> found = middles(shapely.box(0, 0, 3, 3), ell, [shapely.box(1.2, 1.0, 9.0, 9.0)])
    >>> [round(v, 2) + 0.0 for v in found.bounds]
    [0.0, 0.0, 0.2, 0.0]
    """
    return clear_of(places_in(block, turned), turned, kept)


def places_in(block: shapely.Polygon, turned: Floats) -> shapely.Geometry:
    """Where the origin of a polygon (k, 2) can stand so that it lies in a block."""
    parts = _convex_parts_of(turned)
    rings = [shapely.get_coordinates(ring)[:-1] for ring in (block.exterior, *block.interiors)]
    edges = np.concatenate([np.stack([r, np.roll(r, -1, axis=0)], 1) for r in rings])
    inner = np.mean(parts[0], 0)
    start = shapely.transform(block, lambda points: points - inner)
    return shapely.difference(start, _sums(list(edges), parts))


def clear_of(
    region: shapely.Geometry, turned: Floats, kept: Sequence[shapely.Polygon]
) -> shapely.Geometry:
    """The part of a region of origins where the polygon shares nothing with what is ``kept``."""
    if region.is_empty or not kept:
        return region
    obstacles = [np.array(part) for shape in kept for part in convex_parts(_corners(shape))]
    return shapely.difference(region, _sums(obstacles, _convex_parts_of(turned)))


def _convex_parts_of(turned: Floats) -> tuple[Footprint, ...]:
    """A polygon's convex parts, drawn in by :data:`SLACK`."""
    return convex_parts(_corners(shapely.Polygon(turned).buffer(-SLACK, join_style="mitre")))


def _sums(obstacles: Sequence[Floats], parts: Sequence[Footprint]) -> shapely.Geometry:
    """Where the origin may not be so that none of the convex ``parts`` meets an obstacle."""
    owners = np.repeat(np.arange(len(obstacles)), [len(one) for one in obstacles])
    points = np.concatenate(obstacles)
    hulls = []
    for part in parts:
        sums = (points[:, None] - np.array(part)).reshape(-1, 2)
        groups = shapely.multipoints(sums, indices=np.repeat(owners, len(part)))
        hulls.append(shapely.convex_hull(groups))
    return shapely.union_all(np.concatenate(hulls))


def _corners(shape: shapely.Polygon) -> Footprint:
    return tuple((x, y) for x, y in shapely.get_coordinates(shape.exterior)[:-1].tolist())


@lru_cache(maxsize=4096)
def convex_parts(outline: Footprint) -> tuple[Footprint, ...]:
    """Convex parts of a simple polygon that together cover it: itself, or its triangles, joined
    while the union stays convex.

    >>> [len(p) for p in convex_parts(((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)))]
    [4, 4]
    """
    shape = shapely.Polygon(outline)
    if _is_convex(shape):
        return (outline,)
    rest = list(shapely.get_parts(shapely.constrained_delaunay_triangles(shape)))
    parts: list[shapely.Polygon] = []
    while rest:
        one = rest.pop()
        joined = True
        while joined:
            joined = False
            for k, other in enumerate(rest):
                both = shapely.union(one, other)
                if both.geom_type == "Polygon" and _is_convex(both):
                    one, joined = both, True
                    rest.pop(k)
                    break
        parts.append(one.simplify(1e-9))
    return tuple(_corners(part) for part in parts)


def _is_convex(shape: shapely.Polygon) -> bool:
    return bool(shapely.convex_hull(shape).area - shape.area < 1e-9 * max(shape.area, 1.0))


def keep_away(
    problem: SiteProblem, standing: Sequence[StandingBuilding], height: float
) -> list[shapely.Polygon]:
    """The floor a building ``height`` metres high must keep off: the spacing, or a way, around each
    building standing; for the sun, multiples of its height behind it and of the new one's before
    it."""
    gap = max(problem.spacing, problem.fire_access) + HAIR
    sun = problem.sun_spacing
    found = []
    for one in standing:
        found.append(one.shape.buffer(gap, join_style="mitre", mitre_limit=MITRE))
        if sun > 0.0:
            found += _shades(one.shape, noon(problem), sun * one.height, sun * height)
    return found


def _shades(
    shape: shapely.Polygon, heading: float, behind: float, ahead: float
) -> list[shapely.Polygon]:
    """The ground behind a polygon and ahead of it, towards the noon sun, to those distances."""
    toward = np.array([math.cos(heading), math.sin(heading)])
    found = []
    for part in convex_parts(_corners(shape)):
        corners = np.array(part)
        for step in (-toward * (behind + HAIR), toward * (ahead + HAIR)):
            both = np.concatenate([corners, corners + step])
            found.append(shapely.convex_hull(shapely.MultiPoint(both)))
    return found


def blocks_of(problem: SiteProblem) -> list[shapely.Polygon]:
    """The blocks of a site as polygons, the largest first."""
    ground, found = problem.ground, []
    for first, last in problem.ground.block_spans:
        rows, rings, start = ground.block_edges[first:last], [], 0
        for k in range(len(rows)):
            if np.allclose(rows[k, 2:], rows[start, :2], atol=1e-9):
                rings.append(rows[start : k + 1, :2])
                start = k + 1
        found.append(shapely.Polygon(rings[0], rings[1:]))
    return sorted(found, key=lambda block: -float(block.area))
