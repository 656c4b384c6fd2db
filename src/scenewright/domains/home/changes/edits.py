"""What a user changes by hand in a furnished home: pieces moved, swapped, locked and let go.

A group hangs together: who moves its main piece (the bed, the sofa) takes all of it along, who
moves another (a chair) takes that and whatever is on it. Locks are of whole groups.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from math import cos, hypot, sin
from typing import NamedTuple

from scenewright.building.standing import is_radiator
from scenewright.core.edits import Edits
from scenewright.core.errors import InputError
from scenewright.core.piece_edits import carry_pieces, find_spaces, frame_of
from scenewright.core.piece_edits import find_piece as find_named
from scenewright.core.scene import STAIRS, Piece
from scenewright.core.solution import Patch
from scenewright.core.space import Space
from scenewright.domains.home.changes.belonging import moved_in, restore_supports
from scenewright.domains.home.changes.destination import Frame, check_along, room_at
from scenewright.domains.home.groups import GROUPS
from scenewright.domains.home.settings import RearrangeSettings

MOST = 6  # names listed in a message
LIGHT = "light"  # the function of lamps and curtains, which follow the rest


class Shift(NamedTuple):
    """A piece that is moved with its frame from ``start`` to ``end``, into the room ``space``."""

    piece: Piece
    start: Frame
    end: Frame
    space: str


class EditedHome(NamedTuple):
    """The pieces as changed; of those that were ``moved`` the former id by the present one, and
    which piece was named for it; the ids of pieces ``swapped``, together; the ids of all rooms
    that are ``touched``."""

    pieces: tuple[Piece, ...]
    moved: Mapping[str, str]
    named: Mapping[str, str]
    swapped: tuple[frozenset[str], ...]
    touched: frozenset[str]


def apply_edits(
    pieces: Sequence[Piece], patches: Sequence[Patch], rooms: Sequence[Space], edits: Edits
) -> EditedHome:
    """Pieces with all edits made; what was moved or swapped is locked where it now stands."""
    now = {piece.id: piece for piece in pieces}
    for name in edits.unlock:
        main = find_piece(tuple(now.values()), name)
        _check_movable(main)
        if main.function not in GROUPS:
            raise InputError(
                f"'{main.id}' belongs to no furniture group and cannot be placed anew",
                "move it instead, or take it out of the brief",
            )
        now |= {p.id: replace(p, fixed=False) for p in whole(main, now.values())}
    for name in edits.lock:
        _check_movable(find_piece(tuple(now.values()), name))
        held = whole(find_piece(tuple(now.values()), name), now.values())
        now |= {p.id: replace(p, fixed=True) for p in held}
    before = dict(now)
    moved: dict[str, str] = {}
    for name in (*edits.move, *(name for pair in edits.swap for name in pair)):
        _check_movable(find_piece(pieces, name))
    sets, swapped = [], []
    for name, pose in edits.move.items():
        main = find_piece(pieces, name)
        to = (pose[0], pose[1], pose[2] if len(pose) > 2 else main.pose.heading)
        shift = Shift(main, frame_of(main), to, room_at(main, to, rooms))
        sets.append(_make(shift, before, now, moved))
        check_along(main, [now[former] for former in sorted(sets[-1])], rooms)
    for one, other in edits.swap:
        for shift in _swap_pieces(find_piece(pieces, one), find_piece(pieces, other), patches):
            sets.append(_make(shift, before, now, moved))
            swapped.append(sets[-1])
    now = restore_supports(now, sets)
    spaces = {before[i].space for i in moved} | {now[i].space for i in moved}
    touched = find_spaces(rooms, edits.again) | spaces
    ids = {former: piece.id for former, piece in now.items()}
    return EditedHome(
        tuple(now.values()),
        {ids[k]: k for k in moved},
        {ids[k]: ids[v] for k, v in moved.items()},
        tuple(frozenset(ids[k] for k in together) for together in swapped),
        touched,
    )


def _make(
    shift: Shift, before: Mapping[str, Piece], now: dict[str, Piece], moved: dict[str, str]
) -> frozenset[str]:
    """Make one move, in ``now`` and ``moved`` (which piece was named); the former ids of all that
    went along."""
    main = shift.piece
    along = taken_along(main, before.values())
    after = carry_pieces(along, shift.start, shift.end)
    if shift.space != main.space:
        _check_may_leave(main)
        ids = {p.id for k, p in now.items() if k not in {a.id for a in along}}
        groups = {p.group for p in now.values()}
        after = moved_in(after, main.group if leads(main) else "", shift.space, ids | groups)
    now |= {former.id: p for former, p in zip(along, after, strict=True)}
    moved |= {former.id: main.id for former in along}
    return frozenset(p.id for p in along)


def find_piece(pieces: Sequence[Piece], name: str) -> Piece:
    """The piece, or the main piece of the group, that a name means: an id, the end of one, or a
    word of its category, if there is one such only; ``bedroom/bed`` is the one of that room.

    >>> from scenewright.core.scene import Piece, Pose
    >>> bed = Piece("r/sleeping/double_bed", "double_bed", "", "r", Pose(0, 0, 0, 0), (2, 2, 1),
    ...             "r/sleeping", "sleeping")
    >>> [find_piece([bed], name).id[-3:] for name in ("bed", "r/bed", "r/sleeping")]
    ['bed', 'bed', 'bed']
    """
    return find_named(pieces, name, leads)


def leads(piece: Piece) -> bool:
    """Whether a piece is what makes its group."""
    return piece.function in GROUPS and piece.category in GROUPS[piece.function].essential


def whole(piece: Piece, pieces: Iterable[Piece]) -> tuple[Piece, ...]:
    """The furniture group of a piece; the piece alone if it is of none."""
    if piece.function not in GROUPS:
        return (piece,)
    return tuple(p for p in pieces if p.group == piece.group)


def taken_along(piece: Piece, pieces: Iterable[Piece]) -> tuple[Piece, ...]:
    """What moves with a piece: its whole group if it is the main piece, and anything on these."""
    listed = tuple(pieces)
    ids = {p.id for p in whole(piece, listed)} if leads(piece) else {piece.id}
    while more := {p.id for p in listed if p.on in ids} - ids:
        ids |= more
    return tuple(p for p in listed if p.id in ids)


def _swap_pieces(one: Piece, other: Piece, patches: Sequence[Patch]) -> tuple[Shift, ...]:
    """Both in the other's place: back where the back was, heading as it was."""
    if one.group == other.group and one.function in GROUPS:
        raise InputError(f"'{one.id}' and '{other.id}' are of one group", "swap two groups")
    backs = [_back(p, patches) for p in (one, other)]
    return (
        Shift(one, backs[0], backs[1], other.space),
        Shift(other, backs[1], backs[0], one.space),
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


def _check_movable(piece: Piece) -> None:
    if piece.function == STAIRS:
        raise InputError(f"'{piece.id}' is of the building", "move the stairs in the brief")
    if is_radiator(piece):
        raise InputError(
            f"'{piece.id}' belongs to the building", 'change it in the brief, under "radiators"'
        )


def _check_may_leave(piece: Piece) -> None:
    """Lamps under the ceiling and curtains belong to their room."""
    if piece.function == LIGHT:
        raise InputError(
            f"'{piece.id}' belongs to '{piece.space}' and cannot be moved into another room",
            f"give a point within '{piece.space}'",
        )


def near_poses(frame: Frame, rule: RearrangeSettings) -> list[Frame]:
    """Places near a pose, the nearest first, along its own axes."""
    x, y, h = frame
    steps = range(-rule.nudges, rule.nudges + 1)
    offsets = sorted(
        ((i * rule.nudge, k * rule.nudge) for i in steps for k in range(rule.nudges + 1)),
        key=lambda o: hypot(*o),
    )
    return [(x + a * sin(h) + b * cos(h), y - a * cos(h) + b * sin(h), h) for a, b in offsets]
