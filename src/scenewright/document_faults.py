"""What is wrong with a document, in our words: one line out of all that the models found."""

from __future__ import annotations

import json
from math import tau
from typing import Any

from pydantic import ValidationError

from scenewright.errors import InputError

RADIANS = "headings are radians, -6.283 to 6.283: 1.5708 is a quarter turn"
METRES = "lengths are metres"
KINDS = {
    "string_type": "a text in quotes",
    "float_type": "a number, without quotes",
    "int_type": "a whole number",
    "int_from_float": "a whole number",
    "bool_type": "true or false, without quotes",
    "list_type": "a list: [...]",
    "tuple_type": "a list: [...]",
    "dict_type": "an object: {...}",
    "model_type": "an object: {...}",
    "model_attributes_type": "an object: {...}",
    "finite_number": "a finite number",
}
"""What is wanted in place of a value of the wrong kind."""


def told(error: ValidationError) -> InputError:
    """The first error of a model in our words, and how many more there are.

    Where a value may be one or a list there is an error for each reading: the deepest counts.
    """
    errors = error.errors(include_url=False)
    places = [_place(one["loc"]) for one in errors]
    twins = [i for i, place in enumerate(places) if place.startswith(places[0])]
    best = max(twins, key=lambda i: len(places[i]))
    fault, remedy = _fault(errors[best])
    more = len(errors) - len(twins)
    return InputError(fault + f" (and {more} more)" * bool(more), remedy, place=places[best])


def _fault(error: Any) -> tuple[str, str]:
    kind, given, limits = error["type"], error.get("input"), error.get("ctx", {})
    if kind == "missing":
        return "is missing", "add it"
    if kind == "extra_forbidden":
        return "is not a known key", "correct its spelling or leave it out"
    if kind in ("too_short", "too_long"):
        return _length_fault(kind, error["loc"], limits)
    return f"{_shown(given)} is not possible", _wanted(kind, error["loc"], given, limits, error)


def _length_fault(kind: str, loc: tuple[int | str, ...], limits: Any) -> tuple[str, str]:
    """A list with too few or too many entries.

    >>> _length_fault("too_short", ("outline",), {"min_length": 3, "actual_length": 2})
    ('needs at least 3 corners, has 2', 'list more')
    """
    if kind == "too_short" and limits["actual_length"] == 0:
        return "is empty", "list at least one"
    things = "corners" if "outline" in loc[-1:] or "holes" in loc[-2:-1] else "entries"
    has = f"has {limits['actual_length'] or 'more'}"
    if kind == "too_short":
        return f"needs at least {limits['min_length']} {things}, {has}", "list more"
    return f"takes at most {limits['max_length']} {things}, {has}", "list fewer"


def _wanted(kind: str, loc: tuple[int | str, ...], given: Any, limits: Any, error: Any) -> str:
    """What to write instead."""
    if limits.get("le") == tau or limits.get("ge") == -tau:
        return RADIANS
    if kind in KINDS:
        asked = "ask" in loc[-2:-1] and isinstance(given, str)
        return f'write {{"group": {_shown(given)}}}' if asked else f"give {KINDS[kind]}"
    told = str(error["msg"]).removeprefix("Value error, ")
    expected = told.replace("Input should be", "it should be")
    in_metres = kind.startswith(("less_than", "greater_than")) and "size" in loc
    return expected[:1].lower() + expected[1:] + f" ({METRES})" * in_metres


def _shown(given: Any) -> str:
    text = json.dumps(given, ensure_ascii=False, default=str)
    return text if len(text) <= 40 else f"{text[:37]}..."


def _place(where: tuple[int | str, ...]) -> str:
    """``('rooms', 2, 'doors', 0, 'width')`` as ``rooms[2].doors[0].width``."""
    path = ""
    for part in where:
        if isinstance(part, int):
            path += f"[{part}]"
        elif "[" not in part:
            path += f".{part}"
    return path.removeprefix(".")
