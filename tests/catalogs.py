"""Small model files written by the tests: boxes and stepped houses as OBJ, city models."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np

HULL = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
"""Sides of a box whose corners count x, then y, then z."""


def house(file: Path, width: float, depth: float, height: float, head: str = "") -> Path:
    """A body as wide as told with a porch at half of its front (+z in the file, y up)."""
    w, d, h = width / 2, depth / 2, height
    boxes = [((-w, 0, -d), (w, h, d - 0.2 * depth)), ((-w, 0, d - 0.2 * depth), (0, h / 2, d))]
    rows, faces = [head], []
    for number, (low, high) in enumerate(boxes):
        for z in (low[2], high[2]):
            for y in (low[1], high[1]):
                rows += [f"v {x} {y} {z}" for x in (low[0], high[0])]
        faces += [" ".join(["f", *(str(8 * number + k + 1) for k in side)]) for side in HULL]
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text("\n".join([*rows, *faces]) + "\n")
    return file


def city(footprints: dict[str, Any], height: float = 9.0, **more: Any) -> dict[str, Any]:
    """A city model of prisms: each footprint ``(n, 2)`` counter-clockwise in metres."""
    vertices: list[list[int]] = []
    objects: dict[str, Any] = {}
    for key, outline in footprints.items():
        corners = np.asarray(outline, float)
        first, count = len(vertices), len(corners)
        for z in (2.5, 2.5 + height):
            vertices += [[round(1000 * x), round(1000 * y), round(1000 * z)] for x, y in corners]
        floor, top = (
            list(range(first, first + count)),
            list(range(first + count, first + 2 * count)),
        )
        walls = [
            [[floor[i], floor[(i + 1) % count], top[(i + 1) % count], top[i]]] for i in range(count)
        ]
        geometry = {"type": "Solid", "lod": "1", "boundaries": [[[floor[::-1]], [top], *walls]]}
        objects[key] = {"type": "Building", "attributes": {}, "geometry": [geometry]}
    return {
        "type": "CityJSON",
        "version": "2.0",
        "CityObjects": objects,
        "vertices": vertices,
        "transform": {"scale": [0.001] * 3, "translate": [84000.0, 447000.0, 0.0]},
        "metadata": {"referenceSystem": "https://www.opengis.net/def/crs/EPSG/0/7415"},
    } | more


def flat(document: dict[str, Any], key: str, kind: str, outline: Any, **told: Any) -> None:
    """Adds a level area to a city model: a road, water or the ground of a site."""
    first = len(document["vertices"])
    document["vertices"] += [[round(1000 * x), round(1000 * y), 0] for x, y in outline]
    ring = list(range(first, len(document["vertices"])))
    geometry = {"type": "MultiSurface", "lod": "1", "boundaries": [[ring]]}
    document["CityObjects"][key] = {"type": kind, "attributes": told, "geometry": [geometry]}


def saved(file: Path, document: dict[str, Any]) -> Path:
    """The document as a file."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(document))
    return file
