"""Halls as their solvers see them: two zones, the problem built of them, a chain's boxes."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
import shapely

import scenewright
from scenewright.building.plan import spaces
from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.layout import corners
from scenewright.core.solution import Solution
from scenewright.domains.hall.build_problem import HallContext, hall_of
from scenewright.domains.hall.demands.holdings import HallDemand, collect_demands
from scenewright.domains.hall.fit import Fitted, fit
from scenewright.domains.hall.presets import PRESETS
from scenewright.domains.hall.problem import HallProblem
from scenewright.domains.hall.solvers.chains import HallChain
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.zoning.zones import borders_of, zones_of

SLACK = 5e-4
"""Square metres a footprint may stand over an edge."""


class Posed(NamedTuple):
    hall: HallContext
    wishes: list[HallDemand]
    fitted: Fitted


def posed(brief: Brief, preset: str = "default", seed: int = 0, **rule: Any) -> Posed:
    """A brief made to fit, by a preset with another ``rule`` of fitting."""
    space = spaces(brief)[0]
    plan = zones_of(brief, 0, space)
    found = hall_of(space, plan, borders_of(plan, space), (), brief.route_width)
    wishes = collect_demands(brief, 0, (), shipped())
    row = PRESETS[preset]
    settings = row.settings._replace(fit=row.settings.fit._replace(**rule))
    found = found._replace(settings=settings)
    return Posed(
        found, wishes, fit(found, wishes, row.weights, shipped(), seed, row.settings.whole)
    )


def ring(x0: float, y0: float, x1: float, y1: float) -> list[list[float]]:
    return [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]


def two_zones(*demands: dict[str, Any], **room: Any) -> Brief:
    """A hall of 20 by 10 metres in two equal zones, joined by the default link."""
    return Brief.model_validate(
        {
            "domain": "hall",
            "rooms": [
                {
                    "id": "hall",
                    "outline": ring(0, 0, 20, 10),
                    "height": 3.2,
                    "doors": [{"id": "in", "at": [5, 0], "width": 1.8}],
                    "zones": [
                        {"id": "west", "outline": ring(0, 0, 10, 10)},
                        {"id": "east", "outline": ring(10, 0, 20, 10)},
                    ],
                    "demands": list(demands),
                }
                | room
            ],
        }
    )


def boxes_of(chain: HallChain) -> np.ndarray:
    boxes = np.zeros((len(chain.p.sizes), 5))
    copy_frames(chain.s, boxes)
    return boxes


def rules_broken(problem: HallProblem, chain: HallChain) -> float:
    """The largest area by which footprints leave their zone, share floor, or stand in solids."""
    shapes = shapely.polygons(corners(boxes_of(chain)))
    ground, worst = problem.ground, 0.0
    for u, (first, last) in enumerate(problem.units.spans):
        a, b = ground.zone_spans[problem.units.zones[u]]
        zone = shapely.polygonize(
            [shapely.LineString(edge.reshape(2, 2)) for edge in ground.zone_edges[a:b]]
        )
        floor = max(zone.geoms, key=lambda part: part.envelope.area)
        worst = max(worst, *shapely.area(shapely.difference(shapes[first:last], floor)))
    walls = chain.s.walls[chain.s.walls[:, 4] > 0.0]
    built = np.column_stack([walls[:, :2], walls[:, 7], 2 * walls[:, 4], 2 * walls[:, 5]])
    rows = np.vstack([ground.obstacles, ground.keep_free, built])
    solids = shapely.union_all(shapely.polygons(corners(rows))) if len(rows) else shapely.Point()
    worst = max(worst, *shapely.area(shapely.intersection(shapes, solids)))
    first, second = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    pairs = first < second
    shared = shapely.area(shapely.intersection(shapes[first[pairs]], shapes[second[pairs]]))
    return float(max(worst, shared.max(initial=0.0)))


def answer(brief: Brief, **more: Any) -> Solution:
    asked: dict[str, Any] = {"preset": "quick", "steps": 1200, "seed": 4}
    return scenewright.solve(brief, **asked | more)
