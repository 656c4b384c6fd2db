"""Presets of halls: named sets of weights and solver parameters."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.domains.hall.terms.table import HALL_TERMS, PRINTED


class HallPreset(NamedTuple):
    """What it is, weights by name of the term, the solver, how many layouts are looked at (more
    in halls of more than :data:`USUAL` groups), and whether groups stay whole."""

    doc: str
    weights: dict[str, float]
    solver: str
    steps: int
    whole: bool = False


USUAL = 20
"""Groups of a hall for which the steps of a preset are meant."""

OURS = {row.name: row.weight for row in HALL_TERMS}
PAPER = dict.fromkeys(PRINTED, 1.0)

PRESETS: dict[str, HallPreset] = {
    "default": HallPreset("our seven terms, four chains annealed", OURS, "anneal", 24_000),
    "quick": HallPreset("the default with a quarter of the work", OURS, "anneal", 6_000),
    "fine": HallPreset("the default with eight times the work", OURS, "anneal", 192_000),
    "paper": HallPreset(
        "Cao, Cheng, Zhang 2024: four energies, 1000 iterations, groups whole",
        PAPER,
        "gd-mh",
        1000,
        True,
    ),
}
