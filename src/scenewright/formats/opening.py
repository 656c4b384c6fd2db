"""What is to be read: a file that is there, or a sample, and its format."""

from __future__ import annotations

import os
from difflib import get_close_matches
from importlib import resources
from pathlib import Path
from typing import NamedTuple

from scenewright.core.atomic_file import note_read
from scenewright.core.document_faults import check_text
from scenewright.core.errors import InputError
from scenewright.core.registry import Format
from scenewright.core.workspace import check_inside
from scenewright.formats.foreign import name_foreign
from scenewright.formats.table import domains, row_of

SAMPLE = "sample:"


class Opened(NamedTuple):
    """A file that is there, and the row of its format."""

    path: Path
    row: Format


def open_source(source: str | os.PathLike[str]) -> Opened:
    """The file of a name or of a sample (``sample:home-flat``), recorded as read by the run.

    Raises :class:`InputError` where there is none, or none that is read: one in the format of
    another program is named."""
    name = os.fspath(source)
    path = _find_sample(name) if name.startswith(SAMPLE) else Path(name)
    check_inside(path)
    if path.is_dir():
        raise InputError("is a folder", "add --batch for all in it")
    if not path.suffix and not path.exists():
        _refuse_bare_name(name)
    try:
        row = row_of(path, "reader")
    except InputError as error:
        raise name_foreign(path, error, by_suffix=True) from None
    check_text(name, "the name of a file")
    if not path.exists():
        raise InputError("there is no such file", "check the path")
    if not path.is_file():
        raise InputError("is not a file", "give the file itself")
    if not path.stat().st_size:
        raise InputError("is empty: 0 bytes", "save or export it again from its program")
    note_read(path)
    return Opened(path, row)


def samples() -> tuple[str, ...]:
    """Names of the sample briefs, as :func:`read` takes them.

    >>> "sample:home-flat" in samples()
    True
    """
    return tuple(sorted(SAMPLE + name for name in _sample_files()))


def _refuse_bare_name(name: str) -> None:
    """Raise the InputError of a name that is no file and has no suffix."""
    if f"{SAMPLE}{name}" in samples():
        raise InputError("is the name of a sample", f"say {SAMPLE}{name}")
    raise InputError("there is no such file or folder", "check the path")


def _find_sample(name: str) -> Path:
    stems = _sample_files()
    stem = name.removeprefix(SAMPLE)
    if stem not in stems:
        ordered = sorted(stems)
        near = get_close_matches(stem, ordered, 6, 0.5) or ordered[:: len(ordered) // 6]
        some = ", ".join(SAMPLE + other for other in near)
        raise InputError(
            "there is no such sample", f"use one of: {some}; all: scenewright list samples"
        )
    return stems[stem]


def _sample_files() -> dict[str, Path]:
    """The briefs in the folders ``samples`` of the domains, by name."""
    folders = [Path(str(resources.files(kind.package) / "samples")) for kind in domains()]
    return {file.stem: file for folder in folders for file in folder.glob("*.json")}
