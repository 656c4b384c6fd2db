"""Sweet Home 3D furniture libraries (.sh3f): a zip of a catalogue and its models.

``PluginFurnitureCatalog.properties`` lists pieces by number: model, size in centimetres, names,
who made them. A model has y up and its front to +z; ``modelRotation`` (three rows) turns it
first, then it is stretched to its size. Pieces of kinds of model that are not read are listed.
"""

from __future__ import annotations

import io
import re
from collections.abc import Iterator, Mapping
from importlib import import_module
from pathlib import PurePosixPath

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models.archive import Archive, beside, entry, open_archive
from scenewright.catalog.models.conversions import conversion_of
from scenewright.catalog.models.files import MEBIBYTE, Beside
from scenewright.catalog.models.model import ImportOptions, RawModel, SkippedModel, clean
from scenewright.catalog.models.properties import properties
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError
from scenewright.core.scene import Size

Floats = NDArray[np.float64]
Fields = Mapping[str, str]

CATALOGUE = "PluginFurnitureCatalog"
CENTIMETRE = 0.01
MOST_PIECES = 5000
MOST_TAGS = 20
MOST_MODEL = 64 * MEBIBYTE
MOST_TEXT = 8 * MEBIBYTE
READERS = {".obj": "obj", ".glb": "gltf", ".gltf": "gltf", ".stl": "stl"}


def read(
    content: bytes, stem: str, _: Beside, options: ImportOptions
) -> Iterator[RawModel | SkippedModel]:
    """One model a piece of the catalogue, in its order; the others are listed."""
    with open_archive(io.BytesIO(content)) as archive:
        words = catalogue(archive, options.language)
        numbers = sorted(int(key[6:]) for key in words if re.fullmatch(r"model#\d{1,6}", key))
        if not numbers:
            raise InputError("lists no models", f"check its {CATALOGUE}.properties")
        if len(numbers) > MOST_PIECES:
            raise InputError(f"lists more than {MOST_PIECES:,} models", "split the library")
        for number in numbers:
            fields = {
                key.partition("#")[0]: value
                for key, value in words.items()
                if key.endswith(f"#{number}")
            }
            yield _piece(archive, stem, number, fields, words.get("license", ""))


def catalogue(archive: Archive, language: str = "") -> dict[str, str]:
    """The catalogue's entries, those of a language (``de``, ``zh_CN``) over the plain ones."""
    first = entry(archive, f"{CATALOGUE}.properties", MOST_TEXT)
    if first is None:
        raise InputError(f"holds no {CATALOGUE}.properties", "give a furniture library")
    found = properties(first)
    if language and not re.fullmatch(r"[A-Za-z]{2,3}(_[A-Za-z0-9]{2,8})*", language):
        raise InputError(f"'{clean(language)}' is not a language", "write de or zh_CN")
    words = language.split("_") if language else []
    for k in range(len(words)):
        name = f"{CATALOGUE}_{'_'.join(words[: k + 1])}.properties"
        own = entry(archive, name, MOST_TEXT)
        found |= properties(own) if own else {}
    return found


def _piece(
    archive: Archive, stem: str, number: int, fields: Fields, licence: str
) -> RawModel | SkippedModel:
    file = fields.get("model", "").strip().lstrip("/")
    own = clean(PurePosixPath(file.replace("\\", "/")).stem, str(number))
    try:
        parts = _model(archive, file)
        axes = _rotation(fields.get("modelRotation", ""))
        turned = tuple(Part(p.material, p.vertices @ axes.T, p.faces) for p in parts)
        return RawModel(
            f"{stem}/{own}",
            clean(fields.get("name"), own),
            turned,
            "+y",
            "+z",
            clean(fields.get("creator")),
            clean(fields.get("license", licence)),
            clean(fields.get("category")),
            _size(fields),
            _length(fields, "elevation", 0.0),
            _tags(fields),
            fields.get("doorOrWindow", "").strip().lower() == "true",
        )
    except InputError as error:
        fault = InputError(error.fault, error.remedy, place=error.place)
        return SkippedModel(f"{stem}/{own}", str(fault))


def _tags(fields: Fields) -> tuple[str, ...]:
    words = (clean(word) for word in fields.get("tags", "").split(",")[:MOST_TAGS])
    return tuple(word for word in words if word)


def _model(archive: Archive, file: str) -> tuple[Part, ...]:
    suffix = PurePosixPath(file).suffix.lower()
    if suffix not in READERS:
        raise InputError(
            f"'{clean(suffix)}' models are not read in libraries",
            conversion_of(suffix) or f"use one of: {', '.join(READERS)}",
        )
    content = entry(archive, file, MOST_MODEL)
    if content is None:
        raise InputError(f"the model '{clean(file)}' is missing", "save the library again")
    module = import_module(f"scenewright.catalog.models.{READERS[suffix]}")
    folder = str(PurePosixPath(file).parent)
    try:
        found = next(iter(module.read(content, "model", beside(archive, folder), ImportOptions())))
    except InputError as error:
        place = ": ".join(filter(None, (clean(file), error.place)))
        raise InputError(error.fault, error.remedy, place=place) from None
    parts: tuple[Part, ...] = found.parts
    return parts


def _rotation(text: str) -> Floats:
    """The matrix of nine numbers, row by row; it must turn, not bend."""
    if not text.strip():
        return np.eye(3)
    try:
        found = np.array([float(word) for word in text.split()])
        found = found.reshape(3, 3)
    except ValueError:
        raise InputError("modelRotation is not nine numbers", "correct it") from None
    if not np.all(np.abs(found @ found.T - np.eye(3)) < 0.01):
        raise InputError("modelRotation is not a rotation", "correct it")
    return found


def _size(fields: Fields) -> Size:
    sides = [_length(fields, side, -1.0) for side in ("width", "depth", "height")]
    if not all(1e-4 <= side <= 1e3 for side in sides):
        raise InputError("its size is not possible", "give width, depth, height in centimetres")
    return Size(*sides)


def _length(fields: Fields, key: str, otherwise: float) -> float:
    """A length in metres."""
    try:
        value = float(fields[key]) * CENTIMETRE
    except KeyError:
        return otherwise
    except ValueError:
        value = np.nan
    if not abs(value) <= 1e6:
        raise InputError(f"'{clean(fields[key])}' is not a length", "correct it", place=key)
    return value
