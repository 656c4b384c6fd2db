"""Terraces: houses wall to wall in one straight row, whose ground is shared out by the walls
between them, drawn on to the street and to the back."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

Shapes = NDArray[np.object_]
Indices = NDArray[np.int64]
Floats = NDArray[np.float64]

TOUCHING, SHARED = 0.3, 2.0
"""Metres apart at most of houses wall to wall, and of wall that they share at least."""
PARALLEL = np.radians(8.0)
"""How far walls of one row may turn from its mean."""


class Terrace(NamedTuple):
    """A row: the numbers (k,) of its houses in order, the unit vector (2,) along it, and how far
    along it each wall (k − 1,) between two of them lies."""

    houses: Indices
    along: Floats
    walls: Floats


def find_terraces(shapes: Shapes) -> list[Terrace]:
    """The straight rows among some footprints (n,).

    >>> three = np.array([shapely.box(x, 0, x + 5, 9 + x / 5) for x in (0, 5, 10)], object)
    >>> [row] = find_terraces(three)
    >>> row.houses.tolist(), abs(row.walls).round(2).tolist()
    ([0, 1, 2], [5.0, 10.0])
    """
    a, b = shapely.STRtree(shapes).query(shapes, predicate="dwithin", distance=TOUCHING)
    pairs = np.stack([a, b], 1)[a < b]
    if not len(pairs):
        return []
    walls = [_find_wall(shapes[one], shapes[other]) for one, other in pairs]
    label = _join(pairs, len(shapes))[pairs[:, 0]]
    return [row for k in np.unique(label) for row in _read_row(pairs, walls, label == k, shapes)]


def split_terrace(part: shapely.Geometry, row: Terrace) -> Shapes:
    """The ground of a row as the grounds (k,) of its houses.

    >>> three = np.array([shapely.box(x, 0, x + 5, 9) for x in (0, 5, 10)], object)
    >>> [row] = find_terraces(three)
    >>> [round(float(one.area)) for one in split_terrace(shapely.box(0, 0, 15, 20), row)]
    [100, 100, 100]
    """
    across = np.array([-row.along[1], row.along[0]])
    bounds = np.reshape(shapely.bounds(part), (2, 2))
    half = np.hypot(*(bounds[1] - bounds[0])) * across
    middle = row.walls[:, None] * row.along + (bounds.mean(0) @ across) * across
    cuts = shapely.linestrings(np.stack([middle - half, middle + half], 1))
    noded = shapely.union_all([shapely.boundary(part), *cuts])
    cells = shapely.get_parts(shapely.polygonize(shapely.get_parts(noded)))
    at = shapely.get_coordinates(shapely.point_on_surface(cells))
    inside = shapely.contains_xy(part, at)
    owner = np.searchsorted(row.walls, at @ row.along)
    shares = [cells[inside & (owner == k)] for k in range(len(row.houses))]
    return np.array([shapely.union_all(share) for share in shares], object)


def _join(pairs: Indices, count: int) -> Indices:
    """The least number (count,) among all that pairs join each to."""
    label, before = np.arange(count), np.empty(0, np.int64)
    while not np.array_equal(label, before):
        before = label.copy()
        least = label[pairs].min(1)
        np.minimum.at(label, pairs.ravel(), np.repeat(least, 2))
    return label


def _find_wall(one: shapely.Polygon, other: shapely.Polygon) -> Floats | None:
    """The ends (2, 2) of the wall two houses share; none if that is short."""
    shared = shapely.intersection(*(shapely.buffer(s, TOUCHING / 2 + 0.01) for s in (one, other)))
    box = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shared))
    if len(box) < 5:
        return None
    sides = np.hypot(*np.diff(box, axis=0)[:2].T)
    k = int(np.argmax(sides))
    middle = 0.25 * box[:4].sum(0)
    half = 0.5 * (box[k + 1] - box[k])
    return np.stack([middle - half, middle + half]) if sides[k] >= SHARED + TOUCHING else None


def _read_row(
    pairs: Indices, walls: list[Floats | None], mine: NDArray[np.bool_], shapes: Shapes
) -> Iterator[Terrace]:
    """The houses some pairs join, if they are one straight row."""
    found = [walls[k] for k in np.flatnonzero(mine)]
    kept = np.array([wall for wall in found if wall is not None])
    if len(kept) < len(found) or np.bincount(pairs[mine].ravel()).max() > 2:
        return
    turn = np.arctan2(*(kept[:, 1] - kept[:, 0]).T[::-1])
    mean = 0.5 * np.angle(np.exp(2j * turn).mean())
    if np.abs(np.angle(np.exp(2j * (turn - mean)))).max() > 2 * PARALLEL:
        return
    along = np.array([np.sin(mean), -np.cos(mean)])
    houses = np.unique(pairs[mine])
    middle = shapely.get_coordinates(shapely.centroid(shapes[houses])) @ along
    order, at = np.argsort(middle), np.sort(kept.mean(1) @ along)
    between = np.arange(len(houses)), np.searchsorted(at, middle[order])
    if len(at) == len(houses) - 1 and np.array_equal(*between):
        yield Terrace(houses[order], along, at)
