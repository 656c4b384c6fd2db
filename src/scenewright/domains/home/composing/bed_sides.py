"""Beds for two that one gets into from one side only, as they stand."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, hypot, sin

from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.rules.classes import MOVED
from scenewright.domains.home.walking.bed_aisles import DOUBLE, Box
from scenewright.geometry.boxes import area_in_polygon, common_area, make_frame

OFF_BED, GOT_IN_FROM = 0.01, 0.45
"""From where to where, off a bed, the floor lies from which one gets in, metres."""
FREE = 0.91  # share of that floor, from the middle of the bed to its foot, that is free


def count_closed_beds(groups: Sequence[FurnishedGroup], ground: Ground) -> int:
    """The beds for two with less than :data:`FREE` of the floor beside a long side free, from the
    middle to the foot."""
    pieces = [p for g in groups for p in g.pieces if p.pose.z < ON_FLOOR]
    solid = [p for p in pieces if p.category not in MOVED]
    beds = [p for p in pieces if p.category == DOUBLE]
    return sum(_is_closed(bed, [p for p in solid if p is not bed], ground) for bed in beds)


def _is_closed(bed: Piece, others: Sequence[Piece], ground: Ground) -> bool:
    return any(_measure_free(side, others, ground) < FREE for side in _list_sides(bed))


def _list_sides(bed: Piece) -> Iterator[Box]:
    """The boxes beside the left and the right of a bed, from its middle to its foot."""
    (x, y, _, turn), (wide, long, _) = bed.pose, bed.size
    c, s, ahead = cos(turn), sin(turn), long / 4
    for side in (-1.0, 1.0):
        aside = side * (wide + OFF_BED + GOT_IN_FROM) / 2
        at = x + ahead * c + aside * s, y + ahead * s - aside * c
        yield *at, turn, GOT_IN_FROM - OFF_BED, long / 2


def _measure_free(side: Box, others: Sequence[Piece], ground: Ground) -> float:
    """The share of a box (5,) that is floor on which no other piece stands."""
    frame, (x, y, _, wide, long) = make_frame(*side), side
    free = float(area_in_polygon(frame, ground.edges))
    for p in others:
        (u, v, _, turn), (width, depth, _) = p.pose, p.size
        if hypot(u - x, v - y) < hypot(wide, long) / 2 + hypot(width, depth) / 2:
            free -= float(common_area(frame, make_frame(u, v, turn, width, depth)))
    return free / (wide * long)
