"""Rooms of a furnished home in which a row of homes is broken, among those it is about."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

import numpy as np
import shapely

from benchmarks.composition_faults import Count
from scenewright.core.catalog import Group
from scenewright.core.scene import Piece
from scenewright.core.space import Space
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.ground import ground_of
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.weigh_home import ROWS, compile_table, list_faults

UNKNOWN = FurnishedPatch(Group("", "", 0.0, 0.0, ()), np.zeros(5), (), 0)
"""The floor of a group as a whole, which finished pieces do not say."""
ROWS_OF_PIECES = tuple(row for row in ROWS if not row.of.floor)


def count_rows(spaces: Iterable[Space], pieces: Sequence[Piece]) -> dict[str, Count]:
    """For each row about pieces how many rooms break it, of those that hold one."""
    faulty, of = Counter[str](), Counter[str]()
    for space in spaces:
        groups = list_groups([piece for piece in pieces if piece.space == space.id])
        kinds = {piece.category for group in groups for piece in group.pieces}
        of.update(row.id for row in ROWS_OF_PIECES if kinds & row.of.kinds)
        area = shapely.Polygon(space.outline, list(space.holes)).area
        faults = list_faults(compile_table(ROWS_OF_PIECES), groups, (), ground_of(space, (), area))
        faulty.update({fault.row.id for fault in faults})
    return {
        f"row {row.id}": Count(faulty[row.id], of[row.id]) for row in ROWS_OF_PIECES if of[row.id]
    }


def list_groups(pieces: Iterable[Piece]) -> list[FurnishedGroup]:
    """The groups that finished pieces of one room are of."""
    found: dict[str, list[Piece]] = {}
    for piece in pieces:
        found.setdefault(piece.group, []).append(piece)
    return [
        FurnishedGroup(Wish(name.rsplit("/")[-1], 0), name, UNKNOWN, tuple(own))
        for name, own in found.items()
    ]
