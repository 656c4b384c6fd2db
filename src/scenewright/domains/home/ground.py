"""From a space to the ground its items are placed on."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.problem import Ground
from scenewright.scene import Piece
from scenewright.space import Opening, Space

Floats = NDArray[np.float64]

THRESHOLD = 0.5  # kept free before a door, metres
WINDOW_DEPTH = 0.3  # nothing taller than the sill this near to the glass, metres
PASSAGE, SHARE = 0.9, 0.6  # kept free of a wide opening at least: metres, share of its width
WIDE = 1.2  # openings without a leaf wider than this need not stay free in full, metres
CORRIDOR = 0.7  # width of the way from door to door, metres
QUARTER = 0.71  # a little over the cosine of 45 degrees
USE = 0.6  # floor before a fixed piece, metres
HEAD_HEIGHT = 2.0


class Gate(NamedTuple):
    """An opening as one space sees it: its middle on the wall's inner face and the unit normal
    into the room."""

    opening: Opening
    face: Floats
    inward: Floats


def edges_of(space: Space) -> Floats:
    """Directed edges ``(e, 4)`` of outline and holes, the inside on their left."""
    rings = (space.outline, *space.holes)
    return np.concatenate([np.hstack([ring, np.roll(ring, -1, 0)]) for ring in rings])


def gates(space: Space) -> tuple[Gate, ...]:
    """The openings of a space with the wall face and inward normal they have here."""
    walls = edges_of(space)
    return tuple(_gate(opening, walls) for opening in space.openings)


def _gate(opening: Opening, walls: Floats) -> Gate:
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
    return Gate(opening, foot[nearest], inward)


def ground_of(space: Space, fixed: tuple[Piece, ...], area: float) -> Ground:
    """The ground of a space with what already stands in it."""
    seen = gates(space)
    doors = tuple(g for g in seen if g.opening.kind != "window")
    windows = [_window(g) for g in seen if g.opening.kind == "window"]
    x0, y0 = space.outline.min(0)
    x1, y1 = space.outline.max(0)
    main = main_wall(space)
    return Ground(
        edges=np.ascontiguousarray(edges_of(space)),
        walls=np.hstack([space.outline, np.roll(space.outline, -1, 0)]),
        keep_free=_rows([box for g in doors for box in door_zone(space, g)], 5),
        corridors=_rows(_corridors(doors) + [_use(p) for p in fixed if _in_the_way(p)], 5),
        obstacles=_rows([_footprint(p) for p in fixed if _in_the_way(p)], 5),
        windows=_rows(windows, 6),
        doors=_rows([_throat(g) for g in doors], 5),
        main_wall=_rows([] if main is None else [main], 4),
        bounds=np.array([x0, y0, x1, y1]),
        area=area,
    )


def main_wall(space: Space) -> list[float] | None:
    """The main wall as one edge: the stated one, else the longest straight wall of at least 1.5 m
    (the paper's least length) with no opening in it."""
    walls = np.hstack([space.outline, np.roll(space.outline, -1, 0)])
    if space.main_wall is not None:
        return [float(v) for v in walls[space.main_wall]]
    length = np.linalg.norm(walls[:, 2:] - walls[:, :2], axis=1)
    for gate in gates(space):
        touched = _distance(gate.face, walls) < 0.02
        length = np.where(touched, 0.5 * length, length)
    best = int(np.argmax(length))
    return [float(v) for v in walls[best]] if length[best] >= 1.5 else None


def _distance(point: Floats, walls: Floats) -> Floats:
    start, along = walls[:, :2], walls[:, 2:] - walls[:, :2]
    t = ((point - start) * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-12)
    return np.linalg.norm(start + along * np.clip(t, 0, 1)[:, None] - point, axis=1)


def door_zone(space: Space, gate: Gate) -> list[list[float]]:
    """Boxes that keep a door usable in this room: threshold, and the swing if it opens in."""
    opening = gate.opening
    depth = min(THRESHOLD, 0.5 * room_depth(space, gate))
    wide = opening.hinge == 0 and opening.width > WIDE
    kept = max(PASSAGE, SHARE * opening.width) if wide else opening.width
    zones = [_before(gate, kept, depth)]
    if opening.hinge and opening.swing and _opens_here(gate):
        zones += _sweep(gate)
    return zones


def _sweep(gate: Gate) -> list[list[float]]:
    """Two boxes that cover the quarter disc of a leaf: wide and shallow, narrow and deep."""
    width = gate.opening.width
    along = np.array([gate.opening.ux, gate.opening.uy]) * gate.opening.hinge
    near = gate.face + along * (1 - QUARTER) * width / 2
    return [
        _before(gate, width, QUARTER * width),
        _before(gate._replace(face=near), QUARTER * width, width),
    ]


def room_depth(space: Space, gate: Gate) -> float:
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


def _opens_here(gate: Gate) -> bool:
    left = np.array([-gate.opening.uy, gate.opening.ux])
    return bool(gate.opening.swing * (left @ gate.inward) > 0)


def _before(gate: Gate, width: float, depth: float) -> list[float]:
    x, y = gate.face + gate.inward * depth / 2
    return [x, y, float(np.arctan2(gate.inward[1], gate.inward[0])), width, depth]


def _window(gate: Gate) -> list[float]:
    return [*_before(gate, gate.opening.width, WINDOW_DEPTH), gate.opening.sill + 0.04]


def _throat(gate: Gate) -> list[float]:
    """The way through the wall, from a step outside to a little inside."""
    out, inside = gate.opening.thickness + 0.4, 0.1
    x, y = gate.face + gate.inward * (inside - out) / 2
    heading = float(np.arctan2(gate.inward[1], gate.inward[0]))
    return [x, y, heading, gate.opening.width, inside + out]


def _corridors(doors: tuple[Gate, ...]) -> list[list[float]]:
    """Straight ways joining every pair of doors (Liu et al. 2017, cost 3, *Path*)."""
    found = []
    for i, first in enumerate(doors):
        for second in doors[i + 1 :]:
            way = second.face - first.face
            x, y = (first.face + second.face) / 2
            heading = float(np.arctan2(way[1], way[0]))
            found.append([x, y, heading, CORRIDOR, float(np.hypot(*way))])
    return found


def _use(piece: Piece) -> list[float]:
    """The floor before a fixed piece, better left free to use it."""
    pose, out = piece.pose, (piece.size.depth + USE) / 2
    x, y = pose.x + out * np.cos(pose.heading), pose.y + out * np.sin(pose.heading)
    return [float(x), float(y), pose.heading, piece.size.width, USE]


def _in_the_way(piece: Piece) -> bool:
    return piece.pose.z < HEAD_HEIGHT and piece.size.height > 0.05 and piece.on is None


def _footprint(piece: Piece) -> list[float]:
    pose, size = piece.pose, piece.size
    return [pose.x, pose.y, pose.heading, size.width, size.depth]


def _rows(rows: list[list[float]], width: int) -> Floats:
    return np.array(rows, np.float64).reshape(-1, width)
