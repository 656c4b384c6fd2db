"""Reach: which rooms, groups and pieces no route leads to, and what blocks them.

SceneEval (Tam et al. 2025) scores accessibility as the share of an area before each functional
side that no object covers. A free patch nobody can walk to is of no use, so here a side counts
when a person walking in by the door can come to stand before it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.check.bed_aisles import is_entered_from_foot
from scenewright.check.bodies import Bodies, Floats, Members, Rooms, Shape, Shapes
from scenewright.check.ceilings import BENDING, HEADROOM, lower_than
from scenewright.check.routes import JoinedFloor, Walk, squeeze_in, walk_without
from scenewright.check.spaces import inscribed_width
from scenewright.core.kind import Side
from scenewright.core.report import Finding
from scenewright.core.space import Space

REACH = 0.2
"""How far an arm reaches beyond the person's own radius, in metres."""

STAGE = "stage"
"""A kind one steps onto: pieces on it are reached where they are."""

_SIDES = {"front": (1, 2), "left": (2, 3), "back": (3, 0), "right": (0, 1)}
_ROUND: tuple[Side, ...] = ("front", "left", "back", "right")
_SEATS = ("seat", "chair", "stool", "bench", "pew")
_NEAREST = 12
_TIGHT = 2.0
_STEP = 0.1  # a route has entered a room when its centre is this far inside, metres


class Target(NamedTuple):
    """What has to be reached: a room, or a piece (its row, else -1) or group (its id), and the
    shape the centre of the route has to come into."""

    room: int
    piece: int
    shape: Shape
    group: str = ""


def find_unreachable(
    bodies: Bodies,
    rooms: Rooms,
    grounds: list[JoinedFloor],
    walks: list[Walk],
    groups: Sequence[Members] = (),
) -> list[Finding]:
    """Rooms, groups and pieces no route leads to, each with what blocks it.

    ``walks`` are the routes, one for each of ``grounds``.
    A room is reached if the centre of the route can come into it; a room no route could enter
    even empty is not judged. A piece with using sides (its kind's ``access``) is reached if the
    centre comes within half the route width and :data:`REACH` of one of them, straight before
    it (:data:`BENDING` further where a slope makes one bend down). Pieces of a room that is not
    reached are not listed one by one, nor those of a group none of whose pieces is reached (objects
    of a group whose kind names no side are reached from any).
    Seats that go under tables are pushed aside.

    No closet or toilet could be used if one had to walk about in it. So a *tight* room, nowhere
    as wide as two routes or closed to the route by a narrow doorway even while empty, is reached
    if its doorway is, and within it a person goes on sideways; and so one does to a seat of a
    group, along its row, and to one at a table of a group, past the chairs beside it; and to a bed
    for two from its foot (:mod:`.bed_aisles`).
    """
    found: list[Finding] = []
    placed = _by_room(bodies, groups)
    for ground, walk in zip(grounds, walks, strict=True):
        shapely.prepare(walk.reached)
        wanted = _room_targets(rooms, ground, walk)
        missed = [t for t in wanted if not shapely.intersects(walk.reached, t.shape)]
        open_rooms = {t.room for t in wanted} - {t.room for t in missed}
        missed += _missed_pieces(bodies, rooms, ground, walk, open_rooms, placed)
        blockers = _blockers(walk, missed)
        found += [
            _finding(bodies, rooms, walk, target, rows, word)
            for target, (rows, word) in zip(missed, blockers, strict=True)
        ]
    return found


def _room_targets(rooms: Rooms, ground: JoinedFloor, walk: Walk) -> list[Target]:
    targets = []
    for room in ground.rooms:
        within = _with_doorways(rooms, ground, int(room))
        shape = within if _tight(rooms, int(room), walk) else rooms.shapes[room]
        for wanted in (shape, within):
            if shapely.intersects(walk.bare_reached, wanted):
                targets.append(Target(int(room), -1, wanted))
                break
    return targets


def _with_doorways(rooms: Rooms, ground: JoinedFloor, room: int) -> Shape:
    return shapely.union_all([rooms.shapes[room], *ground.doorways.get(room, [])])


def _tight(rooms: Rooms, room: int, walk: Walk) -> bool:
    """Nowhere as wide as two routes, or closed to the route by its own doorway while empty."""
    wide, shape = _TIGHT * 2 * walk.radius, rooms.shapes[room]
    if shape.area < 4 * wide**2 and inscribed_width(shape) < wide:
        return True
    return not shapely.intersects(walk.bare_reached, shapely.buffer(shape, -_STEP))


def _missed_pieces(
    bodies: Bodies,
    rooms: Rooms,
    ground: JoinedFloor,
    walk: Walk,
    open_rooms: set[int],
    placed: dict[int, list[Members]],
) -> list[Target]:
    """Pieces whose sides of use are all off the route, and groups of such pieces."""
    missed = []
    for room in sorted(open_rooms):
        groups = placed.get(room, [])
        grouped = {int(row) for group in groups for row in group.rows}
        here = np.flatnonzero(bodies.room == room).tolist()
        rows = [i for i in here if bodies.kinds[i].access or i in grouped]
        rows = [i for i in rows if not stands_on_stage(bodies, i)]
        if not rows:
            continue
        within = _with_doorways(rooms, ground, room)
        deep = walk.radius + REACH
        shapes = [_used_from(bodies, rooms, i, deep, i in grouped) for i in rows]
        clipped: Shapes = shapely.intersection(np.array(shapes, object), within)
        far = ~shapely.intersects(walk.reached, clipped)
        names = {group.id for group in groups}
        sideways = np.array([_seat_of(bodies, i, grouped, names) for i in rows], bool)
        sideways |= bool(far.any()) and _tight(rooms, room, walk)
        if (far & sideways).any():
            near = squeeze_in(bodies, ground, walk, within)
            far[sideways] &= ~shapely.intersects(near, clipped[sideways])
        for k in np.flatnonzero(far & ~bool(rooms.spaces[room].slopes)):
            far[k] = not is_entered_from_foot(bodies, walk, rows[k], within, walk.radius + REACH)
        shape = {rows[k]: clipped[k] for k in np.flatnonzero(far)}
        lost = [g for g in groups if all(int(row) in shape for row in g.rows)]
        missed += [Target(room, -1, _all_of(g, shape), g.id) for g in lost]
        counted = {int(row) for group in lost for row in group.rows}
        missed += [
            Target(room, row, area)
            for row, area in shape.items()
            if row not in counted and bodies.kinds[row].access
        ]
    return missed


def stands_on_stage(bodies: Bodies, row: int) -> bool:
    """Whether a piece stands on a stage, onto which one steps: reached as the stage is."""
    on = bodies.pieces[row].on
    return on is not None and any(p.id == on and p.category == STAGE for p in bodies.pieces)


def _seat_of(bodies: Bodies, row: int, grouped: set[int], groups: set[str]) -> bool:
    """Whether a piece is a seat of a group, or stands at a table of one."""
    piece = bodies.pieces[row]
    mine = row in grouped or piece.group in groups
    return mine and any(word in piece.category for word in _SEATS)


def _by_room(bodies: Bodies, groups: Sequence[Members]) -> dict[int, list[Members]]:
    """Groups that hold anything by the room their first object stands in."""
    placed: dict[int, list[Members]] = {}
    for group in groups:
        if len(group.rows):
            placed.setdefault(int(bodies.room[group.rows[0]]), []).append(group)
    return placed


def _all_of(group: Members, shapes: dict[int, Shape]) -> Shape:
    return shapely.union_all([shapes[int(row)] for row in group.rows])


def _used_from(bodies: Bodies, rooms: Rooms, i: int, depth: float, grouped: bool) -> Shape:
    """The boxes before the using sides of a piece, ``depth`` metres deep; each deeper if one has
    to bend down there. Chairs of a group may stand at a wall, where one comes to their front."""
    corners, kind = bodies.corners[i], bodies.kinds[i]
    sides = (kind.reached_from if grouped else kind.access) or _ROUND
    space = rooms.spaces[bodies.room[i]]
    return shapely.multipolygons([_before(corners, side, depth, space) for side in sides])


def before_sides(bodies: Bodies, row: int, depth: float) -> list[Shape]:
    """The boxes before the sides that a piece is used from, ``depth`` metres deep."""
    return [_beyond(bodies.corners[row], side, depth) for side in bodies.kinds[row].access]


def _before(corners: Floats, side: str, depth: float, space: Space) -> Shape:
    """The box before one side of a piece of a space."""
    near = _beyond(corners, side, depth)
    if not space.slopes or lower_than(space, near, HEADROOM).is_empty:
        return near
    return _beyond(corners, side, depth + BENDING)


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
    alone = [t for t in range(len(missed)) if not singles[t]]
    together = _together(walk, [missed[t] for t in alone], suspects)
    sets = dict(zip(alone, together, strict=True))
    return [(rows, "or") if rows else (sets[t], "and") for t, rows in enumerate(singles)]


def _together(walk: Walk, targets: list[Target], suspects: NDArray[np.int64]) -> list[list[int]]:
    """For each target rows of a least set of suspects that opens the way to it; empty if none
    does. A set found for one target is named for all others it opens the way to."""
    found: list[list[int]] = [[] for _ in targets]
    shapes: Shapes = np.array([target.shape for target in targets], object)
    own = np.array([target.piece for target in targets], np.int64)
    waiting = np.ones(len(targets), bool)
    while waiting.any():
        first = int(np.argmax(waiting))
        waiting[first] = False
        away = suspects[walk.blocking[suspects] != own[first]]
        if not len(away):
            continue
        reached = walk_without(walk, away)
        if not shapely.intersects(reached, shapes[first]):
            waiting &= shapely.intersects(reached, shapes) | np.isin(own, walk.blocking[suspects])
            continue
        away = _fewest(walk, away, shapes[first])
        opened = waiting & shapely.intersects(walk_without(walk, away), shapes)
        opened &= ~np.isin(own, walk.blocking[away])
        for t in (first, *np.flatnonzero(opened)):
            found[t] = [int(row) for row in walk.blocking[away]]
        waiting &= ~opened
    return found


def _fewest(walk: Walk, away: NDArray[np.int64], shape: Shape) -> NDArray[np.int64]:
    """The pieces of a set without which the way to a shape would stay shut."""
    for k in away[::-1]:
        fewer = away[away != k]
        if len(fewer) and shapely.intersects(walk_without(walk, fewer), shape):
            away = fewer
    return away


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
    """The message when no piece can be blamed."""
    stood_at = target.piece >= 0 or target.group
    if stood_at and not shapely.intersects(walk.bare, target.shape):
        return ": there is no room to stand before it"
    return ", whatever is taken away nearby"


def _finding(
    bodies: Bodies, rooms: Rooms, walk: Walk, target: Target, rows: list[int], word: str
) -> Finding:
    space = rooms.spaces[target.room]
    piece = bodies.pieces[target.piece] if target.piece >= 0 else None
    names = [bodies.pieces[row].id for row in rows]
    short = shapely.distance(walk.reached, target.shape)
    kind, what = _what(space.id, piece.id if piece else "", target.group)
    text = f"no route {2 * walk.radius:.2f} m wide leads to {what}"
    verb = "are" if word == "and" and len(names) > 1 else "is"
    text += f": {f' {word} '.join(names)} {verb} in the way" if names else _why(walk, target)
    given = all(bodies.pieces[row].fixed for row in rows) and (piece is None or piece.fixed)
    return Finding(
        kind,
        space.level,
        space.id,
        piece.id if piece else target.group,
        ",".join(names),
        text,
        round(float(np.nan_to_num(short)), 4),
        given=given and bool(rows or piece),
    )


def _what(space: str, piece: str, group: str) -> tuple[str, str]:
    """The kind of a finding and what is not reached."""
    if group:
        return "unreachable_group", f"any object of group {group} of {space}"
    return (
        ("unreachable_piece", f"{piece} of {space}")
        if piece
        else ("unreachable_room", f"room {space}")
    )
