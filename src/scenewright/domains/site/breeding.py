"""Sites bred block by block: a genome says how each is filled and what ground is kept open."""

from __future__ import annotations

import math
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from functools import cache, partial
from typing import NamedTuple
from zlib import crc32

import numpy as np
import shapely

from scenewright.catalog.loading import catalog_of
from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Site
from scenewright.domains.site.features import DEVELOPED, measure_features
from scenewright.domains.site.furnish import buildings, landmarks
from scenewright.domains.site.given import fixed_buildings
from scenewright.domains.site.holdings import BuildingDemand
from scenewright.domains.site.plan import plan_sites
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.reasons import reasons
from scenewright.domains.site.solvers.blocks.block import FORMS
from scenewright.domains.site.solvers.blocks.schemes import QUEUES
from scenewright.domains.site.solvers.chosen import (
    AXES,
    GAPS,
    ORDERS,
    BlockChoice,
    Fill,
    SiteChoice,
    fill_chosen,
    remember_fillings,
)
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.solving import Built, assemble_solution, build_site_problem, solve
from scenewright.domains.site.variants import Variant
from scenewright.ground.works import GroundWorks

SETBACKS = (1.0, 1.5, 2.5)
"""Times the least distances to streets and borders."""
SPOTS = ((0.0, 0.0), (-0.25, 0.0), (0.25, 0.0), (0.0, -0.25), (0.0, 0.25))
"""Where ground may be kept open, in widths and depths of the site off its middle."""
OPEN = 0.14
"""Radius of the open ground, as a share of the root of the site's area."""
MOST_BLOCKS = 8
"""Blocks that have genes of their own; all further ones share the last."""
EACH, UNSEEN = 16, 60
"""Candidates of a later sheet, and of how many only the buildings are placed to choose them."""
TRIED = 3
"""Layouts of each block that are tried where what a genome says leaves out buildings."""


class SiteVariation(NamedTuple):
    """How a site is varied: how its blocks are filled, times the least distances to streets, and
    where ground is kept open (0: nowhere)."""

    choice: SiteChoice
    back: float = 1.0
    spot: int = 0


class PreparedGround(NamedTuple):
    """The ground of a variation, made ready to be filled: brief and plan, and of each site what
    is to stand, with its problem and a filling that remembers."""

    brief: Brief
    plan: Plan
    sites: tuple[tuple[list[BuildingDemand], SiteProblem, Fill], ...]


Ready = Callable[[float, int], PreparedGround]


def make_breeder(brief: Brief, plan: Plan, seed: int = 0) -> Breeder:
    """Genes of a site: for each block its planar form (0: the usual one), the way its fronts
    look, the order its buildings are placed in and how wide gaps may be; for the whole by how
    much distances to streets exceed the least, where ground is kept open, in which order models
    are taken and which block comes first."""
    blocks = max((len(ground.blocks) for ground in plan.detail), default=1)
    own = min(max(blocks, 1), MOST_BLOCKS)
    parts = {"form": 1 + len(FORMS), "axis": AXES, "order": len(QUEUES), "gaps": len(GAPS)}
    genes = (
        *(Gene(f"{part} {k + 1}", count) for k in range(own) for part, count in parts.items()),
        Gene("setbacks", len(SETBACKS)),
        Gene("open space", 1 + len(SPOTS)),
        Gene("models", ORDERS),
        Gene("first block", own),
    )

    ready = prepare_grounds(brief, plan)
    return Breeder(
        genes, partial(_develop, ready, seed), partial(_measure, ready), (), EACH, UNSEEN
    )


def prepare_grounds(brief: Brief, plan: Plan) -> Ready:
    """The grounds of a brief's variations, each made ready when it is first asked for."""

    @cache
    def ready(back: float, spot: int) -> PreparedGround:
        return _prepare_ground(brief, plan, back, spot)

    return ready


def read_genome(genome: Genome) -> SiteVariation:
    """How a genome says that a site is to be varied."""
    *blocks, back, spot, ranks, first = genome
    chosen = [BlockChoice(*blocks[k : k + 4]) for k in range(0, len(blocks), 4)]
    return SiteVariation(SiteChoice(tuple(chosen), ranks, first), SETBACKS[back], spot)


def _develop(ready: Ready, seed: int, genome: Genome) -> Solution:
    """The brief solved as its genome says; with less and less of it where that leaves out
    buildings."""
    wish, asked = read_genome(genome), ready(1.0, 0)
    for back, spot in dict.fromkeys([(wish.back, wish.spot), (1.0, 0)]):
        with suppress(InputError):
            ground = ready(back, spot)
            variant = Variant(choice=wish.choice)
            found = solve(ground.brief, plan=ground.plan, seed=seed, threads=1, variant=variant)
            if not any(out.required for out in found.left_out):
                return replace(found, brief=asked.brief)
    chance = seed + crc32(bytes(genome)) % 1000
    return solve(asked.brief, plan=asked.plan, seed=chance, steps=TRIED, threads=1)


def _measure(ready: Ready, genome: Genome) -> tuple[dict[str, float], int]:
    """The features of what a genome develops into before ways and trees are laid out; if any
    building finds no place, none and how many do not."""
    asked, (found, lacking) = ready(1.0, 0), draft_site(ready, genome)
    if found is None:
        return {}, lacking
    features = measure_features(found, asked.plan)
    return features | dict.fromkeys(DEVELOPED, math.nan), 0


def draft_site(ready: Ready, genome: Genome) -> tuple[Solution | None, int]:
    """The layout a genome develops into, with buildings alone; none, and how many do not, if any
    building finds no place."""
    wish, asked = read_genome(genome), ready(1.0, 0)
    least = 0
    for back, spot in dict.fromkeys([(wish.back, wish.spot), (1.0, 0)]):
        with suppress(InputError):
            ground = ready(back, spot)
            found = [
                fill_chosen(problem, wish.choice, fill).layouts[0]
                for _, problem, fill in ground.sites
            ]
            least = sum(int((~one.present).sum()) for one in found)
            if not least:
                return _draft(asked, ground, found), 0
    return None, least


def _draft(asked: PreparedGround, ground: PreparedGround, found: list[SiteLayout]) -> Solution:
    """Filled sites as a solution, with buildings alone."""
    catalog, built = catalog_of(asked.brief.catalogs), []
    for plan, (rows, problem, _), layout in zip(
        ground.plan.detail, ground.sites, found, strict=True
    ):
        pieces = (
            *landmarks(plan, catalog),
            *fixed_buildings(plan),
            *buildings(plan, rows, layout.boxes, layout.present),
        )
        terms = reasons(problem, layout, plan.id)
        built.append(Built(plan.id, pieces, terms, (), 1, GroundWorks(plan.id)))
    return assemble_solution(asked.brief, built, "default", "fill", 0, 0.0)


def _prepare_ground(brief: Brief, plan: Plan, back: float, spot: int) -> PreparedGround:
    sites = [_vary_site(site, back, spot) for site in brief.part.sites]
    same = back == 1.0 and not spot
    part = brief.part.model_copy(update={"sites": sites})
    varied = brief if same else brief.model_copy(update={"part": part})
    ground, preset = plan if same else plan_sites(varied), PRESETS["default"]
    catalog = catalog_of(brief.catalogs)
    ready = [
        build_site_problem(site, one, f"sites[{number}]", catalog, preset, None)
        for number, (site, one) in enumerate(zip(sites, ground.detail, strict=True))
    ]
    filled = tuple((rows, problem, remember_fillings(problem)) for rows, problem in ready)
    return PreparedGround(varied, ground, filled)


def _vary_site(site: Site, back: float, spot: int) -> Site:
    update = {"setback": back * site.setback, "road_setback": back * site.road_setback}
    holes = [*site.holes, _open_ground(site, SPOTS[spot - 1])] if spot else site.holes
    return site.model_copy(update={**update, "holes": holes})


def _open_ground(site: Site, spot: tuple[float, float]) -> list[tuple[float, float]]:
    """A round hole in the ground at a spot."""
    floor = shapely.Polygon(site.outline)
    west, south, east, north = floor.bounds
    middle = floor.centroid
    x, y = middle.x + spot[0] * (east - west), middle.y + spot[1] * (north - south)
    ring = shapely.Point(x, y).buffer(OPEN * floor.area**0.5, quad_segs=4).exterior
    return [(float(px), float(py)) for px, py in np.asarray(ring.coords)[:-1]]
