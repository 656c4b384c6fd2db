"""The native brief: JSON, checked by the models of :mod:`scenewright.core.brief`.

A saved solution is read as a brief too: its locked pieces become fixed items.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from scenewright.catalog.models.files import check_json
from scenewright.core.brief import Brief, brief_schema
from scenewright.core.brief.domain_keys import check_parts
from scenewright.core.document_faults import check_characters, to_input_error
from scenewright.core.errors import InputError
from scenewright.core.registry import domain_names, domain_of
from scenewright.formats.catalog_paths import resolve_paths

GREATEST_FILE = 64 * 2**20
MOST_PARSED = 256 * 2**20
"""Bytes a brief or solution may take once parsed; its models take about as many again."""
SOLUTION = "scenewright/solution"


def read(path: Path, keep: bool = False) -> Brief:
    """The brief in a JSON file, or that of a city model (CityJSON). Its fixed items always stay,
    whatever ``keep`` says."""
    del keep
    if path.stat().st_size > GREATEST_FILE:
        raise InputError(
            f"is larger than {GREATEST_FILE // 2**20} MiB", "split it into several briefs"
        )
    document = _document(path.read_bytes())
    for kind in map(domain_of, domain_names()):
        if document.get("type") in kind.documents:
            brief: Brief = kind.load(kind.documents[document["type"]])(document, path)
            return brief
    return _brief(document, path.parent)


def loads(text: str | bytes, folder: Path | None = None) -> Brief:
    """The brief written in ``text`` (UTF-8 if bytes), or in the solution written there; its
    catalogues are below ``folder``.

    >>> loads('{"rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}]}').rooms[0].outline[2]
    (4.0, 3.0)
    """
    return _brief(_document(text), folder or Path())


def _brief(raw: dict[str, Any], folder: Path) -> Brief:
    document = resolve_paths(raw, folder)
    if document.get("format") == SOLUTION:
        from scenewright.formats import solution_json

        return solution_json.brief_of(document)
    check_parts(document)
    try:
        return Brief.model_validate(document)
    except ValidationError as error:
        raise to_input_error(error, brief_schema) from None


def dumps(brief: Brief) -> str:
    """The JSON text of a brief, without what is left at its default."""
    document = brief.model_dump(mode="json", exclude_defaults=True)
    stated = {"route_width": brief.route_width, "name": brief.name}  # their default has two values
    return json.dumps(stated | document, indent=1, ensure_ascii=False) + "\n"


def schema() -> dict[str, Any]:
    """The JSON Schema (draft 2020-12) of a brief.

    >>> schema()["title"]
    'Brief'
    """
    draft = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    return draft | brief_schema()


def _document(text: str | bytes) -> dict[str, Any]:
    check_json(text.encode("utf-8", "replace") if isinstance(text, str) else text, MOST_PARSED)
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
    check_characters(document, plain)
    if not isinstance(document, dict):
        raise InputError("holds no JSON object", 'give a brief: {"rooms": [...]}')
    return document


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is not a number")
