"""The fixed buildings of a site's brief, as pieces."""

from __future__ import annotations

from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose, Size
from scenewright.ground.plan import SitePlan


def given_pieces(_brief: Brief, plan: Plan, _kinds: Catalog) -> tuple[Piece, ...]:
    """The buildings that stay on the sites of a plan, by its brief alone; of landmarks see
    :mod:`.check.bodies`."""
    return tuple(piece for site in plan.detail for piece in fixed_buildings(site))


def fixed_buildings(plan: SitePlan) -> tuple[Piece, ...]:
    """The buildings that stay where they stand."""
    return tuple(
        Piece(
            id=row.id,
            category="building",
            asset=row.model,
            space=plan.id,
            pose=Pose(*row.box[:2], 0.0, row.box[2]),
            size=Size(row.box[3], row.box[4], row.height),
            group=f"{plan.id}/buildings",
            function=row.name,
            fixed=True,
            footprint=row.local,
        )
        for row in plan.fixed
    )
