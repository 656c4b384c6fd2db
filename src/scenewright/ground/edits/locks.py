"""Buildings of a saved solution that stay where they stand when it is solved again."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any, Protocol, TypeVar

from scenewright.core.errors import InputError
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution


class LockableArea(Protocol):
    """A part of a brief with buildings that stay, each with its id: a site, a block."""

    fixed: list[Any]

    def model_copy(self, *, update: dict[str, Any]) -> Any:
        """The same with other values."""


AreaT = TypeVar("AreaT", bound=LockableArea)


def lock_areas(
    solution: Solution,
    areas: Sequence[AreaT],
    names: Sequence[str],
    keep: Callable[[Piece], Any | None],
    dressing: str,
    what: str,
) -> list[AreaT]:
    """The parts of a brief to solve again: what is locked in each, as ``keep`` writes it (``None``:
    it stands by the brief), is ``fixed``, with what was before and has no piece; all else is free.
    What the brief did not have there is marked as ``locked`` by hand. Words as of
    :func:`check_lockable`.
    """
    for piece in solution.pieces:
        check_lockable(piece, dressing, what) if piece.fixed else None
    updated = []
    for area, name in zip(areas, names, strict=True):
        here = [piece for piece in solution.pieces if piece.space == name]
        ids = {piece.id for piece in here}
        before = {row.id: row for row in area.fixed}
        kept = (keep(piece) for piece in here if piece.fixed)
        locked = [_lock(row, before.get(row.id)) for row in kept if row is not None]
        unplaced = [row for row in area.fixed if row.id not in ids]
        updated.append(area.model_copy(update={"fixed": [*locked, *unplaced]}))
    return updated


def _lock(row: Any, before: Any | None) -> Any:
    """A row for a building: that of ``before`` if it stands as it did, else locked by hand."""
    if before is not None and (before.at, before.heading, before.size) == (
        row.at,
        row.heading,
        row.size,
    ):
        return before
    return row.model_copy(update={"locked": True})


def count_buildings(
    solution: Solution, areas: Sequence[AreaT], names: Sequence[str]
) -> list[AreaT]:
    """The parts of a brief, each asked for as many buildings as the solution has there."""
    counts = Counter(p.space for p in solution.pieces if p.category == "building")
    return [
        area.model_copy(update={"count": counts[name], "coverage": None})
        for area, name in zip(areas, names, strict=True)
    ]


def check_lockable(piece: Piece, dressing: str, what: str) -> None:
    """InputError for what is no building: it is ``dressing`` that follows ``what`` can be locked.

    >>> from scenewright.core.scene import Pose, Size
    >>> oak = Piece("oak", "tree", "", "s", Pose(0, 0, 0, 0), Size(1, 1, 1))
    >>> check_lockable(oak, "trees", "houses")
    Traceback (most recent call last):
    scenewright.core.errors.InputError: 'oak' cannot be locked: trees are placed after the houses; \
lock houses only
    """
    if piece.category != "building":
        raise InputError(
            f"'{piece.id}' cannot be locked: {dressing} are placed after the {what}",
            f"lock {what} only",
        )
