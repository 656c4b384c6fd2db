"""Sites of any number of buildings at one density, and one measure for all methods on them.

Streets in a grid, seven or eight buildings a block, a landmark in the middle; buildings are the
paper's nineteen styles and plain ones in one fixed order, so that a scene holds those of the next
smaller one. The measure is F_eva of (22) in Zhang, Yang 2023 with its parts, what walkers see,
sun on fronts in winter, and the verdict of the referee on what was placed.
"""

from __future__ import annotations

import math
import time
from collections import Counter
from itertools import cycle, islice
from typing import Any, NamedTuple

import numpy as np

from scenewright.catalog.assets import shipped
from scenewright.core.brief import Brief
from scenewright.core.catalog import Catalog
from scenewright.domains.site.check.figures import judge_sites
from scenewright.domains.site.furnish import buildings, landmarks
from scenewright.domains.site.holdings import BuildingDemand, collect_buildings
from scenewright.domains.site.plan import plans_of, site_plan
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solvers.outcome import SiteFound
from scenewright.domains.site.solving import problems
from scenewright.ground.plan import SitePlan

Row = dict[str, Any]
SIZES = (6, 15, 30, 70, 120)
"""Numbers of buildings in the paper's scenes."""
MIX = (
    "villa",
    "row_houses",
    "pagoda",
    "modern_residential",
    "japanese_house",
    "gallery",
    "point_tower",
    "villa",
    "classical_residence",
    "row_houses",
    "commercial_block",
    "modernist_house",
    "modern_residential",
    "buddhist_temple",
    "villa",
    "row_houses",
    "gothic_church",
    "villa",
    "office_tower",
    "modern_residential",
    "pavilion",
    "japanese_house",
    "classical_residence",
    "museum",
    "villa",
    "row_houses",
    "gymnasium",
    "modernist_house",
    "byzantine_church",
    "modern_residential",
)
EACH, SPACING, STREET, SETBACK = 7.5, 6.0, 8.0, 3.0
"""Buildings a block; metres between buildings, of street, and kept from streets and borders."""
DENSITY = 0.6
"""How much of the blocks buildings with their distances take."""


class Scene(NamedTuple):
    """A site ready to be solved: the brief, its plan, what is to be placed, and the problem as
    each preset poses it. Layouts are measured by that of the default."""

    brief: Brief
    plan: SitePlan
    wishes: list[BuildingDemand]
    problems: dict[str, SiteProblem]
    catalog: Catalog


def scene_brief(
    count: int, density: float = DENSITY, sun_spacing: float = 0.0, library: bool = False
) -> Brief:
    """A site for so many buildings; as a ``library`` for as much ground and floor of the same."""
    catalog, models = shipped(), list(islice(cycle(MIX), count))
    sizes = np.array([catalog.assets[model].usual for model in models])
    behind = np.maximum(SPACING, sun_spacing * sizes[:, 2])
    ground = float(((sizes[:, 0] + SPACING) * (sizes[:, 1] + behind)).sum()) / density
    columns = max(round(math.sqrt(count / EACH)), 2)
    rows = max(math.ceil(count / EACH / columns), 1)
    side = math.sqrt(ground / (columns * rows)) + STREET + 2.0 * SETBACK
    wide, deep = columns * side, rows * side
    across = [[[-5.0, k * side], [wide + 5.0, k * side]] for k in range(1, rows)]
    along = [[[k * side, -5.0], [k * side, deep + 5.0]] for k in range(1, columns)]
    counts = Counter(models)
    site: Row = {
        "id": "scene",
        "outline": [[0, 0], [wide, 0], [wide, deep], [0, deep]],
        "roads": [{"line": line, "width": STREET} for line in across + along],
        "landmarks": [
            {
                "id": "temple",
                "model": "pavilion",
                "at": [(columns // 2 + 0.5) * side, (rows // 2 + 0.5) * side],
            }
        ],
        "buildings": [{"model": model, "count": counts[model]} for model in sorted(counts)],
        "spacing": SPACING,
        "sun_spacing": sun_spacing,
        "setback": SETBACK,
        "road_setback": SETBACK,
        "origin": [11.58, 48.14],
    }
    if library:
        area, low = wide * deep, sizes[:, 2] / 3.0
        del site["buildings"]
        shares = [{"model": model, "share": counts[model]} for model in sorted(counts)]
        site |= {"library": shares, "coverage": float(sizes[:, :2].prod(1).sum() / area)}
        site |= {"floor_area_ratio": float((sizes[:, :2].prod(1) * low).sum() / area)}
    told = {"domain": "site", "name": f"{count} buildings", "sites": [site]}
    return Brief.model_validate({"format": "scenewright/brief", "version": 1} | told)


def posed(brief: Brief) -> Scene:
    """A brief with one site as the problems that methods are given."""
    site, catalog = brief.part.sites[0], shipped()
    plan = site_plan(site, catalog)
    found = {name: problems(brief, name)[0] for name in PRESETS}
    return Scene(brief, plan, collect_buildings(site, plan, "site", catalog), found, catalog)


def judged(scene: Scene, found: SiteFound) -> Row:
    """The common measure of what a method found, and the referee's verdict with its seconds."""
    layout = found.layouts[0]
    placed = buildings(scene.plan, scene.wishes, layout.boxes, layout.present)
    pieces = (*landmarks(scene.plan, scene.catalog), *placed)
    begun = time.process_time()
    verdict = judge_sites(scene.brief.part.sites, pieces, plans_of(scene.brief))
    took = time.process_time() - begun
    kinds = Counter(finding.kind for finding in verdict.findings)
    figures = next(iter(verdict.figures.values()))
    scores = score(scene.problems["default"], layout.boxes, layout.present)
    return {
        **{name: scores[name] for name in ("value", "use", "shown", "texture", "height", "seen")},
        "sun": figures["sun_mean"] or 0.0,
        "sunny": figures["sun_share"],
        "overlaps": kinds["collision"],
        "outside": kinds["out_of_bounds"],
        "near": kinds["setback"] + kinds["spacing"] + kinds["blocked_path"],
        "unreached": kinds["unreachable_building"],
        "valid": float(not kinds),
        "left_out": int((~layout.present).sum()),
        "generations": layout.generations,
        "evaluations": found.evaluations,
        "judging": took,
    }
