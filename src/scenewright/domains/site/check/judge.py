"""The referee of sites."""

from __future__ import annotations

from scenewright.check.owed import find_owed
from scenewright.check.rooms import count_findings
from scenewright.core.catalog import Catalog
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.solution import Solution
from scenewright.domains.site.check.demands import find_unstated, list_owed
from scenewright.domains.site.check.figures import judge_sites
from scenewright.domains.site.check.notes import find_far_streets, find_small


def check(solution: Solution, plan: Plan, kinds: Catalog, figures: bool = True) -> Report:
    """Judge the buildings of every site; see :func:`scenewright.domains.check`. ``kinds``
    are the models of buildings."""
    sites, works = solution.brief.part.sites, solution.detail or ()
    judged, by_site = judge_sites(sites, solution.pieces, plan.detail, works, figures)
    owed = find_owed([*list_owed(sites, plan.detail, solution.pieces, kinds)], solution.left_out)
    findings = (*judged, *owed, *find_unstated(plan.detail, works))
    told = {**count_findings(solution.pieces, findings), "sites": by_site}
    notes = (*find_small(sites, plan.detail), *find_far_streets(sites, plan.detail))
    return Report(findings, notes, told)


def check_rules(solution: Solution, plan: Plan, kinds: Catalog) -> Report:
    """The same without figures of the sites: hours of sun take half of it."""
    return check(solution, plan, kinds, figures=False)
