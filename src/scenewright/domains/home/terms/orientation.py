"""Terms of orientation: backs to walls, fronts to the main wall, free items square to the room."""

from __future__ import annotations

import math

from scenewright.geometry.boxes import Floats, Frame, distance_to_segment, nearest_segment, wrap
from scenewright.geometry.compiled import compiled, inlined

FLUSH = 0.02
NEAR = 0.1


@compiled
def inward(wall: Floats) -> float:
    """Direction of the inward normal of a wall x0, y0, x1, y1 whose inside is on the left.

    ``wall`` (4,); radians.
    """
    return math.atan2(wall[2] - wall[0], wall[1] - wall[3])


@inlined
def main_wall_turn(heading: float, role: float, normal: float) -> float:
    """r (θ - (r + 1) π / 2), θ in [0, 2π) from the main wall's inward normal, radians.

    The paper's C4 is the absolute value of the sum of these: errors of opposite sign cancel and
    no angle is wrapped (Liu et al. 2017, as printed).
    """
    turned = heading - normal
    turned -= 2.0 * math.pi * math.floor(turned / (2.0 * math.pi))
    return role * (turned - (role + 1.0) * 0.5 * math.pi)


@compiled
def main_wall(heading: float, role: float, normal: float) -> float:
    """|wrap(θ - (r + 1) π / 2)|: radians off facing (r = +1) or backing (r = -1) the main wall.

    Repaired form of Liu et al. 2017, C4; range [0, π].

    >>> main_wall(1.0, -1.0, 1.0), round(main_wall(1.0, 1.0, 1.0), 6)
    (0.0, 3.141593)
    """
    return abs(wrap(heading - normal - (role + 1.0) * 0.5 * math.pi))


@inlined
def gap(distance: float, allowed: float) -> float:
    """0 up to the allowed distance, then 1 - (allowed / distance)²; range [0, 1)."""
    return 0.0 if distance <= allowed else 1.0 - (allowed / distance) ** 2


@compiled
def against_wall_printed(frame: Frame, walls: Floats) -> float:
    """Gap between the middle of the back edge and the nearest wall, 0.1 m allowed.

    Liu et al. 2017, C5 as printed. A box turned by any angle can satisfy it. ``walls`` (w, 4)
    x0, y0, x1, y1 in metres; a share in [0, 1].
    """
    x, y = frame[0] - frame[2] * frame[5], frame[1] - frame[3] * frame[5]
    return gap(nearest_segment(x, y, walls)[1], NEAR)


@compiled
def against_wall(frame: Frame, walls: Floats, allowed: float = FLUSH) -> float:
    """Gap between the worse back corner and the same wall, ``allowed`` metres free: the back lies
    flush.

    Repaired form of Liu et al. 2017, C5. ``walls`` (w, 4) x0, y0, x1, y1 in metres; a share in
    [0, 1].
    """
    x, y = frame[0] - frame[2] * frame[5], frame[1] - frame[3] * frame[5]
    u, v = frame[3] * frame[4], -frame[2] * frame[4]
    least = math.inf
    for k in range(walls.shape[0]):
        x0, y0, x1, y1 = walls[k, 0], walls[k, 1], walls[k, 2], walls[k, 3]
        right = distance_to_segment(x + u, y + v, x0, y0, x1, y1)
        if right < least:
            least = min(least, max(right, distance_to_segment(x - u, y - v, x0, y0, x1, y1)))
    return gap(least, allowed)


@inlined
def alignment(frame: Frame, walls: Floats) -> float:
    """Angle between a free item and its nearest wall modulo a quarter turn, as a share of 45°.

    ``walls`` (w, 4) x0, y0, x1, y1 in metres.
    """
    k = nearest_segment(frame[0], frame[1], walls)[0]
    if k < 0:
        return 0.0
    turned = (frame[7] - inward(walls[k])) / (0.5 * math.pi)
    return 2.0 * abs(turned - math.floor(turned + 0.5))
