"""The floor furniture is used from: before doors, drawers and worktops, beside beds for two."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from math import cos, hypot, sin

from scenewright.catalog.classes import RUN
from scenewright.core.catalog import Member
from scenewright.core.scene import Piece, Size
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.rules.classes import MOVED
from scenewright.geometry.boxes import Frame, common_area, make_frame

BEFORE = {
    **dict.fromkeys(RUN, 0.75),
    "wardrobe": 0.6,
    "chest_of_drawers": 0.45,
    "sideboard": 0.45,
    "bookcase": 0.45,
    "washing_machine": 0.6,
    "dryer": 0.6,
    "desk": 0.6,
    "kids_desk": 0.6,
}
"""Metres of floor before what is opened, worked or sat at."""
BESIDE_FOOT = 0.5
"""Metres of floor beside the foot half of a bed for two, from which one gets in."""


def measure_taken(added: Iterable[Piece], others: Iterable[Piece]) -> float:
    """Square metres of the floor that others are used from on which pieces stand that are added;
    chairs are moved aside, but not from beside a bed.

    >>> from scenewright.core.scene import Pose, Size
    >>> bed = Piece("b", "double_bed", "", "a", Pose(0, 0, 0, 0), Size(1.6, 2.0, 0.5))
    >>> chair = Piece("c", "armchair", "", "a", Pose(0.6, 1.1, 0, 0), Size(0.8, 0.8, 0.8))
    >>> round(measure_taken([chair], [bed]), 2)
    0.4
    """
    low = [p for p in added if p.pose.z < ON_FLOOR and p.category != "rug"]
    frames = [
        (p.category in MOVED, make_frame(p.pose.x, p.pose.y, p.pose.heading, *p.size[:2]))
        for p in low
    ]
    total = 0.0
    for floor, bed in _list_floors(others) if low else ():
        for moved, frame in frames:
            near = hypot(floor[0] - frame[0], floor[1] - frame[1]) < floor[6] + frame[6]
            if near and (bed or not moved):
                total += float(common_area(floor, frame))
    return total


def _list_floors(pieces: Iterable[Piece]) -> Iterator[tuple[Frame, bool]]:
    """The floor each piece is used from, and whether it is that beside a bed."""
    for piece in pieces:
        (width, depth, _), deep = piece.size, BEFORE.get(piece.category)
        if piece.pose.z < ON_FLOOR and deep is not None:
            yield _make_floor(piece, 0.0, (depth + deep) / 2, width, deep), False
        elif piece.category == "double_bed":
            for side in (-1.0, 1.0):
                aside = side * (width + BESIDE_FOOT) / 2
                yield _make_floor(piece, aside, depth / 4, BESIDE_FOOT, depth / 2), True


def _make_floor(piece: Piece, aside: float, ahead: float, width: float, depth: float) -> Frame:
    """A box ``aside`` to the right and ``ahead`` of the middle of a piece."""
    x, y, _, turn = piece.pose
    c, s = cos(turn), sin(turn)
    return make_frame(x + ahead * c + aside * s, y + ahead * s - aside * c, turn, width, depth)


def list_floors_before(member: Member) -> Iterator[Member]:
    """The floor that a member of a group is used from, as members that take it up.

    >>> desk = Member("desk", 0, 0, 0, 0, Size(1.2, 0.6, 0.75))
    >>> [(floor.y, floor.size.depth) for floor in list_floors_before(desk)]
    [(0.6, 0.6)]
    """
    (width, depth, _), deep = member.size, BEFORE.get(member.category)
    if member.z < ON_FLOOR and deep is not None:
        yield _shift(member, 0.0, (depth + deep) / 2, width, deep)
    elif member.category == "double_bed":
        for side in (-1.0, 1.0):
            aside = side * (width + BESIDE_FOOT) / 2
            yield _shift(member, aside, depth / 4, BESIDE_FOOT, depth / 2)


def _shift(member: Member, aside: float, ahead: float, width: float, depth: float) -> Member:
    c, s = cos(member.heading), sin(member.heading)
    x, y = member.x + aside * c - ahead * s, member.y + aside * s + ahead * c
    return member._replace(x=x, y=y, size=Size(width, depth, 0.0))
