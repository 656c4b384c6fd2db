"""Figures of schemes of sites, blocks and areas, in the words of a planner."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from scenewright.core.brief.uses import USES, use_words
from scenewright.core.plan import Plan
from scenewright.core.registry import domain_of
from scenewright.core.report import Report
from scenewright.core.solution import Solution


def scheme_row(figures: Mapping[str, Any]) -> dict[str, Any]:
    """The figures of one site in the words of a planner; none of what is no scheme.

    >>> scheme_row({"coverage": 0.2})
    {}
    """
    if "buildings_by_use" in figures:
        return _use_row(figures)
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


def _use_row(figures: Mapping[str, Any]) -> dict[str, Any]:
    """The figures of uses of a block or area, the uses that any has."""
    told = {use_words(use, 2): count for use, count in figures["buildings_by_use"].items()}
    return {
        "floor m²": f"{figures['floor_area']:.0f}",
        "coverage": f"{figures['coverage']:.0%}",
        "FAR": f"{figures['floor_area_ratio']:.2f}",
    } | {word: told.get(word, 0) for word in (use_words(use, 2) for use in USES)}


def add_schemes(rows: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
    """One row of the figures of several blocks or areas; nothing of several sites.

    >>> add_schemes([{"dwellings": 3}, {"dwellings": 4}])
    {}
    """
    if not rows or any("buildings_by_use" not in row for row in rows):
        return dict(rows[0]) if len(rows) == 1 else {}
    ground = sum(row["floor_area"] / max(row["floor_area_ratio"], 1e-9) for row in rows)
    floor = sum(row["floor_area"] for row in rows)
    covered = sum(
        row["coverage"] * row["floor_area"] / max(row["floor_area_ratio"], 1e-9) for row in rows
    )
    counts = {use: sum(row["buildings_by_use"].get(use, 0) for row in rows) for use in USES}
    return {
        "buildings_by_use": counts,
        "floor_area": floor,
        "floor_area_ratio": floor / max(ground, 1e-9),
        "coverage": covered / max(ground, 1e-9),
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
    judged = (report or check(solution, plan=plan)).figures[f"{domain.noun}s"]
    found = domain.verb("schemes")(solution, plan)
    return {name: judged.get(name, {}) | row for name, row in found.items()}
