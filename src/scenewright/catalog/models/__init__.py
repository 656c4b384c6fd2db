"""Model files in: one file a format, found by suffix.

A row says which suffix a module reads; the module has ``read(content, stem, beside, options)``
that yields :class:`.model.Found` (or :class:`.model.Skipped`) models, in the file's own axes and
units. Whatever is wrong with a file becomes one :class:`InputError`; in a library the file is
skipped and the reason kept.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from importlib import import_module
from pathlib import Path
from typing import NamedTuple

from scenewright.catalog.models.conversions import CONVERSIONS, conversion_of
from scenewright.catalog.models.files import MEBIBYTE, beside, whole
from scenewright.catalog.models.model import (
    ImportOptions,
    Model,
    RawModel,
    SkippedModel,
    clean,
    set_up,
)
from scenewright.core.errors import InputError
from scenewright.text import is_whole

USUAL = ImportOptions()
SIDECARS = ("catalog.csv", "catalog.json")
"""Tables that lie among models and tell about them."""
MOST_MODELS = 5000
MOST_ENTRIES = 100_000
MOST_IN_ALL = 8_000_000
"""Triangles of a whole library."""


class ModelFormat(NamedTuple):
    """A suffix, what it is, the module that reads it and the greatest size of a file."""

    suffix: str
    about: str
    reader: str
    most_bytes: int


ROWS = (
    ModelFormat(".obj", "Wavefront OBJ with its .mtl", "obj", 128 * MEBIBYTE),
    ModelFormat(".glb", "binary glTF 2.0", "gltf", 256 * MEBIBYTE),
    ModelFormat(".gltf", "glTF 2.0", "gltf", 32 * MEBIBYTE),
    ModelFormat(".json", "CityJSON 0.8 to 2.0", "cityjson", 128 * MEBIBYTE),
    ModelFormat(".cityjson", "CityJSON 0.8 to 2.0", "cityjson", 128 * MEBIBYTE),
    ModelFormat(".jsonl", "CityJSON, a building a line", "cityjson", 128 * MEBIBYTE),
    ModelFormat(".stl", "STL, binary or text", "stl", 256 * MEBIBYTE),
    ModelFormat(".sh3f", "Sweet Home 3D furniture library", "sh3f", 512 * MEBIBYTE),
)


class LibraryReport(NamedTuple):
    """What a file or folder holds: models sorted by id, and what was skipped and why."""

    models: tuple[Model, ...]
    skipped: tuple[SkippedModel, ...]


def library(path: str | os.PathLike[str], options: ImportOptions = USUAL) -> tuple[Model, ...]:
    """The models of a file or folder (see :func:`report`); InputError if there are none."""
    found = report(path, options)
    if not found.models:
        first, more = found.skipped[:1], len(found.skipped) - 1
        text = f"{first[0].name}: {first[0].reason}" if first else "there are no model files"
        fault = f"holds no usable model ({text})" + f" and {more} more" * (more > 0)
        raise InputError(fault, f"give one of: {', '.join(suffixes())}", file=str(path))
    return found.models


def report(path: str | os.PathLike[str], options: ImportOptions = USUAL) -> LibraryReport:
    """Every model of a file, or of a folder and those below it; broken ones are listed.

    Links are not followed. Of models of the same name the later ones get a number.
    """
    top = Path(path)
    if not top.exists():
        raise InputError("there is no such file or folder", "check the path", file=str(path))
    models: list[Model] = []
    skipped: list[SkippedModel] = []
    for file, fault in _files(top):
        taken = [fault] if fault else _taken(file, str(file.relative_to(top)), options)
        _sort(taken, models, skipped)
    return LibraryReport(
        tuple(sorted(_make_names_unique(models), key=lambda m: m.id)), tuple(skipped)
    )


def load(path: str | os.PathLike[str], options: ImportOptions = USUAL) -> Model:
    """The one model of a file; InputError if it cannot be used or holds several."""
    found = list(_of_file(Path(path), options))
    for one in found:
        if isinstance(one, SkippedModel):
            raise InputError(one.reason, file=str(path), place=one.name)
    if len(found) != 1 or not isinstance(found[0], Model):
        raise InputError(f"holds {len(found)} models", "give a file of one", file=str(path))
    return found[0]


def suffixes() -> tuple[str, ...]:
    """The suffixes of files that can be read.

    >>> ".glb" in suffixes()
    True
    """
    return tuple(row.suffix for row in ROWS)


def _files(top: Path) -> Iterator[tuple[Path, SkippedModel | None]]:
    """Model files below a folder (or the file itself), in order; and what is no plain file."""
    if not top.is_dir():
        yield top, None
        return
    seen = 0
    for folder, below, names in os.walk(top):
        below.sort()
        seen += len(names) + len(below)
        if seen > MOST_ENTRIES:
            raise InputError(
                f"holds more than {MOST_ENTRIES:,} files", "give a smaller folder", file=str(top)
            )
        for name in sorted(names):
            file = Path(folder, name)
            suffix = file.suffix.lower()
            if (suffix in suffixes() or suffix in CONVERSIONS) and name not in SIDECARS:
                shown = clean(str(file.relative_to(top)), "unnamed")
                fault = _unusable(file, name)
                yield file, SkippedModel(shown, fault) if fault else None


def _unusable(file: Path, name: str) -> str:
    """Why a file is passed over unread; empty if it is not."""
    if not is_whole(name):
        return "its name is not valid Unicode"
    if file.suffix.lower() in CONVERSIONS:
        return str(_unread(file.suffix.lower()))
    return "" if file.is_file() and not file.is_symlink() else "is a link or no plain file"


def _taken(file: Path, name: str, options: ImportOptions) -> Iterator[Model | SkippedModel]:
    """The models of a file of a library; a fault ends it."""
    try:
        yield from _of_file(file, options)
    except InputError as error:
        yield SkippedModel(clean(name if name != "." else file.name, "unnamed"), _reason(error))


def _of_file(file: Path, options: ImportOptions) -> Iterator[Model | SkippedModel]:
    try:
        row = _row(file)
        module = import_module(f"scenewright.catalog.models.{row.reader}")
        content = whole(file, row.most_bytes)
        stem = clean(file.stem, "model")
        for found in module.read(content, stem, beside(file.parent), options):
            yield found if isinstance(found, SkippedModel) else _set_up(found, str(file), options)
    except InputError as error:
        raise error.located(file=str(file)) from None
    except OSError as error:
        raise InputError(
            f"cannot be read: {error.strerror or error}", "check file permissions", file=str(file)
        ) from None


def _set_up(found: RawModel, source: str, options: ImportOptions) -> Model | SkippedModel:
    """In a file of several one that has no body is skipped."""
    try:
        return set_up(found, source, options)
    except InputError as error:
        if "/" not in found.id:
            raise
        return SkippedModel(found.id, _reason(error))


def _reason(error: InputError) -> str:
    return str(InputError(error.fault, error.remedy, place=error.place))


def _row(file: Path) -> ModelFormat:
    suffix = file.suffix.lower()
    found = [row for row in ROWS if row.suffix == suffix]
    if not found:
        raise _unread(suffix)
    return found[0]


def _unread(suffix: str) -> InputError:
    """What is said of a file of another suffix, and what makes it readable."""
    text = f"'{clean(suffix)}' models are not read" if suffix else "the name has no suffix"
    return InputError(text, conversion_of(suffix) or f"use one of: {', '.join(suffixes())}")


def _sort(
    taken: Iterable[Model | SkippedModel], models: list[Model], skipped: list[SkippedModel]
) -> None:
    """Put each where it belongs, as long as there is room."""
    held = sum(len(part.faces) for model in models for part in model.parts)
    for one in taken:
        if isinstance(one, SkippedModel):
            skipped.append(one)
            continue
        held += sum(len(part.faces) for part in one.parts)
        if len(models) >= MOST_MODELS or held > MOST_IN_ALL:
            raise InputError(
                f"holds more than {MOST_MODELS:,} models or {MOST_IN_ALL:,} triangles",
                "give a smaller library",
                file=one.source,
            )
        models.append(one)


def _make_names_unique(models: list[Model]) -> list[Model]:
    """The models under names that differ."""
    taken = {model.id for model in models}
    numbers: dict[str, int] = {}
    found = []
    for model in models:
        number = numbers.get(model.id, 0) + 1
        while number > 1 and f"{model.id}-{number}" in taken:
            number += 1
        numbers[model.id] = number
        found.append(model if number == 1 else model._replace(id=f"{model.id}-{number}"))
    return found
