"""What steers how sites are solved, beside the weights of terms; presets hold the values."""

from __future__ import annotations

import math
from typing import Literal, NamedTuple

from scenewright.catalog.appearance import Measure


class FillSettings(NamedTuple):
    """Filling block by block: layouts of each without a budget; how many times the least the gaps
    may be, filling by filling; how much chance has a say among forms about as good; what half a
    turn off the preferred heading costs, in shares of a block's buildings, and what a court that is
    to close and does not."""

    tried: int = 8
    loosest: tuple[float, ...] = (3.0, 1.5, 1.0, 1.0, 1.0)
    variety: float = 0.05
    askew: float = 0.5
    unclosed: float = 20.0


class ExchangeSettings(NamedTuple):
    """Improving: partners drawn for each building and exchanges tried for each; how far a front may
    turn off the preferred heading, in radians, or as far as it was before."""

    partners: int = 24
    tries: int = 2
    leeway: float = math.radians(30.0)


class ChainSettings(NamedTuple):
    """Annealing of boxes: temperatures, and moves a building without a budget."""

    hot: float = 10.0
    cold: float = 1e-3
    moves: int = 4000


class SiteVarietySettings(NamedTuple):
    """Other plans: candidates for each plan asked for, and more; what differing, being good and a
    building left out weigh."""

    tried: int = 2
    spare: int = 2
    different: float = 0.6
    good: float = 0.3
    lost: float = 0.05


class SiteSettings(NamedTuple):
    """The measure of visual quality (our ``relief`` or as ``printed``), the form of the paper's
    measures, and how blocks are filled, buildings exchanged, boxes annealed and plans chosen."""

    measure: Measure = "relief"
    form: Literal["printed", "repaired"] = "repaired"
    fill: FillSettings = FillSettings()
    exchange: ExchangeSettings = ExchangeSettings()
    chain: ChainSettings = ChainSettings()
    variety: SiteVarietySettings = SiteVarietySettings()
