"""Roofs over wings that cross: of several slopes over a place the highest is built.

So valleys lie where slopes meet, a lower ridge ends at the higher slope, and no eave runs on
through a wall. All slopes have one pitch.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.house_shapes import Wing
from scenewright.core.space import Points
from scenewright.geometry.mesh import Mesh
from scenewright.geometry.prisms import prism

FAR, SPECK = 1e3, 1e-3
"""Metres beyond any house; square metres of roof that are left out."""


class Slope(NamedTuple):
    """A slope in plan: its ground, a point of its eave, and the direction in which it rises."""

    ground: shapely.Polygon
    eave: Points
    rise: Points


def roof_over(wings: Sequence[Wing], eave: float, pitch: float, thick: float) -> list[Mesh]:
    """The slopes of gabled wings from ``eave`` on, ``thick`` metres, rising ``pitch`` a metre; each
    only where it is the highest.

    >>> cross = (Wing((-6, 6), (-2, 2), "x"), Wing((-2, 2), (-6, 6), "y"))
    >>> meshes = roof_over(cross, 3.0, 1.0, 0.2)
    >>> len(meshes), round(max(float(mesh.vertices[:, 2].max()) for mesh in meshes), 3)
    (8, 5.2)
    """
    cells = highest([slope for wing in wings for slope in slopes_of(wing)])
    return [_slab(part, slope, eave, pitch, thick) for part, slope in cells]


def highest(slopes: Sequence[Slope]) -> list[tuple[shapely.Polygon, Slope]]:
    """Where each of some slopes of one pitch is the highest."""
    made = []
    for k, slope in enumerate(slopes):
        rest = slope.ground
        for other, it in enumerate(slopes):
            if other != k and it.ground.intersects(rest):
                rest = shapely.difference(rest, _higher(it, slope, other < k))
        for part in shapely.get_parts(rest):
            if part.geom_type == "Polygon" and part.area > SPECK:
                made.append((part, slope))
    return made


def slopes_of(wing: Wing) -> tuple[Slope, Slope]:
    """Both slopes of a wing."""
    across, length = (wing.y, wing.x) if wing.along == "x" else (wing.x, wing.y)
    middle, axis = sum(across) / 2, np.array([0.0, 1.0] if wing.along == "x" else [1.0, 0.0])
    found = []
    for low, sign in ((across[0], 1.0), (across[1], -1.0)):
        a, b = sorted((low, middle))
        ends = (length[0], a, length[1], b) if wing.along == "x" else (a, length[0], b, length[1])
        found.append(Slope(shapely.box(*ends), low * axis, sign * axis))
    return found[0], found[1]


def _higher(one: Slope, other: Slope, even: bool) -> shapely.Geometry:
    """Where one slope is higher than another, or ``even`` as high: its ground beyond the line along
    which they meet."""
    step = one.rise - other.rise
    offset = float(one.rise @ one.eave - other.rise @ other.eave)
    size = float(np.hypot(*step))
    if size < 1e-9:
        more = -offset > 1e-6 or (even and abs(offset) <= 1e-6)
        return one.ground if more else shapely.Polygon()
    way = step / size
    at, along = way * offset / size, np.array([-way[1], way[0]])
    corners = [at - FAR * along, at + FAR * along]
    half = shapely.Polygon([*corners, *(corner + FAR * way for corner in corners[::-1])])
    return shapely.intersection(one.ground, half)


def _slab(part: shapely.Polygon, slope: Slope, eave: float, pitch: float, thick: float) -> Mesh:
    """A piece of a slope as a body."""
    sound = shapely.orient_polygons(part)
    outline, *holes = [
        shapely.get_coordinates(ring)[:-1] for ring in (sound.exterior, *sound.interiors)
    ]
    vertices, faces, _ = prism(outline, 0.0, thick, holes)
    vertices[:, 2] += eave + pitch * ((vertices[:, :2] - slope.eave) @ slope.rise)
    return Mesh(vertices, faces)
