"""Rectangles of ground beside a street: where a square or a car park may lie.

One side lies on the edge of a street, so that whoever is on the street is at once on the lot.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.space import Points

Floats = NDArray[np.float64]

STRAIGHT = 0.3
"""Metres by which a street may bend and still be straight to a lot."""


def list_frontages(ways: Iterable[tuple[Points, float]], outline: Points) -> Floats:
    """Straight stretches (k, 2, 2) of the edges of streets, the ground beside them on the left.

    ``ways`` are middle lines (n, 2) with their widths in metres; without any, the sides of the
    ``outline`` (m, 2), counter-clockwise.

    >>> list_frontages([(np.array([(0.0, 0.0), (9.0, 0.0)]), 4.0)], np.zeros((0, 2))).tolist()
    [[[0.0, 2.0], [9.0, 2.0]], [[9.0, -2.0], [0.0, -2.0]]]
    """
    found = []
    for line, width in ways:
        straight = shapely.get_coordinates(shapely.simplify(shapely.LineString(line), STRAIGHT))
        along = np.diff(straight, axis=0)
        along /= np.maximum(np.hypot(*along.T), 1e-9)[:, None]
        left = 0.5 * width * np.column_stack([-along[:, 1], along[:, 0]])
        found.append(np.stack([straight[:-1] + left, straight[1:] + left], 1))
        found.append(np.stack([straight[1:] - left, straight[:-1] - left], 1))
    if not found:
        found.append(np.stack([outline, np.roll(outline, -1, axis=0)], 1))
    return np.concatenate(found)


def list_lots(frontages: Floats, width: float, depth: float, step: float) -> Floats:
    """Rectangles (n, 4, 2), counter-clockwise, ``width`` metres along a frontage (k, 2, 2) and
    ``depth`` from it, every ``step`` metres; the first edge lies on it.

    >>> list_lots(np.array([[[0.0, 0.0], [9.0, 0.0]]]), 6.0, 5.0, 2.0)[1].tolist()
    [[2.0, 0.0], [8.0, 0.0], [8.0, 5.0], [2.0, 5.0]]
    """
    found = [np.zeros((0, 4, 2))]
    for start, end in frontages:
        long = float(np.hypot(*(end - start)))
        if long < width:
            continue
        along = (end - start) / long
        into, at = np.array([-along[1], along[0]]), np.arange(0.0, long - width + 1e-9, step)
        corner = start + at[:, None] * along
        sides = [0.0 * along, width * along, width * along + depth * into, depth * into]
        found.append(corner[:, None] + np.array(sides))
    return np.concatenate(found)


def keep_open_lots(lots: Floats, ground: Sequence[shapely.Geometry]) -> Floats:
    """The lots (n, 4, 2) that lie on one of some pieces of open ground, to a centimetre."""
    if not len(lots):
        return lots
    wide = shapely.union_all(shapely.buffer(np.array(list(ground), object), 0.01))
    shapely.prepare(wide)
    kept: Floats = lots[shapely.covers(wide, shapely.polygons(lots))]
    return kept
