"""The brief of a drawing read by a process apart: openings that no wall has room for left out, and
the input report."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from scenewright.core.brief import Brief
from scenewright.core.brief.input_report import Fate, InputReport, report_input
from scenewright.core.document_faults import to_input_error
from scenewright.core.errors import InputError

OPENING, MOST_MISFITS = re.compile(r"rooms\[(\d+)\].*?(doors|windows)\[(\d+)\]"), 60
"""How a fault names an opening, and how many are taken out."""


def brief_of(found: dict[str, Any], path: Path, format_name: str) -> Brief:
    """The brief of a document that :func:`scenewright.building.drawn.plan.plan_sheet` made.

    Raises :class:`InputError` where its rooms make no brief.
    """
    document = {"name": path.stem[:80], "levels": found["levels"], "rooms": found["rooms"]}
    misfits = _drop_misfits(document)
    report = _report(found, [*misfits, *_kept_openings(document)], format_name)
    try:
        return Brief.model_validate(document | {"input_report": report.model_dump()})
    except ValidationError as error:
        raise to_input_error(error) from None


def _drop_misfits(document: dict[str, Any]) -> list[Fate]:
    """Take out the openings that no wall has room for, as the plan of the brief finds them; their
    fates."""
    from scenewright.domains import plan_of

    fates = []
    for _ in range(MOST_MISFITS):
        try:
            plan_of(Brief.model_validate(document))
            break
        except InputError as error:
            place = OPENING.search(error.place)
            if place is None:
                raise
            room, kind, number = int(place[1]), place[2], int(place[3])
            del document["rooms"][room][kind][number]
            fates.append(Fate(f"in room {room + 1}", kind[:-1], "left out", error.fault))
        except ValidationError as error:
            raise to_input_error(error) from None
    return fates


def _kept_openings(document: dict[str, Any]) -> Iterator[Fate]:
    for room in document["rooms"]:
        for kind in ("doors", "windows"):
            yield from [Fate(room["name"], kind[:-1], "used")] * len(room[kind])


def _report(found: dict[str, Any], openings: list[Fate], format_name: str) -> InputReport:
    """What became of every entity, and how much of the floor within the walls was read."""
    entities = [Fate(*row[:4]) for row in found["fates"] for _ in range(row[4])]
    return report_input(
        [*entities, *openings],
        format=format_name,
        unit=found["unit"],
        drawn_floor=found["drawn_floor"],
        read_floor=found["read_floor"],
    )
