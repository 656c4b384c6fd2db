"""Where wheelchairs turn, in plan: a dashed circle of 1.5 m in every room that has room for it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from scenewright.core.report import Report
from scenewright.drawing.marks import (
    LINE,
    ROUTE,
    Mark,
    PaperView,
    Style,
    disc,
    group,
    plate,
    to_paper,
)

DIAMETER = 1.5
WORD = 1.9
"""Height of the figure in the circle, millimetres."""

Turns = Mapping[str, tuple[float, float]]
"""Middles of turning circles by space, metres."""


def turning_of(report: Report) -> Turns:
    """Where the referee found room to turn in the rooms of an accessible home."""
    found = report.figures.get("turning", {})
    return {space: (float(x), float(y)) for space, (x, y) in found.items()}


def turning_mark(view: PaperView, middles: Iterable[tuple[float, float]]) -> Mark:
    """Circles with their diameter."""
    marks = []
    for middle in middles:
        x, y = to_paper(view, middle)
        radius = DIAMETER / 2 * view.scale
        pen: Style = {"stroke": ROUTE, "stroke_width": LINE, "stroke_dasharray": "1.6 0.9"}
        marks.append(disc((x, y), radius, fill="none", **pen))
        foot = (x, y + radius - 0.9 * WORD)
        marks.append(plate(f"\u2300 {DIAMETER:.2f}", foot, WORD, fill=ROUTE))
    return group(marks)
