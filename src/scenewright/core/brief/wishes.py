"""The part of the brief that says what a household would like in a room, or would not have."""

from __future__ import annotations

from math import radians
from typing import Annotated, Literal

from pydantic import Field, model_validator

from scenewright.core.brief.fields import Number, StrictModel, Switch

Name = Annotated[str, Field(min_length=1, max_length=80)]

OPENINGS = ("window", "door")
"""Targets to face or keep away from, besides groups and kinds."""
NEAR, AWAY = 1.0, 2.0
"""Metres that ``near`` and ``away_from`` mean unless said."""
NEAREST = {"window": 1.2, "door": 1.2, "wall": 0.3, "corner": 0.3}
"""Metres within which a piece is ``by`` a window, a door or a wall, or in a corner."""
SIGHT = radians(30.0)
"""Angle off straight ahead within which a target is faced."""


class WishBrief(StrictModel):
    """One wish for a room. ``what`` is a furniture group (``desk``) or a kind of piece (``tv``).

    ``forbid`` keeps it out; otherwise it is wanted, beside what the room would hold anyway, and is
    to stand ``by`` a window, a door, a wall or in a corner, to ``face`` a window, a door or another
    group or kind, to be ``near`` another group or kind, at most ``metres`` away, or
    ``away_from`` one, a window or a door, at least ``metres`` (1 and 2 unless said). A desk faces
    what one sees over it. Where a wanted thing is ``required``, leaving it out is a failure.
    """

    what: Name
    forbid: Switch = False
    by: Literal["window", "corner", "door", "wall"] | None = None
    near: Name | None = None
    face: Name | None = None
    away_from: Name | None = None
    metres: Annotated[Number, Field(ge=0.1, le=20)] | None = None
    required: Switch = False

    @model_validator(mode="after")
    def _one_thing(self) -> WishBrief:
        if self.forbid and (self.by or self.near or self.face or self.away_from or self.required):
            raise ValueError("a forbidden piece has no place; give either forbid or a place")
        if self.what in (self.face, self.near, self.away_from):
            raise ValueError("a piece cannot face, be near or keep away from itself; name another")
        if self.near and self.away_from:
            raise ValueError("near and away_from share `metres`; write two wishes")
        return self

    @property
    def within(self) -> float:
        """Metres that ``near`` means."""
        return NEAR if self.metres is None else self.metres

    @property
    def beyond(self) -> float:
        """Metres that ``away_from`` means."""
        return AWAY if self.metres is None else self.metres
