"""What can be liked about a group of buildings, as numbers, and the reasons people give."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site
from scenewright.domains.site.locks import LANDMARK
from scenewright.domains.site.terms.table import SITE_AIMS, SITE_TERMS
from scenewright.engine.preference.features import boxes_of, composition_features, term_features

Floats = NDArray[np.float64]

REASONS: dict[str, dict[str, float]] = {
    "too dense": {"gaps": 1, "open": 1, "enclosure": -1},
    "too loose": {"gaps": -1, "enclosure": 1},
    "more sun": {"term sun": 1},
    "more open space": {"open": 1},
    "open space in the middle": {"open_from_middle": -1, "open": 0.5},
    "more like courts": {"enclosure": 1, "rows": -0.5},
    "tidier": {"rows": 1, "alignment": 1, "uneven_gaps": -1},
    "less rigid": {"rows": -1, "uneven_gaps": 1},
    "more mixed": {"mixing": 1},
    "less mixed": {"mixing": -1},
    "closer to the street": {"to street": -1},
    "away from the street": {"to street": 1},
    "tall in the middle": {"tall in the middle": 1},
    "tall at the edge": {"tall in the middle": -1},
    "more to see": {"term seen": 1},
    "more trees": {"trees": 1},
}
"""Reasons by their words: features, and the sign in which they should change."""
DEVELOPED = ("trees",)
"""Features that only a whole layout tells, with its ways and what grows between them."""


def measure_features(solution: Solution, plan: Plan) -> dict[str, float]:
    """The features of a site by name: terms and aims, composition of the buildings, how far they
    stand from streets and landmarks, where the tall ones stand, and trees."""
    names = [row.name for row in (*SITE_TERMS, *SITE_AIMS)]
    found = term_features(solution, names) | composition_features(solution, plan, is_building)
    rows = []
    for site, space in zip(solution.brief.part.sites, plan.spaces, strict=True):
        here = [p for p in solution.pieces if p.space == space.id]
        rows.append(_measure_site(site, shapely.Polygon(space.outline, list(space.holes)), here))
    return found | {name: float(np.mean([row[name] for row in rows])) for name in rows[0]}


def is_building(piece: Piece) -> bool:
    """Whether a piece is a building that was placed, not a landmark, a tree or a lamp."""
    return piece.category == "building" and piece.function != LANDMARK


def _measure_site(site: Site, floor: shapely.Polygon, pieces: list[Piece]) -> dict[str, float]:
    placed = [p for p in pieces if is_building(p)]
    marks = [p for p in pieces if p.function == LANDMARK]
    unit = max(float(floor.area), 1e-9) ** 0.5
    boxes, heights = boxes_of(placed), np.array([p.size.height for p in placed])
    middle = np.array(floor.centroid.coords[0])
    at = (boxes[:, :2] - middle) / unit
    streets = shapely.union_all([shapely.LineString(road.line) for road in site.roads])
    near = streets if site.roads else floor.boundary
    points = shapely.points(boxes[:, :2])
    to_marks = shapely.MultiPoint([p.pose[:2] for p in marks])
    turned = np.cos(boxes[:, 2] - site.facing)
    return {
        "to street": _mean(shapely.distance(points, near)) / unit,
        "to landmark": _mean(shapely.distance(points, to_marks)) / unit if marks else 0.0,
        "faces the sun": _mean(turned),
        "tall in the middle": -_correlate(heights, np.hypot(*at.T)),
        "tall in the east": _correlate(heights, at[:, 0]),
        "tall in the north": _correlate(heights, at[:, 1]),
        "trees": sum(p.category == "tree" for p in pieces) / unit,
        "placed": float(len(placed)),
    }


def _mean(values: Floats) -> float:
    return float(np.mean(values)) if len(values) else 0.0


def _correlate(one: Floats, other: Floats) -> float:
    """Correlation of two vectors (n,); 0 where one does not vary."""
    one, other = one - _mean(one), other - _mean(other)
    size = float(np.hypot.reduce(one, initial=0.0) * np.hypot.reduce(other, initial=0.0))
    return float(one @ other) / size if size > 1e-9 else 0.0
