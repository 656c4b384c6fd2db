"""What a change by hand led to: every piece that moved, came or went, with the reason."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple

from scenewright.core.edits import Change
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.home.changes.edits import LIGHT, EditedHome

AROUND = "the room was arranged around what was moved by hand"
ASKED = "the room was furnished again as requested"
HANGS = "lamps, curtains and pictures follow the furniture"
MOVED, NEW, GONE = "moved", "new", "gone"


def changes_of(
    before: Solution,
    after: Solution,
    edited: EditedHome,
    again: Collection[str],
    reasons: Mapping[str, str],
) -> tuple[Change, ...]:
    """Every change between two solutions; ``reasons`` are known by the id of a piece or group,
    ``again`` are the ids of rooms furnished anew."""
    why = _Why(edited, again, reasons, after)
    return tuple(_changes(before, after, edited, why))


class _Why(NamedTuple):
    edited: EditedHome
    again: Collection[str]
    reasons: Mapping[str, str]
    after: Solution

    def reason_of(self, piece: Piece) -> str:
        """Why a piece is not as it was, by its present id or, if it is gone, its former one."""
        if piece.id in self.edited.moved:
            main = self.edited.named[piece.id]
            return "moved by hand" if main == piece.id else f"goes with {main}"
        present = {former: now for now, former in self.edited.moved.items()}.get(piece.id, piece.id)
        known = [self.reasons[key] for key in (present, piece.group) if self.reasons.get(key)]
        if known:
            return known[0]
        if piece.function == LIGHT:
            return HANGS
        for out in self.after.left_out:
            if out.space == piece.space and out.what in (piece.function, piece.category):
                return out.reason
        return ASKED if piece.space in self.again else AROUND


def _changes(before: Solution, after: Solution, edited: EditedHome, why: _Why) -> Iterator[Change]:
    old = {piece.id: piece for piece in before.pieces}
    stayed = set()
    carried = set(edited.moved.values())
    for piece in after.pieces:
        former = edited.moved.get(piece.id, piece.id)
        was = old.get(former)
        other = piece.id not in edited.moved and former in carried  # another now has its id
        if was is None or other:
            yield Change(piece.id, "", NEW, piece.space, why.reason_of(piece))
            continue
        stayed.add(former)
        if (was.pose, was.size, was.space) != (piece.pose, piece.size, piece.space):
            yield Change(piece.id, former, MOVED, piece.space, why.reason_of(piece))
    for piece in before.pieces:
        if piece.id not in stayed:
            yield Change(piece.id, piece.id, GONE, piece.space, why.reason_of(piece))
