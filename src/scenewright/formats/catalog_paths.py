"""Catalogues, learned groups, styles and the source file a brief names relative to its own file, as
absolute paths."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from scenewright.core.workspace import check_inside, is_confined

Json = dict[str, Any]

NAMED = ("catalogs", "groups", "sources")
"""Fields of a brief that hold paths."""
HEIGHTS = ("contours", "raster")
"""Fields of its terrain that do."""
STYLE = ".npz"
"""How the style or networks of a brief end where they are a file that was learned."""


def resolve_paths(document: Json, folder: Path) -> Json:
    """A brief or solution whose ``catalogs``, ``groups``, ``source_file``, ``terrain``, and
    ``style`` and ``nets`` where they are files, are absolute; what is no text stays.

    A plain name that is no file in ``folder`` stays a name: it may be registered.
    """
    if isinstance(document.get("brief"), dict):
        return document | {"brief": resolve_paths(document["brief"], folder)}
    for key in ("style", "nets"):
        learned = document.get(key)
        if isinstance(learned, str) and learned.endswith(STYLE):
            document = document | {key: absolute(learned, folder)}
    source = document.get("source_file")
    if isinstance(source, dict) and isinstance(source.get("file"), str):
        named = source | {"file": absolute(source["file"], folder)}
        document = document | {"source_file": named}
    terrain = document.get("terrain")
    if isinstance(terrain, dict):
        files = {k: terrain[k] for k in HEIGHTS if isinstance(terrain.get(k), str)}
        stated = {k: absolute(file, folder) for k, file in files.items()}
        document = document | {"terrain": terrain | stated}
    listed = {key: document[key] for key in NAMED if isinstance(document.get(key), list)}
    return document | {
        key: [_resolve_entry(entry, folder) for entry in entries] for key, entries in listed.items()
    }


def absolute(path: str, folder: Path) -> str:
    """A path below ``folder``, unless it is absolute already or but a name that is not there; in a
    workspace names of registered catalogues mean nothing."""
    whole = folder / path
    check_inside(whole)
    plain = Path(path).name == path and not Path(path).suffix and not is_confined()
    return path if plain and not whole.exists() else str(whole.absolute())


def absolute_names(
    catalogs: Sequence[str], groups: Sequence[str], style: str
) -> tuple[list[str], list[str], str]:
    """Catalogues, learned groups and a style as named on the command line, below the working
    folder."""
    here = Path.cwd()
    more, learned = ([absolute(path, here) for path in paths] for paths in (catalogs, groups))
    return more, learned, absolute(style, here) if style.endswith(STYLE) else style


def _resolve_entry(entry: object, folder: Path) -> object:
    if isinstance(entry, dict) and isinstance(entry.get("path"), str):
        return entry | {"path": _resolve_entry(entry["path"], folder)}
    return absolute(entry, folder) if isinstance(entry, str) and entry else entry
