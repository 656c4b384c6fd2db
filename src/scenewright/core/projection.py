"""From the coordinates of a map to metres of ground around the middle of what it shows.

Near a point of latitude φ0 on the WGS 84 ellipsoid, with n² = 1 − e² sin² φ0,

    x = a cos φ0 / n · (λ − λ0),    y = a (1 − e²) / n³ · (φ − φ0)

(equirectangular about φ0, with the radii of curvature of the prime vertical and the meridian;
Snyder 1987, Map Projections: A Working Manual, equations 4-19 and 4-20). Lengths along parallels
are wrong by about y tan φ / 6.4e6: at 60 degrees 1 mm on 30 m for what lies 130 m from the middle,
and 0.03 per cent at 1 km. A map of a plane is moved to its middle, its unit made metres, and what
the plane stretches there is taken back (:mod:`scenewright.core.reference_system`).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from scenewright.core.errors import InputError
from scenewright.core.reference_system import (
    ReferenceSystem,
    covers,
    place_of,
    stretch_at,
    system_of,
)
from scenewright.core.space import Points

SEMI_MAJOR = 6_378_137.0
FLATTENING = 1 / 298.257223563
GREATEST_LATITUDE = 85.0
WIDEST_DEGREES = 0.5
FARTHEST = 5_000.0
METRIC = (
    'name its system of metres with --crs EPSG:…, or write it from a brief that has an "origin"'
)
EXPORT = "export it as longitude and latitude (WGS 84, EPSG:4326)"


class Projection(NamedTuple):
    """The origin in the units of the file, metres for one of them in x and y, whether x is
    a longitude, which starts again after 360 degrees, the reference system if one is named, the
    longitude and latitude of the origin, if known, and whether the file lists y before x."""

    origin: tuple[float, float]
    scale: tuple[float, float]
    turns: bool
    system: ReferenceSystem | None = None
    where: tuple[float, float] | None = None
    swapped: bool = False

    @property
    def turn(self) -> float:
        """A whole turn in units of the file."""
        return 360.0 / (self.system.length if self.system else 1.0)

    @property
    def system_in_words(self) -> str:
        """The reference system, for a report."""
        stated = self.system.label if self.system else ""
        assumed = "longitude and latitude (WGS 84)" if self.turns else "none stated: local metres"
        turned = ", listed y before x" if self.swapped else ""
        return (stated or assumed) + turned

    @property
    def unit_in_words(self) -> str:
        """The unit of its coordinates, for a report: how long it is where it is no metre."""
        if self.turns:
            return "degree"
        unit = self.system.unit if self.system else "metre"
        return unit if self.scale[0] == 1.0 else f"{unit} of {self.scale[0]:.4g} m on the ground"


def projection(corners: Points, named: object = "", plane: bool = False) -> Projection:
    """The projection for features whose corners ``(n, 2)`` are given, and the name of their
    reference system, if the file names one.

    Without a name, coordinates are degrees, as every reader of GeoJSON takes them, or metres of a
    ``plane``. InputError for a system that is not known, and where coordinates cannot be degrees:
    over 180 and 90, or spread over more than half a degree (some 50 km) in their middle half.

    >>> paris = projection(np.array([[2.358, 48.877]]))
    >>> metres(paris, np.array([[2.359, 48.878]])).round(2).tolist()
    [[73.35, 111.21]]
    """
    system = system_of(named)
    if not (system.degrees if system else not plane):
        return _on_plane(corners, system)
    degree = system.length if system else 1.0
    turned = _turned(corners, system)
    corners = corners[:, ::-1] if turned else corners
    _check_degrees(corners * degree, system)
    rolled = _unroll_longitudes(corners * degree, float(corners[0, 0]) * degree)
    x, y = np.median(rolled, axis=0).tolist()
    if abs(y) > GREATEST_LATITUDE:
        raise InputError(f"lies at latitude {y:.1f}, too near a pole to draw a plan", EXPORT)
    across, along = _metres_per_degree(y)
    scale = (across * degree, along * degree)
    return Projection((x / degree, y / degree), scale, True, system, (x, y), turned)


def _on_plane(corners: Points, system: ReferenceSystem | None) -> Projection:
    turned = _turned(corners, system)
    x, y = np.median(corners[:, ::-1] if turned else corners, axis=0).tolist()
    if system is None:
        return Projection((x, y), (1.0, 1.0), False)
    if len(corners) > 2 and np.ptp(corners, axis=0).max() < 1 and abs(x) <= 180 and abs(y) <= 90:
        fault = f"its coordinates, such as {x:g}, {y:g}, are degrees, not of '{system.label[:60]}'"
        raise InputError(fault, "name the reference system that they are of, or none")
    length = system.length / stretch_at(system, x, y)
    return Projection((x, y), (length, length), False, system, place_of(system, x, y), turned)


def projection_at(origin: tuple[float, float], named: str = "") -> Projection:
    """The projection by which a place of a reference system is the origin: that by which a map was
    read, from what is kept of it.

    >>> projection_at((691_000.0, 5_331_000.0), "EPSG:25832").scale
    (1.0, 1.0)
    """
    found = projection(np.array([origin], float), named, plane=True)
    return found._replace(origin=origin, swapped=False)


def metres(map_: Projection, coordinates: Points) -> Points:
    """Coordinates ``(n, 2)`` of the file as metres about the origin."""
    if map_.swapped:
        coordinates = coordinates[:, ::-1]
    if map_.turns:
        coordinates = _unroll_longitudes(coordinates, map_.origin[0], map_.turn)
    return (coordinates - np.array(map_.origin)) * np.array(map_.scale)


def coordinates_of(map_: Projection, points: Points) -> Points:
    """Points ``(n, 2)`` in metres about the origin as coordinates of the system, x first.

    >>> paris = projection(np.array([[2.358, 48.877]]))
    >>> coordinates_of(paris, np.array([[73.35, 111.21]])).round(6).tolist()
    [[2.359, 48.878]]
    """
    found: Points = points / np.array(map_.scale) + np.array(map_.origin)
    if map_.turns:
        found[:, 0] = (found[:, 0] + map_.turn / 2) % map_.turn - map_.turn / 2
    return found


def _metres_per_degree(latitude: float) -> tuple[float, float]:
    squared = FLATTENING * (2 - FLATTENING)
    phi = np.deg2rad(latitude)
    n = np.sqrt(1 - squared * np.sin(phi) ** 2)
    across = SEMI_MAJOR * np.cos(phi) / n
    along = SEMI_MAJOR * (1 - squared) / n**3
    return float(np.deg2rad(across)), float(np.deg2rad(along))


def _unroll_longitudes(coordinates: Points, about: float, turn: float = 360.0) -> Points:
    """Longitudes within half a turn of ``about``, so that nothing is torn at 180 degrees."""
    turned = coordinates.copy()
    turned[:, 0] = about + (coordinates[:, 0] - about + turn / 2) % turn - turn / 2
    return turned


def _turned(corners: Points, system: ReferenceSystem | None) -> bool:
    """Whether coordinates are listed y before x: only so they lie where their system is used."""
    if system is None:
        return False
    x, y = np.median(corners, axis=0).tolist()
    return not covers(system, x, y) and covers(system, y, x)


def _check_degrees(corners: Points, system: ReferenceSystem | None) -> None:
    """InputError where coordinates, in degrees, are no longitude and latitude."""
    fits = bool((np.abs(corners) <= (180.0, 90.0)).all())
    if (fits and system) or spreads_as_degrees(corners):
        return
    if system:
        raise InputError(
            f"its coordinates are no longitude and latitude, as '{system.label[:60]}' says", EXPORT
        )
    if not fits:
        raise InputError(
            f"its coordinates, such as {corners[0, 0]:g}, {corners[0, 1]:g}, are no longitude and "
            "latitude",
            METRIC,
        )
    raise InputError(f"its coordinates spread over {_spread(corners):.3g} degrees", METRIC)


def spreads_as_degrees(corners: Points) -> bool:
    """Whether corners ``(n, 2)`` can be degrees of a place: on the globe, and spread no farther
    than a town.

    >>> spreads_as_degrees(np.array([[2.358, 48.877], [2.359, 48.878]]))
    True
    >>> spreads_as_degrees(np.array([[0.0, 0.0], [12.0, 0.0], [80.0, 60.0]]))
    False
    """
    fits = bool((np.abs(corners) <= (180.0, 90.0)).all())
    if not fits or not len(corners):
        return fits
    return _spread(_unroll_longitudes(corners, float(corners[0, 0]))) <= WIDEST_DEGREES


def _spread(corners: Points) -> float:
    """Extent of the middle half, which a few stray features do not change."""
    low, high = np.percentile(corners, [25, 75], axis=0)
    return float((high - low).max())
