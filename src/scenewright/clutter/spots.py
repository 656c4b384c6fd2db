"""Where on a carrier the next small object goes."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, sin

import numpy as np

from scenewright.clutter.rows import Place
from scenewright.clutter.surfaces import CELL, Flags, Floats
from scenewright.clutter.tops import Carrier, Top

CLEAR = 0.01
"""Metres left above a small object under a shelf."""
NEAR = 0.12
"""Metres within which something must lie of the place it belongs to (a plate before its chair)."""
INSET = {"seat": 0.2, "behind": 0.36, "beside": 0.2}
"""Metres from the edge at which what is used from a seat has its middle."""
ASIDE = 0.19
"""Metres to the right (then the left) of the middle of a place at a table at which cutlery is."""
RISE = 0.06
"""By how much more than a seat its back is higher, metres."""
SINK = 0.008
"""Metres by which something soft or on something soft gives way."""

Spot = tuple[float, float, float]
"""Where the middle is in the frame of the carrier, x and y, and the height."""


def windows_free(top: Top, wide: float, deep: float, tall: float) -> Flags:
    """Cells (ny - kd + 1, nx - kw + 1) at which a box ``wide`` by ``deep`` by ``tall`` metres may
    have its first corner: all it covers is free and has the headroom."""
    ok = top.free & (top.headroom >= tall + CLEAR)
    kw, kd = cells_of(wide), cells_of(deep)
    if kd > ok.shape[0] or kw > ok.shape[1]:
        return np.zeros((0, 0), bool)
    total = np.zeros((ok.shape[0] + 1, ok.shape[1] + 1), np.int64)
    total[1:, 1:] = ok.cumsum(0).cumsum(1)
    inside = total[kd:, kw:] - total[:-kd, kw:] - total[kd:, :-kw] + total[:-kd, :-kw]
    found: Flags = inside == kw * kd
    return found


def cells_of(length: float) -> int:
    """How many cells a length takes up, at whatever place it begins."""
    return int(np.ceil(length / CELL - 1e-6)) + 1


def turned_box(wide: float, deep: float, turn: float) -> tuple[float, float]:
    """The sides of the box about a rectangle that is turned."""
    c, s = abs(cos(turn)), abs(sin(turn))
    return wide * c + deep * s, wide * s + deep * c


def find_spot(
    carrier: Carrier,
    where: Place,
    number: int,
    size: tuple[float, float, float],
    rng: np.random.Generator,
) -> tuple[int, Spot] | None:
    """The level and spot of the ``number``-th thing of a row, of a box ``size``; none if there is
    no room for it."""
    rows = [k for k, top in enumerate(carrier.tops) if top.highest and where != "shelf"]
    if where in ("shelf", "any"):
        shelves = [k for k, top in enumerate(carrier.tops) if top.shelf and not top.highest]
        rows += rng.permutation(shelves).astype(int).tolist()
    for k in rows:
        free = windows_free(carrier.tops[k], *size)
        if free.any():
            spot = _choose(carrier, free, where, number, size, rng)
            if spot is not None:
                return k, (*spot, carrier.tops[k].z)
    return None


def _choose(
    carrier: Carrier,
    free: Flags,
    where: Place,
    number: int,
    size: tuple[float, float, float],
    rng: np.random.Generator,
) -> tuple[float, float] | None:
    j, i = np.nonzero(free)
    half = np.array([cells_of(size[0]), cells_of(size[1])]) / 2
    x, y = ((np.stack([i, j], -1) + half) * CELL + carrier.surfaces.start).T
    if where in INSET:
        target = _place_at_seat(carrier, where, number)
        if target is None:
            return None
        off = np.hypot(x - target[0], y - target[1])
        k = int(np.argmin(off))
        return (float(x[k]), float(y[k])) if off[k] <= NEAR else None
    cost = rng.random(len(x)) * 0.6
    wide, deep = (max(float(side), 0.1) for side in carrier.piece.size[:2])
    if where == "back":
        cost = cost * 0.25 + (y / deep + 0.5) + 0.35 * rng.random() * np.abs(x / wide)
        cost += np.abs(x / wide - rng.uniform(-0.5, 0.5))
    elif where == "middle":
        cost = cost * 0.15 + np.hypot(x, y) / wide
    elif where == "side":
        cost = cost * 0.3 - np.abs(x) / wide + (x * _first_side(carrier) * (-1) ** number > 0)
    k = int(np.argmin(cost))
    return float(x[k]), float(y[k])


def _first_side(carrier: Carrier) -> int:
    """The side, 1 or -1, that the first thing of a row takes: by where the carrier stands, so that
    the second can take the other."""
    return 1 if int(10 * (carrier.piece.pose.x + carrier.piece.pose.y)) % 2 else -1


def _place_at_seat(carrier: Carrier, where: Place, number: int) -> tuple[float, float] | None:
    """Where what belongs to a seat has its middle: on the line on which the chair looks."""
    if not len(carrier.seats):
        return None
    count = len(carrier.seats)
    sx, sy, ux, uy = carrier.seats[number % count]
    half = np.array(carrier.piece.size[:2]) / 2
    start = (-np.sign(ux) * half[0], sy) if abs(ux) > abs(uy) else (sx, -np.sign(uy) * half[1])
    aside = 0.0
    if where == "beside":
        aside = (ASIDE, -ASIDE, ASIDE + 0.05)[min(number // count, 2)]
    inset = INSET[where]
    return float(start[0] + ux * inset + uy * aside), float(start[1] + uy * inset - ux * aside)


def lean_spots(carrier: Carrier, wide: float, deep: float) -> list[Spot]:
    """Places on a soft seat or bed where something leans on its back, from the sides inwards.

    Along each column of cells from the front the seat ends where the model rises by more than
    :data:`RISE`; a cushion's back edge is there, and its seat must be even.
    """
    top, start = carrier.surfaces.top, carrier.surfaces.start
    ny, nx = top.shape
    seat = np.nanmedian(top[ny // 3 : 2 * ny // 3])
    rises = np.nan_to_num(top, nan=-1.0) > seat + RISE
    front = ny - 1 - np.argmax(rises[: 2 * ny // 3][::-1], 0) - (ny - 2 * ny // 3)
    front = np.where(rises[: 2 * ny // 3].any(0), front + 1, -1)
    kw, kd = cells_of(wide), cells_of(deep)
    found: list[Spot] = []
    for i in range(nx - kw + 1):
        j = int(front[i : i + kw].max())
        if (front[i : i + kw] < 0).any() or j + kd > ny:
            continue
        under = top[j : j + kd, i : i + kw]
        if np.isnan(under).any() or np.ptp(under) > 2 * RISE or np.ptp(front[i : i + kw]) > 8:
            continue
        z = float(np.quantile(under, 0.7)) - SINK
        found.append((start[0] + (i + kw / 2) * CELL, start[1] + (j + deep / 2 / CELL) * CELL, z))
    return found


def set_apart(spots: Sequence[Spot], wide: float) -> list[Spot]:
    """Of places in a row those that leave ``wide`` metres to each other, from both ends inwards."""
    left, chosen = list(spots), list[Spot]()
    while left:
        chosen.append(left[-1] if len(chosen) % 2 else left[0])
        left = [spot for spot in left if abs(spot[0] - chosen[-1][0]) >= wide]
    return chosen


def foot_spot(carrier: Carrier, deep: float) -> Spot:
    """Across a bed, a third of a metre above its foot."""
    top, start = carrier.surfaces.top, carrier.surfaces.start
    y = carrier.piece.size.depth / 2 - 0.28 - deep / 2
    rows = slice(*(int((v - start[1]) / CELL) for v in (y - deep / 2, y + deep / 2)))
    half = top.shape[1] // 4
    under = top[rows, half:-half]
    return 0.0, y, float(np.nanquantile(under, 0.8)) - SINK


def take(
    top: Top, x: float, y: float, wide: float, deep: float, start: Floats | tuple[float, float]
) -> None:
    """Cells under a box, and about it, are no longer free."""
    low = np.floor((np.array([x - wide / 2, y - deep / 2]) - start) / CELL).astype(int)
    high = np.ceil((np.array([x + wide / 2, y + deep / 2]) - start) / CELL).astype(int)
    low = np.maximum(low, 0)
    top.free[low[1] : max(high[1], 0), low[0] : max(high[0], 0)] = False
