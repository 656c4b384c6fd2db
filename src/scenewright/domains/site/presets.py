"""Presets of sites: named sets of solver parameters."""

from __future__ import annotations

from typing import Literal, NamedTuple

from scenewright.catalog.appearance import Measure


class SitePreset(NamedTuple):
    """What it is, the solver, how many layouts (of each block, by the default solver) are looked
    at, weights by name of the term or aim, the measure of visual quality (our ``relief`` or as
    ``printed``), and the form of the paper's measures."""

    doc: str
    solver: str
    steps: int
    weights: dict[str, float]
    measure: Measure = "relief"
    form: Literal["printed", "repaired"] = "repaired"


PRESETS: dict[str, SitePreset] = {
    "default": SitePreset("blocks filled row by row, eight layouts of each", "fill", 8, {}),
    "quick": SitePreset("two layouts of each block", "fill", 2, {}),
    "fine": SitePreset("forty layouts of each block", "fill", 40, {}),
    "plain": SitePreset(
        "the default without aims: what fits, and no more",
        "fill",
        8,
        {"seen": 0.0, "sun": 0.0, "even": 0.0},
    ),
    "paper": SitePreset(
        "Zhang, Yang 2023 as printed, without the person: 10 layouts, at most 200 "
        "generations, ended by (12)",
        "vp",
        2000,
        {},
        "printed",
        "printed",
    ),
    "paper-repaired": SitePreset(
        "the same with position costs, local search after (12) and our measure of visual quality",
        "vp",
        2000,
        {},
    ),
}
