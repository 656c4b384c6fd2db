"""Terms of relations: items to each other, to daylight, to corners."""

from __future__ import annotations

import math

from scenewright.domains.home.terms.orientation import FLUSH, gap
from scenewright.domains.home.terms.table import OBSTACLES, WINDOW
from scenewright.geometry.boxes import (
    Floats,
    Frame,
    distance_to_box,
    nearest_segment,
    read_frame,
    wrap,
)
from scenewright.geometry.compiled import compiled, inlined


@inlined
def off_distance(distance: float, wanted: float) -> float:
    """Metres off a wanted distance; one below zero is the least that is wanted (ours)."""
    return abs(distance - wanted) if wanted >= 0.0 else max(-wanted - distance, 0.0)


@compiled
def pair_printed(a: Frame, b: Frame, distance: float, angle: float) -> float:
    """|d - d̄| + |θ - θ̄|: metres and radians off the wanted distance and angle; NaN: any.

    d between centres, θ between headings in [0, π] (Liu et al. 2017, C6 as printed).
    """
    off = 0.0
    if not math.isnan(distance):
        dx, dy = b[0] - a[0], b[1] - a[1]
        off += off_distance(math.sqrt(dx * dx + dy * dy), distance)
    if not math.isnan(angle):
        off += abs(abs(wrap(b[7] - a[7])) - abs(wrap(angle)))
    return off


@compiled
def pair(a: Frame, b: Frame, distance: float, angle: float, bearing: float) -> float:
    """The printed form plus the bearing: |wrap(direction from a to b - front of a - wanted)|.

    Distance and angle alone let a screen stand behind the sofa; NaN: any bearing.
    """
    off = pair_printed(a, b, distance, angle)
    if not math.isnan(bearing):
        off += abs(wrap(math.atan2(b[1] - a[1], b[0] - a[0]) - a[7] - bearing))
    return off


@inlined
def daylight(frame: Frame, zones: Floats, span: float) -> float:
    """Distance from an item's centre to the nearest window's box as a share of the room's span.

    ``zones`` (k, 10) as in :func:`scenewright.domains.home.terms.clearance.measure_entered_area`.
    """
    least = math.inf
    for k in range(zones.shape[0]):
        if zones[k, 8] == WINDOW:
            least = min(least, distance_to_box(frame[0], frame[1], read_frame(zones, k)))
    return 0.0 if least == math.inf else min(least / span, 1.0)


@inlined
def nestle(frame: Frame, walls: Floats, zones: Floats) -> float:
    """Gap between the middle of the nearer of the left and right sides and a wall or fixed piece.

    0 with a side flush (0.02 m), towards 1 far off: items that belong in corners. ``walls`` (w,
    4), ``zones`` (k, 10) fixed pieces as of :class:`.assemble.PreparedHome`; metres.
    """
    u, v = frame[3] * frame[4], -frame[2] * frame[4]
    least = math.inf
    for side in range(2):
        x, y = frame[0] + (2 * side - 1) * u, frame[1] + (2 * side - 1) * v
        least = min(least, nearest_segment(x, y, walls)[1])
        for k in range(zones.shape[0]):
            if zones[k, 8] == OBSTACLES:
                least = min(least, distance_to_box(x, y, read_frame(zones, k)))
    return 0.0 if least == math.inf else gap(least, FLUSH)
