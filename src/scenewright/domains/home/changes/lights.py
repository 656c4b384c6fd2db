"""Lamps and curtains after a change: those stay that what was changed has nothing to do with."""

from __future__ import annotations

from collections.abc import Sequence

from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import RoomTask
from scenewright.domains.home.changes.edits import LIGHT
from scenewright.domains.home.tasks import add_lamps_and_curtains


def completed_as_before(
    task: RoomTask, placed: tuple[Piece, ...], before: Sequence[Piece]
) -> list[Piece]:
    """What is placed with its lamps, curtains and pictures; ``before`` is all that was in the room.

    A lamp or curtain that the furniture as it was and the furniture as it is bring alike stays as
    it hung, and where it had been taken away it does not come back.
    """
    whole = add_lamps_and_curtains(task, placed)
    grown, after = whole[: len(placed)], whole[len(placed) :]
    furniture = tuple(p for p in before if p.function != LIGHT or p.fixed)
    usual = {p.id: p for p in add_lamps_and_curtains(task, furniture)[len(furniture) :]}
    hung = {p.id: p for p in before if p.function == LIGHT}
    there = {p.id for p in placed}
    found = []
    for piece in after:
        if usual.get(piece.id) != piece:
            found.append(piece)
        elif piece.id in hung:
            found.append(hung[piece.id])
    own = [p for i, p in hung.items() if i not in usual and i not in there | {p.id for p in after}]
    known = {p.id for p in before}
    stays = [p if p.id in known else g for p, g in zip(placed, grown, strict=True)]
    return [*stays, *found, *own]
