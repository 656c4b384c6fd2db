"""Presets of halls: named sets of weights and solver parameters."""

from __future__ import annotations

from scenewright.domains.hall.settings import HallSettings
from scenewright.domains.hall.terms.table import HALL_TERMS, PRINTED
from scenewright.engine.rows import Preset

HallPreset = Preset[HallSettings]
"""Its steps are layouts looked at in a hall of :data:`FEW` to :data:`USUAL` groups."""

USUAL = 20
"""Groups of a hall for which the steps of a preset are meant."""

FEW = 9
"""Halls of fewer groups take less: the work grows with what there is to place."""

OURS = {row.name: row.weight for row in HALL_TERMS}
PAPER = dict.fromkeys(PRINTED, 1.0)
REFUSING = 1e4
"""At λ = 0.1 a passage narrower by a centimetre is taken once in twenty thousand times."""
USUALLY = HallSettings()

PRESETS: dict[str, HallPreset] = {
    "default": Preset("all terms, four chains annealed", "anneal", 24_000, OURS, USUALLY),
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
        "the same with the extents of eq. 3 repaired",
        "gd-mh",
        1000,
        PAPER,
        HallSettings(whole=True),
    ),
    "paper-strict": Preset(
        "paper-repaired, where moves that break a rule of the referee are refused",
        "gd-mh",
        1000,
        {**PAPER, "access": REFUSING, "reach": REFUSING},
        HallSettings(whole=True),
    ),
}


def count_steps(preset: HallPreset, groups: int) -> int:
    """Layouts looked at in a hall of ``groups`` groups: fewer below :data:`FEW`, more above
    :data:`USUAL`; the paper's are the same for all.

    >>> [count_steps(PRESETS["default"], groups) for groups in (3, 9, 20, 40)]
    [8000, 24000, 24000, 48000]
    """
    if preset.settings.whole:
        return preset.steps or 0
    return int((preset.steps or 0) * max(min(groups / FEW, 1.0), groups / USUAL))
