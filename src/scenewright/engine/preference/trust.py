"""How far predictions may be trusted: counted on screens the model had not learned from."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
TOP = 3
"""Among how many predicted best the person's pick has to be."""
ENOUGH = 0.7
"""The share of screens above which the model may rate in the person's place."""
FEWEST = 5
"""Screens before that may happen."""


class TrustRecord(NamedTuple):
    """On how many ``screens`` the person picked one, and on how many of them (``hits``) it was
    among the :data:`TOP` that were predicted before she did; ``chance`` is what guessing would
    have hit."""

    screens: int = 0
    hits: int = 0
    chance: float = 0.0

    @property
    def share(self) -> float:
        """The share of screens hit; 0 before there are any."""
        return self.hits / self.screens if self.screens else 0.0

    @property
    def enough(self) -> bool:
        """Whether the model may rate in the person's place."""
        return self.screens >= FEWEST and self.share > ENOUGH

    def __str__(self) -> str:
        """One line.

        >>> str(TrustRecord(8, 6, 2.0))
        'top 3 held your pick on 6 of 8 screens (75 %; guessing: 25 %)'
        """
        if not self.screens:
            return "nothing predicted yet"
        return (
            f"top {TOP} held your pick on {self.hits} of {self.screens} screens "
            f"({100 * self.share:.0f} %; guessing: {100 * self.chance / self.screens:.0f} %)"
        )


def count_hit(record: TrustRecord, predicted: Sequence[float], picked: int) -> TrustRecord:
    """The record after one more screen: what was ``predicted`` for each of its candidates before
    the person chose the one at place ``picked``. Ties count as chance has it: a model that says
    the same of all hits nothing.

    >>> count_hit(TrustRecord(), [0.1, 0.9, 0.3, 0.2], 3).hits
    1
    >>> count_hit(TrustRecord(), [0.0, 0.0, 0.0, 0.0], 3).hits
    0
    """
    values = np.asarray(predicted, np.float64)
    better = int((values >= values[picked]).sum()) - 1
    chance = min(TOP / len(values), 1.0)
    return TrustRecord(record.screens + 1, record.hits + (better < TOP), record.chance + chance)
