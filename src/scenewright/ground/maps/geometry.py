"""The parts of a GeoJSON geometry: points, lines, rings, each checked separately.

Parts that cannot be used (a ring of two corners, one on a line) are named; the others count.
"""

from __future__ import annotations

import json
from typing import Any, NamedTuple

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.space import Points

GEOMETRIES = frozenset(
    {
        "Point",
        "MultiPoint",
        "LineString",
        "MultiLineString",
        "Polygon",
        "MultiPolygon",
        "GeometryCollection",
    }
)
DEEPEST = 8
"""Collections within collections of geometries."""
NUMBERS = (int, float)
"""What JSON reads a number as; true and false are none."""
FLATTEST = 1e-9
"""Twice the area of its largest triangle on a first corner, as a share of its squared extent, up to
which a ring is a line."""


class Shapes(NamedTuple):
    """The parts of a geometry, and what is wrong with those that cannot be used."""

    points: list[Points]
    lines: list[Points]
    polygons: list[tuple[Points, ...]]
    faults: list[str]


def gather(geometry: Any, shapes: Shapes, depth: int) -> None:
    """Adds the parts of a geometry; InputError for one of a kind there is not."""
    kind = geometry.get("type") if isinstance(geometry, dict) else None
    if not isinstance(kind, str) or kind not in GEOMETRIES or depth > DEEPEST:
        raise InputError(f"has a geometry of type {json.dumps(kind)[:40]}", "correct it in the map")
    if kind == "GeometryCollection":
        for one in _to_list(geometry.get("geometries")):
            gather(one, shapes, depth + 1)
        return
    coordinates = geometry.get("coordinates")
    parts = _to_list(coordinates) if kind.startswith("Multi") else [coordinates]
    for part in parts:
        try:
            if kind.endswith("Point"):
                shapes.points.append(_positions([part]))
            elif kind.endswith("LineString"):
                shapes.lines.append(_line(part))
            else:
                shapes.polygons.append(_rings(part, shapes.faults))
        except InputError as error:
            shapes.faults.append(error.fault)


def is_closed(line: Points) -> bool:
    """Whether a line ends where it begins, round at least three corners."""
    return len(line) >= 4 and bool((line[0] == line[-1]).all())


def _line(coordinates: Any) -> Points:
    line = _positions(coordinates)
    if len(line) < 2 or not np.ptp(line, axis=0).any():
        raise InputError("has a line of fewer than two points", "correct it in the map")
    return line


def _rings(coordinates: Any, faults: list[str]) -> tuple[Points, ...]:
    """The rings of a polygon, closed; holes that are none are ``faults``."""
    listed = _to_list(coordinates)
    if not listed:
        raise InputError("has a polygon without rings", "correct it in the map")
    found = [_ring(listed[0])]
    for hole in listed[1:]:
        try:
            found.append(_ring(hole))
        except InputError as error:
            faults.append(error.fault)
    return tuple(found)


def _ring(coordinates: Any) -> Points:
    """A ring of at least three corners, its first again at the end."""
    pairs = _pairs(coordinates)
    ring = _points([*pairs, pairs[0]] if pairs and pairs[0] != pairs[-1] else pairs)
    if len({*pairs}) < 3:
        raise InputError("has a ring of fewer than three corners", "correct it in the map")
    away = ring - ring[0]
    flat = np.abs(away[:, :1] * away[:, 1] - away[:, 1:] * away[:, 0]).max()
    if flat <= FLATTEST * np.square(np.ptp(ring, axis=0).max()):
        raise InputError(
            "has a ring without area: its corners lie on one line", "correct it in the map"
        )
    return ring


def _positions(listed: Any) -> Points:
    """Pairs of finite numbers; heights are dropped."""
    return _points(_pairs(listed))


def _pairs(listed: Any) -> list[tuple[float, float]]:
    return [_pair(position) for position in _to_list(listed)]


def _points(pairs: list[tuple[float, float]]) -> Points:
    found = np.array(pairs, float).reshape(-1, 2)
    if not (np.abs(found) < 1e9).all():  # also false for what is not a number
        raise InputError("has a coordinate that is out of range", "correct it in the map")
    return found


def _pair(position: Any) -> tuple[float, float]:
    if not isinstance(position, list) or len(position) < 2:
        raise InputError("has a position that is not a pair of numbers", "correct it in the map")
    x, y = position[:2]
    if type(x) not in NUMBERS or type(y) not in NUMBERS:
        raise InputError("has a position that is not a pair of numbers", "correct it in the map")
    return _bounded(x), _bounded(y)


def _bounded(axis: float) -> float:
    """A number as a float, NaN where it is too large to be a place."""
    return float(axis) if abs(axis) < 1e9 else np.nan


def _to_list(value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise InputError("has coordinates that are no list", "correct it in the map")
    return value
