"""Features of a GeoJSON map (RFC 7946), from metres."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from scenewright.core.projection import Projection, coordinates_of, projection
from scenewright.core.space import Points


def projection_about(origin: Sequence[float] | None) -> Projection:
    """The projection by which a longitude and latitude is the origin; without one, of metres that
    lie nowhere on earth."""
    if origin is None:
        return Projection((0.0, 0.0), (1.0, 1.0), False)
    return projection(np.array([origin], float))


def write_collection(
    name: str, features: Sequence[dict[str, Any]], map_: Projection
) -> dict[str, Any]:
    """The FeatureCollection of features; its ``crs`` is null where they lie nowhere on earth."""
    found = {"type": "FeatureCollection", "name": name, "features": [*features]}
    return found if map_.turns else found | {"crs": None}


def write_feature(
    name: str, kind: str, coordinates: Any, properties: dict[str, Any]
) -> dict[str, Any]:
    """A feature with its geometry of ``kind``; properties that are empty are left out.

    >>> write_feature("a", "Point", [0.0, 0.0], {"name": "", "height": 3})["properties"]
    {'height': 3}
    """
    stated = {key: value for key, value in properties.items() if value != ""}
    geometry = {"type": kind, "coordinates": coordinates}
    return {"type": "Feature", "id": name, "properties": stated, "geometry": geometry}


def write_ring(ring: Points, map_: Projection) -> list[list[float]]:
    """The corners (n, 2) of a ring in metres as coordinates, the first again at the end."""
    return write_points(np.vstack([ring, ring[:1]]), map_)


def write_points(points: Points, map_: Projection) -> list[list[float]]:
    """Points (n, 2) in metres as coordinates: degrees to 1e-8 (a millimetre), or metres to a
    millimetre."""
    digits = 8 if map_.turns else 3
    found: list[list[float]] = coordinates_of(map_, points).round(digits).tolist()
    return found


def bearing_of(heading: float) -> float:
    """The bearing from north, clockwise in degrees, of a heading from east in radians.

    >>> bearing_of(0.0), bearing_of(math.pi)
    (90.0, 270.0)
    """
    return round((90.0 - math.degrees(heading)) % 360.0, 2)
