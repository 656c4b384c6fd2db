"""Reach: which rooms and pieces no route leads to, and what blocks them.

SceneEval (Tam et al. 2025) scores accessibility as the share of an area before each functional
side that no object covers. A free patch nobody can walk to is of no use, so here a side counts
when a person walking in by the door can come to stand before it.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.check.bodies import Bodies, Floats, Rooms, Shape, Shapes
from scenewright.check.complete import inscribed_width
from scenewright.check.report import Finding
from scenewright.check.routes import Ground, Walk, squeeze_in, walk_in, walk_without

REACH = 0.2
"""How far an arm reaches beyond the person's own radius, in metres."""

_SIDES = {"front": (1, 2), "left": (2, 3), "back": (3, 0), "right": (0, 1)}
_NEAREST = 12
_TIGHT = 2.0
_STEP = 0.1  # a route has entered a room when its centre is this far inside, metres


class Target(NamedTuple):
    """What has to be reached: a room, or a piece (its row, else -1), and the shape the centre of
    the route has to come into."""

    room: int
    piece: int
    shape: Shape


def find_unreachable(
    bodies: Bodies, rooms: Rooms, grounds: list[Ground], route_width: float
) -> list[Finding]:
    """Rooms and pieces no route of ``route_width`` metres leads to, each with what blocks it.

    A room is reached if the centre of the route can come into it; a room no route could enter
    even empty is not judged. A piece with using sides (its kind's ``access``) is reached if the
    centre comes within half the route width and :data:`REACH` of one of them, straight before
    it. Pieces of a room that is not reached are not told one by one. Seats that go under tables
    are pushed aside.

    No closet or toilet could be used if one had to walk about in it. So a *tight* room, nowhere
    as wide as two routes or closed to the route by a narrow doorway even while empty, is reached
    if its doorway is, and within it a person goes on sideways.
    """
    found: list[Finding] = []
    for ground in grounds:
        walk = walk_in(bodies, ground, route_width / 2)
        shapely.prepare(walk.reached)
        wanted = _room_targets(rooms, ground, walk)
        missed = [t for t in wanted if not shapely.intersects(walk.reached, t.shape)]
        open_rooms = {t.room for t in wanted} - {t.room for t in missed}
        missed += _missed_pieces(bodies, rooms, ground, walk, open_rooms)
        blockers = _blockers(walk, missed)
        found += [
            _finding(bodies, rooms, walk, target, rows, word)
            for target, (rows, word) in zip(missed, blockers, strict=True)
        ]
    return found


def _room_targets(rooms: Rooms, ground: Ground, walk: Walk) -> list[Target]:
    targets = []
    for room in ground.rooms:
        within = _with_doorways(rooms, ground, int(room))
        shape = within if _tight(rooms, int(room), walk) else rooms.shapes[room]
        for wanted in (shape, within):
            if shapely.intersects(walk.bare_reached, wanted):
                targets.append(Target(int(room), -1, wanted))
                break
    return targets


def _with_doorways(rooms: Rooms, ground: Ground, room: int) -> Shape:
    return shapely.union_all([rooms.shapes[room], *ground.doorways.get(room, [])])


def _tight(rooms: Rooms, room: int, walk: Walk) -> bool:
    """Nowhere as wide as two routes, or closed to the route by its own doorway while empty."""
    wide, shape = _TIGHT * 2 * walk.radius, rooms.shapes[room]
    if shape.area < 4 * wide**2 and inscribed_width(shape) < wide:
        return True
    return not shapely.intersects(walk.bare_reached, shapely.buffer(shape, -_STEP))


def _missed_pieces(
    bodies: Bodies, rooms: Rooms, ground: Ground, walk: Walk, open_rooms: set[int]
) -> list[Target]:
    """Pieces with using sides, none of which the route comes to."""
    missed = []
    for room in sorted(open_rooms):
        rows = [int(i) for i in np.flatnonzero(bodies.room == room) if bodies.kinds[i].access]
        if not rows:
            continue
        within = _with_doorways(rooms, ground, room)
        shapes = [_before(bodies, i, walk.radius + REACH) for i in rows]
        clipped: Shapes = shapely.intersection(np.array(shapes, object), within)
        far = ~shapely.intersects(walk.reached, clipped)
        if far.any() and _tight(rooms, room, walk):
            far &= ~shapely.intersects(squeeze_in(bodies, ground, walk, within), clipped)
        missed += [Target(room, rows[k], clipped[k]) for k in np.flatnonzero(far)]
    return missed


def _before(bodies: Bodies, i: int, depth: float) -> Shape:
    """The boxes before the using sides of a piece, ``depth`` metres deep."""
    corners = bodies.corners[i]
    return shapely.multipolygons([_beyond(corners, s, depth) for s in bodies.kinds[i].access])


def _beyond(corners: Floats, side: str, depth: float) -> Shape:
    start, end = (corners[k] for k in _SIDES[side])
    along = (end - start) / max(float(np.hypot(*(end - start))), 1e-12)
    out = np.array([along[1], -along[0]]) * depth
    return shapely.polygons(np.stack([start, start + out, end + out, end]))


def _blockers(walk: Walk, missed: list[Target]) -> list[tuple[list[int], str]]:
    """For each target the rows of pieces in the way and the word that joins them: any one of
    them would open the way if taken away (or), or only all of them together (and)."""
    shapes: Shapes = np.array([target.shape for target in missed], object)
    singles: list[list[int]] = [[] for _ in missed]
    suspects = _suspects(walk, shapes)
    for k in suspects:
        reached = walk_without(walk, np.array([k]))
        for t in np.flatnonzero(shapely.intersects(reached, shapes)):
            if walk.blocking[k] != missed[t].piece:
                singles[t].append(int(walk.blocking[k]))
    return [
        (rows, "or") if rows else (_together(walk, target, suspects), "and")
        for rows, target in zip(singles, missed, strict=True)
    ]


def _together(walk: Walk, target: Target, suspects: NDArray[np.int64]) -> list[int]:
    """Rows of a least set of suspects that opens the way to a target; empty if none does."""
    away = suspects[walk.blocking[suspects] != target.piece]
    if not len(away) or not shapely.intersects(walk_without(walk, away), target.shape):
        return []
    for k in away[::-1]:
        fewer = away[away != k]
        if len(fewer) and shapely.intersects(walk_without(walk, fewer), target.shape):
            away = fewer
    return [int(row) for row in walk.blocking[away]]


def _suspects(walk: Walk, shapes: Shapes) -> NDArray[np.int64]:
    """Indices into ``walk.blocking`` of the pieces nearest to both the region reached and what is
    beyond: the shapes missed and the free floor that is cut off."""
    if not len(shapes) or not len(walk.blocking):
        return np.empty(0, np.int64)
    parts = shapely.get_parts(walk.free)
    beyond = parts[~shapely.intersects(parts, walk.start)]
    apart = shapely.distance(walk.grown, shapely.union_all([*shapes, *beyond]))
    if not walk.reached.is_empty:
        apart = apart + shapely.distance(walk.grown, walk.reached)
    order = np.lexsort((-shapely.area(walk.grown), np.round(apart, 2)))
    return np.asarray(order[:_NEAREST], np.int64)


def _why(walk: Walk, target: Target) -> str:
    """What to say when no piece can be blamed."""
    if target.piece >= 0 and not shapely.intersects(walk.bare, target.shape):
        return ": there is no room to stand before it"
    return ", whatever is taken away nearby"


def _finding(
    bodies: Bodies, rooms: Rooms, walk: Walk, target: Target, rows: list[int], word: str
) -> Finding:
    space = rooms.spaces[target.room]
    piece = bodies.pieces[target.piece] if target.piece >= 0 else None
    names = [bodies.pieces[row].id for row in rows]
    short = shapely.distance(walk.reached, target.shape)
    what = f"{piece.id} of {space.id}" if piece else f"room {space.id}"
    told = f"no route {2 * walk.radius:.2f} m wide leads to {what}"
    verb = "are" if word == "and" and len(names) > 1 else "is"
    told += f": {f' {word} '.join(names)} {verb} in the way" if names else _why(walk, target)
    given = all(bodies.pieces[row].fixed for row in rows) and (piece is None or piece.fixed)
    return Finding(
        "unreachable_piece" if piece else "unreachable_room", space.level, space.id,
        piece.id if piece else "", ",".join(names), told,
        round(float(np.nan_to_num(short)), 4), given=given and bool(rows or piece),
    )  # fmt: skip
