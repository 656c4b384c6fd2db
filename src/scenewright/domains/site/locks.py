"""Buildings of a saved site that stay where they stand when it is solved again."""

from __future__ import annotations

from collections import Counter

from scenewright.core.brief import Brief
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Building, LockedBuilding, Site
from scenewright.ground.edits.locks import Lockable, kept_values, lock_brief, with_areas
from scenewright.ground.names import assign_ids

LANDMARK = "landmark"


def lock_sites(solution: Solution) -> Brief:
    """The brief to solve again: locked buildings are ``fixed`` on their site and count for what
    is asked; all others are free. Landmarks stand by the brief, locked or not."""
    return lock_brief(solution, BUILDINGS)


def _keep_building(piece: Piece) -> LockedBuilding | None:
    """A building as the brief keeps it; no landmark."""
    if piece.function == LANDMARK:
        return None
    return LockedBuilding(name=piece.function, **kept_values(piece))


BUILDINGS = Lockable("sites", "site", _keep_building, "trees and lamps", "buildings")


def ask_for_standing(brief: Brief, standing: Solution) -> Brief:
    """The brief, asking for the buildings of a solution where those are other than it asks for."""
    sites = brief.part.sites
    names = assign_ids(sites, "site", "sites")
    updated = [_ask(site, name, standing) for site, name in zip(sites, names, strict=True)]
    return with_areas(brief, "sites", updated)


def _ask(site: Site, name: str, standing: Solution) -> Site:
    here = [p for p in standing.pieces if p.space == name and p.category == "building"]
    counts = Counter(
        (p.function, p.asset, p.size, p.footprint) for p in here if p.function != LANDMARK
    )
    asked = Counter[str]()
    for row in site.buildings:
        asked[row.model] += row.count
    there = Counter[str]()
    for (_, model, _, _), count in counts.items():
        there[model] += count
    if asked == there:
        return site
    rows = [
        Building(
            model=model, name=label, size=(*size,), footprint=list(covered) or None, count=count
        )
        for (label, model, size, covered), count in counts.items()
    ]
    return site.model_copy(update={"buildings": rows, "library": []})
