"""From buildings placed by hand or by another program to the solution of a site."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence

import numpy as np

from scenewright.catalog.loading import catalog_of
from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.layout import Layouts, NamedBox, check_layouts
from scenewright.core.plan import Plan
from scenewright.core.solution import Solution
from scenewright.domains.site.holdings import BuildingDemand
from scenewright.domains.site.plan import plan_sites
from scenewright.domains.site.presets import PRESETS
from scenewright.domains.site.problem import Flags, Floats
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.solving import assemble_solution, build_site_problem, furnish_site
from scenewright.engine.solve import Found

FITS = 0.01
"""Metres by which a box may differ from the building it is of."""


def solution_of(
    brief: Brief, layouts: Layouts, *, plan: Plan | None = None, seed: int = 0
) -> Solution:
    """The solution whose buildings stand on the boxes given, by the name or model of each; trees
    and lamps are added by ``seed``. What has no box is left out."""
    started = time.perf_counter()
    made = plan or plan_sites(brief)
    check_layouts(layouts, [space.id for space in made.spaces])
    catalog, built = catalog_of(brief.catalogs), []
    for k, (site, ground) in enumerate(zip(brief.part.sites, made.detail, strict=True)):
        rows, problem = build_site_problem(
            site, ground, f"sites[{k}]", catalog, PRESETS["default"], None, bool(site.library)
        )
        boxes, present = match_boxes(rows, layouts.get(ground.id, ()), ground.id)
        found = Found((SiteLayout(boxes, present, {}),), 0)
        built.append(furnish_site(site, ground, rows, problem, found, catalog, seed + 7919 * k))
    return assemble_solution(brief, built, "default", "given", seed, time.perf_counter() - started)


def match_boxes(
    rows: list[BuildingDemand], given: Sequence[NamedBox], site: str
) -> tuple[Floats, Flags]:
    """Boxes (n, 5) of buildings and which have one (n,); InputError for a box no building fits."""
    boxes, present = np.zeros((len(rows), 5)), np.zeros(len(rows), np.bool_)
    free: dict[str, list[int]] = {}
    for number, row in enumerate(rows):
        for name in {row.name, row.asset.id}:
            free.setdefault(name, []).append(number)
    for k, one in enumerate(given):
        place = f"{site}[{k}] '{one.name}'"
        if one.name not in free:
            known = ", ".join(sorted({row.name for row in rows}))
            raise InputError("is not a building of the site", f"use one of: {known}", place=place)
        left = [n for n in free[one.name] if not present[n]]
        if not left:
            raise InputError("is one more than the site asks for", "raise its count", place=place)
        best = min(left, key=lambda n: math.dist(rows[n].size[:2], one.box[3:]))
        size = rows[best].size
        if max(abs(size.width - one.box[3]), abs(size.depth - one.box[4])) > FITS:
            raise InputError(
                f"is {one.box[3]:g} x {one.box[4]:g} m, the building {size.width:g} x "
                f"{size.depth:g} m",
                "give the box the building's size",
                place=place,
            )
        boxes[best], present[best] = one.box, True
    return boxes, present
