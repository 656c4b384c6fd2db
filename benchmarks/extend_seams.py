"""What gives a grown half away, counted beside its source: repeats, slits, streets that never turn.

A *repeat* is a building whose footprint lies on another one's within :data:`SAME` metres once
turned or mirrored; a *slit* is a gap to the nearest building too narrow to walk through and too
wide for a wall. Of streets: the turning of their middle lines, the entropy of their bearings (in
bins of 10°, 1: all as common), and how many begin or end at another.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

import scenewright as sw
from scenewright.core.piece_outlines import polygons_of
from scenewright.domains.extend.areas import OLD
from scenewright.domains.extend.plan import plan_extend
from scenewright.ground.buildings.built import BuiltRoad

Shapes = NDArray[np.object_]
SAME, BESIDE = 0.3, 50.0
"""Metres by which two footprints may differ and be one, and within which a repeat is seen."""
TOUCHING, SLIT, FAR = 0.05, 1.5, 12.0
"""Metres of a gap that is a party wall, of the widest slit, and of the widest gap that counts."""
BINS, JOINED = 18, 1.0
"""Bins of bearings, and metres within which streets meet."""


class SeamFigures(NamedTuple):
    """Sums of one half: buildings, those that are repeats within the half, those that repeat one
    within :data:`BESIDE` of all that stands; gaps to the nearest building, slits among them;
    metres of street, radians by which they turn, lengths by bearing (18,), streets and those that
    begin or end at another."""

    buildings: float
    repeats: float
    beside: float
    gaps: float
    slits: float
    metres: float
    turning: float
    bearings: NDArray[np.float64]
    streets: float
    branches: float


def seam_figures(solution: sw.Solution) -> tuple[SeamFigures, SeamFigures]:
    """The figures of the source and of what was grown."""
    built = [p for p in solution.pieces if p.category == "building"]
    old = np.array([p.space.startswith(OLD) for p in built], bool)
    shapes = polygons_of(built)
    plan = plan_extend(solution.brief).detail
    standing = [scene for scene, there in zip(plan.sources, plan.stands, strict=True) if there]
    theirs = [_line(road) for scene in standing for road in scene.roads if road.kind == "road"]
    ours = [_line(road) for area in plan.areas for road in area.roads if road.kind == "road"]
    every = [*theirs, *ours]
    return _half(shapes, old, theirs, every), _half(shapes, ~old, ours, every)


def _line(road: BuiltRoad) -> shapely.LineString:
    return shapely.LineString(road.line)


def _half(
    shapes: Shapes,
    mine: NDArray[np.bool_],
    lines: Sequence[shapely.LineString],
    every: Sequence[shapely.LineString],
) -> SeamFigures:
    rows = np.flatnonzero(mine)
    away = np.asarray(shapely.distance(shapes[:, None], shapes[None]))
    np.fill_diagonal(away, np.inf)
    same = find_repeats(shapes)
    gaps = away[rows].min(1) if len(shapes) > 1 else np.zeros(0)
    gaps = gaps[gaps <= FAR]
    turning, bearings = 0.0, np.zeros(BINS)
    for line in lines:
        steps = np.diff(shapely.get_coordinates(line.simplify(0.5)), axis=0)
        bearing = np.arctan2(steps[:, 1], steps[:, 0])
        turning += float(np.abs((np.diff(bearing) + np.pi) % (2 * np.pi) - np.pi).sum())
        bins = (np.degrees(bearing) % 180 // 10).astype(int) % BINS
        bearings += np.bincount(bins, np.hypot(*steps.T), BINS)
    ends = [(line, end) for line in lines for end in line.boundary.geoms]
    met = [any(o is not own and o.distance(end) < JOINED for o in every) for own, end in ends]
    return SeamFigures(
        float(len(rows)),
        float((same & mine[None])[rows].any(1).sum()),
        float((same & (away <= BESIDE))[rows].any(1).sum()),
        float(len(gaps)),
        float(((gaps > TOUCHING) & (gaps < SLIT)).sum()),
        float(sum(line.length for line in lines)),
        turning,
        bearings,
        float(len(lines)),
        float(sum(met)),
    )


def find_repeats(shapes: Shapes) -> NDArray[np.bool_]:
    """Which pairs (n, n) of footprints are one, turned or mirrored."""
    frames = [_framed(shape) for shape in shapes]
    found = np.zeros((len(shapes), len(shapes)), bool)
    sizes = np.array(
        [[*sides, shape.area] for (_, sides), shape in zip(frames, shapes, strict=True)]
    )
    for a in range(len(shapes)):
        close = np.abs(sizes[a + 1 :, :2] - sizes[a, :2]).max(1) < 2 * SAME
        for b in (a + 1 + np.flatnonzero(close)).tolist():
            found[a, b] = found[b, a] = _are_same(frames[a][0], frames[b][0])
    return found


def _framed(shape: shapely.Polygon) -> tuple[NDArray[np.float64], tuple[float, float]]:
    """A footprint about the middle of its least rectangle, the long side along x."""
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shape))
    sides = np.diff(frame[:3], axis=0)
    length = np.hypot(*sides.T)
    way = sides[int(length[1] > length[0])] / max(length.max(), 1e-9)
    step = shapely.get_coordinates(shapely.segmentize(shape, 2.0).exterior)[:-1] - frame[:4].mean(0)
    local = np.column_stack([step @ way, step @ np.array([-way[1], way[0]])])
    return local, (float(length.max()), float(length.min()))


def _are_same(one: NDArray[np.float64], other: NDArray[np.float64]) -> bool:
    ring, turns = shapely.LinearRing(one), [(1, 1), (1, -1), (-1, 1), (-1, -1)]
    if np.ptp(other, axis=0).min() > np.ptp(other, axis=0).max() - 2 * SAME:
        turned = [other[:, ::-1] * turn for turn in turns]
    else:
        turned = []
    for spots in (*(other * turn for turn in turns), *turned):
        there = shapely.LinearRing(spots)
        if (
            shapely.distance(shapely.points(spots), ring).max() <= SAME
            and shapely.distance(shapely.points(one), there).max() <= SAME
        ):
            return True
    return False


def add_figures(rows: Sequence[SeamFigures]) -> dict[str, float]:
    """The shares of some halves together; entropy is the mean over halves."""
    total = SeamFigures(*(sum(column) for column in zip(*rows, strict=True)))
    entropies = [_entropy(row.bearings) for row in rows if row.metres]
    return {
        "footprints that repeat": total.repeats / max(total.buildings, 1.0),
        "the same within 50 m, old and new": total.beside / max(total.buildings, 1.0),
        "slits among gaps": total.slits / max(total.gaps, 1.0),
        "degrees a street turns in 100 m": 100 * np.degrees(total.turning) / max(total.metres, 1.0),
        "entropy of bearings": float(np.mean(entropies)) if entropies else 0.0,
        "streets in 100 m of street": 100 * total.streets / max(total.metres, 1.0),
        "ends of streets at another": total.branches / max(2 * total.streets, 1.0),
    }


def _entropy(bearings: NDArray[np.float64]) -> float:
    part = bearings[bearings > 0] / bearings.sum()
    return float(-(part * np.log(part)).sum() / np.log(BINS))
