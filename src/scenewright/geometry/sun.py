"""Where the sun stands, and how long it shines on the sides of buildings.

Hours are in true solar time: at 12 the sun is due south (north of it, or overhead, where it
stands that way). Latitudes are in degrees, south negative; directions in the plan's own axes,
``north`` being the angle of north counter-clockwise from +x.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from scenewright.geometry.box_grid import BoxGrid, box_grid, first_box
from scenewright.geometry.boxes import Floats
from scenewright.geometry.compiled import compiled, inlined

SILL = 0.9
"""Height of the ground floor's window sills, metres: where sunlight is counted (GB 50180)."""
FIRST_HOUR, LAST_HOUR = 8.0, 16.0
"""The hours that count on the day of great cold, 20 January (GB 50180); 9 to 15 at the winter
solstice."""
MINUTES = 15.0
TILT = np.deg2rad(23.437)
"""The angle of the ecliptic to the equator."""
REFRACTED = np.deg2rad(-0.833)
"""Altitude of the sun's middle as its rim appears at the horizon, by refraction: what almanacs
call sunrise."""


def declination(day: ArrayLike) -> Floats:
    """Declination of the sun in radians at noon of ``day`` of the year (1 is the first of January).

    With n = day - 0.5 days, the mean longitude L = 280.460° + 0.9856474° n and the anomaly
    g = 357.528° + 0.9856003° n, the sun's longitude is λ = L + 1.915° sin g + 0.020° sin 2g and
    sin δ = sin 23.437° sin λ: the almanac's own approximation (J. J. Michalsky, *The Astronomical
    Almanac's algorithm for approximate solar position*, 1988), for the mean of leap years and
    others. Within 0.25 degrees of the sun in every year from 2001 to 2040, where the better-known
    series of J. W. Spencer (1971) is off by up to 0.57.

    >>> np.rad2deg(declination([20, 79.5, 172, 266, 355])).round(1).tolist()
    [-20.1, 0.1, 23.4, -0.1, -23.4]
    """
    past = np.asarray(day, np.float64) - 0.5
    anomaly = np.deg2rad(357.528 + 0.9856003 * past)
    longitude = 280.460 + 0.9856474 * past + 1.915 * np.sin(anomaly) + 0.020 * np.sin(2 * anomaly)
    return np.asarray(np.arcsin(np.sin(TILT) * np.sin(np.deg2rad(longitude))))


def sun_position(latitude: float, day: float, hours: ArrayLike) -> tuple[Floats, Floats]:
    """Azimuth, clockwise from north in [0, 2π), and altitude of the sun's middle, radians.

    With latitude φ, declination δ and the hour angle H = (hour - 12) π/12 the sun stands towards
    east -cos δ sin H, north cos φ sin δ - sin φ cos δ cos H, up sin φ sin δ + cos φ cos δ cos H.

    >>> azimuth, altitude = np.rad2deg(sun_position(40.0, 80, [6.0, 12.0]))
    >>> azimuth.round().tolist(), altitude.round().tolist()
    ([90.0, 180.0], [0.0, 50.0])
    """
    east, north, up = _towards(latitude, day, np.asarray(hours, np.float64))
    return np.arctan2(east, north) % (2.0 * np.pi), np.arcsin(np.clip(up, -1.0, 1.0))


def _towards(latitude: float, day: float, hours: Floats) -> tuple[Floats, Floats, Floats]:
    phi, delta, turn = np.deg2rad(latitude), declination(day), (hours - 12.0) * np.pi / 12.0
    return (
        -np.cos(delta) * np.sin(turn),
        np.cos(phi) * np.sin(delta) - np.sin(phi) * np.cos(delta) * np.cos(turn),
        np.sin(phi) * np.sin(delta) + np.cos(phi) * np.cos(delta) * np.cos(turn),
    )


def sunrise(latitude: float, day: float, altitude: float = 0.0) -> float:
    """Hour of true solar time at which the sun's middle passes ``altitude`` (radians) upwards; it
    sets as long after noon. 0 if it stays above all day, 12 if it never gets there.

    cos H = (sin a - sin φ sin δ) / (cos φ cos δ).

    >>> round(sunrise(40.0, 355), 2), sunrise(80.0, 355), sunrise(80.0, 172)
    (7.42, 12.0, 0.0)
    """
    phi, delta = np.deg2rad(latitude), float(declination(day))
    down = np.sin(altitude) - np.sin(phi) * np.sin(delta)
    turn = np.arccos(np.clip(down / max(np.cos(phi) * np.cos(delta), 1e-12), -1.0, 1.0))
    return float(12.0 - 12.0 * turn / np.pi)


def sun_path(
    latitude: float,
    day: float,
    hours: tuple[float, float] = (FIRST_HOUR, LAST_HOUR),
    minutes: float = MINUTES,
    north: float = np.pi / 2,
) -> Floats:
    """The sun through the day: rows ``(s, 4)`` of the unit direction towards it and the hours it
    stands for; only while it is up.

    The time between ``hours`` is cut into steps of about ``minutes``; each is stood for by its
    middle.

    >>> path = sun_path(40.0, 20)
    >>> path.shape, float(path[:, 3].sum())
    ((32, 4), 8.0)
    """
    count = max(round((hours[1] - hours[0]) * 60.0 / minutes), 1)
    length = (hours[1] - hours[0]) / count
    middles = np.asarray(hours[0] + (np.arange(count) + 0.5) * length, np.float64)
    east, ahead, up = _towards(latitude, day, middles)
    x = east * np.sin(north) + ahead * np.cos(north)
    y = ahead * np.sin(north) - east * np.cos(north)
    rows = np.stack([x, y, up, np.full(count, length)], 1)
    return np.ascontiguousarray(rows[up > 0.0])


def open_hours(headings: ArrayLike, path: Floats) -> Floats:
    """Hours of sun ``(n, 4)`` on the front, left, back and right side of boxes with ``headings``
    (n,) that have nothing in front of them: while the sun stands before the side.

    >>> open_hours([-np.pi / 2], sun_path(40.0, 20)).tolist()
    [[8.0, 4.0, 0.0, 4.0]]
    """
    turns = np.asarray(headings, np.float64)[:, None] + np.arange(4) * np.pi / 2
    outward = np.stack([np.cos(turns), np.sin(turns)], -1)
    return np.asarray((outward @ path[:, :2].T > 0.0) @ path[:, 3])


def sun_hours(
    boxes: ArrayLike,
    heights: ArrayLike,
    path: Floats,
    obstacles: tuple[ArrayLike, ArrayLike] | None = None,
    places: int = 1,
    sill: float = SILL,
) -> Floats:
    """Hours of direct sun ``(n, 4)`` on the front, left, back and right side of buildings.

    ``boxes`` (n, 5) and ``heights`` (n,) in metres; ``path`` from :func:`sun_path`;
    ``obstacles`` boxes (m, 5) and heights (m,) that only throw shadows. Counted at the height of
    ``sill`` above the ground, in the middle of each side, or as the mean over ``places`` spread
    evenly along it. A place is lit while the sun stands before the side and the ray to it meets
    no other building. 6,000 buildings take about a second.

    >>> rows = [[0, 0, -np.pi / 2, 40, 12], [0, 30, -np.pi / 2, 40, 12]]
    >>> sun_hours(rows, [18.0, 18.0], sun_path(40.0, 20))[:, 0].tolist()
    [8.0, 1.5]
    """
    every, tops = np.asarray(boxes, np.float64).reshape(-1, 5), np.asarray(heights, np.float64)
    count = len(every)
    if obstacles is not None:
        every = np.concatenate([every, np.asarray(obstacles[0], np.float64).reshape(-1, 5)])
        tops = np.concatenate([tops, np.asarray(obstacles[1], np.float64)])
    hours = np.zeros((count, 4))
    light(box_grid(every, tops), path, places, sill, hours)
    return hours


@compiled
def light(grid: BoxGrid, path: Floats, places: int, sill: float, hours: Floats) -> None:
    """Write the hours of sun ``(n, 4)`` on the sides of the first n boxes of a grid."""
    top = highest(grid)
    for i in range(hours.shape[0]):
        for side in range(4):
            hours[i, side] = lit_hours(grid, path, places, sill, top, i, side)


@compiled
def highest(grid: BoxGrid) -> float:
    """The height of the highest box."""
    top = 0.0
    for i in range(grid.heights.shape[0]):
        top = max(top, grid.heights[i])
    return top


@inlined
def lit_hours(
    grid: BoxGrid, path: Floats, places: int, sill: float, top: float, i: int, side: int
) -> float:
    """Hours of sun on a side of a box, none of them higher than ``top``.

    ``path`` (k, 4) directions to the sun and hours; ``sill`` and ``top`` in metres.
    """
    x, y, c, s = grid.frames[i, 0], grid.frames[i, 1], grid.frames[i, 2], grid.frames[i, 3]
    for _ in range(side):
        c, s = -s, c
    along, out = grid.frames[i, 4], grid.frames[i, 5]
    if side % 2:
        along, out = out, along
    z, hours = min(sill, grid.heights[i]), 0.0
    for k in range(path.shape[0]):
        ax, ay, az = path[k, 0], path[k, 1], path[k, 2]
        if ax * c + ay * s <= 0.0:
            continue
        for place in range(places):
            shift = along * ((2.0 * place + 1.0) / places - 1.0)
            px, py = x + out * c - shift * s, y + out * s + shift * c
            met, _, _, _ = first_box(grid, px, py, z, ax, ay, az, (top - z) / az, i)
            if met < 0:
                hours += path[k, 3] / places
    return hours
