"""The main colour of a model in a word."""

from __future__ import annotations

import colorsys
from collections.abc import Sequence

import numpy as np

from scenewright.core.catalog import Part

HUES = (
    (15, "red"),
    (45, "orange"),
    (70, "yellow"),
    (165, "green"),
    (255, "blue"),
    (290, "purple"),
    (345, "pink"),
    (360, "red"),
)
"""Hues in degrees up to which a colour has its name."""


def main_colour(parts: Sequence[Part]) -> str:
    """The name of the colour most of the surface has; empty for no surface.

    >>> from scenewright.catalog.assets import shipped
    >>> bed = shipped().assets["bathtub"]
    >>> main_colour(bed.mesh(bed.usual))
    'white'
    """
    areas: dict[str, float] = {}
    for part in parts:
        a, b, c = (part.vertices[part.faces[:, k]] for k in range(3))
        area = float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum())
        name = colour_name(part.material.color)
        areas[name] = areas.get(name, 0.0) + area * part.material.opacity
    return max(areas, key=lambda name: areas[name]) if areas else ""


def colour_name(colour: tuple[float, float, float]) -> str:
    """A colour's name; what is pale is white, grey or black, dark orange is brown.

    >>> colour_name((0.9, 0.9, 0.88)), colour_name((0.45, 0.3, 0.2)), colour_name((0.1, 0.2, 0.6))
    ('white', 'brown', 'blue')
    """
    hue, saturation, value = colorsys.rgb_to_hsv(*colour)
    if value < 0.16:
        return "black"
    if saturation < 0.13 or (saturation < 0.25 and value < 0.35):
        return "white" if value > 0.82 else "grey" if value > 0.25 else "black"
    name = next(name for most, name in HUES if hue * 360 <= most)
    if name in ("orange", "yellow", "red") and 10 < hue * 360 < 70:
        if saturation < 0.35 and value > 0.6:
            return "beige"
        if value < 0.62 or saturation < 0.55:
            return "brown"
    return name
