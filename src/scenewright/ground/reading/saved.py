"""The buildings of a saved solution, whatever kind of scene it is of."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.footprint import place_outline
from scenewright.core.layout import corners
from scenewright.ground.buildings.built import BuiltBuilding, BuiltRoad, BuiltScene, Spot
from scenewright.ground.reading.cleaning import clean_outline, drop_overlaps

OLD = "source"
"""The space of the buildings before an extension."""
GROUNDS = ("sites", "blocks", "areas")
"""Keys of briefs under which grounds are listed."""


def saved_scene(document: dict[str, Any]) -> BuiltScene:
    """The scene of the buildings among the pieces of a solution; pieces that are broken are left
    out by name."""
    brief = document.get("brief")
    brief = brief if isinstance(brief, dict) else {}
    found, left_out = list[BuiltBuilding](), list[str]()
    for piece in document["pieces"]:
        if isinstance(piece, dict) and piece.get("category") == "building":
            name = str(piece.get("id", ""))[:120]
            try:
                found.append(_building(piece, name))
            except (KeyError, TypeError, ValueError, InputError):
                left_out.append(f"{name}: has no usable pose, size or footprint")
    kept, overlapping = drop_overlaps(found)
    grounds = [row for key in GROUNDS for row in _rows(brief, key)]
    outline = _ring(grounds[0].get("outline")) if len(grounds) == 1 else None
    origin = brief.get("origin")
    return BuiltScene(
        str(brief.get("name", "scene"))[:120],
        kept,
        (*_roads(brief), *_roads({"lanes": document.get("continued")})),
        outline if outline is not None and len(outline) > 2 else None,
        (*left_out, *overlapping),
        (float(origin[0]), float(origin[1])) if isinstance(origin, list) else None,
        trees=tuple(_spots(document["pieces"], "tree")),
        lamps=tuple(_spots(document["pieces"], "lamp_post")),
    )


def _spots(pieces: list[Any], category: str) -> Iterator[Spot]:
    """Where the pieces of a category stand; broken ones stand nowhere."""
    for piece in pieces:
        if isinstance(piece, dict) and piece.get("category") == category:
            try:
                x, y = (float(value) for value in piece["pose"][:2])
            except (KeyError, TypeError, ValueError):
                continue
            if np.isfinite([x, y]).all():
                yield x, y


def grown_scenes(document: Any) -> tuple[BuiltScene, BuiltScene]:
    """The old buildings and the grown ones of the document of a saved extension."""
    pieces = document.get("pieces") if isinstance(document, dict) else None
    rows = (
        [piece for piece in pieces if isinstance(piece, dict)] if isinstance(pieces, list) else []
    )
    if not rows or not any(piece.get("space") == OLD for piece in rows):
        raise InputError("holds no buildings of a source", "give two scenes to compare")
    parts = [[p for p in rows if (p.get("space") == OLD) is before] for before in (True, False)]
    old, new = (saved_scene(document | {"pieces": part}) for part in parts)
    return (
        old._replace(name="source", outline=None),
        new._replace(name="grown", context=old.buildings),
    )


def _building(piece: dict[str, Any], name: str) -> BuiltBuilding:
    x, y, z, heading = (float(v) for v in piece["pose"])
    width, depth, height = (float(v) for v in piece["size"])
    del z
    local = piece.get("footprint")
    if local:
        outline = place_outline(np.array(local, float), x, y, heading)
    else:
        outline = corners(np.array([[x, y, heading, width, depth]]))[0]
    cleaned = clean_outline(outline)
    if cleaned is None or not np.isfinite([heading, height]).all():
        raise ValueError(name)
    kind = str(piece.get("function") or "")
    return BuiltBuilding(name, kind, cleaned, height, heading, str(piece.get("asset") or ""))


def _rows(brief: dict[str, Any], key: str) -> list[dict[str, Any]]:
    rows = brief.get(key)
    return [row for row in rows if isinstance(row, dict)] if isinstance(rows, list) else []


def _ring(points: object) -> Any:
    try:
        found = np.array(points, float)
    except (TypeError, ValueError):
        return None
    return found if found.ndim == 2 and found.shape[1] == 2 else None


def _roads(brief: dict[str, Any]) -> Iterator[BuiltRoad]:
    rows = _rows(brief, "lanes")
    for key in GROUNDS:
        for ground in _rows(brief, key):
            rows += _rows(ground, "roads")
    for source in _rows(brief, "sources"):
        rows += _rows(source, "roads")
    for row in rows:
        line = _ring(row.get("line"))
        if line is not None and len(line) > 1:
            yield BuiltRoad(line, float(row.get("width", 5.0)), str(row.get("kind", "road")))
