"""What the walls of a house show: windows with frames and shutters, doors, along any side."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely

from scenewright.catalog.assets.buildings.facades import bays
from scenewright.core.footprint import Footprint
from scenewright.core.space import Points
from scenewright.geometry.mesh import Mesh, rotate_mesh, translate_mesh
from scenewright.geometry.solids import Interval, block

OUT = 0.05
"""How far panes stand out, in metres; frames a little less, shutters a little more."""
FLOOR = 2.7
EDGE, APART, LEAF = 0.35, 0.06, 0.42
"""Metres from a corner to a window, between a door and a window, and of the width of a shutter."""
DOOR, DOOR_TOP, LEAST_TALL = 1.1, 2.25, 0.4
"""Width and height of a door, and the least height of a window, in metres."""
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
    width of a gate instead of a door (a barn), with a light above it. On the front the windows of
    the ground floor stand beside the door, which leaves the middle where it must; a front too
    narrow for both has a light in the door."""
    found = WallOpenings([], [], [], [], [])
    ring = np.array(footprint)
    ends = np.roll(ring, -1, axis=0)
    entrance = front_of(footprint)
    storeys = min(max(1, int((eave + 0.25) // FLOOR)), STOREYS)
    bay = max(look.bay, shapely.length(shapely.LinearRing(ring)) * storeys / WINDOWS)
    for number, (start, end) in enumerate(zip(ring, ends, strict=True)):
        side = _Side(start, end, float(np.hypot(*(end - start))))
        front = number == entrance
        if front:
            _front(found, side, eave, look, gate)
        if side.length < look.wide + 0.8 or gate:
            continue
        for floor in range(int(front), storeys):
            for a, b in bays((-side.length / 2 + EDGE, side.length / 2 - EDGE), bay):
                _window(found, side, (a + b) / 2, _heights(floor, eave, look), look)
    return found


class _Side(NamedTuple):
    """A side of a footprint: where it starts and ends, and its length."""

    start: Points
    end: Points
    length: float


def _heights(floor: int, eave: float, look: WindowLook) -> Interval:
    """From where to where a window of a storey reaches."""
    low = floor * FLOOR + look.sill
    return low, min(low + look.tall, eave - 0.2)


def _front(found: WallOpenings, side: _Side, eave: float, look: WindowLook, gate: float) -> None:
    """The door and the ground floor of a front."""
    reach = side.length / 2 - EDGE
    wide = max(min(gate or DOOR, side.length - 0.5), 0.6)
    top = max(min(DOOR_TOP, eave - 0.15), 1.2)
    frame = look.wide / 2 + 0.09 + (LEAF if look.shutters else 0.0)
    room = wide / 2 + 0.14 + APART
    least = look.wide / 2 + 0.09
    at, z = 0.0, _heights(0, eave, look)
    shown = not gate and z[1] - z[0] > LEAST_TALL
    if shown and reach - room < 2 * least and 2 * reach >= room + wide / 2 + 0.14 + 2 * least:
        at = -reach + wide / 2 + 0.14
    _door(found, side, at, wide, top, not gate)
    spans = [(-reach, at - room), (at + room, reach)] if shown else []
    made = 0
    for a, b in spans:
        closed = look._replace(shutters=look.shutters and b - a >= 2 * frame)
        half = frame if closed.shutters else least
        if b - a >= 2 * half - 1e-9:
            for c, d in bays((a, b), max(look.bay, 2 * half)) if b - a > look.bay else [(a, b)]:
                if d - c >= 2 * half - 1e-9:
                    _window(found, side, (c + d) / 2, z, closed)
                    made += 1
    if not made:
        pane = block((at - 0.3 * wide, at + 0.3 * wide), (-OUT, 1.3 * OUT), (top - 0.5, top - 0.15))
        found.panes.append(_on_side(pane, side.start, side.end))


def _window(found: WallOpenings, side: _Side, at: float, z: Interval, look: WindowLook) -> None:
    """A window about a place along a side; none that would be lower than :data:`LEAST_TALL`."""
    if z[1] - z[0] <= LEAST_TALL:
        return
    half, (start, end) = look.wide / 2, side[:2]
    pane = block((at - half, at + half), (-OUT, OUT), z)
    rim = block((at - half - 0.09, at + half + 0.09), (-OUT, 0.6 * OUT), (z[0] - 0.09, z[1] + 0.09))
    found.panes.append(_on_side(pane, start, end))
    found.frames.append(_on_side(rim, start, end))
    for sign in (-1, 1) if look.shutters else ():
        edge = at + sign * (half + 0.09)
        span = (edge, edge + LEAF) if sign > 0 else (edge - LEAF, edge)
        leaf = block(span, (0.0, 1.3 * OUT), (z[0] - 0.03, z[1] + 0.03))
        found.shutters.append(_on_side(leaf, start, end))


def _door(found: WallOpenings, side: _Side, at: float, wide: float, top: float, step: bool) -> None:
    """A door or gate about a place along a side, with a step before a door."""
    half, (start, end) = wide / 2, side[:2]
    leaf = block((at - half, at + half), (-OUT, OUT), (0.06, top))
    found.doors.append(_on_side(leaf, start, end))
    rim = block((at - half - 0.14, at + half + 0.14), (-OUT, 0.6 * OUT), (0.0, top + 0.14))
    found.frames.append(_on_side(rim, start, end))
    if step:
        tread = block((at - half - 0.25, at + half + 0.25), (-OUT, 0.3), (0.0, 0.1))
        found.stones.append(_on_side(tread, start, end))


def _on_side(mesh: Mesh, start: Points, end: Points) -> Mesh:
    """What is built on a wall at y = 0 looking to +y, set on one side of a footprint."""
    along, middle = end - start, (start + end) / 2
    turned = rotate_mesh(mesh, "z", float(np.arctan2(-along[0], along[1]) - np.pi / 2))
    return translate_mesh(turned, float(middle[0]), float(middle[1]))
