"""Locked objects: which of them a route leads to where nothing else stands."""

from __future__ import annotations

import math

from scenewright.domains.hall.terms.state import Floats
from scenewright.geometry.boxes import read_frame, read_sides
from scenewright.geometry.circulation import is_reached, route
from scenewright.geometry.compiled import compiled
from scenewright.geometry.flood import Bits
from scenewright.geometry.paths import RouteGrid


@compiled
def find_reached(
    frames: Floats,
    access: Floats,
    none: Floats,
    grid: RouteGrid,
    free: Bits,
    reached: Bits,
    found: Floats,
) -> None:
    """Write to ``found`` (k,) 1 for each of some frames (k, 8) with sides of use ``access`` (k, 4)
    that a route comes to, else 0; ``none`` (0, 8), ``free`` and ``reached`` (h, w) are scratch."""
    route(none, none, none, grid, free, reached, math.inf)
    for k in range(frames.shape[0]):
        beside = is_reached(read_frame(frames, k), read_sides(access, k), reached, grid)
        found[k] = 1.0 if beside else 0.0
