"""The part of the brief that only villages have: blocks, lanes, and the houses to choose from.

A block is ground between lanes; houses stand on it as those of a region stand (Zhu, Jiang,
Li 2022): each a real house of the library, none invented.
"""

from __future__ import annotations

from math import pi
from operator import not_
from typing import Annotated, Literal

from pydantic import Field

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

Stretch = Annotated[Number, Field(gt=0, le=BUILDING)]
Portion = Annotated[Number, Field(ge=0, le=1)]
RoofName = Literal["gabled", "hipped", "flat"]
HouseClass = Literal["small", "medium", "large"]


class Lane(StrictModel):
    """A street, lane or path by its middle line and width in metres. Sides of blocks along one are
    street sides."""

    id: str = ""
    name: str = ""
    line: Annotated[list[Point], Field(min_length=2, max_length=5000)]
    width: Annotated[Number, Field(ge=0.5, le=60)] = 5.0
    kind: Literal["road", "path"] = "road"


class LibraryHouse(StrictModel):
    """A house to choose: the ``footprint`` it covers in metres, as drawn, with ``levels`` and a
    ``roof`` (built in the style of the brief), or a ``model`` of the brief's ``catalogs`` as large
    as it is. ``height`` in metres (left out: by its levels); ``share`` how often it is chosen
    among houses about as large; its ``use`` (left out: an outbuilding under 45 m², else a
    dwelling): outbuildings belong to a house, stand behind it and have no plot of their own."""

    name: Annotated[str, Field(min_length=1, max_length=80)]
    footprint: FootprintOutline | None = None
    model: Annotated[str, Field(max_length=500)] = ""
    levels: Annotated[Whole, Field(ge=1, le=12)] = 2
    roof: RoofName = "gabled"
    height: Stretch | None = None
    share: Annotated[Number, Field(gt=0, le=1e6)] = 1.0
    use: Annotated[UseName | None, Field(exclude_if=is_left_out)] = None


class LockedHouse(StrictModel):
    """A house that stays where it stands: one that stands already, or one locked in a saved
    solution. ``house`` is its name in the library, ``size`` width, depth and height in metres,
    ``footprint`` the polygon it covers, stretched to these. One without a ``model`` is drawn by its
    ``use`` and ``roof`` (left out: a gabled dwelling)."""

    id: Annotated[str, Field(min_length=1, max_length=500)]
    house: str = ""
    model: Annotated[str, Field(max_length=500)] = ""
    at: Point
    heading: Heading = -pi / 2
    size: tuple[Stretch, Stretch, Stretch]
    footprint: Annotated[FootprintOutline | None, Field(exclude_if=is_left_out)] = None
    use: Annotated[UseName | None, Field(exclude_if=is_left_out)] = None
    roof: Annotated[RoofName | None, Field(exclude_if=is_left_out)] = None
    locked: Annotated[Switch, Field(exclude_if=not_)] = False


class VillageBlock(StrictModel):
    """One block. Lengths in metres, y to the north.

    ``streets`` are the sides of the ``outline`` that are streets, by number: side 0 runs from the
    first corner to the second (left out: the sides along ``lanes``). ``count`` houses, or as many
    as cover the share ``coverage`` of the block (both left out: as many as such blocks have).
    ``classes`` are the shares of small (under 50 m²), medium and large (over 100 m²) houses;
    ``square``: square metres kept free on the street; ``uses``: how many buildings of a use there
    are to be, or of how much floor (left out: as it comes). ``fixed`` are houses that stay
    where they stand and count.
    """

    id: str = ""
    name: str = ""
    outline: Outline
    streets: Annotated[list[Whole], Field(max_length=5000)] | None = None
    count: Annotated[Whole, Field(ge=0, le=500)] | None = None
    coverage: Annotated[Number, Field(gt=0, le=0.7)] | None = None
    classes: dict[HouseClass, Portion] = {}
    square: Annotated[Number, Field(gt=0, le=1e5)] | None = None
    uses: Annotated[dict[UseName, UseWish], Field(exclude_if=not_)] = {}
    fixed: Annotated[list[LockedHouse], Field(max_length=1000)] = []


class VillagePart(StrictModel):
    """The keys only briefs of villages have. ``region`` is one of those the style knows (left out:
    all together; of ``riviera``, the Riviera): how many houses stand there, how large and how near
    to each other. ``nets`` is a file of networks for the solver ``paper``; ``origin``
    is the longitude and latitude of (0, 0), if known."""

    blocks: Annotated[list[VillageBlock], Field(min_length=1, max_length=1000)] = Field(
        default=[], validate_default=True
    )
    lanes: Annotated[list[Lane], Field(max_length=5000)] = []
    houses: Annotated[list[LibraryHouse], Field(max_length=2000)] = []
    region: Annotated[str | None, Field(max_length=80, exclude_if=is_left_out)] = None
    nets: Annotated[str, Field(max_length=500, exclude_if=not_)] = ""
    origin: tuple[Coordinate, Coordinate] | None = None
    terrain: Annotated[TerrainBrief | None, Field(exclude_if=is_left_out)] = None
