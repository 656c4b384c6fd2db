"""How a kind of scene is changed by hand: one value a domain (its verb ``editing``)."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

from scenewright.arranging.give_way import Ways
from scenewright.core.piece_edits import Edited
from scenewright.core.scene import Piece, Pose
from scenewright.core.solution import Solution

Find = Callable[[Sequence[Piece], str], Sequence[Piece]]


class HandRules(NamedTuple):
    """What of a solution can be changed by hand, and what follows from it.

    ``find`` answers the pieces that a name means, the first leading; ``make`` a new piece of a
    model, by its id or name or by that of something that stands there, in the space with an id;
    ``ways`` where pieces may stand and what gives way; ``settle`` the solution after some pieces
    were changed, with all that follows from them; ``owed`` the words by which something is left out
    that answers what the brief asks for. All raise InputError for what cannot be.
    """

    find: Find
    make: Callable[[str, str, Pose], Piece]
    ways: Ways
    settle: Callable[[Edited], Solution]
    owed: Callable[[Piece], str]
