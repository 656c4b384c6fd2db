"""What sofas look at close by: floor that is theirs, or the foot of a bed, a fridge, a wall."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, hypot, sin

from scenewright.catalog.classes import SOFAS
from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.problem import Ground
from scenewright.geometry.boxes import Frame, area_in_polygon, common_area, make_frame

AHEAD, WIDE = 1.2, 0.8
"""The floor before the middle of a sofa that it looks over, metres: a low table and those who pass
have room there (Panero, Zelnik 1979)."""
FEET, ARM = 0.45, 0.2  # who sits has feet so far before the seats, beside the arms, metres
SEAT = 0.95  # how deep the seats of a sofa are, the long one of a corner sofa apart, metres
SEEN, FELT = 0.12, 0.05  # shares of that and of the floor for feet that are not noticed
ASIDE = frozenset(("seating", "reading", "media", "plant"))
"""Groups that belong there."""


def cost_of_outlook(
    groups: Sequence[FurnishedGroup], ground: Ground, cost: float, fixed: Sequence[Piece] = ()
) -> float:
    """What is wrong with sofas that look at something too near: Σ over them of half the cost for
    being so and half by the share of the floor before them that walls and others take."""
    sofas = [p for g in groups for p in g.pieces if p.category in SOFAS]
    if not sofas:
        return 0.0
    others = [p for g in groups if g.wish.group not in ASIDE for p in g.pieces]
    low = [p for p in (*fixed, *others) if p.pose.z < ON_FLOOR and p.category != "rug"]
    floors = ((_look_over(sofa), _put_feet(sofa)) for sofa in sofas)
    shares = ([measure_filled(floor, low, ground) for floor in each] for each in floors)
    return sum(
        cost * (1.0 + min(max(ahead, feet), 1.0)) / 2
        for ahead, feet in shares
        if ahead > SEEN or feet > FELT
    )


def measure_filled(floor: Frame, pieces: Sequence[Piece], ground: Ground) -> float:
    """The share of some floor that is beyond the walls or that pieces stand on."""
    whole = 4 * floor[4] * floor[5]
    taken = whole - float(area_in_polygon(floor, ground.edges))
    for (x, y, _, heading), (width, depth, _) in ((p.pose, p.size) for p in pieces):
        if hypot(x - floor[0], y - floor[1]) < floor[6] + hypot(width, depth) / 2:
            taken += float(common_area(make_frame(x, y, heading, width, depth), floor))
    return taken / whole


def _look_over(sofa: Piece) -> Frame:
    """The floor before the middle of a sofa."""
    return _ahead_of(sofa, min(sofa.size.depth, SEAT), WIDE, AHEAD)


def _put_feet(sofa: Piece) -> Frame:
    """The floor right before all of its seats but the ends."""
    return _ahead_of(sofa, sofa.size.depth, sofa.size.width - 2 * ARM, FEET)


def _ahead_of(sofa: Piece, start: float, wide: float, deep: float) -> Frame:
    """A box before a sofa, so far from its back."""
    (x, y, _, turn), ahead = sofa.pose, start - sofa.size.depth / 2 + deep / 2
    return make_frame(x + ahead * cos(turn), y + ahead * sin(turn), turn, wide, deep)
