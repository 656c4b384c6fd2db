"""The native brief: JSON, checked by the models of :mod:`scenewright.brief`.

A saved solution is read as a brief too: its locked pieces become fixed items.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from scenewright.brief import Brief
from scenewright.errors import InputError

GREATEST_FILE = 64 * 2**20
SOLUTION = "scenewright/solution"


def read(path: Path, keep: bool = False) -> Brief:
    """The brief in a JSON file. Its fixed items always stay, whatever ``keep`` says."""
    del keep
    if path.stat().st_size > GREATEST_FILE:
        raise InputError(
            f"is larger than {GREATEST_FILE // 2**20} MiB", "split it into several briefs"
        )
    return loads(path.read_bytes())


def loads(text: str | bytes) -> Brief:
    """The brief written in ``text`` (UTF-8 if bytes), or in the solution written there.

    >>> loads('{"rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}]}').rooms[0].outline[2]
    (4.0, 3.0)
    """
    document = _document(text)
    if document.get("format") == SOLUTION:
        from scenewright.formats import solution_json

        return solution_json.brief_of(document)
    try:
        return Brief.model_validate(document)
    except ValidationError as error:
        raise _told(error) from None


def dumps(brief: Brief) -> str:
    """The JSON text of a brief, without what is left at its default."""
    return brief.model_dump_json(indent=1, exclude_defaults=True) + "\n"


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a brief.

    >>> schema()["title"]
    'Brief'
    """
    draft = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    return draft | Brief.model_json_schema()


def _document(text: str | bytes) -> dict[str, Any]:
    try:
        plain = text.decode("utf-8-sig") if isinstance(text, bytes) else text
        document = json.loads(plain, parse_constant=_no_constant)
    except UnicodeDecodeError:
        raise InputError("is not UTF-8 text", "save it as UTF-8") from None
    except RecursionError:
        raise InputError("is nested too deeply", "give a brief") from None
    except json.JSONDecodeError as error:
        fault = "is empty" if not plain.strip() else f"broken JSON: {error.msg}"
        where = f"line {error.lineno}, column {error.colno}"
        raise InputError(fault, "correct the text there", place=where) from None
    except ValueError as error:
        raise InputError(f"broken JSON: {error}", "write plain finite numbers") from None
    if not isinstance(document, dict):
        raise InputError("holds no JSON object", 'give a brief: {"rooms": [...]}')
    return document


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is not a number")


def _told(error: ValidationError) -> InputError:
    """The first error of pydantic in our words, and how many more there are.

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
    kind, given = error["type"], error.get("input")
    if kind == "missing":
        return "is missing", "add it"
    if kind == "extra_forbidden":
        return "is not a known key", "correct its spelling or leave it out"
    if kind == "too_short" and isinstance(given, list) and error["ctx"]["min_length"] == 1:
        return "is empty", "list at least one"
    shown = json.dumps(given, ensure_ascii=False, default=str)
    shown = shown if len(shown) <= 40 else f"{shown[:37]}..."
    expected = error["msg"].replace("Input should", "it should")
    return f"{shown} is not possible", expected[:1].lower() + expected[1:]


def _place(where: tuple[int | str, ...]) -> str:
    """``('rooms', 2, 'doors', 0, 'width')`` as ``rooms[2].doors[0].width``."""
    told = ""
    for part in where:
        if isinstance(part, int):
            told += f"[{part}]"
        elif "[" not in part:
            told += f".{part}"
    return told.removeprefix(".")
