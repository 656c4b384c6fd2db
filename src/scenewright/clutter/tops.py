"""The tops of a placed piece: its surfaces, less the things on or above them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import cos, sin
from typing import NamedTuple

import numpy as np

from scenewright.clutter.surfaces import CELL, Flags, Floats, Level, Surfaces
from scenewright.clutter.sweeps import Box
from scenewright.core.scene import Piece
from scenewright.core.space import Opening

Measure = Callable[[Piece], Surfaces]
"""The surfaces of a piece as it is drawn."""

TOUCH = 0.002
"""Metres by which something stands out of a surface before it is in the way there."""
SWING = 0.6
"""Metres before a window that its leaf takes when it opens inwards: nothing above its sill."""
MAIN, SHARE = 100, 0.2
"""Cells of the least level that is the top of a piece rather than a knob (100 cm²) or the edge of a
headboard: so large a share of its largest level."""


class Top(NamedTuple):
    """One level of a placed piece that carries: cells still ``free``, metres of ``headroom``; the
    ``highest`` large level of it is its top, those under something are shelves (others are the
    floors of basins and baths). Arrays are changed as it fills."""

    z: float
    free: Flags
    headroom: Floats
    highest: bool
    shelf: bool = False


class Carrier(NamedTuple):
    """A placed piece with its levels, the highest first, and its ``surfaces``; ``seats`` are the
    places (x, y) and directions to it of chairs in its frame (k, 4)."""

    piece: Piece
    tops: tuple[Top, ...]
    surfaces: Surfaces
    seats: Floats


def to_local(piece: Piece, points: Floats) -> Floats:
    """Points (n, 2) of a level in the frame of a piece: x to its width, y to its front."""
    c, s = cos(piece.pose.heading), sin(piece.pose.heading)
    moved = points - piece.pose[:2]
    return np.stack([moved[:, 0] * s - moved[:, 1] * c, moved[:, 0] * c + moved[:, 1] * s], -1)


def to_level(piece: Piece, points: Floats) -> Floats:
    """Points (n, 2) of the frame of a piece on its level; undoes :func:`to_local`."""
    c, s = cos(piece.pose.heading), sin(piece.pose.heading)
    turned = np.stack(
        [points[:, 0] * s + points[:, 1] * c, points[:, 1] * s - points[:, 0] * c], -1
    )
    return turned + np.array(piece.pose[:2])


def carrier_of(
    piece: Piece,
    near: Sequence[Piece],
    windows: Sequence[Opening],
    seats: Floats,
    measure: Measure,
    sweeps: Callable[[Piece], Sequence[Box]],
) -> Carrier:
    """A piece as a carrier among the pieces of its level ``near`` it; ``sweeps`` are the boxes in
    which something of a piece opens."""
    surfaces = measure(piece)
    open_above = [int(one.free[np.isinf(one.headroom)].sum()) for one in surfaces.levels]
    least = max(MAIN, SHARE * max(open_above, default=0))
    main = next((k for k, cells in enumerate(open_above) if cells >= least), 0)
    tops = tuple(
        Top(one.z, one.free.copy(), one.headroom.copy(), k == main, covered(one))
        for k, one in enumerate(surfaces.levels)
    )
    x, y = surfaces.middles
    spots = to_level(piece, np.stack([x.ravel(), y.ravel()], -1))
    for other in near:
        _stand_in(tops, piece, other, spots, measure)
    for other in (piece, *near):
        _open(tops, piece, sweeps(other), spots)
    for window in windows:
        _open_window(tops, piece, window, spots)
    return Carrier(piece, tops, surfaces, seats)


def covered(level: Level) -> bool:
    """Whether most of a level lies under something of its own model: a shelf."""
    return bool(np.isfinite(level.headroom[level.free]).mean() > 0.5)


def _stand_in(
    tops: Sequence[Top], piece: Piece, other: Piece, spots: Floats, measure: Measure
) -> None:
    """Take what another piece covers, and the headroom under what it holds up."""
    inner = to_local(other, spots)
    if (np.abs(inner) > np.array(other.size[:2]) / 2 + CELL).any(1).all():
        return
    there = measure(other)
    cells = np.floor((inner - there.start) / CELL).astype(np.int64)
    ny, nx = there.top.shape
    near = ((cells >= 0) & (cells < [nx, ny])).all(1)
    high = np.full(len(spots), -np.inf)
    high[near] = np.nan_to_num(there.top[cells[near, 1], cells[near, 0]], nan=-np.inf)
    high, low = high + other.pose.z, other.pose.z
    for top in tops:
        z, shape = piece.pose.z + top.z, top.free.shape
        inside = (high > z + TOUCH).reshape(shape)
        if low <= z + 10 * TOUCH:
            top.free[_grown(inside)] = False
        else:
            top.headroom[inside] = np.minimum(top.headroom[inside], low - z)


def _open(tops: Sequence[Top], piece: Piece, boxes: Sequence[Box], spots: Floats) -> None:
    """Take the room in which something opens, boxes in the frame of the level."""
    first, last = spots.min(0), spots.max(0)
    for low, high in boxes:
        if (low[:2] > last).any() or (high[:2] < first).any():
            continue
        within = ((spots > low[:2]) & (spots < high[:2])).all(1)
        for top in tops:
            z, inside = piece.pose.z + top.z, within.reshape(top.free.shape)
            if z < high[2]:
                top.headroom[inside] = np.minimum(top.headroom[inside], max(low[2] - z, 0.0))


def _grown(cells: Flags) -> Flags:
    """Cells and those beside them."""
    wide = cells.copy()
    wide[1:] |= cells[:-1]
    wide[:-1] |= cells[1:]
    found = wide.copy()
    found[:, 1:] |= wide[:, :-1]
    found[:, :-1] |= wide[:, 1:]
    return found


def _open_window(tops: Sequence[Top], piece: Piece, window: Opening, spots: Floats) -> None:
    """Nothing is higher than the sill where the leaf of a window comes in."""
    moved = spots - (window.x, window.y)
    along = moved @ np.array([window.ux, window.uy])
    out = moved @ np.array([-window.uy, window.ux])
    before = (np.abs(along) < window.width / 2) & (np.abs(out) < window.thickness / 2 + SWING)
    for top in tops:
        z, inside = piece.pose.z + top.z, before.reshape(top.free.shape)
        if z < window.head:
            top.headroom[inside] = np.minimum(top.headroom[inside], max(window.sill - z, 0.0))
