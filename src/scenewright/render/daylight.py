"""Times of day: light of sun and sky, for photographs and for the sun in files."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Light = tuple[float, float, float]


class Daylight(NamedTuple):
    """Light of the sun, of the ground, the horizon and the zenith, as linear colours in kilolux and
    kilocandela a square metre; how bright what glows is, a unit of emission; where the sun stands:
    radians above the ground, and counter-clockwise from the east (-pi / 2: in the south)."""

    sun: Light
    ground: Light
    horizon: Light
    zenith: Light
    glow: float
    height: float = float(np.deg2rad(24.0))
    azimuth: float = float(np.deg2rad(-145.0))


HOURS = {
    "morning": Daylight(
        (20.0, 15.0, 9.5), (0.9, 0.9, 0.6), (3.4, 3.1, 2.7), (1.3, 1.8, 2.6), 0.8, 0.26, -0.35
    ),
    "noon": Daylight(
        (78.0, 72.0, 62.0), (2.6, 2.7, 1.9), (4.6, 5.0, 5.4), (2.2, 3.0, 4.4), 0.8, 0.94, -1.5
    ),
    "day": Daylight((30.0, 25.0, 18.0), (1.2, 1.4, 0.8), (3.6, 3.7, 3.6), (1.7, 2.2, 3.0), 0.8),
    "dusk": Daylight(
        (0.0, 0.0, 0.0), (0.005, 0.006, 0.0045), (0.075, 0.05, 0.04), (0.017, 0.024, 0.042), 0.5
    ),
    "night": Daylight(
        (0.0, 0.0, 0.0), (0.0006,) * 3, (0.0012, 0.0014, 0.002), (0.0006, 0.0008, 0.0014), 0.5
    ),
}
"""An hour after sunrise, noon, a late afternoon, each under a clear sky; a quarter of an hour after
sunset; a night with light of a town in the sky."""


class Sun(NamedTuple):
    """The direction to the sun (3,), its illuminance across that in lux and its linear colour."""

    towards: NDArray[np.float64]
    lux: float
    color: Light


def towards(azimuth: float, height: float) -> NDArray[np.float64]:
    """The unit direction (3,) to the sun, z up.

    >>> towards(-np.pi / 2, 0.0).round(6).tolist()
    [0.0, -1.0, 0.0]
    """
    level = np.cos(height)
    return np.array([level * np.cos(azimuth), level * np.sin(azimuth), np.sin(height)])


def sun_at(hour: str) -> Sun | None:
    """The sun at an hour of :data:`HOURS`; None where none is said, or it has set.

    >>> sun_at("noon").lux, sun_at("dusk"), sun_at("")
    (78000.0, None, None)
    """
    light = HOURS.get(hour)
    if light is None or not any(light.sun):
        return None
    top = max(light.sun)
    red, green, blue = (share / top for share in light.sun)
    return Sun(towards(light.azimuth, light.height), 1000.0 * top, (red, green, blue))
