"""Models of a registered catalogue kept ready: one file of arrays instead of many to be parsed.

The file is only a copy: it says what it was made of, and is made anew when that changes.
"""

from __future__ import annotations

import json
import zipfile
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.models import LibraryReport
from scenewright.catalog.models.model import Model, SkippedModel
from scenewright.core.atomic_file import atomic_write
from scenewright.core.catalog import Material, Part
from scenewright.core.scene import Size

VERSION = 1
MOST_BYTES = 2**31


def keep(file: Path, found: LibraryReport, made_of: str) -> None:
    """Write what a catalogue holds; where nothing can be written nothing is kept."""
    values = {
        "version": VERSION,
        "made_of": made_of,
        "models": [_describe_model(model) for model in found.models],
        "skipped": [list(one) for one in found.skipped],
    }
    parts = [part for model in found.models for part in model.parts]
    arrays = {
        "told": np.frombuffer(json.dumps(values, default=float).encode(), np.uint8),
        "vertices": _join_arrays([p.vertices for p in parts], np.float64),
        "faces": _join_arrays([p.faces for p in parts], np.int32),
    }
    with suppress(OSError), atomic_write(file, own=True) as partial, partial.open("wb") as stream:
        np.savez(stream, allow_pickle=False, **arrays)


def load_cached(file: Path, made_of: str) -> LibraryReport | None:
    """What was kept, if it was made of just this and is whole; else None."""
    try:
        if not file.is_file() or file.stat().st_size > MOST_BYTES:
            return None
        with file.open("rb") as stream, np.load(stream, allow_pickle=False) as arrays:
            record = json.loads(arrays["told"].tobytes())
            if (record["version"], record["made_of"]) != (VERSION, made_of):
                return None
            points, corners = arrays["vertices"], arrays["faces"].astype(np.int64)
        models = tuple(_models(record["models"], points, corners))
        return LibraryReport(models, tuple(SkippedModel(*one) for one in record["skipped"]))
    except (OSError, ValueError, KeyError, TypeError, IndexError, EOFError, zipfile.BadZipFile):
        return None


def _join_arrays(arrays: Sequence[NDArray[Any]], kind: type) -> NDArray[Any]:
    return np.concatenate([np.zeros((0, 3)), *arrays]).astype(kind)


def _describe_model(model: Model) -> dict[str, Any]:
    """A model without its triangles, and how many vertices and faces each part has."""
    values = model._asdict() | {"size": list(model.size), "tags": list(model.tags)}
    values["parts"] = [
        {
            "material": [
                p.material.name,
                list(p.material.color),
                p.material.roughness,
                p.material.metallic,
                p.material.opacity,
                p.material.emission,
            ],
            "counts": [len(p.vertices), len(p.faces)],
        }
        for p in model.parts
    ]
    return values


def _models(
    rows: Sequence[dict[str, Any]], points: NDArray[Any], corners: NDArray[Any]
) -> Iterator[Model]:
    first, start = 0, 0
    for row in rows:
        parts = []
        for part in row["parts"]:
            name, colour, *rest = part["material"]
            vertices, faces = part["counts"]
            own = corners[start : start + faces]
            if len(own) != faces or (faces and not 0 <= own.min() <= own.max() < vertices):
                raise ValueError("not whole")
            material = Material(name, tuple(colour), *rest)
            parts.append(Part(material, points[first : first + vertices], own))
            first, start = first + vertices, start + faces
        yield Model(
            **row | {"parts": tuple(parts), "size": Size(*row["size"]), "tags": tuple(row["tags"])}
        )
