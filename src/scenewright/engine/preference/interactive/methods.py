"""The table of interactive genetic algorithms. A new one is one row; the rows drive the tests.

What tells them apart: how parents are drawn, whether the best is kept, whom the person is asked of,
how the others are estimated, and whether a network may rate in her place.
"""

from __future__ import annotations

from typing import Literal, NamedTuple

from scenewright.core.errors import InputError
from scenewright.engine.preference.interactive.estimates import (
    Estimate,
    estimate_by_alleles,
    estimate_by_elites,
)

Measure = Literal["", "ratings", "genes"]


class InteractiveMethod(NamedTuple):
    """One method: its name, what it is and whose; whether the first layouts are ``led`` by visual
    quality; parents by ``tournament`` or roulette; ``points`` of the crossover (of strings; blocks
    of plots are swapped whole); whether the best stays (``keep``); how many of a generation are
    ``asked`` of (0: all) and how the others are estimated; whether mutation goes by what alleles
    are ``worth``, whether a ``network`` may take over, by what (``alike``) it is seen that the
    global search has ended (empty: never), and how many generations the network rates ``alone`` at
    most before the person is asked again (the paper's second stage goes on to the end)."""

    name: str
    doc: str
    source: str
    led: bool = False
    tournament: bool = False
    points: int = 2
    keep: bool = True
    asked: int = 0
    estimate: Estimate | None = None
    worth: bool = False
    network: bool = False
    alike: Measure = ""
    alone: int = 10


ROWS = (
    InteractiveMethod(
        "vp",
        "five of ten rated, the others from preferences of alleles (7) or local models (21); an "
        "ART1 network takes over in two stages; local search after (12)",
        "Zhang, Yang 2023",
        led=True,
        tournament=True,
        asked=5,
        estimate=estimate_by_alleles,
        network=True,
        alike="ratings",
    ),
    InteractiveMethod(
        "tiga", "traditional interactive: every new layout is rated, the best stays", "its TIGA"
    ),
    InteractiveMethod(
        "ciga",
        "matrix blocks; half rated, the others from the elites' alleles (21), (23), by which genes "
        "mutate; the best replaces the worst; local search once genes hardly differ",
        "Zhang, Fei 2017",
        led=True,
        tournament=True,
        asked=4,
        estimate=estimate_by_elites,
        worth=True,
        alike="genes",
    ),
    InteractiveMethod(
        "siga",
        "simple interactive: every new layout is rated, one point, the best stays",
        "its SIGA",
        points=1,
    ),
    InteractiveMethod(
        "sga",
        "simple genetic algorithm, rated: one point, nobody stays",
        "Goldberg 1989",
        points=1,
        keep=False,
    ),
)
INTERACTIVE_METHODS = {row.name: row for row in ROWS}


def method_named(name: str) -> InteractiveMethod:
    """The method of a name; :class:`InputError` if there is none.

    >>> method_named("vp").asked
    5
    """
    if name not in INTERACTIVE_METHODS:
        known = ", ".join(INTERACTIVE_METHODS)
        raise InputError(f"unknown method '{name[:40]}'", f"use one of: {known}")
    return INTERACTIVE_METHODS[name]
