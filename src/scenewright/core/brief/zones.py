"""The part of the brief that only halls have: zones, links between them, demands.

A hall is an exhibition, a shop, a reading room, an auditorium: a room whose floor is divided into
functional zones, and groups of like objects to be laid out in them (Cao, Cheng, Zhang 2024).
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from scenewright.core.brief.fields import (
    Clearance,
    Number,
    Outline,
    Side,
    StrictModel,
    Switch,
    Whole,
    is_left_out,
)

PatternName = Annotated[str, Field(min_length=1, max_length=40)]
Sizes = tuple[Side, Side, Side]
UsedSide = Literal["front", "back", "left", "right"]
Fill = Annotated[Number, Field(ge=0.05, le=0.8)]
"""A share of floor."""


class ZoneBrief(StrictModel):
    """A functional zone of a hall.

    With ``outline`` it lies there. Without, one is proposed: of about ``area`` square metres
    (left out: by what it is to hold), ``beside`` the zones named, at the door ``door``. ``slack``
    metres each of its borders with other zones may be moved while solving (left out: none where the
    outline is stated, 1.5 where it is proposed).
    """

    id: Annotated[str, Field(min_length=1, max_length=200)]
    name: str = ""
    outline: Outline | None = None
    area: Annotated[Number, Field(gt=0, le=1e6)] | None = None
    beside: Annotated[list[str], Field(max_length=200)] = []
    door: str | None = None
    slack: Annotated[Number, Field(ge=0, le=100)] | None = None


class Link(StrictModel):
    """Two zones between which people must be able to walk, through a passage at least ``width``
    metres wide (left out: the brief's ``passage_width``)."""

    between: tuple[str, str]
    width: Annotated[Number, Field(ge=0.3, le=20)] | None = None


class AisleBrief(StrictModel):
    """An aisle across rows: each row is broken after ``every`` objects by ``width`` metres."""

    every: Annotated[Whole, Field(ge=1, le=20_000)]
    width: Annotated[Number, Field(ge=0.3, le=20)]


class Demand(StrictModel):
    """A group of like objects to be laid out: 24 showcases, 300 m of shelving, 80 seats.

    ``category`` is a kind of the catalog (``scenewright list assets``). How many: ``count``, or
    ``length``, metres of front side by side; with ``most`` up to that number where there is room,
    with ``fill`` as many as it takes for the objects of its zones, with the free depth around
    each, to cover that share of their floor. Where none is said, goods of the hall's theme fill it
    to the usual share; ``"fill": "none"`` stands for one. How large: ``size`` (width, depth,
    height), or ``sizes``, one for each of unequal objects; else what is usual.
    ``clearance`` is the free depth wished for at all sides, or front, left, back, right.
    ``place`` tells whether they stand at a wall; ``patterns`` which patterns may lay them out;
    ``zone`` in which zone, or which of several, they belong (left out: anywhere); ``facing`` the
    demand they look at (seats a stage; left out, seats look at a stage or screen); ``aisle`` breaks
    their rows by aisles across. ``used_from`` are the sides people come to: with it, ``name`` and
    ``size`` a ``box`` is a kind of one's own. What is not given follows the category. A demand that
    is not ``required`` may be left out quietly.
    """

    id: str = ""
    name: str = ""
    category: Annotated[str, Field(min_length=1, max_length=200)]
    count: Annotated[Whole, Field(ge=1, le=20_000)] | None = None
    length: Annotated[Number, Field(gt=0, le=100_000)] | None = None
    most: Annotated[Whole | None, Field(ge=1, le=20_000, exclude_if=is_left_out)] = None
    fill: Annotated[Fill | Literal["none"] | None, Field(exclude_if=is_left_out)] = None
    size: Sizes | None = None
    sizes: Annotated[list[Sizes], Field(max_length=20_000)] = []
    clearance: Clearance | tuple[Clearance, Clearance, Clearance, Clearance] | None = None
    place: Literal["wall", "free"] | None = None
    patterns: Annotated[list[PatternName], Field(max_length=9)] = []
    zone: str | Annotated[list[str], Field(max_length=200)] | None = None
    facing: str | None = None
    aisle: Annotated[AisleBrief | None, Field(exclude_if=is_left_out)] = None
    used_from: Annotated[list[UsedSide] | None, Field(max_length=4, exclude_if=is_left_out)] = None
    required: Switch = True
