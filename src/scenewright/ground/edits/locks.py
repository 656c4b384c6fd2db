"""Buildings of a saved solution that stay where they stand when it is solved again."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Protocol, TypeVar

from scenewright.core.brief import Brief
from scenewright.core.errors import InputError
from scenewright.core.scene import Piece, Pose, Size
from scenewright.core.solution import Solution
from scenewright.ground.names import assign_ids


class Lockable(NamedTuple):
    """What of a domain's brief can be locked: the key of its parts (``blocks``) and what one is
    called (``block``), how a building is kept (``None``: it stands by the brief), things that
    follow the buildings, and what these are called."""

    key: str
    word: str
    keep: Callable[[Piece], Any | None]
    dressing: str
    what: str


class LockableArea(Protocol):
    """A part of a brief with buildings that stay, each with its id: a site, a block."""

    fixed: list[Any]

    def model_copy(self, *, update: dict[str, Any]) -> Any:
        """The same with other values."""


AreaT = TypeVar("AreaT", bound=LockableArea)


def standing_piece(
    row: Any, space: str, asset: str, function: str, what: str = "buildings"
) -> Piece:
    """The piece of a building that stays where it stands: ``row`` has its id, box (x, y, heading,
    width, depth), height and ``local``, its footprint in the frame of the box."""
    return Piece(
        id=row.id,
        category="building",
        asset=asset,
        space=space,
        pose=Pose(row.box[0], row.box[1], 0.0, row.box[2]),
        size=Size(row.box[3], row.box[4], row.height),
        group=f"{space}/{what}",
        function=function,
        fixed=True,
        footprint=row.local,
    )


def kept_values(piece: Piece) -> dict[str, Any]:
    """What every brief keeps of a building that stays."""
    return {
        "id": piece.id,
        "model": piece.asset,
        "at": piece.pose[:2],
        "heading": piece.pose.heading,
        "size": (*piece.size,),
        "footprint": list(piece.footprint) or None,
    }


def lock_brief(solution: Solution, lockable: Lockable) -> Brief:
    """The brief to solve again: locked buildings are ``fixed`` in their part and count for what is
    asked; all others are free."""
    areas = getattr(solution.brief.part, lockable.key)
    names = assign_ids(areas, lockable.word, lockable.key)
    updated = lock_areas(solution, areas, names, *lockable[2:])
    return with_areas(solution.brief, lockable.key, updated)


def lock_and_count(solution: Solution, lockable: Lockable) -> Brief:
    """That brief, asking for as many buildings in each part as the solution has there."""
    brief = lock_brief(solution, lockable)
    areas = getattr(brief.part, lockable.key)
    names = assign_ids(areas, lockable.word, lockable.key)
    return with_areas(brief, lockable.key, count_buildings(solution, areas, names))


def with_areas(brief: Brief, key: str, areas: Sequence[Any]) -> Brief:
    """A brief with other parts."""
    part = brief.part.model_copy(update={key: [*areas]})
    return brief.model_copy(update={"part": part})


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
