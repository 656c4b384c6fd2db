"""Where a model can carry something: its upward faces, measured on its triangles.

Seen from above, the model is a grid of cells :data:`CELL` wide. An upright line through the middle
of a cell goes into solids through faces that look up and out of them through faces that look down;
counted from the top, a cell's *support* is a face through which the line goes in from free air, its
*headroom* the way up to the face above. Exact at the lines for closed meshes; of an open one what
lies under the opening counts as inside, where nothing is placed.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Part

Floats = NDArray[np.float64]
Flags = NDArray[np.bool_]
Ints = NDArray[np.int64]

CELL = 0.01
"""Width of a cell, metres."""
LEAST = 40
"""Cells of the smallest level that carries anything: 40 cm²."""
_LEVEL = 0.999
"""Upward part of the normal of a face that counts as level."""
_SAME = 1e-4
"""Metres within which heights are one."""
_PEEP = 0.04
"""Metres above a shelf at which it must be open to the front."""


class Level(NamedTuple):
    """One height of a model that carries: ``free`` (ny, nx) cells that are level there and can be
    reached from above or from the front, and their ``headroom`` in metres."""

    z: float
    free: Flags
    headroom: Floats


class Surfaces(NamedTuple):
    """All a model carries on: its ``levels`` from the highest down, and the ``top`` (ny, nx) seen
    from above (nan: nothing there). Cell (j, i) has its middle at ``start`` + ((i, j) + 0.5) cells
    in the frame of the piece."""

    start: tuple[float, float]
    levels: tuple[Level, ...]
    top: Floats

    @property
    def deck(self) -> float:
        """How high the next of a pile lies: the height of the middle of the model from above."""
        ny, nx = self.top.shape
        middle = self.top[ny // 5 : ny - ny // 5, nx // 5 : nx - nx // 5]
        return float(np.nanmedian(middle))

    @property
    def middles(self) -> tuple[Floats, Floats]:
        """The middles of all cells, x and y, each (ny, nx)."""
        ny, nx = self.top.shape
        x = self.start[0] + (np.arange(nx) + 0.5) * CELL
        y = self.start[1] + (np.arange(ny) + 0.5) * CELL
        across, along = np.meshgrid(x, y)
        return across, along


class _Crossings(NamedTuple):
    """Where upright lines meet faces, by cell and downwards: ``way`` is 1 into a solid and -1 out
    of it, ``within`` how many solids the line was in before."""

    cell: Ints
    z: Floats
    way: Ints
    level: Flags
    within: Ints


def surfaces_of(parts: Sequence[Part]) -> Surfaces:
    """The surfaces of a model.

    >>> from scenewright.catalog.assets import shipped
    >>> table = shipped().assets["coffee_table"]
    >>> round(surfaces_of(table.mesh(table.usual)).levels[0].z, 3) == table.usual.height
    True
    """
    corners = np.concatenate([part.vertices[part.faces] for part in parts])
    low, high = corners[..., :2].min((0, 1)), corners[..., :2].max((0, 1))
    nx, ny = (int(n) for n in np.maximum(np.ceil((high - low) / CELL - 1e-6), 1))
    found = _crossings(corners, low, nx, ny)
    top = np.full(nx * ny, np.nan)
    entered = (found.way > 0) & (found.within <= 0)
    first = np.flatnonzero(entered)[np.unique(found.cell[entered], return_index=True)[1]]
    top[found.cell[first]] = found.z[first]
    levels = tuple(_levels(found, entered, nx, ny))
    return Surfaces((float(low[0]), float(low[1])), levels, top.reshape(ny, nx))


def _crossings(corners: Floats, low: Floats, nx: int, ny: int) -> _Crossings:
    """All crossings of the lines through the middles of cells with triangles ``(m, 3, 3)``."""
    across = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    flat = corners[..., :2]
    first = np.ceil((flat.min(1) - low) / CELL - 0.5).astype(np.int64)
    last = np.floor((flat.max(1) - low) / CELL - 0.5).astype(np.int64)
    first, last = np.maximum(first, 0), np.minimum(last, [nx - 1, ny - 1])
    steep = np.abs(across[:, 2]) <= 1e-12
    rows = np.flatnonzero((first <= last).all(1) & ~steep)
    found = [_covered(corners[k], across[k], low, first[k], last[k], nx) for k in rows]
    cell = np.concatenate([f[0] for f in found]) if found else np.zeros(0, np.int64)
    z = np.concatenate([f[1] for f in found]) if found else np.zeros(0)
    face = np.repeat(rows, [len(f[0]) for f in found])
    way = np.sign(across[face, 2]).astype(np.int64)
    level = across[face, 2] >= _LEVEL * np.linalg.norm(across[face], axis=1)
    order = np.lexsort((-way, -np.round(z / _SAME), cell))
    cell, z, way, level = cell[order], z[order], way[order], level[order]
    passed = np.cumsum(way)
    start = np.searchsorted(cell, cell)
    return _Crossings(cell, z, way, level, passed - way - (passed - way)[start])


def _covered(
    triangle: Floats, across: Floats, low: Floats, first: Ints, last: Ints, nx: int
) -> tuple[Ints, Floats]:
    """Cells whose middle a triangle covers in plan, and its height there. A middle on an edge
    belongs to one of the two triangles that share it: that on its left, or above."""
    i, j = np.arange(first[0], last[0] + 1), np.arange(first[1], last[1] + 1)
    x = (low[0] + (i + 0.5) * CELL)[None, :]
    y = (low[1] + (j + 0.5) * CELL)[:, None]
    ring = triangle if across[2] > 0 else triangle[::-1]
    inside = np.ones((len(j), len(i)), bool)
    for a, b in zip(ring, np.roll(ring, -1, 0), strict=True):
        side = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
        owned = b[1] < a[1] or (b[1] == a[1] and b[0] < a[0])
        inside &= (side >= 0) if owned else (side > 0)
    jj, ii = np.nonzero(inside)
    px, py = x[0, ii] - triangle[0, 0], y[jj, 0] - triangle[0, 1]
    z = triangle[0, 2] - (across[0] * px + across[1] * py) / across[2]
    return (j[jj] * nx + i[ii]), z


def _levels(found: _Crossings, entered: Flags, nx: int, ny: int) -> Iterator[Level]:
    """The level heights of a model, the highest first."""
    above = np.full(len(found.z), np.inf)
    same = np.flatnonzero(found.cell[1:] == found.cell[:-1]) + 1
    above[same] = found.z[same - 1] - found.z[same]
    carrying = entered & found.level
    heights, count = np.unique(np.round(found.z[carrying] / (10 * _SAME)), return_counts=True)
    for height in heights[count >= LEAST][::-1]:
        rows = np.flatnonzero(carrying & (np.round(found.z / (10 * _SAME)) == height))
        z = float(found.z[rows].max())
        free, headroom = np.zeros((ny, nx), bool), np.zeros((ny, nx))
        free.flat[found.cell[rows]], headroom.flat[found.cell[rows]] = True, above[rows]
        covered = np.isfinite(headroom) & free
        free &= ~covered | ~_shut(found, z + _PEEP, nx, ny)
        if free.sum() >= LEAST:
            yield Level(z, free, headroom)


def _shut(found: _Crossings, z: float, nx: int, ny: int) -> Flags:
    """Cells (ny, nx) with something solid between them and the front at a height."""
    inside = np.zeros(nx * ny, np.int64)
    over = found.z > z
    np.add.at(inside, found.cell[over], found.way[over])
    solid = (inside > 0).reshape(ny, nx)
    shut: Flags = np.logical_or.accumulate(solid[::-1], 0)[::-1]
    return shut
