"""The brief: what a user asks for. The only validation of user input.

A brief is a small JSON document (``scenewright schema brief`` prints its JSON Schema). Lengths
are metres, angles radians counter-clockwise from +x, plans seen from above with y to the north.
What only one domain knows is that domain's part.
"""

from __future__ import annotations

from collections.abc import Mapping
from operator import not_
from typing import Annotated, Any, Literal

from pydantic import (
    Field,
    SerializerFunctionWrapHandler,
    ValidationInfo,
    field_validator,
    model_serializer,
    model_validator,
)
from pydantic_core import PydanticKnownError

from scenewright.core.brief.accepted import AcceptedFinding
from scenewright.core.brief.catalog import CatalogEntry, GroupsEntry
from scenewright.core.brief.fields import (
    Coordinate,
    Day,
    FootprintOutline,
    Heading,
    Height,
    Hour,
    Number,
    Outline,
    Point,
    Side,
    Storey,
    StrictModel,
    Switch,
    Whole,
    Words,
    is_left_out,
)
from scenewright.core.brief.input_report import InputReport
from scenewright.core.brief.scaling import LEAST, MOST, scale_plan, scale_widths
from scenewright.core.brief.services import OutletBrief, RadiatorBrief
from scenewright.core.brief.slope import SlopeBrief
from scenewright.core.brief.source_file import SourceFile
from scenewright.core.brief.stairs import StairsBrief
from scenewright.core.brief.wishes import WishBrief
from scenewright.core.brief.zones import Demand, Fill, Link, ZoneBrief
from scenewright.core.registry import DEFAULT, domain_names, domain_of, part_keys
from scenewright.core.views import describe, show

Function = Literal[
    "living",
    "dining",
    "kitchen",
    "bedroom",
    "double_bedroom",
    "single_bedroom",
    "child_bedroom",
    "study",
    "bathroom",
    "toilet",
    "washroom",
    "hall",
    "storage",
    "balcony",
    "other",
]

ACCESSIBLE_ROUTE = 0.9
"""Least width of routes for wheelchairs, in metres."""


class LevelBrief(StrictModel):
    """A storey. Rooms name it by ``id``."""

    id: str
    name: str = ""
    elevation: Coordinate = 0.0
    height: Storey = 2.6


class Door(StrictModel):
    """A door or open passage, given in one of the rooms it joins.

    ``at`` is its middle, on (or within a wall's thickness of) the room's outline. ``hinge`` is
    the side of the hinges seen from inside this room facing the door; ``swing`` whether the leaf
    turns into this room, out of it, slides, or is missing (an open passage).
    ``to`` is the id of the room beyond; left out, it is found from the plan. In halls ``use``
    tells where visitors come in and leave; every door is a way out in an emergency. ``ajar`` is
    how far a leaf that turns stands open in pictures and 3D files, in radians (left out: 1.36).
    """

    at: Point
    width: Annotated[Number, Field(ge=0.3, le=20)] = 0.85
    height: Storey = 2.05
    hinge: Literal["left", "right"] = "left"
    swing: Literal["in", "out", "slide", "none"] = "in"
    to: str | None = None
    use: Literal["both", "entrance", "exit"] = "both"
    id: str = ""
    ajar: Annotated[Number | None, Field(ge=0, le=1.6, exclude_if=is_left_out)] = None


class Window(StrictModel):
    """A window; ``at`` its middle on the room's outline, ``sill`` the height of its lower edge."""

    at: Point
    width: Annotated[Number, Field(ge=0.1, le=30)] = 1.2
    height: Storey = 1.4
    sill: Height = 0.9
    id: str = ""


class FixedItem(StrictModel):
    """A thing that stands where it stands. ``size`` is width, depth, height, of at most 30 m;
    ``heading`` of its front, in radians; ``z`` the height of its underside above the floor;
    ``on`` the id of the fixed item it stands on. ``group`` and ``function`` tell the
    furniture group it belongs to, if any. ``footprint`` is the polygon it covers, x to its right
    and y to its front, stretched to its width and depth (left out: its model's, else its box).
    ``locked`` things were placed by a solver and kept there by a person: they are judged as what
    is placed, not as what is given."""

    category: str
    at: Point
    heading: Heading = 0.0
    size: tuple[Side, Side, Side]
    footprint: Annotated[FootprintOutline | None, Field(exclude_if=is_left_out)] = None
    z: Height = 0.0
    asset: str | None = None
    name: str = ""
    id: str = ""
    on: str | None = None
    group: str = ""
    function: str = ""
    locked: Annotated[Switch, Field(exclude_if=not_)] = False


class Ask(StrictModel):
    """A wish for a room: a furniture group (``sleeping``, ``desk`` …), how many, how wide and
    deep at most, and whether leaving it out is a failure."""

    group: str
    count: Annotated[Whole, Field(ge=1, le=50)] = 1
    size: tuple[Side, Side] | None = None
    required: Switch = True


class Room(StrictModel):
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
    and ``people``, the most that may be inside at once. Their ``theme`` (museum, clothes …) adds
    what such a hall usually holds and is not named, and ``fill`` the share of the floor to which
    demands without a number fill it (``"none"``: neither). A hall ``like`` another, by its id,
    holds the same, laid out alike.
    """

    id: str = ""
    name: str = ""
    function: Function | list[Function] | None = None
    level: str = ""
    outline: Outline
    holes: Annotated[list[Outline], Field(max_length=200)] = []
    height: Storey | None = None
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
    theme: Annotated[Words | None, Field(exclude_if=is_left_out)] = None
    fill: Annotated[Fill | Literal["none"] | None, Field(exclude_if=is_left_out)] = None
    like: Annotated[str | None, Field(max_length=200, exclude_if=is_left_out)] = None


class WallBrief(StrictModel):
    """A wall given by its middle line; where walls are given they are drawn as they are."""

    start: Point
    end: Point
    thickness: Annotated[Number, Field(gt=0, le=5)] = 0.1
    height: Storey | None = None
    level: str = ""
    id: str = ""


class Brief(StrictModel):
    """The space, what is fixed in it and how it is judged, for every domain.

    Homes and halls have ``rooms`` on ``levels``, and ``stairs`` between these. Keys that only one
    domain knows (the ``sites`` of sites) are its ``part``; in the file they stand among the others.
    ``catalogs`` are models of the user's own: folders, libraries or files, relative to
    the brief's file.

    ``outlines`` tells whether room outlines are the inner faces of walls or their centre lines
    (then rooms shrink by half of ``wall_thickness``). ``route_width`` is the width of the
    walking route every piece must be reached by (0.6 m in homes, 0.9 m in halls, as a wheelchair
    needs); ``passage_width`` the least clear width between linked zones of a hall. A home that is
    ``accessible`` has routes of 0.9 m, room to turn in every room and free floor beside beds and
    toilets.

    ``scale`` corrects a plan drawn at the wrong scale: every length in plan is multiplied by it
    once, on reading (1.25: the plan was drawn too small), and it is 1 from then on; furniture and
    heights keep their size. ``notes`` are what a reader of files left out or assumed; the referee
    repeats them. ``sheet`` is the number of the plan's sheet, ``date`` its day (2026-11-22): as
    they are printed. ``residents`` is how many live in a home (left out: as many as its bedrooms
    are for). ``hour`` is the time of day it is lit for in files of 3D and photographs.
    ``accepted`` are findings of the referee that are meant to be so, with reasons.
    ``input_report`` is written by readers: what became of each feature of the file. Left out in a
    brief that was not changed (:func:`.own_report.input_report_of` counts what it holds).
    ``source_file`` is the file, where results can be written into a copy of it (IFC); a plan that
    is scaled is no longer that of its file.
    """

    format: Literal["scenewright/brief"] = "scenewright/brief"
    version: Literal[1] = 1
    domain: str = DEFAULT
    name: str = "home"
    catalogs: Annotated[list[CatalogEntry], Field(max_length=50)] = []
    groups: Annotated[list[GroupsEntry], Field(max_length=20)] = []
    style: Annotated[str, Field(max_length=500)] = ""
    colour: Words = ""
    levels: Annotated[list[LevelBrief], Field(max_length=200)] = []
    stairs: Annotated[list[StairsBrief], Field(max_length=200)] = []
    rooms: Annotated[list[Room], Field(max_length=10_000)]
    walls: Annotated[list[WallBrief], Field(max_length=50_000)] = []
    outlines: Literal["inner", "centre"] = "inner"
    wall_thickness: Annotated[Number, Field(ge=0.02, le=2)] = 0.12
    outer_wall_thickness: Annotated[Number, Field(ge=0.02, le=2)] = 0.25
    route_width: Annotated[Number, Field(ge=0.3, le=3)] = 0.6
    passage_width: Annotated[Number, Field(ge=0.3, le=20)] = 1.2
    accessible: Switch = False
    scale: Annotated[Number, Field(ge=LEAST, le=MOST)] = 1.0
    notes: Annotated[list[Annotated[str, Field(max_length=400)]], Field(max_length=100)] = []
    sheet: Annotated[str, Field(max_length=20, exclude_if=not_)] = ""
    date: Annotated[Day, Field(exclude_if=not_)] = ""
    residents: Annotated[Whole | None, Field(ge=1, le=20, exclude_if=is_left_out)] = None
    hour: Annotated[Hour, Field(exclude_if=not_)] = ""
    accepted: Annotated[list[AcceptedFinding], Field(max_length=1000, exclude_if=not_)] = []
    input_report: Annotated[InputReport | None, Field(exclude_if=is_left_out)] = None
    source_file: Annotated[SourceFile | None, Field(exclude_if=is_left_out)] = None
    part: Any = Field(default=None, validate_default=True)

    @model_validator(mode="before")
    @classmethod
    def _by_domain(cls, document: Any) -> Any:
        """What a brief does not state follows its domain, whose own keys become its part."""
        if not isinstance(document, dict):
            return document
        if "part" in document:
            raise PydanticKnownError("extra_forbidden")
        name = document.get("domain", DEFAULT)
        if name not in domain_names():
            return document
        domain = domain_of(name)
        return _gather(domain, {**_defaults(domain, document), **scale_widths(document)})

    @field_validator("domain")
    @classmethod
    def _known(cls, name: str) -> str:
        if name not in domain_names():
            expected = ", ".join(f"'{known}'" for known in domain_names())
            raise PydanticKnownError("literal_error", {"expected": expected})
        return name

    @field_validator("part", mode="before")
    @classmethod
    def _of_domain(cls, part: Any, info: ValidationInfo) -> Any:
        """The part as the model of its domain."""
        kind = _kind(info)
        model = kind.part_model() if kind else None
        return part if model is None or isinstance(part, model) else model.model_validate(part)

    @field_validator("rooms")
    @classmethod
    def _some(cls, rooms: list[Room], info: ValidationInfo) -> list[Room]:
        """Scenes of rooms need rooms."""
        kind = _kind(info)
        if not rooms and kind and kind.rooms:
            limits = {"field_type": "List", "min_length": 1, "actual_length": 0}
            raise PydanticKnownError("too_short", limits)
        return rooms

    @field_validator("scale")
    @classmethod
    def _of_rooms(cls, scale: float, info: ValidationInfo) -> float:
        """Sites are drawn from maps; only plans of rooms have a scale of their own."""
        kind = _kind(info)
        if scale != 1.0 and kind and not kind.rooms:
            raise ValueError("only homes and halls have a scale, leave it out")
        return scale

    @model_validator(mode="after")
    def _at_true_scale(self) -> Brief:
        """A brief never holds another scale than 1: it is applied in place while the model is made,
        because a validator may not return another instance."""
        if self.scale != 1.0:
            self.__dict__.update(scale_plan(self, self.scale), scale=1.0, source_file=None)
        return self

    @property
    def is_read_whole(self) -> bool:
        """Whether nothing that stands in the file this brief was read from is missing here."""
        return self.input_report is None or self.input_report.complete

    def __repr__(self) -> str:
        """One line: the domain, the name, and how much there is."""
        lists = {key: len(value) for key, value in self.part or () if isinstance(value, list)}
        counts = {"rooms": len(self.rooms), "levels": len(self.levels)} | lists
        return describe(
            "Brief", self.domain, self.name, **{k: n or None for k, n in counts.items()}
        )

    __str__ = __repr__

    def _repr_html_(self) -> str:
        """In notebooks: the plan without furniture, and a table of its rooms."""
        return str(show("brief_html", self))

    def _repr_svg_(self) -> str | None:
        """In notebooks: the plan without furniture, to scale."""
        drawn: str | None = show("brief_svg", self)
        return drawn

    @model_serializer(mode="wrap")
    def _flat(self, plain: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """The part's keys stand among the others, as in the file."""
        document: dict[str, Any] = plain(self)
        return document | (document.pop("part", None) or {})


def _kind(info: ValidationInfo) -> Any:
    """The domain of the brief that is being checked; ``None`` if what it names is none."""
    name = info.data.get("domain")
    return domain_of(name) if name else None


def _defaults(domain: Any, document: Mapping[str, Any]) -> dict[str, Any]:
    """Defaults of a brief of a domain."""
    given = dict(domain.defaults) if domain.rooms else {"rooms": [], **domain.defaults}
    if document.get("accessible") is True:
        given["route_width"] = max(ACCESSIBLE_ROUTE, given.get("route_width", 0.0))
    return given


def _gather(domain: Any, document: dict[str, Any]) -> dict[str, Any]:
    """The keys of a domain's part below ``part``; empty keys of other domains, which older files
    list, are dropped."""
    own = part_keys(domain.name)
    others = {key for name in domain_names() for key in part_keys(name)} - set(own)
    kept = {key: value for key, value in document.items() if key not in others or value}
    if not own:
        return kept
    part = {key: value for key, value in kept.items() if key in own}
    return {key: value for key, value in kept.items() if key not in own} | {"part": part}


def brief_schema() -> dict[str, Any]:
    """The JSON Schema of a brief, with the keys of every domain's part.

    >>> sorted(brief_schema()["properties"])[:3]
    ['accepted', 'accessible', 'areas']
    """
    schema = Brief.model_json_schema(mode="validation")
    schema["properties"].pop("part")
    schema["required"] = [key for key in schema.get("required", ()) if key != "rooms"]
    schema["properties"]["domain"]["enum"] = list(domain_names())
    for name in domain_names():
        if domain_of(name).part:
            part = domain_of(name).part_model().model_json_schema()
            schema["properties"] |= part["properties"]
            schema["$defs"] |= part.get("$defs", {})
    return schema
