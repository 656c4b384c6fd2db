"""Whose shadow falls where, kept up to date while buildings move one at a time.

For every side of every building and every position of the sun, ``counts`` (n, 4, s) holds how
many other buildings stand in the way of the middle of the side at ``sill`` height. Moving one
building takes its shadows away from where it stood and throws them where it stands now; nobody
else's change. So the hours are the same as those of :func:`scenewright.geometry.sun.sun_hours`.

To move building i: :func:`throw` with ``sign`` -1, change its frame (and where it is filed in the
buckets), :func:`throw` with +1 and :func:`gather`. To take the move back, do the same again.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.geometry.box_grid import enters
from scenewright.geometry.boxes import Floats, Frame, Sides, read_frame
from scenewright.geometry.buckets import Buckets, column_of, row_of
from scenewright.geometry.compiled import compiled, inlined

Counts = NDArray[np.int16]


@inlined
def in_the_way(
    frames: Floats,
    heights: Floats,
    path: Floats,
    sill: float,
    i: int,
    j: int,
    sign: int,
    counts: Counts,
) -> None:
    """Add ``sign`` to the counts of building j wherever building i stands in the way.

    ``frames`` (n, 8), ``heights`` (n,) in metres, ``path`` (k, 3) directions to the sun,
    ``counts`` (n, 4, k).
    """
    a, b = read_frame(frames, i), read_frame(frames, j)
    dx, dy, wide = a[0] - b[0], a[1] - b[1], a[6] + b[6]
    z, top = min(sill, heights[j]), heights[i]
    for k in range(path.shape[0]):
        ax, ay, az = path[k, 0], path[k, 1], path[k, 2]
        flat = ax * ax + ay * ay
        ahead, aside = dx * ax + dy * ay, dx * ay - dy * ax
        if aside * aside > wide * wide * flat or ahead < -wide:
            continue
        if (ahead - wide) * az > (top - z) * flat:
            continue
        c, s = b[2], b[3]
        for side in range(4):
            if ax * c + ay * s > 0.0:
                out = b[4] if side % 2 else b[5]
                t, _, _ = enters(a, top, b[0] + out * c, b[1] + out * s, z, ax, ay, az)
                if t < np.inf:
                    counts[j, side, k] += sign
            c, s = -s, c


@inlined
def shadow_bounds(
    frame: Frame, height: float, sill: float, path: Floats, sign: float
) -> tuple[float, float, float, float]:
    """What holds all shadows of a building through the day (``sign`` -1), or all that can throw
    one on it if they are of this height (+1): x0, y0, x1, y1.

    ``path`` (k, 3) directions to the sun; metres.
    """
    x0 = x1 = y0 = y1 = 0.0
    for k in range(path.shape[0]):
        length = sign * max(height - sill, 0.0) / max(path[k, 2], 1e-6)
        x0, x1 = min(x0, length * path[k, 0]), max(x1, length * path[k, 0])
        y0, y1 = min(y0, length * path[k, 1]), max(y1, length * path[k, 1])
    r = frame[6]
    return frame[0] + x0 - r, frame[1] + y0 - r, frame[0] + x1 + r, frame[1] + y1 + r


@inlined
def among(
    frames: Floats,
    heights: Floats,
    path: Floats,
    sill: float,
    buckets: Buckets,
    i: int,
    place: int,
    sign: int,
    counts: Counts,
) -> None:
    """Building i and the others in one list of the buckets: its shadows on them (``sign`` 1 or
    -1) or theirs on it (0).

    ``frames`` (n, 8), ``heights`` (n,) in metres, ``path`` (k, 3), ``counts`` (n, 4, k).
    """
    j = buckets.heads[place]
    while j >= 0:
        if j != i and sign != 0:
            in_the_way(frames, heights, path, sill, i, j, sign, counts)
        elif j != i:
            in_the_way(frames, heights, path, sill, j, i, 1, counts)
        j = buckets.after[j]


@inlined
def among_near(
    frames: Floats,
    heights: Floats,
    path: Floats,
    sill: float,
    buckets: Buckets,
    bounds: Sides,
    i: int,
    sign: int,
    counts: Counts,
) -> None:
    """:func:`among` all that may reach into ``bounds``.

    ``frames`` (n, 8), ``heights`` (n,) in metres, ``path`` (k, 3), ``counts`` (n, 4, k).
    """
    x0, y0, x1, y1 = bounds
    reach = buckets.reach
    for row in range(row_of(buckets, y0 - reach), row_of(buckets, y1 + reach) + 1):
        for column in range(column_of(buckets, x0 - reach), column_of(buckets, x1 + reach) + 1):
            place = row * buckets.columns + column
            among(frames, heights, path, sill, buckets, i, place, sign, counts)
    among(frames, heights, path, sill, buckets, i, buckets.columns * buckets.rows, sign, counts)


@compiled
def throw(
    frames: Floats,
    heights: Floats,
    path: Floats,
    sill: float,
    buckets: Buckets,
    i: int,
    sign: int,
    counts: Counts,
) -> None:
    """Add (``sign`` 1) or take away (-1) the shadows of building i on all others that are filed
    in ``buckets``; ``frames`` (n, 8), ``heights`` (n,), ``path`` from ``sun.sun_path``.

    About 6 microseconds among 120 buildings, 100 among 6,000.
    """
    bounds = shadow_bounds(read_frame(frames, i), heights[i], 0.0, path, -1.0)
    among_near(frames, heights, path, sill, buckets, bounds, i, sign, counts)


@compiled
def gather(
    frames: Floats,
    heights: Floats,
    path: Floats,
    sill: float,
    buckets: Buckets,
    i: int,
    highest: float,
    counts: Counts,
) -> None:
    """Count anew what stands in the way of building i; ``highest`` of all heights.

    ``frames`` (n, 8), ``heights`` (n,) in metres, ``path`` (k, 3), ``counts`` (n, 4, k).
    """
    counts[i, :, :] = 0
    low = min(sill, heights[i])
    bounds = shadow_bounds(read_frame(frames, i), highest, low, path, 1.0)
    among_near(frames, heights, path, sill, buckets, bounds, i, 0, counts)


@compiled
def hours_of(frames: Floats, path: Floats, i: int, side: int, counts: Counts) -> float:
    """Hours of sun on a side (0 front, 1 left, 2 back, 3 right) of building i."""
    c, s = frames[i, 2], frames[i, 3]
    for _ in range(side):
        c, s = -s, c
    hours = 0.0
    for k in range(path.shape[0]):
        if counts[i, side, k] == 0 and path[k, 0] * c + path[k, 1] * s > 0.0:
            hours += path[k, 3]
    return hours
