"""Model against model: whether the meshes of pieces are in each other, and whether doors, drawers
and flaps open.

Footprints say whether two boxes share floor; here the closed solids that the models are drawn of
are compared, part by part. Boxes about them come first: only solids whose boxes share more than
:data:`DEPTH` are compared at all. By rule nothing is said of what gives way or is lain on: rugs,
curtains, blinds and foliage; cushions, throws and towels may lie :data:`SOFT` deep in what they
lie on.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, sin
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.check.solids import Floats, Solid, penetration_depth
from scenewright.core.report import Finding
from scenewright.core.scene import Piece

DEPTH = 0.005
"""Metres by which models may be in each other."""
SOFT = 0.08
"""Metres by which soft goods may lie in what they lie on."""
GIVING = frozenset(("rug", "curtain", "blind", "plant", "potted_tree", "planter", "tree"))
"""What gives way: textiles that hang or lie, and foliage."""
TEXTILES = frozenset(("cushion", "throw", "towels", "rolled_towel", "teddy", "bag", "hat"))
"""Soft goods."""
SEATS = ("chair", "stool", "bench", "pouf")
"""Words of kinds that people push aside."""
STEPS = 18
"""Positions of a body at which it is tried, from closed to open: every 5° of a door."""


class Moving(NamedTuple):
    """What of a model moves: its name, how (``hinge`` or ``slide``) about or along which line, from
    closed to ``upper``, and its solids where they are closed; all in the frame of the level."""

    name: str
    kind: str
    pivot: Floats
    axis: Floats
    upper: float
    solids: tuple[Solid, ...]


class DrawnPiece(NamedTuple):
    """A piece with the solids it is drawn of, in the frame of its level; those that move also as
    ``moving`` bodies."""

    piece: Piece
    level: str
    solids: tuple[Solid, ...]
    moving: tuple[Moving, ...] = ()

    @property
    def box(self) -> tuple[Floats, Floats]:
        """The box about all of it."""
        low = np.min([solid.low for solid in self.solids], axis=0)
        return low, np.max([solid.high for solid in self.solids], axis=0)


class Meeting(NamedTuple):
    """Two pieces and how deep they are in each other, metres."""

    first: int
    second: int
    depth: float


def find_meetings(drawn: Sequence[DrawnPiece]) -> list[Meeting]:
    """Pairs of pieces, by number, whose models are in each other by more than is allowed."""
    found = []
    for i, j in _near(drawn):
        allowed = _allowed(drawn[i].piece, drawn[j].piece)
        if allowed is None:
            continue
        depth = _depth(drawn[i].solids, drawn[j].solids, allowed)
        if depth > 0:
            found.append(Meeting(i, j, depth))
    return found


def _near(drawn: Sequence[DrawnPiece]) -> Iterator[tuple[int, int]]:
    """Pairs of one level whose boxes share more than the depth allowed."""
    boxes = [one.box for one in drawn]
    plan = [shapely.box(*(low[:2]), *(high[:2])) for low, high in boxes]
    first, second = shapely.STRtree(plan).query(plan, predicate="intersects")
    for i, j in zip(first.tolist(), second.tolist(), strict=True):
        if i < j and drawn[i].level == drawn[j].level and _share(*boxes[i], *boxes[j]):
            yield i, j


def _share(low: Floats, high: Floats, lower: Floats, higher: Floats) -> bool:
    return bool((np.minimum(high, higher) - np.maximum(low, lower) > DEPTH).all())


def _allowed(a: Piece, b: Piece) -> float | None:
    """How deep two pieces may be in each other; none where it is not looked at."""
    if {a.category, b.category} & GIVING:
        return None
    soft = {a.category, b.category} & TEXTILES
    return SOFT if soft and (a.on == b.id or b.on == a.id or len(soft) == 2) else DEPTH


def _depth(first: Sequence[Solid], second: Sequence[Solid], allowed: float) -> float:
    """The deepest that solids of one are in solids of the other; 0 if not more than allowed."""
    lows = np.array([solid.low for solid in second])
    highs = np.array([solid.high for solid in second])
    deepest = 0.0
    for solid in first:
        shared = np.minimum(solid.high, highs) - np.maximum(solid.low, lows)
        for k in np.flatnonzero((shared > allowed).all(1)):
            deepest = max(deepest, penetration_depth(solid, second[int(k)], allowed))
    return deepest


class Stop(NamedTuple):
    """A moving body that does not open all the way: the number of its piece, its name, the share of
    its way it is free, and the piece it meets."""

    piece: int
    body: str
    free: float
    other: int


def find_stops(drawn: Sequence[DrawnPiece]) -> list[Stop]:
    """Doors, drawers and flaps that meet another piece before they are open.

    Each is tried at :data:`STEPS` positions. What people push aside (seats) and what gives way
    stops nothing, and nothing stops things on the body's own piece.
    """
    boxes = [one.box for one in drawn]
    low, high = np.array([box[0] for box in boxes]), np.array([box[1] for box in boxes])
    found = (
        _first_stop(drawn, low, high, i, body) for i, one in enumerate(drawn) for body in one.moving
    )
    return [stop for stop in found if stop is not None]


def _first_stop(
    drawn: Sequence[DrawnPiece], low: Floats, high: Floats, i: int, body: Moving
) -> Stop | None:
    ways = [position(body, body.upper * step / STEPS) for step in range(1, STEPS + 1)]
    placed = [[solid.moved(turn, shift) for solid in body.solids] for turn, shift in ways]
    lows = np.array([[solid.low for solid in solids] for solids in placed]).min(1)
    highs = np.array([[solid.high for solid in solids] for solids in placed]).max(1)
    shared = np.minimum(high, highs.max(0)) - np.maximum(low, lows.min(0))
    near = [
        j
        for j in np.flatnonzero((shared > DEPTH).all(1)).tolist()
        if j != i and drawn[j].level == drawn[i].level and not _yields(drawn[j].piece)
        if drawn[j].piece.on != drawn[i].piece.id
    ]
    for step, solids in enumerate(placed if near else ()):
        for j in near:
            meets = _share(lows[step], highs[step], low[j], high[j])
            if meets and _depth(solids, drawn[j].solids, DEPTH) > 0:
                return Stop(i, body.name, step / STEPS, j)
    return None


def _yields(piece: Piece) -> bool:
    return piece.category in GIVING or any(word in piece.category for word in SEATS)


def position(body: Moving, amount: float) -> tuple[Floats, Floats]:
    """The turn (3, 3) and shift (3,) of a body that is moved by an amount from where it is closed
    (Rodrigues 1840 for hinges).

    >>> slide = Moving("drawer", "slide", np.zeros(3), np.array([0.0, 1, 0]), 0.4, ())
    >>> position(slide, 0.3)[1].tolist()
    [0.0, 0.3, 0.0]
    """
    if body.kind == "slide":
        return np.eye(3), body.axis * amount
    x, y, z = body.axis
    across = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    turn = np.eye(3) + sin(amount) * across + (1 - cos(amount)) * across @ across
    return turn, body.pivot - turn @ body.pivot


def describe_meetings(drawn: Sequence[DrawnPiece], found: Sequence[Meeting]) -> list[Finding]:
    """Meetings as findings of the referee."""
    return [
        Finding(
            "mesh_overlap",
            drawn[one.first].level,
            drawn[one.first].piece.space,
            drawn[one.first].piece.id,
            drawn[one.second].piece.id,
            f"the models of {drawn[one.first].piece.id} and {drawn[one.second].piece.id} are "
            f"{100 * one.depth:.1f} cm in each other",
            round(one.depth, 4),
            given=drawn[one.first].piece.fixed and drawn[one.second].piece.fixed,
        )
        for one in found
    ]


def describe_stops(drawn: Sequence[DrawnPiece], found: Sequence[Stop]) -> list[str]:
    """What does not open all the way, a line each."""
    return [
        f"{drawn[one.piece].piece.id}: {one.body} opens {one.free:.0%} of its way, then it meets "
        f"{drawn[one.other].piece.id}"
        for one in found
    ]
