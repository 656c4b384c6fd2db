"""What a user changes by hand in a furnished home: pieces moved, swapped, locked and let go.

A group hangs together: who moves its main piece (the bed, the sofa) takes all of it along, who
moves another (a chair) takes that and what stands on it. Locks are of whole groups.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from math import cos, hypot, pi, sin
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.domains.home.groups import GROUPS
from scenewright.domains.standing import is_radiator
from scenewright.errors import InputError
from scenewright.layout import corners
from scenewright.scene import STAIRS, Piece, Pose
from scenewright.solution import Patch
from scenewright.space import Space

Frame = tuple[float, float, float]
MOST = 6  # names listed in a message
NUDGE = 0.05  # step of the search for where a swapped group fits, metres
NUDGES = 12
STICKS_OUT = 0.1  # how far a piece put by hand may stick out of its room, metres


class Edits(NamedTuple):
    """Changes by the names of pieces or groups: ``move`` to (x, y) or (x, y, heading) in metres
    and radians, ``swap`` pairs, ``lock`` and ``unlock``, and rooms to furnish ``again``."""

    move: Mapping[str, tuple[float, ...]] = {}
    swap: tuple[tuple[str, str], ...] = ()
    lock: tuple[str, ...] = ()
    unlock: tuple[str, ...] = ()
    again: tuple[str, ...] = ()


class Edited(NamedTuple):
    """The pieces as changed, the ids of those that were ``moved``, the groups that were
    ``swapped``, and the ids of all rooms that are ``touched``."""

    pieces: tuple[Piece, ...]
    moved: frozenset[str]
    swapped: frozenset[str]
    touched: frozenset[str]


def edited(
    pieces: Sequence[Piece], patches: Sequence[Patch], rooms: Sequence[Space], edits: Edits
) -> Edited:
    """Pieces with all edits made; what was moved or swapped is locked where it now stands."""
    now = {piece.id: piece for piece in pieces}
    for name in edits.unlock:
        main = named(tuple(now.values()), name)
        _check_movable(main)
        if main.function not in GROUPS:
            raise InputError(
                f"'{main.id}' belongs to no furniture group and cannot be placed anew",
                "move it instead, or take it out of the brief",
            )
        now |= {p.id: replace(p, fixed=False) for p in whole(main, now.values())}
    for name in edits.lock:
        _check_movable(named(tuple(now.values()), name))
        held = whole(named(tuple(now.values()), name), now.values())
        now |= {p.id: replace(p, fixed=True) for p in held}
    before, moved = dict(now), set()
    for name in (*edits.move, *(name for pair in edits.swap for name in pair)):
        _check_movable(named(pieces, name))
    for name, pose in edits.move.items():
        main = named(pieces, name)
        to = (pose[0], pose[1], pose[2] if len(pose) > 2 else main.pose.heading)
        there = _room_at(main, to, rooms)
        for p in carried(taken_along(main, before.values()), frame_of(main), to, there):
            now[p.id] = p
            moved.add(p.id)
    for one, other in edits.swap:
        for p in _swapped(named(pieces, one), named(pieces, other), before, patches):
            now[p.id] = p
            moved.add(p.id)
    spaces = {before[i].space for i in moved} | {now[i].space for i in moved}
    swapped = frozenset(named(pieces, name).group for pair in edits.swap for name in pair)
    touched = frozenset(spaces | _again(rooms, edits))
    return Edited(tuple(now.values()), frozenset(moved), swapped, touched)


def named(pieces: Sequence[Piece], name: str) -> Piece:
    """The piece, or the main piece of the group, that a name means: an id, the end of one, or a
    word of its category, if there is one such only; ``bedroom/bed`` is the one of that room.

    >>> bed = Piece("r/sleeping/double_bed", "double_bed", "", "r", Pose(0, 0, 0, 0), (2, 2, 1),
    ...             "r/sleeping", "sleeping")
    >>> [named([bed], name).id[-3:] for name in ("bed", "r/bed", "r/sleeping")]
    ['bed', 'bed', 'bed']
    """
    tests: tuple[Callable[[Piece], bool], ...] = (
        lambda p: p.id == name,
        lambda p: p.group == name and leads(p),
        lambda p: p.id.endswith(f"/{name}"),
        lambda p: p.group.endswith(f"/{name}") and leads(p),
        lambda p: p.category == name,
        lambda p: p.function == name and leads(p),
        lambda p: name in p.category.split("_"),
    )
    for test in tests:
        found = [p for p in pieces if test(p)]
        groups = {p.group for p in found}
        if len(found) == 1 or (len(groups) == 1 and found and leads(found[0])):
            return found[0]
        if found:
            told = ", ".join(p.id for p in found[:MOST]) + " …" * (len(found) > MOST)
            raise InputError(f"'{name}' may be any of {len(found)} pieces", f"say which: {told}")
    room, _, rest = name.partition("/")
    here = [p for p in pieces if rest and p.space == room]
    if here:
        return named(here, rest)
    raise InputError(f"there is no piece '{name}'", _nearest(name, pieces))


def _nearest(name: str, pieces: Sequence[Piece]) -> str:
    known = {word: p.id for p in pieces for word in (p.category, p.id.rpartition("/")[2], p.id)}
    near = get_close_matches(name, known, MOST, 0.5)
    told = list(dict.fromkeys(known[word] for word in near)) or [p.id for p in pieces[:MOST]]
    return f"use one of: {', '.join(told)}" if told else "the file holds no pieces"


def leads(piece: Piece) -> bool:
    """Whether a piece is what makes its group."""
    return piece.function in GROUPS and piece.category in GROUPS[piece.function].essential


def whole(piece: Piece, pieces: Iterable[Piece]) -> tuple[Piece, ...]:
    """The furniture group of a piece; the piece alone if it is of none."""
    if piece.function not in GROUPS:
        return (piece,)
    return tuple(p for p in pieces if p.group == piece.group)


def taken_along(piece: Piece, pieces: Iterable[Piece]) -> tuple[Piece, ...]:
    """What moves with a piece: its whole group if it makes it, else what stands on it."""
    listed = tuple(pieces)
    if leads(piece):
        return whole(piece, listed)
    ids = {piece.id}
    for p in listed:
        if p.on in ids:
            ids.add(p.id)
    return tuple(p for p in listed if p.id in ids)


def carried(pieces: Iterable[Piece], start: Frame, end: Frame, space: str) -> tuple[Piece, ...]:
    """Pieces moved together as one frame is laid on another (x, y, heading), locked there."""
    found = []
    for p in pieces:
        x, y, heading = laid_on(frame_of(p), start, end)
        found.append(replace(p, pose=Pose(x, y, p.pose.z, heading), space=space, fixed=True))
    return tuple(found)


def laid_on(frame: Frame, start: Frame, end: Frame) -> Frame:
    """Where a frame comes to lie as the frame ``start`` is laid on ``end``.

    >>> laid_on((1.0, 0.0, 0.0), (1.0, 0.0, 0.5), (4.0, 2.0, 0.5))
    (4.0, 2.0, 0.0)
    """
    turn = end[2] - start[2]
    c, s = cos(turn), sin(turn)
    dx, dy = frame[0] - start[0], frame[1] - start[1]
    heading = (frame[2] + turn + pi) % (2 * pi) - pi if turn else frame[2]
    return end[0] + c * dx - s * dy, end[1] + s * dx + c * dy, heading


def frame_of(piece: Piece) -> Frame:
    """Where a piece stands and looks."""
    return piece.pose.x, piece.pose.y, piece.pose.heading


def _swapped(
    one: Piece, other: Piece, pieces: Mapping[str, Piece], patches: Sequence[Patch]
) -> tuple[Piece, ...]:
    """Both in the other's place: back where the back was, heading as it was."""
    if one.group == other.group and one.function in GROUPS:
        raise InputError(f"'{one.id}' and '{other.id}' are of one group", "swap two groups")
    first, second = (taken_along(p, pieces.values()) for p in (one, other))
    backs = [_back(p, patches) for p in (one, other)]
    return (
        *carried(first, backs[0], backs[1], other.space),
        *carried(second, backs[1], backs[0], one.space),
    )


def _back(piece: Piece, patches: Sequence[Patch]) -> Frame:
    """The middle of the back of a piece, or of the patch it makes, and where it looks."""
    x, y, heading = frame_of(piece)
    depth = piece.size.depth
    if leads(piece):
        for patch in patches:
            if patch.id == piece.group:
                x, y, heading, _, depth = patch.box
    return x - cos(heading) * depth / 2, y - sin(heading) * depth / 2, heading


def _room_at(piece: Piece, to: Frame, rooms: Sequence[Space]) -> str:
    """The room of the piece's level that a point lies in."""
    level = {room.id: room.level for room in rooms}
    point = shapely.Point(to[:2])
    here = [r for r in rooms if r.level == level.get(piece.space)]
    for room in sorted(here, key=lambda r: r.id != piece.space):
        if shapely.Polygon(room.outline, list(room.holes)).covers(point):
            _check_inside(piece, to, room)
            return room.id
    raise InputError(
        f"'{piece.id}' cannot stand at ({to[0]:g}, {to[1]:g}): no room of its level is there",
        _extent(next((r for r in here if r.id == piece.space), None)),
    )


def _check_inside(piece: Piece, to: Frame, room: Space) -> None:
    """A piece put by hand lies on the floor of its room: in no wall, and on no stairs."""
    box = shapely.Polygon(corners(np.array([[*to, piece.size.width, piece.size.depth]]))[0])
    floor = shapely.Polygon(room.outline, list(room.holes))
    out = max(floor.distance(shapely.Point(c)) for c in shapely.get_coordinates(box))
    told = f"'{piece.id}' of {piece.size.width:.2f} x {piece.size.depth:.2f} m"
    if out > STICKS_OUT:
        raise InputError(
            f"{told} at ({to[0]:g}, {to[1]:g}) would stick {out:.2f} m out of its room",
            f"turn it or give a point further inside; {_extent(room)}",
        )
    if len(room.stair_parts):
        taken = corners(np.array([part.box for part in room.stair_parts]))
        if shapely.union_all(shapely.polygons(taken)).intersection(box).area > STICKS_OUT**2:
            raise InputError(f"{told} at ({to[0]:g}, {to[1]:g}) would stand in the stairs",
                             "give a point beside them")  # fmt: skip


def _extent(room: Space | None) -> str:
    if room is None:
        return "give a point inside a room"
    (x0, y0), (x1, y1) = room.outline.min(0), room.outline.max(0)
    return f"'{room.id}' lies within {x0:.2f} to {x1:.2f} and {y0:.2f} to {y1:.2f}"


def _check_movable(piece: Piece) -> None:
    if piece.function == STAIRS:
        raise InputError(f"'{piece.id}' is of the building", "move the stairs in the brief")
    if is_radiator(piece):
        raise InputError(
            f"'{piece.id}' belongs to the building", 'change it in the brief, under "radiators"'
        )


def _again(rooms: Sequence[Space], edits: Edits) -> set[str]:
    known = {room.name: room.id for room in rooms} | {room.id: room.id for room in rooms}
    for name in edits.again:
        if name not in known:
            found = [known[n] for n in get_close_matches(name, known, MOST, 0.5)]
            near = dict.fromkeys(found or [room.id for room in rooms][:20])
            raise InputError(f"there is no room '{name}'", f"use one of: {', '.join(near)}")
    return {known[name] for name in edits.again}


def near_poses(frame: Frame) -> list[Frame]:
    """Places near a pose, the nearest first, along its own axes."""
    x, y, h = frame
    steps = range(-NUDGES, NUDGES + 1)
    offsets = sorted(((i * NUDGE, k * NUDGE) for i in steps for k in range(NUDGES + 1)),
                     key=lambda o: hypot(*o))  # fmt: skip
    return [(x + a * sin(h) + b * cos(h), y - a * cos(h) + b * sin(h), h) for a, b in offsets]
