"""Distances and tolerances that several rules of homes go by. Said once, each with its reason."""

from __future__ import annotations

HAIR = 1e-6
"""What two lengths, metres, or costs may differ by and still be one."""
ROUNDING = 1e-9
"""What sums of floating-point numbers differ by where their terms are the same."""
ALIKE = 0.99
"""The cosine, at least, between headings that are taken for one: 8 degrees."""
RAISED = 0.3
"""Height of the underside, metres, from which a piece is on another or hangs: no unit of a run,
and it fills no floor. Lower than any worktop, higher than any plinth."""
ON_FLOOR = 0.12
"""What begins higher, metres, leaves the floor free: it stands on something, on legs, or hangs."""
AT_WALL = 0.12
"""What is nearer, metres, stands at its wall."""
HEAD_HEIGHT = 2.0
"""What begins above, metres, is in nobody's way: the least headroom of stairs and doors."""
FLATTEST = 0.05
"""What lies flat and is no thicker, metres, is walked on: a rug."""
TUCKED = 0.2
"""What of a rug lies under a bed or a sofa, and of a chair under its table, metres."""
NARROWER = 0.08
"""Metres by which ways on a grid of 0.04 m are narrower, so that it bars no more than an exact
walk: two cells."""
SOFA_OF_THREE = 1.9
"""The width of a sofa for three, metres: three seats of 0.55 m and two arms."""
