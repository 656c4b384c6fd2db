"""From the plan of a site and its buildings to the problem that is solved."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.building.outlines import edges
from scenewright.catalog.appearance import PLAIN, Facts, Measure, qualities
from scenewright.core.space import Points
from scenewright.domains.site.brief import Site
from scenewright.domains.site.holdings import BuildingDemand
from scenewright.domains.site.problem import Buildings, Floats, SiteGround, SiteProblem
from scenewright.ground.plan import Block, SitePlan
from scenewright.ground.works import FRONTED

PACE = 5.0
"""Distance of the points from which people look, along ways, in metres."""


class Looks(NamedTuple):
    """How the models of a site look: facts by the id of the asset, the assets of its landmarks
    and buildings that stay ("": none known), and the measure of visual quality."""

    facts: Mapping[str, Facts]
    landmarks: tuple[str, ...]
    measure: Measure = "relief"


def build_problem(
    site: Site,
    plan: SitePlan,
    buildings: list[BuildingDemand],
    weights: dict[str, float],
    looks: Looks,
) -> SiteProblem:
    """The problem of placing some buildings on a site."""
    sizes = np.array([tuple(b.size) for b in buildings], np.float64).reshape(-1, 3)
    facts = [looks.facts[b.asset.id] for b in buildings]
    marks = [looks.facts.get(name, PLAIN) for name in looks.landmarks]
    quality, sides = qualities([*facts, *marks], looks.measure)
    count, least = len(buildings), float(sizes[:, :2].min(initial=np.inf))
    return SiteProblem(
        ground=_ground(plan, least, site.verge)._replace(
            landmark_quality=quality[count:], landmark_sides=sides[count:]
        ),
        buildings=Buildings(
            sizes=sizes,
            quality=quality[:count],
            sides=sides[:count],
            tone=np.array([f.tone for f in facts]),
            symmetry=np.array([f.symmetry for f in facts]),
            models=np.array([b.wish for b in buildings], np.int64),
            floors=np.array([b.floors for b in buildings], np.int64),
            forms=tuple(b.forms for b in buildings),
            footprints=(
                tuple(b.footprint for b in buildings) if any(b.footprint for b in buildings) else ()
            ),
        ),
        names=tuple(f"{plan.id}/{b.asset.id}_{k}" for k, b in enumerate(buildings, 1)),
        weights=weights,
        spacing=site.spacing,
        sun_spacing=site.sun_spacing,
        facing=site.facing,
        fire_access=site.fire_access,
        latitude=site.latitude,
        day=site.day,
        door_distance=site.door_distance,
        block_forms=_block_forms(site, _wide_blocks(plan, least)),
        court_gap=site.court_gap or 0.0,
    )


def _ground(plan: SitePlan, least: float, verge: float) -> SiteGround:
    """The ground, with the blocks that are at least ``least`` metres wide somewhere; fronts look
    over a ``verge`` at streets beside the border."""
    blocks = _wide_blocks(plan, least)
    rings = [_rings(block.outline, block.holes) for block in blocks]
    ends = np.cumsum([len(ring) for ring in rings])
    standing = (*plan.landmarks, *plan.fixed)
    ways = [line for way in plan.roads for line in (*way.inside, *way.beside)]
    outline = _rings(plan.outline, plan.holes)
    low, high = plan.outline.min(0), plan.outline.max(0)
    middles = [np.mean(a.outline, axis=0) for a in plan.areas if a.kind == "square"]
    marks = [row.box[:2] for row in plan.landmarks]
    return SiteGround(
        edges=outline,
        block_edges=np.concatenate([np.zeros((0, 4)), *rings]),
        block_spans=np.stack([ends - [len(ring) for ring in rings], ends], 1).astype(np.int64)
        if rings
        else np.zeros((0, 2), np.int64),
        block_areas=np.array([block.area for block in blocks]),
        roads=np.concatenate(
            [
                np.zeros((0, 5)),
                *(_pieces(line, way.width) for way in plan.roads for line in way.inside),
                *(
                    _pieces(line, way.width + 2.0 * verge)
                    for way in plan.roads
                    for line in way.beside
                ),
            ]
        ),
        landmarks=np.array([row.box for row in standing]).reshape(-1, 5),
        landmark_heights=np.array([row.height for row in standing]),
        landmark_quality=np.ones(len(standing)),
        eyes=np.concatenate([np.zeros((0, 2)), *(_space_points(line) for line in ways)]),
        bounds=np.concatenate([low, high]),
        area=plan.area,
        squares=np.concatenate(
            [
                np.zeros((0, 4)),
                *(edges(np.array(a.outline)) for a in plan.areas if a.kind in FRONTED),
            ]
        ),
        focus=np.array(middles or marks).reshape(-1, 2),
    )


def _wide_blocks(plan: SitePlan, least: float) -> list[Block]:
    """The blocks in which something as wide as ``least`` may stand."""
    return [block for block in plan.free if 2.02 * block.radius >= least]


def _block_forms(site: Site, blocks: Sequence[Block]) -> tuple[str, ...]:
    """The form asked for each block: its own, else that of the site ("": any)."""
    shapes = [shapely.Polygon(block.outline, block.holes) for block in blocks]
    found = [site.form or ""] * len(shapes)
    for row in site.blocks:
        near = int(np.argmin(shapely.distance(shapes, shapely.Point(row.at)))) if shapes else 0
        found[near : near + 1] = [row.form] * len(found[near : near + 1])
    return tuple(found)


def _rings(outline: Points, holes: tuple[Points, ...]) -> Floats:
    return np.concatenate([edges(ring) for ring in (outline, *holes)])


def _pieces(line: Points, width: float) -> Floats:
    """Boxes of the straight pieces of a way, fronts along it."""
    step = np.diff(line, axis=0)
    length = np.hypot(step[:, 0], step[:, 1])
    middle = 0.5 * (line[1:] + line[:-1])
    return np.column_stack(
        [middle, np.arctan2(step[:, 1], step[:, 0]), np.full(len(step), width), length]
    )


def _space_points(line: Points) -> Floats:
    """Points along a line, about :data:`PACE` metres apart."""
    step = np.hypot(*np.diff(line, axis=0).T)
    along = np.concatenate([[0.0], np.cumsum(step)])
    count = max(int(along[-1] / PACE), 1) + 1
    at = np.linspace(0.0, along[-1], count)
    return np.stack([np.interp(at, along, line[:, k]) for k in (0, 1)], 1)
