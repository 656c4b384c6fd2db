"""Rays among buildings: which of many upright boxes a ray meets first.

A uniform grid lists the boxes over each cell and the greatest height there; a ray walks from cell
to cell (J. Amanatides and A. Woo, *A fast voxel traversal algorithm for ray tracing*, 1987) and
passes over cells whose buildings are lower than it flies. Boxes stand on the ground and reach
down without end, so that rays only enter them through sides and roofs.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.geometry.boxes import Frame, frames_of, read_frame
from scenewright.geometry.compiled import compiled, inlined

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]

FRONT, LEFT, BACK, RIGHT, ROOF = range(5)
"""Sides of a box, in the order used everywhere, and its roof."""
CROWDED = 6
"""Boxes may be listed in this many cells on average."""


class BoxGrid(NamedTuple):
    """``frames`` (n, 8) of the boxes and ``heights`` (n,); corner, ``cell`` size, ``columns``
    and ``rows`` of the grid; cell k lists ``items[starts[k] : starts[k + 1]]``, none of them
    higher than ``tallest[k]``."""

    frames: Floats
    heights: Floats
    x0: float
    y0: float
    cell: float
    columns: int
    rows: int
    starts: Ints
    items: Ints
    tallest: Floats


def box_grid(boxes: ArrayLike, heights: ArrayLike) -> BoxGrid:
    """A grid over boxes ``(n, 5)`` (x, y, heading, width, depth) of ``heights`` (n,), metres.

    >>> grid = box_grid([[0, 0, 0.0, 10, 10], [50, 0, 0.0, 10, 10]], [9, 12])
    >>> grid.tallest.max().item(), len(grid.items) >= 2
    (12.0, True)
    """
    rows = np.ascontiguousarray(boxes, np.float64).reshape(-1, 5)
    tops = np.ascontiguousarray(heights, np.float64).reshape(-1)
    frames = frames_of(rows)
    c, s = np.abs(frames[:, 2]), np.abs(frames[:, 3])
    half = np.stack([s * frames[:, 4] + c * frames[:, 5], c * frames[:, 4] + s * frames[:, 5]], 1)
    low, high = frames[:, :2] - half, frames[:, :2] + half
    corner = low.min(0) if len(rows) else np.zeros(2)
    span = (high.max(0) if len(rows) else np.ones(2)) - corner
    cell = _cell(high - low, span)
    columns, lines = (int(v) for v in span / cell + 1)
    ends = np.concatenate([low - corner, high - corner], 1) // cell
    spread = np.clip(ends, 0, [columns - 1, lines - 1] * 2).astype(np.int64)
    many = (spread[:, 2] - spread[:, 0] + 1) * (spread[:, 3] - spread[:, 1] + 1)
    starts = np.zeros(columns * lines + 1, np.int64)
    items, tallest = np.zeros(int(many.sum()), np.int64), np.zeros(columns * lines)
    file(spread, tops, columns, starts, items, tallest)
    return BoxGrid(
        frames,
        tops,
        float(corner[0]),
        float(corner[1]),
        cell,
        columns,
        lines,
        starts,
        items,
        tallest,
    )


def _cell(sizes: Floats, span: Floats) -> float:
    """A cell as large as most boxes; larger if boxes lie so closely that lists would be long, or
    are so far apart that there would be many cells."""
    count = max(len(sizes), 1)
    cell = float(np.median(sizes.max(1))) if len(sizes) else 1.0
    cell = max(cell, 0.5, float(np.sqrt(span[0] * span[1] / (16 * count + 64))), 1e-3 * span.max())
    while (np.prod(sizes / cell + 1.0, axis=1)).sum() > CROWDED * count + 100:
        cell *= 1.5
    return cell


@compiled
def file(
    spread: Ints, heights: Floats, columns: int, starts: Ints, items: Ints, tallest: Floats
) -> None:
    """Fill the lists of a grid: ``spread`` (n, 4) first and last column and row of each box."""
    for i in range(spread.shape[0]):
        for row in range(spread[i, 1], spread[i, 3] + 1):
            for column in range(spread[i, 0], spread[i, 2] + 1):
                starts[row * columns + column] += 1
    for k in range(1, starts.shape[0]):
        starts[k] += starts[k - 1]
    for i in range(spread.shape[0]):
        for row in range(spread[i, 1], spread[i, 3] + 1):
            for column in range(spread[i, 0], spread[i, 2] + 1):
                k = row * columns + column
                starts[k] -= 1
                items[starts[k]] = i
                tallest[k] = max(tallest[k], heights[i])


@inlined
def enters(
    box: Frame, height: float, x: float, y: float, z: float, ax: float, ay: float, az: float
) -> tuple[float, int, float]:
    """Where the ray (x, y, z) + t (ax, ay, az), t > 0, enters a box: t (infinite if it does not,
    0 from inside), the side and the cosine of incidence (the direction taken as unit)."""
    dx, dy, c, s = x - box[0], y - box[1], box[2], box[3]
    u, v, au, av = dx * s - dy * c, dx * c + dy * s, ax * s - ay * c, ax * c + ay * s
    above = z - height
    if above >= 0.0 and az >= 0.0:
        return np.inf, -1, 0.0
    near, far, side, cosine = 0.0, np.inf, -1, 0.0
    if above > 0.0:
        near, side, cosine = -above / az, ROOF, -az
    elif az > 0.0:
        far = -above / az
    if au == 0.0:
        far = far if abs(u) < box[4] else -1.0
    else:
        far = min(far, (box[4] - u if au > 0.0 else -box[4] - u) / au)
        t = (-box[4] - u if au > 0.0 else box[4] - u) / au
        if t > near:
            near, side, cosine = t, LEFT if au > 0.0 else RIGHT, abs(au)
    if av == 0.0:
        far = far if abs(v) < box[5] else -1.0
    else:
        far = min(far, (box[5] - v if av > 0.0 else -box[5] - v) / av)
        t = (-box[5] - v if av > 0.0 else box[5] - v) / av
        if t > near:
            near, side, cosine = t, BACK if av > 0.0 else FRONT, abs(av)
    if near >= far:
        return np.inf, -1, 0.0
    return near, side, cosine


@inlined
def across(
    grid: BoxGrid, x: float, y: float, ax: float, ay: float, reach: float
) -> tuple[float, float]:
    """From where to where a ray is over the grid; the start lies after the end if it never is."""
    begin, end = 0.0, reach
    for axis in range(2):
        p, a = (x - grid.x0, ax) if axis == 0 else (y - grid.y0, ay)
        size = grid.cell * (grid.columns if axis == 0 else grid.rows)
        if a == 0.0:
            end = end if 0.0 <= p <= size else -1.0
        else:
            one, other = -p / a, (size - p) / a
            begin, end = max(begin, min(one, other)), min(end, max(one, other))
    return begin, end


@inlined
def first_box(
    grid: BoxGrid,
    x: float,
    y: float,
    z: float,
    ax: float,
    ay: float,
    az: float,
    reach: float,
    own: int,
) -> tuple[int, float, int, float]:
    """The first box but ``own`` a ray meets before ``reach``: its number (-1 if there is none),
    distance in lengths of the direction, side and cosine of incidence."""
    found, distance, side, cosine = -1, reach, -1, 0.0
    begin, end = across(grid, x, y, ax, ay, reach)
    if begin > end:
        return -1, reach, -1, 0.0
    column = min(max(int((x + begin * ax - grid.x0) / grid.cell), 0), grid.columns - 1)
    row = min(max(int((y + begin * ay - grid.y0) / grid.cell), 0), grid.rows - 1)
    right, up = 1 if ax > 0.0 else -1, 1 if ay > 0.0 else -1
    tx = ty = np.inf
    if ax != 0.0:
        tx = (grid.x0 + (column + (right + 1) // 2) * grid.cell - x) / ax
    if ay != 0.0:
        ty = (grid.y0 + (row + (up + 1) // 2) * grid.cell - y) / ay
    while begin < distance:
        leave = min(tx, ty)
        cell = row * grid.columns + column
        if z + (begin if az > 0.0 else min(leave, end)) * az < grid.tallest[cell]:
            for k in range(grid.starts[cell], grid.starts[cell + 1]):
                i = grid.items[k]
                if i != own:
                    t, face, facing = enters(
                        read_frame(grid.frames, i), grid.heights[i], x, y, z, ax, ay, az
                    )
                    if t < distance:
                        found, distance, side, cosine = i, t, face, facing
        begin = leave
        if tx < ty:
            column += right
            tx += grid.cell / abs(ax)
        else:
            row += up
            ty += grid.cell / abs(ay)
        if begin >= end or column < 0 or row < 0 or column >= grid.columns or row >= grid.rows:
            break
    return found, distance, side, cosine


@compiled
def cast(
    grid: BoxGrid,
    origins: Floats,
    ways: Floats,
    reach: float,
    found: Ints,
    distances: Floats,
    sides: Ints,
    cosines: Floats,
) -> None:
    """What rays from ``origins`` (r, 3) along unit ``ways`` (r, 3) meet first within ``reach``
    metres: see :func:`first_box`; distances are infinite where nothing is met."""
    for r in range(origins.shape[0]):
        found[r], distances[r], sides[r], cosines[r] = first_box(
            grid,
            origins[r, 0],
            origins[r, 1],
            origins[r, 2],
            ways[r, 0],
            ways[r, 1],
            ways[r, 2],
            reach,
            -1,
        )
        if found[r] < 0:
            distances[r] = np.inf
