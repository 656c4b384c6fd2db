"""GeoJSON as a list of features: tags, rings and levels, checked once (RFC 7946).

Tags follow OpenStreetMap's simple indoor tagging. They are the properties of a feature, or lie
under ``tags`` there, as some exporters write them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from scenewright.catalog.models.files import check_json
from scenewright.core.document_faults import check_characters
from scenewright.core.errors import InputError
from scenewright.core.space import Points

GREATEST_FILE = 64 * 2**20
MOST_FEATURES = 100_000
MOST_CORNERS = 1_000_000
MOST_LEVELS = 200
LONGEST_TEXT = 120
RANGE = re.compile(r"(-?\d{1,3}(?:\.\d+)?)-(-?\d{1,3}(?:\.\d+)?)")
LEVEL = re.compile(r"-?\d{1,3}(?:\.\d{1,3})?")
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

Polygons = tuple[tuple[Points, ...], ...]


class Feature(NamedTuple):
    """One feature: its id (plain letters), tags, a point ``(2,)`` or none, and polygons, each its
    outline and holes ``(n, 2)``. ``open_line`` marks a line that is not closed; ``lines`` are all
    its lines ``(n, 2)``, closed or not."""

    id: str
    tags: dict[str, str]
    point: Points | None
    polygons: Polygons
    open_line: bool
    lines: tuple[Points, ...] = ()


class SkippedFeature(NamedTuple):
    """A feature that was left out, and why."""

    feature: str
    reason: str


class Collection(NamedTuple):
    """All features of a file that can be read, those that cannot, and the name of the
    reference system, if one is given."""

    features: tuple[Feature, ...]
    skipped: tuple[SkippedFeature, ...]
    crs: str


def load(path: Path) -> Collection:
    """The features of a GeoJSON file; InputError if it holds none."""
    if path.stat().st_size > GREATEST_FILE:
        raise InputError(
            f"is larger than {GREATEST_FILE // 2**20} MiB", "cut one building out of the map"
        )
    return collection(_document(path.read_bytes()))


def collection(document: Any) -> Collection:
    """The features of a GeoJSON document: a FeatureCollection or a single Feature."""
    kind = document.get("type") if isinstance(document, dict) else None
    rows = [document] if kind == "Feature" else None
    if kind == "FeatureCollection":
        rows = document.get("features")
    if not isinstance(rows, list):
        text = f"its type is {json.dumps(kind)[:40]}" if kind else "holds no GeoJSON features"
        text = "holds no list of features" if kind == "FeatureCollection" else text
        raise InputError(text, 'give {"type": "FeatureCollection", "features": [...]}')
    if len(rows) > MOST_FEATURES:
        raise InputError(f"holds {len(rows)} features", f"at most {MOST_FEATURES} are read")
    good: list[Feature] = []
    bad: list[SkippedFeature] = []
    taken: dict[str, int] = {}
    corners = 0
    for number, row in enumerate(rows):
        name = _fresh(_identifier(row, number), taken)
        try:
            feature = _feature(row, name)
        except InputError as error:
            bad.append(SkippedFeature(name, error.fault))
            continue
        good.append(feature)
        corners += sum(len(ring) for rings in (*feature.polygons, feature.lines) for ring in rings)
        if corners > MOST_CORNERS:
            raise InputError(f"holds more than {MOST_CORNERS} corners", "cut one building out")
    if not rows:
        raise InputError("holds no features", "export the indoor map again")
    return Collection(tuple(good), tuple(bad), _reference_system(document))


def levels_of(tags: dict[str, str]) -> tuple[float, ...]:
    """The levels a feature lies on, by ``level`` and ``repeat_on``; none if it does not say.

    A range counts whole storeys.

    >>> levels_of({"level": "-1;0"}), levels_of({"level": "0-2", "repeat_on": "5"})
    ((-1.0, 0.0), (0.0, 1.0, 2.0, 5.0))
    >>> levels_of({"level": "-2--1"}), levels_of({})
    ((-2.0, -1.0), ())
    """
    text = ";".join(tags[key] for key in ("level", "repeat_on") if tags.get(key))
    found: set[float] = set()
    for part in filter(None, (part.strip() for part in text.split(";"))):
        span = RANGE.fullmatch(part)
        if span:
            low, high = sorted((float(span[1]), float(span[2])))
            found.update(low + step for step in range(int(high - low) + 1))
        elif LEVEL.fullmatch(part):
            found.add(float(part))
        else:
            raise InputError(f"its level '{part[:40]}' is not a number")
        if len(found) > MOST_LEVELS:
            raise InputError(f"it lies on more than {MOST_LEVELS} levels")
    return tuple(sorted(found))


def _feature(row: Any, name: str) -> Feature:
    geometry = row.get("geometry") if isinstance(row, dict) else None
    if not isinstance(geometry, dict):
        raise InputError("has no geometry")
    kind, coordinates = geometry.get("type"), geometry.get("coordinates")
    if not isinstance(kind, str) or kind not in GEOMETRIES:
        raise InputError(f"has a geometry of type {json.dumps(kind)[:40]}")
    tags = _tags(row)
    if kind == "Point":
        return Feature(name, tags, _positions([coordinates])[0], (), False)
    if kind == "Polygon":
        return Feature(name, tags, None, (_rings(coordinates),), False)
    if kind == "MultiPolygon":
        return Feature(name, tags, None, tuple(_rings(r) for r in _to_list(coordinates)), False)
    if kind == "LineString":
        line = _positions(coordinates)
        closed = len(line) >= 4 and bool((line[0] == line[-1]).all())
        return Feature(name, tags, None, ((line,),) if closed else (), not closed, (line,))
    if kind == "MultiLineString":
        return Feature(name, tags, None, (), False, tuple(map(_positions, _to_list(coordinates))))
    return Feature(name, tags, None, (), False)


def _rings(coordinates: Any) -> tuple[Points, ...]:
    rings = tuple(_positions(ring) for ring in _to_list(coordinates))
    if not rings or any(len(ring) < 4 for ring in rings):
        raise InputError("has a ring of fewer than three corners")
    return rings


def _positions(listed: Any) -> Points:
    """Pairs of finite numbers; heights are dropped."""
    flat = [axis for position in _to_list(listed) for axis in _pair(position)]
    found = np.array(flat, float).reshape(-1, 2)
    if not (np.abs(found) < 1e9).all():  # also false for what is not a number
        raise InputError("has a coordinate that is out of range")
    return found


def _pair(position: Any) -> Iterator[float]:
    if not isinstance(position, list) or len(position) < 2:
        raise InputError("has a position that is not a pair of numbers")
    for axis in position[:2]:
        if isinstance(axis, bool) or not isinstance(axis, int | float):
            raise InputError("has a position that is not a pair of numbers")
        yield float(axis) if abs(axis) < 1e9 else np.nan


def _to_list(value: Any) -> list[Any]:
    if not isinstance(value, list):
        raise InputError("has coordinates that are no list")
    return value


def _tags(row: dict[str, Any]) -> dict[str, str]:
    """Tags as plain short text; nested ones first."""
    properties = row.get("properties")
    if not isinstance(properties, dict):
        return {}
    nested = properties.get("tags")
    listed = (properties | nested).items() if isinstance(nested, dict) else properties.items()
    return {
        str(key)[:LONGEST_TEXT]: plain(value)
        for key, value in listed
        if isinstance(value, str | int | float) and not isinstance(value, bool)
    }


def plain(value: object) -> str:
    """Text on one line, without control characters, of at most 120 letters.

    >>> plain("Caf\\u00e9\\n du  Nord")
    'Café du Nord'
    """
    text = "".join(c if c.isprintable() else " " for c in str(value)[: 4 * LONGEST_TEXT])
    return " ".join(text.split())[:LONGEST_TEXT]


def _identifier(row: Any, number: int) -> str:
    """``way/123`` as ``way-123``; ``feature-7`` where there is none."""
    properties = row.get("properties") if isinstance(row, dict) else None
    inside = properties if isinstance(properties, dict) else {}
    given = [row.get("id")] if isinstance(row, dict) else []
    for name in (*given, inside.get("@id"), inside.get("id")):
        if isinstance(name, str | int) and not isinstance(name, bool):
            text = re.sub(r"[^\w.-]+", "-", str(name)[:LONGEST_TEXT]).strip("-")
            if text:
                return re.sub(r"-{2,}", "-", text)
    return f"feature-{number + 1}"


def _fresh(wish: str, taken: dict[str, int]) -> str:
    name = wish
    while name in taken:
        taken[wish] += 1
        name = f"{wish}-{taken[wish]}"
    taken[name] = 1
    return name


def _reference_system(document: dict[str, Any]) -> str:
    """``crs.properties.name`` of GeoJSON before RFC 7946."""
    crs = document.get("crs")
    properties = crs.get("properties") if isinstance(crs, dict) else None
    name = properties.get("name") if isinstance(properties, dict) else None
    return plain(name) if isinstance(name, str) else ""


def _document(data: bytes) -> Any:
    check_json(data)
    try:
        text = data.decode("utf-8-sig")
        document = json.loads(text)
    except UnicodeDecodeError:
        raise InputError("is not UTF-8 text", "save it as UTF-8") from None
    except RecursionError:
        raise InputError("is nested too deeply", "give GeoJSON") from None
    except json.JSONDecodeError as error:
        where = f"line {error.lineno}, column {error.colno}"
        fault = f"broken JSON: {error.msg}" if data.strip() else "is empty"
        raise InputError(fault, "export it again", place=where) from None
    except ValueError as error:  # a whole number of thousands of digits
        raise InputError(f"broken JSON: {error}", "export it again") from None
    check_characters(document, text)
    return document
