"""Aisles beside beds for two that nobody gets into, as something stands across their end."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from scenewright.core.piece_outlines import boxes_of
from scenewright.core.scene import Piece
from scenewright.domains.home.bed_aisles import DOUBLE, is_free, list_aisles
from scenewright.domains.home.composing.fronts import MOVED
from scenewright.domains.home.problem import Ground

COST = 4.0
"""What each such aisle costs."""


def list_shut_in(
    bed: Piece, others: Sequence[tuple[str, Piece]], ground: Ground
) -> Iterator[tuple[str, float]]:
    """The group of what stands across the end of an aisle of a bed that is free otherwise, the
    floor beyond its foot within the room, and what that costs; ``others`` with their groups."""
    if bed.category != DOUBLE:
        return
    solid = [(n, p) for n, p in others if p is not bed and p.category not in MOVED]
    boxes = [box for _, p in solid for box in boxes_of(p)]
    for beside, along in zip(list_aisles(bed, further=0.0), list_aisles(bed), strict=True):
        if not is_free(along, (), ground.edges) or not is_free(beside, boxes, ground.edges):
            continue
        across = [n for n, p in solid if not is_free(along, boxes_of(p), ground.edges)]
        if across:
            yield across[0], COST
