"""Why an area is as it is: the terms of the layout, and figures for information."""

from __future__ import annotations

from collections import Counter

from scenewright.core.plan import Plan
from scenewright.core.solution import Solution, TermValue
from scenewright.domains.extend.features import is_new
from scenewright.domains.extend.plan import plan_extend
from scenewright.domains.extend.problem import ExtendProblem, GrownLayout
from scenewright.domains.extend.rating import MEANINGS as RATED
from scenewright.domains.extend.rating import WEIGHTS, measure_layout
from scenewright.text import quantity

FIGURES: dict[str, str] = {
    "rows": "share of the new buildings that continue a row of the source or of the brief",
    "neighbours": "share of the new buildings that stand where a neighbour of the source would",
    "edges": "share of the new buildings laid along streets and borders as in the source",
    "patches": "share of the new buildings laid as part of a whole patch of the source",
    "filled": "share of the new buildings that fill free ground in line with the nearest",
}
MEANINGS: dict[str, str] = {**RATED, **FIGURES}
WAYS = {
    "rows": ("continued", "row", "unfolded"),
    "neighbours": ("neighbour",),
    "edges": ("edge",),
    "patches": ("patch",),
    "filled": ("filled",),
}


def reasons(problem: ExtendProblem, layout: GrownLayout) -> tuple[TermValue, ...]:
    """What is said of an area: the terms, whose costs add up to its energy, then figures."""
    values = layout.score or measure_layout(problem, layout)
    rows = [
        TermValue(problem.name, "", n, values[n], WEIGHTS[n], WEIGHTS[n] * max(values[n], 0.0))
        for n in RATED
    ]
    counts = Counter(layout.how)
    total = max(len(layout.how), 1)
    for name, ways in WAYS.items():
        share = sum(counts[way] for way in ways) / total
        rows.append(TermValue(problem.name, "", name, share, 0.0, 0.0))
    return tuple(rows)


def describe_extension(solution: Solution, plan: Plan | None = None) -> str:
    """How the new buildings of each area came to stand, the two main ways: ``New edge: 20
    buildings, 40 % in patches, 30 % in rows``."""
    counts = Counter(piece.space for piece in solution.pieces if is_new(piece))
    words = []
    for area in (plan or plan_extend(solution.brief)).detail.areas:
        mine = [(t.value, t.term) for t in solution.terms if t.space == area.id and t.term in WAYS]
        main = sorted((row for row in mine if row[0] > 0), key=lambda row: -row[0])[:2]
        parts = [quantity(counts[area.id], "building")]
        parts += [f"{share:.0%} {_NAMED[name]}" for share, name in main]
        words.append(f"{area.name}: {', '.join(parts)}")
    return "; ".join(words)


_NAMED = {
    "rows": "in rows",
    "neighbours": "beside neighbours",
    "edges": "along edges",
    "patches": "in patches",
    "filled": "filling in",
}
