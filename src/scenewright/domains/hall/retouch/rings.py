"""Rings of exhibits about the main exhibit of their zone: one middle for both."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from scenewright.domains.hall.patterns import ACROSS, CODE, NUMBER, PART, RADIATION
from scenewright.domains.hall.problem import Floats, HallProblem
from scenewright.domains.hall.retouch.lines import count_objects, find_layers
from scenewright.domains.hall.terms.state import Kept
from scenewright.domains.hall.terms.visitors import MAIN

FEWEST, WIDER = 5, (0.0, 0.5, 1.0, 2.0)
"""Fewest exhibits of a ring about another, and by how many metres it is made wider than it must
be."""
SHIFTS = (-1.5, -0.75, 0.0, 0.75, 1.5)


def find_ring(problem: HallProblem, kept: Kept) -> tuple[int, int, int] | None:
    """The main exhibit, the largest unit of its zone that stands in rings, and its first layer."""
    roles = problem.visitors.roles.astype(int)
    mains = [unit for unit in range(len(roles)) if roles[unit] & MAIN]
    if not mains:
        return None
    sizes, zones = count_objects(problem), problem.units.zones
    rings = [
        unit
        for unit in range(len(roles))
        if zones[unit] == zones[mains[0]]
        and sizes[unit] >= FEWEST
        and int(kept.rows[unit, 0]) == RADIATION
    ]
    if not rings:
        return None
    ring = max(rings, key=lambda unit: int(sizes[unit]))
    return mains[0], ring, find_layers(problem, ring)[0]


def propose_rings(problem: HallProblem, kept: Kept, boxes: Floats) -> Iterator[Kept]:
    """Layouts with the main exhibit in the middle of one ring, about the middle of their zone."""
    found = find_ring(problem, kept)
    if found is None:
        return
    main, ring, layer = found
    first, last = problem.units.spans[ring]
    width, depth = boxes[int(problem.units.spans[main, 0]), 3:]
    wide, deep = problem.units.sizes[first:last].max(0)
    clear = float(problem.units.clear[first:last].max())
    inside = 0.5 * np.hypot(width, depth) + clear + 0.5 * deep
    number = int(last - first)
    beside = 0.5 * (wide + clear) / np.sin(np.pi / number)
    spots = [_middle(problem, int(problem.units.zones[main])), kept.pose[main, :2]]
    for spot in spots:
        for dx in SHIFTS:
            for dy in SHIFTS:
                for wider in WIDER:
                    pose, layers, rows = kept.pose.copy(), kept.layers.copy(), kept.rows.copy()
                    pose[[main, ring], :2] = spot + np.array([dx, dy])
                    layers[layer, [NUMBER, ACROSS]] = number, max(inside, beside) + wider
                    layers[layer, [CODE, PART]], rows[ring, 1] = (RADIATION, 0), 1
                    yield kept._replace(pose=pose, layers=layers, rows=rows)


def _middle(problem: HallProblem, zone: int) -> Floats:
    """The middle of the bounds of a zone."""
    bounds = problem.ground.zone_bounds[zone]
    return np.array([0.5 * (bounds[0] + bounds[2]), 0.5 * (bounds[1] + bounds[3])])
