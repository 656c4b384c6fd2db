"""What a format does not hold of a solution: the column ``lacks`` of its row, in numbers.

A word of the column that is a key of :data:`COUNTED` is listed with how many there are in this
solution, and not at all where there are none; any other word is always listed.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from scenewright.formats.table import row_of

if TYPE_CHECKING:
    from scenewright.core.solution import Solution


class Loss(NamedTuple):
    """A kind of things that a file does not hold, and how many there are (``None``: uncounted)."""

    kind: str
    number: int | None

    def describe(self) -> str:
        """The loss in words.

        >>> Loss("hanging lamps", 3).describe(), Loss("reasons", None).describe()
        ('3 hanging lamps', 'reasons')
        """
        return self.kind if self.number is None else f"{self.number:,} {self.kind}"


def _count_hanging(solution: Solution) -> int:
    from scenewright.catalog.loading import catalog_of

    kinds = catalog_of(solution.brief.catalogs).kinds
    above = {name for name, kind in kinds.items() if kind.support == "ceiling"}
    return sum(piece.category in above for piece in solution.pieces)


def _count_roofs(solution: Solution) -> int:
    """Buildings with models of which a city model does not hold the roof."""
    from scenewright.ground.buildings.city_roofs import find_roofed

    built = [piece for piece in solution.pieces if piece.category == "building" and piece.asset]
    return sum(find_roofed(piece, {}) is None for piece in built)


COUNTED: dict[str, Callable[[Solution], int]] = {
    "hanging lamps": _count_hanging,
    "sloped ceilings": lambda solution: sum(len(room.slopes) for room in solution.brief.rooms),
    "outlets": lambda solution: sum(len(room.outlets) for room in solution.brief.rooms),
    "roofs": _count_roofs,
    "trees and street furniture": lambda solution: sum(
        piece.category != "building" for piece in solution.pieces
    ),
    "things not placed": lambda solution: len(solution.left_out),
}
"""Kinds of losses that a solution may have none of."""


def losses(solution: Solution, path: str | os.PathLike[str]) -> tuple[Loss, ...]:
    """What a file named ``path`` does not hold of a solution, in the order of its row.

    >>> from scenewright import arrange
    >>> solution = arrange("sample:home-room", steps=50).solution
    >>> [loss.kind for loss in losses(solution, "room.json")]
    []
    >>> "reasons" in [loss.kind for loss in losses(solution, "room.glb")]
    True
    """
    row = row_of(path, "writer", solution.brief.domain)
    counts = [(kind, COUNTED[kind](solution) if kind in COUNTED else None) for kind in row.lacks]
    return tuple(Loss(kind, count) for kind, count in counts if count != 0)
