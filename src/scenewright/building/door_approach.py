"""Doors and windows as one space sees them: what has to stay free to use them.

Every box is (x, y, heading, width, depth), its front looking into the room.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.same import once
from scenewright.core.space import Opening, Space, StairEnd

Floats = NDArray[np.float64]

LANDING = 0.7  # kept free before stairs, metres
THRESHOLD = 0.5  # kept free before a door, metres
PASSAGE, SHARE = 0.9, 0.6  # kept free of a wide opening at least: metres, share of its width
LEAF = 0.04  # how thick a leaf is, metres
WIDE = 1.2  # openings without a leaf wider than this need not stay free in full, metres
HAIR = 0.001  # what an opening reaches into a room by rounding, metres
STRIPS = 8  # boxes that stand for a quarter disc
QUARTER = 0.71  # a little over the cosine of 45 degrees


class DoorApproach(NamedTuple):
    """An opening as one space sees it: its middle on the wall's inner face and the unit normal
    into the room."""

    opening: Opening
    face: Floats
    inward: Floats


def edges_of(space: Space) -> Floats:
    """Directed edges ``(e, 4)`` of outline and holes, the inside on their left."""
    rings = (space.outline, *space.holes)
    return np.concatenate([np.hstack([ring, np.roll(ring, -1, 0)]) for ring in rings])


@once(256)
def gates(space: Space) -> tuple[DoorApproach, ...]:
    """The openings of a space with the wall face and inward normal they have here; of the same
    space made once."""
    walls = edges_of(space)
    return tuple(_gate(opening, walls) for opening in space.openings)


def _gate(opening: Opening, walls: Floats) -> DoorApproach:
    start, end = walls[:, :2], walls[:, 2:]
    along = end - start
    length = np.maximum(np.linalg.norm(along, axis=1), 1e-12)
    along = along / length[:, None]
    centre = np.array([opening.x, opening.y])
    t = np.clip(((centre - start) * along).sum(-1), 0, length)
    foot = start + along * t[:, None]
    skew = np.abs(along[:, 0] * opening.uy - along[:, 1] * opening.ux)
    nearest = int(np.argmin(np.linalg.norm(foot - centre, axis=1) + 5 * (skew > 0.1)))
    inward = np.array([-along[nearest, 1], along[nearest, 0]])
    return DoorApproach(opening, foot[nearest], inward)


def door_zone(space: Space, gate: DoorApproach) -> list[list[float]]:
    """Boxes that keep a door usable in this room: threshold, and the swing if it opens in."""
    opening = gate.opening
    depth = min(THRESHOLD, 0.5 * room_depth(space, gate))
    wide = opening.hinge == 0 and opening.width > WIDE
    kept = max(PASSAGE, SHARE * opening.width) if wide else opening.width
    zones = [before(gate, kept, depth + _beyond_face(gate))]
    if has_leaf(gate):
        zones += _sweep(gate)
    return zones


def has_leaf(gate: DoorApproach) -> bool:
    """Whether a leaf swings into this room."""
    opening = gate.opening
    return bool(opening.hinge and opening.swing and opens_here(gate))


def open_leaf(gate: DoorApproach) -> list[float]:
    """The box of a leaf of this room that stands open at a right angle."""
    half = gate.opening.width / 2
    along = np.array([gate.opening.ux, gate.opening.uy]) * gate.opening.hinge
    hung = gate._replace(face=gate.face + along * (half - LEAF / 2))
    return before(hung, LEAF, 2 * half)


def _beyond_face(gate: DoorApproach) -> float:
    """How far an opening itself reaches into the room, metres: where rooms touch without a wall
    between them, it may lie a little off their common edge."""
    opening = gate.opening
    x, y = opening.x - gate.face[0], opening.y - gate.face[1]
    off = float(x * gate.inward[0] + y * gate.inward[1]) + opening.thickness / 2
    return off if off > HAIR else 0.0


def sweep_strips(gate: DoorApproach) -> list[list[float]]:
    """Boxes side by side, as large together as the quarter disc that a leaf sweeps: each as wide as
    the disc is in the mean over its depth."""
    width = gate.opening.width
    along = np.array([gate.opening.ux, gate.opening.uy]) * gate.opening.hinge
    edges = np.linspace(0.0, 1.0, STRIPS + 1)
    under = 0.5 * (edges * np.sqrt(1.0 - edges**2) + np.arcsin(edges))
    wide, deep = width * STRIPS * np.diff(under), width / STRIPS
    return [
        before(
            gate._replace(face=gate.face + along * (width - one) / 2 + gate.inward * deep * k),
            float(one),
            deep,
        )
        for k, one in enumerate(wide)
    ]


def _sweep(gate: DoorApproach) -> list[list[float]]:
    """Two boxes that cover the quarter disc of a leaf: wide and shallow, narrow and deep."""
    width = gate.opening.width
    along = np.array([gate.opening.ux, gate.opening.uy]) * gate.opening.hinge
    near = gate.face + along * (1 - QUARTER) * width / 2
    return [
        before(gate, width, QUARTER * width),
        before(gate._replace(face=near), QUARTER * width, width),
    ]


def room_depth(space: Space, gate: DoorApproach) -> float:
    """How deep the room is, straight in from an opening, in metres."""
    walls = edges_of(space)
    start, along = walls[:, :2], walls[:, 2:] - walls[:, :2]
    cross = gate.inward[0] * along[:, 1] - gate.inward[1] * along[:, 0]
    to = start - gate.face
    with np.errstate(divide="ignore", invalid="ignore"):
        t = (to[:, 0] * along[:, 1] - to[:, 1] * along[:, 0]) / cross
        s = (to[:, 0] * gate.inward[1] - to[:, 1] * gate.inward[0]) / cross
    ahead = t[(np.abs(cross) > 1e-12) & (s >= 0) & (s <= 1) & (t > 0.05)]
    return float(ahead.min()) if ahead.size else THRESHOLD


def opens_here(gate: DoorApproach) -> bool:
    """Whether the leaf of a door opens into the room it is approached from."""
    left = np.array([-gate.opening.uy, gate.opening.ux])
    return bool(gate.opening.swing * (left @ gate.inward) > 0)


def before(gate: DoorApproach, width: float, depth: float) -> list[float]:
    """The box of some width before an opening, from the wall into the room."""
    x, y = gate.face + gate.inward * depth / 2
    return [x, y, float(np.arctan2(gate.inward[1], gate.inward[0])), width, depth]


def free_width(space: Space, gate: DoorApproach) -> float:
    """Metres of an opening, side by side, before which no hole (column) stands."""
    half, way = gate.opening.width / 2, np.array([gate.opening.ux, gate.opening.uy])
    sides = [gate.face - half * way, gate.face + half * way]
    strip = shapely.Polygon([*sides, *(side + THRESHOLD * gate.inward for side in sides[::-1])])
    found, reached = 0.0, -half
    taken = [
        _span(shapely.Polygon(hole).intersection(strip), gate.face, way) for hole in space.holes
    ]
    for low, high in [*sorted(span for span in taken if span), (half, half)]:
        found, reached = max(found, low - reached), max(reached, high)
    return found


def _span(shape: shapely.Geometry, face: Floats, way: Floats) -> tuple[float, float] | None:
    """From where to where a shape reaches along a direction."""
    if shape.area < 1e-9:
        return None
    along = (shapely.get_coordinates(shape) - face) @ way
    return float(along.min()), float(along.max())


def landing(end: StairEnd) -> list[float]:
    """The floor before the foot or head of stairs, from where one comes and goes."""
    out = LANDING / 2
    return [
        end.x + out * np.cos(end.heading),
        end.y + out * np.sin(end.heading),
        end.heading,
        end.width,
        LANDING,
    ]


def throat(gate: DoorApproach) -> list[float]:
    """The way through the wall, from a step outside to a little inside."""
    out, inside = gate.opening.thickness + 0.4, 0.1
    x, y = gate.face + gate.inward * (inside - out) / 2
    heading = float(np.arctan2(gate.inward[1], gate.inward[0]))
    return [x, y, heading, gate.opening.width, inside + out]
