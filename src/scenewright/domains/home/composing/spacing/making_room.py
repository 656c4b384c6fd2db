"""What is merely usual makes room for a table or a wardrobe that cannot be used where it stands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from scenewright.domains.home.attempt import Missing, RoomTask
from scenewright.domains.home.composing.judging import Placed, count_unmet
from scenewright.domains.home.composing.spacing.rules import Close

NEEDED = {"dining": "table", "dining_wall": "table", "wardrobe": "wardrobe"}
"""What something else makes room for, and what that is called."""
YIELDING = frozenset(("chest", "console", "plant", "reading", "shelf", "sideboard", "vanity"))
"""What makes room, unless it is essential or asked for."""
MUCH = 2.5
"""What it costs at least that something stands too near."""


def list_hindered(placed: Placed, close: Sequence[Close]) -> list[str]:
    """The names of the groups that something would make room for."""
    near = {name for c in close if c.cost >= MUCH for name in (c.group, c.other)}
    return [p.name for p in placed if p.name in near and p.wish.group in NEEDED]


def list_without_one(task: RoomTask, placed: Placed, name: str) -> Iterator[tuple[Placed, Missing]]:
    """The groups of a room without one that is spare, the least important first, and that it is
    missing for the sake of the group of that name."""
    unmet = count_unmet(task, placed)
    what = next(NEEDED[p.wish.group] for p in placed if p.name == name)
    for group in sorted(placed, key=lambda p: -p.wish.rank):
        wish = group.wish
        if wish.group in YIELDING and wish.rank > 0 and not wish.required:
            rest = tuple(p for p in placed if p is not group)
            if count_unmet(task, rest) <= unmet:
                yield rest, Missing(wish, f"it makes room for the {what}")
