"""Podiums and towers: where walls may meet, a low wide building and a high one on less ground stand
wall to wall. Designers build them so or far apart, hardly ever between.

One of the two moves so that a wall of it runs along one of the other, in corners of its footprint
too, where that costs no sun, no way before a front, no door and no distance, leaves no more ground
void and keeps what stands along the border there. What is joined stays so.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.footprint import place_outline
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
from scenewright.ground.ways.walks import find_doors

Planes = NDArray[np.complex128]
Shapes = NDArray[np.object_]

WIDER, HIGHER, LOWEST = 1.5, 2.0, 15.0
"""How many times a tower's ground a podium takes and how many times higher the tower is, at least;
metres of height of a podium, at most."""
TOWERS, PODIUMS, LOOKED = 3, 24, 40
"""Nearest towers tried for each podium, the largest podiums looked at, and places looked at."""
TOUCHING, MEETING = 1e-3, 1.0
"""Metres more than the least distance at which they are set, and within which walls meet; where
buildings keep a greater distance, none are joined."""
WALL = 6.0
"""Metres of the shortest wall that another may stand along."""
BORDER, ALONG = 15.0, math.radians(10.0)
"""Metres from the border within which walls stand along it, and how far they may be turned."""
WAY, DOOR, ASIDE = 15.0, (0.5, 3.5), 0.9
"""Metres from a door within which a way is near; where ahead of it its walk begins, and what that
keeps from walls."""


class Before(NamedTuple):
    """A layout before a building of it moves: its ``boxes`` (n, 5), which stand, their ``shapes``
    (n,) and the ``walks`` (n,) that begin at their doors, mean hours of sun on fronts, and the
    ``points`` of its ground, of which a share is void."""

    boxes: Floats
    present: Flags
    shapes: Shapes
    walks: Shapes
    hours: float
    points: Floats
    void: float


def join_podiums(problem: SiteProblem, found: SiteLayout) -> tuple[SiteLayout, Flags]:
    """The layout with towers and podiums side by side, and which buildings (n,) are so joined."""
    joined = np.zeros(len(found.present), bool)
    pairs = list_pairs(problem, found) if problem.spacing <= MEETING - TOUCHING else []
    if not pairs:
        return found, joined
    boxes = np.where(found.present[:, None], found.boxes, 0.0)
    p, s = prepare_site(problem), make_site_state(problem)
    points = spread_points(np.asarray(problem.ground.block_edges))
    before = _read_layout(problem, boxes, found.present, points)
    for podium, tower in pairs:
        if joined[podium] or joined[tower]:
            continue
        placed: Floats | None = before.boxes
        if shapely.distance(before.shapes[podium], before.shapes[tower]) > MEETING:
            placed = _join(problem, p, s, before, (podium, tower))
            if placed is not None:
                before = _read_layout(problem, placed, found.present, points)
        joined[[podium, tower]] = placed is not None
    return found._replace(boxes=before.boxes, score={}), joined


def list_pairs(problem: SiteProblem, found: SiteLayout) -> list[tuple[int, int]]:
    """Podiums with towers that they may carry, the largest podium first, the nearest towers."""
    sizes, given = problem.buildings.sizes, problem.buildings.forms
    area, high = sizes[:, :2].prod(1), sizes[:, 2]
    free = found.present.copy()
    free[found.present] &= ~on_square(problem, found.boxes[found.present])
    free &= np.array([not form for form in given] or [True] * len(free), bool)
    if problem.court_gap > 0.0:
        free &= np.array([form != "peripheral" for form in found.forms], bool)
    pairs = []
    low = np.flatnonzero(free & (high <= LOWEST))
    for podium in low[np.argsort(-area[low], kind="stable")][:PODIUMS].tolist():
        fit = free & (high >= HIGHER * high[podium]) & (WIDER * area <= area[podium])
        towers = np.flatnonzero(fit)
        far = np.hypot(*(found.boxes[towers, :2] - found.boxes[podium, :2]).T)
        near = towers[np.argsort(far, kind="stable")][:TOWERS].tolist()
        pairs += [(podium, tower) for tower in near]
    return pairs


def _read_layout(problem: SiteProblem, boxes: Floats, present: Flags, points: Floats) -> Before:
    hours = sun_of(problem, boxes[present], problem.buildings.sizes[present, 2])
    built = _build(problem.buildings.outlines(), boxes)
    for row in built:
        row[~present] = shapely.Polygon()
    return Before(boxes, present, *built, hours, points, find_void(points, boxes[present]))


def _build(outlines: list[Floats], boxes: Floats) -> tuple[Shapes, Shapes]:
    """The shapes (k,) of buildings at some boxes, and where the walks from their doors begin."""
    rings = [place_outline(outline, *box[:3]) for outline, box in zip(outlines, boxes, strict=True)]
    doors = find_doors(rings, boxes[:, 2])
    walks = np.stack([doors.places + ahead * doors.ways for ahead in DOOR], 1)
    return np.array([shapely.Polygon(ring) for ring in rings], object), shapely.linestrings(walks)


def _join(
    problem: SiteProblem, p: SitePrepared, s: SiteState, before: Before, pair: tuple[int, int]
) -> Floats | None:
    """The boxes (n, 5) with one of a pair beside the other, None if nowhere at no loss."""
    boxes, outlines = before.boxes, problem.buildings.outlines()
    lay(p, s, boxes)
    for base, other in (pair, pair[::-1]):
        walls = place_outline(outlines[base], *boxes[base, :3])
        places = list_places(walls, outlines[other], boxes[other], problem.spacing + TOUCHING)
        fit = np.zeros(len(places), bool)
        mark_standing(p, s, other, places, LOOSE, fit)
        for place in places[fit][:LOOKED]:
            moved = boxes.copy()
            moved[other] = place
            if _is_no_worse(problem, outlines, before, moved, other):
                return moved
    return None


def list_places(base: Floats, outline: Floats, other: Floats, gap: float) -> Floats:
    """Boxes (k, 5) of a building ``other`` of some ``outline`` (m, 2) with one of its walls ``gap``
    metres off and along one of those of ``base`` (n, 2), their ends or middles in line; the nearest
    to where it stands first.

    >>> base = 0.5 * np.array([(-30, -20), (30, -20), (30, 20), (-30, 20)])
    >>> tower, there = base / (3, 2), np.array([25.0, 30.0, 0.0, 10.0, 10.0])
    >>> list_places(base, tower, there, 2.0)[0, :2].round(6).tolist()
    [10.0, 17.0]
    """
    (a, b), (c, d) = _list_walls(base), _list_walls(outline)
    a, b = a[:, None], b[:, None]
    along, own = (b - a) / np.abs(b - a), (d - c) / np.abs(d - c)
    turn, off = -along / own, -1j * gap * along
    starts, ends = a - turn * d + off, b - turn * c + off
    middles = np.concatenate([starts, ends, 0.5 * (starts + ends)]).ravel()
    headings = np.tile(np.angle(turn), (3, 1)).ravel() + 0.5 * math.pi
    sizes = np.tile(other[3:], (len(middles), 1))
    places = np.column_stack([middles.real, middles.imag, headings, sizes])
    nearest: Floats = places[np.argsort(np.abs(middles - complex(*other[:2])), kind="stable")]
    return nearest


def _list_walls(ring: Floats) -> tuple[Planes, Planes]:
    """Where the walls of a ring (k, 2) that are long enough begin and end, as complex numbers."""
    first = ring[:, 0] + 1j * ring[:, 1]
    last = np.roll(first, -1)
    long = np.abs(last - first) >= WALL
    return first[long], last[long]


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
    problem: SiteProblem, outlines: list[Floats], before: Before, moved: Floats, i: int
) -> bool:
    """Whether building ``i`` has as good a front as before, and all have as much sun and their
    doors free."""
    boxes, present = before.boxes, before.present
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
    if _stands_along(problem, boxes[i]) and not _stands_along(problem, moved[i]):
        return False
    if find_void(before.points, rows) > before.void:
        return False
    free = _doors_are_free(outlines, before, moved, i)
    return free and sun_of(problem, rows, heights) >= before.hours


def _doors_are_free(outlines: list[Floats], before: Before, moved: Floats, i: int) -> bool:
    """Whether building ``i`` leaves room before all doors, and has it before its own."""
    (shape,), (walk,) = _build([outlines[i]], moved[i : i + 1])
    others = np.arange(len(before.boxes)) != i
    cut_off = shapely.dwithin(before.walks[others], shape, ASIDE)
    return not (cut_off | shapely.dwithin(before.shapes[others], walk, ASIDE)).any()


def _stands_along(problem: SiteProblem, box: Floats) -> bool:
    """Whether the middle of a box lies near an edge of the ground and a side of it along that."""
    edges = np.asarray(problem.ground.edges)
    far = shapely.distance(shapely.linestrings(edges.reshape(-1, 2, 2)), shapely.Point(box[:2]))
    way = edges[int(far.argmin()), 2:] - edges[int(far.argmin()), :2]
    off = (math.atan2(way[1], way[0]) - box[2] + math.pi / 4) % (math.pi / 2) - math.pi / 4
    return float(far.min()) <= BORDER + 0.5 * float(box[4]) and abs(off) <= ALONG


def _to_way(problem: SiteProblem, box: Floats) -> float:
    """Metres from the door of a box to where people walk; 0 where they walk nowhere."""
    door = box[:2] + 0.5 * box[4] * np.array([math.cos(box[2]), math.sin(box[2])])
    eyes = problem.ground.eyes
    return float(np.hypot(*(eyes - door).T).min()) if len(eyes) else 0.0
