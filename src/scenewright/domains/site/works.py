"""Ground works of a site: lanes, walks and areas between its buildings."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Points
from scenewright.domains.site.brief import Site
from scenewright.domains.site.courts import find_courts
from scenewright.domains.site.parks import lay_parks
from scenewright.ground.buildings.built import BuiltRoad
from scenewright.ground.plan import SitePlan
from scenewright.ground.terrain.profiles import rule_area
from scenewright.ground.ways.pathways import Network, lay_pathways
from scenewright.ground.works import GREEN, GroundWorks, Pathway


def works_of(solution: Solution, plans: Sequence[SitePlan]) -> tuple[GroundWorks, ...]:
    """What a solution says is laid out on each of its sites; where it says nothing (it was saved
    before ways were, or made by another program), ways are laid out to its buildings."""
    known = {one.site: one for one in solution.detail or ()}
    return tuple(
        known[plan.id] if plan.id in known else lay_works(site, plan, solution.pieces)
        for site, plan in zip(solution.brief.part.sites, plans, strict=True)
    )


def lay_works(site: Site, plan: SitePlan, pieces: Sequence[Piece]) -> GroundWorks:
    """The ways to the buildings among some pieces."""
    marks = {name for row in plan.landmarks for name in (row.id, f"{plan.id}/{row.id}")}
    here = [
        piece
        for piece in pieces
        if piece.space == plan.id and piece.category == "building" and piece.id not in marks
    ]
    sound = [p for p in here if np.isfinite([*p.pose, *p.size]).all() and min(p.size) > 0]
    paths = network_of(site, plan, sound).pathways
    return gather_works(site, plan, paths, [outline_of(piece) for piece in sound])


def gather_works(
    site: Site, plan: SitePlan, pathways: Sequence[Pathway], footprints: Sequence[Points]
) -> GroundWorks:
    """All that is laid out on a site: ways, what was set apart for squares and parking, the
    courts that buildings, ``footprints`` (k, 2), enclose, and parks where none is near."""
    ways, areas = (*plan.drives, *pathways), (*plan.areas, *find_courts(site, plan, footprints))
    parks, walks = lay_parks(plan, ways, areas, footprints)
    return GroundWorks(plan.id, (*ways, *walks), (*areas, *parks))


def network_of(site: Site, plan: SitePlan, buildings: Sequence[Piece]) -> Network:
    """The ways of a site to all of some buildings."""
    headings = np.array([piece.pose.heading for piece in buildings])
    outlines = [outline_of(piece) for piece in buildings]
    return lay_pathways(plan, outlines, headings, site.fire_access, site.fire_reach)


def list_grounds(_solution: Solution, plan: Plan) -> tuple[SitePlan, ...]:
    """The grounds of all sites."""
    return tuple(plan.detail)


def list_ways(solution: Solution, plan: Plan) -> list[BuiltRoad]:
    """The middle lines of streets, paths, lanes and drives of all sites, and strips of what is
    paved beside them."""
    found = [BuiltRoad(w.line, w.width, w.kind, w.name) for one in plan.detail for w in one.roads]
    works = works_of(solution, plan.detail)
    laid = [row for one in works for row in one.pathways]
    driven = [row for row in laid if row.kind != "walk"]
    lines = [(shapely.LineString(row.line), row) for row in driven]
    heads = [(line, row.width / 2) for line, row in lines if line.length < row.width / 2]
    found += [
        BuiltRoad(np.array(row.line), row.width, row.kind)
        for line, row in lines
        if line.length >= row.width / 2
    ]
    paved = [np.array(a.outline) for one in works for a in one.areas if a.kind not in GREEN]
    paved += [shapely.get_coordinates(line.buffer(wide))[:-1] for line, wide in heads]
    return found + [strip for outline in paved for strip in rule_area(outline)]
