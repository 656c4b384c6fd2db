"""Which streets serve a site, and where one crosses over from them.

Judged by the lines and widths of the brief alone. A street serves a site that its surface comes
within ``verge`` metres of. From the parts of its line that lie outside or at the border, people and
engines cross straight over the verge, anywhere along them.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Flags, Shape, Shapes
from scenewright.domains.site.brief import Road, Site

AT = 0.5
"""Metres beyond half of its width by which the end of a line may stop short of the border."""


class JudgedStreets(NamedTuple):
    """The streets that serve a site, row by row: their whole ``surfaces``, the ground outside on
    which one crosses over from them (``crossings``, may be empty), the parts of their lines at the
    border or outside (``ends``, may be empty), which are roads, and which carry a fire engine."""

    surfaces: Shapes
    crossings: Shapes
    ends: Shapes
    road: Flags
    driven: Flags


def find_serving_streets(site: Site, floor: Shape) -> JudgedStreets:
    """The streets of a brief that serve a ``floor``, holes and all."""
    outer = shapely.Polygon(floor.exterior)
    shapely.prepare(outer)
    rows = [row for row in site.roads if _surface(row).distance(outer) <= site.verge + TOLERANCE]
    lines = [shapely.LineString(row.line) for row in rows]
    return JudgedStreets(
        _array([_surface(row) for row in rows]),
        _array([_cross(site, row, line, outer) for row, line in zip(rows, lines, strict=True)]),
        _array(
            [
                _leave(line, outer, 0.5 * row.width + AT)
                for row, line in zip(rows, lines, strict=True)
            ]
        ),
        np.array([row.kind == "road" for row in rows], bool),
        np.array(
            [row.kind == "road" or row.width >= site.fire_access - TOLERANCE for row in rows], bool
        ),
    )


def _surface(row: Road) -> Shape:
    return shapely.buffer(
        shapely.LineString(row.line), row.width / 2, cap_style="flat", join_style="mitre"
    )


def _cross(site: Site, row: Road, line: Shape, outer: Shape) -> Shape:
    """The ground outside that is crossed: of a line inside only where it runs nearer to the border
    than leaves room for an engine on its surface."""
    left = _leave(line, outer, max(0.5 * (site.fire_access - row.width), 0.0) + TOLERANCE)
    wide = shapely.buffer(left, 0.5 * row.width + site.verge, cap_style="square")
    return shapely.difference(wide, outer)


def _leave(line: Shape, outer: Shape, depth: float) -> Shape:
    """The parts of a line outside, or less than ``depth`` inside."""
    return shapely.difference(line, shapely.buffer(outer, -depth))


def _array(shapes: list[Shape]) -> Shapes:
    found = np.empty(len(shapes), object)
    found[:] = shapes
    return found
