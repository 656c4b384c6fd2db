"""What moved pieces belong to: their room, their ids and groups, and what they stand on."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import replace

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.core.scene import Piece

FIXED = "fixed"  # the function and group of what belongs to no furniture group
HIGHEST = 1.3  # top of what a piece may be put on by hand, metres


def fresh(name: str, taken: Collection[str]) -> str:
    """A name that is not taken, with the least number that makes it so.

    >>> fresh("study/desk", {"study/desk", "study/desk_2"})
    'study/desk_3'
    """
    found, number = name, 1
    while found in taken:
        number += 1
        found = f"{name}_{number}"
    return found


def moved_in(
    pieces: Sequence[Piece], group: str, space: str, taken: Collection[str]
) -> tuple[Piece, ...]:
    """Pieces that now belong to the room ``space``: with ids that no other has, in its own group.

    Those of ``group`` stay one (empty: none is whole); others become single pieces. What each
    stands ``on`` is left to :func:`restore_supports`. Ids a user gave, which do not begin with the
    old room, stay.
    """
    used = set(taken)
    whole = fresh(f"{space}/{group.rpartition('/')[2]}", used) if group else ""
    found = []
    for piece in pieces:
        tail = piece.id.rpartition("/")[2]
        if group and piece.group == group:
            piece = replace(piece, group=whole)
            wanted = f"{whole}/{tail}"
        else:
            piece = replace(piece, group=f"{space}/{FIXED}", function=FIXED)
            wanted = f"{space}/{tail}"
        own = piece.id.startswith(f"{piece.space}/")
        name = fresh(wanted, used) if own else piece.id
        used.add(name)
        found.append(replace(piece, id=name, space=space))
    return tuple(found)


def restore_supports(
    now: Mapping[str, Piece], carried: Iterable[frozenset[str]]
) -> dict[str, Piece]:
    """Pieces by their former ids with ``on`` as the present id of what is below them.

    A piece moved without what it stood on stands on what is below it now, else on the floor;
    ``carried`` are the former ids of what was moved together.
    """
    found = dict(now)
    for together in carried:
        for former in together:
            piece = found[former]
            if piece.on is not None and piece.on not in together:
                found[former] = _put_down(piece, [p for k, p in now.items() if k not in together])
    names = {former: piece.id for former, piece in now.items()}
    put = {former for former in found if found[former] is not now[former]}
    return {
        former: p if former in put or p.on is None else replace(p, on=names.get(p.on, p.on))
        for former, p in found.items()
    }


def _put_down(piece: Piece, others: Sequence[Piece]) -> Piece:
    """A piece on the highest top below its middle that it may be put on, or on the floor."""
    middle = shapely.Point(piece.pose.x, piece.pose.y)
    tops = [
        (p.pose.z + p.size.height, p.id)
        for p in others
        if p.space == piece.space and _covers(p, middle)
    ]
    top, under = max(((z, i) for z, i in tops if 0.2 < z <= HIGHEST), default=(0.0, None))
    return replace(piece, on=under, pose=piece.pose._replace(z=top))


def _covers(piece: Piece, point: shapely.Point) -> bool:
    box = np.array([[*piece.pose[:2], piece.pose.heading, *piece.size[:2]]])
    return bool(shapely.Polygon(corners(box)[0]).covers(point))


def consistent(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Pieces with ids of their own, each on a piece that is there.

    Of several with one id those that are fixed keep it. What stood on something that is gone goes
    with it; what is fixed stays, on nothing.
    """
    named = _distinct(pieces)
    while True:
        there = {piece.id for piece in named}
        loose = {p.id for p in named if p.on is not None and p.on not in there}
        if not loose:
            return named
        named = tuple(
            replace(p, on=None) if p.id in loose else p
            for p in named
            if p.fixed or p.id not in loose
        )


def _distinct(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    taken: set[str] = set()
    names: dict[int, str] = {}
    for k in sorted(range(len(pieces)), key=lambda k: (not pieces[k].fixed, k)):
        names[k] = fresh(pieces[k].id, taken)
        taken.add(names[k])
    if all(pieces[k].id == name for k, name in names.items()):
        return tuple(pieces)
    near = {(p.space, p.group, p.id): names[k] for k, p in enumerate(pieces)}
    on = [p.on and near.get((p.space, p.group, p.on), p.on) for p in pieces]
    return tuple(replace(p, id=names[k], on=on[k]) for k, p in enumerate(pieces))
