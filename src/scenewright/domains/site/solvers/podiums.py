"""Podiums and towers: where walls may meet, a low wide building and a high slender one stand wall
to wall. Designers build them so or far apart, hardly ever between.

One of the two moves to a side of the other, fronts or backs in line, where that costs no sun, no
way before a front and no distance, and leaves no more ground void. What is joined stays so.
"""

from __future__ import annotations

import math

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.domains.site.solvers.answer import LOOSE, sun_of
from scenewright.domains.site.solvers.blocks.distances import mark_shaded, noon
from scenewright.domains.site.solvers.blocks.front import blind, on_square
from scenewright.domains.site.solvers.blocks.schemes import find_void, spread_points
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.terms.measure import (
    SitePrepared,
    SiteState,
    lay,
    make_site_state,
    prepare_site,
    put,
    stands,
)
from scenewright.geometry.boxes import make_frame, read_frame
from scenewright.geometry.buckets import remove
from scenewright.geometry.compiled import compiled

WIDER, HIGHER, LOWEST = 1.5, 2.0, 15.0
"""How many times a tower's ground a podium takes and how many times higher the tower is, at least;
metres of height of a podium, at most."""
TOWERS, PODIUMS = 3, 24
"""Nearest towers tried for each podium, and the largest podiums looked at."""
TOUCHING, MEETING = 1e-3, 1.0
"""Metres more than the least distance at which they are set, and within which walls meet; where
buildings keep a greater distance, none are joined."""
ALIGNED = math.radians(5.0)
"""Radians by which both may be turned against each other: none is turned by more."""
WAY = 15.0
"""Metres from a door within which a way is near."""


def join_podiums(problem: SiteProblem, found: SiteLayout) -> tuple[SiteLayout, Flags]:
    """The layout with towers and podiums side by side, and which buildings (n,) are so joined."""
    joined = np.zeros(len(found.present), bool)
    pairs = list_pairs(problem, found) if problem.spacing <= MEETING - TOUCHING else []
    if not pairs:
        return found, joined
    boxes = np.where(found.present[:, None], found.boxes, 0.0)
    p, s = prepare_site(problem), make_site_state(problem)
    for podium, tower in pairs:
        if joined[podium] or joined[tower]:
            continue
        placed: Floats | None = boxes
        if not _side_by_side(boxes[[podium, tower]]):
            placed = _join(problem, p, s, boxes, found.present, (podium, tower))
        if placed is not None:
            boxes, joined[[podium, tower]] = placed, True
    return found._replace(boxes=boxes, score={}), joined


def list_pairs(problem: SiteProblem, found: SiteLayout) -> list[tuple[int, int]]:
    """Podiums with towers that they may carry, the largest podium first, the nearest towers."""
    sizes, given = problem.buildings.sizes, problem.buildings.forms
    area, high = sizes[:, :2].prod(1), sizes[:, 2]
    free = found.present.copy()
    free[found.present] &= ~on_square(problem, found.boxes[found.present])
    free &= np.array([not form for form in given] or [True] * len(free), bool)
    if problem.court_gap > 0.0:
        free &= np.array([form != "peripheral" for form in found.forms], bool)
    slender = free & (high >= sizes[:, :2].max(1))
    pairs = []
    low = np.flatnonzero(free & (high <= LOWEST))
    for podium in low[np.argsort(-area[low], kind="stable")][:PODIUMS].tolist():
        fit = slender & (high >= HIGHER * high[podium]) & (WIDER * area <= area[podium])
        towers = np.flatnonzero(fit)
        far = np.hypot(*(found.boxes[towers, :2] - found.boxes[podium, :2]).T)
        near = towers[np.argsort(far, kind="stable")][:TOWERS].tolist()
        pairs += [(podium, tower) for tower in near]
    return pairs


def _side_by_side(two: Floats) -> bool:
    a, b = shapely.polygons(corners(two))
    return bool(shapely.distance(a, b) <= MEETING)


def _join(
    problem: SiteProblem,
    p: SitePrepared,
    s: SiteState,
    boxes: Floats,
    present: Flags,
    pair: tuple[int, int],
) -> Floats | None:
    """The boxes (n, 5) with one of a pair beside the other, None if nowhere at no loss."""
    lay(p, s, boxes)
    hours = sun_of(problem, boxes[present], problem.buildings.sizes[present, 2])
    off = (boxes[pair[0], 2] - boxes[pair[1], 2] + 0.5 * math.pi) % math.pi - 0.5 * math.pi
    for base, other in (pair, pair[::-1]) if abs(off) <= ALIGNED else ():
        places = list_places(boxes[base], boxes[other], problem.spacing + TOUCHING)
        fit = np.zeros(len(places), bool)
        mark_standing(p, s, other, places, LOOSE, fit)
        for place in places[fit]:
            moved = boxes.copy()
            moved[other] = place
            if _is_no_worse(problem, boxes, moved, present, other, hours):
                return moved
    return None


def list_places(base: Floats, other: Floats, gap: float) -> Floats:
    """Boxes (6, 5) of a building ``other`` beside ``base``, ``gap`` metres from its right or left
    side, fronts, backs or middles in line; the nearest to where it stands first.

    >>> base, tower = np.array([0, 0, 0, 30, 20.0]), np.array([0, 90, 0, 10, 10.0])
    >>> list_places(base, tower, 2.0)[0].tolist()
    [0.0, 22.0, 0.0, 10.0, 10.0]
    """
    c, s = math.cos(base[2]), math.sin(base[2])
    aside = 0.5 * (base[3] + other[3]) + gap
    rows = [
        [base[0] + u * s + v * c, base[1] - u * c + v * s, base[2], other[3], other[4]]
        for u in (aside, -aside)
        for v in 0.5 * (base[4] - other[4]) * np.array([1.0, -1.0, 0.0])
    ]
    places = np.array(rows)
    far = np.hypot(*(places[:, :2] - other[:2]).T)
    nearest: Floats = places[np.argsort(far, kind="stable")]
    return nearest


@compiled
def mark_standing(
    p: SitePrepared, s: SiteState, i: int, places: Floats, loose: float, fit: Flags
) -> None:
    """Mark the places (k, 5) at which building ``i`` keeps all distances."""
    before = read_frame(s.frames, i)
    remove(s.buckets, i)
    for k in range(places.shape[0]):
        frame = make_frame(places[k, 0], places[k, 1], places[k, 2], places[k, 3], places[k, 4])
        fit[k] = stands(p, s, i, frame, loose)
    put(p, s, i, before)


def _is_no_worse(
    problem: SiteProblem, boxes: Floats, moved: Floats, present: Flags, i: int, hours: float
) -> bool:
    """Whether building ``i`` has as good a front as before, and all as much sun."""
    rows, heights = moved[present], problem.buildings.sizes[present, 2]
    if blind(problem, moved[i : i + 1])[0] and not blind(problem, boxes[i : i + 1])[0]:
        return False
    if _to_way(problem, moved[i]) > max(_to_way(problem, boxes[i]), WAY):
        return False
    if problem.sun_spacing > 0.0:
        dark = np.zeros(len(rows), bool)
        work = np.empty((len(rows), 5))
        mark_shaded(rows, heights, noon(problem), problem.sun_spacing, work, dark)
        if dark.any():
            return False
    points = spread_points(np.asarray(problem.ground.block_edges))
    if find_void(points, rows) > find_void(points, boxes[present]):
        return False
    return sun_of(problem, rows, heights) >= hours


def _to_way(problem: SiteProblem, box: Floats) -> float:
    """Metres from the door of a box to where people walk; 0 where they walk nowhere."""
    door = box[:2] + 0.5 * box[4] * np.array([math.cos(box[2]), math.sin(box[2])])
    eyes = problem.ground.eyes
    return float(np.hypot(*(eyes - door).T).min()) if len(eyes) else 0.0
