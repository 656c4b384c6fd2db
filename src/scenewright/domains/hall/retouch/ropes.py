"""Ropes where they guide somebody: in lines before the desk people queue at, and where a zone has
none, in a row before its main exhibit or before objects at its walls."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

import numpy as np

from scenewright.domains.hall.patterns import CHAIN, SINGLE, WALL
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.arrivals import box_round, find_met
from scenewright.domains.hall.retouch.desk_groups import BACK
from scenewright.domains.hall.retouch.lines import count_objects, find_layers, line_up
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import FIRST, GUIDE, LANE, MAIN, TILL

MOST, LINES, LONGEST = 24, 5, 4
"""Ropes of one group, lines of them, and ropes of one line at most."""
GAPS = (1.0, 1.3)
"""Metres between what they guard and the ropes, nearest and farthest."""
LANES = (1.0, 1.25)
"""Widths of the lanes between lines of ropes that are tried, in metres."""
ROPES_ACROSS, PER_TURNED_ROPE, PER_ROPE_ASIDE, MOST_OFF = 2.0, 0.6, 0.5, 3.0
"""What ropes across what they should stand along count, those along a desk instead of up to it,
what a metre beside it does, and metres beyond which more count no more."""
NEARER, LONG_DESK = 5.0, 4.0
"""Cost of each metre by which ropes along a desk, or before one longer than ``LONG_DESK``, are
too near for anybody to pass between."""
ANCHORS, NEARLY_WIDEST, SECOND = 12, 0.75, 0.6
"""How many objects at walls are looked at; the share of the widest row of desks down to which
people queue at other rows of the zone too; and what ropes before a shorter row count."""


IN_LINE = 0.02
"""Sine of the angle between two desks from which on they do not stand in line."""


class Anchor(NamedTuple):
    """What ropes are to stand before: a box (5,), whether people queue there, and metres by which
    ropes elsewhere are better."""

    box: Floats
    queue: bool
    less: float = 0.0


def find_ropes(problem: HallProblem, kept: Kept) -> list[int]:
    """The units that are ropes."""
    return find_met(problem, kept, GUIDE, MOST, (CHAIN, SINGLE))


def find_served(problem: HallProblem, unit: int) -> list[int]:
    """The units of desks in the zone of a unit of ropes, at which people queue."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    return [
        u
        for u in range(len(roles))
        if units.zones[u] == units.zones[unit]
        and roles[u] & (FIRST | TILL)
        and not roles[u] & LANE
        and not units.access[units.spans[u, 0], BACK]
    ]


def find_anchors(problem: HallProblem, kept: Kept, boxes: Floats, unit: int) -> list[Anchor]:
    """What the ropes of a unit may guard in their zone, of the first kind present."""
    units, roles = problem.units, problem.visitors.roles.astype(int)
    beside = [u for u in range(len(roles)) if units.zones[u] == units.zones[unit] and u != unit]
    desks = find_served(problem, unit)
    mine = [boxes[slice(*span)] for span in units.spans]
    alone = _find_mains(problem, kept, mine, beside)
    if desks:
        whole = [box_round(row) for u in desks for row in _split_rows(mine[u])]
        widest = max(float(box[3]) for box in whole)
        less = [SECOND * (box[3] < NEARLY_WIDEST * widest) for box in whole]
        queues = [Anchor(box, True, one) for box, one in zip(whole, less, strict=True)]
        return queues + [one._replace(less=SECOND) for one in alone]
    lanes = [u for u in beside if roles[u] & LANE]
    if lanes:
        return [Anchor(_find_queue_end(problem, mine[u]), True) for u in lanes]
    if alone:
        return alone
    walls = [box for u in beside if kept.rows[u, 0] == WALL for box in mine[u]]
    return [Anchor(box, False) for box in walls[:: max(len(walls) // ANCHORS, 1)]]


def _split_rows(desks: Floats) -> list[Floats]:
    """Desks (n, 5) of one unit by the walls along which they stand in line.

    >>> desks = np.array([[0, 0, 1.5, 2, 1], [2, 0, 1.5, 2, 1], [5, 3, 3.1, 2, 1.0]])
    >>> [len(row) for row in _split_rows(desks)]
    [2, 1]
    """
    turned = np.flatnonzero(np.abs(np.sin(np.diff(desks[:, 2]))) > IN_LINE)
    return np.split(desks, turned + 1)


def _find_mains(
    problem: HallProblem, kept: Kept, mine: list[Floats], beside: list[int]
) -> list[Anchor]:
    """The sides of the main exhibit, if it is one of some units and stands free; ``mine`` are the
    boxes (n, 5) of each unit."""
    roles = problem.visitors.roles.astype(int)
    mains = [mine[u][0] for u in beside if roles[u] & MAIN and kept.rows[u, 0] != WALL]
    if not mains:
        return []
    turned = mains[0] + [0.0, 0.0, 0.5 * np.pi, 0.0, 0.0]
    turned[3:] = mains[0][[4, 3]]
    half = np.array([0.0, 0.0, np.pi, 0.0, 0.0])
    return [Anchor(box, False) for box in (mains[0], turned, mains[0] + half, turned + half)]


def _find_queue_end(problem: HallProblem, tills: Floats) -> Floats:
    """The box (5,) round tills with lanes, its front where people come to the lanes."""
    turn = 0.5 * np.pi
    right = np.array([np.sin(tills[0, 2]), -np.cos(tills[0, 2])])
    middle, doors = tills[:, :2].mean(0), problem.visitors.exits
    out = doors[np.hypot(*(doors - middle).T).argmin()] - middle if len(doors) else -right
    heading = float(tills[0, 2]) + (turn if out @ right > 0.0 else -turn)
    turned = np.full(len(tills), heading)
    return box_round(np.column_stack([tills[:, :2], turned, tills[:, 4], tills[:, 3]]))


def ropes_adrift(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """The faults of all ropes of boxes (n, 5), in metres."""
    return sum(measure_ropes(problem, kept, boxes, u) for u in find_ropes(problem, kept))


def measure_ropes(problem: HallProblem, kept: Kept, boxes: Floats, unit: int) -> float:
    """How far the ropes of a unit are from their place before the nearest of what they may guard,
    in metres; 0 where there is nothing of that."""
    mine = boxes[slice(*problem.units.spans[unit])]
    anchors = find_anchors(problem, kept, boxes, unit)
    return min((measure_before(mine, anchor) for anchor in anchors), default=0.0)


def forms_lane(problem: HallProblem, kept: Kept, boxes: Floats, unit: int) -> bool:
    """Whether the ropes of a unit stand in two lines and more, or where nobody queues."""
    queues = any(anchor.queue for anchor in find_anchors(problem, kept, boxes, unit))
    return not queues or (int(kept.rows[unit, 0]) == CHAIN and int(kept.rows[unit, 1]) > 1)


def measure_before(ropes: Floats, anchor: Anchor) -> float:
    """How far some ropes (n, 5) are from their place before an anchor, in metres: in lines where
    people queue, else in one line, as several guard nothing more."""
    box = anchor.box
    front = np.array([np.cos(box[2]), np.sin(box[2])])
    run = np.array([-np.sin(ropes[0, 2]), np.cos(ropes[0, 2])])
    along = abs(float(run @ front))
    seen = box_round(np.column_stack([ropes[:, :2], np.full(len(ropes), box[2]), ropes[:, 3:]]))
    if along > 0.7:
        seen = box_round(
            np.column_stack([ropes[:, :2], np.full(len(ropes), box[2]), ropes[:, 4], ropes[:, 3]])
        )
    off = seen[:2] - box[:2]
    gap = float(off @ front) - 0.5 * (box[4] + seen[4])
    aside = abs(float(off @ (front[1], -front[0]))) - 0.5 * max(box[3] - seen[3], 0.0)
    near = max(GAPS[0] - 0.3 - gap, 0.0)
    if along < 0.7 or box[3] > LONG_DESK:
        near = NEARER * max(GAPS[0] - 0.1 - gap, 0.0)
    far = max(near, gap - GAPS[1] - 0.3)
    deeper = max(float(seen[4]) - float(ropes[0, 4]), 0.0)
    turned = (
        PER_TURNED_ROPE * (1.0 - along)
        if anchor.queue
        else ROPES_ACROSS * along + min(deeper, MOST_OFF)
    )
    return (
        anchor.less + turned + min(far, MOST_OFF) + PER_ROPE_ASIDE * min(max(aside, 0.0), MOST_OFF)
    )


def propose_ropes(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the ropes of one unit before what they may guard."""
    for unit in find_ropes(problem, kept):
        number, room = int(count_objects(problem)[unit]), find_layers(problem, unit)[1]
        wide, deep = problem.units.sizes[problem.units.spans[unit, 0]]
        for anchor in find_anchors(problem, kept, boxes, unit):
            for form in _forms(number, anchor, room):
                lines, lane = form.lines, form.lane
                whole = np.array([-(-number // lines) * wide, lines * deep + (lines - 1) * lane])
                for gap, aside in product(GAPS, (0.0, -1.0, 1.0)):
                    pose = _place(anchor, whole, form.up, gap, aside)
                    yield line_up(problem, kept, unit, pose, lines, lane)


class RopeForm(NamedTuple):
    """Lines of ropes, the width of the lanes between them in metres, and whether they lead ``up``
    to what they stand before."""

    lines: int
    lane: float
    up: bool


def _forms(number: int, anchor: Anchor, room: int) -> list[RopeForm]:
    """Forms for ``number`` ropes; before a desk those that lead up to it first."""
    if not anchor.queue:
        return [RopeForm(1, 0.0, False)]
    most = min(LINES, number, room)
    lines = [n for n in range(min(2, number), most + 1) if -(-number // n) <= LONGEST]
    up = [RopeForm(n, lane, True) for n in lines or [most] for lane in LANES]
    few = [n for n in (1, 2) if n <= most and -(-number // n) <= LONGEST]
    return [*up, *(RopeForm(n, LANES[0], False) for n in few)]


def _place(
    anchor: Anchor, whole: Floats, up: bool, gap: float, aside: float
) -> tuple[float, float, float]:
    """The pose of ropes as large as ``whole`` (2,) along and across, ``gap`` metres before an
    anchor and beside its middle by as much as there is room, times ``aside``."""
    box = anchor.box
    front = np.array([np.cos(box[2]), np.sin(box[2])])
    depth, width = whole if up else whole[::-1]
    off = aside * 0.5 * max(float(box[3]) - width, 0.0)
    x, y = box[:2] + (0.5 * (box[4] + depth) + gap) * front + off * np.array([front[1], -front[0]])
    return float(x), float(y), float(box[2] + (0.5 * np.pi if up else 0.0))
