"""Beds for two reached from the foot: one goes in sideways where both sides are a little free."""

from __future__ import annotations

import shapely

from scenewright.check.bodies import Bodies, Floats, Shape
from scenewright.check.routes import Walk

BED = "double_bed"
AISLE = 0.33
"""Width that a person turned sideways takes, metres (Panero, Zelnik 1979: body depth 0.29 to
0.33 m)."""
HEAD = 0.45
"""Metres of a bed's length beside which its nightstands stand."""
PASSED = 0.025
"""Share of an aisle that something may take, as a radiator does."""


def is_entered_from_foot(bodies: Bodies, walk: Walk, row: int, within: Shape, reach: float) -> bool:
    """Whether a route comes within ``reach`` metres before the foot of a bed for two on either
    side, and both aisles beside it, on the floor ``within``, are free from its nightstands to as
    far beyond the foot as they are wide."""
    if bodies.pieces[row].category != BED:
        return False
    corners = bodies.corners[row]
    others = [int(k) for k in walk.blocking if k != row]
    taken = shapely.union_all(bodies.footprints[others])
    free = shapely.difference(within, taken)
    aisles = [_strip(corners, right, HEAD, AISLE) for right in (False, True)]
    open_ = all(_share(aisle, free) >= 1.0 - PASSED for aisle in aisles)
    long = float(((corners[1] - corners[0]) ** 2).sum() ** 0.5)
    mouths = [_strip(corners, right, long, reach) for right in (False, True)]
    return open_ and any(shapely.intersects(walk.reached, mouth) for mouth in mouths)


def _share(strip: Shape, free: Shape) -> float:
    return float(shapely.area(shapely.intersection(strip, free)) / shapely.area(strip))


def _strip(corners: Floats, right: bool, start: float, beyond: float) -> Shape:
    """The strip of :data:`AISLE` beside the right or the left side of a bed, from ``start``
    metres before its head to ``beyond`` its foot; ``corners`` (4, 2) from the back right round."""
    head, foot = (corners[0], corners[1]) if right else (corners[3], corners[2])
    other = corners[3] if right else corners[0]
    long = ((foot - head) ** 2).sum() ** 0.5
    along, out = (foot - head) / long, head - other
    out = out / (out**2).sum() ** 0.5 * AISLE
    near, far = head + along * start, foot + along * beyond
    return shapely.polygons([near, near + out, far + out, far])
