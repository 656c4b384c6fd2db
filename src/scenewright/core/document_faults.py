"""The fault of a document in one line, out of all that the models report."""

from __future__ import annotations

import difflib
import json
from collections.abc import Callable, Sequence
from math import tau
from typing import Any

from pydantic import ValidationError

from scenewright.core.errors import InputError
from scenewright.text import HALF, is_whole

RADIANS = "headings are radians, -6.283 to 6.283: 1.5708 is a quarter turn"
PITCH = "pitches are radians, 0.02 to 1.55: 0.7854 is 45 degrees"
METRES = "lengths are metres"
LENGTHS = frozenset(
    (
        "at",
        "clearance",
        "depth",
        "elevation",
        "end",
        "footprint",
        "going",
        "height",
        "holes",
        "knee",
        "length",
        "metres",
        "outer_wall_thickness",
        "outline",
        "passage_width",
        "route_width",
        "sill",
        "size",
        "sizes",
        "start",
        "thickness",
        "wall_thickness",
        "width",
        "z",
    )
)
"""Keys under which numbers are metres."""
MEANT = {"count": ("quantity", "number", "amount", "qty", "how_many")}
"""Keys, and what else they are called by sense, not by spelling."""
BROKEN = ("holds half of a surrogate pair, which is not a character", "whole Unicode characters")
"""The fault of a text that UTF-8 cannot hold, and the remedy."""
KINDS = {
    "string_type": "a text in quotes",
    "string_unicode": BROKEN[1],
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
"""The kind of value wanted in place of a wrong one."""
FILL = "it should be a share of the floor, from 0.05 to 0.8: half of it is 0.5"
PLAINLY = {
    "less than or equal to": "at most",
    "greater than or equal to": "at least",
    "greater than": "more than",
    "String should have": "it should have",
}


def to_input_error(
    error: ValidationError, schema: Callable[[], dict[str, Any]] | None = None
) -> InputError:
    """The first error of a model in our words, and how many more there are.

    Where a value may be one or a list there is an error for each reading: the deepest counts. A key
    that is not known comes before all else, with the nearest that the ``schema`` knows there: what
    is missing is most often misspelt.
    """
    errors = [one | {"loc": _shown_loc(one["loc"])} for one in error.errors(include_url=False)]
    errors.sort(key=lambda one: one["type"] != "extra_forbidden")
    places = [_place(one["loc"]) for one in errors]
    twins = [
        i
        for i, place in enumerate(places)
        if _within(place, places[0]) or _within(places[0], place)
    ]
    best = max(twins, key=lambda i: len(places[i]))
    fault, remedy = _fault(errors[best])
    if errors[best]["type"] == "extra_forbidden" and schema is not None:
        missing = _missing_beside(errors[best]["loc"], errors)
        remedy = _respelt(errors[best]["loc"], schema(), missing) or remedy
    more = len(errors) - len(twins)
    return InputError(fault + f" (and {more} more)" * bool(more), remedy, place=places[best])


def _shown_loc(loc: tuple[int | str, ...]) -> tuple[int | str, ...]:
    """A place as in the file, where the keys of a domain's part stand among the others."""
    return loc[1:] if loc[:1] == ("part",) and len(loc) > 1 else loc


def check_characters(document: Any, source: str) -> None:
    """Raise :class:`InputError` naming the place if a text or key of a JSON ``document``, parsed
    from ``source``, holds half of a surrogate pair.

    >>> check_characters({"rooms": [{"name": "\\ud800"}]}, '{"rooms": [{"name": "\\\\ud800"}]}')
    Traceback (most recent call last):
    scenewright.core.errors.InputError: rooms[0].name: holds half of a surrogate pair, which is \
not a character; give whole Unicode characters
    """
    if not HALF.search(source):
        return
    waiting: list[tuple[tuple[int | str, ...], Any]] = [((), document)]
    while waiting:
        place, value = waiting.pop()
        if isinstance(value, dict):
            waiting += [((*place, "its keys"), key) for key in value]
            waiting += [((*place, key), inside) for key, inside in value.items()]
        elif isinstance(value, list):
            waiting += [((*place, number), inside) for number, inside in enumerate(value)]
        elif isinstance(value, str) and not is_whole(value):
            raise InputError(BROKEN[0], f"give {BROKEN[1]}", place=_place(place))


def check_text(text: str, what: str) -> None:
    """Raise :class:`InputError` if a text that does not stand in a document is not whole Unicode.

    >>> check_text("\\udcff.json", "the name of a file")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    scenewright.core.errors.InputError: the name of a file is not valid Unicode: ...; rename it
    """
    if not is_whole(text):
        raise InputError(f"{what} is not valid Unicode: '{text}'", "rename it")


def _within(place: str, other: str) -> bool:
    return place == other or place.startswith((f"{other}.", f"{other}["))


def _missing_beside(loc: tuple[int | str, ...], errors: Sequence[Any]) -> list[str]:
    """The keys that are missing where a key stands that is not known."""
    return [
        str(one["loc"][-1])
        for one in errors
        if one["type"] == "missing" and one["loc"][:-1] == loc[:-1]
    ]


def _respelt(
    loc: tuple[int | str, ...], schema: dict[str, Any], missing: Sequence[str] = ()
) -> str:
    """What an unknown key was most likely meant to be: of those ``missing`` there the nearest, or
    the only one, else the one of this sense, else the nearest of all; empty if none is like it.

    >>> _respelt(("rooms", 0, "outlin"), {"properties": {"rooms": {"items": {"$ref": "#/$defs/R"}}},
    ...                                   "$defs": {"R": {"properties": {"outline": {}}}}})
    'did you mean "outline"?'
    """
    keys = _keys(loc[:-1], schema, schema["$defs"])
    near = difflib.get_close_matches(str(loc[-1]), missing, 1, 0.0 if len(missing) == 1 else 0.6)
    near = near or [key for key in keys if loc[-1] in MEANT.get(key, ())]
    near = near or difflib.get_close_matches(str(loc[-1]), keys, 1, 0.6)
    return f'did you mean "{near[0]}"?' if near else ""


def _keys(loc: Sequence[int | str], schema: dict[str, Any], defs: dict[str, Any]) -> list[str]:
    """The keys known at a place below a schema."""
    if "$ref" in schema:
        return _keys(loc, defs[schema["$ref"].rpartition("/")[2]], defs)
    if "anyOf" in schema:
        named = loc[1:] if loc and isinstance(loc[0], str) else loc
        ways = [(way, where) for way in schema["anyOf"] for where in dict.fromkeys((loc, named))]
        return [key for way, where in ways for key in _keys(where, way, defs)]
    if not loc:
        return list(schema.get("properties", ()))
    below = schema.get("items") if isinstance(loc[0], int) else None
    below = below or schema.get("properties", {}).get(loc[0], {})
    return _keys(loc[1:], below, defs)


def _fault(error: Any) -> tuple[str, str]:
    kind, given, limits = error["type"], error.get("input"), error.get("ctx", {})
    if kind == "missing":
        return "is missing", "list one more" if isinstance(error["loc"][-1], int) else "add it"
    if kind == "extra_forbidden":
        return "is not a known key", "correct its spelling or leave it out"
    if kind in ("too_short", "too_long"):
        return _length_fault(kind, error["loc"], limits)
    return f"{_quote_value(given)} is not possible", _describe_expected(
        kind, error["loc"], given, limits, error
    )


def _length_fault(kind: str, loc: tuple[int | str, ...], limits: Any) -> tuple[str, str]:
    """A list with too few or too many entries.

    >>> _length_fault("too_short", ("outline",), {"min_length": 3, "actual_length": 2})
    ('needs at least 3 corners, has 2', 'list more')
    """
    if kind == "too_short" and limits["actual_length"] == 0:
        return "is empty", "list at least one"
    things = (
        "corners" if {"outline", "footprint"} & {*loc[-1:]} or "holes" in loc[-2:-1] else "entries"
    )
    has = f"has {limits['actual_length'] or 'more'}"
    if kind == "too_short":
        return f"needs at least {limits['min_length']} {things}, {has}", "list more"
    return f"takes at most {limits['max_length']} {things}, {has}", "list fewer"


def _describe_expected(
    kind: str, loc: tuple[int | str, ...], given: Any, limits: Any, error: Any
) -> str:
    """The remedy: what to write instead."""
    if limits.get("le") == tau or limits.get("ge") == -tau:
        return RADIANS
    if loc[-1:] == ("pitch",) and limits:
        return PITCH
    if loc[-1:] == ("fill",) and limits:
        return FILL
    if kind in KINDS:
        asked = "ask" in loc[-2:-1] and isinstance(given, str)
        return f'write {{"group": {_quote_value(given)}}}' if asked else f"give {KINDS[kind]}"
    text = str(error["msg"]).removeprefix("Value error, ")
    expected = text.replace("Input should be", "it should be")
    for words, plainly in PLAINLY.items():
        expected = expected.replace(words, plainly)
    in_metres = kind.startswith("less_than") and not LENGTHS.isdisjoint(loc[-3:])
    in_metres |= kind.startswith("greater_than") and "size" in loc
    return expected[:1].lower() + expected[1:] + f" ({METRES})" * in_metres


def _quote_value(given: Any) -> str:
    text = json.dumps(given, ensure_ascii=False, default=str)
    return text if len(text) <= 40 else f"{text[:37]}..."


def _place(where: tuple[int | str, ...]) -> str:
    """``('rooms', 2, 'doors', 0, 'width')`` as ``rooms[2].doors[0].width``."""
    path = ""
    for part in where:
        if isinstance(part, int):
            path += f"[{part}]"
        elif "[" not in part and not part.startswith("constrained-") and not part.endswith("Brief"):
            path += f".{part}"
    return path.removeprefix(".")
