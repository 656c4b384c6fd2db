"""The forms of tables and soft seats that a home is settled with, the better first."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from functools import cache

from scenewright.core.catalog import Group, Member
from scenewright.core.scene import Piece, Size
from scenewright.domains.home.cases.library import shipped_cases
from scenewright.domains.home.composing.places.forms import list_further
from scenewright.domains.home.composing.seats.lounges import PLACES
from scenewright.domains.home.groups.least import LEAST as LEAST_FORMS
from scenewright.domains.home.programme import STANDS_FOR

LEAST = 2
"""Places at a table at the very least."""
EACH = 3
"""Tables of a kind tried, the smallest first: where none of them fits no larger one does."""
CHAIRS = (Size(0.78, 0.8, 0.85), Size(0.66, 0.68, 0.8))
"""Armchairs without a lamp, the larger first."""
SMALL = 1.45
"""No seats wider than this are put in, metres."""


def measure_places(pieces: Iterable[Piece | Member]) -> float:
    """The places at the table of a group; one on a stool is half of one, and there is none without
    a table."""
    each = Counter(p.category for p in pieces)
    if not any(each[name] for name in STANDS_FOR["dining"]):
        return 0.0
    return sum(worth * each[name] for name, worth in PLACES.items())


@cache
def list_tables(seats: float) -> tuple[Group, ...]:
    """The smallest tables with ``seats`` places, the better first: freestanding ones, then those
    at a wall.

    >>> [case.name for case in list_tables(6)][:2]
    ['1.6 m table for 6', '1.8 m table for 6']
    """
    known = [c for name in ("dining", "dining_wall") for c in shipped_cases(name).groups]
    forms = (*known, *list_further("dining_wall"))
    fit = [c for c in forms if measure_places(c.members) == seats and len(_find_seats(c)) >= LEAST]
    fit.sort(key=lambda case: case.width * case.depth)
    kinds = ([case for case in fit if case.function == name] for name in ("dining", "dining_wall"))
    return tuple(case for kind in kinds for case in kind[:EACH])


def _find_seats(case: Group) -> list[Member]:
    """The chairs and stools of a case."""
    return [member for member in case.members if member.category in PLACES]


@cache
def list_seats(lived_in: bool) -> tuple[Group, ...]:
    """Small seats, the better first: in a room one lives in a sofa for two before an armchair.

    >>> [case.name for case in list_seats(False)][-2:]
    ['0.78 m armchair', '0.66 m armchair']
    """
    sofas = [case for case in shipped_cases("seating").groups if case.width <= SMALL + 0.42]
    small = [case for case in sofas if case.members[0].size.width <= SMALL and case.depth < 1.0]
    single = (*shipped_cases("reading").groups, *map(_make_armchair, CHAIRS))
    wide = sorted((*small, *LEAST_FORMS["seating"]()), key=lambda case: -case.width)
    return (*wide, *single) if lived_in else single


def _make_armchair(size: Size) -> Group:
    piece = Member("armchair", 0, 0, 0, 0, size)
    name = f"{size.width:.2f} m armchair"
    return Group("reading", name, size.width, size.depth + 0.02, (piece,))
