"""The part of the brief that says what a household would like in a room, or would not have."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from scenewright.brief_fields import Model, Number, Switch

Name = Annotated[str, Field(min_length=1, max_length=80)]


class WishBrief(Model):
    """One wish for a room. ``what`` is a furniture group (``desk``) or a kind of piece (``tv``).

    ``forbid`` keeps it out; otherwise it is wanted, beside what the room would hold anyway, and is
    to stand ``by`` a window or in a corner, or ``near`` another group or kind, at most so many
    ``metres`` away. Where a wanted thing is ``required``, leaving it out is a failure.
    """

    what: Name
    forbid: Switch = False
    by: Literal["window", "corner"] | None = None
    near: Name | None = None
    metres: Annotated[Number, Field(ge=0.1, le=20)] = 1.0
    required: Switch = False

    @model_validator(mode="after")
    def _one_thing(self) -> WishBrief:
        if self.forbid and (self.by or self.near or self.required):
            raise ValueError("what is forbidden stands nowhere; say either forbid or by and near")
        return self
