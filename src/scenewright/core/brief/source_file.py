"""The file a brief was read from, where results can be written into a copy of it."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from scenewright.core.brief.fields import Number, StrictModel, Whole

_Id = Annotated[str, Field(max_length=500)]
_Numbers = Annotated[dict[_Id, Whole], Field(max_length=10_000)]


class SourceFile(StrictModel):
    """Where the file is and what it held (``sha256``), so that a changed one is noticed.

    ``levels`` and ``rooms`` are the numbers that those of the brief, by their ids, have in the
    file, ``floors`` the heights of the floors of its rooms in metres, ``items`` the ids of fixed
    items that stand in it. Coordinates of the brief are those of the file less ``offset``, in
    metres. ``unkept`` counts furniture of the file that the brief leaves out: it would stand among
    what is added.
    """

    file: Annotated[str, Field(max_length=4096)]
    sha256: Annotated[str, Field(pattern="^[0-9a-f]{64}$")]
    offset: tuple[Number, Number] = (0.0, 0.0)
    levels: _Numbers = {}
    rooms: _Numbers = {}
    floors: Annotated[dict[_Id, Number], Field(max_length=10_000)] = {}
    items: Annotated[list[_Id], Field(max_length=100_000)] = []
    unkept: Annotated[Whole, Field(ge=0)] = 0
