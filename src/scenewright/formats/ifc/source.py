"""The model a brief was read from: what is recorded of it, and how it is found again unchanged."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from scenewright.building.plan import room_ids
from scenewright.core.atomic_file import note_read
from scenewright.core.brief import Brief
from scenewright.core.brief.source_file import SourceFile
from scenewright.core.errors import InputError
from scenewright.formats.ifc.extract import EARLIER, GREATEST_FILE
from scenewright.formats.ifc.rooms import DrawnRoom, Row
from scenewright.text import quantity

ANEW = "furniture is planned anew (--keep keeps it)"
"""Why furniture of a model is left out."""


def record_source(
    brief: Brief, path: Path, document: Row, rooms: Sequence[DrawnRoom], move: np.ndarray
) -> SourceFile | None:
    """What is recorded of the model at ``path`` that a brief was read from; nothing of one that is
    zipped or of an earlier schema, to which nothing is added."""
    if path.suffix.lower() != ".ifc" or document["schema"].upper() in EARLIER:
        return None
    storeys = document["storeys"]
    found = list(zip(room_ids(brief), rooms, strict=True))
    rows = brief.input_report.rows if brief.input_report else ()
    return SourceFile(
        file=str(path.absolute()),
        sha256=_digest(path.read_bytes()),
        offset=(float(move[0]), float(move[1])),
        levels={lv.id: storeys[int(lv.id)]["number"] for lv in brief.levels if int(lv.id) >= 0},
        rooms={name: room.row["number"] for name, room in found if room.row},
        floors={name: round(room.low, 6) for name, room in found},
        items=[item.id for room in brief.rooms for item in room.fixed],
        unkept=sum(row.count for row in rows if row.reason == ANEW),
    )


def open_source_file(source: SourceFile) -> bytes:
    """The content of the model a brief was read from, which this run may not replace. Raises
    :class:`InputError` where it is gone or changed, or its furniture would stand among more."""
    path = Path(source.file)
    fault = f"was read from {path.name}, which"
    try:
        if path.stat().st_size > GREATEST_FILE or not path.is_file():
            raise OSError
        data = path.read_bytes()
    except (OSError, ValueError):
        remedy = f"put it back ({path}), or choose another format"
        raise InputError(f"{fault} is gone: furniture is added to that file", remedy) from None
    note_read(path)
    if _digest(data) != source.sha256:
        raise InputError(f"{fault} has changed since", "arrange that file again")
    if source.unkept:
        many = f"{quantity(source.unkept, 'piece')} of furniture"
        fault = f"{fault} holds {many} that the new would stand among"
        raise InputError(fault, "read it again with --keep")
    return data


def _digest(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
