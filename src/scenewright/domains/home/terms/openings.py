"""Terms of openings: furniture before windows and before wide doors and passages."""

from __future__ import annotations

from scenewright.geometry.boxes import Floats, Frame, common_area, read_frame
from scenewright.geometry.compiled import inlined

FIRST = 0.1
"""Metres of an opening that count double, the first: something before its edge is seen at once."""


@inlined
def covered_width(frame: Frame, strips: Floats, kind: float) -> float:
    """Σ m + min(m, 0.1) / 0.1: metres m of each opening of a kind that an item stands before, and
    1 more from the first decimetre on.

    ``strips`` (k, 10) are frames of the floor before openings, the kind (0 a door or passage, 1 a
    window) and their depth in metres; m is the area shared with the item over that depth. In the
    hard zone before a door (``keep_free``) nothing stands; this asks for all of its width.
    """
    total = 0.0
    for k in range(strips.shape[0]):
        if strips[k, 8] == kind:
            width = common_area(frame, read_frame(strips, k)) / strips[k, 9]
            total += width + min(width, FIRST) / FIRST
    return total
