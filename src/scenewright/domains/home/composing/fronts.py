"""What stands before the doors of wardrobes."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, hypot, sin

from scenewright.core.scene import Piece
from scenewright.domains.home.attempt import FurnishedGroup
from scenewright.domains.home.measures import ON_FLOOR
from scenewright.domains.home.rules.classes import MOVED
from scenewright.geometry.boxes import common_area, make_frame

OPENED = 0.45  # floor that a door of a wardrobe is opened over, metres
SEEN = 0.05  # share of the doors that is not noticed


def cost_of_fronts(
    groups: Sequence[FurnishedGroup], cost: float, fixed: Sequence[Piece] = ()
) -> float:
    """What is wrong with wardrobes, built in or not, whose doors something stands before: Σ over
    them of half the cost for being so and half by the share of the floor before their doors that
    is taken; ``fixed`` pieces stand already."""
    pieces = [p for p in (*fixed, *(q for g in groups for q in g.pieces)) if p.pose.z < ON_FLOOR]
    shares = (measure_share(p, pieces) for p in pieces if p.category == "wardrobe")
    return sum(cost * (1.0 + min(share, 1.0)) / 2 for share in shares if share > SEEN)


def measure_share(wardrobe: Piece, pieces: Sequence[Piece]) -> float:
    """The share of the floor before a wardrobe's doors on which other pieces stand.

    >>> from scenewright.core.scene import Pose, Size
    >>> one = Piece("w", "wardrobe", "", "a", Pose(0, 0, 0, 0), Size(2.0, 0.6, 2.0))
    >>> bed = Piece("b", "single_bed", "", "a", Pose(1.3, 0.5, 0, 0), Size(1.0, 2.0, 0.5))
    >>> round(measure_share(one, [one, bed]), 2)
    0.5
    """
    (x, y, _, heading), (width, depth, _) = wardrobe.pose, wardrobe.size
    ahead = (depth + OPENED) / 2
    x, y = x + ahead * cos(heading), y + ahead * sin(heading)
    reach = hypot(width, OPENED) / 2
    front = make_frame(x, y, heading, width, OPENED)
    taken = 0.0
    for other in pieces:
        far = hypot(other.pose.x - x, other.pose.y - y)
        if far > reach + hypot(*other.size[:2]) / 2 or other.category in MOVED:
            continue
        if other is not wardrobe:
            box = (other.pose.x, other.pose.y, other.pose.heading, *other.size[:2])
            taken += float(common_area(make_frame(*box), front))
    return taken / (width * OPENED)
