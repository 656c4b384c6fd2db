"""How buildings of a site are composed: directions, those along the border, ground far from any.

Measured on footprints alone, of the designer and of ours alike; nothing is shared with the solver.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.scene import Piece

Floats = NDArray[np.float64]
BIN = math.radians(10.0)
ALONG, ASLANT = 25.0, math.radians(15.0)
"""Metres from the border up to which a building stands along it, and how far its sides may turn
from it."""
FAR = 25.0
"""Metres from a building beyond which ground is void."""
ALIKE, IN_LINE, PARALLEL, NEXT = 1.0, 1.0, math.radians(3.0), 30.0
"""Metres by which sides of equal buildings differ at most (heights thrice as much) and by which
they stand off one line, radians by which they are turned, and the widest gap in metres of a row."""
PODIUM, WIDER, HIGHER, MEETING = 15.0, 1.5, 2.0, 1.0
"""Metres of height of a podium, at most; how many times a tower's ground it takes and how many
times higher the tower is, at least; metres within which walls meet."""
SMOOTH = 1.0
"""Metres by which a border is drawn more simply before its direction is read."""


def measure_composition(
    outline: shapely.Polygon,
    shapes: NDArray[np.object_],
    headings: Floats,
    parks: Sequence[shapely.Polygon] = (),
) -> dict[str, float]:
    """The figures of some footprints (n,) with ``headings`` (n,) on the ground of an outline;
    ``parks`` are void that is made something of."""
    near = share_along_border(outline, shapes, headings)
    far = shapely.union_all(shapely.buffer(shapes, FAR))
    ground = shapely.make_valid(outline)
    void = shapely.difference(ground, far)
    return {
        "directions": entropy(headings, math.pi),
        "grids": entropy(headings, math.pi / 2),
        "along_border": near,
        "void": float(void.area / ground.area),
        "bare": float(shapely.difference(void, shapely.union_all(parks)).area / ground.area),
    }


def entropy(headings: Floats, turn: float) -> float:
    """Entropy in nats of headings in bins of 10 degrees, those a ``turn`` apart being one.

    >>> round(entropy(np.radians([0.0, 90.0, 180.0, 270.0]), math.pi), 3)
    0.693
    """
    if not len(headings):
        return 0.0
    bins = np.round((headings % turn) / BIN).astype(int) % round(turn / BIN)
    shares = np.bincount(bins) / len(bins)
    shares = shares[shares > 0.0]
    return float(-(shares * np.log(shares)).sum())


def share_along_border(
    outline: shapely.Polygon, shapes: NDArray[np.object_], headings: Floats
) -> float:
    """The share of buildings near the border with a side along the edge of it that is nearest.

    >>> square = shapely.box(0.0, 0.0, 200.0, 200.0)
    >>> two = np.array([shapely.box(10.0, 10.0, 30.0, 20.0), shapely.box(90.0, 90.0, 99.0, 99.0)])
    >>> share_along_border(square, two, np.zeros(2))
    0.5
    """
    if not len(shapes):
        return 0.0
    ring = shapely.get_coordinates(shapely.simplify(outline, SMOOTH).exterior)
    steps = np.diff(ring, axis=0)
    edges = shapely.linestrings(np.stack([ring[:-1], ring[1:]], 1))
    apart = shapely.distance(shapes[:, None], edges[None])
    nearest = apart.argmin(1)
    along = np.arctan2(steps[nearest, 1], steps[nearest, 0])
    off = np.abs((headings - along + math.pi / 4) % (math.pi / 2) - math.pi / 4)
    return float(((apart.min(1) <= ALONG) & (off <= ASLANT)).mean())


def boxes_of(houses: Sequence[Piece]) -> tuple[Floats, Floats]:
    """Boxes (n, 5) of buildings and their heights (n,)."""
    rows = [[*one.pose[:2], one.pose.heading, *one.size[:2]] for one in houses]
    return np.array(rows).reshape(-1, 5), np.array([one.size.height for one in houses])


def share_of_podiums(shapes: NDArray[np.object_], heights: Floats) -> float:
    """The share of podiums at most :data:`MEETING` metres from a tower; NaN without any."""
    gaps = list_podium_gaps(shapes, heights)
    return float(np.mean([gap <= MEETING for gap in gaps])) if gaps else math.nan


def list_gap_variations(boxes: Floats, heights: Floats) -> list[float]:
    """The coefficient of variation of the gaps in each run of three or more equal ``boxes`` (n, 5)
    of ``heights`` (n,) that stand beside each other on one line, nothing between them.

    >>> row = np.array([[x, 0.0, math.pi / 2, 10.0, 8.0] for x in (0.0, 15.0, 40.0)])
    >>> [round(found, 3) for found in list_gap_variations(row, np.full(3, 9.0))]
    [0.5]
    """
    following = {k: find_neighbour(k, boxes, heights) for k in range(len(boxes))}
    inner = {right for right, _ in following.values()}
    found = []
    for k in sorted(set(following) - inner):
        gaps: list[float] = []
        while following[k][0] >= 0:
            k, gap = following[k]
            gaps.append(gap)
        if len(gaps) > 1:
            found.append(float(np.std(gaps) / np.mean(gaps)))
    return found


def find_neighbour(k: int, boxes: Floats, heights: Floats) -> tuple[int, float]:
    """The next building in line to the right of one whose heading is taken modulo half a turn, and
    the gap in metres; -1 where there is none equal to it or another stands between."""
    x, y, heading, width, depth = boxes[k]
    heading %= math.pi
    step = boxes[:, :2] - (x, y)
    along = step @ (math.sin(heading), -math.cos(heading))
    aside = np.abs(step @ (math.cos(heading), math.sin(heading)))
    turned = np.abs((boxes[:, 2] - heading + math.pi / 2) % math.pi - math.pi / 2)
    gaps = along - 0.5 * (width + boxes[:, 3])
    equal = (np.abs(boxes[:, 3:] - (width, depth)) <= ALIKE).all(1) & (turned <= PARALLEL)
    equal &= np.abs(heights - heights[k]) <= 3.0 * ALIKE
    equal &= (aside <= IN_LINE) & (gaps > 0.0) & (gaps <= NEXT)
    if not equal.any():
        return -1, 0.0
    right = int(np.where(equal, gaps, np.inf).argmin())
    between = (along > 0.0) & (along < along[right]) & (aside < 0.5 * boxes[:, 3:].min(1))
    return (-1, 0.0) if between.any() else (right, float(gaps[right]))


def list_podium_gaps(shapes: NDArray[np.object_], heights: Floats) -> list[float]:
    """Metres from each podium, a low wide building among footprints (n,) of ``heights`` (n,), to
    the nearest tower that is much higher and more slender.

    >>> two = np.array([shapely.box(0.0, 0.0, 40.0, 30.0), shapely.box(45.0, 0.0, 60.0, 15.0)])
    >>> list_podium_gaps(two, np.array([9.0, 45.0]))
    [5.0]
    """
    area, found = shapely.area(shapes), []
    for k in np.flatnonzero(heights <= PODIUM).tolist():
        towers = (heights >= HIGHER * heights[k]) & (WIDER * area <= area[k])
        if towers.any():
            found.append(float(shapely.distance(shapes[towers], shapes[k]).min()))
    return found
