"""What a solved village adds to its file: the lanes that were laid into its blocks."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import Field

from scenewright.core.brief.fields import Number, Point, StrictModel
from scenewright.domains.village.lanes import VillageLane


class LaneRecord(StrictModel):
    """A lane in a block: its middle line, width and the radius of its turning head (0: none)."""

    block: Annotated[str, Field(max_length=200)]
    line: Annotated[list[Point], Field(min_length=2, max_length=5000)]
    width: Annotated[Number, Field(ge=0.5, le=60)]
    head: Annotated[Number, Field(ge=0, le=60)] = 0.0


class VillageRecord(StrictModel):
    """The keys only solutions of villages have: lanes laid into deep blocks."""

    laid: Annotated[list[LaneRecord], Field(max_length=20_000)] | None = None


def detail_document(lanes: tuple[VillageLane, ...]) -> dict[str, Any]:
    """The keys a solution of a village adds to its document."""
    rows = [lane._asdict() | {"line": np.round(lane.line, 3).tolist()} for lane in lanes]
    return {"laid": rows}


def detail_of(record: VillageRecord) -> tuple[VillageLane, ...] | None:
    """The lanes that a document says were laid; ``None`` if it says nothing."""
    if record.laid is None:
        return None
    return tuple(
        VillageLane(row.block, np.array(row.line, float), row.width, row.head)
        for row in record.laid
    )
