"""Seats and the screen that they should look at."""

from __future__ import annotations

from collections.abc import Sequence
from math import atan2, cos, hypot, pi, radians, remainder, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.classes import SOFAS
from scenewright.core.scene import Piece, Pose
from scenewright.domains.home.attempts.attempt import FurnishedGroup
from scenewright.domains.home.groups.classes import SITTING
from scenewright.domains.home.measures import RAISED
from scenewright.domains.home.settings import CompositionCosts
from scenewright.geometry.boxes import Frame, area_in_polygon, common_area, make_frame

Floats = NDArray[np.float64]

ASIDE, AWAY = radians(35.0), radians(90.0)
"""Angles off the axis of a sofa up to which a screen is seen well, and from which not at all: the
head turns 30 to 45 degrees with ease (Panero, Zelnik 1979)."""

ON_AXIS, OFF_AXIS = 0.15, 1.2
"""Metres from the axis of a sofa up to which a screen is on it, and from which it is off it."""

ASTRAY = 0.3
"""Metres off the axis of a sofa from which on an eye finds a screen off it."""

WATCHED_FROM, WATCHED_TO, OFF_COUNTED = 1.5, 4.0, 2.0
"""Nearer to a screen, and farther from it, nobody sits with comfort, metres; by how many metres at
most that counts."""

KNEES = 10.0
"""How many times as much each metre less than that counts as one more."""

SIGHT, FILLED = 0.8, 0.6
"""Width of the sight from a sofa to a screen, metres, and the square metres that fill it."""

HIDDEN = 0.3
"""Square metres of furniture in the line of sight that hide a screen."""


SEEN_OVER, EYES = frozenset(("kitchen", "kitchenette", "counter", "fridge")), 1.1
"""Groups one looks over: of a kitchen only what is higher than the eyes of who sits hides a screen,
in metres, as a fridge round a corner of the run."""

COLUMN = 4.0
"""Factor by which a column or wall hides more than its floor area says, as nobody looks over
it."""
MIDST, BETTER_SIGHT, BEFORE_SCREEN = 0.5, 0.9, 0.4
"""Width of the sight without which a screen is hidden by walls, that which is better free of them,
and by how much both end before the screen, whose own wall hides nothing, metres."""

BEFORE, CLOSE = 0.5, 3.0
"""Metres before a screen within which furniture hides more of it than elsewhere in the sight, and
by what factor more."""

LYING = radians(60.0)
"""Angle off the axis of a bed or an armchair up to which a screen is seen from it."""

RESTING = ("armchair", "double_bed", "single_bed", "bunk_bed")
"""What else one watches a screen from."""


def cost_of_view(
    groups: Sequence[FurnishedGroup], costs: CompositionCosts, edges: Floats | None = None
) -> float:
    """What is wrong with a sofa and the screen before it: not looking at one another (half for
    being so and half by its degree), off each other's axis, too near or too far, and what of other
    groups, of walls and of columns (``edges`` of the room) is between them; 0 where there is no
    screen or no sofa."""
    screen, sofas = _find_pair(groups)
    if screen is None or not sofas:
        return 0.0
    off = min(measure_turn(sofa.pose, screen.pose) for sofa in sofas)
    degree = min((off - ASIDE) / (AWAY - ASIDE), 1.0)
    if degree == 1.0:  # it sees nothing, wherever the screen is
        return costs.view + costs.axis + costs.between + OFF_COUNTED * costs.distance
    turned = costs.view * (1.0 + degree) / 2 if degree > 0.0 else 0.0
    away = _measure_distance(sofas[0].pose, screen.pose)
    aside = measure_aside(sofas[0].pose, screen.pose)
    beside = min(max(aside - ON_AXIS, 0.0) / (OFF_AXIS - ON_AXIS), 1.0)
    far, near = min(max(away - WATCHED_TO, 0.0), OFF_COUNTED), max(WATCHED_FROM - away, 0.0)
    reach = far + KNEES * near
    between = min(_measure_hidden(sofas[0], screen, groups, edges, BETTER_SIGHT) / FILLED, 1.0)
    return turned + costs.axis * beside + costs.distance * reach + costs.between * between


def is_unseen(groups: Sequence[FurnishedGroup], edges: Floats | None = None) -> bool:
    """Whether there is a screen that no sofa of the room looks at, or only past a table, a column
    or a wall, those within the ``edges`` of the room; without a sofa, whether there is nothing else
    to watch it from."""
    screen, sofas = _find_pair(groups)
    if screen is None:
        return False
    if not sofas:
        resting = (p for g in groups for p in g.pieces if p.category in RESTING)
        return not any(measure_turn(p.pose, screen.pose) <= LYING for p in resting)
    behind = _measure_hidden(sofas[0], screen, groups, edges, MIDST) > HIDDEN
    return behind or min(measure_turn(sofa.pose, screen.pose) for sofa in sofas) > ASIDE


def is_off_axis(groups: Sequence[FurnishedGroup]) -> bool:
    """Whether the main sofa of a room has a screen that is off its axis, or turned from it."""
    screen, sofas = _find_pair(groups)
    if screen is None or not sofas:
        return False
    return measure_aside(sofas[0].pose, screen.pose) > ASTRAY or not _do_face(sofas[0], screen)


def _do_face(seat: Piece, screen: Piece) -> bool:
    return measure_turn(seat.pose, screen.pose) <= ASIDE


def measure_aside(one: Pose, other: Pose) -> float:
    """Metres by which something is off the axis of a seat."""
    (x, y, _, turn) = one
    return abs((other.x - x) * sin(turn) - (other.y - y) * cos(turn))


def list_between(groups: Sequence[FurnishedGroup]) -> frozenset[str]:
    """The names of the groups that stand between the main sofa and its screen."""
    screen, sofas = _find_pair(groups)
    return frozenset(_fill_sight(sofas[0], screen, groups)) if screen and sofas else frozenset()


def _find_pair(groups: Sequence[FurnishedGroup]) -> tuple[Piece | None, list[Piece]]:
    """The screen of a room and its sofas, the largest first."""
    pieces = [p for g in groups for p in g.pieces]
    sofas = [p for p in pieces if p.category in SOFAS]
    screen = next((p for p in pieces if p.category == "tv"), None)
    return screen, sorted(sofas, key=lambda p: -p.size.width * p.size.depth)


def _measure_distance(one: Pose, other: Pose) -> float:
    return hypot(other.x - one.x, other.y - one.y)


def _measure_hidden(
    sofa: Piece, screen: Piece, groups: Sequence[FurnishedGroup], edges: Floats | None, wide: float
) -> float:
    """Square metres of the sight that others take, and walls, in a sight so ``wide``, with what
    counts for them."""
    filled = sum(_fill_sight(sofa, screen, groups).values())
    if edges is None:
        return filled
    a, b = sofa.pose, screen.pose
    turn, long = atan2(b.y - a.y, b.x - a.x), _measure_distance(a, b) - BEFORE_SCREEN
    if long <= 0.0:
        return filled
    x, y = a.x + long / 2 * cos(turn), a.y + long / 2 * sin(turn)
    sight = make_frame(x, y, turn, wide, long)
    return filled + COLUMN * (wide * long - float(area_in_polygon(sight, edges)))


def _make_sight(sofa: Piece, screen: Piece) -> Frame:
    """The floor between a sofa and a screen."""
    a, b = sofa.pose, screen.pose
    long, turn = _measure_distance(a, b), atan2(b.y - a.y, b.x - a.x)
    return make_frame((a.x + b.x) / 2, (a.y + b.y) / 2, turn, SIGHT, long)


def _make_front(screen: Piece) -> Frame:
    """The floor right before a screen."""
    (x, y, _, turn), (width, depth, _) = screen.pose, screen.size
    ahead = (depth + BEFORE) / 2
    return make_frame(x + ahead * cos(turn), y + ahead * sin(turn), turn, width, BEFORE)


def _fill_sight(sofa: Piece, screen: Piece, groups: Sequence[FurnishedGroup]) -> dict[str, float]:
    """Square metres that each other group takes of the floor between a sofa and its screen, right
    before the screen more than elsewhere, of those that take some, by name."""
    a, b = sofa.pose, screen.pose
    long, x, y = _measure_distance(a, b), (a.x + b.x) / 2, (a.y + b.y) / 2
    sight, front = _make_sight(sofa, screen), _make_front(screen)
    found, far = dict[str, float](), hypot(long, SIGHT) / 2
    for group in groups:
        if group.wish.group in SITTING:
            continue
        lowest = EYES if group.wish.group in SEEN_OVER else 0.0
        for p in group.pieces:
            (u, v, z, turn), (width, depth, height) = p.pose, p.size
            low = z < RAISED and p.category != "rug" and height > lowest
            if low and hypot(u - x, v - y) < far + hypot(width, depth) / 2:
                frame = make_frame(u, v, turn, width, depth)
                area = float(common_area(frame, sight) + CLOSE * common_area(frame, front))
                if area > 0.0:
                    found[group.name] = found.get(group.name, 0.0) + area
    return found


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
