"""Presets of halls: named sets of weights and solver parameters."""

from __future__ import annotations

from scenewright.domains.hall.settings import HallSettings
from scenewright.domains.hall.terms.table import HALL_TERMS, PRINTED
from scenewright.engine.rows import Preset

HallPreset = Preset[HallSettings]
"""Its steps are layouts looked at in a hall of :data:`USUAL` groups, more where there are more."""

USUAL = 20
"""Groups of a hall for which the steps of a preset are meant."""

OURS = {row.name: row.weight for row in HALL_TERMS}
PAPER = dict.fromkeys(PRINTED, 1.0)
USUALLY = HallSettings()

PRESETS: dict[str, HallPreset] = {
    "default": Preset("our nine terms, four chains annealed", "anneal", 24_000, OURS, USUALLY),
    "quick": Preset("the default with a quarter of the work", "anneal", 6_000, OURS, USUALLY),
    "fine": Preset("the default with eight times the work", "anneal", 192_000, OURS, USUALLY),
    "paper": Preset(
        "Cao, Cheng, Zhang 2024 as printed: four energies, 1000 iterations, groups whole",
        "gd-mh",
        1000,
        PAPER,
        HallSettings(whole=True, printed=True),
    ),
    "paper-repaired": Preset(
        "the same with the divisor of eq. 1 and the extents of eq. 3 repaired",
        "gd-mh",
        1000,
        PAPER,
        HallSettings(whole=True),
    ),
}
