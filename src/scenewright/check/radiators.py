"""Radiators: what shuts in the warm air.

Advice on heating asks for 0.1 to 0.3 m of free floor before a radiator. Here nothing closed (a
cupboard, a sofa, a bed) may stand, and no curtain hang, over more than 1 cm of the radiator or of
the strip of :data:`STRIP` before it, unless all of it is above the radiator. What air passes under
(tables, chairs), plants and lamps may stand there; rugs may lie.
"""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Bodies, Floats, Rooms, Shape
from scenewright.core.report import Finding
from scenewright.core.space import Radiator

STRIP = 0.2
"""Depth of the free strip before a radiator, in metres."""


def find_shut_in(bodies: Bodies, rooms: Rooms) -> list[Finding]:
    """A finding for every closed piece or curtain before a radiator."""
    found: list[Finding] = []
    for room, space in enumerate(rooms.spaces):
        for radiator in space.radiators:
            strip = shapely.buffer(_strip(radiator), -TOLERANCE / 2, join_style="mitre")
            here = np.flatnonzero(
                (bodies.level == rooms.level[room])
                & ~bodies.flat
                & (bodies.low < radiator.z + radiator.height - TOLERANCE)
                & [not kind.airy for kind in bodies.kinds]
                & [piece.id != radiator.id for piece in bodies.pieces]
            )
            met = shapely.intersects(bodies.footprints[here], strip)
            found += [_finding(bodies, rooms, room, radiator, int(i)) for i in here[met]]
    return found


def _strip(radiator: Radiator) -> Shape:
    """The radiator and the floor before it."""
    ahead = np.array([np.cos(radiator.heading), np.sin(radiator.heading)])
    side = np.array([-ahead[1], ahead[0]]) * radiator.width / 2
    back = np.array([radiator.x, radiator.y]) - ahead * radiator.depth / 2
    front = back + ahead * (radiator.depth + STRIP)
    corners: Floats = np.stack([back - side, front - side, front + side, back + side])
    return shapely.polygons(corners)


def _finding(bodies: Bodies, rooms: Rooms, room: int, radiator: Radiator, i: int) -> Finding:
    piece, space = bodies.pieces[i], rooms.spaces[room]
    ahead = np.array([np.cos(radiator.heading), np.sin(radiator.heading)])
    gap = float(((bodies.corners[i] - [radiator.x, radiator.y]) @ ahead).min())
    gap = max(gap - radiator.depth / 2, 0.0)
    area = float(shapely.intersection(bodies.footprints[i], _strip(radiator)).area)
    does = "hangs" if bodies.soft[i] else "stands"
    text = f"{piece.id} {does} {gap:.2f} m before {radiator.id} of {space.id}"
    text += f" ({STRIP - gap:.2f} m too near)" if gap else ""
    return Finding(
        "blocked_radiator",
        space.level,
        space.id,
        piece.id,
        radiator.id,
        text,
        round(STRIP - gap, 4),
        round(area, 4),
        piece.fixed,
    )
