"""What a file draws, before anything is known of it: lines, arcs and words by layer."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from shapely import Geometry, Polygon

from scenewright.building.drawn.drawing import Arc, Word

MOST_LINES, FARTHEST = 1_000_000, 1e12
"""The most lines of a layer, and the greatest coordinate."""


class Layer:
    """What lies on a layer: lines (x0, y0, x1, y1), quarter arcs, words, and how many entities by
    type. What is not finite or farther than ``FARTHEST`` is left out."""

    def __init__(self) -> None:
        self.lines: list[tuple[float, float, float, float]] = []
        self.arcs: list[Arc] = []
        self.words: list[Word] = []
        self.counts: dict[str, int] = {}

    def count(self, kind: str) -> None:
        """Count an entity of a type."""
        self.counts[kind] = self.counts.get(kind, 0) + 1

    def add_path(self, points: Iterable[tuple[float, float]]) -> None:
        """Add the lines from point to point."""
        for a, b in pairwise(points):
            if len(self.lines) < MOST_LINES and is_near(*a, *b):
                self.lines.append((*a, *b))

    def add_arc(self, arc: Arc) -> None:
        """Add a part of a circle."""
        if arc.radius > 0.0 and is_near(*arc.middle, arc.radius, *arc.start, *arc.end):
            self.arcs.append(arc)

    def add_word(self, word: Word) -> None:
        """Add words, unless they are empty."""
        if word.words and is_near(word.x, word.y, word.size):
            self.words.append(word)


class Sheet(NamedTuple):
    """A drawing: its layers by name, the metres of its stated unit (``None``: none), and the
    outlines Scenewright has marked as rooms: id, name, points ``(n, 2)``; ``solid`` is what walls
    cover, where they are filled, and ``painted`` are areas in other colours."""

    layers: dict[str, Layer]
    unit: float | None
    rooms: tuple[tuple[str, str, np.ndarray], ...]
    solid: Geometry | None = None
    painted: tuple[Polygon, ...] = ()


def is_near(*values: float) -> bool:
    """Whether numbers are finite and no farther from zero than coordinates may be.

    >>> is_near(1.0, -2e6), is_near(0.0, float("nan")), is_near(1e300)
    (True, False, False)
    """
    return all(abs(value) <= FARTHEST for value in values)
