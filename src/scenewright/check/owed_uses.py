"""The uses a brief asks for against the models that stand."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from scenewright.catalog.assets.buildings.house_looks import FORMS, read_asset
from scenewright.check.owed import Owed
from scenewright.core.brief.uses import UseName, UseWish, use_words
from scenewright.core.scene import Piece


def list_owed_uses(
    space: str, wishes: Mapping[UseName, UseWish], pieces: Sequence[Piece]
) -> Iterator[Owed]:
    """How many buildings of each use a space is to have that states a number, by the form of
    its houses; other models are taken at the solution's word."""
    words = [read_asset(piece.asset) for piece in pieces]
    shown = [FORMS[row[0]].use if row else None for row in words]
    unknown = sum(use is None for use in shown)
    for use, wish in wishes.items():
        if wish.count is not None:
            named = (use_words(use, 1),)
            there = sum(one == use for one in shown) + unknown
            yield Owed(space, use_words(use, 2), there, wish.count, words=named)
