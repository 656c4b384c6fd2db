"""Changes by hand that are alike in every kind of scene: finding, carrying and locking pieces."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from difflib import get_close_matches
from math import cos, pi, sin
from typing import NamedTuple

from scenewright.core.edits import Adjusted, Change, Edits
from scenewright.core.errors import InputError
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece, Pose
from scenewright.core.solution import Solution
from scenewright.core.space import Space

Frame = tuple[float, float, float]
Together = Callable[[Piece, Sequence[Piece]], Sequence[Piece]]

MOST = 6  # names listed in a message
AROUND = "arranged around what was moved by hand"
AGAIN = "arranged again as requested"


def find_piece(pieces: Sequence[Piece], name: str, leads: Callable[[Piece], bool]) -> Piece:
    """The piece, or the piece that ``leads`` the group, that a name means: an id, the end of one,
    or a word of its category, if there is one such only; ``bedroom/bed`` is the one of that room.
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
            text = ", ".join(p.id for p in found[:MOST]) + " …" * (len(found) > MOST)
            raise InputError(f"'{name}' may be any of {len(found)} pieces", f"say which: {text}")
    room, _, rest = name.partition("/")
    here = [p for p in pieces if rest and p.space == room]
    if here:
        try:
            return find_piece(here, rest, leads)
        except InputError as error:
            raise InputError(error.fault.replace(f"'{rest}'", f"'{name}'"), error.remedy) from None
    raise InputError(f"unknown piece '{name}'", _nearest(name, pieces))


def _nearest(name: str, pieces: Sequence[Piece]) -> str:
    known = {word: p.id for p in pieces for word in (p.category, p.id.rpartition("/")[2], p.id)}
    near = get_close_matches(name, known, MOST, 0.5)
    names = list(dict.fromkeys(known[word] for word in near)) or [p.id for p in pieces[:MOST]]
    more = ", …" * (len(names) < len(pieces))
    return f"use one of: {', '.join(names)}{more}" if names else "the file holds no pieces"


def carry_pieces(pieces: Iterable[Piece], start: Frame, end: Frame) -> tuple[Piece, ...]:
    """Pieces moved together as one frame is laid on another (x, y, heading), locked there."""
    found = []
    for p in pieces:
        x, y, heading = transfer_frame(frame_of(p), start, end)
        found.append(replace(p, pose=Pose(x, y, p.pose.z, heading), fixed=True))
    return tuple(found)


def transfer_frame(frame: Frame, start: Frame, end: Frame) -> Frame:
    """Where a frame comes to lie as the frame ``start`` is laid on ``end``.

    >>> transfer_frame((1.0, 0.0, 0.0), (1.0, 0.0, 0.5), (4.0, 2.0, 0.5))
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


class Edited(NamedTuple):
    """Pieces as edited by hand, the ids of those ``moved``, and the ids of the spaces that are to
    be arranged ``again``."""

    pieces: tuple[Piece, ...]
    moved: frozenset[str]
    again: frozenset[str]


def apply_edits(
    pieces: Sequence[Piece],
    plan: Plan,
    edits: Edits,
    find: Callable[[Sequence[Piece], str], Sequence[Piece]],
    together: Together,
    aligned: float = -0.5,
) -> Edited:
    """Pieces unlocked, locked, moved, then swapped. ``find`` answers what a name means, the first
    piece leading; ``together`` all that is locked with a piece. What is swapped is ``aligned`` at
    its back (-0.5) or front (0.5). Raises InputError for a name, a place or an edit that is not
    possible."""
    now = {piece.id: piece for piece in pieces}
    for names, fixed in ((edits.unlock, False), (edits.lock, True)):
        for name in names:
            for piece in together(find(pieces, name)[0], pieces):
                now[piece.id] = replace(now[piece.id], fixed=fixed)
    moved: set[str] = set()
    for along, end in _list_moves(pieces, plan, edits, find, aligned):
        now |= {p.id: replace(now[p.id], fixed=True) for p in together(along[0], pieces)}
        now |= {p.id: p for p in carry_pieces(along, frame_of(along[0]), end)}
        moved |= {p.id for p in along}
    return Edited(tuple(now.values()), frozenset(moved), find_spaces(plan.spaces, edits.again))


def _list_moves(
    pieces: Sequence[Piece],
    plan: Plan,
    edits: Edits,
    find: Callable[[Sequence[Piece], str], Sequence[Piece]],
    aligned: float,
) -> Iterator[tuple[Sequence[Piece], Frame]]:
    """What is moved or swapped, and where to."""
    for name, to in edits.move.items():
        along = find(pieces, name)
        end = (to[0], to[1], to[2] if len(to) > 2 else along[0].pose.heading)
        _check_inside(along[0], end, plan)
        yield along, end
    for names in edits.swap:
        one, other = (find(pieces, name) for name in names)
        _check_swap(one, other)
        yield one, _frame_instead(one[0], other[0], aligned)
        yield other, _frame_instead(other[0], one[0], aligned)


def _check_swap(one: Sequence[Piece], other: Sequence[Piece]) -> None:
    first, second = one[0], other[0]
    if {p.id for p in one} & {p.id for p in other}:
        raise InputError(f"'{first.id}' and '{second.id}' are of one group", "swap two others")
    if first.space != second.space:
        raise InputError(
            f"'{first.id}' is of '{first.space}', '{second.id}' of '{second.space}'",
            "swap two of one space",
        )


def _frame_instead(piece: Piece, other: Piece, aligned: float) -> Frame:
    """Where a piece comes to stand in the place of another, their backs or fronts in one line."""
    shift = aligned * (other.size.depth - piece.size.depth)
    x, y, heading = frame_of(other)
    return x + shift * cos(heading), y + shift * sin(heading), heading


def _check_inside(piece: Piece, to: Frame, plan: Plan) -> None:
    """InputError unless a piece stays within its space."""
    space = next(s for s in plan.spaces if s.id == piece.space)
    (west, south), (east, north) = space.outline.min(0), space.outline.max(0)
    if not (west <= to[0] <= east and south <= to[1] <= north):
        raise InputError(
            f"'{piece.id}' cannot stand at ({to[0]:g}, {to[1]:g})",
            f"'{space.id}' lies within ({west:g}, {south:g}) and ({east:g}, {north:g})",
        )


def find_spaces(spaces: Sequence[Space], names: Iterable[str]) -> frozenset[str]:
    """The ids of spaces by id or name; InputError for one there is not."""
    known = {space.name: space.id for space in spaces} | {space.id: space.id for space in spaces}
    for name in names:
        if name not in known:
            near = get_close_matches(name, known, MOST, 0.5) or [s.id for s in spaces][:20]
            offered = dict.fromkeys(known.get(n, n) for n in near)
            more = ", …" * (len(offered) < len(spaces))
            raise InputError(f"unknown space '{name}'", f"use one of: {', '.join(offered)}{more}")
    return frozenset(known[name] for name in names)


def with_locks(pieces: Iterable[Piece], locked: Collection[str]) -> tuple[Piece, ...]:
    """The pieces, with just those whose ids are in ``locked`` fixed."""
    return tuple(
        p if p.fixed == (p.id in locked) else replace(p, fixed=p.id in locked) for p in pieces
    )


def list_adjusted(before: Solution, after: Solution, edited: Edited, skip: str = "") -> Adjusted:
    """The solution with every change and its reason, but for groups that end in ``skip``."""
    listed = (c for c, piece in _changes(before, after, edited) if not _ends(piece, skip))
    return Adjusted(after, tuple(listed))


def _ends(piece: Piece, skip: str) -> bool:
    return bool(skip) and piece.group.endswith(skip)


def _changes(before: Solution, after: Solution, edited: Edited) -> Iterator[tuple[Change, Piece]]:
    old: Mapping[str, Piece] = {piece.id: piece for piece in before.pieces}
    present = {piece.id for piece in after.pieces}

    def reason(piece: Piece) -> str:
        if piece.id in edited.moved:
            return "moved by hand"
        return AGAIN if piece.space in edited.again else AROUND

    for piece in after.pieces:
        was = old.get(piece.id)
        if was is None:
            yield Change(piece.id, "", "new", piece.space, reason(piece)), piece
        elif (was.pose, was.size) != (piece.pose, piece.size):
            yield Change(piece.id, piece.id, "moved", piece.space, reason(piece)), piece
    for piece in before.pieces:
        if piece.id not in present:
            yield Change(piece.id, piece.id, "gone", piece.space, reason(piece)), piece
