"""The demands of a site against its solution: buildings, and the ground laid out."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import numpy as np

from scenewright.check.bodies import TOLERANCE
from scenewright.check.owed import Owed
from scenewright.core.catalog import Catalog
from scenewright.core.footprint import extents
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.domains.site.brief import Building, Site
from scenewright.ground.plan import SitePlan
from scenewright.ground.works import GroundWorks


def list_owed(
    sites: Sequence[Site], plans: Sequence[SitePlan], pieces: Sequence[Piece], kinds: Catalog
) -> Iterator[Owed]:
    """What each site is to hold: a number of buildings of a name, model and size, or at least one
    where it states a target."""
    for site, plan in zip(sites, plans, strict=True):
        here = [p for p in pieces if p.space == plan.id and p.category == "building"]
        marks = {name for row in plan.landmarks for name in (row.id, f"{plan.id}/{row.id}")}
        here = [p for p in here if p.id not in marks]
        kept = {row.id for row in site.fixed}
        if not site.buildings:
            yield Owed(plan.id, "buildings", len(here), 1)
            continue
        rows = zip(site.buildings, plan.models, strict=True)
        asked: dict[tuple[str, str], list[Building]] = {}
        for row, model in rows:
            name = row.name or (kinds.assets[model].name if model in kinds.assets else "")
            asked.setdefault((name, model), []).append(row)
        for (name, model), same in asked.items():
            mine = [
                p
                for p in here
                if p.function == name and p.asset == model and _is_as_large(p, same, model, kinds)
            ]
            count, stay = sum(row.count for row in same), sum(p.id in kept for p in mine)
            yield Owed(plan.id, name, len(mine), count, max(count, stay), (name,))
        strange = sum((p.function, p.asset) not in asked for p in here if p.id not in kept)
        yield Owed(plan.id, "buildings of no demand", strange, 0, 0)


def _is_as_large(piece: Piece, rows: Sequence[Building], model: str, kinds: Catalog) -> bool:
    """Whether a building has the size that one of its rows states, or else its model's own."""
    asset = kinds.assets.get(model)
    for row in rows:
        size = row.size or (asset.usual if asset else None)
        if row.size is None and row.footprint and asset:
            size = (*extents(row.footprint), asset.usual.height)
        if size is None or np.abs(np.subtract(piece.size, size)).max() <= TOLERANCE:
            return True
    return False


def find_unstated(plans: Sequence[SitePlan], works: Sequence[GroundWorks]) -> list[Finding]:
    """A finding for each site whose ground works the solution does not state."""
    stated = {one.site for one in works}
    return [
        Finding("missing", "", plan.id, "", "", f"what is laid out on {plan.id} is not stated")
        for plan in plans
        if plan.id not in stated
    ]
