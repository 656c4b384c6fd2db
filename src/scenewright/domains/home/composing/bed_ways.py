"""What closes the way to a side of a bed: a shelf before its nightstand, a chest at its foot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import cos, hypot, sin

from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.bed_aisles import DOUBLE, list_aisles
from scenewright.domains.home.composing.fronts import MOVED, ON_FLOOR
from scenewright.geometry.boxes import common_area, make_frame

WAY, BEYOND = 0.4, 0.4
"""Width of the way beside a bed that nothing else stands in, and by how much it goes on beyond the
foot, metres."""
SEEN = 0.03  # share of the way that is not noticed


def cost_of_bed_ways(groups: Sequence[FurnishedGroup], cost: float) -> float:
    """What is wrong with beds for two to whose sides something closes the way: of each side with a
    nightstand half the cost for being so and half by the share of the way that is taken."""
    return sum(cost * (1.0 + min(share, 1.0)) / 2 for _, share in _list_closed(groups))


def list_closing(groups: Sequence[FurnishedGroup]) -> frozenset[str]:
    """The names of the groups that stand in such a way, and of its bed."""
    return frozenset(name for names, _ in _list_closed(groups) for name in names)


def _list_closed(groups: Sequence[FurnishedGroup]) -> Iterator[tuple[set[str], float]]:
    """Of each side of a bed to which the way is closed the bed's group and those that close it, by
    name, and the share of the way that they take."""
    for group in groups:
        for bed in group.pieces:
            if bed.category == DOUBLE:
                for side, way in zip((-1.0, 1.0), list_aisles(bed, WAY, BEYOND), strict=True):
                    if any(_stands_beside(p, bed, side) for p in group.pieces):
                        taken = _find_taken(way, group, groups)
                        share = sum(taken.values()) / (way[3] * way[4])
                        if share > SEEN:
                            yield {group.name, *taken}, share


def _stands_beside(stand: Piece, bed: Piece, side: float) -> bool:
    """Whether a piece is a nightstand on the right (``side`` 1) or the left (-1) of a bed."""
    (x, y, _, turn), (u, v, _, _) = bed.pose, stand.pose
    right = (u - x) * sin(turn) - (v - y) * cos(turn)
    return stand.category == "nightstand" and right * side > 0.0


def _find_taken(
    way: tuple[float, ...], own: FurnishedGroup, groups: Sequence[FurnishedGroup]
) -> dict[str, float]:
    """Square metres of a way that each group but its ``own`` takes, of those that take some."""
    (x, y, _, width, depth), found = way, dict[str, float]()
    frame, reach = make_frame(*way), hypot(width, depth) / 2
    for group in groups:
        for p in group.pieces if group is not own else ():
            (u, v, z, turn), (wide, deep, _) = p.pose, p.size
            near = hypot(u - x, v - y) < reach + hypot(wide, deep) / 2
            if near and z < ON_FLOOR and p.category not in MOVED:
                area = float(common_area(frame, make_frame(u, v, turn, wide, deep)))
                if area > 0.0:
                    found[group.name] = found.get(group.name, 0.0) + area
    return found
