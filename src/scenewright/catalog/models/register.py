"""Catalogues by name: a small folder a name under the user's data, with a path and a table.

``catalog.json`` there tells where the models are, ``catalog.csv`` what each is taken for; both may
be edited. The folder is ``$SCENEWRIGHT_HOME/catalogs``, else the usual place for user data.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import sys
from pathlib import Path

from scenewright.catalog.models import SIDECARS
from scenewright.catalog.models.files import MEBIBYTE, json_of, whole
from scenewright.core import atomic_file as whole_file
from scenewright.core.atomic_file import write_atomically
from scenewright.core.errors import InputError

PLAIN = r"[\w][\w.-]{0,63}"
TABLE, POINTER = SIDECARS


def home() -> Path:
    """The user's folder of catalogues."""
    given = os.environ.get("SCENEWRIGHT_HOME")
    if given:
        return Path(given) / "catalogs"
    if sys.platform == "win32":
        data = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        data = Path.home() / "Library" / "Application Support"
    else:
        data = Path(os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share")
    return data / "scenewright" / "catalogs"


def names() -> tuple[str, ...]:
    """The names of all registered catalogues."""
    folder = home()
    found = folder.iterdir() if folder.is_dir() else ()
    return tuple(sorted(one.name for one in found if (one / POINTER).is_file()))


def where(name: str) -> Path:
    """Where a registered catalogue's models are; InputError if there is none of that name."""
    pointer = home() / check_name(name) / POINTER
    if not pointer.is_file():
        known = ", ".join(names()) or "none yet: scenewright catalog add PATH"
        raise InputError(f"unknown file or catalogue '{name}'", f"registered are: {known}")
    try:
        path = json_of(whole(pointer, MEBIBYTE), "a catalogue's entry").get("path")
    except InputError as error:
        raise error.located(file=str(pointer)) from None
    if not isinstance(path, str) or not path:
        raise InputError("states no path", "register it again", file=str(pointer))
    return Path(path)


def table_file(name: str) -> Path:
    """The table of a registered catalogue."""
    return home() / check_name(name) / TABLE


def register(name: str, path: Path, table: str) -> Path:
    """Store where a catalogue is and its table; the folder that holds both."""
    folder = home() / check_name(name)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        write_atomically(folder / TABLE, table, own=True)
        pointer = json.dumps({"path": str(path.absolute())}, indent=1) + "\n"
        write_atomically(folder / POINTER, pointer, own=True)
    except OSError as error:
        raise InputError(
            f"cannot be written: {error.strerror}", "check file permissions", file=str(folder)
        ) from None
    return folder


def read_saved_files(name: str) -> dict[str, bytes]:
    """The files of a registered catalogue as they are, to be put back; none if there is none."""
    folder = home() / check_name(name)
    files = [folder / file for file in (TABLE, POINTER)]
    return {file.name: file.read_bytes() for file in files if file.is_file()}


def restore(name: str, files: dict[str, bytes]) -> None:
    """Put a registered catalogue back as it was; without files it is gone."""
    folder = home() / check_name(name)
    for file, content in files.items():
        with whole_file.atomic_write(folder / file, own=True) as partial:
            partial.write_bytes(content)
    if not files:
        shutil.rmtree(folder, ignore_errors=True)


def check_name(name: str) -> str:
    """A name that is fit for a folder; InputError otherwise."""
    if not re.fullmatch(PLAIN, name) or name in (".", ".."):
        raise InputError(
            f"'{name[:40]}' is not a valid name for a catalogue",
            "use letters, digits, dashes, dots",
        )
    return name
