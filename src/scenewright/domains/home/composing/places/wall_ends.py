"""Places at the ends of free stretches of walls: beside a door, a window, or a piece.

Places along a wall are counted from its corners, a step apart (:mod:`..wall_places`). A stretch
between two doors that is a hair longer than a bed holds it in one place only, which lies between
two such steps.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.catalog import Group
from scenewright.domains.home.attempts.attempt import RoomTask
from scenewright.domains.home.composing.places.wall_stretch import list_free_stretches, list_taken
from scenewright.domains.home.furnishing.obstacles import StandingObstacles
from scenewright.domains.home.furnishing.whole import list_grounded
from scenewright.domains.home.grounds.wall_places import stand_free

Floats = NDArray[np.float64]

NOWHERE: Floats = np.empty((0, 5))


def list_wall_ends(task: RoomTask, case: Group, standing: StandingObstacles) -> Floats:
    """The boxes (n, 5) of a case at either end of every free stretch of a wall on which it stands
    free."""
    height = max(member.size.height for member in case.members)
    taken = list_taken(task.ground, standing, NOWHERE, height)
    stretches = list_free_stretches(task.ground, case.depth, taken, case.width)
    ends = [s.boxes_at(np.array([0.0, s.length - case.width]), case) for s in stretches]
    boxes, height = np.concatenate([NOWHERE, *ends]), task.space.height
    grounded = list_grounded(case)
    return boxes[stand_free(boxes, case, grounded, task.ground, standing, task.catalog, height)]
