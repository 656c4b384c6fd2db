"""Tills with lanes between them: across the flow before a way out, so that people leave through
the lanes; where one comes in by the same door, beside the way in."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.hall.measures import WAY_LENGTH, WAY_WIDTH
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.places import before, stand_at
from scenewright.domains.hall.retouch.row_groups import GROUPS
from scenewright.domains.hall.retouch.weigh_rows import find_ways_out, look_rows, measure_rows
from scenewright.domains.hall.terms.state import Kept

PER_TURNED_LANES = 3.0
"""Cost of lanes that lead along the wall of the way out, in metres."""
STEPS = (2.0, 2.6, 3.4, 4.4)
SHIFTS = tuple(0.6 * k for k in range(-16, 17))
"""Metres ahead of a way out and aside that are tried."""


def find_tills(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of tills with lanes in rows."""
    return np.flatnonzero(GROUPS["tills with lanes"](problem, kept)).tolist()


def tills_adrift(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of all tills with lanes of boxes (n, 5), in metres: how far they are from the
    nearest way out, lanes that do not lead to it, and square metres of them on the way in."""
    mine = (boxes[slice(*problem.units.spans[unit])] for unit in find_tills(problem, kept))
    far = measure_rows(look_rows(("tills_far",), problem), kept, boxes)
    return far + sum(measure_tills(problem, tills) for tills in mine)


def measure_tills(problem: HallProblem, tills: Floats) -> float:
    """What of one group of tills (n, 5) does not lead to the way out or stands on the way in, in
    metres."""
    middle, ways = box_round(tills)[:2], find_ways_out(problem)
    out = ways[int(np.hypot(*(ways[:, :2] - middle).T).argmin()), 2]
    turned = PER_TURNED_LANES * (1.0 - abs(float(np.sin(tills[0, 2] - out))))
    door, inward = problem.visitors.entrances[0], problem.visitors.inward[0]
    x, y = door + 0.5 * WAY_LENGTH * inward
    strip = np.array([x, y, np.arctan2(inward[1], inward[0]), WAY_WIDTH, WAY_LENGTH])
    free, *shapes = shapely.polygons(corners(np.concatenate([strip[None], tills])))
    return turned + float(shapely.area(shapely.intersection(shapes, free)).sum())


def propose_tills(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the tills of one unit before a way out, their lanes leading to it, where they
    stand one behind another already."""
    for unit in find_tills(problem, kept):
        tills = boxes[slice(*problem.units.spans[unit])]
        if int(kept.rows[unit, 1]) != len(tills):
            continue
        half = 0.5 * tills[0, 3]
        for out in find_ways_out(problem):
            places = before(out, (ahead + half for ahead in STEPS), SHIFTS, -0.5 * np.pi)
            yield from stand_at(kept, unit, places)
