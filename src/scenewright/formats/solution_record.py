"""The solution document as a model: what may stand in it, and what must hold together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from typing import Annotated, Any, Literal

from pydantic import Field, ValidationError, model_validator

from scenewright.core.brief import Brief
from scenewright.core.brief.domain_keys import is_brief
from scenewright.core.brief.fields import (
    BUILT_IN,
    Coordinate,
    FootprintOutline,
    Heading,
    Length,
    Number,
    StrictModel,
    Switch,
    Whole,
)
from scenewright.core.document_faults import to_input_error
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.registry import DEFAULT, domain_names, domain_of

FORMAT = "scenewright/solution"

Count = Annotated[Whole, Field(ge=0, le=2**63 - 1)]


class PieceRecord(StrictModel):
    """One placed object as written in the file; see :class:`scenewright.core.scene.Piece`."""

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
    footprint: FootprintOutline | None = None


class PatchRecord(StrictModel):
    """One functional area: box is centre x, centre y, heading, width, depth."""

    id: str
    space: str
    function: str
    box: tuple[Coordinate, Coordinate, Number, Length, Length]


class TermRecord(StrictModel):
    """What one term says of one item; ``cost`` is value times weight."""

    space: str
    item: str = ""
    term: str
    value: Number
    weight: Number
    cost: Number


class LeftOutRecord(StrictModel):
    """Something that was not placed, and why."""

    space: str
    what: str
    reason: str
    required: Switch


class SolutionRecord(StrictModel):
    """The whole document; ``made_by`` is the version of Scenewright that wrote it, ``seconds``
    stands in older files only."""

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
    credits: Annotated[list[dict[str, Any]], Field(max_length=100_000)] = []
    brief: Brief
    clutter: Literal["none", "some", "lived-in"] = "none"
    detail: Any = None

    @model_validator(mode="before")
    @classmethod
    def _by_domain(cls, document: Any) -> Any:
        """The keys only the brief's domain knows become its detail."""
        brief = document.get("brief") if isinstance(document, Mapping) else None
        name = brief.get("domain", DEFAULT) if isinstance(brief, Mapping) else DEFAULT
        model = domain_of(name).detail_model() if name in domain_names() else None
        if model is None or "detail" in document:
            return document
        own = {key: value for key, value in document.items() if key in model.model_fields}
        rest = {key: value for key, value in document.items() if key not in own}
        return rest | {"detail": model.model_validate(own)}


def check_document(
    document: object, known: tuple[Brief, Plan] | None = None
) -> tuple[SolutionRecord, Plan]:
    """A document as a record and the plan of its brief, or :class:`InputError` naming the place and
    the fault. A brief equal to the ``known`` one has that one's plan."""
    if not isinstance(document, Mapping) or document.get("format") != FORMAT:
        if is_brief(document):
            raise InputError("is not a solution but a brief", "arrange it first, with -o NAME.json")
        raise InputError(
            f'is not a solution: "format" must be "{FORMAT}"', "give what arrange wrote as .json"
        )
    if document.get("version") != 1:
        raise InputError(
            f"has version {str(document.get('version'))[:20]!r} of the solution format",
            "this Scenewright reads version 1",
        )
    try:
        record = SolutionRecord.model_validate(document)
    except ValidationError as error:
        raise to_input_error(error) from None
    except RecursionError:
        raise InputError("is nested too deeply", "give a solution file") from None
    same = known is not None and record.brief == known[0]
    plan = known[1] if known and same else domain_of(record.brief.domain).verb("plan")(record.brief)
    _check_names(record, plan)
    _check_sizes(record)
    return record, plan


def _check_sizes(record: SolutionRecord) -> None:
    """No piece is larger than a brief could ask for."""
    largest = domain_of(record.brief.domain).largest_piece
    for index, piece in enumerate(record.pieces):
        most = BUILT_IN if piece.category in ("partition", "curtain") else largest
        if max(piece.size) > most:
            fault = f"{max(piece.size):g} m is not possible"
            remedy = f"it should be at most {most:g} (lengths are metres)"
            raise InputError(fault, remedy, place=f"pieces[{index}].size")


def _check_names(record: SolutionRecord, plan: Plan) -> None:
    """Ids are unique and everything named exists."""
    known = Counter(piece.id for piece in record.pieces)
    if twice := [name for name, count in known.items() if count > 1]:
        raise InputError(f"several pieces have the id {twice[0]!r}", "give each its own")
    for index, piece in enumerate(record.pieces):
        if piece.space not in plan.names:
            fault = f"the brief has no room with the id {piece.space!r}"
            raise InputError(
                fault, f"use one of: {', '.join([*plan.names][:6])}", place=f"pieces[{index}].space"
            )
        if piece.on is not None and piece.on not in known:
            raise InputError(
                f"unknown piece {piece.on!r}",
                "name the piece it stands on, or null",
                place=f"pieces[{index}].on",
            )


def solution_schema() -> dict[str, Any]:
    """The JSON Schema of a solution, with the keys that only some domains' solutions have."""
    schema = SolutionRecord.model_json_schema()
    schema["properties"].pop("detail")
    schema["properties"]["brief"] = {"title": "Brief", "type": "object"}
    for name in domain_names():
        model = domain_of(name).detail_model()
        if model is not None:
            own = model.model_json_schema()
            schema["properties"] |= own["properties"]
            schema["$defs"] |= own.get("$defs", {})
    return schema
