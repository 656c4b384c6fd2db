"""The brief: what a user asks for. The only validation of user input.

A brief is a small JSON document (``scenewright schema brief`` prints its JSON Schema). Lengths
are metres, angles radians counter-clockwise from +x, plans seen from above with y to the north.
What only halls know (zones, links, demands) is in :mod:`scenewright.brief.hall`.
"""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, ValidationInfo, field_validator, model_validator
from pydantic_core import PydanticKnownError

from scenewright.brief.catalog import CatalogEntry, GroupsEntry
from scenewright.brief.fields import (
    Coordinate,
    Heading,
    Height,
    Length,
    Model,
    Number,
    Outline,
    Point,
    Side,
    Switch,
    Whole,
    Words,
)
from scenewright.brief.hall import Demand, Link, ZoneBrief
from scenewright.brief.services import OutletBrief, RadiatorBrief
from scenewright.brief.site import Site
from scenewright.brief.slope import SlopeBrief
from scenewright.brief.stairs import StairsBrief
from scenewright.brief.wishes import WishBrief

Function = Literal[
    "living", "dining", "kitchen", "bedroom", "double_bedroom", "single_bedroom",
    "child_bedroom", "study", "bathroom", "toilet", "washroom", "hall", "storage", "balcony",
    "other",
]  # fmt: skip

ROUTE_WIDTHS = {"home": 0.6, "hall": 0.9}
"""Width of the route to every piece where a brief does not state it, by domain, in metres."""


class LevelBrief(Model):
    """A storey. Rooms name it by ``id``."""

    id: str
    name: str = ""
    elevation: Coordinate = 0.0
    height: Length = 2.6


class Door(Model):
    """A door or open passage, given in one of the rooms it joins.

    ``at`` is its middle, on (or within a wall's thickness of) the room's outline. ``hinge`` is
    the side of the hinges seen from inside this room facing the door; ``swing`` whether the leaf
    turns into this room, out of it, slides, or is missing (an open passage).
    ``to`` is the id of the room beyond; left out, it is found from the plan. In halls ``use``
    tells where visitors come in and leave; every door is a way out in an emergency.
    """

    at: Point
    width: Annotated[Number, Field(ge=0.3, le=20)] = 0.85
    height: Length = 2.05
    hinge: Literal["left", "right"] = "left"
    swing: Literal["in", "out", "slide", "none"] = "in"
    to: str | None = None
    use: Literal["both", "entrance", "exit"] = "both"
    id: str = ""


class Window(Model):
    """A window; ``at`` its middle on the room's outline, ``sill`` the height of its lower edge."""

    at: Point
    width: Annotated[Number, Field(ge=0.1, le=30)] = 1.2
    height: Length = 1.4
    sill: Height = 0.9
    id: str = ""


class FixedItem(Model):
    """A thing that stands where it stands. ``size`` is width, depth, height, of at most 30 m;
    ``heading`` of its front, in radians; ``z`` the height of its underside above the floor;
    ``on`` the id of the fixed item it stands on. ``group`` and ``function`` tell the
    furniture group it belongs to, if any."""

    category: str
    at: Point
    heading: Heading = 0.0
    size: tuple[Side, Side, Side]
    z: Height = 0.0
    asset: str | None = None
    name: str = ""
    id: str = ""
    on: str | None = None
    group: str = ""
    function: str = ""


class Ask(Model):
    """A wish for a room: a furniture group (``sleeping``, ``desk`` …), how many, how wide and
    deep at most, and whether leaving it out is a failure."""

    group: str
    count: Annotated[Whole, Field(ge=1, le=50)] = 1
    size: tuple[Side, Side] | None = None
    required: Switch = True


class Room(Model):
    """One room: its outline (inner faces of the walls, either direction), holes (columns), what
    it is for, its openings and what already stands in it.

    ``function`` may be several for an open plan; left out, it is read from ``name``.
    ``main_wall`` is the index of an outline edge as listed (0 joins the first two points).
    ``slopes`` are the parts of the ceiling under a roof; the lowest at a point counts.
    ``outlets`` are where things are connected, ``radiators`` what heats.
    ``ask`` replaces what the function and size would bring, ``wishes`` add to it, take from it
    or say where. ``style`` and ``colour`` are words
    that furniture of the brief's own catalogues should answer to; left out, the home's.
    Halls have ``zones``, ``links`` between them and ``demands`` instead of functions and asks,
    and ``people``, the most that may be inside at once.
    """

    id: str = ""
    name: str = ""
    function: Function | list[Function] | None = None
    level: str = ""
    outline: Outline
    holes: Annotated[list[Outline], Field(max_length=200)] = []
    height: Length | None = None
    doors: Annotated[list[Door], Field(max_length=200)] = []
    windows: Annotated[list[Window], Field(max_length=200)] = []
    main_wall: Annotated[Whole, Field(ge=0)] | None = None
    slopes: Annotated[list[SlopeBrief], Field(max_length=20)] = []
    fixed: Annotated[list[FixedItem], Field(max_length=2000)] = []
    outlets: Annotated[list[OutletBrief], Field(max_length=200)] = []
    radiators: Annotated[list[RadiatorBrief], Field(max_length=50)] = []
    ask: Annotated[list[Ask], Field(max_length=200)] | None = None
    wishes: Annotated[list[WishBrief], Field(max_length=200)] = []
    style: Words = ""
    colour: Words = ""
    zones: Annotated[list[ZoneBrief], Field(max_length=200)] = []
    links: Annotated[list[Link], Field(max_length=1000)] = []
    demands: Annotated[list[Demand], Field(max_length=1000)] = []
    people: Annotated[Whole, Field(ge=1, le=100_000)] | None = None


class WallBrief(Model):
    """A wall given by its middle line; where walls are given they are drawn as they are."""

    start: Point
    end: Point
    thickness: Annotated[Number, Field(gt=0, le=5)] = 0.1
    height: Length | None = None
    level: str = ""
    id: str = ""


class Brief(Model):
    """A home, hall or site (later also a village): what there is and how it is to be judged.

    Homes and halls have ``rooms`` on ``levels``, and ``stairs`` between these; sites have
    ``sites``. ``catalogs`` are models of the user's own: folders, libraries or files, relative to
    the brief's file.

    ``outlines`` tells whether room outlines are the inner faces of walls or their centre lines
    (then rooms shrink by half of ``wall_thickness``). ``route_width`` is the width of the
    walking route every piece must be reached by (0.6 m in homes, 0.9 m in halls, as a wheelchair
    needs); ``passage_width`` the least clear width between linked zones of a hall. A home that is
    ``accessible`` has routes of 0.9 m, room to turn in every room and free floor beside beds and
    toilets.
    """

    format: Literal["scenewright/brief"] = "scenewright/brief"
    version: Literal[1] = 1
    domain: Literal["home", "hall", "site"] = "home"
    name: str = "home"
    catalogs: Annotated[list[CatalogEntry], Field(max_length=50)] = []
    groups: Annotated[list[GroupsEntry], Field(max_length=20)] = []
    style: Words = ""
    colour: Words = ""
    levels: Annotated[list[LevelBrief], Field(max_length=200)] = []
    stairs: Annotated[list[StairsBrief], Field(max_length=200)] = []
    rooms: Annotated[list[Room], Field(max_length=10_000)]
    sites: Annotated[list[Site], Field(max_length=100)] = []
    walls: Annotated[list[WallBrief], Field(max_length=50_000)] = []
    outlines: Literal["inner", "centre"] = "inner"
    wall_thickness: Annotated[Number, Field(ge=0.02, le=2)] = 0.12
    outer_wall_thickness: Annotated[Number, Field(ge=0.02, le=2)] = 0.25
    route_width: Annotated[Number, Field(ge=0.3, le=3)] = 0.6
    passage_width: Annotated[Number, Field(ge=0.3, le=20)] = 1.2
    accessible: Switch = False

    @model_validator(mode="before")
    @classmethod
    def _by_domain(cls, document: Any) -> Any:
        """What a brief does not state follows its domain."""
        domain = document.get("domain") if isinstance(document, dict) else None
        if domain == "hall":
            return {"route_width": ROUTE_WIDTHS["hall"], "name": "hall"} | document
        if isinstance(document, dict) and document.get("accessible") is True:
            return {"route_width": ROUTE_WIDTHS["hall"]} | document
        if domain == "site":
            return {"rooms": [], "name": "site", "sites": []} | document
        return document

    @field_validator("rooms", "sites")
    @classmethod
    def _some(cls, listed: list[Any], info: ValidationInfo) -> list[Any]:
        """Homes and halls need rooms, sites need sites."""
        wanted = "sites" if info.data.get("domain") == "site" else "rooms"
        if info.field_name == wanted and not listed:
            limits = {"field_type": "List", "min_length": 1, "actual_length": 0}
            raise PydanticKnownError("too_short", limits)
        return listed
