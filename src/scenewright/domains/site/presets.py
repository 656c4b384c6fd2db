"""Presets of sites: named sets of solver parameters."""

from __future__ import annotations

from scenewright.domains.site.settings import MatrixSettings, SiteSettings
from scenewright.domains.site.terms.table import SITE_TERMS
from scenewright.engine.rows import Preset

SitePreset = Preset[SiteSettings]
"""Its steps are layouts looked at, of each block by the default solver; terms and aims whose weight
it does not state have their default weight."""

OURS = SiteSettings()
PRINTED = MatrixSettings(population=10, generations=200, crossover=0.75, mutation=0.04)
"""Sizes and chances of Zhang, Yang 2023, IV-A."""
AIMLESS = {"seen": 0.0, "sun": 0.0, "even": 0.0}

PRESETS: dict[str, SitePreset] = {
    "default": Preset("blocks filled row by row, eight layouts of each", "fill", 8, {}, OURS),
    "quick": Preset("two layouts of each block", "fill", 2, {}, OURS),
    "fine": Preset("forty layouts of each block", "fill", 40, {}, OURS),
    "plain": Preset("the default without aims: what fits, and no more", "fill", 8, AIMLESS, OURS),
    "paper": Preset(
        "Zhang, Yang 2023 as printed, without the person: 10 layouts, at most 200 "
        "generations, local search after (12)",
        "vp",
        2000,
        {row.name: 0.0 for row in SITE_TERMS if row.data},
        SiteSettings("printed", "printed", matrix=PRINTED),
    ),
    "paper-repaired": Preset(
        "the same with position costs, operators that lose no building and what walkers see",
        "vp",
        2000,
        {row.name: 0.0 for row in SITE_TERMS if row.data},
        OURS,
    ),
}
