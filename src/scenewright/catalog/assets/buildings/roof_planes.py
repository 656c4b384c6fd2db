"""Roofs of the houses of villages as planes over parts of their footprint: what a city model of
level of detail 2 holds. Eaves, pitch and wings are those that draw the house
(:mod:`~scenewright.catalog.assets.buildings.rural_houses`); chimneys, overhangs and steps of gables
are left out."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.court_houses import YARD, court_heights
from scenewright.catalog.assets.buildings.house_looks import read_asset
from scenewright.catalog.assets.buildings.house_roofs import SPECK, Slope, highest, slopes_of
from scenewright.catalog.assets.buildings.house_shapes import (
    Wing,
    cells_of,
    is_convex,
    list_rectangles,
    saddle_sides,
)
from scenewright.catalog.assets.buildings.rural_houses import (
    THICK,
    HouseBody,
    body_of,
    gable_heights,
    hip_heights,
    roofing_of,
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
    words = read_asset(asset)
    if words is None:
        return ()
    form, style, roof = words
    body = body_of(size, footprint, style, form)
    roofing, wings = roofing_of(body, roof)
    if roofing == "flat":
        return flat_roof(body.outline, size.height)
    if roofing == "court":
        return _court(size)
    return _hips(body) if roofing == "hips" else _gables(body, wings)


def flat_roof(outline: Footprint, height: float) -> tuple[RoofPlane, ...]:
    """A level roof at a height."""
    return (RoofPlane(shapely.Polygon(outline), (0.0, 0.0, height)),)


def _gables(body: HouseBody, wings: tuple[Wing, ...]) -> tuple[RoofPlane, ...]:
    heights = gable_heights(body, wings)
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


def _hips(body: HouseBody) -> tuple[RoofPlane, ...]:
    outline, height = body.outline, body.size.height
    eave, pitch = hip_heights(body)
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
