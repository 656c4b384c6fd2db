"""The terrain of a brief: how high its ground lies, and the water on it."""

from __future__ import annotations

from typing import Annotated, Self

import numpy as np
from pydantic import Field, model_validator

from scenewright.core.brief.catalog import PathText
from scenewright.core.brief.fields import Number, Outline, StrictModel, Words, is_left_out
from scenewright.core.space import Points

Level = Annotated[Number, Field(ge=-1e4, le=1e4)]
Place = Annotated[Number, Field(ge=-1e9, le=1e9)]


class Water(StrictModel):
    """A river or lake: its ``outline``, and the ``level`` of its surface in metres (left out: that
    of the lowest ground along it)."""

    name: Words = ""
    outline: Outline
    level: Annotated[Level | None, Field(exclude_if=is_left_out)] = None


BANK = 3.0
"""Metres beside water that are not built on."""


class TerrainBrief(StrictModel):
    """Ground that is not flat: one of a ``slope`` (metres of fall a metre, at most 0.5) that falls
    ``towards`` a bearing in degrees, clockwise from north; ``contours``, a GeoJSON file of lines
    with heights; and a ``raster`` of heights, an ESRI ASCII grid or a GeoTIFF. Files are in metres,
    ``at`` the map's coordinates of (0, 0) of the brief. ``water`` is level, and nothing is built on
    it."""

    slope: Annotated[Number, Field(ge=0, le=0.5)] | None = None
    towards: Annotated[Number, Field(ge=-360, le=360)] = 180.0
    contours: PathText | None = None
    raster: PathText | None = None
    at: Annotated[tuple[Place, Place] | None, Field(exclude_if=is_left_out)] = None
    water: Annotated[list[Water], Field(max_length=200)] = []

    @model_validator(mode="after")
    def _is_one(self) -> Self:
        stated = (self.slope is not None, self.contours is not None, self.raster is not None)
        if sum(stated) > 1:
            raise ValueError("Give one of slope, contours and raster")
        return self


def list_waters(terrain: TerrainBrief | None) -> tuple[Points, ...]:
    """The outlines (n, 2) of the water of a terrain."""
    rows = terrain.water if terrain else ()
    return tuple(np.array(row.outline, float) for row in rows)
