"""Roofs of the houses of villages as planes over parts of their footprint: what a city model of
level of detail 2 holds. Eaves, pitch and wings are those that draw the house
(:mod:`~scenewright.catalog.assets.buildings.rural_houses`); chimneys, overhangs and steps of gables
are left out."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.house_roofs import SPECK, Slope, highest, slopes_of
from scenewright.catalog.assets.buildings.house_shapes import (
    Wing,
    cells_of,
    is_convex,
    list_rectangles,
    saddle_sides,
    tallest,
)
from scenewright.catalog.assets.buildings.rural_houses import (
    LOOKS,
    LOWEST,
    THICK,
    YARD,
    court_heights,
    form_of,
    gable_heights,
)
from scenewright.core.footprint import Footprint
from scenewright.core.scene import Size


class RoofPlane(NamedTuple):
    """A plane of a roof: its ground in the plan, and (a, b, c) of its height a x + b y + c above
    the underside of the house, in metres."""

    ground: shapely.Polygon
    plane: tuple[float, float, float]


def roof_planes(asset: str, size: Size, footprint: Footprint) -> tuple[RoofPlane, ...]:
    """The planes of the roof of a drawn house, in its local frame; none of another model.

    >>> rows = roof_planes("house_rural_gabled", Size(10, 6, 8), ())
    >>> len(rows), round(max(row.plane[2] for row in rows), 2)
    (2, 7.45)
    """
    kind, _, rest = asset.partition("_")
    style, _, roof = rest.partition("_")
    if kind != "house" or style not in LOOKS or roof not in ("gabled", "hipped", "flat"):
        return ()
    w, d = size.width / 2, size.depth / 2
    outline = footprint or ((-w, -d), (w, -d), (w, d), (-w, d))
    form, wings = form_of(size, outline, style, roof)
    if form == "flat":
        return flat_roof(outline, size.height)
    if form == "court":
        return _court(size)
    if form == "hips":
        return _hips(outline, size.height, LOOKS[style].pitch)
    return _gables(size, outline, wings, style)


def flat_roof(outline: Footprint, height: float) -> tuple[RoofPlane, ...]:
    """A level roof at a height."""
    return (RoofPlane(shapely.Polygon(outline), (0.0, 0.0, height)),)


def _gables(
    size: Size, outline: Footprint, wings: tuple[Wing, ...], style: str
) -> tuple[RoofPlane, ...]:
    area = float(shapely.Polygon(outline).area)
    heights = gable_heights(size, wings, LOOKS[style], area, style == "hui")
    cells = highest([slope for wing in wings for slope in slopes_of(wing)])
    return _planes(cells, heights.eave + THICK, heights.pitch)


def _court(size: Size) -> tuple[RoofPlane, ...]:
    """Four slopes down to a court, and its ground."""
    w, d = size.width / 2, size.depth / 2
    court_x, court_y, low, high = court_heights(size)
    inner = [(-court_x, -court_y), (court_x, -court_y), (court_x, court_y), (-court_x, court_y)]
    outer = [(-w, -d), (w, -d), (w, d), (-w, d)]
    fall_x, fall_y = (high - low) / (w - court_x), (high - low) / (d - court_y)
    rises = ((0.0, -fall_y), (fall_x, 0.0), (0.0, fall_y), (-fall_x, 0.0))
    found = [RoofPlane(shapely.Polygon(inner), (0.0, 0.0, YARD))]
    for k, (a, b) in enumerate(rises):
        after = (k + 1) % 4
        ground = shapely.Polygon([outer[k], outer[after], inner[after], inner[k]])
        level = low - a * inner[after][0] - b * inner[after][1]
        found.append(RoofPlane(ground, (a, b, level)))
    return tuple(found)


def _hips(outline: Footprint, height: float, pitch: float) -> tuple[RoofPlane, ...]:
    half = tallest(outline)
    rise = min(pitch * half, height - LOWEST)
    eave, pitch = height - rise, rise / half
    boxes = [shapely.box(*row) for row in list_rectangles(outline)]
    if boxes:
        rings = [
            shapely.get_coordinates(shapely.orient_polygons(box).exterior)[:-1] for box in boxes
        ]
        return _planes(highest([one for ring in rings for one in _sides(ring)]), eave, pitch)
    if is_convex(outline):
        cells = [(slope.ground, slope) for slope in _sides(np.array(outline))]
        return _planes(cells, eave, pitch)
    halves, reach = saddle_sides(outline)
    made = [(part, Slope(part, at, rise)) for part, at, rise in halves]
    return _planes(made, eave, (height - eave) / max(reach, 1e-9))


def _sides(ring: np.ndarray) -> list[Slope]:
    """The slopes over a convex ring, one a side, each where it is the lowest."""
    rows = [row for row in cells_of(ring) if len(row[0]) > 2]
    made = [(shapely.buffer(shapely.Polygon(cell), 0.0), at, inward) for cell, at, inward in rows]
    return [Slope(ground, at, inward) for ground, at, inward in made if ground.area > SPECK]


def _planes(
    cells: list[tuple[shapely.Polygon, Slope]], eave: float, pitch: float
) -> tuple[RoofPlane, ...]:
    found = []
    for part, slope in cells:
        a, b = (pitch * slope.rise).tolist()
        found.append(RoofPlane(part, (a, b, eave - float(pitch * (slope.rise @ slope.eave)))))
    return tuple(found)
