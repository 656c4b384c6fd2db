"""What steers how halls are solved, beside the weights of terms; presets hold the values."""

from __future__ import annotations

from typing import NamedTuple


class ChainSettings(NamedTuple):
    """Annealing of patterns: how many chains, λ at the start (``low``) and the end (``high``) of
    the schedule, the share ``tepid`` of it that is left out where a good layout is improved, the
    share of moves that energies do not lead (``free``), and the seconds without a budget."""

    chains: int = 4
    low: float = 0.05
    high: float = 20.0
    tepid: float = 0.25
    free: float = 0.6
    seconds: float = 0.4


class GuidedSettings(NamedTuple):
    """The paper's chain (Cao, Cheng, Zhang 2024): its iterations and its λ."""

    steps: int = 1000
    rate: float = 0.1


class SearchSettings(NamedTuple):
    """Attempts while something cannot be reached; of a stated budget the share of the ``first``
    and of each ``again``; how much more what is ``wrong`` weighs in the end."""

    attempts: int = 4
    first: float = 0.5
    again: float = 0.1
    wrong: float = 20.0


class HallSettings(NamedTuple):
    """Whether groups stay ``whole``, and whether eqs. 1 and 3 stand as ``printed``; how chains
    anneal, the paper's chain runs, and attempts follow one another."""

    whole: bool = False
    printed: bool = False
    chains: ChainSettings = ChainSettings()
    guided: GuidedSettings = GuidedSettings()
    search: SearchSettings = SearchSettings()
