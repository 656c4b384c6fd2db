"""Aisles beside beds for two that nobody gets into, as something stands across their end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import hypot

from scenewright.core.piece_outlines import boxes_of
from scenewright.core.same import once
from scenewright.core.scene import Piece
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.rules.classes import MOVED
from scenewright.domains.home.walking.bed_aisles import AISLE, DOUBLE, Box, is_free, list_aisles

COST = 4.0
"""What each such aisle costs."""


def list_shut_in(
    bed: Piece, others: Sequence[tuple[str, Piece]], ground: Ground
) -> Iterator[tuple[str, float]]:
    """The group that stands across the end of an otherwise free aisle of a bed, the
    floor beyond its foot within the room, and what that costs; ``others`` with their groups."""
    aisles = _list_within(bed, ground) if bed.category == DOUBLE else ()
    if not aisles:
        return
    near = [(name, p) for name, p in others if p is not bed and _is_near(bed, p)]
    boxes = [box for _, p in near for box in boxes_of(p)]
    for beside, along in aisles:
        if not is_free(along, boxes, ground.edges) and is_free(beside, boxes, ground.edges):
            across = (n for n, p in near if not is_free(along, boxes_of(p), ground.edges))
            yield from ((name, COST) for name in list(across)[:1])


@once(256)
def _list_within(bed: Piece, ground: Ground) -> tuple[tuple[Box, Box], ...]:
    """The aisles of a bed, each to its foot and beyond, that lie on the floor of the room."""
    pairs = zip(list_aisles(bed, further=0.0), list_aisles(bed), strict=True)
    return tuple(pair for pair in pairs if is_free(pair[1], (), ground.edges))


def _is_near(bed: Piece, other: Piece) -> bool:
    """Whether what is not pushed aside may reach into an aisle of a bed."""
    far = hypot(other.pose.x - bed.pose.x, other.pose.y - bed.pose.y)
    reach = hypot(*bed.size[:2]) / 2 + hypot(*other.size[:2]) / 2 + 2 * AISLE
    return other.category not in MOVED and far < reach
