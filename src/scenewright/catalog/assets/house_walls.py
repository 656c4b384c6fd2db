"""What the walls of a house show: windows with frames and shutters, doors, along any side."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.facades import bays
from scenewright.core.footprint import Footprint
from scenewright.core.space import Points
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, block

OUT = 0.05
"""How far panes stand out, in metres; frames a little less, shutters a little more."""
FLOOR = 2.7
STOREYS, WINDOWS = 4, 70
"""Most storeys with windows, and about how many windows a house has at most."""


class WallOpenings(NamedTuple):
    """Meshes of what is in walls."""

    panes: list[Mesh]
    frames: list[Mesh]
    shutters: list[Mesh]
    doors: list[Mesh]
    stones: list[Mesh]


class WindowLook(NamedTuple):
    """How windows look: the width of a bay, width and height of a window, its sill above the floor
    in metres, and whether it has shutters."""

    bay: float
    wide: float
    tall: float
    sill: float
    shutters: bool


def front_of(footprint: Footprint) -> int:
    """The side of a footprint that is farthest ahead.

    >>> front_of(((-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)))
    2
    """
    ring = np.array(footprint)
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    return int(np.argmax(np.round(middle[:, 1], 6)))


def openings(
    footprint: Footprint, eave: float, look: WindowLook, gate: float = 0.0
) -> WallOpenings:
    """Windows in every bay of every storey of every side, and a door in the front; ``gate`` is the
    width of a gate instead of a door (a barn), and then there are windows above only."""
    found = WallOpenings([], [], [], [], [])
    ring = np.array(footprint)
    ends = np.roll(ring, -1, axis=0)
    entrance = front_of(footprint)
    storeys = min(max(1, int((eave + 0.25) // FLOOR)), STOREYS)
    bay = max(look.bay, shapely.length(shapely.LinearRing(ring)) * storeys / WINDOWS)
    for number, (start, end) in enumerate(zip(ring, ends, strict=True)):
        length = float(np.hypot(*(end - start)))
        wide = gate if gate and number == entrance else 0.0
        if number == entrance:
            _door(found, start, end, min(wide or 1.1, length - 0.5), min(2.25, eave - 0.15), gate)
        if length < look.wide + 0.8 or gate:
            continue
        for a, b in bays((-length / 2 + 0.35, length / 2 - 0.35), bay):
            for floor in range(storeys):
                middle = (a + b) / 2
                if number == entrance and floor == 0 and abs(middle) < 0.9 + look.wide / 2:
                    continue
                low = floor * FLOOR + look.sill
                high = min(low + look.tall, eave - 0.2)
                if high - low > 0.4:
                    _window(found, start, end, middle, (low, high), look)
    return found


def _window(
    found: WallOpenings, start: Points, end: Points, at: float, z: Interval, look: WindowLook
) -> None:
    half = look.wide / 2
    pane = block((at - half, at + half), (-OUT, OUT), z)
    rim = block((at - half - 0.09, at + half + 0.09), (-OUT, 0.6 * OUT), (z[0] - 0.09, z[1] + 0.09))
    found.panes.append(_on_side(pane, start, end))
    found.frames.append(_on_side(rim, start, end))
    for side in (-1, 1) if look.shutters else ():
        edge = at + side * (half + 0.09)
        span = (edge, edge + 0.42) if side > 0 else (edge - 0.42, edge)
        leaf = block(span, (0.0, 1.3 * OUT), (z[0] - 0.03, z[1] + 0.03))
        found.shutters.append(_on_side(leaf, start, end))


def _door(
    found: WallOpenings, start: Points, end: Points, wide: float, tall: float, gate: float
) -> None:
    half = max(wide, 0.6) / 2
    top = max(tall, 1.2)
    leaf = block((-half, half), (-OUT, OUT), (0.06, top))
    found.doors.append(_on_side(leaf, start, end))
    rim = block((-half - 0.14, half + 0.14), (-OUT, 0.6 * OUT), (0.0, top + 0.14))
    found.frames.append(_on_side(rim, start, end))
    if not gate:
        step = block((-half - 0.25, half + 0.25), (-OUT, 0.3), (0.0, 0.1))
        found.stones.append(_on_side(step, start, end))


def _on_side(mesh: Mesh, start: Points, end: Points) -> Mesh:
    """What is built on a wall at y = 0 looking to +y, set on one side of a footprint."""
    along, middle = end - start, (start + end) / 2
    turned = rotate_mesh(mesh, "z", float(np.arctan2(-along[0], along[1]) - np.pi / 2))
    return translate_mesh(turned, float(middle[0]), float(middle[1]))
