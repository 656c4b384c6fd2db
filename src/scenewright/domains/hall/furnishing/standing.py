"""A hall in which only what is given stands."""

from __future__ import annotations

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece
from scenewright.core.solution import LeftOut
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand
from scenewright.domains.hall.furnishing.assemble import Laid
from scenewright.domains.hall.furnishing.on_stage import put_on_stage
from scenewright.domains.hall.furnishing.pieces import kept_groups
from scenewright.domains.hall.hall_layout import HallLayout
from scenewright.domains.hall.visit.tour import tour


def keep_standing(
    hall: HallContext,
    locked: tuple[Piece, ...],
    carried: list[HallDemand],
    missing: tuple[LeftOut, ...],
    catalog: Catalog,
) -> Laid:
    """A hall in which nothing is laid out beside what is locked and stands on its stage."""
    on, groups, out = put_on_stage(hall, carried, hall.fixed, catalog)
    kept = (*kept_groups(hall, locked), *groups)
    layout = HallLayout(hall.plan.zones, hall.plan.links, kept)
    way = tour(hall.space, hall.fixed, layout, catalog, hall.route) if kept else None
    return Laid(on, kept, (), (), (*missing, *out), 0.0, 0, way)
