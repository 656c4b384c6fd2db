"""Kerbs: stones between carriageway and pavement, let down where people cross and cars drive on."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.scene import Fall
from scenewright.ground.outlines import GRID, MITRE, lines
from scenewright.ground.ways.junctions import Crossing
from scenewright.ground.works import Pathway

STONE = 0.15
"""Width in metres of a kerb (DIN EN 1340: 125 to 180 mm)."""
LET_DOWN, RAMP = 0.05, 0.6
"""Height in metres of kerbs let down, 0.02 above the carriageway (DIN 18040-3: 0.03 at most), and
over how many metres the pavement falls to them."""
ONWARD = 3.0
"""Metres beyond the ends of a crossing within which its kerbs lie: corners are round."""
LED_ON = 4.0
"""Metres from a carriageway within which the end of a lane leads on to it: the widest pavement, and
the ground between it and the lane."""


class KerbedPavement(NamedTuple):
    """Pavements without their edge, the stones and slopes of the edge, and how those fall."""

    pavement: shapely.Geometry
    kerb: shapely.Geometry
    fall: Fall | None


def edge_pavement(
    pavement: shapely.Geometry,
    lanes: shapely.Geometry,
    crossings: Sequence[Crossing],
    pathways: Sequence[Pathway],
) -> KerbedPavement:
    """Pavements beside carriageways (``lanes``) with their kerbs, let down at ``crossings`` and
    where a lane or drive of some ``pathways`` comes in.

    >>> street, lane = shapely.box(0, 0, 40, 10), shapely.box(0, 2, 40, 8)
    >>> found = edge_pavement(shapely.difference(street, lane), lane, [], [])
    >>> round(found.kerb.area, 2), found.fall
    (12.0, None)
    """
    if shapely.is_empty(pavement):
        return KerbedPavement(pavement, shapely.Polygon(), None)
    beside = shapely.buffer(lanes, STONE, join_style="mitre", mitre_limit=MITRE)
    low = shapely.union_all([*_lower_kerbs(lanes, crossings), *_open(pavement, lanes, pathways)])
    straight = shapely.buffer(low, RAMP, cap_style="flat", quad_segs=1)
    around = shapely.union(straight, shapely.buffer(low, RAMP, quad_segs=1))
    zones = (straight, shapely.difference(around, straight), shapely.difference(beside, around))
    found = shapely.intersection(pavement, zones, grid_size=GRID)
    parts = shapely.get_parts(shapely.get_parts(found))
    falls = lines(low)
    return KerbedPavement(
        shapely.difference(pavement, shapely.union(beside, around), grid_size=GRID),
        shapely.multipolygons(parts[shapely.get_dimensions(parts) == 2]),
        Fall(falls, LET_DOWN, RAMP) if falls else None,
    )


def _lower_kerbs(lanes: shapely.Geometry, crossings: Sequence[Crossing]) -> list[shapely.Geometry]:
    """The edges of carriageways at both ends of crossings."""
    stretched = [one._replace(wide=one.wide + 2.0 * ONWARD).area() for one in crossings]
    return list(shapely.intersection(shapely.boundary(lanes), np.array(stretched, object)))


def _open(
    pavement: shapely.Geometry, lanes: shapely.Geometry, pathways: Sequence[Pathway]
) -> list[shapely.Geometry]:
    """The edges of pavements, inner and outer, where lanes and drives lead over them."""
    driven = [row for row in pathways if row.kind != "walk"]
    ends = shapely.points(np.array([row.line[k] for row in driven for k in (0, -1)]).reshape(-1, 2))
    half = np.repeat([0.5 * row.width for row in driven], 2)
    over = shapely.shortest_line(ends, lanes)
    kept = (shapely.length(over) > 0.0) & (shapely.length(over) <= LED_ON)
    zones = shapely.buffer(over[kept], half[kept], cap_style="square")
    return list(shapely.intersection(shapely.boundary(pavement), zones))
