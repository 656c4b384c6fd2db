"""The part of the brief that says what the building brings into a room: outlets and radiators."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from scenewright.core.brief.fields import Number, Point, StrictModel, Switch

OutletKind = Literal["power", "antenna", "data", "water"]


class OutletBrief(StrictModel):
    """A place on the room's outline where something is connected: a socket (``power``), an
    ``antenna`` or ``data`` socket, a tap with a drain (``water``).

    Where a room lists outlets of a kind, what needs one is drawn to within reach of it. That it
    stands farther off is reported; if any outlet of the kind is ``required`` it is a failure.
    """

    at: Point
    kind: OutletKind
    required: Switch = False
    id: str = ""


class RadiatorBrief(StrictModel):
    """A radiator on the room's outline; ``at`` is the middle of its back, ``z`` the height of its
    underside above the floor. What is closed does not stand before it."""

    at: Point
    width: Annotated[Number, Field(ge=0.1, le=10)] = 1.0
    height: Annotated[Number, Field(ge=0.05, le=3)] = 0.6
    depth: Annotated[Number, Field(ge=0.02, le=0.5)] = 0.1
    z: Annotated[Number, Field(ge=0, le=3)] = 0.1
    id: str = ""
