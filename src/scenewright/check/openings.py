"""Opening clearance: pieces before doors and windows.

SceneEval (Tam et al. 2025) extrudes a box into the room in front of each opening, as deep as a
door is wide and 0.5 m at a window, and asks which objects enter it. Flats with closets of half a
metre need a finer rule, so here the *door zone* is

* the threshold: the opening's width by :data:`DOOR_DEPTH`, on each side that is a room, no deeper
  than half that room is there; and
* the sector the leaf sweeps, a quarter disc of the opening's width about its hinge, on the side
  it swings to,

cut to the room. Openings wider than :data:`WIDE` without a swinging leaf are blocked only when
too little of their width is left in one stretch: an open passage needs :data:`PASSAGE`, and of a
sliding door, whose panels pass behind each other, the half that opens and at least
:data:`SLIDING`.
A window is blocked by what rises more than :data:`SILL_ALLOWANCE` above its sill within
:data:`WINDOW_DEPTH` of the glass. Rugs and curtains, and what hangs above head height, never block.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.check.bodies import HEAD_HEIGHT, TOLERANCE, Bodies, Floats, Rooms, Shape, Shapes
from scenewright.core.report import Finding
from scenewright.core.space import Opening

DOOR_DEPTH = 0.5
"""Depth of the threshold kept free before a door, in metres."""

WIDE = 1.2
"""Openings without a leaf wider than this may be partly furnished, in metres."""

PASSAGE = 0.9
"""The stretch of a wide passage that has to stay free, in metres."""

SLIDING = 0.8
"""The least stretch of a wide sliding door that has to stay free, in metres; half its width if
that is more."""

WINDOW_DEPTH = 0.25
"""Depth of the zone before a window, in metres."""

SILL_ALLOWANCE = 0.05
"""How far things before a window may rise above its sill, in metres."""

_FRAME = 0.05
_ARC = np.linspace(0.0, np.pi / 2, 13)
_FAR = 100.0


class OpeningZone(NamedTuple):
    """What must be free before one side of one opening: room index, shape, and heights between
    which it must be free."""

    opening: Opening
    room: int
    shape: Shape
    low: float
    high: float


def find_blocked(bodies: Bodies, rooms: Rooms) -> list[Finding]:
    """A finding for every piece that enters the zone of a door or window by more than 1 cm."""
    zones = [z for room in range(len(rooms.spaces)) for z in _zones_of(rooms, room)]
    if not zones or not bodies.pieces:
        return []
    shapes = np.array([zone.shape for zone in zones], object)
    tree = shapely.STRtree(bodies.footprints)
    which, piece = tree.query(shapely.buffer(shapes, -TOLERANCE), predicate="intersects")
    low = np.array([zone.low for zone in zones])[which]
    high = np.array([zone.high for zone in zones])[which]
    level = rooms.level[np.array([zone.room for zone in zones])[which]]
    keep = (bodies.high[piece] > low) & (bodies.low[piece] < high - TOLERANCE)
    keep &= (bodies.level[piece] == level) & ~bodies.flat[piece] & ~bodies.soft[piece]
    found: list[Finding] = []
    for number in np.unique(which[keep]):
        found += _find_blocked(
            bodies, rooms, zones[number], np.sort(piece[keep & (which == number)])
        )
    return found


def _zones_of(rooms: Rooms, room: int) -> list[OpeningZone]:
    zones = []
    for opening in (o for o in rooms.spaces[room].openings if o.roof is None):
        inward = _inward(opening, rooms.shapes[room])
        box = _box(opening, inward, rooms.shapes[room])
        if opening.kind == "window":
            low, high = opening.sill + SILL_ALLOWANCE, opening.head
        else:
            low, high = 0.0, min(opening.head, HEAD_HEIGHT)
            if opening.swing == inward:
                box = shapely.union(box, _sector(opening))
        shape = shapely.intersection(box, rooms.shapes[room])
        zones.append(OpeningZone(opening, room, shape, low, high))
    return zones


def _frame(opening: Opening) -> tuple[Floats, Floats, Floats]:
    along = np.array([opening.ux, opening.uy])
    return np.array([opening.x, opening.y]), along, np.array([-along[1], along[0]])


def _inward(opening: Opening, room: Shape) -> int:
    """The side of the opening that the room is on: +1 its left, -1 its right."""
    centre, _, left = _frame(opening)
    reach = opening.thickness / 2 + 0.1
    sides = shapely.points(np.stack([centre + left * reach, centre - left * reach]))
    ahead, behind = shapely.distance(sides, room)
    return 1 if ahead <= behind else -1


def _box(opening: Opening, inward: int, room: Shape) -> Shape:
    """The box before an opening, from the middle of the wall."""
    centre, along, left = _frame(opening)
    out = left * inward
    if opening.kind == "window":
        half, depth = max(opening.width / 2 - _FRAME, opening.width / 4), WINDOW_DEPTH
    else:
        half = opening.width / 2
        depth = min(DOOR_DEPTH, _depth_of_room(centre + out * opening.thickness / 2, out, room) / 2)
    near, far = centre, centre + out * (opening.thickness / 2 + depth)
    side = along * half
    return shapely.polygons(np.stack([near - side, near + side, far + side, far - side]))


def _depth_of_room(start: Floats, out: Floats, room: Shape) -> float:
    """How far one can look from an opening into the room, in metres."""
    sight = shapely.linestrings(np.stack([start + out * 0.02, start + out * _FAR]))
    seen = shapely.get_parts(shapely.intersection(sight, room))
    near = seen[shapely.distance(seen, shapely.points(start)) < 0.1] if len(seen) else seen
    return float(shapely.length(near).max()) + 0.02 if len(near) else 2 * DOOR_DEPTH


def _sector(opening: Opening) -> Shape:
    """The quarter disc a leaf sweeps about its hinge, from the face of the wall."""
    centre, along, left = _frame(opening)
    out = left * opening.swing
    hinge = centre + along * opening.hinge * opening.width / 2 + out * opening.thickness / 2
    closed = -along * opening.hinge
    arc = np.cos(_ARC)[:, None] * closed + np.sin(_ARC)[:, None] * out
    return shapely.polygons(np.concatenate([hinge[None], hinge + arc * opening.width]))


def _find_blocked(
    bodies: Bodies, rooms: Rooms, zone: OpeningZone, inside: NDArray[np.intp]
) -> list[Finding]:
    opening = zone.opening
    entered = shapely.intersection(bodies.footprints[inside], zone.shape)
    wide = opening.kind != "window" and opening.swing == 0 and opening.width > WIDE
    if wide and _widest_stretch(opening, entered) >= stretch_kept_free(opening):
        return []
    return [
        _finding(bodies, rooms, zone, int(i), shape)
        for i, shape in zip(inside, entered, strict=True)
    ]


def stretch_kept_free(opening: Opening) -> float:
    """The stretch in metres that has to stay free before a wide opening without a swinging leaf.

    >>> stretch_kept_free(Opening("d", "door", "0", 0, 0, 1, 0, 2.4, 0.1, 0, 2))
    1.2
    """
    return PASSAGE if opening.kind == "passage" else max(SLIDING, opening.width / 2)


def _widest_stretch(opening: Opening, entered: Shapes) -> float:
    """The widest part of an opening that nothing stands before, in metres."""
    centre, along, _ = _frame(opening)
    spans = [(shapely.get_coordinates(shape) - centre) @ along for shape in entered]
    blocked = sorted((float(s.min()), float(s.max())) for s in spans if len(s))
    widest, at = 0.0, -opening.width / 2
    for start, end in [*blocked, (opening.width / 2, opening.width / 2)]:
        widest, at = max(widest, start - at), max(at, end)
    return widest


def _finding(bodies: Bodies, rooms: Rooms, zone: OpeningZone, i: int, shape: Shape) -> Finding:
    piece, opening = bodies.pieces[i], zone.opening
    kind = "blocked_window" if opening.kind == "window" else "blocked_door"
    space, area = rooms.spaces[zone.room], float(shape.area)
    _, _, left = _frame(opening)
    across = (shapely.get_coordinates(shape) - [opening.x, opening.y]) @ left
    gap = max(float(np.abs(across).min()) - opening.thickness / 2, 0.0)
    text = f"{piece.id} stands {gap:.2f} m before {opening.kind} {opening.id} of {space.id}"
    if kind == "blocked_window":
        over = float(bodies.high[i]) - opening.sill
        text += f" and rises {over:.2f} m above its sill"
    text += f" ({area:.2f} m² of what should be free)"
    return Finding(
        kind,
        space.level,
        space.id,
        piece.id,
        opening.id,
        text,
        round(gap, 4),
        round(area, 4),
        piece.fixed,
    )
