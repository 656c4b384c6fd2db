"""The fixed buildings of a site's brief, as pieces."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.ground.edits.locks import standing_piece
from scenewright.ground.plan import SitePlan


def given_pieces(_brief: Brief, plan: Plan, _kinds: Catalog) -> tuple[Piece, ...]:
    """The buildings that stay on the sites of a plan, by its brief alone; of landmarks see
    :mod:`.check.bodies`."""
    return tuple(piece for site in plan.detail for piece in fixed_buildings(site))


def fixed_buildings(plan: SitePlan) -> tuple[Piece, ...]:
    """The buildings that stay where they stand."""
    return tuple(standing_piece(row, plan.id, row.model, row.name) for row in plan.fixed)
