"""Local templates: small groups of buildings in a box, by form, put right by annealing.

Zhang, Yang 2023 anneal groups of buildings in a bounding box under (4)-(6). Here a form gives the
start, and only what it leaves out or sets wrongly is looked for by annealing, so that rows stay
rows.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.core.errors import InputError
from scenewright.domains.site.encodings.forms import FORMS, FRONT, Target
from scenewright.domains.site.problem import Buildings, Flags, SiteGround, SiteProblem
from scenewright.domains.site.settings import SiteSettings
from scenewright.domains.site.solvers.anneal import anneal_from
from scenewright.domains.site.solvers.answer import make_measure, score, standing
from scenewright.domains.site.terms.table import fitness_of_cost, utilisation
from scenewright.engine.solve import Budget, BudgetWatch
from scenewright.geometry.boxes import Floats

AS_USUAL = SiteSettings()
STEPS = 20_000
"""Moves of annealing a single template."""


class Template(NamedTuple):
    """Boxes (k, 5) about the middle of the target, which of them stand (k,), and what they score:
    every term, Fit of (1) over the greatest height as ``fit`` and f_cost of (6)."""

    boxes: Floats
    present: Flags
    score: dict[str, float]


def rectangle_problem(
    buildings: Buildings,
    target: Target,
    spacing: float,
    fire_access: float,
    settings: SiteSettings = AS_USUAL,
) -> SiteProblem:
    """A site that is one rectangular block about the origin; fronts may look anywhere."""
    w, d = 0.5 * target[0], 0.5 * target[1]
    corners = np.array([[-w, -d], [w, -d], [w, d], [-w, d]])
    edges = np.hstack([corners, np.roll(corners, -1, 0)])
    more = np.array([-1.0, -1.0, 1.0, 1.0]) * max(fire_access, spacing)
    wide = edges * (1.0 + np.array([more[2] / w, more[2] / d] * 2))
    none = np.zeros((0, 5))
    ground = SiteGround(
        wide,
        edges,
        np.array([[0, 4]]),
        np.array([4.0 * w * d]),
        none,
        none,
        np.zeros(0),
        np.zeros(0),
        np.zeros((0, 2)),
        np.array([-w, -d, w, d]) + more,
        4.0 * w * d,
    )
    return SiteProblem(
        ground,
        buildings,
        ("",) * len(buildings.sizes),
        {"facing": 0.0},
        spacing,
        0.0,
        FRONT,
        fire_access,
        0.0,
        1,
        settings=settings,
    )


def make_template(
    form: str,
    buildings: Buildings,
    target: Target,
    spacing: float,
    fire_access: float = 4.0,
    behind: float = 0.0,
    seed: int = 0,
    steps: int = STEPS,
    settings: SiteSettings = AS_USUAL,
) -> Template:
    """A group of buildings laid out by a form in a rectangle, annealed if the form leaves some
    out; see :mod:`scenewright.domains.site.encodings.forms`."""
    if form not in FORMS:
        raise InputError(f"no form is called {form!r}", f"the forms are {', '.join(FORMS)}")
    problem = rectangle_problem(buildings, target, spacing, fire_access, settings)
    chain = settings.chain
    boxes = FORMS[form].place(buildings.sizes, spacing, target, behind)
    present = standing(make_measure(problem), boxes)
    if not present.all() and steps > 0:
        budget = Budget(steps=steps)
        watch, lines = BudgetWatch(budget, None, None), np.array([FRONT, 0.0])
        start = np.where(present[:, None], boxes, 0.0)
        tried, _ = anneal_from(problem, start, budget, seed, watch, lines, chain.cool)
        stands = standing(make_measure(problem), tried)
        if stands.sum() > present.sum():
            boxes, present = tried, stands
    found = score(problem, boxes, present)
    sizes = buildings.sizes[present]
    tall = float(sizes[:, 2].max(initial=1e-9))
    found["fit"] = utilisation(sizes, (spacing, spacing), (*target, tall))
    found["fitness"] = float(fitness_of_cost(np.array(found["ratio"]), chain.most))
    return Template(np.where(present[:, None], boxes, 0.0), present, found)
