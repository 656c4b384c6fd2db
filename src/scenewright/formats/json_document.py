"""JSON that people hand in: not too large, UTF-8, one object of plain finite numbers."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any

from scenewright.catalog.models.files import check_json
from scenewright.core.document_faults import check_characters
from scenewright.core.errors import InputError

GREATEST_FILE = 64 * 2**20
MOST_PARSED = 256 * 2**20
"""Bytes a brief or solution may take once parsed; its models take about as many again."""


def check_size(path: Path, remedy: str) -> None:
    """InputError for a file larger than any brief or solution."""
    if path.stat().st_size > GREATEST_FILE:
        raise InputError(f"is larger than {GREATEST_FILE // 2**20} MiB", remedy)


def parse_document(text: str | bytes, wanted: str) -> Any:
    """The value a JSON text holds (UTF-8 if bytes); InputError, with line and column, for what is
    no such text. ``wanted`` is what to give instead.

    >>> parse_document('{"rooms": []}', "a brief")
    {'rooms': []}
    """
    check_json(text.encode("utf-8", "replace") if isinstance(text, str) else text, MOST_PARSED)
    try:
        plain = text.decode("utf-8-sig") if isinstance(text, bytes) else text
        document = json.loads(plain, parse_constant=_no_constant, object_pairs_hook=_pair_once)
    except UnicodeDecodeError:
        raise InputError("is not UTF-8 text", "save it as UTF-8") from None
    except RecursionError:
        raise InputError("is nested too deeply", f"give {wanted}") from None
    except json.JSONDecodeError as error:
        if not plain.strip():
            raise InputError("is empty", f"give {wanted}") from None
        where = f"line {error.lineno}, column {error.colno}"
        fault = f"broken JSON: {error.msg}"
        raise InputError(fault, "correct the text there", place=where) from None
    except InputError:
        raise
    except ValueError as error:
        raise InputError(f"broken JSON: {error}", "write plain finite numbers") from None
    check_characters(document, plain)
    return document


def _pair_once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object whose keys are all different: of two that are the same one would be lost."""
    found = dict(pairs)
    if len(found) < len(pairs):
        counts = Counter(key for key, _ in pairs)
        name = next(key for key in counts if counts[key] > 1)
        raise InputError(f'the key "{name[:40]}" is given twice in one object', "leave out one")
    return found


def _no_constant(name: str) -> float:
    raise ValueError(f"{name} is not a number")
