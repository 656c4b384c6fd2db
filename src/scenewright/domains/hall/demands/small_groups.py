"""A few objects stand in rows: three in a ring look thrown down."""

from __future__ import annotations

from scenewright.domains.hall.build_problem import HallContext
from scenewright.domains.hall.demands.holdings import HallDemand

RINGS, FEWEST = ("radiation", "circulation"), 5
"""Patterns that turn each object another way, and of how many objects on they read as a ring."""


def drop_small_rings(hall: HallContext, wishes: list[HallDemand]) -> list[HallDemand]:
    """Demands without rings for small groups whose pattern the brief leaves open; unchanged
    where groups stay as printed."""
    if hall.settings.whole:
        return wishes
    return [_without_rings(wish) if wish.unplaced else wish for wish in wishes]


def _without_rings(wish: HallDemand) -> HallDemand:
    rows = tuple(name for name in wish.patterns if name not in RINGS)
    return wish._replace(patterns=rows) if rows and len(wish.sizes) < FEWEST else wish
