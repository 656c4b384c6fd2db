"""Stands of a fair stand side by side and back to back of others, with an aisle before them."""

from __future__ import annotations

from scenewright.catalog.kinds import hall_use
from scenewright.core.catalog import Catalog
from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand

ISLAND, STAND = "exhibit_island", "exhibit_island_stand"
"""The category of stands, and how they are drawn."""
STAND_AISLE, SEVERAL = 2.4, 2
"""Metres free before stands: people stop on both sides and others pass; and how many stand so at
least."""


def abut_stands(hall: HallContext, wishes: list[HallDemand], catalog: Catalog) -> list[HallDemand]:
    """Demands with nothing free at sides and backs of several stands of a fair that ask for no
    clearance of their own; as they are where groups stay as printed."""
    if hall.settings.whole:
        return wishes
    return [_abut(wish) if _is_stand(wish, catalog) else wish for wish in wishes]


def _is_stand(wish: HallDemand, catalog: Catalog) -> bool:
    usual = wish.clearance == hall_use(wish.category).clearance
    if wish.category != ISLAND or len(wish.sizes) < SEVERAL or not usual:
        return False
    drawn = catalog.choose_called(wish.category, f"{wish.id} {wish.name}")
    return drawn is not None and drawn.id == STAND


def _abut(wish: HallDemand) -> HallDemand:
    return wish._replace(clearance=(max(STAND_AISLE, wish.clearance[0]), 0.0, 0.0, 0.0))
