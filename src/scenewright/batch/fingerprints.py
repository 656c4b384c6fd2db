"""What a file of a batch depends on beside itself: the catalogues and learned groups it names."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from scenewright.catalog.loading import Stamp, stamps_of
from scenewright.catalog.models.files import check_json
from scenewright.core.brief.catalog import CatalogBrief
from scenewright.core.errors import InputError
from scenewright.formats.catalog_paths import NAMED, absolute, resolve_paths

Look = Callable[[str], tuple[Stamp, ...]]

_MOST = 100_000_000
"""Bytes of a brief up to which it is looked at."""


def list_dependencies(source: str, further: tuple[str, ...]) -> tuple[str, ...]:
    """Paths of the catalogues and files of groups a brief depends on: its own, relative to its
    folder, and those named ``further`` for all of a batch, below the working folder.

    A file that is no such brief, or cannot be read, names none.
    """
    try:
        own = list(_named_in(Path(source)))
    except (OSError, ValueError, RecursionError):
        own = []
    return tuple(dict.fromkeys([*(absolute(path, Path.cwd()) for path in further), *own]))


def look(path: str) -> tuple[Stamp, ...]:
    """Name, time and size of every file of a catalogue, and of the tables that correct it; of a
    file of groups the same. Nothing for what is not there."""
    try:
        return stamps_of(CatalogBrief(path=path))
    except (InputError, OSError, ValueError):
        return ()


def _named_in(source: Path) -> Iterator[str]:
    if source.suffix.lower() != ".json" or not source.is_file() or source.stat().st_size > _MOST:
        return
    content = source.read_bytes()
    if not any(f'"{key}"'.encode() in content for key in NAMED):
        return
    try:
        check_json(content)
    except InputError:
        return
    document: Any = json.loads(content)
    if isinstance(document, dict):
        resolved = resolve_paths(document, source.parent)
        brief = resolved["brief"] if isinstance(resolved.get("brief"), dict) else resolved
        entries = [e for key in NAMED if isinstance(brief.get(key), list) for e in brief[key]]
        paths = [entry.get("path") if isinstance(entry, dict) else entry for entry in entries]
        yield from (path for path in paths if isinstance(path, str) and path)
