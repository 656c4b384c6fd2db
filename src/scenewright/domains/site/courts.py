"""Courts of a layout: the ground that buildings of a block stand round.

Buildings grown by half of the widest opening allowed enclose a court if their union has a hole; the
court is the ground of that hole up to the facades.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.space import Points
from scenewright.domains.site.brief import Site
from scenewright.ground.plan import SitePlan
from scenewright.ground.works import PavedArea

FROM_WALLS = 0.5
"""Metres that the ground of a court, as drawn, stays off the facades."""
LEAST = 25.0
"""Square metres of ground, between buildings so grown, that count as a court."""


def find_courts(site: Site, plan: SitePlan, footprints: Sequence[Points]) -> tuple[PavedArea, ...]:
    """The courts of a site that asks for closed ones, by the ``footprints`` (k, 2) of its
    buildings."""
    if site.court_gap is None or not footprints:
        return ()
    shapes = np.array([shapely.Polygon(ring) for ring in footprints], object)
    found = []
    for block in list_court_blocks(site, plan):
        own = shapes[shapely.intersects(block, shapely.centroid(shapes))]
        grown = shapely.union_all(shapely.buffer(own, 0.5 * site.court_gap))
        for part in shapely.get_parts(grown):
            for ring in part.interiors:
                hole = shapely.Polygon(ring)
                if hole.area >= LEAST:
                    ground = shapely.difference(
                        hole.buffer(0.5 * site.court_gap), shapely.union_all(own)
                    )
                    found += _as_areas(ground)
    return tuple(found)


def list_court_blocks(site: Site, plan: SitePlan) -> list[shapely.Polygon]:
    """The blocks of a site whose form is a perimeter block."""
    blocks = [shapely.Polygon(block.outline, block.holes) for block in plan.free]
    forms = [site.form] * len(blocks)
    for row in site.blocks:
        if blocks:
            forms[int(np.argmin(shapely.distance(blocks, shapely.Point(row.at))))] = row.form
    return [block for block, form in zip(blocks, forms, strict=True) if form == "peripheral"]


def _as_areas(ground: shapely.Geometry) -> list[PavedArea]:
    """The largest part of some ground, with few corners; none of what is too narrow."""
    drawn_in = shapely.buffer(ground, -2.0 * FROM_WALLS).buffer(FROM_WALLS)
    if drawn_in.is_empty:
        return []
    part = max(shapely.get_parts(drawn_in), key=lambda one: float(one.area))
    ring = shapely.get_coordinates(shapely.simplify(part, 0.5 * FROM_WALLS).exterior)[:-1]
    return [PavedArea("court", tuple((x, y) for x, y in np.round(ring, 3).tolist()))]
