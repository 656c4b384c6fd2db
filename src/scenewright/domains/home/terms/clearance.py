"""Terms of clearance: what must stay free before doors, windows and the sides of items."""

from __future__ import annotations

from scenewright.domains.home.terms.table import OBSTACLES
from scenewright.geometry.boxes import (
    Floats,
    Frame,
    Sides,
    area_in_polygon,
    beyond,
    common_area,
    read_frame,
)
from scenewright.geometry.compiled import inlined


@inlined
def measure_entered_area(frame: Frame, height: float, zones: Floats, weights: Floats) -> float:
    """Σ_r w_r A(P ∩ D_r): area of an item in zones to be kept free, weighted.

    A zone (k, 10) is a frame, the term that weighs it and a height it starts from: door swings
    (Liu et al. 2017, C3), the floor before fixed pieces, fixed pieces, and the room in front of
    the glass of windows, which counts for items that rise above the sill. Square metres times
    weight.
    """
    total = 0.0
    for k in range(zones.shape[0]):
        weight = weights[int(zones[k, 8])]
        if weight != 0.0 and height > zones[k, 9]:
            total += weight * common_area(frame, read_frame(zones, k))
    return total


@inlined
def zone_blocked(frame: Frame, clear: Sides, edges: Floats, zones: Floats) -> float:
    """Area of an item's clear zones outside the room or on fixed pieces, square metres.

    ``clear`` is the depth wished for beyond the front, left, back and right side. ``edges`` (e,
    4) of the room, ``zones`` (k, 10) fixed pieces as of :class:`.assemble.PreparedHome`.
    """
    total = 0.0
    for side in range(4):
        if clear[side] > 0.0:
            zone = beyond(frame, side, clear[side])
            total += max(4.0 * zone[4] * zone[5] - area_in_polygon(zone, edges), 0.0)
            for k in range(zones.shape[0]):
                if zones[k, 8] == OBSTACLES:
                    total += common_area(zone, read_frame(zones, k))
    return total


@inlined
def zone_covered(frame: Frame, clear: Sides, other: Frame) -> float:
    """Area of an item's clear zones under another item, square metres."""
    total = 0.0
    for side in range(4):
        if clear[side] > 0.0:
            total += common_area(beyond(frame, side, clear[side]), other)
    return total


@inlined
def zones_covered(a: Frame, b: Frame, clear_a: Sides, clear_b: Sides) -> float:
    """Area of each item's clear zones under the other, summed both ways, square metres."""
    return zone_covered(a, clear_a, b) + zone_covered(b, clear_b, a)
