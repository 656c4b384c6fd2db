"""Presets of villages: named sets of what steers their filling."""

from __future__ import annotations

from scenewright.domains.village.settings import GrowSettings, VillageSettings
from scenewright.engine.rows import Preset

VillagePreset = Preset[VillageSettings]
"""Its steps are layouts grown of each block; the best is taken."""

COMPOSED = VillageSettings(composed=True)

PRESETS: dict[str, VillagePreset] = {
    "default": Preset("three layouts of each block", "grow", 3, {}, COMPOSED),
    "quick": Preset("one layout of each block", "grow", 1, {}, COMPOSED),
    "fine": Preset("twelve layouts of each block", "grow", 12, {}, COMPOSED),
    "paper": Preset(
        "the loop of Zhu, Jiang and Li (2022), its networks in their small form",
        "paper",
        1,
        {},
        VillageSettings(),
    ),
    "strict": Preset(
        "houses stand where most do: little is left to chance",
        "grow",
        3,
        {},
        COMPOSED._replace(grow=GrowSettings(temperature=0.4)),
    ),
}
