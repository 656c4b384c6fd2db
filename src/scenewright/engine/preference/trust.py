"""How far predictions may be trusted: counted on screens the model had not learned from.

Screens to learn from show layouts far apart, which are easily told from each other. Layouts the
model would rate alone lie close together, so only screens that mostly show what is predicted best
say whether it may, and only by how much better it does there than guessing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
TOP = 3
"""Among how many predicted best the person's pick has to be."""
ENOUGH = 0.7
"""The share of screens of twelve above which the model may rate in the person's place."""
GUESSED = 0.25
"""What guessing hits of screens of twelve."""
FEWEST = 5
"""Screens before that may happen."""


class TrustRecord(NamedTuple):
    """On how many ``screens`` the person picked one, and on how many of them (``hits``) it was
    among the :data:`TOP` that were predicted before she did; ``chance`` is what guessing would
    have hit; ``late`` is the same of those screens alone that mostly showed the predicted best
    (screens, hits, chance)."""

    screens: int = 0
    hits: int = 0
    chance: float = 0.0
    late: tuple[int, int, float] = (0, 0, 0.0)

    @property
    def share(self) -> float:
        """The share of screens hit; 0 before there are any."""
        return self.hits / self.screens if self.screens else 0.0

    @property
    def skill(self) -> float:
        """(h - g) / (s - g) of ``late`` screens s, hits h and guessed ones g: 0 as by chance, 1 if
        all are hit (Cohen 1960's κ); 0 before there are any."""
        screens, hits, chance = self.late
        return (hits - chance) / (screens - chance) if screens > chance else 0.0

    @property
    def enough(self) -> bool:
        """Whether the model may rate in the person's place: of late screens of twelve above
        :data:`ENOUGH`, and as far above chance of smaller ones."""
        least = (ENOUGH - GUESSED) / (1.0 - GUESSED)
        return self.late[0] >= FEWEST and self.skill > least + 1e-9

    def __str__(self) -> str:
        """One line.

        >>> str(TrustRecord(8, 6, 2.0, (3, 2, 0.75)))
        'top 3 held your pick on 6 of 8 sheets (guessing: 25 %), on 2 of 3 of the predicted best'
        """
        if not self.screens:
            return "none tested by a pick yet"
        late, hits, _ = self.late
        guessed = 100 * self.chance / self.screens
        words = f"top {TOP} held your pick on {self.hits} of {self.screens} sheets"
        of_best = f", on {hits} of {late} of the predicted best" if late else ""
        return f"{words} (guessing: {guessed:.0f} %){of_best}"


def count_hit(
    record: TrustRecord, predicted: Sequence[float], picked: int, late: bool = True
) -> TrustRecord:
    """The record after one more screen: what was ``predicted`` for each of its candidates before
    the person chose the one at place ``picked``. Ties count as chance has it: a model that says
    the same of all hits nothing. ``late`` says that it mostly showed the predicted best.

    >>> count_hit(TrustRecord(), [0.1, 0.9, 0.3, 0.2], 3).hits
    1
    >>> count_hit(TrustRecord(), [0.0, 0.0, 0.0, 0.0], 3).hits
    0
    """
    values = np.asarray(predicted, np.float64)
    hit = int((values >= values[picked]).sum()) - 1 < TOP
    chance = min(TOP / len(values), 1.0)
    screens, hits, guessed = record.late
    late_record = (screens + 1, hits + hit, guessed + chance) if late else record.late
    return TrustRecord(record.screens + 1, record.hits + hit, record.chance + chance, late_record)
