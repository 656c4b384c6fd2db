"""The screen on the axis of the main seat, once the pieces in the patches are known."""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, pi, remainder, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.problem import Ground
from scenewright.geometry.fit import stands

Floats = NDArray[np.float64]

SEATS = ("corner_sofa", "sofa", "loveseat", "double_bed")
FACING = 0.2  # seats and screens that look at each other so nearly are put on one axis, radians
OFF = 0.6  # by how much at most one of them is moved, metres
ENOUGH = 0.02
SHARES = (1.0, 0.75, 0.5, 0.25)  # of the way that are tried


def _aside(case: Group) -> float | None:
    """How far the main seat of a group stands to the right of its middle, metres; None if it has
    none that looks ahead."""
    main = next((m for m in case.members if m.category in SEATS), None)
    return main.x if main and abs(remainder(main.heading, 2 * pi)) < FACING else None


def face_screen(
    cases: Sequence[Group], boxes: Floats, new: NDArray[np.bool_], ground: Ground
) -> Floats:
    """Boxes ``(n, 5)`` with the screen moved along its wall, or else the seat, until its middle is
    straight before the seat; as they are where neither would stand free.

    A group with a table on one side has its seat aside of its middle, and only the middle of
    patches is known while they are laid out."""
    names = [case.function for case in cases]
    seat = next((names.index(name) for name in ("seating", "sleeping") if name in names), None)
    screen = names.index("media") if "media" in names else None
    if seat is None or screen is None:
        return boxes
    off = _off(cases[seat], boxes[seat], boxes[screen])
    if not ENOUGH < abs(off) <= OFF:
        return boxes
    zones = np.concatenate([ground.keep_free, ground.obstacles, ground.fronts])
    heading = boxes[seat, 2]
    side = np.array([sin(heading), -cos(heading)])
    for share in SHARES:
        for number, sign in ((screen, -1.0), (seat, 1.0)):
            moved = boxes.copy()
            moved[number, :2] += sign * share * off * side
            if new[number] and stands(moved, number, ground.edges, zones):
                return moved
    return boxes


def _off(case: Group, seat: Floats, screen: Floats) -> float:
    """How far to the right of the main seat's axis the screen is, metres; 0 if they do not look at
    each other."""
    right = _aside(case)
    if right is None or abs(remainder(screen[2] - seat[2] - pi, 2 * pi)) > FACING:
        return 0.0
    dx, dy = screen[0] - seat[0], screen[1] - seat[1]
    ahead = dx * cos(seat[2]) + dy * sin(seat[2])
    return float(dx * sin(seat[2]) - dy * cos(seat[2]) - right) if ahead > 0 else 0.0
