"""Catalogues a brief names relative to its own file, as absolute paths; and back."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from scenewright.brief import Brief

Json = dict[str, Any]


def resolved(document: Json, folder: Path) -> Json:
    """A brief or solution whose ``catalogs`` are absolute; what is no text stays as it is.

    A plain name that is no file in ``folder`` stays a name: it may be registered.
    """
    if isinstance(document.get("brief"), dict):
        return document | {"brief": resolved(document["brief"], folder)}
    listed = document.get("catalogs")
    if not isinstance(listed, list):
        return document
    return document | {"catalogs": [_mapped(entry, folder) for entry in listed]}


def absolute(path: str, folder: Path) -> str:
    """A path below ``folder``, unless it is absolute already or but a name that is not there."""
    whole = folder / path
    plain = Path(path).name == path and not Path(path).suffix
    return path if plain and not whole.exists() else str(whole.absolute())


def with_catalogs(brief: Brief, catalogs: Sequence[str]) -> Brief:
    """A brief with further catalogues, below the working folder."""
    more = [absolute(path, Path.cwd()) for path in catalogs]
    return brief.model_copy(update={"catalogs": [*brief.catalogs, *more]}) if more else brief


def _mapped(entry: object, folder: Path) -> object:
    if isinstance(entry, dict) and isinstance(entry.get("path"), str):
        return entry | {"path": _mapped(entry["path"], folder)}
    return absolute(entry, folder) if isinstance(entry, str) and entry else entry
