"""Where on earth a map lies: its reference system, and the place that becomes 0, 0."""

from __future__ import annotations

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.map_options import MapOptions, place_in
from scenewright.core.projection import Projection, metres, projection, spreads_as_degrees
from scenewright.core.reference_system import from_degrees, system_of
from scenewright.core.space import Points
from scenewright.ground.maps.chosen_ground import choose_around, choose_by_id
from scenewright.ground.maps.features import Collection

FARTHEST = 100_000.0
"""Metres from the middle of a map beyond which no origin of it lies."""


def place_map(found: Collection, options: MapOptions) -> Collection:
    """The features with the reference system and the origin that the ``options`` name. Without a
    system, coordinates of a plane that cannot be degrees are metres. Raises :class:`InputError`
    for a system that is not known, and for an origin far from the map."""
    if options.layers and not any(feature.layer for feature in found.features):
        raise InputError("--layer is given, but the file has no layers", "leave it out")
    crs = options.crs or found.crs
    system_of(crs)
    corners = corners_of(found)
    plane = found.plane and not crs and not spreads_as_degrees(corners)
    placed = found._replace(crs=crs, plane=plane)
    if not len(corners):
        return placed
    if options.origin is not None:
        placed = placed._replace(origin=_find_place(placed, corners, options.origin, "--origin"))
    if not options.site:
        return placed
    stated = place_in(options.site)
    if stated is None:
        return choose_by_id(placed, options.site)
    at = _find_place(placed, corners, stated, "--site")
    return choose_around(placed, at, projection_of(placed._replace(origin=at), corners))


def projection_of(found: Collection, corners: Points) -> Projection:
    """The projection of a map, about its origin if one is given, else about the middle of
    ``corners`` (n, 2) of it."""
    map_ = projection(corners, found.crs, found.plane)
    if found.origin is None:
        return map_
    at = projection(np.array([found.origin], float), found.crs, found.plane)
    return at._replace(origin=found.origin, swapped=map_.swapped)


def corners_of(found: Collection) -> Points:
    """All corners (n, 2) of areas and lines, as the file lists them."""
    rings = [ring for f in found.features for part in (*f.polygons, f.lines) for ring in part]
    return np.vstack(rings) if rings else np.zeros((0, 2))


def _find_place(
    found: Collection, corners: Points, given: tuple[float, float], option: str
) -> tuple[float, float]:
    """A place in coordinates of the system of a map: it may be given so, or in longitude and
    latitude. InputError, naming the ``option``, where it lies far from the map."""
    map_ = projection(corners, found.crs, found.plane)._replace(swapped=False)
    listed = [given]
    if map_.system and not map_.system.degrees and abs(given[0]) <= 180 and abs(given[1]) <= 90:
        listed.append(from_degrees(map_.system, *given))
    away = [_distance(map_, place) for place in listed]
    if min(away) > FARTHEST:
        x, y = map_.origin
        raise InputError(
            f"{option} {given[0]:.10g},{given[1]:.10g} is {min(away) / 1000:,.0f} km from the map",
            f"give a place on it, such as {x:.10g},{y:.10g}",
        )
    return listed[int(np.argmin(away))]


def _distance(map_: Projection, place: tuple[float, float]) -> float:
    """Metres from the middle of a map."""
    found = float(np.hypot(*metres(map_, np.array([place], float))[0]))
    return found if np.isfinite(found) else np.inf
