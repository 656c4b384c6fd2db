"""A plan as drawn: lines of walls, symbols of doors and windows, words; in one unit."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Segments = NDArray[np.float64]


class Arc(NamedTuple):
    """A part of a circle: its middle, radius and both ends."""

    middle: tuple[float, float]
    radius: float
    start: tuple[float, float]
    end: tuple[float, float]


class Word(NamedTuple):
    """Words at a point, letters ``size`` high."""

    words: str
    x: float
    y: float
    size: float


class Drawn(NamedTuple):
    """What a drawing holds of a plan: ``walls`` (n, 2, 2), ``doors`` (m, 2, 2) and ``windows``
    (k, 2, 2) are lines on layers of these, ``arcs`` quarter circles, ``words`` texts;
    ``marks`` (j, 2, 2) lines of what else is drawn, which may close a gap."""

    walls: Segments
    doors: Segments
    windows: Segments
    arcs: tuple[Arc, ...]
    words: tuple[Word, ...]
    marks: Segments

    def scaled(self, factor: float, shift: NDArray[np.float64]) -> Drawn:
        """The drawing moved by ``-shift`` and then multiplied."""

        def move(point: tuple[float, float]) -> tuple[float, float]:
            x, y = ((np.asarray(point) - shift) * factor).tolist()
            return x, y

        return Drawn(
            (self.walls - shift) * factor,
            (self.doors - shift) * factor,
            (self.windows - shift) * factor,
            tuple(
                Arc(move(a.middle), a.radius * factor, move(a.start), move(a.end))
                for a in self.arcs
            ),
            tuple(Word(w.words, *move((w.x, w.y)), w.size * factor) for w in self.words),
            (self.marks - shift) * factor,
        )


NO_LINES: Segments = np.zeros((0, 2, 2))
