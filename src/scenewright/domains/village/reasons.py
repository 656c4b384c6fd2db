"""Why a block is as it is: figures of the layout, those of weight 0 for information."""

from __future__ import annotations

import numpy as np

from scenewright.core.solution import TermValue
from scenewright.domains.village.measures import PARALLEL, coverage, excess_void, relations_of
from scenewright.domains.village.problem import VillageProblem
from scenewright.domains.village.standing import StandingHouses

MEANINGS: dict[str, str] = {
    "missing": "houses asked for without a place",
    "void": "how much wider the void is than in most real blocks, in plot widths",
    "gap": "median distance to the nearest house, in metres",
    "beside": "share of houses within 5 degrees of the nearest house",
    "along": "share of houses within 5 degrees of the nearest street side",
    "setback": "median distance to the street, in metres",
    "coverage": "share of the ground that houses cover",
}
WEIGHED = ("missing", "void")


def reasons(
    problem: VillageProblem, standing: StandingHouses, missing: int
) -> tuple[TermValue, ...]:
    """What is said of a block: the terms, whose costs add up to its energy, then figures."""
    count = len(standing.shapes)
    known = {"missing": float(missing), "void": 0.0, "coverage": 0.0}
    if count:
        found = relations_of(standing, problem.streets)
        known["void"] = excess_void(problem.floor, standing)
        known["setback"] = float(np.median(found.street))
        known["along"] = float((found.street_turn <= PARALLEL).mean())
        known["coverage"] = coverage(problem.floor, standing)
        if count > 1:
            known["gap"] = float(np.median(found.gap))
            known["beside"] = float((found.turn <= PARALLEL).mean())
    rows = []
    for name in (n for n in MEANINGS if n in known):
        weight = 1.0 if name in WEIGHED else 0.0
        rows.append(TermValue(problem.name, "", name, known[name], weight, weight * known[name]))
    return tuple(rows)
