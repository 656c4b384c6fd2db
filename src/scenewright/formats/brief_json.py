"""The native brief: JSON, checked by the models of :mod:`scenewright.core.brief`.

A saved solution is read as a brief too: its locked pieces become fixed items.
"""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from scenewright.core.brief import Brief, brief_schema
from scenewright.core.brief.domain_keys import check_parts, is_brief
from scenewright.core.brief.own_report import report_changes
from scenewright.core.brief.units import suggest_for
from scenewright.core.brief.variations import scale_brief
from scenewright.core.document_faults import METRES, to_input_error
from scenewright.core.errors import InputError
from scenewright.core.registry import domain_names, domain_of
from scenewright.formats.catalog_paths import resolve_paths
from scenewright.formats.json_document import check_size, parse_document

SOLUTION = "scenewright/solution"


def read(path: Path, keep: bool = False, scale: float = 1.0) -> Brief:
    """The brief in a JSON file, or that of a city model (CityJSON), with its lengths in plan times
    ``scale``. Its fixed items always stay, whatever ``keep`` says."""
    del keep
    check_size(path, "split it into several briefs")
    document = _document(path.read_bytes())
    for kind in map(domain_of, domain_names()):
        if document.get("type") in kind.documents:
            brief: Brief = kind.load(kind.documents[document["type"]])(document, path)
            return scale_brief(brief, scale)
    return _brief(document, path.parent, scale)


def loads(text: str | bytes, folder: Path | None = None) -> Brief:
    """The brief written in ``text`` (UTF-8 if bytes), or in the solution written there; its
    catalogues are below ``folder``.

    >>> loads('{"rooms": [{"outline": [[0, 0], [4, 0], [4, 3]]}]}').rooms[0].outline[2]
    (4.0, 3.0)
    """
    return _brief(_document(text), folder or Path())


def _brief(raw: dict[str, Any], folder: Path, scale: float = 1.0) -> Brief:
    document = resolve_paths(raw, folder)
    if document.get("format") == SOLUTION:
        from scenewright.formats import solution_json

        return scale_brief(solution_json.brief_of(document), scale)
    check_parts(document)
    stated = document.get("scale", 1.0)
    try:
        if scale != 1.0 and "scale" not in document:
            brief = Brief.model_validate(document | {"scale": scale})
        else:
            brief = scale_brief(Brief.model_validate(document), scale)
        return report_changes(brief, document, scale * stated)
    except ValidationError as error:
        raise _with_unit(to_input_error(error, brief_schema), document) from None


def _with_unit(error: InputError, document: dict[str, Any]) -> InputError:
    """An error about a length that is too great with the scale that helps, if all are."""
    unit = suggest_for(document) if METRES in error.remedy else ""
    remedy = f"{error.remedy}: {unit}" if unit else error.remedy
    return InputError(error.fault, remedy, file=error.file, place=error.place)


def holds_brief(path: Path) -> bool:
    """Whether there is a JSON file that is meant as a brief: what somebody wrote by hand."""
    if path.suffix.lower() != ".json" or not path.is_file():
        return False
    try:
        check_size(path, "split it")
        document = parse_document(path.read_bytes(), "a brief")
    except (InputError, OSError):
        return False
    return is_brief(document)


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
    document = parse_document(text, "a brief")
    if not isinstance(document, dict):
        raise InputError("holds no JSON object", 'give a brief: {"rooms": [...]}')
    return document
