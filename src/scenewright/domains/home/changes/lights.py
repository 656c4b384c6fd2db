"""Lamps and curtains after a change: those stay that what was changed has nothing to do with."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.changes.edits import LIGHT
from scenewright.domains.home.tasks import grow_pieces, list_extras


def completed_as_before(
    task: RoomTask, placed: tuple[Piece, ...], before: Sequence[Piece]
) -> list[Piece]:
    """What is placed with its lamps, curtains and pictures; ``before`` is all that was in the room.

    A lamp or curtain that the furniture as it was and the furniture as it is bring alike stays as
    it hung, and where it had been taken away it does not come back.
    """
    known = {p.id: p for p in before}
    larger = {p.id: p for p in grow_pieces(task, placed)}
    standing = [
        p if _is_as_large(p, known) else larger[p.id]
        for p in placed
        if p.id in larger or _is_as_large(p, known)
    ]
    furniture = [p for p in before if p.function != LIGHT or p.fixed]
    usual = {p.id: p for p in list_extras(task, furniture)}
    after = {p.id: p for p in list_extras(task, standing)}
    hung = {i: p for i, p in known.items() if p.function == LIGHT}
    found = [
        hung.get(i, p) if usual.get(i) == p else p
        for i, p in after.items()
        if usual.get(i) != p or i in hung
    ]
    there = {p.id for p in placed} | usual.keys() | after.keys()
    return [*standing, *found, *(p for i, p in hung.items() if i not in there)]


def _is_as_large(piece: Piece, known: Mapping[str, Piece]) -> bool:
    """Whether a piece was in the room before, as large as now."""
    return piece.id in known and known[piece.id].size == piece.size
