"""How much of a need the pieces of one room serve."""

from __future__ import annotations

from collections.abc import Callable, Collection, Sequence
from math import cos, pi, sin

from scenewright.catalog.classes import EATING_TABLES, SOFT_SEATS, TABLE_SEATS
from scenewright.core.scene import Piece
from scenewright.domains.home.needs.household import BED_PLACES, count_places

EDGE = 0.6
"""Metres of a table's edge, or of a bench, for each who eats."""
AT_TABLE = 0.75
"""A chair whose middle is further from a table, metres, is none of it."""


def count_kinds(kinds: Collection[str]) -> Callable[[Sequence[Piece]], float]:
    """How many pieces are of some kinds."""
    return lambda pieces: float(sum(piece.category in kinds for piece in pieces))


def measure_widths(kinds: Collection[str]) -> Callable[[Sequence[Piece]], float]:
    """Metres that pieces of some kinds are wide together."""
    return lambda pieces: sum(p.size.width for p in pieces if p.category in kinds)


def count_sleepers(pieces: Sequence[Piece]) -> float:
    """How many sleep in the beds among pieces."""
    return float(sum(BED_PLACES.get(piece.category, 0) for piece in pieces))


def count_soft_places(pieces: Sequence[Piece]) -> float:
    """How many sit on sofas and armchairs."""
    return float(count_places(piece for piece in pieces if piece.category in SOFT_SEATS))


def count_eaters(pieces: Sequence[Piece]) -> float:
    """How many eat at tables: a seat at each :data:`EDGE` of a table's edge, at most as many as
    stand at it.

    >>> from scenewright.core.scene import Pose, Size
    >>> table = Piece("t", "dining_table", "", "a", Pose(0, 0, 0, 0), Size(0.8, 0.8, 0.75))
    >>> chair = Piece("c", "dining_chair", "", "a", Pose(0, 0.7, 0, 0), Size(0.4, 0.5, 0.9))
    >>> count_eaters([table, chair]), count_eaters([chair])
    (1.0, 0.0)
    """
    tables = [piece for piece in pieces if piece.category in EATING_TABLES]
    seats = [p for p in pieces if p.category in TABLE_SEATS or p.category == "bench"]
    total = 0
    for table in tables:
        at = [seat for seat in seats if _measure_off(seat, table) <= AT_TABLE]
        seats = [seat for seat in seats if seat not in at]
        total += min(sum(map(_count_on, at)), int(_measure_edge(table) / EDGE + 1e-6))
    return float(total)


def _count_on(seat: Piece) -> int:
    return max(int(seat.size.width / EDGE + 1e-6), 1)


def _measure_edge(table: Piece) -> float:
    width, depth, _ = table.size
    return pi * width if table.category == "round_table" else 2 * (width + depth)


def _measure_off(seat: Piece, table: Piece) -> float:
    """From the middle of a seat to the nearest side of a table, along it, metres; below 0 under
    it."""
    dx, dy = seat.pose.x - table.pose.x, seat.pose.y - table.pose.y
    c, s = cos(table.pose.heading), sin(table.pose.heading)
    ahead, aside = abs(dx * c + dy * s), abs(dx * s - dy * c)
    return max(ahead - table.size.depth / 2, aside - table.size.width / 2)
