"""Buildings set into each other's corners, moved apart again: each to where it has most room about
it and leaves least ground void, all others standing.

Setting them compactly finds room for all and jams them at one corner; what is left open is then
given back. Buildings are taken in an order drawn, so seeds are other schemes.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.footprint import place_outline
from scenewright.domains.site.problem import Floats, SiteProblem
from scenewright.domains.site.solvers.blocks.schemes import find_void, spread_points
from scenewright.domains.site.solvers.interlock import (
    StandingBuilding,
    blocks_of,
    clear_of,
    keep_away,
    places_in,
)
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.engine.solve import BudgetWatch

ROOM = (12.0, 8.0, 5.0, 3.0, 1.5)
"""Metres more than the least distance that a building is given, tried in turn."""
ROUNDS, MANY, LOOKED = 2, 60, 24
"""How often each is moved, the most buildings of a site on which they are, and places looked at."""


def loosen_buildings(
    problem: SiteProblem, found: SiteLayout, watch: BudgetWatch, rng: np.random.Generator
) -> SiteLayout:
    """The layout with its buildings moved apart, none turned and none left out."""
    here = np.flatnonzero(found.present)
    if len(here) > MANY:
        return found
    outlines, heights = problem.buildings.outlines(), problem.buildings.sizes[:, 2]
    boxes, blocks = found.boxes.copy(), blocks_of(problem)
    edges = np.asarray(problem.ground.block_edges)
    points = spread_points(edges)
    standing = {k: _stand(outlines[k], boxes[k], heights[k]) for k in here.tolist()}
    for _ in range(ROUNDS):
        for i in rng.permutation(here).tolist():
            if watch.cancelled() or watch.share(0) >= 1.0:
                return found
            others = [one for k, one in standing.items() if k != i]
            spots = _find_room(problem, blocks, outlines[i], boxes[i], others, heights[i])
            if len(spots):
                boxes[i, :2] = _choose(spots, points, boxes, here, i, rng)
                standing[i] = _stand(outlines[i], boxes[i], heights[i])
    return found._replace(boxes=boxes, score={})


def _stand(outline: Floats, box: Floats, height: float) -> StandingBuilding:
    return StandingBuilding(shapely.Polygon(place_outline(outline, *box[:3])), float(height))


def _find_room(
    problem: SiteProblem,
    blocks: list[shapely.Polygon],
    outline: Floats,
    box: Floats,
    others: list[StandingBuilding],
    height: float,
) -> Floats:
    """Corners (k, 2) of where the middle of a building can stand with as much room as there is."""
    block = min(blocks, key=lambda one: float(one.distance(shapely.Point(box[:2]))))
    turned = place_outline(outline, 0.0, 0.0, float(box[2]))
    free = places_in(block, turned)
    least = max(problem.spacing, problem.fire_access)
    for more in ROOM:
        wider = problem._replace(spacing=least + more)
        region = clear_of(free, turned, keep_away(wider, others, float(height)))
        spots = shapely.get_coordinates(region)
        if len(spots):
            return spots
    return np.zeros((0, 2))


def _choose(
    spots: Floats, points: Floats, boxes: Floats, here: np.ndarray, i: int, rng: np.random.Generator
) -> Floats:
    """The one of some spots (k, 2), a few drawn, that leaves least of the ``points`` void."""
    drawn = spots[rng.permutation(len(spots))[:LOOKED]]
    void = []
    for spot in drawn:
        boxes[i, :2] = spot
        void.append(find_void(points, boxes[here]))
    best: Floats = drawn[int(np.argmin(void))]
    return best
