"""Statistics of furnished rooms as rows of a file, each with its limits."""

from __future__ import annotations

from typing import Annotated, Literal, NamedTuple

from pydantic import Field

from scenewright.core.brief.fields import Number

Apart = Annotated[Number, Field(ge=0, lt=100)]
Floor = Annotated[Number, Field(gt=0, le=10_000)]
Depth = Annotated[Number, Field(ge=0, le=20)]
Part = Annotated[Number, Field(ge=0, le=1)]
Count = Annotated[int, Field(strict=True, ge=0, le=1_000_000)]
Beside = Literal["front", "beside", "back"]

SIDES: tuple[Beside, ...] = ("front", "beside", "back", "beside")
"""How the sides of a group are named, counter-clockwise from its front."""


class Distance(NamedTuple):
    """How far the middles of two groups of one room are apart: median and quartiles, metres;
    ``turns``, how many of them look the same way, a quarter turn apart and opposite ways."""

    first: str
    second: str
    median: Apart
    low: Apart
    high: Apart
    seen: Count
    turns: tuple[Count, Count, Count] = (0, 0, 0)


class Clearance(NamedTuple):
    """Free floor at a side of groups of a function: lower quartile and median, metres (at most
    three); the left and right side are one."""

    function: str
    side: Beside
    low: Depth
    median: Depth
    seen: Count


class Share(NamedTuple):
    """What share of a room of a function furniture covers: the room's area, the share, and the
    groups found in it."""

    function: str
    area: Floor
    share: Part
    groups: Annotated[tuple[str, ...], Field(max_length=100)] = ()


class Targets(NamedTuple):
    """Statistics of furnished rooms."""

    distances: tuple[Distance, ...]
    clearances: tuple[Clearance, ...]
    shares: tuple[Share, ...]
