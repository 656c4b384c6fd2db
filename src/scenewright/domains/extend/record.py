"""What a solved extension adds to its file: the streets that were continued."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import Field

from scenewright.core.brief.fields import StrictModel
from scenewright.domains.extend.brief import StreetLine
from scenewright.ground.buildings.built import BuiltRoad


class ExtensionRecord(StrictModel):
    """The keys only solutions of extensions have: streets of the sources that run on."""

    continued: Annotated[list[StreetLine], Field(max_length=20_000)] | None = None


def detail_document(streets: tuple[BuiltRoad, ...]) -> dict[str, Any]:
    """The keys a solution of an extension adds to its document."""
    return {
        "continued": [
            {
                "name": road.name,
                "line": np.round(road.line, 4).tolist(),
                "width": road.width,
                "kind": road.kind,
            }
            for road in streets
        ]
    }


def detail_of(record: ExtensionRecord) -> tuple[BuiltRoad, ...] | None:
    """The streets that a document says were continued; ``None`` if it says nothing."""
    if record.continued is None:
        return None
    return tuple(
        BuiltRoad(np.array(row.line, float), row.width, row.kind, row.name)
        for row in record.continued
    )
