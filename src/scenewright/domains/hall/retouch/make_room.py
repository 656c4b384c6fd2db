"""Room for what a retouch moves: the groups that stand where it is to go find other places."""

from __future__ import annotations

import numpy as np
import shapely

from scenewright.core.layout import corners
from scenewright.domains.hall.energy import kept_of
from scenewright.domains.hall.patterns import WALL
from scenewright.domains.hall.problem import Ints
from scenewright.domains.hall.solvers.chains import HallChain
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.start import copy_frames, place_units
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.table import FACING

MOST, DRAWN, TRIES, SETTLED = 4, 40, 60, 2
"""Groups that give way at most, how often new places are drawn for them, tries each time, and how
many of the layouts drawn are settled."""
SHARED_FLOOR, SHARED = 0.05, 0.15
"""Square metres a footprint and the free floor of another may share, and the part for which what
two free floors share counts."""
TURNED_MORE = 0.3
"""By how much of the term that gave way may look away from what it looks at."""
STEPS = (0.6, 0.3, 0.15)
"""Metres by which what gave way is moved on for less energy."""


def make_room(chain: HallChain, before: Kept, kept: Kept, yielding: list[int]) -> list[Kept]:
    """Layouts like ``kept`` in which the units ``yielding`` (:func:`find_yielding`) stand
    elsewhere, in the form they have or in another."""
    p, s, work = chain.p, chain.s, chain.work
    bring_back(p, s, work, before)
    facing = s.costs[FACING].copy()
    bring_back(p, s, work, kept)
    count, looked = len(p.spans), facing[yielding]
    standing = [u for u in range(count) if u not in yielding]
    order = np.array([*standing, *yielding], np.int64)
    found: list[tuple[float, int, Kept]] = []
    for drawn in range(DRAWN):
        bring_back(p, s, work, kept)
        placed = np.zeros(count)
        place_units(p, s, work, order, len(standing), TRIES, drawn % 2 == 1, chain.stream, placed)
        if not placed[standing].all():
            break
        if placed.all():
            one = kept_of(s)
            energy = bring_back(p, s, work, one)
            if (s.costs[FACING, yielding] <= looked + TURNED_MORE).all():
                found.append((energy, drawn, one))
    return [_settle(chain, one, yielding) for _, _, one in sorted(found)[:SETTLED]]


def find_yielding(chain: HallChain, before: Kept, kept: Kept, firm: list[int]) -> list[int]:
    """The units in the way of what ``kept`` moves, which stands in the chain; none if more than
    ``MOST`` of them are or one of the ``firm`` ones."""
    found = _in_the_way(chain, _moved(before, kept))
    return [] if len(found) > MOST or set(found) & set(firm) else found


def _settle(chain: HallChain, kept: Kept, units: list[int]) -> Kept:
    """The layout with some units moved a little, each way for as long as it lowers the energy."""
    least = bring_back(chain.p, chain.s, chain.work, kept)
    for step in STEPS:
        for unit in units:
            for way in ((1, 0), (-1, 0), (0, 1), (0, -1)):
                for _ in range(0 if kept.rows[unit, 0] == WALL else 8):
                    tried = kept._replace(pose=kept.pose.copy())
                    tried.pose[unit, :2] += step * np.array(way)
                    energy = bring_back(chain.p, chain.s, chain.work, tried)
                    if energy >= least:
                        break
                    kept, least = tried, energy
    return kept


def _moved(before: Kept, kept: Kept) -> list[int]:
    """The units that stand elsewhere."""
    other = (before.pose != kept.pose).any(1) | (before.rows != kept.rows).any(1)
    return [int(unit) for unit in np.flatnonzero(other)]


def _in_the_way(chain: HallChain, moved: list[int]) -> list[int]:
    """The units on the floor ``moved`` ones stand on or need free, or that need theirs."""
    boxes = np.zeros((len(chain.p.sizes), 5))
    copy_frames(chain.s, boxes)
    clears = chain.s.clears[:, [0, 1, 7, 4, 5]] * (1.0, 1.0, 1.0, 2.0, 2.0)
    stand, need = shapely.polygons(corners(boxes)), shapely.polygons(corners(clears))
    mine = _owned(chain.p.spans, moved)
    taken, kept_free = shapely.union_all(stand[mine]), shapely.union_all(need[mine])
    shared = SHARED * shapely.area(shapely.intersection(need, kept_free))
    for shapes, others in ((stand, kept_free), (need, taken)):
        shared = np.maximum(shared, shapely.area(shapely.intersection(shapes, others)))
    return [
        unit
        for unit, (first, last) in enumerate(chain.p.spans)
        if unit not in moved and (shared[first:last] > SHARED_FLOOR).any()
    ]


def _owned(spans: Ints, units: list[int]) -> Ints:
    """The rows of the objects of some units."""
    rows = [np.arange(*spans[unit]) for unit in units]
    return np.concatenate([np.zeros(0, np.int64), *rows])
