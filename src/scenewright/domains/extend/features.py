"""What can be liked about an extension, as numbers, and the reasons people give."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD
from scenewright.domains.extend.rating import MEANINGS
from scenewright.engine.preference.features import boxes_of, composition_features, term_features

REASONS: dict[str, dict[str, float]] = {
    "too dense": {"gaps": 1, "open": 1, "density": -1},
    "too loose": {"gaps": -1, "density": 1},
    "more like the old": {"term how": -1, "term what": -1},
    "tidier": {"rows": 1, "alignment": 1, "uneven_gaps": -1},
    "less rigid": {"rows": -1, "uneven_gaps": 1},
    "more like courts": {"enclosure": 1},
    "more open space": {"open": 1},
    "open space in the middle": {"open_from_middle": -1, "open": 0.5},
    "larger buildings": {"floor area": 1},
    "smaller buildings": {"floor area": -1},
    "taller": {"height": 1},
    "lower": {"height": -1},
    "more mixed": {"mixing": 1},
    "less mixed": {"mixing": -1},
    "closer to the street": {"to street": -1},
    "away from the street": {"to street": 1},
}
"""Reasons by their words: features, and the sign in which they should change."""


def measure_features(solution: Solution, plan: Plan) -> dict[str, float]:
    """The features of an extension by name: how far it is from its sources, the composition of the
    new buildings, their mean height (metres) and floor area (log m²), and their mean distance to
    the street, as a share of the root of the ground."""
    new = [piece for piece in solution.pieces if is_new(piece)]
    found = term_features(solution, MEANINGS) | composition_features(solution, plan, is_new)
    sizes = np.array([p.size for p in new], float).reshape(-1, 3)
    lines = [shapely.LineString(way.line) for way in plan.detail.ground.roads if len(way.line) > 1]
    unit = max(float(plan.detail.ground.area), 1.0) ** 0.5
    points = shapely.points(boxes_of(new)[:, :2])
    away = shapely.distance(points, shapely.union_all(lines)) if lines else np.zeros(len(new))
    return found | {
        "floor area": float(
            np.log(np.maximum(sizes[:, 0] * sizes[:, 1], 1.0)).mean() if new else 0
        ),
        "height": float(sizes[:, 2].mean()) if new else 0.0,
        "to street": float(np.mean(away)) / unit if new else 0.0,
        "placed": float(len(new)),
    }


def is_new(piece: Piece) -> bool:
    """Whether a piece is a building that was grown."""
    return piece.category == "building" and not piece.space.startswith(OLD)
