"""Waiting: seats on which people wait to be served are near a desk, on its visitors' side."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from scenewright.domains.hall.patterns import SINGLE, WALL
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.desks import BACK, far_from
from scenewright.domains.hall.retouch.lines import forgive_space
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.visitors import FIRST, MACHINE, TILL, WAITING

NEAR, FAR, RATE = 4.0, 20.0, 0.1
"""Metres from a desk within which one waits for it, metres beyond which more count no more, and
what each between counts."""
BESIDE, BEHIND, AHEAD, STAFF = 2.2, 3.0, 0.6, 2.0
"""Metres beside, behind and ahead of the front of a desk in which nobody waits, and what counts
who does, in metres."""
LOOSE, ADRIFT = 0.3, 2.0
"""What each metre counts between a seat by itself and a wall at its back, up to so many."""
STEPS, ALONG, CLOSE = 9, 0.5, 0.02
"""Places along each side of the zone that are tried, metres between those along its walls, and what
is left between a wall and a back at it, in metres."""
MOST = 200
"""How many places along walls are tried at most."""


def measure_waiting(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """How much too far from the nearest desk, or where its staff is, each group of seats among
    boxes (n, 5) stands on which people wait, in metres."""
    desks = _find_desks(problem, boxes)
    waiting = _find_waiting(problem, kept) if len(desks) else []
    mine = {unit: boxes[slice(*problem.units.spans[unit])] for unit in waiting}
    return sum(_measure(desks, own) + _measure_loose(problem, own) for own in mine.values())


def _measure_loose(problem: HallProblem, seats: Floats) -> float:
    """What the distance from a wall counts of one seat (1, 5) by itself."""
    if len(seats) > 1:
        return 0.0
    x, y, heading, _, depth = seats[0]
    back = np.array([[x - 0.5 * depth * np.cos(heading), y - 0.5 * depth * np.sin(heading)]])
    far = float(far_from(problem.ground.edges, back)[0])
    return LOOSE * min(max(far - 2.0 * CLOSE, 0.0), ADRIFT)


def _find_waiting(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of seats to wait on at walls or one by itself: lounges stand where they have room
    for their company."""
    waits = problem.visitors.roles.astype(int) & WAITING > 0
    if not waits.any():
        return []
    alone = (kept.rows[:, 0] == SINGLE) & (np.diff(problem.units.spans, axis=1)[:, 0] == 1)
    return np.flatnonzero(waits & (alone | (kept.rows[:, 0] == WALL))).tolist()


def _find_desks(problem: HallProblem, boxes: Floats) -> Floats:
    """Boxes (d, 5) round the desks of each group of those that are served from behind."""
    spans, access = problem.units.spans, problem.units.access
    roles = problem.visitors.roles.astype(int)
    served = (roles & (FIRST | TILL) > 0) & (roles & MACHINE == 0)
    found = [
        box_round(boxes[slice(*span)])
        for span, mine in zip(spans, served, strict=False)
        if mine and not access[span[0], BACK]
    ]
    return np.array(found).reshape(-1, 5)


def _measure(desks: Floats, seats: Floats) -> float:
    """The fault of the seats (k, 5) of one group beside desks (d, 5).

    >>> desk = np.array([[0.0, 0.0, np.pi / 2, 3.0, 0.8]])
    >>> [_measure(desk, np.array([[0.0, y, 0.0, 0.8, 0.8]])) for y in (3.0, 9.4, -2.0)]
    [0.0, 0.5, 2.0]
    """
    front = np.stack([np.cos(desks[:, 2]), np.sin(desks[:, 2])], axis=1)
    off = seats[:, None, :2] - (desks[:, :2] + 0.5 * desks[:, 4:] * front)
    ahead = (off * front).sum(2)
    aside = np.abs(off[..., 0] * front[:, 1] - off[..., 1] * front[:, 0])
    beyond = np.maximum(aside - 0.5 * desks[:, 3], 0.0)
    staff = (ahead < AHEAD) & (ahead > -desks[:, 4] - BEHIND) & (beyond < BESIDE)
    far = np.hypot(ahead, beyond).min(1).mean()
    return STAFF * bool(staff.any()) + RATE * float(np.clip(far - NEAR, 0.0, FAR))


def forgive_backs(
    problem: HallProblem,
    kept: Kept,
    boxes: Floats,  # noqa: ARG001
    p: PreparedHall,
    s: State,
) -> float:
    """What of the energy of a measured state comes from free floor of seats by themselves that lies
    at walls: their back stands at one."""
    alone = [unit for unit in _find_waiting(problem, kept) if int(kept.rows[unit, 0]) == SINGLE]
    return sum(forgive_space(p, s, unit, float(s.covered[unit, :2].sum())) for unit in alone)


def propose_waiting(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the seats of one group that is not near a desk elsewhere in its zone, those at
    walls farther along them, one by itself with its back at each wall too."""
    desks = _find_desks(problem, boxes)
    for unit in _find_waiting(problem, kept) if len(desks) else []:
        mine = boxes[slice(*problem.units.spans[unit])]
        if _measure(desks, mine) + _measure_loose(problem, mine) <= 0.0:
            continue
        if int(kept.rows[unit, 0]) == WALL:
            poses = _slide(problem, unit, kept.pose[unit])
        else:
            poses = [*_spots(problem, unit, kept.pose[unit]), *_walls(problem, unit)]
        for own in poses:
            pose = kept.pose.copy()
            pose[unit] = own
            yield kept._replace(pose=pose)


def _slide(problem: HallProblem, unit: int, pose: Floats) -> list[Floats]:
    """Poses (4,) of a row at walls along all of those of its zone, each at either end of the wall
    or amid it."""
    ground = problem.ground
    rows = ground.stretches[ground.stretches[:, 4] == problem.units.zones[unit]]
    total = float(np.hypot(*(rows[:, 2:4] - rows[:, :2]).T).sum())
    starts = np.linspace(0.0, total, min(int(total / ALONG) + 1, MOST), endpoint=False)
    return [np.array([a, b, *pose[2:]]) for a, b in product(starts, (-1.0, 0.0, 1.0))]


def _spots(problem: HallProblem, unit: int, pose: Floats) -> list[Floats]:
    """Poses (4,) all over the zone of a group, as it looks now and turned by quarters."""
    low, high = problem.ground.zone_bounds[int(problem.units.zones[unit])].reshape(2, 2)
    parts = (np.arange(STEPS) + 0.5) / STEPS
    return [
        np.array([*(low + part * (high - low)), pose[2] + 0.5 * np.pi * turn, pose[3]])
        for part, turn in product(np.array(list(product(parts, repeat=2))), range(4))
    ]


def _walls(problem: HallProblem, unit: int) -> list[Floats]:
    """Poses (4,) of one seat with its back at the walls of its zone."""
    ground, depth = problem.ground, float(problem.units.sizes[problem.units.spans[unit, 0], 1])
    wide, found = float(problem.units.sizes[problem.units.spans[unit, 0], 0]), list[Floats]()
    for x0, y0, x1, y1 in ground.stretches[ground.stretches[:, 4] == problem.units.zones[unit], :4]:
        length = max(float(np.hypot(x1 - x0, y1 - y0)), 1e-9)
        way = np.array([x1 - x0, y1 - y0]) / length
        left = np.array([-way[1], way[0]])
        for t in np.arange(0.5 * wide + CLOSE, length - 0.5 * wide, ALONG):
            at = np.array([x0, y0]) + t * way + (0.5 * depth + CLOSE) * left
            found.append(np.array([*at, np.arctan2(left[1], left[0]), 0.0]))
    return found[:: len(found) // MOST + 1]
