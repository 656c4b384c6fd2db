"""Groups of a single piece, read off the rows of kinds that say so."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from scenewright.catalog.kinds import KINDS
from scenewright.core.catalog import Group, Member
from scenewright.core.kind import SIDES, Kind, OwnGroup

Sides = tuple[float, float, float, float]
SPARE = 0.01
"""By how much a patch is deeper than the piece in it, in metres."""


def own_groups(kinds: Iterable[Kind] = KINDS.values()) -> dict[str, tuple[Kind, ...]]:
    """The kinds that make each group of single pieces.

    >>> [kind.category for kind in own_groups()["exercise"]]
    ['exercise_bike']
    """
    found: dict[str, tuple[Kind, ...]] = {}
    for kind in kinds:
        if kind.alone is not None:
            found[kind.alone.name] = (*found.get(kind.alone.name, ()), kind)
    return found


def cases_of(kinds: Iterable[Kind]) -> Iterator[Group]:
    """Each piece in its smallest, usual and largest size."""
    for kind in kinds:
        own = kind.alone or OwnGroup(kind.category)
        for size in dict.fromkeys(kind.sizes):
            piece = Member(kind.category, 0, 0, 0, 0, size)
            name = f"{size.width:.2f} m {kind.name}"
            yield Group(own.name, name, size.width, size.depth + SPARE, (piece,))


def access_of(kind: Kind) -> Sides:
    """The sides, at least one of which must be reachable, as flags.

    >>> access_of(KINDS["exercise_bike"])
    (0.0, 1.0, 0.0, 1.0)
    """
    front, left, back, right = (float(side in kind.access) for side in SIDES)
    return front, left, back, right


def clearance_of(kind: Kind) -> Sides:
    """Free depth outside a patch, in metres: the kind's reach before its front or, where it is
    used from elsewhere, shared among the sides it is used from.

    >>> clearance_of(KINDS["exercise_bike"])
    (0.0, 0.25, 0.0, 0.25)
    """
    used = ("front",) if "front" in kind.access else kind.access
    front, left, back, right = (kind.reach / len(used) if s in used else 0.0 for s in SIDES)
    return front, left, back, right
