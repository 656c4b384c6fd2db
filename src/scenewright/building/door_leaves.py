"""The leaves of a door that turn: one, or two where it is wide."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

from scenewright.core.space import Opening

TWO = 1.3
"""Width in metres from which on a door that turns has two leaves."""


class DoorLeaf(NamedTuple):
    """One leaf as the ``opening`` it closes, and how far the middle of that lies along the whole
    one from its middle, in metres."""

    opening: Opening
    along: float


def leaves_of(opening: Opening) -> tuple[DoorLeaf, ...]:
    """The leaves of a door that turns, hinged at its ends.

    >>> door = Opening("d", "door", "0", 4.0, 0, 1, 0, 1.8, 0.12, 0.0, 2.05, hinge=1, swing=1)
    >>> [(leaf.opening.x, leaf.opening.width, leaf.opening.hinge) for leaf in leaves_of(door)]
    [(3.55, 0.9, -1), (4.45, 0.9, 1)]
    """
    if opening.width < TWO:
        return (DoorLeaf(opening, 0.0),)
    found = []
    for side in (-1, 1):
        along = 0.25 * side * opening.width
        x, y = opening.x + along * opening.ux, opening.y + along * opening.uy
        half = replace(opening, x=x, y=y, width=0.5 * opening.width, hinge=side)
        found.append(DoorLeaf(half, along))
    return tuple(found)
