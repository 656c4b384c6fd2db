"""CityJSON 0.8 to 2.0: every building, with its parts, as one model.

H. Ledoux et al., *CityJSON: a compact and easy-to-use encoding of the CityGML data model* (2019).
Of each object the most detailed geometry counts, a solid before surfaces. Maps do not know a
building's front: it is turned until its footprint fills its box best, the front the side
nearest to the south.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.catalog.models.city_documents import (
    document_of,
    faults_of,
    objects_of,
    place_templates,
)
from scenewright.catalog.models.city_surfaces import CitySurface, parts_of, surfaces_of
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
from scenewright.core.projection import Projection, projection

Floats = NDArray[np.float64]
Json = Mapping[str, Any]

VERSIONS = ("0", "1", "2")
_VERSION = re.compile(r"(?:https?://www\.cityjson\.org/version/)?((\d)(?:\.\d+)*)")
BUILDINGS = ("Building", "BuildingPart", "OtherConstruction")
MOST_BUILDINGS = 5000
MOST_PARTS = 10_000
DEEPEST = 8
"""Parts within parts of a building."""


class City(NamedTuple):
    """The objects of a file, its corners in metres about their middle, who made it, where that
    middle lies in the file's reference system, the ``system``'s name, and the projection by which
    coordinates became metres."""

    objects: Json
    corners: Floats
    author: str
    licence: str
    middle: tuple[float, float, float]
    system: str
    map_: Projection


def read(content: bytes, stem: str, *_: object) -> Iterator[RawModel | SkippedModel]:
    """One model a building, in the order of the file; the others are listed."""
    city = city_of(document_of(content))
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
    if document.get("type") not in ("CityJSON", "CityModel"):
        raise InputError("is not CityJSON", "give a file of the type 'CityJSON'")
    stated = clean(document.get("version"), "unknown")
    version = _VERSION.fullmatch(stated)
    if not version or version[2] not in VERSIONS:
        raise InputError(f"is CityJSON {stated[:12]}", "use one of: 0.8, 0.9, 1.0, 1.1, 2.0")
    objects, raw = place_templates(document, objects_of(document), _scaled(document))
    about = document.get("metadata")
    about = about if isinstance(about, dict) else {}
    contact = about.get("pointOfContact", about.get("datasetPointOfContact"))
    author = clean(contact.get("contactName")) if isinstance(contact, dict) else ""
    corners, middle, map_ = _in_metres(raw, document.get("transform"), _system(about))
    name = map_.system.name if map_.system else ""
    return City(objects, corners, author, clean(about.get("license")), middle, name, map_)


def _system(about: Json) -> object:
    """The reference system as metadata name it: ``crs.epsg`` before version 1.0."""
    older = about.get("crs")
    code = older.get("epsg") if isinstance(older, dict) else None
    return about.get("referenceSystem") or (f"EPSG:{code}" if code else "")


def _scaled(document: Json) -> Floats:
    """Corners ``(n, 3)`` in units of the file, before they are moved to their place."""
    raw = _table(document.get("vertices"), "vertices")
    check_count(len(raw), MOST_VERTICES, "vertices")
    transform = document.get("transform")
    if isinstance(transform, dict):
        scale = _table([transform.get("scale")], "transform")
        if scale.shape != (1, 3) or not np.all(np.abs(scale) <= FARTHEST):
            raise InputError("its scale is not three numbers", "save it again", place="transform")
        with np.errstate(over="ignore", invalid="ignore"):
            raw = raw * scale
    if not np.all(np.abs(raw) <= FARTHEST):
        raise InputError("a corner is not at a finite place", "save it again", place="vertices")
    return raw


def _in_metres(
    raw: Floats, transform: object, system: object
) -> tuple[Floats, tuple[float, float, float], Projection]:
    """Corners ``(n, 3)`` in metres near the origin, so that no digits are lost, where that lies,
    and the projection."""
    move = _translate(transform)
    middle = np.median(raw, 0) if len(raw) else np.zeros(3)
    ends = np.vstack([middle, raw.min(0), raw.max(0)] if len(raw) else [middle])[:, :2]
    map_ = projection(ends + move[:2], system, plane=True)
    map_ = map_._replace(origin=_listed_origin(map_, middle + move))
    near = raw - middle
    near[:, :2] = near[:, 1::-1] if map_.swapped else near[:, :2]
    if map_.turns:
        near[:, 0] = (near[:, 0] + map_.turn / 2) % map_.turn - map_.turn / 2
    rise = map_.system.height if map_.system else 1.0
    x, y = map_.origin
    return near * (*map_.scale, rise), (x, y, float((middle + move)[2])), map_


def _listed_origin(map_: Projection, at: Floats) -> tuple[float, float]:
    x, y = float(at[0]), float(at[1])
    return (y, x) if map_.swapped else (x, y)


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
    if not is_building(one):
        return False
    parents = one.get("parents")
    known = [p for p in parents if isinstance(p, str)] if isinstance(parents, list) else []
    return not any(is_building(objects.get(p, {})) for p in known)


def is_building(one: Json) -> bool:
    """Whether an object is a building or a part of one, also of an extension.

    >>> is_building({"type": "+EnergyBuilding"}), is_building({"type": "Road"})
    (True, False)
    """
    kind = str(one.get("type"))
    return kind in BUILDINGS or (kind.startswith("+") and kind.endswith(BUILDINGS[:2]))


def parts_within(city: City, key: str) -> list[str]:
    """The keys of a building and of its parts, each once."""
    waiting, seen = [(key, 0)], {key: None}
    while waiting:
        name, depth = waiting.pop()
        one = city.objects[name]
        children = one.get("children")
        for child in children if isinstance(children, list) else []:
            if not isinstance(child, str) or child in seen:
                continue
            if str(city.objects.get(child, {}).get("type")).endswith("BuildingPart"):
                seen[child] = None
                waiting.append((child, depth + 1))
        if depth > DEEPEST or len(seen) > MOST_PARTS:
            raise InputError("has too many parts within parts", "simplify the building")
    return list(seen)


def _surfaces(city: City, key: str) -> list[CitySurface]:
    """Surfaces of a building and of its parts."""
    found: list[CitySurface] = []
    for name in parts_within(city, key):
        best = _best(city.objects[name].get("geometry"))
        found += surfaces_of(best, len(city.corners)) if best is not None else []
        check_count(len(found), MOST_FACES, "surfaces")
    if not found:
        fault = next(faults_of(city.objects[key].get("geometry")), "")
        raise InputError(fault or "has no geometry that can be used", "give solids or surfaces")
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
