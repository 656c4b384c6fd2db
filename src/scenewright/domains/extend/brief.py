"""The part of the brief that only extensions have: source scenes, and the areas to fill.

A source is a small neighbourhood; an area is ground that is to be built on as the sources are
(after Zhang and Fei 2017, who grow a scene from one or more of the user's own).
"""

from __future__ import annotations

from operator import not_
from typing import Annotated, Literal

from pydantic import Field

from scenewright.core.brief.catalog import PathText
from scenewright.core.brief.fields import (
    BUILDING,
    Coordinate,
    FootprintOutline,
    Heading,
    Number,
    Outline,
    Point,
    StrictModel,
    Switch,
    Whole,
    is_left_out,
)
from scenewright.core.brief.terrain import TerrainBrief
from scenewright.core.brief.uses import UseName, UseWish

RoofName = Literal["gabled", "hipped", "flat"]
Spots = Annotated[list[Point], Field(max_length=20_000, exclude_if=not_)]
Span = Annotated[Number, Field(gt=0, le=BUILDING)]


class SourceBuilding(StrictModel):
    """A building of a source: its ``outline`` in metres, ``height`` (or ``levels``), ``heading`` of
    its front in radians (left out: the side facing the nearest street), the ``model`` that draws
    it, else its ``use`` and ``roof``."""

    id: Annotated[str, Field(max_length=200)] = ""
    name: Annotated[str, Field(max_length=80)] = ""
    outline: Outline
    height: Span = 7.5
    levels: Annotated[Whole | None, Field(ge=1, le=130, exclude_if=is_left_out)] = None
    heading: Heading | None = None
    model: Annotated[str, Field(max_length=500)] = ""
    use: Annotated[UseName | None, Field(exclude_if=is_left_out)] = None
    roof: Annotated[RoofName | None, Field(exclude_if=is_left_out)] = None


class StreetLine(StrictModel):
    """A street or path by its middle line and width in metres."""

    id: str = ""
    name: str = ""
    line: Annotated[list[Point], Field(min_length=2, max_length=5000)]
    width: Annotated[Number, Field(ge=0.5, le=60)] = 6.0
    kind: Literal["road", "path"] = "road"


class SourceScene(StrictModel):
    """One neighbourhood to continue: a file at ``path`` (GeoJSON, CityJSON, a saved solution, or a
    scene of models, .glb or a folder of such, ``scale`` metres a unit), or drawn ``buildings`` and
    ``roads``. ``outline`` is its ground (left out: what lies about its buildings). Of several, each
    is followed in its ``share``. ``stands`` says whether it stands where it is drawn and is
    continued from there (left out: if it lies beside an area). ``trees`` and street ``lamps`` are
    points."""

    name: Annotated[str, Field(max_length=80)] = ""
    path: PathText | None = None
    scale: Annotated[Number, Field(gt=0, le=1e4)] = 1.0
    buildings: Annotated[list[SourceBuilding], Field(max_length=5000)] = []
    roads: Annotated[list[StreetLine], Field(max_length=2000)] = []
    trees: Spots = []
    lamps: Spots = []
    outline: Outline | None = None
    share: Annotated[Number, Field(gt=0, le=1e6)] = 1.0
    stands: Switch | None = None


class DrawnRow(StrictModel):
    """A row to build first: a string of kinds of the sources, folded or not (``(A B)^5 - C``; ``-``
    is a passage), laid along a ``line`` on which its fronts stand, to its left. ``gap`` is that
    between buildings in metres (left out: the least of the sources)."""

    pattern: Annotated[str, Field(min_length=1, max_length=4000)]
    line: Annotated[list[Point], Field(min_length=2, max_length=500)]
    gap: Annotated[Number, Field(ge=0, le=100)] | None = None


class LockedGrowth(StrictModel):
    """A building of an area that stays: one locked in a saved solution, or a landmark."""

    id: Annotated[str, Field(min_length=1, max_length=500)]
    kind: Annotated[str, Field(max_length=80)] = ""
    model: Annotated[str, Field(max_length=500)] = ""
    at: Point
    heading: Heading = 0.0
    size: tuple[Span, Span, Span]
    footprint: Annotated[FootprintOutline | None, Field(exclude_if=is_left_out)] = None
    locked: Annotated[Switch, Field(exclude_if=not_)] = False


class GrowthArea(StrictModel):
    """Ground to fill. ``count`` buildings, or as many as cover the share ``coverage`` (both left
    out: the share that the sources cover). ``roads`` are drawn there; ``continue_streets`` runs
    those on that end at its border. ``use`` says which models stand there: the ``source``'s own,
    or of a like size from the brief's ``catalogue``. ``rows`` are built first. ``uses`` says
    how many new buildings of a use there are to be, or of how much floor (left out: as in the
    source). ``fixed`` stays and counts. ``storeys``: how many storeys copies are taller (or lower)
    than their originals."""

    id: str = ""
    name: str = ""
    outline: Outline
    holes: Annotated[list[Outline], Field(max_length=200)] = []
    roads: Annotated[list[StreetLine], Field(max_length=2000)] = []
    continue_streets: Switch = True
    count: Annotated[Whole, Field(ge=0, le=5000)] | None = None
    coverage: Annotated[Number, Field(gt=0, le=0.8)] | None = None
    storeys: Annotated[int, Field(strict=True, ge=-20, le=60)] = 0
    use: Literal["source", "catalogue"] = "source"
    rows: Annotated[list[DrawnRow], Field(max_length=200)] = []
    uses: Annotated[dict[UseName, UseWish], Field(exclude_if=not_)] = {}
    fixed: Annotated[list[LockedGrowth], Field(max_length=5000)] = []


class ExtendPart(StrictModel):
    """The keys only briefs of extensions have. ``origin`` is the longitude and latitude of
    (0, 0), if known."""

    sources: Annotated[list[SourceScene], Field(min_length=1, max_length=20)] = Field(
        default=[], validate_default=True
    )
    areas: Annotated[list[GrowthArea], Field(min_length=1, max_length=100)] = Field(
        default=[], validate_default=True
    )
    origin: tuple[Coordinate, Coordinate] | None = None
    terrain: Annotated[TerrainBrief | None, Field(exclude_if=is_left_out)] = None
