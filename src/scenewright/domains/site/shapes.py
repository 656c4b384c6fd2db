"""Buildings on the sites of a solution, as footprints with heights: for maps and plans."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.site.brief import Site, rows_of
from scenewright.ground.plan import SitePlan

STOREY = 3.0


class StandingBuilding(NamedTuple):
    """A building or landmark: its footprint ``(n, 2)`` counter-clockwise, underside and top in
    metres, heading of its front, storeys, name, the model that draws it, and its site."""

    id: str
    name: str
    model: str
    site: str
    footprint: Points
    low: float
    high: float
    heading: float
    floors: int
    landmark: bool


def standing(solution: Solution, plans: tuple[SitePlan, ...]) -> tuple[StandingBuilding, ...]:
    """Buildings as placed, and landmarks as in the brief, in the order of the pieces; landmarks
    that have no piece come last."""
    marks = {
        name: row
        for plan in plans
        for row in plan.landmarks
        for name in (row.id, f"{plan.id}/{row.id}")
    }
    sites = {
        plan.id: (site, plan) for site, plan in zip(solution.brief.part.sites, plans, strict=True)
    }
    found, seen = [], set()
    for piece in solution.pieces:
        if piece.category != "building" or piece.space not in sites:
            continue
        row = marks.get(piece.id)
        if row is not None:
            seen.add(id(row))
        floors = storeys(*sites[piece.space], piece)
        found.append(
            StandingBuilding(
                piece.id,
                row.name if row else piece.function or piece.asset,
                piece.asset,
                piece.space,
                row.footprint if row else outline_of(piece),
                piece.pose.z,
                piece.pose.z + piece.size.height,
                piece.pose.heading,
                floors,
                row is not None,
            )
        )
    for plan in plans:
        for mark in plan.landmarks:
            if id(mark) not in seen:
                floors = max(1, round(mark.height / STOREY))
                found.append(
                    StandingBuilding(
                        mark.id,
                        mark.name,
                        mark.model,
                        plan.id,
                        mark.footprint,
                        0.0,
                        mark.height,
                        mark.box[2],
                        floors,
                        True,
                    )
                )
    return tuple(found)


def storeys(site: Site, plan: SitePlan, piece: Piece) -> int:
    """Storeys of a building: as the wish of its model says, else one for every 3 m."""
    rows = zip(rows_of(site), plan.models, strict=True)
    wishes = [wish for wish, model in rows if wish.floors and piece.asset == model]
    if not wishes:
        return max(1, round(piece.size.height / STOREY))
    heights = [abs((wish.size or piece.size)[2] - piece.size.height) for wish in wishes]
    return wishes[heights.index(min(heights))].floors or 1
