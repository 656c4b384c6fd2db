"""Features every layout has: what its terms say and how it is composed.

A domain adds its own to these; one without features of its own gets these alone.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.geometry.composition import NAMES, measure_composition

Floats = NDArray[np.float64]
LOW = 0.3
"""Pieces that begin higher above the floor do not count as standing on it, metres."""


def stands_on_floor(piece: Piece) -> bool:
    """Whether a piece takes floor: it lies on nothing else and does not hang."""
    return piece.on is None and piece.pose.z < LOW and piece.function != "light"


def boxes_of(pieces: Sequence[Piece]) -> Floats:
    """Boxes (n, 5) of pieces."""
    rows = [(*p.pose[:2], p.pose.heading, *p.size[:2]) for p in pieces]
    return np.array(rows, np.float64).reshape(-1, 5)


def term_features(solution: Solution, names: Iterable[str]) -> dict[str, float]:
    """What each term costs in all, by ``term <name>``; 0 for those not reported."""
    found = dict.fromkeys(names, 0.0)
    for row in solution.terms:
        if row.term in found and np.isfinite(row.value):
            found[row.term] += float(row.cost) if row.weight else float(row.value)
    return {f"term {name}": value for name, value in found.items()}


def composition_features(
    solution: Solution, plan: Plan, counted: Callable[[Piece], bool] = stands_on_floor
) -> dict[str, float]:
    """The composition of the pieces ``counted`` in every space, the mean over spaces by area."""
    total, weight = np.zeros(len(NAMES)), 0.0
    for space in plan.spaces:
        here = [p for p in solution.pieces if p.space == space.id and counted(p)]
        if here:
            total += space_area(space) * compose_space(here, space)
            weight += space_area(space)
    return dict(zip(NAMES, (total / max(weight, 1e-9)).tolist(), strict=True))


def compose_space(pieces: Sequence[Piece], space: Space) -> Floats:
    """The composition (17,) of some pieces in their space."""
    floor = shapely.Polygon(space.outline, list(space.holes))
    _, kinds = np.unique([p.function or p.category for p in pieces], return_inverse=True)
    return measure_composition(boxes_of(pieces), kinds, floor)


def space_area(space: Space) -> float:
    """Floor area in square metres."""
    return float(shapely.Polygon(space.outline, list(space.holes)).area)
