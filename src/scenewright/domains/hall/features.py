"""What can be liked about a hall, as numbers, and the reasons people give."""

from __future__ import annotations

from collections import Counter

import numpy as np

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.hall.patterns import PATTERNS
from scenewright.domains.hall.terms.table import MEANINGS
from scenewright.engine.preference.features import composition_features, term_features

REASONS: dict[str, dict[str, float]] = {
    "too dense": {"density": -1, "open": 1, "gaps": 1, "enclosure": -0.5},
    "too empty": {"open": -1, "enclosure": 1},
    "more open floor": {"open": 1},
    "tidier": {"rows": 1, "alignment": 1, "uneven_gaps": -1},
    "less rigid": {"rows": -1, "alignment": -1},
    "wider aisles": {"term aisles": -1, "gaps": 1},
    "shorter way round": {"tour": -1},
    "better balanced": {"term balance": -1},
    "more along the walls": {"from_edge": -1, "open": 1},
    "more mixed": {"mixing": 1},
}
"""Reasons by their words: features, and the sign in which they should change."""


def measure_features(solution: Solution, plan: Plan) -> dict[str, float]:
    """The features of a hall by name: terms, composition, the share of groups in each pattern,
    how zones share the floor, and how long the visitors' tour is."""
    found = term_features(solution, MEANINGS) | composition_features(solution, plan)
    detail = solution.detail
    groups = detail.layout.groups if detail is not None else ()
    many = [g for g in groups if len(g.objects) > 1]
    counts = Counter(g.pattern for g in many)
    for name in PATTERNS:
        found[f"pattern {name}"] = counts[name] / max(len(many), 1)
    tours = detail.tours if detail is not None else ()
    unit = sum(_area(space.outline) for space in plan.spaces) ** 0.5
    found["tour"] = sum(
        float(np.hypot(*np.diff(way.points, axis=0).T).sum()) for way in tours
    ) / max(unit, 1e-9)
    zones = [_area(zone.outline) for zone in detail.layout.zones] if detail is not None else []
    share = np.array(zones) / max(sum(zones), 1e-9)
    found["zone balance"] = float(-(share * np.log(np.maximum(share, 1e-9))).sum())
    return found


def _area(outline: object) -> float:
    """Area of a polygon (n, 2)."""
    x, y = np.asarray(outline, np.float64).T
    return abs(float(x @ np.roll(y, -1) - y @ np.roll(x, -1))) / 2
