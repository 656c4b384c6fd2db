"""Flat polygons in space, with holes, cut into triangles.

The cutting is that of mapbox-earcut; here polygons are laid into a plane for it: the one of the
coordinate planes they are most parallel to.
"""

from __future__ import annotations

from collections.abc import Sequence

import mapbox_earcut
import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]


def newell(ring: Floats) -> Floats:
    """Normal ``(3,)`` of a polygon ``(n, 3)``, twice its area long, whether flat or not.

    M. Newell's sum of cross products (I. Sutherland, R. Sproull and R. Schumacker, 1974).

    >>> newell(np.array([[0.0, 0, 5], [2, 0, 5], [2, 1, 5], [0, 1, 5]])).tolist()
    [0.0, 0.0, 4.0]
    """
    x, y, z = (ring - ring[0]).T
    return np.array([_twice_area(y, z), _twice_area(z, x), _twice_area(x, y)])


def _twice_area(first: Floats, second: Floats) -> float:
    """Twice the signed area of a polygon whose first corner is the origin."""
    return float(first[:-1] @ second[1:] - second[:-1] @ first[1:])


def triangles(rings: Sequence[Floats]) -> Ints:
    """Triangles ``(m, 3)`` of a polygon: indices into its rings ``(n, 3)`` set end to end.

    The first ring is the outline, the others holes; the triangles run as the outline does. A
    polygon without area has none.

    >>> outline = np.array([[0.0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]])
    >>> hole = np.array([[1.0, 1, 0], [1, 2, 0], [2, 2, 0], [2, 1, 0]])
    >>> len(triangles([outline, hole]))
    8
    """
    normal = newell(rings[0])
    axis = int(np.argmax(np.abs(normal)))
    if not abs(normal[axis]) > 0.0:
        return np.zeros((0, 3), np.int64)
    points = np.concatenate(rings)
    first, second = ((1, 2), (2, 0), (0, 1))[axis]
    plane = np.ascontiguousarray((points - points[0])[:, [first, second]])
    ends = np.cumsum([len(ring) for ring in rings]).astype(np.uint32)
    found = mapbox_earcut.triangulate_float64(plane, ends).reshape(-1, 3).astype(np.int64)
    a, b, c = (plane[found[:, k]] for k in range(3))
    area = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    wrong = area * normal[axis] < 0.0
    found[wrong] = found[wrong][:, ::-1]
    return np.asarray(found[area != 0.0])


def quads_cut(points: Floats, quads: Ints) -> Ints:
    """Triangles ``(2 m, 3)`` of quadrangles ``(m, 4)``, along the diagonal that lies inside.

    >>> dart = np.array([[0.0, 0, 0], [2, 1, 0], [0, 2, 0], [1, 1, 0]])
    >>> quads_cut(dart, np.array([[0, 1, 2, 3]])).tolist()
    [[1, 2, 3], [1, 3, 0]]
    """
    a, b, c, d = (points[quads[:, k]] for k in range(4))
    first, second = np.cross(b - a, c - a), np.cross(c - a, d - a)
    other = np.einsum("ij,ij->i", first, second) < 0.0
    turned = np.where(other[:, None], np.roll(quads, -1, axis=1), quads)
    return np.asarray(turned[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3))
