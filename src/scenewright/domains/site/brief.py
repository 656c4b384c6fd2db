"""The part of the brief that only sites have: ground, roads, landmarks, buildings asked for.

A site is ground between streets: its outline, roads and paths, a few fixed landmarks, and
buildings to be placed on it (Zhang, Yang 2023). Buildings are models: shipped styles by name, or
models of the brief's catalogues.
"""

from __future__ import annotations

from math import pi
from operator import not_
from typing import Annotated, Literal

from pydantic import AfterValidator, Field

from scenewright.core.brief.fields import (
    BUILDING,
    Clearance,
    Coordinate,
    FootprintOutline,
    Heading,
    Length,
    Number,
    Outline,
    Point,
    StrictModel,
    Switch,
    Whole,
    is_left_out,
)
from scenewright.core.brief.terrain import TerrainBrief

Place = Annotated[Number, Field(ge=-1e9, le=1e9)]
Metres = Annotated[Number, Field(gt=0, le=BUILDING)]
Depth = Annotated[Number, Field(ge=2, le=300)]
Side = Annotated[Number, Field(ge=0.5, le=BUILDING)]
CourtGap = Annotated[Number, Field(ge=3, le=60)]
RoofName = Literal["gabled", "hipped", "flat"]
FormName = Literal[
    "parallel", "staggered", "spliced", "rotated", "peripheral", "half-closed", "point", "mixed"
]


USUAL_WIDTH = 6.0
"""Metres of a street whose width is not known."""


def _known_width(width: float) -> float:
    """A width in metres; the usual one for 0, by which maps say that it is not known."""
    if 0.0 < width < 0.5:
        raise ValueError("Input should be at least 0.5, or 0 where it is not known")
    return width or USUAL_WIDTH


class Road(StrictModel):
    """A road or path by its middle line. Roads divide the ground; paths are where people walk
    and look. Nothing may stand on either. A ``width`` of 0 is not known, and taken as 6 m."""

    id: str = ""
    name: str = ""
    line: Annotated[list[Point], Field(min_length=2, max_length=5000)]
    width: Annotated[Number, Field(ge=0, le=100), AfterValidator(_known_width)] = USUAL_WIDTH
    kind: Literal["road", "path"] = "road"


class Landmark(StrictModel):
    """A building that stands where it stands: a shipped style or a model of the brief's
    ``catalogs``, as large as it is unless ``size`` (width, depth, height) is given, or just a
    footprint with a height. ``forecourt`` metres before its front are paved and kept free, as wide
    as it is; ``quad`` metres all round it are a court that buildings close, their fronts to it;
    its front stays in sight from ``view`` metres of the street before it, to either side. ``use``
    (``church``, ``school``, ``warehouse`` …), ``levels`` and ``roof`` say what draws one that names
    no model."""

    id: str = ""
    name: str = ""
    model: str = ""
    at: Point | None = None
    heading: Heading = -pi / 2
    size: tuple[Metres, Metres, Metres] | None = None
    outline: Outline | None = None
    height: Length | None = None
    forecourt: Annotated[Depth | None, Field(exclude_if=is_left_out)] = None
    quad: Annotated[Depth | None, Field(exclude_if=is_left_out)] = None
    view: Annotated[Depth | None, Field(exclude_if=is_left_out)] = None
    use: Annotated[str, Field(max_length=80, exclude_if=not_)] = ""
    levels: Annotated[Whole | None, Field(ge=1, le=300, exclude_if=is_left_out)] = None
    roof: Annotated[RoofName | None, Field(exclude_if=is_left_out)] = None


class Square(StrictModel):
    """A paved square of ``area`` square metres beside a street or path, as near to ``at`` (left
    out: to the middle of the site) as it can be."""

    name: str = ""
    area: Annotated[Number, Field(ge=25, le=1e5)]
    at: Point | None = None


class Parking(StrictModel):
    """Parking in lots beside roads: ``bays`` in all, or ``per_building``."""

    bays: Annotated[Whole | None, Field(ge=1, le=20_000)] = None
    per_building: Annotated[Number | None, Field(gt=0, le=100)] = None


class Building(StrictModel):
    """Buildings of one model to be placed: ``model`` names a shipped style
    (``scenewright list assets``) or a model of the brief's ``catalogs``; ``size`` width, depth and
    height in metres (left out: the model's own); ``count`` how many; ``floors`` storeys, for the
    floor-area ratio. ``forms`` are the planar forms they may take (left out: rows ``parallel`` or
    ``staggered``, ``peripheral`` around a court, ``mixed``); see ``form`` of a site.
    ``footprint`` is the polygon each covers, x to its right and y to its front: in metres, or
    stretched to ``size``
    (left out: the model's, else its box)."""

    id: str = ""
    name: str = ""
    model: Annotated[str, Field(min_length=1, max_length=500)]
    count: Annotated[Whole, Field(ge=1, le=20_000)] = 1
    size: tuple[Side, Side, Side] | None = None
    footprint: Annotated[FootprintOutline | None, Field(exclude_if=is_left_out)] = None
    floors: Annotated[Whole, Field(ge=1, le=300)] | None = None
    forms: Annotated[list[FormName], Field(max_length=8)] = []
    required: Switch = True


class BlockForm(StrictModel):
    """The planar form of the block that a point ``at`` lies in."""

    at: Point
    form: FormName


class LibraryModel(StrictModel):
    """A model that buildings may be of where a site states a target instead of numbers: ``model``,
    ``name``, ``size`` and ``floors`` as of a row of ``buildings``; ``share`` is its part of all
    buildings against that of the others."""

    id: str = ""
    name: str = ""
    model: Annotated[str, Field(min_length=1, max_length=500)]
    size: tuple[Side, Side, Side] | None = None
    floors: Annotated[Whole, Field(ge=1, le=300)] | None = None
    share: Annotated[Number, Field(gt=0, le=1000)] = 1.0


class LockedBuilding(StrictModel):
    """A building asked for that stays where it stands: one locked in a saved solution. ``name`` is
    that of the row of ``buildings`` it counts for, ``size`` width, depth and height in metres,
    ``footprint`` the polygon it covers, stretched to these."""

    id: Annotated[str, Field(min_length=1, max_length=500)]
    name: str = ""
    model: Annotated[str, Field(min_length=1, max_length=500)]
    at: Point
    heading: Heading = -pi / 2
    size: tuple[Metres, Metres, Metres]
    footprint: Annotated[FootprintOutline | None, Field(exclude_if=is_left_out)] = None
    locked: Annotated[Switch, Field(exclude_if=not_)] = False


VERGE = 8.0
"""Metres between the border of a site and a street that gives access to it, at most."""


def _is_usual_verge(value: float) -> bool:
    return value == VERGE


class Site(StrictModel):
    """One site. Lengths in metres, y to the north.

    ``setback`` is kept from the outline, ``road_setback`` from roads and paths; ``spacing`` is
    the least distance of buildings to each other, ``sun_spacing`` the least distance behind a
    building to the south in heights of that building (0: by hours of sun alone).
    A street on the border, or at most ``verge`` beside it, gives access as one inside does.
    ``facing`` is the preferred heading of fronts (south); ``fire_access`` the width of the way
    that must reach each building; a paved one must come within ``fire_reach``.
    ``door_distance`` is kept from the border ahead of a door, but where a way runs there.
    ``latitude`` (degrees) and ``day`` (of the year; 355 is the winter solstice in the north, 20
    January is 20) are for hours of sun, at least ``sun_hours``: a wish, or a rule with
    ``sun_required``.
    ``form`` is the planar form of all blocks, ``blocks`` that of some: rows ``parallel``,
    ``staggered``, ``spliced`` of two directions or ``rotated`` in place; ``peripheral`` all round
    a court or ``half-closed``, open to the front; ``point`` towers apart; ``mixed``.
    Where ``court_gap`` is given, courts of ``peripheral`` blocks close: no opening between
    neighbours round a court is wider. ``squares`` and ``parking`` are laid out beside the streets.
    ``fixed`` are buildings that stay where they stand and count for what is asked.
    With a ``library`` in place of ``buildings``, its models fill the site up to ``coverage`` and
    ``floor_area_ratio``, mixed by their shares; genetic algorithms choose the models themselves.
    Without either those of the brief's ``catalogs``, or shipped dwellings, fill the site
    up to ``floor_area_ratio`` and ``coverage``. ``origin`` is the longitude and latitude of
    (0, 0), if known; ``shift`` is to be added to coordinates for those of the reference
    ``system`` of the map or city model that the site came from.
    """

    id: str = ""
    name: str = ""
    outline: Outline
    holes: Annotated[list[Outline], Field(max_length=200)] = []
    roads: Annotated[list[Road], Field(max_length=5000)] = []
    landmarks: Annotated[list[Landmark], Field(max_length=2000)] = []
    buildings: Annotated[list[Building], Field(max_length=1000)] = []
    library: Annotated[list[LibraryModel], Field(max_length=200)] = []
    form: FormName | None = None
    blocks: Annotated[list[BlockForm], Field(max_length=1000)] = []
    court_gap: Annotated[CourtGap | None, Field(exclude_if=is_left_out)] = None
    squares: Annotated[list[Square], Field(max_length=50, exclude_if=not_)] = []
    parking: Annotated[Parking | None, Field(exclude_if=is_left_out)] = None
    fixed: Annotated[list[LockedBuilding], Field(max_length=20_000)] = []
    floor_area_ratio: Annotated[Number, Field(gt=0, le=30)] | None = None
    coverage: Annotated[Number, Field(gt=0, le=0.9)] | None = None
    height_limit: Length | None = None
    setback: Clearance = 3.0
    road_setback: Clearance = 3.0
    verge: Annotated[Number, Field(ge=0, le=100, exclude_if=_is_usual_verge)] = VERGE
    spacing: Clearance = 6.0
    sun_spacing: Annotated[Number, Field(ge=0, le=5)] = 0.0
    facing: Heading = -pi / 2
    fire_access: Annotated[Number, Field(gt=0, le=20)] = 4.0
    fire_reach: Annotated[Number, Field(ge=1, le=200)] = 25.0
    door_distance: Clearance = 5.0
    latitude: Annotated[Number, Field(ge=-89, le=89)] = 35.0
    day: Annotated[Whole, Field(ge=1, le=366)] = 20
    sun_hours: Annotated[Number, Field(ge=0, le=12)] = 2.0
    sun_required: Switch = False
    origin: tuple[Coordinate, Coordinate] | None = None
    system: Annotated[str, Field(max_length=200)] = ""
    shift: tuple[Place, Place] = (0.0, 0.0)


class SitePart(StrictModel):
    """The keys only briefs of sites have, and their ``terrain``."""

    sites: Annotated[list[Site], Field(min_length=1, max_length=100)] = Field(
        default=[], validate_default=True
    )
    terrain: Annotated[TerrainBrief | None, Field(exclude_if=is_left_out)] = None


def rows_of(site: Site) -> list[Building | LibraryModel]:
    """The rows that name the models of a site: its library, else its buildings."""
    return [*site.library] or [*site.buildings]
