"""What closes the way to a side of a bed: a shelf before its nightstand, a chest at its foot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, hypot, sin

from scenewright.core.scene import Piece
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.composing.bed_places import SINGLE
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.problem import Ground
from scenewright.domains.home.rules.classes import MOVED
from scenewright.domains.home.walking.bed_aisles import DOUBLE, Box, list_aisles
from scenewright.geometry.boxes import area_in_polygon, common_area, make_frame

WAY, BEYOND = 0.4, 0.4
"""Width of the way beside a bed that nothing else stands in, and by how much it goes on beyond the
foot, metres."""
SPOT, PILLOW = 0.34, 0.4
"""Room for a nightstand, metres, and how much it counts that there is none."""
WAY_UNSEEN = 0.03  # share of the way that is not noticed


def cost_of_bed_ways(groups: Sequence[FurnishedGroup], ground: Ground, cost: float) -> float:
    """What is wrong with beds to whose sides something closes the way: of each side of a bed for
    two with a nightstand half the cost for being so and half by the share of the way that is taken,
    of the pillow of a bed for one without :data:`PILLOW` of that."""
    closed = _list_closed(groups, ground)
    return sum(cost * worth * (1.0 + min(share, 1.0)) / 2 for _, share, worth in closed)


def list_closing(groups: Sequence[FurnishedGroup], ground: Ground) -> frozenset[str]:
    """The names of the groups that stand in such a way, and of its bed."""
    return frozenset(name for names, _, _ in _list_closed(groups, ground) for name in names)


def _list_closed(
    groups: Sequence[FurnishedGroup], ground: Ground
) -> Iterator[tuple[set[str], float, float]]:
    """Of each side of a bed to which the way is closed the bed's group and those that close it, by
    name, the share of the way that they take, and how much that counts."""
    for group in groups:
        for bed in group.pieces:
            if bed.category == DOUBLE:
                ways = zip((-1.0, 1.0), list_aisles(bed, WAY, BEYOND), strict=True)
                used = [way for side, way in ways if _has_stand(group, bed, side)]
                taken = [_find_taken(way, group, groups) for way in used]
                yield from ((names, share, 1.0) for names, share in taken if share > WAY_UNSEEN)
            elif bed.category == SINGLE and len(group.pieces) == 1:
                spots = [spot for spot in list_spots(bed) if _is_floor(spot, ground)]
                taken = [_find_taken(spot, group, groups) for spot in spots]
                if taken and all(share > WAY_UNSEEN for _, share in taken):
                    yield *min(taken, key=lambda each: each[1]), PILLOW


def list_spots(bed: Piece) -> Iterator[Box]:
    """The boxes on either side of a bed's pillow where a narrow nightstand stands."""
    (x, y, _, turn), (wide, long, _) = bed.pose, bed.size
    c, s, ahead = cos(turn), sin(turn), (SPOT - long) / 2
    for aside in (-(wide + SPOT) / 2, (wide + SPOT) / 2):
        yield x + ahead * c + aside * s, y + ahead * s - aside * c, turn, SPOT, SPOT


def _is_floor(spot: Box, ground: Ground) -> bool:
    """Whether a box is on the floor of the room as a whole."""
    free = float(area_in_polygon(make_frame(*spot), ground.edges))
    return free > (1.0 - WAY_UNSEEN) * spot[3] * spot[4]


def _has_stand(group: FurnishedGroup, bed: Piece, side: float) -> bool:
    return any(_stands_beside(p, bed, side) for p in group.pieces)


def _stands_beside(stand: Piece, bed: Piece, side: float) -> bool:
    """Whether a piece is a nightstand on the right (``side`` 1) or the left (-1) of a bed."""
    (x, y, _, turn), (u, v, _, _) = bed.pose, stand.pose
    right = (u - x) * sin(turn) - (v - y) * cos(turn)
    return stand.category == "nightstand" and right * side > 0.0


def _find_taken(
    way: Box, own: FurnishedGroup, groups: Sequence[FurnishedGroup]
) -> tuple[set[str], float]:
    """The names of a bed's ``own`` group and of those that stand in a way, and the share of the way
    that they take."""
    (x, y, _, width, depth), names, taken = way, {own.name}, 0.0
    frame, reach = make_frame(*way), hypot(width, depth) / 2
    for group in groups:
        for p in group.pieces if group is not own else ():
            (u, v, z, turn), (wide, deep, _) = p.pose, p.size
            near = hypot(u - x, v - y) < reach + hypot(wide, deep) / 2
            if near and z < ON_FLOOR and p.category not in MOVED:
                area = float(common_area(frame, make_frame(u, v, turn, wide, deep)))
                taken += area
                names |= {group.name} if area > 0.0 else set()
    return names, taken / (width * depth)
