"""A row of the table of verbs, and the keys that several verbs have."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

from scenewright.studio.people import EDIT
from scenewright.studio.shapes import Json

POSE: Json = {
    "type": "array",
    "items": {"type": "number"},
    "minItems": 3,
    "maxItems": 3,
    "description": "x, y in metres and the heading of the front in radians, from +x to the left",
}
AT: Json = {
    "type": "array",
    "items": {"type": "number"},
    "minItems": 2,
    "maxItems": 2,
    "description": "x, y in metres",
}
SEED: Json = {"type": "integer", "minimum": 0, "description": "another one, another answer"}
TEXT: Json = {"type": "string"}
NUMBER: Json = {"type": "integer", "minimum": 0, "description": "number of a layout"}


class Verb(NamedTuple):
    """What a verb does, in a sentence; its keys by JSON Schema; what does it; which keys it cannot
    do without; what one must be allowed; and whether it goes on after it has answered."""

    about: str
    keys: Mapping[str, Json]
    do: Callable[[Any, Json], Json | None]
    needed: tuple[str, ...] = ()
    right: str = EDIT
    goes_on: bool = False

    def schema(self) -> Json:
        """The JSON Schema of its keys."""
        keys = {"type": "object", "properties": dict(self.keys), "additionalProperties": False}
        return keys | ({"required": [*self.needed]} if self.needed else {})
