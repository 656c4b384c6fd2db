"""GeoJSON as a list of features: tags, rings and levels, checked once (RFC 7946).

Tags follow OpenStreetMap's simple indoor tagging. They are the properties of a feature, or lie
under ``tags`` there, as some exporters write them.
"""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np

from scenewright.catalog.models.files import check_json
from scenewright.core.document_faults import check_characters
from scenewright.core.errors import InputError
from scenewright.core.projection import projection
from scenewright.core.reference_system import to_degrees
from scenewright.core.space import Points
from scenewright.ground.maps.geometry import GEOMETRIES, Shapes, gather, is_closed
from scenewright.ground.maps.imdf import is_imdf, to_indoor_tags
from scenewright.ground.maps.kinds import kind_of
from scenewright.ground.maps.tags import LONGEST_TEXT, plain, tags_of

GREATEST_FILE = 64 * 2**20
MOST_FEATURES = 100_000
MOST_CORNERS = 1_000_000
MOST_LEVELS = 200
RANGE = re.compile(r"(-?\d{1,3}(?:\.\d+)?)-(-?\d{1,3}(?:\.\d+)?)")
LEVEL = re.compile(r"-?\d{1,3}(?:\.\d{1,3})?")
Polygons = tuple[tuple[Points, ...], ...]


class Feature(NamedTuple):
    """One feature: its id (plain letters), tags, a point ``(2,)`` or none, and polygons, each its
    outline and holes ``(n, 2)``. ``open_line`` marks a line that is not closed; ``lines`` are all
    its lines ``(n, 2)``, closed or not; ``lost`` says which parts of it cannot be used, ``layer``
    on which layer of its file it lies."""

    id: str
    tags: dict[str, str]
    point: Points | None
    polygons: Polygons
    open_line: bool
    lines: tuple[Points, ...] = ()
    lost: str = ""
    layer: str = ""

    @property
    def kind(self) -> str:
        """What it is, in words, and its layer."""
        shape = "area" if self.polygons else "line" if self.lines else "point"
        return kind_of(self.tags, shape) + (f" (layer {self.layer})" if self.layer else "")


class SkippedFeature(NamedTuple):
    """A feature that was left out, and why."""

    feature: str
    reason: str


class Collection(NamedTuple):
    """All features of a file that can be read, those that cannot, the reference system, if one is
    given, as :func:`scenewright.core.reference_system.system_of` takes it, the tags of those that
    cannot be read by their names, and the format of the file in words. Coordinates of a ``plane``
    that no system is given for are metres, where they cannot be degrees. ``origin`` is the place
    that becomes 0, 0, in coordinates of the system."""

    features: tuple[Feature, ...]
    skipped: tuple[SkippedFeature, ...]
    crs: str
    broken: Mapping[str, dict[str, str]] = MappingProxyType({})
    format: str = "GeoJSON"
    plane: bool = False
    origin: tuple[float, float] | None = None


def load(path: Path) -> Collection:
    """The features of a GeoJSON file; InputError if it holds none."""
    if path.stat().st_size > GREATEST_FILE:
        raise InputError(
            f"is larger than {GREATEST_FILE // 2**20} MiB", "cut one building out of the map"
        )
    return collection(_document(path.read_bytes()))


def collection(document: Any) -> Collection:
    """The features of a GeoJSON document: a FeatureCollection, a single Feature, or a geometry,
    which is a feature without tags."""
    kind = document.get("type") if isinstance(document, dict) else None
    rows = [document] if kind == "Feature" else None
    if isinstance(kind, str) and kind in GEOMETRIES - {"Point", "MultiPoint"}:
        rows = [{"type": "Feature", "properties": {}, "geometry": document}]
    if kind == "FeatureCollection":
        rows = document.get("features")
    if not isinstance(rows, list):
        text = f"its type is {json.dumps(kind)[:40]}" if kind else "holds no GeoJSON features"
        text = "holds no list of features" if kind == "FeatureCollection" else text
        raise InputError(text, 'give {"type": "FeatureCollection", "features": [...]}')
    if len(rows) > MOST_FEATURES:
        raise InputError(f"holds {len(rows)} features", f"at most {MOST_FEATURES} are read")
    rows = to_indoor_tags(rows) if is_imdf(rows) else rows
    good: list[Feature] = []
    bad: list[SkippedFeature] = []
    broken: dict[str, dict[str, str]] = {}
    taken: dict[str, int] = {}
    corners = 0
    for number, row in enumerate(rows):
        name = _fresh(_identifier(row, number), taken)
        try:
            feature = _feature(row, name)
        except InputError as error:
            bad.append(SkippedFeature(name, error.fault))
            broken[name] = tags_of(row) if isinstance(row, dict) else {}
            continue
        good.append(feature)
        corners += sum(len(ring) for rings in (*feature.polygons, feature.lines) for ring in rings)
        if corners > MOST_CORNERS:
            raise InputError(f"holds more than {MOST_CORNERS} corners", "cut one building out")
    if not rows:
        raise InputError("holds no features", "export the indoor map again")
    return Collection(tuple(good), tuple(bad), _reference_system(document), broken)


def in_degrees(found: Collection) -> Collection:
    """The same with longitudes and latitudes, where its coordinates are those of a plane."""
    corners = [ring for f in found.features for rings in (*f.polygons, f.lines) for ring in rings]
    map_ = projection(np.vstack(corners), found.crs, found.plane) if corners else None
    if map_ is None or map_.turns or map_.system is None:
        return found
    system, order = map_.system, -1 if map_.swapped else 1

    def turn(points: Points) -> Points:
        return to_degrees(system, points[:, ::order])

    features = tuple(
        feature._replace(
            point=None if feature.point is None else turn(feature.point[None])[0],
            polygons=tuple(tuple(map(turn, rings)) for rings in feature.polygons),
            lines=tuple(map(turn, feature.lines)),
        )
        for feature in found.features
    )
    at = None if found.origin is None else to_degrees(system, np.array([found.origin], float))[0]
    origin = None if at is None else (float(at[0]), float(at[1]))
    return found._replace(features=features, crs="OGC:CRS84", origin=origin)


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
            raise InputError(f"its level '{part[:40]}' is not a number", "correct it in the map")
        if len(found) > MOST_LEVELS:
            raise InputError(f"it lies on more than {MOST_LEVELS} levels", "correct it in the map")
    return tuple(sorted(found))


def _feature(row: Any, name: str) -> Feature:
    geometry = row.get("geometry") if isinstance(row, dict) else None
    layer, missing = _stated(row)
    if not isinstance(geometry, dict):
        raise InputError(missing or "has no geometry", "correct it in the map")
    shapes = Shapes([], [], [], [])
    gather(geometry, shapes, 0)
    whole = len(shapes.points) + len(shapes.lines) + len(shapes.polygons)
    if not whole:
        raise InputError(
            shapes.faults[0] if shapes.faults else "has an empty geometry", "correct it in the map"
        )
    lost, count = missing, len(shapes.faults)
    if shapes.faults:
        lost = f"{count} of its {whole + count} parts left out: one {shapes.faults[0]}"
    closed = [line for line in shapes.lines if is_closed(line)]
    areas = tuple(shapes.polygons) or tuple((line,) for line in closed[:1])
    return Feature(
        name,
        tags_of(row),
        shapes.points[0][0] if shapes.points else None,
        areas,
        bool(shapes.lines) and not closed,
        tuple(shapes.lines),
        lost,
        layer,
    )


def _stated(row: Any) -> tuple[str, str]:
    """What a reader of ours says of a feature beside what its file does: the layer that it lies
    on, and what of it is lost."""
    about = row.get("scenewright") if isinstance(row, dict) else None
    stated = about if isinstance(about, dict) else {}
    return plain(stated.get("layer", "")), plain(stated.get("lost", ""))


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
    """What ``crs`` says, of GeoJSON before RFC 7946: a name, an address, a code, or PROJJSON."""
    crs = document.get("crs")
    if not isinstance(crs, dict):
        return crs if isinstance(crs, str) else ""
    about = crs.get("properties")
    stated = about if isinstance(about, dict) else {}
    found = next((stated[key] for key in ("name", "code", "href") if stated.get(key)), None)
    if found is None and str(crs.get("type", "")).endswith("CRS"):
        return json.dumps(crs)
    return str(found) if isinstance(found, str | int) else ""


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
