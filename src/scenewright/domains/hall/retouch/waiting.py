"""Waiting: seats on which people wait to be served are near a desk, on its visitors' side."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import SINGLE, WALL
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.arrivals import box_round
from scenewright.domains.hall.retouch.desk_groups import BACK
from scenewright.domains.hall.retouch.desks import far_from
from scenewright.domains.hall.retouch.lines import forgive_space
from scenewright.domains.hall.retouch.places import CLOSE, all_over, along_walls, at_walls, stand_at
from scenewright.domains.hall.terms.state import Kept, PreparedHall, State
from scenewright.domains.hall.terms.visitors import FIRST, MACHINE, TILL, WAITING

WAITING_NEAR, FARTHEST_SEAT, RATE = 4.0, 20.0, 0.1
"""Metres from a desk within which one waits for it, metres beyond which more count no more, and
what each between counts."""
STAFF_BESIDE, STAFF_BEHIND, AHEAD, AMONG_STAFF = 2.2, 3.0, 0.6, 2.0
"""Metres beside, behind and ahead of the front of a desk in which nobody waits, and what counts
who does, in metres."""
LOOSE, ADRIFT = 0.3, 2.0
"""Cost of each metre between a lone seat and the wall behind it, and the most."""


def measure_waiting(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """How much too far from the nearest desk, or where its staff is, each group of seats among
    boxes (n, 5) stands on which people wait, in metres."""
    desks = _find_desks(problem, boxes)
    waiting = _find_waiting(problem, kept) if len(desks) else []
    mine = {unit: boxes[slice(*problem.units.spans[unit])] for unit in waiting}
    return sum(_measure(desks, own) + _measure_loose(problem, own) for own in mine.values())


def _measure_loose(problem: HallProblem, seats: Floats) -> float:
    """The cost of the distance of a lone seat (1, 5) from a wall."""
    if len(seats) > 1:
        return 0.0
    x, y, heading, _, depth = seats[0]
    back = np.array([[x - 0.5 * depth * np.cos(heading), y - 0.5 * depth * np.sin(heading)]])
    far = float(far_from(problem.ground.edges, back)[0])
    return LOOSE * min(max(far - 2.0 * CLOSE, 0.0), ADRIFT)


def _find_waiting(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of waiting seats at walls, or of one seat: lounges stand where they have room
    for their company."""
    waits = problem.visitors.roles.astype(int) & WAITING > 0
    if not waits.any():
        return []
    alone = (kept.rows[:, 0] == SINGLE) & (np.diff(problem.units.spans, axis=1)[:, 0] == 1)
    return np.flatnonzero(waits & (alone | (kept.rows[:, 0] == WALL))).tolist()


def _find_desks(problem: HallProblem, boxes: Floats) -> Floats:
    """Boxes (d, 5) round the desks of each group of those that are served from behind, and of those
    set at doors."""
    spans, access = problem.units.spans, problem.units.access
    roles = problem.visitors.roles.astype(int)
    served = (roles & (FIRST | TILL) > 0) & (roles & MACHINE == 0)
    found = [
        box_round(boxes[slice(*span)])
        for span, mine in zip(spans, served, strict=False)
        if mine and not access[span[0], BACK]
    ]
    return np.concatenate([np.array(found).reshape(-1, 5), problem.visitors.served])


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
    staff = (ahead < AHEAD) & (ahead > -desks[:, 4] - STAFF_BEHIND) & (beyond < STAFF_BESIDE)
    far = np.hypot(ahead, beyond).min(1).mean()
    return AMONG_STAFF * bool(staff.any()) + RATE * float(
        np.clip(far - WAITING_NEAR, 0.0, FARTHEST_SEAT)
    )


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
    walls farther along them, a lone one also with its back at each wall."""
    desks = _find_desks(problem, boxes)
    for unit in _find_waiting(problem, kept) if len(desks) else []:
        mine = boxes[slice(*problem.units.spans[unit])]
        if _measure(desks, mine) + _measure_loose(problem, mine) <= 0.0:
            continue
        if int(kept.rows[unit, 0]) == WALL:
            places = along_walls(problem, unit)
        else:
            places = [*all_over(problem, unit, kept.pose[unit, 2]), *at_walls(problem, unit)]
        yield from stand_at(kept, unit, places)
