"""The walls of a room on which something can hang: not the chords across its curves."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from scenewright.core.same import once
from scenewright.domains.home.problem import Ground
from scenewright.geometry.arcs import true_walls


@once(64)
def hanging_walls(ground: Ground) -> NDArray[np.float64]:
    """The walls ``(w, 4)`` of a ground that are no chords, or chords of nearly straight curves; of
    the same ground found once."""
    return true_walls(ground.walls, ground.edges)
