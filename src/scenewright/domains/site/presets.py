"""Presets of sites: named sets of solver parameters."""

from __future__ import annotations

from typing import NamedTuple

from scenewright.appearance import Measure


class SitePreset(NamedTuple):
    """What it is, the solver, how many layouts (of each block, by the default solver) are looked
    at, weights by name of the term or aim, and the measure of visual quality: our ``relief`` or as
    ``printed``."""

    doc: str
    solver: str
    steps: int
    weights: dict[str, float]
    measure: Measure = "relief"


PRESETS: dict[str, SitePreset] = {
    "default": SitePreset("blocks filled row by row, six layouts of each", "fill", 6, {}),
    "quick": SitePreset("two layouts of each block", "fill", 2, {}),
    "fine": SitePreset("forty layouts of each block", "fill", 40, {}),
}  # fmt: skip
