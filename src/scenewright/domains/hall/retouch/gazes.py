"""Free-standing rows of lounge seats look into the hall, not at a wall or window close before."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import shapely

from scenewright.domains.hall.patterns import CHAIN, GRID, SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import turn_half_round
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import LOUNGE

CLOSE, LOOKED = 2.0, 8.0
"""Metres to a wall at which nobody wants to look, and metres beyond which a view is no wider."""
TURNED = 1.5
"""What a group counts if all of it looks at a wall close before, in metres."""
OFF = 0.1
"""What each metre counts between the backs of a group and a wall close behind: turned round, it
stands nearer to that."""
STEPS = tuple(sorted((0.15 * k for k in range(-8, 9)), key=abs))
"""Metres ahead of where they stand that are tried with seats turned half round."""


def find_lounges(problem: HallProblem, kept: Kept) -> list[int]:
    """The units of lounge seats in straight rows that look at nothing of their own."""
    lounge = problem.visitors.roles.astype(int) & LOUNGE > 0
    straight = np.isin(kept.rows[:, 0].astype(int), (CHAIN, GRID, SINGLE))
    return [int(u) for u in np.flatnonzero(lounge & straight & (problem.units.targets < 0))]


def measure_gazes(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """What groups among boxes (n, 5) count of whose seats more than half look at a wall closer than
    :data:`CLOSE` with a wider view behind: :data:`TURNED` each; of others, how far their backs are
    from such a wall, by :data:`OFF`."""
    return sum(_measure_gaze(problem, boxes, unit) for unit in find_lounges(problem, kept))


def _measure_gaze(problem: HallProblem, boxes: Floats, unit: int) -> float:
    mine = boxes[slice(*problem.units.spans[unit])]
    before, behind = _view(problem, mine, 0.0), _view(problem, mine, np.pi)
    if np.mean((before < CLOSE) & (behind > CLOSE)) > 0.5:
        return TURNED
    near = behind[behind < CLOSE]
    return OFF * float(near.mean()) if 2 * len(near) > len(mine) else 0.0


def _view(problem: HallProblem, seats: Floats, turn: float) -> Floats:
    """How far seats (n, 5) see (n,), in metres: from their edge to the first wall, that way."""
    ahead = np.stack([np.cos(seats[:, 2] + turn), np.sin(seats[:, 2] + turn)], axis=1)
    begin = seats[:, :2] + 0.5 * seats[:, 4:] * ahead
    rays = shapely.linestrings(np.stack([begin, begin + LOOKED * ahead], axis=1))
    walls = shapely.multilinestrings(problem.ground.edges[:, :4].reshape(-1, 2, 2))
    hit = shapely.distance(shapely.points(begin), shapely.intersection(rays, walls))
    seen: Floats = np.nan_to_num(hit, nan=LOOKED)
    return seen


def propose_views(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one group that looks at a wall turned half round, a little ahead of or behind
    where it stands."""
    for unit in find_lounges(problem, kept):
        if _measure_gaze(problem, boxes, unit) == TURNED:
            yield from turn_half_round(kept, unit, STEPS)
