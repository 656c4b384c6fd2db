"""What marks stand for: for files that have an entity of their own for it (a block, a dimension).

A :class:`scenewright.drawing.marks.MeantMark` holds how a thing is drawn, which is all that SVG
needs, and what it is, by which DXF writes inserts with attributes, true dimensions and room tags.
Points are millimetres on paper, as in the marks.
"""

from __future__ import annotations

from collections.abc import Hashable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Point = tuple[float, float]


class PieceMeaning(NamedTuple):
    """A placed object: its middle and turn (degrees clockwise on paper) from the symbol that looks
    to the top of the paper. Objects of one ``symbol`` are drawn alike; ``size`` is width, depth and
    height in metres."""

    id: str
    kind: str
    name: str
    model: str
    size: tuple[float, float, float]
    at: Point
    turn: float
    symbol: Hashable


class DimensionMeaning(NamedTuple):
    """A chain of lengths between the ``measured`` points (k, 2), written along the line through
    ``foots`` (k, 2), at ``turn`` degrees, 0 or 90; the k - 1 figures as drawn, empty where one has
    no room."""

    measured: NDArray[np.float64]
    foots: NDArray[np.float64]
    turn: float
    words: tuple[str, ...]


class RoomMeaning(NamedTuple):
    """The floor of a room: its rings ``(k, 2)``, the outer one first."""

    id: str
    name: str
    rings: tuple[NDArray[np.float64], ...]


class TagMeaning(NamedTuple):
    """The label of a room at a point: the words of its name, its area, its inner dimensions."""

    name: str
    area: str
    size: str
    at: Point


class OpeningMeaning(NamedTuple):
    """An opening: ``door``, ``window`` or ``passage``."""

    kind: str


Meaning = OpeningMeaning | PieceMeaning | DimensionMeaning | RoomMeaning | TagMeaning
