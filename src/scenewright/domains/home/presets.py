"""Presets: named sets of weights and solver parameters for homes."""

from __future__ import annotations

from dataclasses import dataclass

from scenewright.core.errors import InputError


@dataclass(frozen=True, slots=True)
class Preset:
    """``weights`` by term name; ``printed`` takes the formulas as the paper prints them;
    ``exact`` checks every piece while dressing; ``steps`` is the work for one item of a room
    (``None``: what the solver does of itself, as the paper's 100 generations)."""

    doc: str
    weights: dict[str, float]
    solver: str = "anneal"
    printed: bool = False
    exact: bool = True
    steps: int | None = 12_000


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
    "places": 110.0,
}

PRESETS: dict[str, Preset] = {
    "default": Preset("our terms in repaired form, every piece checked", HOME),
    "quick": Preset("the default with a third of the work", HOME, steps=4_000),
    "fine": Preset("the default with eight times the work", HOME, steps=96_000),
    "paper": Preset(
        "Liu, Jiang, Mao, Wang 2017 as printed: seven costs, 40 x 100 GA, nearest case",
        PAPER,
        solver="paper-ga",
        printed=True,
        exact=False,
        steps=None,
    ),
    "paper-repaired": Preset("the paper's seven costs, repaired, by our solver", PAPER),
}


def preset_named(name: str) -> Preset:
    """The preset of a name; raises :class:`InputError` if there is none."""
    if name not in PRESETS:
        raise InputError(f"unknown preset '{name}'", "one of " + ", ".join(PRESETS))
    return PRESETS[name]
