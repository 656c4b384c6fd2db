"""The tags of a feature of a map as plain short text, however an exporter nests them."""

from __future__ import annotations

import json
import re
from typing import Any

LONGEST_TEXT, LONGEST_TAGS = 120, 20_000
HSTORE = re.compile(r'"((?:[^"\\]|\\.)*)"\s*=>\s*"((?:[^"\\]|\\.)*)"')


def tags_of(row: dict[str, Any]) -> dict[str, str]:
    """Tags as plain short text; nested ones first, whether an object (``tags``) or the text of
    one, as GDAL writes ``other_tags``."""
    properties = row.get("properties")
    if not isinstance(properties, dict):
        return {}
    listed = dict(properties)
    for key in ("other_tags", "all_tags", "tags"):
        nested = listed.pop(key, None)
        listed |= nested if isinstance(nested, dict) else _tags_in_text(nested)
    return {
        str(key)[:LONGEST_TEXT]: plain(value)
        for key, value in listed.items()
        if isinstance(value, str | int | float) and not isinstance(value, bool)
    }


def _tags_in_text(text: Any) -> dict[str, Any]:
    """Tags written as one text: hstore of PostgreSQL, or a JSON object.

    >>> _tags_in_text('"building"=>"school","name"=>"St. \\\\"Anna\\\\""')
    {'building': 'school', 'name': 'St. "Anna"'}
    """
    if not isinstance(text, str):
        return {}
    if text.lstrip().startswith("{"):
        try:
            found = json.loads(text)
        except (ValueError, RecursionError):
            return {}
        return found if isinstance(found, dict) else {}
    pairs = HSTORE.findall(text[:LONGEST_TAGS])
    return {_unescaped(key): _unescaped(value) for key, value in pairs}


def _unescaped(text: str) -> str:
    return re.sub(r"\\(.)", r"\1", text)


def plain(value: object) -> str:
    """Text on one line, without control characters, of at most 120 letters.

    >>> plain("Caf\\u00e9\\n du  Nord")
    'Café du Nord'
    """
    text = str(value)[: 4 * LONGEST_TEXT]
    if not text.isprintable():
        text = "".join(c if c.isprintable() else " " for c in text)
    return " ".join(text.split())[:LONGEST_TEXT]
