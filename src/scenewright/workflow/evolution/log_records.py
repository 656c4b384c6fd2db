"""What the entries of a log may say: models of every kind, checked when a log is read."""

from __future__ import annotations

import json
import zlib
from collections.abc import Collection, Sequence
from typing import Annotated, Any

from pydantic import Field, TypeAdapter

from scenewright.core.breeding import Gene, Genome
from scenewright.core.brief.fields import StrictModel, Switch, Whole
from scenewright.core.errors import InputError
from scenewright.core.stored_file import MEBIBYTE
from scenewright.engine.preference.events import event_of
from scenewright.workflow.evolution.population import BreedingPlan

LARGEST_DOCUMENT = 32 * MEBIBYTE
"""Bytes of a solution once unpacked, at most."""
REMEDY = "start a new one"

Count = Annotated[Whole, Field(ge=0, le=1_000_000)]
Share = Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)]
Figure = Annotated[float, Field(ge=-1e12, le=1e12, allow_inf_nan=False)]


class ScreenRecord(StrictModel):
    """A screen that was shown."""

    screen: Count
    shown: Annotated[list[Count], Field(min_length=1, max_length=100)]
    predicted: Annotated[list[Figure | None], Field(max_length=100)]
    wide: Count = 0


class AutoRecord(StrictModel):
    """Generations that were bred without asking."""

    screen: Count


class BredRecord(StrictModel):
    """What a candidate is made of."""

    genome: Annotated[list[Count], Field(max_length=10_000)]
    values: Annotated[list[Figure], Field(min_length=1, max_length=10_000)]
    lacking: Count
    valid: Switch


class AboutRecord(StrictModel):
    """What an evolution is of."""

    brief: str
    seed: Annotated[str, Field(pattern=r"^\d{1,18}$")]
    source: str = ""
    breeding: str
    form: str
    method: Annotated[str, Field(pattern=r"^[a-z-]{0,20}$")] = ""


class BreedingRecord(StrictModel):
    """The numbers of a :class:`BreedingPlan`."""

    first: Annotated[Whole, Field(ge=1, le=1000)]
    each: Annotated[Whole, Field(ge=1, le=1000)]
    alleles: Annotated[Whole, Field(ge=1, le=1000)]
    more: Annotated[Whole, Field(ge=0, le=1000)]
    fresh: Share
    mutated: Annotated[float, Field(ge=0, le=1000, allow_inf_nan=False)]
    crossed: Share
    parents: Annotated[Whole, Field(ge=1, le=1000)]
    rounds: Annotated[Whole, Field(ge=0, le=100)]
    brood: Annotated[Whole, Field(ge=1, le=1000)]
    hope: Annotated[float, Field(ge=-10, le=10, allow_inf_nan=False)]


def read_breeding(text: str) -> BreedingPlan:
    """The breeding plan a log was begun with.

    >>> read_breeding(json.dumps(BreedingPlan())) == BreedingPlan()
    True
    """
    given = TypeAdapter(list[float]).validate_json(text)
    if len(given) != len(BreedingPlan._fields):
        raise InputError("is damaged: its breeding plan is not whole", REMEDY)
    plain = [int(value) if value == int(value) else value for value in given]
    record = BreedingRecord.model_validate(dict(zip(BreedingPlan._fields, plain, strict=True)))
    return BreedingPlan(**dict(record))


def read_body(kind: str, body: str) -> dict[str, Any]:
    """What an entry of some kind says; InputError or ValidationError where it says nothing that
    can be meant."""
    if kind == "event":
        record = json.loads(body)
        if not isinstance(record, dict):
            raise InputError("is damaged: an event is no object", REMEDY)
        event_of(record)
        return record
    if kind == "auto":
        return AutoRecord.model_validate_json(body).model_dump()
    if kind == "screen":
        return _screen(ScreenRecord.model_validate_json(body))
    raise InputError(f"is damaged: it holds an entry of kind '{kind[:20]}'", REMEDY)


def _screen(record: ScreenRecord) -> dict[str, Any]:
    if len(record.predicted) != len(record.shown) or len(set(record.shown)) < len(record.shown):
        raise InputError("is damaged: a screen is not whole", REMEDY)
    return record.model_dump()


def read_bred(body: str) -> dict[str, Any]:
    """What a candidate is made of."""
    return BredRecord.model_validate_json(body).model_dump()


def check_order(numbers: Sequence[int], what: str) -> None:
    """InputError unless rows are numbered 0, 1, 2 …"""
    if list(numbers) != list(range(len(numbers))):
        raise InputError(f"is damaged: its {what} are not numbered one by one", REMEDY)


def check_known(numbers: Collection[int], count: int) -> None:
    """InputError unless all numbers are those of ``count`` candidates."""
    if any(not 0 <= number < count for number in numbers):
        raise InputError("is damaged: it speaks of candidates it does not hold", REMEDY)


def check_epochs(epochs: Collection[str], count: int) -> None:
    """InputError unless the names of epochs are locks, each with one of ``count`` candidates.

    >>> check_epochs({"", "0:sofa", "0:sofa;1:bed"}, 2)
    """
    for epoch in filter(None, epochs):
        parts = [part.partition(":") for part in epoch.split(";")]
        if len(epoch) > 100_000 or not all(
            number.isdecimal() and len(number) < 8 and int(number) < count and name
            for number, _, name in parts
        ):
            raise InputError(f"is damaged: '{epoch[:40]}' is no epoch", REMEDY)


def check_genome(genome: Genome, genes: Sequence[Gene]) -> None:
    """InputError unless a genome chooses one of the alleles of every gene.

    >>> check_genome((0, 1), (Gene("desk", 2), Gene("bed", 2)))
    """
    whole = len(genome) == len(genes)
    if not whole or any(not 0 <= a < g.alleles for a, g in zip(genome, genes, strict=True)):
        raise InputError("is damaged, or of another version: a genome does not fit", REMEDY)


def unpack_document(packed: bytes) -> str:
    """The text of a packed solution; InputError for one that unpacks to more than
    :data:`LARGEST_DOCUMENT` bytes.

    >>> unpack_document(zlib.compress(b"{}"))
    '{}'
    """
    machine = zlib.decompressobj()
    content = machine.decompress(packed, LARGEST_DOCUMENT)
    if machine.unconsumed_tail or not machine.eof:
        raise InputError("is damaged: a solution is not whole or too large", REMEDY)
    return content.decode()
