"""From longitude and latitude to metres around the middle of a building.

Near a point of latitude φ0 on the WGS 84 ellipsoid, with n² = 1 − e² sin² φ0,

    x = a cos φ0 / n · (λ − λ0),    y = a (1 − e²) / n³ · (φ − φ0)

(equirectangular about φ0, with the radii of curvature of the prime vertical and the meridian;
Snyder 1987, Map Projections: A Working Manual, equations 4-19 and 4-20). Lengths along parallels
are wrong by about y tan φ / 6.4e6: at 60 degrees 1 mm on 30 m for what lies 130 m from the middle,
and 0.03 per cent at 1 km. Maps already in metres are only moved to their middle.
"""

from __future__ import annotations

import re
from typing import NamedTuple

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.space import Points

SEMI_MAJOR = 6_378_137.0
FLATTENING = 1 / 298.257223563
GREATEST_LATITUDE = 85.0
WIDEST_DEGREES = 0.5
FARTHEST = 5_000.0
LON_LAT = re.compile(r"CRS:?84|EPSG:+(4326|4979|4258|4269)$", re.IGNORECASE)
METRES = re.compile(
    r"EPSG:+(326\d\d|327\d\d|258\d\d|2154|2180|27700|28992|3067|31370|3346|5514)$", re.IGNORECASE
)
METRIC = (
    'GeoJSON is in degrees: write it from a site that has an "origin", or name its system of '
    'metres in "crs"'
)
EXPORT = "export it as longitude and latitude (WGS 84, EPSG:4326)"


class Projection(NamedTuple):
    """The origin in the units of the file, metres for one of them in x and y, and whether x is
    a longitude, which starts again after 360 degrees."""

    origin: tuple[float, float]
    scale: tuple[float, float]
    turns: bool


def projection(corners: Points, crs: str = "") -> Projection:
    """The projection for features whose corners ``(n, 2)`` are given, and the name of their
    reference system, if the file names one.

    Without a name, coordinates are degrees, as every reader takes them. InputError if they cannot
    be: over 180 and 90, or spread over more than half a degree (some 50 km) in their middle half.

    >>> paris = projection(np.array([[2.358, 48.877]]))
    >>> metres(paris, np.array([[2.359, 48.878]])).round(2).tolist()
    [[73.35, 111.21]]
    """
    degrees = _degrees(corners, crs)
    if degrees:
        corners = _unroll_longitudes(corners, corners[0, 0])
    x, y = np.median(corners, axis=0).tolist()
    if not degrees:
        return Projection((x, y), (1.0, 1.0), False)
    if abs(y) > GREATEST_LATITUDE:
        raise InputError(f"lies at latitude {y:.1f}, too near a pole to draw a plan", EXPORT)
    return Projection((x, y), _metres_per_degree(y), True)


def metres(map_: Projection, coordinates: Points) -> Points:
    """Coordinates ``(n, 2)`` of the file as metres about the origin."""
    if map_.turns:
        coordinates = _unroll_longitudes(coordinates, map_.origin[0])
    return (coordinates - np.array(map_.origin)) * np.array(map_.scale)


def coordinates_of(map_: Projection, points: Points) -> Points:
    """Points ``(n, 2)`` in metres about the origin as coordinates of the file.

    >>> paris = projection(np.array([[2.358, 48.877]]))
    >>> coordinates_of(paris, np.array([[73.35, 111.21]])).round(6).tolist()
    [[2.359, 48.878]]
    """
    found: Points = points / np.array(map_.scale) + np.array(map_.origin)
    if map_.turns:
        found[:, 0] = (found[:, 0] + 180.0) % 360.0 - 180.0
    return found


def _metres_per_degree(latitude: float) -> tuple[float, float]:
    squared = FLATTENING * (2 - FLATTENING)
    phi = np.deg2rad(latitude)
    n = np.sqrt(1 - squared * np.sin(phi) ** 2)
    across = SEMI_MAJOR * np.cos(phi) / n
    along = SEMI_MAJOR * (1 - squared) / n**3
    return float(np.deg2rad(across)), float(np.deg2rad(along))


def _unroll_longitudes(coordinates: Points, about: float) -> Points:
    """Longitudes within half a turn of ``about``, so that nothing is torn at 180 degrees."""
    turned = coordinates.copy()
    turned[:, 0] = about + (coordinates[:, 0] - about + 180.0) % 360.0 - 180.0
    return turned


def _degrees(corners: Points, crs: str) -> bool:
    """Whether the coordinates are longitude and latitude rather than metres."""
    fits = bool((np.abs(corners) <= (180.0, 90.0)).all())
    if crs and METRES.search(crs):
        return False
    if crs and not LON_LAT.search(crs):
        raise InputError(f"its reference system '{crs[:60]}' is not known here", EXPORT)
    if fits and (crs or _spread(_unroll_longitudes(corners, corners[0, 0])) <= WIDEST_DEGREES):
        return True
    if crs:
        raise InputError(
            f"its coordinates are no longitude and latitude, as '{crs[:60]}' says", EXPORT
        )
    if not fits:
        raise InputError(
            f"its coordinates, such as {corners[0, 0]:g}, {corners[0, 1]:g}, are no longitude and "
            "latitude",
            METRIC,
        )
    raise InputError(f"its coordinates spread over {_spread(corners):.3g} degrees", METRIC)


def _spread(corners: Points) -> float:
    """Extent of the middle half, which a few stray features do not change."""
    low, high = np.percentile(corners, [25, 75], axis=0)
    return float((high - low).max())
