"""The referee of sites."""

from __future__ import annotations

from scenewright.check.rooms import count_findings
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.domains.site.check.figures import judge_sites
from scenewright.domains.site.check.notes import find_far_streets, find_small


def check(solution: Solution, plan: Plan, kinds: Catalog) -> Report:
    """Judge the buildings of every site; see :func:`scenewright.domains.check`. Buildings have
    no ``kinds``."""
    del kinds
    sites = solution.brief.part.sites
    findings, by_site = judge_sites(sites, solution.pieces, plan.detail, solution.detail or ())
    figures = {**count_findings(solution.pieces, findings), "sites": by_site}
    notes = (*find_small(sites, plan.detail), *find_far_streets(sites, plan.detail))
    return Report(tuple(findings), notes, figures)
