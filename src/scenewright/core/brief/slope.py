"""Slopes of a brief: ceilings that rise from a wall, as in an attic."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from scenewright.core.brief.fields import Height, Number, StrictModel, Whole


class SlopeBrief(StrictModel):
    """A ceiling that rises inwards from an outline edge (counted as listed, from 0), starting at
    the height ``knee`` of its knee wall, by an angle of ``pitch`` in radians."""

    edge: Annotated[Whole, Field(ge=0)]
    knee: Height = 1.0
    pitch: Annotated[Number, Field(ge=0.02, le=1.55)]
