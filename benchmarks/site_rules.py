"""What a planner asks of a layout besides distances: doors, lanes, courts, room for parking.

Both the designer's buildings and ours are given ways by the same rules (a walk to each door, lanes
within reach of every building), on their boxes; what could not be laid out is what lacks.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.domains.site.brief import Parking, Site
from scenewright.domains.site.check.bodies import bodies_of, grounds_of
from scenewright.domains.site.check.doors import find_served
from scenewright.domains.site.paving import reserve_areas
from scenewright.domains.site.plan import site_plan
from scenewright.domains.site.works import lay_works
from scenewright.ground.plan import SitePlan, Standing

Row = dict[str, Any]
OPENING, COURT = 12.0, 400.0
"""Widest opening in metres, and least ground in square metres, of what counts as a closed court."""
BAYS, MOST = 1.0, 40
"""Bays for each building for which room is looked for, and most of them."""


def measure_rules(site: Site, pieces: list[Piece]) -> Row:
    """Shares of doors with a walk and of buildings near a lane; closed courts; and the share of
    bays that there is room for beside streets or the border."""
    plan = site_plan(site)
    ground = grounds_of([site], [plan])[0]
    bodies = bodies_of(ground, pieces)[0]
    served, near = find_served(ground, bodies, lay_works(site, plan, pieces))
    return {
        "doors": float(served.mean()) if len(served) else 1.0,
        "lanes": float(near.mean()) if len(near) else 1.0,
        "courts": float(count_courts(pieces)),
        "parking": _find_room(site, plan, pieces),
    }


def count_courts(pieces: list[Piece]) -> int:
    """The grounds that buildings enclose.

    >>> count_courts([])
    0
    """
    shapes = [shapely.Polygon(outline_of(piece)) for piece in pieces]
    grown = shapely.union_all(shapely.buffer(np.array(shapes, object), 0.5 * OPENING))
    holes = [ring for part in shapely.get_parts(grown) for ring in part.interiors]
    courts = [shapely.buffer(shapely.Polygon(ring), 0.5 * OPENING) for ring in holes]
    return sum(court.area >= COURT for court in courts)


def _find_room(site: Site, plan: SitePlan, pieces: list[Piece]) -> float:
    """The share of a bay for each building that finds room on what is left free."""
    bays = min(max(round(BAYS * len(pieces)), 1), MOST)
    asked = site.model_copy(update={"parking": Parking(bays=bays), "squares": []})
    standing = [
        Standing(p.id, "", "", outline_of(p), (*p.pose[:2], 0.0, 1.0, 1.0), 1.0) for p in pieces
    ]
    floor = shapely.Polygon(plan.outline, plan.holes)
    found = reserve_areas(asked, floor, plan.roads, standing, [floor], "")
    return sum(area.bays for area in found.areas) / bays
