"""Where a stage may stand that its audience is to sit before."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import SINGLE, WALL
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.places import walk_walls
from scenewright.domains.hall.solvers.chains import HallChain, begin_chain
from scenewright.domains.hall.solvers.guided_metropolis import bring_back
from scenewright.domains.hall.solvers.start import copy_frames
from scenewright.domains.hall.terms.state import Kept
from scenewright.engine.draws import streams

AT_WALL = 0.02
"""Gap between a free-standing stage and its wall, in metres."""
WIDE_STAGE, OFF_WALL, OFF_MIDDLE, MOST = 2.0, 0.5, 0.15, 4.0
"""Width from which a stage belongs at the middle of its wall, in metres, what a metre off the wall
and off its middle count, and the metres beyond which more count no more."""
SIDES = (0.0, -1.0, 1.0)
"""Middle and ends of a wall, as rows along walls count them."""


def propose_stages(
    problem: HallProblem, kept: Kept, boxes: Floats, stage: int
) -> Iterator[tuple[Kept, Floats]]:
    """Layouts with the unit of a stage as it stands and elsewhere at the walls of its zone, each
    with the box (5,) it has there."""
    here = kept._replace(pose=kept.pose.copy())
    yield here, boxes[problem.units.spans[stage, 0]]
    code = int(kept.rows[stage, 0])
    if code == SINGLE:
        yield from _stand_free(problem, kept, boxes, stage)
    elif code == WALL:
        yield from _stand_at_walls(problem, kept, stage)


def measure_stage(problem: HallProblem, boxes: Floats, stage: int) -> float:
    """How far the back of a wide stage among boxes (n, 5) is from the middle of a wall of its
    zone, in metres: in the middle of the zone, of the wall where that has no room there."""
    unit = int(problem.units.spans[stage, 0])
    x, y, heading, width, depth = boxes[unit]
    front = np.array([np.cos(heading), np.sin(heading)])
    back = np.array([x, y]) - 0.5 * depth * front
    zone = int(problem.units.zones[stage])
    middle = problem.ground.zone_bounds[zone].reshape(2, 2).mean(0)
    found = [OFF_WALL * MOST] if width >= WIDE_STAGE else [0.0]
    for start, way, left, length in walk_walls(problem, stage):
        if left @ front > 0.99:
            along, off = float((back - start) @ way), float((back - start) @ left)
            centre = float((middle - start) @ way)
            if not 0.5 * width <= centre <= length - 0.5 * width:
                centre = 0.5 * length
            aside = abs(along - centre)
            if 0.0 <= along <= length:
                found.append(OFF_WALL * min(off, MOST) + OFF_MIDDLE * min(aside, MOST))
    return min(found)


def _stand_free(
    problem: HallProblem, kept: Kept, boxes: Floats, stage: int
) -> Iterator[tuple[Kept, Floats]]:
    """With its back at each wall, in the middle of that and of the zone."""
    box, zone = boxes[problem.units.spans[stage, 0]], int(problem.units.zones[stage])
    low, high = problem.ground.zone_bounds[zone].reshape(2, 2)
    for start, way, left, length in walk_walls(problem, stage):
        if length < box[3]:
            continue
        middle = float(
            np.clip((0.5 * (low + high) - start) @ way, 0.5 * box[3], length - 0.5 * box[3])
        )
        for along in sorted({round(middle, 3), round(0.5 * length, 3)}):
            x, y = start + along * way + (0.5 * box[4] + AT_WALL) * left
            placed = np.array([x, y, np.arctan2(left[1], left[0]), *box[3:]])
            moved = kept._replace(pose=kept.pose.copy())
            moved.pose[stage, :3] = placed[:3]
            yield moved, placed


def _stand_at_walls(problem: HallProblem, kept: Kept, stage: int) -> Iterator[tuple[Kept, Floats]]:
    """At the middle and both ends of each wall with room for it, and in the middle of its zone."""
    chain, zone = begin_chain(problem, kept, streams(0, 1)[0]), int(problem.units.zones[stage])
    first, last = chain.p.loop_spans[zone]
    lengths = chain.s.stretches[chain.p.loops[first:last], 4].copy()
    middle = problem.ground.zone_bounds[zone].reshape(2, 2).mean(0)
    for along in np.cumsum(lengths) - 0.5 * lengths:
        centre, end = (_place(chain, kept, stage, along, side)[1][:2] for side in SIDES[::2])
        way = end - centre
        part = float((middle - centre) @ way) / max(float(way @ way), 1e-9)
        for side in (*SIDES, *((part,) if abs(part) < 1.0 else ())):
            yield _place(chain, kept, stage, along, side)


def _place(
    chain: HallChain, kept: Kept, stage: int, along: float, side: float
) -> tuple[Kept, Floats]:
    """A stage ``along`` metres down the walls of its zone, and the box (5,) it has there."""
    moved = kept._replace(pose=kept.pose.copy())
    moved.pose[stage, :2] = along, side
    bring_back(chain.p, chain.s, chain.work, moved)
    boxes = np.zeros((len(chain.p.sizes), 5))
    copy_frames(chain.s, boxes)
    return moved, boxes[int(chain.problem.units.spans[stage, 0])]
