"""Shafts on a plan: what is walled in without a door is hatched, as ducts are."""

from __future__ import annotations

from collections.abc import Sequence

from shapely import Polygon

from scenewright.building.shafts import is_shaft
from scenewright.core.space import Space
from scenewright.drawing.marks import (
    FINE,
    GREY,
    FillPattern,
    Mark,
    PaperView,
    group,
    line,
    shape,
    to_paper,
)

NAMED = 1.0
"""Square metres from which on a shaft is named."""

HATCH, PITCH = "url(#shaft)", 1.6
"""The fill of shafts, and the millimetres between its lines."""


def printed_name(space: Space) -> str:
    """The name of a room on a plan: ``other`` says nothing and is left out; a shaft is called so
    where there is room for the word.

    >>> import numpy as np
    >>> def room(name, wide):
    ...     return Space("r", name, (), "0", np.array([[0, 0], [wide, 0], [wide, 1.0], [0, 1]]))
    >>> [printed_name(room(*r)) for r in (("Study", 3), ("other", 9), ("other", 2), ("other", 0.5))]
    ['Study', '', 'shaft', '']
    """
    name = space.name.strip()
    if is_shaft(space):
        return "shaft" if Polygon(space.outline, space.holes).area >= NAMED else ""
    return "" if name.lower() == "other" else name or space.id


def shafts_mark(view: PaperView, spaces: Sequence[Space]) -> Mark:
    """Floors of shafts, hatched."""
    found = [space for space in spaces if is_shaft(space)]
    rings = [[to_paper(view, ring) for ring in (s.outline, *s.holes)] for s in found]
    return group([shape(ring, fill=HATCH) for ring in rings], fill_rule="evenodd")


def shaft_pattern() -> FillPattern:
    """Thin lines at 45 degrees."""
    stroke = line([(0, 0), (0, PITCH)], fill="none", stroke=GREY, stroke_width=FINE)
    return FillPattern("shaft", PITCH, PITCH, 45.0, "", (stroke,))
