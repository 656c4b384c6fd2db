"""Figures of schemes of sites, in the words of a planner."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.report import Report
from scenewright.core.solution import Solution


def scheme_row(figures: Mapping[str, Any]) -> dict[str, Any]:
    """The figures of one site in the words of a planner; none of what is no scheme.

    >>> scheme_row({"coverage": 0.2})
    {}
    """
    if "dwellings" not in figures:
        return {}
    bays, green = figures["bays_per_dwelling"], figures["green_per_person"]
    sun = figures["sun_mean"]
    return {
        "floor m²": f"{figures['floor_area']:.0f}",
        "coverage": f"{figures['coverage']:.0%}",
        "FAR": f"{figures['floor_area_ratio']:.2f}",
        "dwellings": figures["dwellings"],
        "bays each": "-" if bays is None else f"{bays:.2f}",
        "green m²/person": "-" if green is None else f"{green:.0f}",
        "trees": figures["trees"],
        "sun h": "-" if sun is None else f"{sun:.1f}",
    }


def find_schemes(
    solution: Solution, plan: Plan, report: Report | None = None
) -> dict[str, dict[str, Any]]:
    """The figures of the schemes of a solution, with those of the referee (asked for his ``report``
    unless given); none of kinds of scene that have no schemes."""
    from scenewright.domains import check

    domain = domain_of(solution.brief.domain)
    if not domain.has("schemes"):
        return {}
    judged = (report or check(solution, plan=plan)).figures["sites"]
    found = domain.verb("schemes")(solution, plan)
    return {name: judged.get(name, {}) | row for name, row in found.items()}
