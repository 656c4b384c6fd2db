"""What steers how homes are solved, beside the weights of terms; presets hold the values."""

from __future__ import annotations

from typing import NamedTuple


class ChainSettings(NamedTuple):
    """Annealing of patches: temperatures at the start and the end, in spreads of the energies of
    random layouts; ``agreed`` chains whose bests differ by no more than the share ``alike`` have
    found the same, and the run ends; ``seconds`` is the work without a budget."""

    hot: float = 0.07
    cold: float = 5e-6
    agreed: int = 3
    alike: float = 0.005
    seconds: float = 0.1


class HomeSettings(NamedTuple):
    """``printed`` takes the formulas as the paper prints them, ``paper`` its problem
    (:mod:`scenewright.domains.home.paper_problem`) instead of ours; ``exact`` checks every piece
    while furnishing; how ``chains`` anneal."""

    printed: bool = False
    paper: bool = False
    exact: bool = True
    chains: ChainSettings = ChainSettings()
