"""Rugs of a sofa that came without one: a little under it, before its middle or, where it stands in
a corner, from where it ends to beyond its other side."""

from __future__ import annotations

from itertools import product
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.domains.home.measures import TUCKED

Floats = NDArray[np.float64]

BEYOND = (0.6, 0.4, 0.2)  # by which a rug before a sofa is wider than it, metres
DEPTHS = (1.6, 1.4, 1.2, 1.0, 0.8)  # of that rug, metres
SIDES = (0.0, 0.5, -0.5)  # and lies by this share of what it is wider to the left of its middle
LOW_TABLE = "coffee_table"  # stands wholly on such a rug, or not at all
WELL_ON = 0.15  # of a rug reaches beyond a table that stands on it, metres


def list_sofa_rugs(sofa: Piece) -> Floats:
    """Boxes (n, 5) of rugs of a sofa, the best first: before its middle, then to either side, the
    largest first.

    >>> from scenewright.core.scene import Pose, Size
    >>> sofa = Piece("s", "sofa", "", "a", Pose(0.0, 0.0, 0.0, 0.0), Size(2.0, 0.9, 0.8))
    >>> list_sofa_rugs(sofa)[0].round(2).tolist()
    [1.05, 0.0, 0.0, 2.6, 1.6]
    """
    (x, y, _, heading), half = sofa.pose, sofa.size.depth / 2 - TUCKED
    rows = np.array([(half + d / 2, s * m, m, d) for s, d, m in product(SIDES, DEPTHS, BEYOND)])
    out, aside, more, deep = rows.T
    c, s = cos(heading), sin(heading)
    turn = np.full(len(rows), heading)
    return np.column_stack(
        [x + c * out - s * aside, y + s * out + c * aside, turn, sofa.size.width + more, deep]
    )


def stands_well(table: Piece, rug: Floats) -> bool:
    """Whether a table stands on a rug (5,) with :data:`WELL_ON` all round, or beside it."""
    c, s = cos(rug[2]), sin(rug[2])
    off = outline_of(table) - rug[:2]
    beyond = np.maximum(np.abs(off @ (s, -c)) - rug[3] / 2, np.abs(off @ (c, s)) - rug[4] / 2)
    return bool((beyond <= -WELL_ON).all() or (beyond > 0.0).all())
