"""Classes of pieces that rows of homes are about, with the words for them."""

from __future__ import annotations

from scenewright.arranging.rows import (
    DOORS,
    ENTRANCES,
    OPENINGS,
    PANES,
    PIPES,
    TURNS,
    WALLS,
    WAYS,
    WINDOWS,
    Class,
)
from scenewright.domains.home.measures import ON_FLOOR

MOVED = frozenset(("rug", "office_chair", "dining_chair", "stool"))
"""What is pushed aside."""
CHAIRS = frozenset(("dining_chair", "bar_stool"))
FED = CHAIRS | {"stool"}
"""What one sits on to eat."""


def stand(words: str, *kinds: str) -> Class:
    """Pieces of some kinds that stand on the floor."""
    return Class(words, frozenset(kinds), below=ON_FLOOR)


ANYTHING = Class("something", but=MOVED, below=ON_FLOOR, hung=frozenset(("wall_shelf",)))
"""Whatever is not pushed aside; over a shelf on the wall hangs a screen."""
BY_WALLS = Class("the wall", parts=WALLS)
BY_DOORS = Class("the wall or an open door", parts=WALLS | DOORS)
AT_DOORS = Class("an open door", parts=DOORS)
AT_ENTRANCES = Class("the front door", parts=ENTRANCES)
ON_WAYS = Class("the way between doors", parts=WAYS)
AT_WINDOWS = Class("a window", parts=WINDOWS)
AT_OPENINGS = Class("a wide door", parts=OPENINGS)
BY_GLASS = Class("the light of a window", parts=PANES)
AT_PIPES = Class("the wall to a room with water", parts=PIPES)
TO_WALLS = Class("the walls", parts=TURNS)
