"""Desks at which visitors arrive: at a wall near the entrance, beside the way in, not across it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.hall.patterns import SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.table import ORDER
from scenewright.domains.hall.terms.visitors import FIRST

STEP, PROPOSED = 0.4, 200
"""Metres between two places that are tried along a wall, and how many of them at most."""
BEHIND, STAFF = 0.3, 0.9
"""Metres that a back or side may be farther from a wall than who serves needs, and what they need
at least."""
FAR, TOO_FAR = 3.0, 0.4
"""Metres from the entrance that are near enough, and what each beyond counts."""
WAY, WIDE, QUEUE = 6.0, 1.2, 1.5
"""Length and half width of the way in that stays free, and depth of the queue, in metres."""
WAITING = 0.3
"""What a square metre of queue on the way in counts, of desk one metre."""
BACK_TO = 1.5
"""What a back turned to who comes in counts, in metres."""
FIRST_OF_ALL = 12.0
"""What it costs beside the energy that others lie a metre nearer to the entrance."""
LONGEST, LINES = 4.0, 24


def find_desks(problem: HallProblem, kept: Kept) -> list[int]:
    """The units that are one desk each to come to first; none without an entrance."""
    roles, spans = problem.visitors.roles, problem.units.spans
    if not len(problem.visitors.inward) or not len(problem.visitors.entrances):
        return []
    return [
        unit
        for unit in range(len(spans))
        if int(roles[unit]) & FIRST
        and spans[unit, 1] - spans[unit, 0] == 1
        and int(kept.rows[unit, 0]) == SINGLE
        and problem.units.targets[unit] < 0
    ]


def desks_adrift(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of all desks, in metres, of boxes (n, 5)."""
    rows = [int(problem.units.spans[unit, 0]) for unit in find_desks(problem, kept)]
    return sum(measure_desk(problem, boxes[row], row) for row in rows)


def measure_desk(problem: HallProblem, box: Floats, row: int) -> float:
    """How far a desk (5,) is from where one looks for it: metres its back is off a wall beyond what
    who serves needs, how far it is from the entrance, how much of it and its queue lies on the way
    in, and whether it turns its back to who comes in."""
    door, inward = problem.visitors.entrances[0], problem.visitors.inward[0]
    front = np.array([np.cos(box[2]), np.sin(box[2])])
    staff = max(float(problem.units.clear[row, 2]), STAFF)
    right = np.array([front[1], -front[0]])
    back = _far(problem, box[:2] - 0.5 * box[4] * front) - staff
    sides = min(_far(problem, box[:2] + side * box[3] * right) for side in (-0.5, 0.5))
    adrift = max(min(back, sides) - BEHIND, 0.0)
    far = float(np.hypot(*(box[:2] - door)))
    turned = BACK_TO if (door - box[:2]) @ front < -0.3 * far else 0.0
    before = box[:2] + 0.5 * (box[4] + QUEUE) * front
    queue = np.array([*before, box[2], box[3], QUEUE])
    middle, ahead = door + 0.5 * WAY * inward, np.arctan2(inward[1], inward[0])
    way = np.array([*middle, ahead, 2 * WIDE, WAY])
    desk, waiting, free = shapely.polygons(corners(np.stack([box, queue, way])))
    across = float(desk.intersection(free).area + WAITING * waiting.intersection(free).area)
    return min(adrift, LONGEST) + TOO_FAR * max(far - FAR, 0.0) + across + turned


def _far(problem: HallProblem, point: Floats) -> float:
    """Metres from a point to the nearest wall of the hall."""
    start, way = (
        problem.ground.edges[:, :2],
        problem.ground.edges[:, 2:] - problem.ground.edges[:, :2],
    )
    along = ((point - start) * way).sum(1) / np.maximum((way**2).sum(1), 1e-12)
    nearest = start + np.clip(along, 0.0, 1.0)[:, None] * way
    return float(np.hypot(*(point - nearest).T).min())


def mind_order(
    problem: HallProblem,  # noqa: ARG001
    kept: Kept,  # noqa: ARG001
    boxes: Floats,  # noqa: ARG001
    p: PreparedHall,  # noqa: ARG001
    s: State,
) -> float:
    """What is taken off the energy of a measured state: nothing, but more for every metre by which
    others lie nearer to the entrance than desks; no desk leaves its turn for a wall."""
    return -FIRST_OF_ALL * float(s.costs[ORDER, 0])


def propose_desks(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one desk each at a wall of its zone, the best places first."""
    for unit in find_desks(problem, kept):
        row = int(problem.units.spans[unit, 0])
        places = _places(problem, boxes, row, int(problem.units.zones[unit]))
        faults = np.array([measure_desk(problem, box, row) for box in places])
        now = measure_desk(problem, boxes[row], row)
        for number in np.argsort(faults, kind="stable")[:PROPOSED]:
            if faults[number] < now:
                pose = kept.pose.copy()
                pose[unit, :3] = places[number, :3]
                yield kept._replace(pose=pose)


def _places(problem: HallProblem, boxes: Floats, row: int, zone: int) -> Floats:
    """Boxes (n, 5) of a desk along the walls of its zone, with room behind it to serve, and with
    its side at them: at even steps, and in line with the middles of other ``boxes`` (n, 5)."""
    staff, box = max(float(problem.units.clear[row, 2]), STAFF), boxes[row]
    others = np.delete(boxes[:, :2], row, axis=0)
    found = [np.zeros((0, 5))]
    for x0, y0, x1, y1 in problem.ground.stretches[problem.ground.stretches[:, 4] == zone, :4]:
        length = float(np.hypot(x1 - x0, y1 - y0))
        way = np.array([x1 - x0, y1 - y0]) / max(length, 1e-9)
        left = np.array([-way[1], way[0]])
        heading = float(np.arctan2(left[1], left[0]))
        for turn, off in ((0.0, staff), (0.5 * np.pi, 0.05), (-0.5 * np.pi, 0.05)):
            wide, deep = (box[3], box[4]) if turn == 0.0 else (box[4], box[3])
            near, far = 0.5 * wide + 0.05, length - 0.5 * wide
            along = np.arange(near, far, STEP)
            along = np.append(along, _lines((others - (x0, y0)) @ way, near, far))
            first = off + 0.5 * deep
            offs = np.append(first, _lines((others - (x0, y0)) @ left, first, first + BEHIND))
            t, d = (grid.ravel() for grid in np.meshgrid(along, offs))
            places = np.zeros((len(t), 5))
            places[:, :2] = (x0, y0) + t[:, None] * way + d[:, None] * left
            places[:, 2], places[:, 3:] = heading + turn, box[3:]
            found.append(places)
    return np.concatenate(found)


def _lines(values: Floats, low: float, high: float) -> Floats:
    """The different values between two, to the millimetre, at most so many."""
    within = np.unique(np.round(values[(values > low) & (values < high)], 3))
    return within[:: max(len(within) // LINES, 1)]
