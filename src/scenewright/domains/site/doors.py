"""Doors of a layout: every one gets a walk, room before it, and a lane near by.

What has none is turned round where that helps, and left out where it does not.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.footprint import place_outline
from scenewright.core.layout import corners
from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.domains.site.brief import Site
from scenewright.domains.site.courts import list_court_blocks
from scenewright.domains.site.facing import face_ways
from scenewright.domains.site.problem import Flags, Floats, SiteProblem
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.ground.plan import SitePlan
from scenewright.ground.streetside.frontage import find_doors_at_border
from scenewright.ground.ways.pathways import Network, lay_pathways
from scenewright.ground.ways.walks import find_doors

ROUNDS = 3
"""How often what is cut off is left out, before all that is still cut off is."""


class ServedLayout(NamedTuple):
    """A layout whose doors are served: its ways, by the number of a building left out, why, and
    the footprints (k, 2) of all that stands."""

    layout: SiteLayout
    network: Network
    lost: dict[int, str]
    footprints: list[Floats]


class Served(NamedTuple):
    """The ways to buildings at some boxes, those that stay last, and which doors lie too near the
    border, which buildings too far from a lane, which doors have no walk."""

    network: Network
    at_border: Flags
    far: Flags
    closed: Flags

    def faulty(self) -> Flags:
        """Which buildings (n,) break a rule."""
        return self.at_border | self.far | self.closed


def serve_doors(
    site: Site, plan: SitePlan, problem: SiteProblem, found: SiteLayout, stay: tuple[Piece, ...]
) -> ServedLayout:
    """A layout with ways to all its doors; ``stay`` are buildings that stand already."""
    lost: dict[int, str] = {}
    free = None
    if problem.form == "repaired" and not site.sun_required:
        shapes = problem.buildings.footprints
        free = np.array([not (shapes and shapes[i]) for i in range(len(found.present))], bool)
        loose = (free & ~find_closing(site, plan, found))[found.present]
        boxes = found.boxes.copy()
        boxes[found.present] = face_ways(plan, problem, boxes[found.present], loose)
        found = found._replace(boxes=boxes, score={})
    found, served = _serve(site, plan, problem, found, stay, free)
    if served.faulty().any():
        turned = _turn_round(problem, found, served.faulty())
        turned, again = _serve(site, plan, problem, turned, stay)
        if again.faulty().sum() < served.faulty().sum():
            found, served = turned, again
    for _ in range(ROUNDS):
        faulty = np.flatnonzero(served.faulty())
        if not len(faulty):
            break
        here = np.flatnonzero(found.present)
        lost |= {int(here[k]): _reason(site, served, int(k)) for k in faulty}
        present = found.present.copy()
        present[here[faulty]] = False
        found = found._replace(present=present, score={})
        found, served = _serve(site, plan, problem, found, stay, free)
    outlines = [*_footprints(problem, found), *(outline_of(piece) for piece in stay)]
    return ServedLayout(found, served.network, lost, outlines)


def find_closing(site: Site, plan: SitePlan, found: SiteLayout) -> Flags:
    """Which buildings (n,) stand round a court that is to close."""
    if site.court_gap is None or not found.forms:
        return np.zeros(len(found.present), bool)
    blocks = shapely.union_all(list_court_blocks(site, plan))
    round_court = np.array([form == "peripheral" for form in found.forms], bool)
    return round_court & shapely.dwithin(blocks, shapely.points(found.boxes[:, :2]), 0.0)


def _serve(
    site: Site,
    plan: SitePlan,
    problem: SiteProblem,
    found: SiteLayout,
    stay: tuple[Piece, ...],
    free: Flags | None = None,
) -> tuple[SiteLayout, Served]:
    """The ways to a layout, with the fronts turned to them that are ``free`` (n,) to."""
    here, own = np.flatnonzero(found.present), int(found.present.sum())
    outlines = [*_footprints(problem, found), *(outline_of(piece) for piece in stay)]
    headings = np.concatenate([found.boxes[here, 2], [piece.pose.heading for piece in stay]])
    may = None if free is None else np.append(free[here], np.zeros(len(stay), bool))
    network = lay_pathways(plan, outlines, headings, site.fire_access, site.fire_reach, may)
    if may is not None:
        boxes = found.boxes.copy()
        boxes[here, 2] = network.headings[:own]
        found = found._replace(boxes=boxes, score={})
    doors = find_doors(outlines[:own], network.headings[:own])
    at_border = find_doors_at_border(plan, doors, site.door_distance)
    return found, Served(network, at_border, ~network.near[:own], ~network.served[:own])


def _footprints(problem: SiteProblem, found: SiteLayout) -> list[Floats]:
    """The footprint of each building that stands, corners (k, 2)."""
    here = np.flatnonzero(found.present)
    if not problem.buildings.footprints:
        return list(corners(found.boxes[here]))
    outlines = problem.buildings.outlines()
    return [place_outline(outlines[i], *found.boxes[i, :3]) for i in here]


def _turn_round(problem: SiteProblem, found: SiteLayout, faulty: Flags) -> SiteLayout:
    """The layout with the boxes among the faulty ones turned to the other side."""
    here = np.flatnonzero(found.present)[faulty]
    shapes = problem.buildings.footprints
    boxes = found.boxes.copy()
    boxes[[i for i in here if not shapes or not shapes[i]], 2] += math.pi
    return found._replace(boxes=boxes, score={})


def _reason(site: Site, served: Served, k: int) -> str:
    """Why a building cannot stand where there is room for it."""
    if served.at_border[k]:
        return f"its door would be less than {site.door_distance:g} m from the border"
    if served.closed[k]:
        return "no walk leads to the door where there is room for it"
    return (
        f"no lane {site.fire_access:g} m wide comes within {site.fire_reach:g} m of where there "
        "is room for it"
    )
