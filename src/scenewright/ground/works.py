"""What is laid out on a site besides buildings: lanes, drives, walks, squares, parking, courts."""

from __future__ import annotations

from typing import Literal, NamedTuple

Corner = tuple[float, float]
PathKind = Literal["lane", "drive", "walk"]
AreaKind = Literal["square", "forecourt", "parking", "court"]


class Pathway(NamedTuple):
    """A paved way between buildings: a ``lane`` that fire engines and cars can drive, the ``drive``
    between the bays of a car park, or a ``walk``; its middle line in metres and its width."""

    kind: PathKind
    width: float
    line: tuple[Corner, ...]


class PavedArea(NamedTuple):
    """Ground set apart: a ``square`` (``about`` its name), the ``forecourt`` of a landmark
    (``about`` its id), a rectangle of ``parking`` with ``bays`` bays, its first edge on the
    street, or a ``court`` that buildings enclose."""

    kind: AreaKind
    outline: tuple[Corner, ...]
    bays: int = 0
    about: str = ""


class GroundWorks(NamedTuple):
    """All that is laid out on the ground of one site."""

    site: str
    pathways: tuple[Pathway, ...] = ()
    areas: tuple[PavedArea, ...] = ()
