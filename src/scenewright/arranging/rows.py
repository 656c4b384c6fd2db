"""Rules of an arrangement as rows of tables, in a small vocabulary of relations.

A row says which pieces it is about (``of``), what is asked (``relation``), of what else or which
parts of the room (``to``), within how many ``metres``, and what it costs if it does not hold. A row
is plain data: the same one is weighed by the search, names what a repair moves, and says in a
sentence what is wrong.
"""

from __future__ import annotations

from math import inf
from typing import NamedTuple

FRONT, LEFT, BACK, RIGHT, ROUND, ON = range(6)
"""Where the floor of a row lies: beyond a side of a piece, all round it, or under it."""
GROUP, PIECE, ANY = range(3)
"""What the others of a row are: of other groups, other pieces, or any."""
HALF, FLAT, WHOLE = range(3)
"""What a broken row costs: half for being broken and half by its degree, all at any degree, or by
its degree alone."""
FLOOR, STRIP, SQUARE, ALONG, METRES = range(5)
"""What the area that is taken is divided by: the floor of the row; a strip as wide as the row and
as long as the shortest side of either piece; a square metre; the depth of the part of the room; the
metres of the row."""
WALLS, DOORS, WAYS, WINDOWS, OPENINGS, TURNS, PANES, ENTRANCES, EXITS, COLUMNS, WAY_IN, PIPES = (
    1 << k for k in range(12)
)
"""Parts of a room: what is beyond its walls, where doors swing, the ways from door to door, the
floor before windows and before wide doors, the directions of its walls, the glass; of a hall where
people come in and leave, its columns, and the way in that stays free; walls with pipes in them."""


class Class(NamedTuple):
    """What a row is about: ``words`` for it; pieces of ``kinds``, or of groups of a function among
    ``groups``, or any ``but`` of some kinds; none of groups ``outside``. Only what begins
    ``below`` a height counts, metres, apart from kinds ``hung``. ``floor``: of a group the floor it
    takes as a whole instead of its pieces. ``parts`` are those of the room."""

    words: str = ""
    kinds: frozenset[str] = frozenset()
    groups: frozenset[str] = frozenset()
    but: frozenset[str] | None = None
    outside: frozenset[str] = frozenset()
    below: float = inf
    hung: frozenset[str] = frozenset()
    floor: bool = False
    parts: int = 0


class Relation(NamedTuple):
    """What a row asks, by ``name``, and how its degree is measured: see the functions below."""

    name: str
    side: int = ON
    per: int = FLOOR
    grade: int = HALF
    unseen: float = 0.0
    each: bool = False
    within: int = GROUP
    wide: float = 0.0
    inset: float = 0.0
    start: float = inf
    turned: float = -2.0
    full: float = 1.0


class Place(NamedTuple):
    """A piece of a kind at a place in metres, turned by degrees."""

    kind: str
    x: float
    y: float
    turn: float
    width: float
    depth: float
    above: float = 0.0


class Example(NamedTuple):
    """Pieces among which a row is broken and among which it holds, and those it is broken among
    once they are mended: in a room of 5 by 4 m from the origin on, with a door that opens inwards
    in the middle of its lower wall and a window in the middle of its upper one."""

    broken: tuple[Place, ...]
    held: tuple[Place, ...]
    mended: tuple[Place, ...]


class Row(NamedTuple):
    """One rule. ``cost`` is a number, or the name of one in the settings of a preset, that many
    ``times``; in rooms of less than ``area`` square metres ``tight`` times that. ``only`` in rooms
    of just these functions. ``fixed``: fixed pieces are held to it too. ``late``: it is
    weighed once a home is furnished, not while a room is composed, ``early``: then as well. A row
    that is ``joined`` has one degree with the row before it, the larger of both. ``moves``: its
    group is placed anew for it. ``says`` is what is wrong where it does not hold, with
    ``{of}``, ``{to}`` and ``{metres}``."""

    id: str
    of: Class
    relation: Relation
    to: Class
    metres: float
    cost: float | str
    says: str
    source: str
    hard: bool = False
    times: float = 1.0
    area: float = 0.0
    tight: float = 0.0
    only: tuple[str, ...] = ()
    fixed: bool = False
    late: bool = False
    early: bool = False
    joined: bool = False
    moves: bool = True
    example: Example | None = None


def clear(
    side: int,
    unseen: float = 0.03,
    *,
    each: bool = False,
    within: int = GROUP,
    wide: float = 0.0,
    inset: float = 0.0,
    start: float = inf,
    grade: int = HALF,
) -> Relation:
    """Floor as deep as the metres of the row on a side of a piece is free, up to an ``unseen``
    share: of others one by one, or of all together. It is as wide as the piece, less an
    ``inset`` at both ends, or so ``wide``; before a deep piece it may ``start`` so far from its
    back."""
    return Relation("clear", side, FLOOR, grade, unseen, each, within, wide, inset, start)


def apart(unseen: float = 0.03, grade: int = HALF) -> Relation:
    """Each other piece keeps off all round a piece; the degree is the share of a strip as long as
    the shortest side of either."""
    return Relation("apart", ROUND, STRIP, grade, unseen, True)


def keep_off(unseen: float, grade: int = HALF, *, each: bool = False) -> Relation:
    """What others take of the floor round a piece or group is no more than ``unseen`` square
    metres, which are the degree: of each one, or of all together."""
    return Relation("keep_off", ROUND, SQUARE, grade, unseen, each, ANY)


def off(unseen: float, per: int = FLOOR, grade: int = HALF, *, each: bool = False) -> Relation:
    """A piece is not on parts of the room, each grown by the metres of the row."""
    return Relation("off", ON, per, grade, unseen, each)


def no_back(side: int, wide: float, turned: float, unseen: float) -> Relation:
    """Nothing on a side of a piece, so ``wide``, turns its back on it: a cosine of more than
    ``turned`` between both headings, on more than ``unseen`` square metres."""
    return Relation("no_back", side, SQUARE, FLAT, unseen, True, GROUP, wide, turned=turned)


def square_to() -> Relation:
    """A piece is turned off some wall or a right angle to it by no more than the metres of the row,
    which are radians."""
    return Relation("square_to", grade=FLAT)


def against(side: int, full: float = 0.0) -> Relation:
    """A piece stands at a wall with a long side (``LEFT``) or its back (``BACK``), over most of it;
    from ``full`` metres on the degree is 1, without it for any gap."""
    return Relation("against", side, grade=HALF if full else FLAT, full=full or 1.0)


def near(full: float) -> Relation:
    """A piece is no farther from the nearest of some parts of the room, as it looks out of them,
    than the metres of the row; the degree rises to 1 ``full`` metres from it."""
    return Relation("near", grade=WHOLE, full=full)


def faces(away: float = 0.0, grade: int = WHOLE, within: float = inf) -> Relation:
    """A piece does not turn its back to the nearest of some parts of the room, ``within`` so many
    metres: the degree is the cosine between its back and the way to that, where it is more than
    ``away``."""
    return Relation("faces", grade=grade, unseen=away, start=within)


def beside(ahead: float, alike: float) -> Relation:
    """Where there are others, a piece of a group stands side by side with one: the gap is no more
    than the metres of the row, the other at most so far ``ahead``, and the cosine of the angle
    between them at least ``alike``."""
    return Relation("beside", grade=FLAT, start=ahead, turned=alike)


def say(row: Row, of: str = "", to: str = "") -> str:
    """What is wrong where a row does not hold, in a sentence; ``of`` and ``to`` name the pieces.

    >>> rug = Class("a rug", frozenset(("rug",)))
    >>> say(Row("thin", rug, apart(), rug, 0.1, 1.0, "{of} is within {metres} m of {to}", ""))
    'a rug is within 0.1 m of a rug'
    """
    metres = f"{row.metres:g}"
    return row.says.format(of=of or row.of.words, to=to or row.to.words, metres=metres)


def is_lone(row: Row) -> bool:
    """Whether a row is about pieces and their room alone, whatever else is there."""
    return row.to.but is None and not (row.to.kinds or row.to.groups)
