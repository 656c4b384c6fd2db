"""Lamps of a scene: where each gives its light, how much and of what colour."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from scenewright.core.catalog import Catalog
from scenewright.render.items import RenderItem

SMALLEST = 0.04
"""Least radius in metres of what glows."""


class Lamp(NamedTuple):
    """The thing that shines, the middle of what glows in its own frame, in metres, the radius of a
    ball about it, the luminous flux in lumens and the linear colour, of luminance 1."""

    item: RenderItem
    at: tuple[float, float, float]
    radius: float
    lumens: float
    color: tuple[float, float, float]


def lamps_of(items: Sequence[RenderItem], catalog: Catalog) -> Iterator[Lamp]:
    """Every piece of a kind that gives light."""
    for item in items:
        kind = catalog.kinds.get(str(item.extras.get("category", "")))
        if item.kind == "piece" and kind is not None and kind.lumens > 0 and item.parts:
            glowing = [part for part in item.parts if part.material.emission > 0]
            points = np.vstack([part.vertices for part in glowing or item.parts])
            low, high = points.min(0), points.max(0)
            middle = (low + high) / 2
            x, y, z = float(middle[0]), float(middle[1]), float((middle if glowing else high)[2])
            radius = max(float((high - low).max()) / 2 if glowing else 0.0, SMALLEST)
            yield Lamp(item, (x, y, z), radius, kind.lumens, color_of_kelvin(kind.kelvin))


def color_of_kelvin(kelvin: float) -> tuple[float, float, float]:
    """Linear sRGB of a black body between 1,667 and 25,000 K, of luminance 1; from chromaticity by
    cubics in 1,000 / T (B. Kim and others 2002), negative light left out.

    >>> [round(value, 2) for value in color_of_kelvin(2700.0)]
    [1.93, 0.81, 0.19]
    >>> [round(value, 1) for value in color_of_kelvin(6500.0)]
    [1.0, 1.0, 1.0]
    """
    t = 1000.0 / kelvin
    if kelvin < 4000.0:
        x = ((-0.2661239 * t - 0.2343589) * t + 0.8776956) * t + 0.179910
        cubic = (-1.1063814, -1.34811020, 2.18555832, -0.20219683)
        if kelvin >= 2222.0:
            cubic = (-0.9549476, -1.37418593, 2.09137015, -0.16748867)
    else:
        x = ((-3.0258469 * t + 2.1070379) * t + 0.2226347) * t + 0.240390
        cubic = (3.0817580, -5.87338670, 3.75112997, -0.37001483)
    y = float(np.polyval(cubic, x))
    bright = np.array([x / y, 1.0, (1.0 - x - y) / y])
    turn = np.array(
        [[3.2406, -1.5372, -0.4986], [-0.9689, 1.8758, 0.0415], [0.0557, -0.2040, 1.0570]]
    )
    red, green, blue = np.maximum(turn @ bright, 0.0).tolist()
    return red, green, blue
