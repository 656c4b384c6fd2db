"""Presets of extensions: named sets of what steers their filling."""

from __future__ import annotations

from scenewright.domains.extend.rating import WEIGHTS
from scenewright.domains.extend.settings import GrowthSettings
from scenewright.engine.rows import Preset

ExtendPreset = Preset[GrowthSettings]
"""Its steps are layouts grown of each area; the best is taken."""

PRESETS: dict[str, ExtendPreset] = {
    "default": Preset("four layouts of each area", "grow", 4, WEIGHTS, GrowthSettings()),
    "quick": Preset(
        "one layout of each area, not annealed", "grow", 1, WEIGHTS, GrowthSettings(polish=0)
    ),
    "fine": Preset(
        "twelve layouts of each area, annealed for longer",
        "grow",
        12,
        WEIGHTS,
        GrowthSettings(polish=200),
    ),
    "paper": Preset(
        "Zhang and Fei (2017) as printed: 300 ants x 20, then 8 x 30 bred, by F on a grid of plots",
        "colony",
        None,
        WEIGHTS,
        GrowthSettings(polish=0),
    ),
    "paper-repaired": Preset(
        "the same where the print cannot work: elite deposit, evaporation, allele values",
        "colony-repaired",
        None,
        WEIGHTS,
        GrowthSettings(polish=0),
    ),
    "grammar": Preset(
        "the sources' grammar unfolded: rows by their folded strings, the layout repeated across",
        "grammar",
        1,
        WEIGHTS,
        GrowthSettings(polish=0),
    ),
    "strict": Preset(
        "buildings stand only where neighbours of the source would: ground may stay free",
        "grow",
        4,
        WEIGHTS,
        GrowthSettings(spread=1.2, missing=0.5, noise=0.05, polish=0, relaxed=False, edges=False),
    ),
}
