"""The overlap of two footprints, also where they touch within a rounding error."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from scenewright.check.bodies import Shape, Shapes

GRID = 1e-9
"""Metres to which corners are rounded where an answer is looked at again."""


def intersect_footprints(one: Shape | Shapes, other: Shape | Shapes) -> Any:
    """What footprints share, (n,) or single shapes. Of two that touch along sides that differ by
    the last digit, ``shapely.intersection`` may return one whole (seen with GEOS 3.14): whatever
    has an area is therefore intersected again, with corners rounded to :data:`GRID`.

    >>> float(intersect_footprints(shapely.box(0, 0, 3, 2), shapely.box(2, 1, 5, 4)).area)
    1.0
    """
    shared = np.atleast_1d(np.asarray(shapely.intersection(one, other), object))
    rows = np.flatnonzero(shapely.area(shared) > 0.0)
    if len(rows):
        some, others = np.broadcast_arrays(np.asarray(one, object), np.asarray(other, object))
        a, b = np.atleast_1d(some)[rows], np.atleast_1d(others)[rows]
        shared[rows] = shapely.intersection(a, b, grid_size=GRID)
    alone = isinstance(one, shapely.Geometry) and isinstance(other, shapely.Geometry)
    return shared[0] if alone else shared
