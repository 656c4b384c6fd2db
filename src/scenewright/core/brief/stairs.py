"""The part of the brief that says where stairs lead from one level to another."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from scenewright.core.brief.fields import Heading, Number, Point, StrictModel

Name = Annotated[str, Field(max_length=80)]


class StairsBrief(StrictModel):
    """Stairs between two levels; steps, rise and going follow from the levels' elevations.

    ``at`` is the middle of the lowest step's front edge and ``heading`` the way one goes up
    there. ``level`` is the id of the lower level (the first, if left out), ``to`` of the upper
    (the next above). ``shape`` is straight, a quarter turn (L) or a half turn (U) with a
    landing, or a spiral; all but straight ones ``turn`` left or right as one goes up. ``width``
    is that of the steps in metres, ``going`` their depth, where the comfortable one (0.63 m less
    two rises) is not wanted.
    """

    at: Point
    heading: Heading
    level: Name = ""
    to: Name = ""
    shape: Literal["straight", "quarter", "half", "spiral"] = "straight"
    turn: Literal["left", "right"] = "left"
    width: Annotated[Number, Field(ge=0.5, le=4)] = 0.9
    going: Annotated[Number, Field(ge=0.15, le=0.5)] | None = None
    id: Name = ""
    name: Name = ""
