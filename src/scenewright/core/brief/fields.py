"""The fields briefs are made of: numbers with their limits, points, outlines."""

from __future__ import annotations

from datetime import date
from math import tau
from typing import Annotated, Literal

from pydantic import AfterValidator, BaseModel, ConfigDict, Field
from pydantic_core import PydanticCustomError

from scenewright.core.errors import InputError
from scenewright.core.footprint import MOST_CORNERS, read_footprint

Number = Annotated[float, Field(strict=True, allow_inf_nan=False)]
Whole = Annotated[int, Field(strict=True)]
Switch = Annotated[bool, Field(strict=True)]
Coordinate = Annotated[Number, Field(ge=-1e4, le=1e4)]
FURNITURE = 30.0
"""Greatest side of a piece of furniture in metres, wherever one is read."""
BUILT_IN = 300.0
"""Greatest side of what is built into a room: a partition, a curtain."""
BUILDING = 500.0
"""Greatest side of a building in metres, wherever one is read."""

DAY = r"^(\d{4}-[01]\d-[0-3]\d)?$"
"""A day as ISO 8601 writes it, or none."""

Length = Annotated[Number, Field(gt=0, le=1e3)]
Side = Annotated[Number, Field(gt=0, le=FURNITURE)]
Storey = Annotated[Number, Field(gt=0, le=100)]
Height = Annotated[Number, Field(ge=0, le=100)]
Heading = Annotated[Number, Field(ge=-tau, le=tau)]
Clearance = Annotated[Number, Field(ge=0, le=20)]
Words = Annotated[str, Field(max_length=80)]
Hour = Literal["", "morning", "noon", "day", "dusk", "night"]
"""A time of day by what lights it; none is said where it is empty."""
Point = tuple[Coordinate, Coordinate]
Outline = Annotated[list[Point], Field(min_length=3, max_length=5000)]


def _check_footprint(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The corners, if they are those of a simple polygon."""
    try:
        read_footprint(points, 1.0, 1.0)
    except InputError as error:
        raise PydanticCustomError(
            "footprint", "give a simple polygon: this {error}", {"error": str(error)}
        ) from None
    return points


FootprintOutline = Annotated[
    list[Point], Field(min_length=3, max_length=MOST_CORNERS), AfterValidator(_check_footprint)
]
"""The outline of what a thing covers, x to its right and y to its front, stretched to its box."""


def _check_day(day: str) -> str:
    """A day of the calendar, or none.

    >>> _check_day("2026-02-28"), _check_day("")
    ('2026-02-28', '')
    """
    try:
        known = not day or (len(day) == 10 and bool(date.fromisoformat(day)))
    except ValueError:
        known = False
    if not known:
        raise PydanticCustomError("day", "write a day there is, as YYYY-MM-DD")
    return day


Day = Annotated[str, AfterValidator(_check_day), Field(json_schema_extra={"pattern": DAY})]


def is_left_out(value: object) -> bool:
    """Whether an optional key has no value and is not written."""
    return value is None


class StrictModel(BaseModel):
    """Immutable, and strict about names: an unknown key is a mistake worth telling. Texts are
    checked to be whole Unicode, which a text without any limit is not."""

    model_config = ConfigDict(frozen=True, extra="forbid", str_min_length=0)
