"""Why a site is as good as it is: every term and aim with its weight, and the paper's figures."""

from __future__ import annotations

from math import isfinite

from scenewright.core.solution import TermValue
from scenewright.domains.site.problem import SiteProblem
from scenewright.domains.site.solvers.answer import score
from scenewright.domains.site.solvers.blocks.distances import noon
from scenewright.domains.site.solvers.outcome import SiteLayout
from scenewright.domains.site.terms.table import (
    MUCH,
    QUALITY,
    SITE_AIMS,
    SITE_FIGURES,
    SITE_TERMS,
    read_site_aims,
    read_site_weights,
)
from scenewright.geometry.sun import open_hours, sun_path


def reasons(problem: SiteProblem, found: SiteLayout, site: str) -> tuple[TermValue, ...]:
    """The terms of a site as built, whose costs add up to its energy, then figures of weight 0."""
    known = found.score or score(problem, found.boxes, found.present)
    known = known | {"generations": float(found.generations)}
    weights, count = read_site_weights(problem.weights), len(problem.buildings.sizes)
    rows = []
    for row in SITE_TERMS:
        value, weight = known[row.name], float(weights[row.number])
        lacks = count - value if row.number == QUALITY else value
        rows.append(TermValue(site, "", row.name, value, weight, weight * lacks))
    best = float(open_hours([noon(problem)], sun_path(problem.latitude, problem.day))[0, 0])
    lacking = {
        "seen": 1.0 - known["seen"] / MUCH,
        "sun": 1.0 - known["sun"] / max(best, 1e-9),
        "even": known["even"],
    }
    for aim, weight in zip(SITE_AIMS, read_site_aims(problem.weights).tolist(), strict=True):
        cost = weight * max(lacking[aim.name], 0.0)
        rows.append(TermValue(site, "", aim.name, known[aim.name], weight, cost))
    figures = {name: known[name] for name in SITE_FIGURES if isfinite(known[name])}  # of none: inf
    rows += [TermValue(site, "", name, value, 0.0, 0.0) for name, value in figures.items()]
    return tuple(rows)
