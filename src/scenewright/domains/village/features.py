"""What can be liked about a village, as numbers, and the reasons people give."""

from __future__ import annotations

import numpy as np

from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.reasons import MEANINGS
from scenewright.engine.preference.features import composition_features, term_features

REASONS: dict[str, dict[str, float]] = {
    "too dense": {"term coverage": -1, "term gap": 1, "open": 1},
    "too loose": {"term coverage": 1, "term gap": -1},
    "tidier": {"term beside": 1, "term along": 1, "uneven_gaps": -1},
    "less rigid": {"term beside": -1, "term along": -1},
    "closer to the street": {"term setback": -1},
    "away from the street": {"term setback": 1},
    "more like courts": {"enclosure": 1},
    "more open space": {"open": 1, "term coverage": -1},
    "open space in the middle": {"open_from_middle": -1, "open": 0.5},
    "larger houses": {"floor area": 1},
    "smaller houses": {"floor area": -1},
    "taller": {"height": 1},
    "lower": {"height": -1},
    "more mixed": {"mixing": 1, "spread of sizes": 1},
    "less mixed": {"mixing": -1, "spread of sizes": -1},
}
"""Reasons by their words: features, and the sign in which they should change."""


def measure_features(solution: Solution, plan: Plan) -> dict[str, float]:
    """The features of a village by name: what is said of its blocks, the composition of its
    houses, and their mean height (metres), mean floor area and its spread (both in log m²)."""
    sizes = np.array([p.size for p in solution.pieces if is_house(p)], float).reshape(-1, 3)
    areas = np.log(np.maximum(sizes[:, 0] * sizes[:, 1], 1.0))
    found = term_features(solution, MEANINGS) | composition_features(solution, plan, is_house)
    return found | {
        "floor area": float(areas.mean()) if len(areas) else 0.0,
        "spread of sizes": float(areas.std()) if len(areas) else 0.0,
        "height": float(sizes[:, 2].mean()) if len(sizes) else 0.0,
        "placed": float(len(sizes)),
    }


def is_house(piece: Piece) -> bool:
    """Whether a piece is a house of the village."""
    return piece.category == "building"
