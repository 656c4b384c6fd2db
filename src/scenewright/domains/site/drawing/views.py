"""What walkers on the ways of a site see, for its plan."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from scenewright.catalog.loading import catalog_of
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.geometry.walker import eyes_along, seen
from scenewright.ground.plan import SitePlan
from scenewright.render.building_quality import collect_building_quality

PACE, EYES = 5.0, 4000
"""Metres between points on the ways, and about how many there are at most."""
BOUNDS = 1e6
"""Metres beyond which nothing can be seen for sure."""

Views = Mapping[str, tuple[Points, Points]]
"""By site: points (n, 2) along its ways, and the visual quality V (n,) seen from each."""


def views_of(solution: Solution, plans: Sequence[SitePlan]) -> Views:
    """The views from the ways of every site that has ways and buildings."""
    catalog = catalog_of(solution.brief.catalogs)
    found = {}
    for plan in plans:
        here = [
            p
            for p in solution.pieces
            if p.space == plan.id and p.category == "building" and _sound(p)
        ]
        lines = [part for way in plan.roads for part in way.inside]
        length = sum(float(np.hypot(*np.diff(line, axis=0).T).sum()) for line in lines)
        eyes = eyes_along(list(lines), max(PACE, length / EYES))
        if here and len(eyes):
            found[plan.id] = (
                eyes,
                seen(eyes, *collect_building_quality(here, catalog), best=1.0).points,
            )
    return found


def _sound(piece: Piece) -> bool:
    """True if a building has a place and a size that rays can meet."""
    numbers = np.array([*piece.pose, *piece.size], float)
    bounded = bool(np.isfinite(numbers).all() and (np.abs(numbers) < BOUNDS).all())
    return bounded and min(piece.size) > 0.0
