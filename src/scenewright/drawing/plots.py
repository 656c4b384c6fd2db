"""Plots in a plan: their borders, dashed, with their square metres."""

from __future__ import annotations

from collections.abc import Iterable

from scenewright.drawing.marks import FINE, Mark, PaperView, group, shape, title, to_paper
from scenewright.ground.streetside.plots import Plot

BORDER = "#6f7f5a"


def plots_mark(view: PaperView, plots: Iterable[Plot]) -> Mark:
    """The borders of plots."""
    marks = [
        group([title(f"plot of {row.area:.0f} m²"), shape([to_paper(view, row.outline)])])
        for row in plots
    ]
    return group(marks, fill="none", stroke=BORDER, stroke_width=FINE, stroke_dasharray="1.2 0.8")
