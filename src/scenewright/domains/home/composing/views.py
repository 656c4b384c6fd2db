"""Seats and the screen that they should look at."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, pi, radians, remainder

from scenewright.core.scene import Pose
from scenewright.domains.home.attempt import FurnishedGroup, Missing, RoomAnswer
from scenewright.domains.home.furnishing.enlarge import SOFAS

ASIDE, AWAY = radians(35.0), radians(90.0)
"""A screen is seen well up to so far off the axis of a sofa, and from so far on not at all: the
head turns 30 to 45 degrees with ease (Panero, Zelnik 1979)."""

BLIND = radians(60.0)
"""A sofa for want of a better one that is turned so far off is not placed."""


def leave_out_blind_seats(answer: RoomAnswer) -> RoomAnswer:
    """The answer without a sofa by itself, its table lost or none, that sees nothing of the screen:
    the last resort of a room that holds no seats."""
    seats = next((g for g in answer.placed if any(p.category in SOFAS for p in g.pieces)), None)
    if seats is None or len(seats.pieces) > 1:
        return answer
    screens = [p.pose for g in answer.placed for p in g.pieces if p.category == "tv"]
    if not screens or min(measure_turn(seats.pieces[0].pose, s) for s in screens) < BLIND:
        return answer
    gone = Missing(seats.wish, "the only place left for a sofa does not look at the screen")
    placed = tuple(g for g in answer.placed if g is not seats)
    return answer._replace(placed=placed, missing=(*answer.missing, gone))


def cost_of_view(groups: Sequence[FurnishedGroup], cost: float) -> float:
    """What is wrong with a sofa that does not look at the screen or that the screen is turned away
    from, half for being so and half by its degree; 0 where there is no screen or no sofa."""
    pieces = [p for g in groups for p in g.pieces]
    screen = next((p.pose for p in pieces if p.category == "tv"), None)
    sofas = [p.pose for p in pieces if p.category in SOFAS]
    if screen is None or not sofas:
        return 0.0
    off = min(measure_turn(sofa, screen) for sofa in sofas)
    degree = min((off - ASIDE) / (AWAY - ASIDE), 1.0)
    return cost * (1.0 + degree) / 2 if degree > 0.0 else 0.0


def measure_turn(one: Pose, other: Pose) -> float:
    """How far, in radians, two things are turned off each other: the larger of both angles between
    the way one looks and where the other is.

    >>> sofa = Pose(0.0, 0.0, 0.0, 0.0)
    >>> measure_turn(sofa, Pose(2.0, 0.0, 0.0, pi)), measure_turn(sofa, Pose(2.0, 0.0, 0.0, 0.0))
    (0.0, 3.141592653589793)
    """
    return max(_measure_aside(one, other), _measure_aside(other, one))


def _measure_aside(eye: Pose, mark: Pose) -> float:
    return abs(remainder(atan2(mark.y - eye.y, mark.x - eye.x) - eye.heading, 2 * pi))
