"""The buildings that a brief draws: those of its sources, and those on its sites."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from scenewright.ground.buildings.built import BuiltBuilding, BuiltRoad, BuiltScene
from scenewright.ground.reading.cleaning import clean_outline, drop_overlaps

DRAWN = (("sources", "buildings"), ("sites", "landmarks"))
"""Keys under which a brief lists grounds, and below them what is built there."""
HEIGHT = 7.5
"""Of a building that does not state its own, in metres."""


def draws_buildings(document: dict[str, Any]) -> bool:
    """Whether a JSON document is a brief that draws buildings.

    >>> draws_buildings({"sources": [{"buildings": [{"outline": [[0, 0], [9, 0], [9, 9]]}]}]})
    True
    """
    return next(_drawn(document), None) is not None


def drawn_scene(document: dict[str, Any]) -> BuiltScene:
    """What is built in a brief; buildings without a usable outline are left out by name."""
    found, left_out = list[BuiltBuilding](), list[str]()
    for number, row in enumerate(_drawn(document), 1):
        name = str(row.get("id") or f"building-{number}")[:120]
        try:
            outline = clean_outline(np.array(row["outline"], float))
            heading = None if row.get("heading") is None else float(row["heading"])
            height = float(row.get("height", HEIGHT))
        except (KeyError, TypeError, ValueError):
            outline = None
        if outline is None:
            left_out.append(f"{name}: has no usable footprint")
            continue
        model = str(row.get("model", ""))
        found.append(BuiltBuilding(name, str(row.get("name", "")), outline, height, heading, model))
    kept, overlapping = drop_overlaps(found) if found else ((), ())
    name = str(document.get("name", "scene"))[:120]
    return BuiltScene(name, kept, tuple(_roads(document)), None, (*left_out, *overlapping))


def _drawn(document: dict[str, Any]) -> Iterator[dict[str, Any]]:
    for grounds, key in DRAWN:
        for ground in _rows(document, grounds):
            yield from _rows(ground, key)


def _roads(document: dict[str, Any]) -> Iterator[BuiltRoad]:
    """Roads of all grounds that have at least two points."""
    for grounds, _ in DRAWN:
        for row in (row for ground in _rows(document, grounds) for row in _rows(ground, "roads")):
            try:
                line = np.array(row["line"], float).reshape(-1, 2)
                width = float(row.get("width", 6.0))
            except (KeyError, TypeError, ValueError):
                continue
            if len(line) > 1:
                yield BuiltRoad(line, width, str(row.get("kind", "road")))


def _rows(document: dict[str, Any], key: str) -> list[dict[str, Any]]:
    rows = document.get(key)
    return [row for row in rows if isinstance(row, dict)] if isinstance(rows, list) else []
