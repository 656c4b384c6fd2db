"""The sheet of a plan of open ground, north up: the drawing in the middle of its room, the legend
beside or below it; and which buildings can be drawn."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from scenewright.core.scene import GroundSurface, Piece
from scenewright.core.solution import Solution
from scenewright.drawing import sheet as sheets
from scenewright.drawing.layers import PlanDrawing, PlanLayer, merge_layers
from scenewright.drawing.legend import LegendRow, arrange, legend_mark
from scenewright.drawing.marks import Mark, PaperView, group, shape, to_paper

MARGIN, LARGE = 6.0, 1000
"""Millimetres around the drawing; the scale from which papers above A3 are used."""
FAR = 1e5
"""Metres from (0, 0) beyond which nothing is drawn."""


def draw_ground_sheet(
    solution: Solution,
    bounds: Sequence[float],
    summary: str,
    legend: Sequence[LegendRow],
    layers_of: Callable[[PaperView], list[PlanLayer]],
) -> PlanDrawing:
    """A plan of what lies within ``bounds`` (west, south, east, north), in metres: ``layers_of``
    draws it on paper, ``legend`` and ``summary`` tell it."""
    west, south, east, north = bounds
    size, extra = (east - west, north - south), (2 * MARGIN, 2 * MARGIN)
    arranged = arrange(size, extra, legend, LARGE)
    sheet, (wide, high) = arranged.sheet, arranged.room
    scale = 1000 / sheet.scale
    left = sheets.EDGE + (wide - (east - west) * scale) / 2
    bottom = sheets.EDGE + (high + (north - south) * scale) / 2
    view = sheets.view_at(sheet, west, south, left, bottom)
    name, title = solution.brief.name, sheets.title_of(solution.brief)
    layers = [
        [PlanLayer("Sheet", sheets.sheet_mark(sheet, name, summary, title))],
        layers_of(view),
        [PlanLayer("Legend", legend_mark(arranged))],
    ]
    return PlanDrawing(name, sheet, (), merge_layers(layers), view)


def paving_mark(
    view: PaperView, rows: Sequence[GroundSurface], fills: Mapping[str, str], *kinds: str
) -> Mark:
    """What lies on the ground, of some ``kinds``, one over the other, each in its colour."""
    return group(
        [
            shape([to_paper(view, ring) for ring in (outline, *holes)], fill=fills[kind])
            for kind in kinds
            for row in rows
            if row.kind == kind
            for outline, holes in row.areas
        ],
        fill_rule="evenodd",
    )


def is_drawable(piece: Piece) -> bool:
    """Whether a piece is a building at a place that can be drawn."""
    whole = np.isfinite([*piece.pose, *piece.size]).all()
    return piece.category == "building" and bool(whole) and max(map(abs, piece.pose[:2])) < FAR


def figure_rows(heading: str, figures: Sequence[tuple[str, Any]]) -> list[LegendRow]:
    """A heading and its figures."""
    return [LegendRow("heading", heading), *(LegendRow("", w, right) for w, right in figures)]
