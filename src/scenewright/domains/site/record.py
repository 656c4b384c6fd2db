"""Ground works of a solved site, as written in a solution file."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field

from scenewright.core.brief.fields import Number, Point, StrictModel, Whole
from scenewright.ground.works import GroundWorks, Pathway, PavedArea

Line = Annotated[list[Point], Field(min_length=2, max_length=5000)]
Ring = Annotated[list[Point], Field(min_length=3, max_length=5000)]


class PathwayRecord(StrictModel):
    """A lane, drive or walk: middle line and width in metres."""

    kind: Literal["lane", "drive", "walk"]
    width: Annotated[Number, Field(gt=0, le=100)]
    line: Line


class AreaRecord(StrictModel):
    """Ground set apart: outline in metres, parking bays, the id of the landmark it lies before."""

    kind: Literal["square", "forecourt", "parking", "court", "park"]
    outline: Ring
    bays: Annotated[Whole, Field(ge=0, le=100_000)] = 0
    about: Annotated[str, Field(max_length=500)] = ""


class WorksRecord(StrictModel):
    """The ground works of one site."""

    site: str
    pathways: Annotated[list[PathwayRecord], Field(max_length=100_000)] = []
    areas: Annotated[list[AreaRecord], Field(max_length=10_000)] = []


class DetailRecord(StrictModel):
    """The part of solutions of sites: lanes, walks and areas of each."""

    works: Annotated[list[WorksRecord], Field(max_length=100)] | None = None


def detail_document(works: tuple[GroundWorks, ...]) -> dict[str, Any]:
    """The keys a solution of sites adds to its document."""
    return {
        "works": [
            {
                "site": one.site,
                "pathways": [
                    path._asdict() | {"line": [list(point) for point in path.line]}
                    for path in one.pathways
                ],
                "areas": [
                    area._asdict() | {"outline": [list(point) for point in area.outline]}
                    for area in one.areas
                ],
            }
            for one in works
        ]
    }


def detail_of(record: DetailRecord) -> tuple[GroundWorks, ...] | None:
    """What a document says of the ground; ``None`` if it says nothing, as before 0.8."""
    if record.works is None:
        return None
    return tuple(
        GroundWorks(
            one.site,
            tuple(Pathway(p.kind, p.width, tuple(p.line)) for p in one.pathways),
            tuple(PavedArea(a.kind, tuple(a.outline), a.bays, a.about) for a in one.areas),
        )
        for one in record.works
    )
