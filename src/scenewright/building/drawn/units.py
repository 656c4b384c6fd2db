"""The unit of a drawing: what its header says if that can be, else the one that fits a building."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.building.drawn.drawing import Drawn

UNITS = (("m", 1.0), ("mm", 0.001), ("cm", 0.01), ("inches", 0.0254), ("feet", 0.3048))
"""Units that plans are drawn in, the usual first, in metres."""
EXTENT = (4.0, 250.0)
"""Metres a plan is long."""
LEAF = (0.5, 1.35)
"""Metres of the leaves of doors, by the median of the arcs."""
USUAL_LEAF, USUAL_WALL = 0.85, (0.04, 0.6)
"""The usual leaf, and the thickness of most walls, in metres."""


class UnitFound(NamedTuple):
    """A unit in metres, its name, and whether the header said so."""

    name: str
    metres: float
    stated: bool


def list_units(drawn: Drawn, stated: float | None) -> list[UnitFound]:
    """The units that may be a drawing's, the likeliest first. ``stated`` is that of the header in
    metres: the first where it can be."""
    fitting = [UnitFound(*row, False) for row in UNITS if fits_building(drawn, row[1])]
    leaf = median_leaf(drawn)
    if leaf is not None:
        fitting.sort(key=lambda unit: abs(np.log(leaf * unit.metres / USUAL_LEAF)))
    if stated is not None and fits_building(drawn, stated):
        others = [unit for unit in fitting if abs(unit.metres - stated) > 1e-9]
        return [UnitFound(_name(stated), stated, True), *others]
    return fitting


def _name(metres: float) -> str:
    return next((name for name, size in UNITS if abs(size - metres) < 1e-9), f"{metres:g} m")


def fits_building(drawn: Drawn, metres: float) -> bool:
    """Whether walls are as long as a building is, leaves as wide as people, walls as thick."""
    points = drawn.walls.reshape(-1, 2)
    long, short = sorted(np.ptp(points, axis=0) * metres)[::-1] if len(points) else (0.0, 0.0)
    leaf, thick = median_leaf(drawn), _thickness(drawn)
    if not EXTENT[0] <= long <= EXTENT[1] or short < 2.0:
        return False
    if leaf is not None:
        return LEAF[0] <= leaf * metres <= LEAF[1]
    return thick is None or USUAL_WALL[0] <= thick * metres <= USUAL_WALL[1]


def median_leaf(drawn: Drawn) -> float | None:
    """The median radius of the leaves drawn; ``None`` for fewer than two."""
    radii = [arc.radius for arc in drawn.arcs]
    return float(np.median(radii)) if len(radii) >= 2 else None


def _thickness(drawn: Drawn) -> float | None:
    """The distance between the two faces of a wall that most length of wall has, if the walls are
    drawn as two lines: the nearest parallel line beside each line."""
    walls = drawn.walls
    along = walls[:, 1] - walls[:, 0]
    length = np.hypot(*along.T)
    keep = np.argsort(-length)[:400]
    walls, along, length = walls[keep], along[keep], length[keep]
    if len(walls) < 8:
        return None
    unit = along / np.maximum(length, 1e-12)[:, None]
    middle = walls.mean(1)
    away = middle[None] - middle[:, None]
    aside = np.abs(away[..., 0] * unit[:, None, 1] - away[..., 1] * unit[:, None, 0])
    beside = np.abs((away * unit[:, None]).sum(-1)) < (length[:, None] + length[None]) / 2
    parallel = np.abs(unit @ unit.T) > 0.999
    aside[~(beside & parallel) | (aside < 1e-6 * length.max())] = np.inf
    nearest = aside.min(1)
    paired = np.isfinite(nearest)
    if length[paired].sum() < 0.5 * length.sum():
        return None
    order = np.argsort(nearest[paired])
    share = np.cumsum(length[paired][order]) / length[paired].sum()
    return float(nearest[paired][order][np.searchsorted(share, 0.35)])
