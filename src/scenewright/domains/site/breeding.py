"""Sites bred by planar form, distances, open ground, order of the buildings and chance."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple, get_args

import numpy as np
import shapely

from scenewright.core.breeding import Breeder, Gene, Genome
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.site.brief import Building, FormName, Site
from scenewright.domains.site.plan import plan_sites
from scenewright.domains.site.solving import solve

FORMS: tuple[FormName, ...] = get_args(FormName)
LOOSE = (1.0, 1.15, 1.35, 1.7)
"""Times the least distance that buildings keep."""
SETBACKS = (1.0, 1.5, 2.5)
"""Times the least distances to streets and borders."""
SPOTS = ((0.0, 0.0), (-0.25, 0.0), (0.25, 0.0), (0.0, -0.25), (0.0, 0.25))
"""Where ground may be kept open, in widths and depths of the site off its middle."""
OPEN = 0.14
"""Radius of the open ground, as a share of the root of the site's area."""
ORDERS, SEEDS = 8, 8
MOST_ROWS = 8
"""Rows of buildings that choose a form of their own; all others share the last gene."""
TRIED = 3
"""Layouts of each block that are tried: chance is in the genes."""


class SiteVariation(NamedTuple):
    """How a site is varied: the form each row of buildings takes, in which order rows are placed,
    times the least distances of buildings and to streets, and where ground is kept open."""

    forms: tuple[int, ...]
    order: int = 0
    loose: float = 1.0
    back: float = 1.0
    spot: int = 0


def make_breeder(brief: Brief, plan: Plan, seed: int = 0) -> Breeder:
    """Genes of a site: the planar form each row of buildings takes (none: any that it may), by
    how much distances exceed the least, where ground is kept open, in which order rows are
    placed, and the seed."""
    rows = max((len(site.buildings) for site in brief.part.sites), default=0)
    forms = tuple(Gene(f"form {k + 1}", 1 + len(FORMS)) for k in range(min(rows, MOST_ROWS)))
    genes = (
        *forms,
        Gene("spacing", len(LOOSE)),
        Gene("setbacks", len(SETBACKS)),
        Gene("open space", 1 + len(SPOTS)),
        Gene("order", ORDERS),
        Gene("chance", SEEDS),
    )
    return Breeder(genes, partial(_develop, brief, plan, seed))


def _develop(brief: Brief, plan: Plan, seed: int, genome: Genome) -> Solution:
    """The brief solved as its genome says; where that leaves out buildings, less and less of it."""
    *forms, loose, back, spot, order, chance = genome
    wish = SiteVariation(tuple(forms), order, LOOSE[loose], SETBACKS[back], spot)
    least = wish._replace(loose=1.0, back=1.0)
    tried = list(dict.fromkeys([wish, least, least._replace(spot=0)]))
    for variation in tried[:-1]:
        with suppress(InputError):
            found = _solve(brief, seed + chance, variation, plan)
            if not any(out.required for out in found.left_out):
                return found
    return _solve(brief, seed + chance, tried[-1], plan)


def _solve(brief: Brief, seed: int, variation: SiteVariation, plan: Plan) -> Solution:
    sites = [_vary_site(site, variation) for site in brief.part.sites]
    part = brief.part.model_copy(update={"sites": sites})
    varied = brief.model_copy(update={"part": part})
    same = variation.back == 1.0 and not variation.spot and not variation.order
    ground = plan if same else plan_sites(varied)
    found = solve(varied, plan=ground, seed=seed, steps=TRIED, threads=1)
    return replace(found, brief=brief)


def _vary_site(site: Site, variation: SiteVariation) -> Site:
    last = len(variation.forms) - 1
    rows = [_vary_row(row, variation.forms[min(k, last)]) for k, row in enumerate(site.buildings)]
    if variation.order:
        places = np.random.default_rng(variation.order).permutation(len(rows)).tolist()
        rows = [rows[k] for k in places]
    update: dict[str, Any] = {
        "buildings": rows,
        "spacing": variation.loose * site.spacing,
        "setback": variation.back * site.setback,
        "road_setback": variation.back * site.road_setback,
    }
    if variation.spot:
        update["holes"] = [*site.holes, _open_ground(site, SPOTS[variation.spot - 1])]
    return site.model_copy(update=update)


def _open_ground(site: Site, spot: tuple[float, float]) -> list[tuple[float, float]]:
    """A round hole in the ground at a spot."""
    floor = shapely.Polygon(site.outline)
    west, south, east, north = floor.bounds
    middle = floor.centroid
    x, y = middle.x + spot[0] * (east - west), middle.y + spot[1] * (north - south)
    ring = shapely.Point(x, y).buffer(OPEN * floor.area**0.5, quad_segs=4).exterior
    return [(float(px), float(py)) for px, py in ring.coords[:-1]]


def _vary_row(row: Building, form: int) -> Building:
    """A row of buildings that takes one form, if it may."""
    name = FORMS[form - 1] if form else ""
    if not name or (row.forms and name not in row.forms):
        return row
    return row.model_copy(update={"forms": [name]})
