"""Presets: named sets of weights and solver parameters for homes."""

from __future__ import annotations

from scenewright.domains.home.settings import HomeSettings
from scenewright.engine.rows import Preset

HomePreset = Preset[HomeSettings]
"""Its steps are those for one item of a room."""

PAPER = {
    "boundary": 5000.0,
    "overlap": 600.0,
    "keep_free": 600.0,
    "corridors": 600.0,
    "main_wall": 1500.0,
    "against_wall": 1000.0,
    "pairs": 110.0,
    "size": 50.0,
}

HOME = {
    "boundary": 8000.0,
    "overlap": 6000.0,
    "keep_free": 6000.0,
    "obstacles": 6000.0,
    "window": 4000.0,
    "slope": 4000.0,
    "corridors": 150.0,
    "against_wall": 1000.0,
    "alignment": 400.0,
    "main_wall": 70.0,
    "clear_room": 900.0,
    "clear_items": 900.0,
    "pairs": 110.0,
    "daylight": 30.0,
    "nestle": 40.0,
    "wish": 200.0,
    "route": 900.0,
    "balance": 60.0,
    "bed_symmetry": 60.0,
    "places": 110.0,
    "daylight_kept": 40.0,
    "openings_kept": 60.0,
}

OURS = HomeSettings()
PRESETS: dict[str, HomePreset] = {
    "default": Preset(
        "our terms in repaired form, every piece checked", "anneal", 6_000, HOME, OURS
    ),
    "quick": Preset("the default with some half of the work", "anneal", 4_000, HOME, OURS),
    "fine": Preset("the default with fourteen times the work", "anneal", 96_000, HOME, OURS),
    "paper": Preset(
        "Liu, Jiang, Mao, Wang 2017 as printed: seven costs, 40 x 100 GA, nearest case",
        "paper-ga",
        None,
        PAPER,
        HomeSettings(printed=True, paper=True, exact=False),
    ),
    "paper-repaired": Preset(
        "the same with C4, C5 and C6 repaired, and nothing else",
        "paper-ga",
        None,
        PAPER,
        HomeSettings(paper=True, exact=False),
    ),
}
