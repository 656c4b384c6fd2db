"""A room as the paper's problem (Liu et al. 2017): its seven costs and nothing of ours.

Every patch belongs to a wall (C5), a pair has one distance, one angle and the weight 1 (C6), sizes
range over all cases of a group (3.3.1), and the floor is all of the room (C7). A door has one area
(C3): the quarter disc that its leaf sweeps, or where none swings in, its threshold. What fixed
pieces and radiators ask for, places, and a room's own weights are ours and left out. Of its pairs
the paper names one, media and seating face to face at 2.5 m; the others are those of ours that have
both a distance and an angle.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.building.door_approach import door_zone, gates, has_leaf, landing, sweep_strips
from scenewright.core.space import Space
from scenewright.domains.home.build_problem import NAN, Relation, relate, select_allowed
from scenewright.domains.home.cases.library import SHIPPED, Library, cases
from scenewright.domains.home.problem import Ground, Items, Problem
from scenewright.domains.home.programme import Wish

Floats = NDArray[np.float64]
PAIRS: tuple[Relation, ...] = (
    Relation("seating", "media", 2.5, np.pi, 0.0, 1.0),
    Relation("sleeping", "media", 2.8, np.pi, 0.0, 1.0, "seating"),
    Relation("kitchenette", "fridge", 1.2, 0.0, NAN, 1.0),
)
"""The bearings count in the repaired form alone."""
NEAR = 0.1
"""d_max of C5, metres."""


def as_in_paper(
    problem: Problem, wishes: tuple[Wish, ...], space: Space, library: Library = SHIPPED
) -> Problem:
    """The problem of placing the same wishes in the same room as the paper states it."""
    return problem._replace(
        ground=empty_floor(problem.ground)._replace(keep_free=door_areas(space)),
        items=paper_items(problem.items, wishes, library),
        flush=NEAR,
    )


def door_areas(space: Space) -> Floats:
    """The areas D (k, 5) of C3 as boxes that do not overlap: of a leaf that swings in, strips as
    large together as the quarter disc; of other doors, and of stairs, the floor before them."""
    doors = [gate for gate in gates(space) if gate.opening.kind != "window"]
    boxes = [
        *(
            box
            for gate in doors
            for box in (sweep_strips(gate) if has_leaf(gate) else door_zone(space, gate))
        ),
        *map(landing, space.stairs),
    ]
    return np.array(boxes, np.float64).reshape(-1, 5)


def empty_floor(ground: Ground) -> Ground:
    """The ground without what the paper does not know of, A(R) being the whole floor."""
    edges, none = ground.edges, np.zeros((0, 5))
    area = 0.5 * float((edges[:, 0] * edges[:, 3] - edges[:, 2] * edges[:, 1]).sum())
    return ground._replace(area=area, use_space=none, fronts=none)


def paper_items(items: Items, wishes: tuple[Wish, ...], library: Library = SHIPPED) -> Items:
    """Items that each belong to a wall, as large as any case of their group, pairs weighing 1."""
    sizes = [cases(w.group, library).sizes[select_allowed(w, library)] for w in wishes]
    pairs, targets, weights = relate([w.group for w in wishes], library, PAIRS)
    return items._replace(
        low=np.array([found.min(0) for found in sizes]).reshape(-1, 2),
        high=np.array([found.max(0) for found in sizes]).reshape(-1, 2),
        back_to_wall=np.ones(len(wishes)),
        pairs=pairs,
        pair_targets=targets,
        pair_weights=weights,
    )
