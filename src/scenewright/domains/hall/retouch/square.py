"""Groups amid the floor that stand askew to the hall are set square to it."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

import numpy as np

from scenewright.core.layout import corners
from scenewright.domains.hall.patterns import CHAIN, GRID, SINGLE
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.terms.state import Kept

QUARTER = 0.5 * np.pi
SQUARE, SHARE = np.radians(1.0), 0.4
"""Radians that are no angle, and the share of all walls that run one way in a hall that has one."""
ASKEW, CLOSE, LONG = 3.0, 1.2, 1.5
"""What an askew group counts, in metres, how near one stands to a wall it goes with, and how long
this is: no column."""
STEPS = (0.0, 0.3, -0.3, 0.6, -0.6, 1.2, -1.2)
"""Metres that are tried aside of where a group stands."""


def measure_askew(problem: HallProblem, kept: Kept, boxes: Floats) -> float:
    """What groups count that are askew to most walls of the hall and go with no wall near them."""
    main = _find_way(problem.ground.edges)
    return ASKEW * sum(1 for _ in _list_askew(problem, kept, boxes, main)) if main else 0.0


def propose_squared(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with one such group turned to the nearest quarter, or to the next one, where it
    stands or a little aside."""
    main = _find_way(problem.ground.edges)
    for unit in _list_askew(problem, kept, boxes, main) if main else ():
        off = _turn_off(float(kept.pose[unit, 2]), main[0])
        for turn, x, y in product((-off, np.sign(off) * QUARTER - off), STEPS, STEPS):
            pose = kept.pose.copy()
            pose[unit, :3] += (x, y, turn)
            yield kept._replace(pose=pose)


def _list_askew(
    problem: HallProblem, kept: Kept, boxes: Floats, main: tuple[float, ...]
) -> Iterator[int]:
    """The units in straight rows that look at nothing and are askew."""
    units = problem.units
    straight = np.isin(kept.rows[:, 0].astype(int), (CHAIN, GRID, SINGLE))
    for unit in np.flatnonzero(straight & (units.targets < 0)).tolist():
        mine = boxes[slice(*units.spans[unit])]
        heading = float(mine[0, 2])
        if abs(_turn_off(heading, main[0])) > SQUARE and not _goes_with(problem, mine, heading):
            yield unit


def _turn_off(heading: float, way: float) -> float:
    """Radians from the nearest quarter to a way, to a heading: from -π/4 to π/4."""
    return (heading - way + 0.5 * QUARTER) % QUARTER - 0.5 * QUARTER


def _find_way(edges: Floats) -> tuple[float, ...]:
    """The angle, up to quarters, in which most metres of edges (e, 4) run; none in a round hall.

    >>> _find_way(np.array([[0.0, 0, 8, 0], [8, 0, 8, 5], [8, 5, 0, 5], [0, 5, 0, 0]]))
    (0.0,)
    """
    way = edges[:, 2:4] - edges[:, :2]
    lengths, angles = np.hypot(*way.T), np.arctan2(way[:, 1], way[:, 0])
    off = (angles[:, None] - angles + 0.5 * QUARTER) % QUARTER - 0.5 * QUARTER
    whole = (np.abs(off) < SQUARE) @ lengths
    most = int(np.argmax(whole))
    return (float(angles[most]),) if whole[most] >= SHARE * lengths.sum() else ()


def _goes_with(problem: HallProblem, boxes: Floats, heading: float) -> bool:
    """Whether some wall near boxes (n, 5) runs along or across their heading."""
    edges = problem.ground.edges
    edges = edges[np.hypot(*(edges[:, 2:4] - edges[:, :2]).T) >= LONG]
    way = edges[:, 2:4] - edges[:, :2]
    along = np.array([_turn_off(heading, angle) for angle in np.arctan2(way[:, 1], way[:, 0])])
    start, way = edges[np.abs(along) < SQUARE, :2], way[np.abs(along) < SQUARE]
    off = corners(boxes).reshape(-1, 1, 2) - start
    share = (off * way).sum(2) / np.maximum((way**2).sum(1), 1e-12)
    off = off - np.clip(share, 0.0, 1.0)[..., None] * way
    return bool((np.hypot(off[..., 0], off[..., 1]) < CLOSE).any())
