"""The brief: what a user asks for. The only validation of user input.

A brief is a small JSON document (``scenewright schema brief`` prints its JSON Schema). Lengths
are metres, angles radians counter-clockwise from +x, plans seen from above with y to the north.
"""

from __future__ import annotations

from math import tau
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Whole = Annotated[int, Field(strict=True)]
Switch = Annotated[bool, Field(strict=True)]
Coordinate = Annotated[Number, Field(ge=-1e4, le=1e4)]
Length = Annotated[Number, Field(gt=0, le=1e3)]
Side = Annotated[Number, Field(gt=0, le=30)]
Height = Annotated[Number, Field(ge=0, le=100)]
Heading = Annotated[Number, Field(ge=-tau, le=tau)]
Point = tuple[Coordinate, Coordinate]
Outline = Annotated[list[Point], Field(min_length=3, max_length=5000)]

Function = Literal[
    "living", "dining", "kitchen", "bedroom", "double_bedroom", "single_bedroom",
    "child_bedroom", "study", "bathroom", "toilet", "washroom", "hall", "storage", "balcony",
    "other",
]  # fmt: skip


class Model(BaseModel):
    """Immutable, and strict about names: an unknown key is a mistake worth telling."""

    model_config = ConfigDict(frozen=True, extra="forbid")


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
    ``to`` is the id of the room beyond; left out, it is found from the plan.
    """

    at: Point
    width: Annotated[Number, Field(ge=0.3, le=20)] = 0.85
    height: Length = 2.05
    hinge: Literal["left", "right"] = "left"
    swing: Literal["in", "out", "slide", "none"] = "in"
    to: str | None = None
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
    size: tuple[Length, Length] | None = None
    required: Switch = True


class Room(Model):
    """One room: its outline (inner faces of the walls, either direction), holes (columns), what
    it is for, its openings and what already stands in it.

    ``function`` may be several for an open plan; left out, it is read from ``name``.
    ``main_wall`` is the index of an outline edge as listed (0 joins the first two points).
    ``ask`` replaces what the function and size would bring.
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
    fixed: Annotated[list[FixedItem], Field(max_length=2000)] = []
    ask: Annotated[list[Ask], Field(max_length=200)] | None = None


class WallBrief(Model):
    """A wall given by its middle line; where walls are given they are drawn as they are."""

    start: Point
    end: Point
    thickness: Annotated[Number, Field(gt=0, le=5)] = 0.1
    height: Length | None = None
    level: str = ""
    id: str = ""


class Brief(Model):
    """A home (later also a hall, a site, a village): levels, rooms and how it is to be judged.

    ``outlines`` tells whether room outlines are the inner faces of walls or their centre lines
    (then rooms shrink by half of ``wall_thickness``). ``route_width`` is the width of the
    walking route every piece must be reached by.
    """

    format: Literal["scenewright/brief"] = "scenewright/brief"
    version: Literal[1] = 1
    domain: Literal["home"] = "home"
    name: str = "home"
    levels: Annotated[list[LevelBrief], Field(max_length=200)] = []
    rooms: Annotated[list[Room], Field(min_length=1, max_length=10_000)]
    walls: Annotated[list[WallBrief], Field(max_length=50_000)] = []
    outlines: Literal["inner", "centre"] = "inner"
    wall_thickness: Annotated[Number, Field(ge=0.02, le=2)] = 0.12
    outer_wall_thickness: Annotated[Number, Field(ge=0.02, le=2)] = 0.25
    route_width: Annotated[Number, Field(ge=0.3, le=3)] = 0.6
