"""Tills with lanes between them: across the flow before a way out, so that people leave through
the lanes; where one comes in by the same door, beside the way in."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.arrivals import box_round, find_met
from scenewright.domains.hall.retouch.desks import WAY, WIDE
from scenewright.domains.hall.retouch.places import before, stand_at
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import LANE

MOST = 24
"""Tills of one group at most."""
NEAR, FAR, MOST_FAR = 5.0, 0.3, 4.0
"""Metres from a way out that are near enough (farther off goods stand between), what each beyond
counts, and the most they count."""
TURNED = 3.0
"""What lanes count that lead along the wall of the way out, in metres."""
STEPS = (2.0, 2.6, 3.4, 4.4)
SHIFTS = tuple(0.6 * k for k in range(-16, 17))
"""Metres ahead of a way out and aside that are tried."""


def find_tills(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of tills with lanes in rows."""
    return find_met(problem, kept, LANE, MOST) if len(problem.visitors.exits) else []


def tills_adrift(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of all tills with lanes of boxes (n, 5), in metres: how far they are from the
    nearest way out, lanes that do not lead to it, and square metres of them on the way in."""
    mine = (boxes[slice(*problem.units.spans[unit])] for unit in find_tills(problem, kept))
    return sum(measure_tills(problem, tills) for tills in mine)


def measure_tills(problem: HallProblem, tills: Floats) -> float:
    """The fault of one group of tills (n, 5), in metres."""
    middle = box_round(tills)[:2]
    best = min(_ways_out(problem), key=lambda way: float(np.hypot(*(way[:2] - middle))))
    far = FAR * max(float(np.hypot(*(best[:2] - middle))) - NEAR, 0.0)
    right = np.array([np.sin(tills[0, 2]), -np.cos(tills[0, 2])])
    turned = TURNED * (1.0 - abs(float(right @ best[2:])))
    door, inward = problem.visitors.entrances[0], problem.visitors.inward[0]
    x, y = door + 0.5 * WAY * inward
    strip = np.array([x, y, np.arctan2(inward[1], inward[0]), 2 * WIDE, WAY])
    free, *shapes = shapely.polygons(corners(np.concatenate([strip[None], tills])))
    return (
        min(far, MOST_FAR) + turned + float(shapely.area(shapely.intersection(shapes, free)).sum())
    )


def _ways_out(problem: HallProblem) -> Floats:
    """Where visitors leave (k, 4): a point and the unit direction in from there."""
    doors = problem.ground.doors
    ahead = np.column_stack([np.cos(doors[:, 2]), np.sin(doors[:, 2])])
    points = problem.visitors.exits
    near = [int(np.hypot(*(doors[:, :2] - point).T).argmin()) for point in points]
    return np.column_stack([points, ahead[near]])


def propose_tills(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the tills of one unit before a way out, their lanes leading to it, where they
    stand one behind another already."""
    for unit in find_tills(problem, kept):
        tills = boxes[slice(*problem.units.spans[unit])]
        if int(kept.rows[unit, 1]) != len(tills):
            continue
        for x, y, dx, dy in _ways_out(problem):
            out, half = np.array([x, y, np.arctan2(dy, dx)]), 0.5 * tills[0, 3]
            places = before(out, (ahead + half for ahead in STEPS), SHIFTS, -0.5 * np.pi)
            yield from stand_at(kept, unit, places)
