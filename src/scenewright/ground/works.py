"""What is laid out on a site besides buildings: lanes, drives, walks, squares, parking, courts."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any, Literal, NamedTuple

import numpy as np
import shapely

Corner = tuple[float, float]
PathKind = Literal["lane", "drive", "walk"]
AreaKind = Literal["square", "forecourt", "parking", "court", "park"]


class Pathway(NamedTuple):
    """A paved way between buildings: a ``lane`` that fire engines and cars can drive, the ``drive``
    between the bays of a car park, or a ``walk``; its middle line in metres and its width."""

    kind: PathKind
    width: float
    line: tuple[Corner, ...]


def middle_lines(lines: Sequence[Sequence[Any]]) -> Any:
    """Lines (k, 2) each, of two points at least, as an array (n,) of shapes."""
    count = [len(line) for line in lines]
    points = np.array(list(chain.from_iterable(lines)), np.float64).reshape(-1, 2)
    return shapely.linestrings(points, indices=np.repeat(np.arange(len(count)), count))


class PavedArea(NamedTuple):
    """Ground set apart: a ``square`` (``about`` its name), the ``forecourt`` of a landmark
    (``about`` its id), a rectangle of ``parking`` with ``bays`` bays, its first edge on the
    street, a ``court`` that buildings enclose, or a ``park`` on open ground."""

    kind: AreaKind
    outline: tuple[Corner, ...]
    bays: int = 0
    about: str = ""


GREEN, FRONTED = ("court", "park"), ("square", "court")
"""Kinds of areas that are planted, not paved; and of those set apart that fronts look at."""


class GroundWorks(NamedTuple):
    """All that is laid out on the ground of one site."""

    site: str
    pathways: tuple[Pathway, ...] = ()
    areas: tuple[PavedArea, ...] = ()
