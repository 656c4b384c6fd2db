"""CityJSON 1.0, 1.1 and 2.0: every building, with its parts, as one model.

H. Ledoux et al., *CityJSON: a compact and easy-to-use encoding of the CityGML data model* (2019).
Of each object the most detailed geometry counts, a solid before surfaces. Maps do not know a
building's front: it is turned until its footprint fills its box best, the front the side
nearest to the south.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.models.city_surfaces import CitySurface, parts_of, surfaces_of
from scenewright.catalog.models.files import json_of
from scenewright.catalog.models.model import (
    FARTHEST,
    MOST_FACES,
    MOST_VERTICES,
    RawModel,
    SkippedModel,
    check_count,
    clean,
)
from scenewright.core.catalog import Part
from scenewright.core.errors import InputError

Floats = NDArray[np.float64]
Json = Mapping[str, Any]

VERSIONS = ("1.0", "1.1", "2.0")
BUILDINGS = ("Building", "BuildingPart")
MOST_BUILDINGS = 5000
MOST_PARTS = 10_000
DEEPEST = 8
"""Parts within parts of a building."""


class City(NamedTuple):
    """The objects of a file, its corners in metres about their middle, who made it, and where the
    middle lies in the file's reference system (named as the file does)."""

    objects: Json
    corners: Floats
    author: str
    licence: str
    middle: tuple[float, float, float] = (0.0, 0.0, 0.0)
    system: str = ""


def read(content: bytes, stem: str, *_: object) -> Iterator[RawModel | SkippedModel]:
    """One model a building, in the order of the file; the others are listed."""
    city = city_of(json_of(content, "CityJSON"))
    for key in roots_of(city):
        name = clean(key, "unnamed")
        try:
            parts = parts_at(city, key)
            parts = rotate_parts(parts, turn_of(parts))
            yield RawModel(f"{stem}/{name}", name, parts, "+z", "-y", city.author, city.licence)
        except InputError as error:
            fault = InputError(error.fault, error.remedy, place=error.place)
            yield SkippedModel(f"{stem}/{name}", str(fault))


def roots_of(city: City) -> list[str]:
    """The keys of all buildings; InputError if there are none."""
    roots = [key for key, one in city.objects.items() if _is_root(city.objects, one)]
    check_count(len(roots), MOST_BUILDINGS, "buildings")
    if not roots:
        raise InputError("holds no buildings", "give a CityJSON file with buildings")
    return roots


def parts_at(city: City, key: str) -> tuple[Part, ...]:
    """The triangles of an object where it stands, one part a material."""
    return parts_of(city.corners, _surfaces(city, key))


def city_of(document: Json) -> City:
    """The checked frame of a document: version, objects, corners."""
    if document.get("type") != "CityJSON":
        raise InputError("is not CityJSON", "give a file of the type 'CityJSON'")
    version = clean(document.get("version"), "unknown")
    if not version.startswith(VERSIONS):
        raise InputError(f"is CityJSON {version[:12]}", f"use one of: {', '.join(VERSIONS)}")
    objects = document.get("CityObjects")
    if not isinstance(objects, dict) or not all(isinstance(o, dict) for o in objects.values()):
        raise InputError("its CityObjects are no objects", "save it again")
    about = document.get("metadata")
    about = about if isinstance(about, dict) else {}
    contact = about.get("pointOfContact", about.get("datasetPointOfContact"))
    author = clean(contact.get("contactName")) if isinstance(contact, dict) else ""
    corners, middle = _corners(document)
    system = clean(about.get("referenceSystem"))
    return City(objects, corners, author, clean(about.get("license")), middle, system)


def _corners(document: Json) -> tuple[Floats, tuple[float, float, float]]:
    """Corners ``(n, 3)``, near the origin so that no digits are lost, and where that lies."""
    raw = _table(document.get("vertices"), "vertices")
    check_count(len(raw), MOST_VERTICES, "vertices")
    transform = document.get("transform")
    if isinstance(transform, dict):
        scale = _table([transform.get("scale")], "transform")
        if scale.shape != (1, 3) or not np.all(np.abs(scale) <= FARTHEST):
            raise InputError("its scale is not three numbers", "save it again", place="transform")
        with np.errstate(over="ignore", invalid="ignore"):
            raw = raw * scale  # where on earth the whole lies does not matter
    if not np.all(np.abs(raw) <= FARTHEST):
        raise InputError("a corner is not at a finite place", "save it again", place="vertices")
    middle = np.median(raw, 0) if len(raw) else np.zeros(3)
    x, y, z = (middle + _translate(transform)).tolist()
    return raw - middle, (x, y, z)


def _translate(transform: object) -> Floats:
    """What a transform adds to corners; nothing if it does not tell three finite numbers."""
    shift = transform.get("translate") if isinstance(transform, dict) else None
    try:
        found = np.array(shift, np.float64)
    except (ValueError, TypeError, OverflowError):
        return np.zeros(3)
    right = found.shape == (3,) and bool(np.all(np.abs(found) <= FARTHEST))
    return found if right else np.zeros(3)


def _table(rows: object, place: str) -> Floats:
    try:
        found = np.array(rows, np.float64) if isinstance(rows, list) else None
    except (ValueError, TypeError, OverflowError):
        found = None
    if found is None or (found.size and (found.ndim != 2 or found.shape[1] != 3)):
        raise InputError("are not rows of three numbers", "save it again", place=place)
    return found.reshape(-1, 3)


def _is_root(objects: Json, one: Json) -> bool:
    """Whether an object is a building, or a part whose building is not there."""
    if one.get("type") not in BUILDINGS:
        return False
    parents = one.get("parents")
    known = [p for p in parents if isinstance(p, str)] if isinstance(parents, list) else []
    return not any(objects.get(p, {}).get("type") in BUILDINGS for p in known)


def _surfaces(city: City, key: str) -> list[CitySurface]:
    """Surfaces of a building and of its parts, each part once."""
    found: list[CitySurface] = []
    waiting, seen = [(key, 0)], {key}
    while waiting:
        name, depth = waiting.pop()
        one = city.objects[name]
        best = _best(one.get("geometry"))
        found += surfaces_of(best, len(city.corners)) if best is not None else []
        check_count(len(found), MOST_FACES, "surfaces")
        children = one.get("children")
        for child in children if isinstance(children, list) else []:
            if not isinstance(child, str) or child in seen:
                continue
            if city.objects.get(child, {}).get("type") == "BuildingPart":
                seen.add(child)
                waiting.append((child, depth + 1))
        if depth > DEEPEST or len(seen) > MOST_PARTS:
            raise InputError("has too many parts within parts", "simplify the building")
    if not found:
        raise InputError("has no geometry that can be used", "give solids or surfaces")
    return found


def _best(geometries: object) -> Json | None:
    """The most detailed geometry, a solid before surfaces."""
    usable = [
        one
        for one in (geometries if isinstance(geometries, list) else [])
        if isinstance(one, dict) and str(one.get("type")) in DEPTHS
    ]
    return max(usable, key=_detail, default=None)


DEPTHS = {
    "Solid": 1,
    "MultiSolid": 2,
    "CompositeSolid": 2,
    "MultiSurface": 0,
    "CompositeSurface": 0,
}
"""Lists within lists before the surfaces."""


def _detail(geometry: Json) -> tuple[float, bool]:
    try:
        level = float(geometry.get("lod", 0.0))
    except (TypeError, ValueError, OverflowError):
        level = 0.0
    return (level if 0.0 <= level < 100.0 else 0.0), DEPTHS[str(geometry["type"])] > 0


def turn_of(parts: tuple[Part, ...]) -> float:
    """By what angle the least rectangle round some parts is turned in plan against the axes.

    It is at most an eighth: what looked south still looks south most of all.
    """
    points = np.concatenate([part.vertices[:, :2] for part in parts])
    box = shapely.minimum_rotated_rectangle(shapely.multipoints(points - points[0]))
    if box.geom_type != "Polygon":
        return 0.0
    side = np.diff(np.asarray(box.exterior.coords)[:2], axis=0)[0]
    angle = float(np.arctan2(side[1], side[0]))
    return angle - float(np.round(angle / (np.pi / 2)) * np.pi / 2)


def rotate_parts(parts: tuple[Part, ...], angle: float) -> tuple[Part, ...]:
    """The parts turned back by an angle in plan, clockwise."""
    cos, sin = np.cos(angle), np.sin(angle)
    turn = np.array([[cos, sin, 0.0], [-sin, cos, 0.0], [0.0, 0.0, 1.0]])
    return tuple(Part(part.material, part.vertices @ turn.T, part.faces) for part in parts)
