"""What is laid out between buildings once they stand: lanes, walks to doors, squares, parking."""

from __future__ import annotations

from typing import Literal, NamedTuple

Corner = tuple[float, float]
PathKind = Literal["lane", "walk"]
AreaKind = Literal["square", "forecourt", "parking", "court"]


class Pathway(NamedTuple):
    """A paved way between buildings: a ``lane`` that fire engines and cars can drive, or a
    ``walk``; its middle line in metres and its width."""

    kind: PathKind
    width: float
    line: tuple[Corner, ...]


class PavedArea(NamedTuple):
    """Ground set apart: a ``square``, the ``forecourt`` of a landmark (``about`` its id), a
    rectangle of ``parking`` with so many ``bays``, or a ``court`` that buildings enclose."""

    kind: AreaKind
    outline: tuple[Corner, ...]
    bays: int = 0
    about: str = ""


class GroundWorks(NamedTuple):
    """All that is laid out on the ground of one site."""

    site: str
    pathways: tuple[Pathway, ...] = ()
    areas: tuple[PavedArea, ...] = ()
