"""The solution document as a model: what may stand in it, and what must hold together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError

from scenewright.brief import Brief
from scenewright.brief.fields import Coordinate, Heading, Length, Model, Number, Switch, Whole
from scenewright.document_faults import told
from scenewright.errors import InputError
from scenewright.formats.graph_record import GraphRecord, TourRecord
from scenewright.plan import space_names

FORMAT = "scenewright/solution"

Count = Annotated[Whole, Field(ge=0, le=2**63 - 1)]


class PieceRecord(Model):
    """One placed object as written in the file; see :class:`scenewright.scene.Piece`."""

    id: str
    category: str
    asset: str = ""
    space: str
    pose: tuple[Coordinate, Coordinate, Coordinate, Heading]
    size: tuple[Length, Length, Length]
    group: str = ""
    function: str = ""
    on: str | None = None
    fixed: Switch = False


class PatchRecord(Model):
    """One functional area: box is centre x, centre y, heading, width, depth."""

    id: str
    space: str
    function: str
    box: tuple[Coordinate, Coordinate, Number, Length, Length]


class TermRecord(Model):
    """What one term says of one item; ``cost`` is value times weight."""

    space: str
    item: str = ""
    term: str
    value: Number
    weight: Number
    cost: Number


class LeftOutRecord(Model):
    """Something that was not placed, and why."""

    space: str
    what: str
    reason: str
    required: Switch


class SolutionRecord(Model):
    """The whole document; ``made_by`` is the version of Scenewright that wrote it."""

    format: Literal["scenewright/solution"] = "scenewright/solution"
    version: Literal[1] = 1
    made_by: str = ""
    preset: str = "default"
    solver: str = ""
    seed: Whole = 0
    brief_hash: str = ""
    seconds: Annotated[Number, Field(ge=0)] = 0.0
    evaluations: Count = 0
    energies: dict[str, Number]
    pieces: Annotated[list[PieceRecord], Field(max_length=100_000)]
    patches: Annotated[list[PatchRecord], Field(max_length=100_000)]
    left_out: Annotated[list[LeftOutRecord], Field(max_length=100_000)]
    terms: Annotated[list[TermRecord], Field(max_length=1_000_000)]
    graph: GraphRecord | None = None
    tours: Annotated[list[TourRecord], Field(max_length=10_000)] = []
    credits: Annotated[list[dict[str, Any]], Field(max_length=100_000)] = []
    brief: Brief


def checked(document: object) -> SolutionRecord:
    """A document as a record, or :class:`InputError` naming the place and the fault."""
    if not isinstance(document, Mapping) or document.get("format") != FORMAT:
        raise InputError(f'is not a solution: "format" must be "{FORMAT}"')
    if document.get("version") != 1:
        raise InputError(
            f"has version {str(document.get('version'))[:20]!r} of the solution format",
            "this Scenewright reads version 1",
        )
    try:
        record = SolutionRecord.model_validate(document)
    except ValidationError as error:
        raise told(error) from None
    except RecursionError:
        raise InputError("is nested too deeply", "give a solution file") from None
    _check_names(record)
    return record


def _check_names(record: SolutionRecord) -> None:
    """Ids are unique and everything named exists."""
    known = Counter(piece.id for piece in record.pieces)
    rooms = set(space_names(record.brief))
    if twice := [name for name, count in known.items() if count > 1]:
        raise InputError(f"several pieces have the id {twice[0]!r}", "give each its own")
    for index, piece in enumerate(record.pieces):
        if piece.space not in rooms:
            fault = f"the brief has no room with the id {piece.space!r}"
            raise InputError(fault, place=f"pieces[{index}].space")
        if piece.on is not None and piece.on not in known:
            raise InputError(f"there is no piece {piece.on!r}", place=f"pieces[{index}].on")
