"""Rooms of a furnished home in which a row of homes is broken, among those it is about."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from benchmarks.composition_faults import Count
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.rules.told import ROWS_OF_PIECES, list_broken


def count_rows(spaces: Iterable[Space], pieces: Sequence[Piece]) -> dict[str, Count]:
    """For each row about pieces how many rooms break it, of those that hold one."""
    faulty, of = Counter[str](), Counter[str]()
    for space in spaces:
        kinds = {piece.category for piece in pieces if piece.space == space.id}
        of.update(row.id for row in ROWS_OF_PIECES if kinds & row.of.kinds)
        faulty.update({fault.row.id for fault in list_broken(space, pieces, ROWS_OF_PIECES)})
    return {
        f"row {row.id}": Count(faulty[row.id], of[row.id]) for row in ROWS_OF_PIECES if of[row.id]
    }
