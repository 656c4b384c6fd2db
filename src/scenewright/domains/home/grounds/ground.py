"""From a space to the ground its items are placed on."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.building.ceiling import planes
from scenewright.building.door_approach import (
    WIDE,
    DoorApproach,
    before,
    door_zone,
    edges_of,
    gates,
    has_leaf,
    landing,
    open_leaf,
    throat,
)
from scenewright.building.outlines import edges
from scenewright.building.standing import RADIATED, is_radiator
from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.grounds.cupboards import list_cupboards
from scenewright.domains.home.measures import HEAD_HEIGHT
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.walking.door_paths import door_paths
from scenewright.geometry.arcs import chords_of

Floats = NDArray[np.float64]

WINDOW_DEPTH = 0.3  # nothing taller than the sill this near to the glass, metres
STRIP = 0.3  # the floor before an opening that is better free in all its width, metres
USE = 0.6  # floor before a fixed piece, metres
HEARTH = "fireplace"
MAIN_WALL = 1.5  # the paper's least length of a main wall, metres


def ground_of(
    space: Space, fixed: tuple[Piece, ...], area: float, beside: tuple[Piece, ...] = ()
) -> Ground:
    """The ground of a space with what already stands in it, and ``beside`` it and reaches in."""
    seen = gates(space)
    doors = tuple(g for g in seen if g.opening.kind != "window")
    windows = [_window(g) for g in seen if g.opening.kind == "window"]
    x0, y0 = space.outline.min(0)
    x1, y1 = space.outline.max(0)
    main = main_wall(space, fixed)
    standing = [p for p in (*fixed, *beside) if _in_the_way(p)]
    solids = _rows([box for p in standing for box in boxes_of(p)], 5)
    return Ground(
        edges=np.ascontiguousarray(edges_of(space)),
        walls=np.vstack([edges(space.outline), chords_of(space.outline)]),
        keep_free=_rows(
            [
                *(box for g in doors for box in door_zone(space, g)),
                *map(landing, space.stairs),
                *list_cupboards(space, fixed),
            ],
            5,
        ),
        use_space=_rows([_ahead(p, USE) for p in fixed if _needs_use_space(p)], 5),
        obstacles=solids,
        windows=_rows(windows, 6),
        doors=_rows([*map(throat, doors), *map(landing, space.stairs)], 5),
        main_wall=_rows([] if main is None else [main], 4),
        bounds=np.array([x0, y0, x1, y1]),
        area=area,
        slopes=planes(space),
        fronts=_rows([_ahead(p, RADIATED) for p in fixed if is_radiator(p)], 5),
        paths=door_paths(space, doors, solids),
        strips=_rows([_strip(g) for g in seen if _wants_all(g)], 6),
        hearths=_rows([_hearth(p) for p in fixed if p.category == HEARTH], 4),
        leaves=_rows([[*open_leaf(g), k] for k, g in enumerate(doors) if has_leaf(g)], 6),
        entrances=_rows([throat(g) for g in doors if has_leaf(g) and _is_entrance(g)], 5),
    )


def main_wall(space: Space, fixed: tuple[Piece, ...] = ()) -> list[float] | None:
    """The main wall as one edge: the stated one, else that behind a ``fixed`` fireplace, else the
    longest straight wall of at least 1.5 m (the paper's least length) with no opening in it."""
    walls = np.hstack([space.outline, np.roll(space.outline, -1, 0)])
    if space.main_wall is not None:
        return [float(v) for v in walls[space.main_wall]]
    for hearth in (p for p in fixed if p.category == HEARTH):
        return [float(v) for v in walls[int(np.argmin(_distance(_back(hearth), walls)))]]
    length = np.linalg.norm(walls[:, 2:] - walls[:, :2], axis=1)
    for gate in gates(space):
        touched = _distance(gate.face, walls) < 0.02
        length = np.where(touched, 0.5 * length, length)
    best = int(np.argmax(length))
    return [float(v) for v in walls[best]] if length[best] >= MAIN_WALL else None


def _distance(point: Floats, walls: Floats) -> Floats:
    start, along = walls[:, :2], walls[:, 2:] - walls[:, :2]
    t = ((point - start) * along).sum(-1) / np.maximum((along**2).sum(-1), 1e-12)
    return np.linalg.norm(start + along * np.clip(t, 0, 1)[:, None] - point, axis=1)


def _window(gate: DoorApproach) -> list[float]:
    if gate.opening.roof is not None:
        near, far = gate.opening.roof
        under = gate._replace(face=gate.face + near * gate.inward)
        return [*before(under, gate.opening.width, far - near), gate.opening.sill + 0.04]
    return [*before(gate, gate.opening.width, WINDOW_DEPTH), gate.opening.sill + 0.04]


def _is_entrance(gate: DoorApproach) -> bool:
    """Whether a door leads in from outside."""
    return len(gate.opening.spaces) < 2 and gate.opening.use != "exit"


def _wants_all(gate: DoorApproach) -> bool:
    """Whether an opening wants its whole width free though some may stand there: a window in a
    wall, and a door or passage without a leaf, whose middle is kept free by rule."""
    opening = gate.opening
    if opening.kind == "window":
        return opening.roof is None
    return opening.hinge == 0 and opening.width > WIDE


def _strip(gate: DoorApproach) -> list[float]:
    return [*before(gate, gate.opening.width, STRIP), float(gate.opening.kind == "window")]


def _hearth(piece: Piece) -> list[float]:
    """The middle of the front of a fixed piece and its heading as cos and sin."""
    x, y = _ahead(piece, 0.0)[:2]
    return [x, y, float(np.cos(piece.pose.heading)), float(np.sin(piece.pose.heading))]


def _back(piece: Piece) -> Floats:
    """The middle of the back of a piece, metres."""
    pose, half = piece.pose, piece.size.depth / 2
    return np.array([pose.x - half * np.cos(pose.heading), pose.y - half * np.sin(pose.heading)])


def _ahead(piece: Piece, depth: float) -> list[float]:
    """The floor before a fixed piece: to use it, or what a radiator needs free."""
    pose, out = piece.pose, (piece.size.depth + depth) / 2
    x, y = pose.x + out * np.cos(pose.heading), pose.y + out * np.sin(pose.heading)
    return [float(x), float(y), pose.heading, piece.size.width, depth]


def _needs_use_space(piece: Piece) -> bool:
    """Whether a fixed piece is better left room to use it."""
    return _in_the_way(piece) and not is_radiator(piece)


def _in_the_way(piece: Piece) -> bool:
    return piece.pose.z < HEAD_HEIGHT and piece.size.height > 0.05 and piece.on is None


def _rows(rows: list[list[float]], width: int) -> Floats:
    return np.array(rows, np.float64).reshape(-1, width)
