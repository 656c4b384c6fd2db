"""Findings of the referee that the user accepts."""

from __future__ import annotations

import difflib
from typing import Annotated

from pydantic import Field, field_validator
from pydantic_core import PydanticKnownError

from scenewright.core.brief.fields import StrictModel
from scenewright.core.report import KINDS


class AcceptedFinding(StrictModel):
    """A finding of the referee that is accepted: its ``kind``, and the ``piece`` or other thing
    named in it (empty: any) and the ``space`` (empty: any) it is accepted for. The ``reason`` is
    shown with it."""

    kind: str
    piece: Annotated[str, Field(max_length=500)] = ""
    space: Annotated[str, Field(max_length=500)] = ""
    reason: Annotated[str, Field(min_length=1, max_length=400)]

    @field_validator("kind")
    @classmethod
    def _known(cls, kind: str) -> str:
        if kind not in KINDS:
            begun = [known for known in KINDS if known.startswith(kind)]
            near = begun or difflib.get_close_matches(kind, KINDS, 3) or KINDS
            expected = ", ".join(f"'{known}'" for known in near)
            raise PydanticKnownError("literal_error", {"expected": expected})
        return kind
