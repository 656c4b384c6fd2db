"""The rows of homes that a finished home breaks, in the words of the rows."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

import numpy as np
import shapely

from scenewright.arranging.rows import Row
from scenewright.core.catalog import Group
from scenewright.core.explanation import Remark
from scenewright.core.plan import Plan
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.core.space import Space
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.furnishing.furnish import FurnishedPatch
from scenewright.domains.home.grounds.ground import ground_of
from scenewright.domains.home.programme import Wish
from scenewright.domains.home.rules.weigh_home import (
    ROWS,
    Fault,
    compile_table,
    list_faults,
    say_fault,
)
from scenewright.domains.home.settings import FaultCosts

UNKNOWN = FurnishedPatch(Group("", "", 0.0, 0.0, ()), np.zeros(5), (), 0)
"""The floor of a group as a whole, which finished pieces do not say."""
ROWS_OF_PIECES = tuple(row for row in ROWS if not row.of.floor)
LATE_OF_PIECES = tuple(row for row in ROWS_OF_PIECES if row.late)
MUCH = 3.0
"""What a row costs from which on it is told."""
REMEDY = "move one of them by hand (adjust --move), or forbid it"


def tell_faults(solution: Solution, plan: Plan) -> tuple[Remark, ...]:
    """What the rows weighed late say of a finished home, each sentence of a room once, the
    costliest first; costs in units of the energy."""
    each = FaultCosts().energy
    remarks = (
        Remark(plan.names.get(space.id, space.id), (), fault.row.id, text, REMEDY, cost / each)
        for space in plan.spaces
        for text, (fault, cost) in _sum_up(list_broken(space, solution.pieces)).items()
        if cost >= MUCH
    )
    return tuple(sorted(remarks, key=lambda remark: -remark.cost))


def _sum_up(faults: Iterable[Fault]) -> dict[str, tuple[Fault, float]]:
    """The first fault of each sentence, and what all of them cost."""
    found: dict[str, tuple[Fault, float]] = {}
    for fault in faults:
        first, cost = found.get(say_fault(fault), (fault, 0.0))
        found[say_fault(fault)] = first, cost + fault.cost
    return found


def list_broken(
    space: Space, pieces: Sequence[Piece], rows: tuple[Row, ...] = LATE_OF_PIECES
) -> list[Fault]:
    """The rows about pieces that those in a room break."""
    groups = list(list_groups(piece for piece in pieces if piece.space == space.id))
    area = shapely.Polygon(space.outline, list(space.holes)).area
    return list_faults(compile_table(rows), groups, (), ground_of(space, (), area))


def list_groups(pieces: Iterable[Piece]) -> Iterator[FurnishedGroup]:
    """The groups that finished pieces of one room are of."""
    found: dict[str, list[Piece]] = {}
    for piece in pieces:
        found.setdefault(piece.group, []).append(piece)
    for name, own in found.items():
        yield FurnishedGroup(Wish(name.rsplit("/")[-1], 0), name, UNKNOWN, tuple(own))
