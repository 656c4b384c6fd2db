"""The plan of a village to print, to scale, north up: all blocks in one drawing.

Ground, lanes and street sides, yards and walks, houses by class of area with their doors, trees;
what the referee finds in red. Beside it the legend with the houses used and the figures.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from scenewright.core.piece_outlines import outline_of
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.scene import Piece
from scenewright.core.solution import Solution
from scenewright.domains.village.blocks import VillagePlan
from scenewright.domains.village.drawing import marks as marks
from scenewright.domains.village.gardens import lay_ground
from scenewright.domains.village.lanes import opened
from scenewright.domains.village.plots import lay_block_plots
from scenewright.drawing.ground_sheet import (
    draw_ground_sheet,
    figure_rows,
    is_drawable,
    paving_mark,
)
from scenewright.drawing.houses import FAULT, faults_mark, houses_mark, trees_mark, words_mark
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.marks import PaperView, clean
from scenewright.drawing.plots import BORDER, plots_mark
from scenewright.text import quantity

LISTED = 30
"""Most houses listed."""


def draw(solution: Solution, made: Plan, judge: Callable[[], Report]) -> PlanDrawing:
    """The plan of a solution's blocks; ``judge`` gives the referee's report."""
    village: VillagePlan = opened(made, solution).detail
    report = judge()
    houses = [p for p in solution.pieces if is_drawable(p)]
    numbers = number_houses(houses)
    return draw_ground_sheet(
        solution,
        _bounds(village, houses),
        _summary(village, houses, report),
        legend(village, houses, numbers, report),
        lambda view: _layers(view, solution, village, houses, numbers, report),
    )


def number_houses(houses: Sequence[Piece]) -> dict[str, int]:
    """A number for every house of the library that is used, the most frequent first."""
    counts = Counter(piece.function for piece in houses)
    return {name: number for number, (name, _) in enumerate(counts.most_common(), 1)}


def _bounds(village: VillagePlan, houses: Sequence[Piece]) -> tuple[float, float, float, float]:
    """The drawing: blocks, and houses not farther outside than the village is long."""
    low = np.min([b.outline.min(0) for b in village.blocks], 0)
    high = np.max([b.outline.max(0) for b in village.blocks], 0)
    reach = float((high - low).max()) / 2
    rings = [outline_of(p) for p in houses]
    near = [r for r in rings if (r > low - reach).all() and (r < high + reach).all()]
    corners = np.vstack([low, high, *near])
    (west, south), (east, north) = (corners.min(0) - 4).tolist(), (corners.max(0) + 4).tolist()
    return west, south, east, north


def _layers(
    view: PaperView,
    solution: Solution,
    village: VillagePlan,
    houses: Sequence[Piece],
    numbers: dict[str, int],
    report: Report,
) -> list[PlanLayer]:
    """The village on paper, from the ground up."""
    surfaces = lay_ground(village, solution.pieces, solution.patches)
    fills = marks.PAVING
    trees = [p for p in solution.pieces if p.category == "tree"]
    plots = [
        plot
        for block in village.blocks
        for plot in lay_block_plots(village, block, solution.pieces, solution.patches)
    ]
    blocks = village.blocks

    def number_of(piece: Piece) -> str:
        return str(numbers[piece.function])

    found = [*(PlanLayer("Ground", marks.ground_mark(view, block)) for block in blocks)]
    found += [
        PlanLayer("Yards and walks", paving_mark(view, surfaces, fills, "yard", "square", "walk")),
        PlanLayer("Lanes", paving_mark(view, surfaces, fills, "path", "asphalt")),
        PlanLayer("Walls, hedges and beds", paving_mark(view, surfaces, fills, *marks.ENCLOSING)),
        PlanLayer("Plots", plots_mark(view, plots)),
        *(PlanLayer("Street sides", marks.streets_mark(view, block)) for block in blocks),
        PlanLayer("Names of lanes", marks.names_mark(view, village.lanes)),
        PlanLayer("Trees", trees_mark(view, trees)),
        PlanLayer("Houses", houses_mark(view, houses, marks.fill_of, named=True)),
        PlanLayer("Numbers", words_mark(view, houses, number_of, marks.LABEL)),
        PlanLayer("Violations", faults_mark(view, houses, report.findings)),
    ]
    return found


def legend(
    village: VillagePlan, houses: Sequence[Piece], numbers: dict[str, int], report: Report
) -> tuple[LegendRow, ...]:
    """Signs that occur, the houses by number, the figures of each block."""
    rows = [LegendRow("heading", "Legend")]
    used = {marks.fill_of(piece) for piece in houses}
    rows += [LegendRow("swatch", w, value=colour) for w, colour in marks.CLASSES if colour in used]
    if marks.KEPT in used:
        rows.append(LegendRow("swatch", "House that stays", value=marks.KEPT))
    rows.append(LegendRow("swatch", "Street side", value=marks.STREET))
    rows.append(LegendRow("swatch", "Border of a plot", value=BORDER))
    rows.append(LegendRow("entrance", "Door"))
    if report.findings:
        rows.append(LegendRow("swatch", "Violation", value=FAULT))
    counts = Counter(piece.function for piece in houses)
    rows.append(LegendRow("heading", "Houses"))
    rows += [
        LegendRow("letter", clean(name, 40), f"{counts[name]} ×", str(number))
        for name, number in list(numbers.items())[:LISTED]
    ]
    for block in village.blocks[:6]:
        heading = clean(block.name, 40) if len(village.blocks) > 1 else "Figures"
        rows += _figures(heading, report.figures["blocks"][block.id])
    return tuple(rows)


def _figures(heading: str, found: dict[str, Any]) -> list[LegendRow]:
    figures = [
        ("Ground", f"{found['area']:,.0f} m²"),
        ("Houses", f"{found['houses']}"),
        ("Coverage", f"{found['coverage']:.0%}"),
        ("Distance to the nearest, median", _metres(found["median_gap"])),
        ("Distance to the street, median", _metres(found["median_setback"])),
        ("Reached from a street", f"{found['reached_share']:.0%}"),
    ]
    return figure_rows(heading, figures)


def _metres(value: float | None) -> str:
    return "–" if value is None else f"{value:.1f} m"


def _summary(village: VillagePlan, houses: Sequence[Piece], report: Report) -> str:
    area = sum(block.area for block in village.blocks)
    faults = sum(found.is_blamed for found in report.findings)
    parts = [f"{area / 1e4:.2f} ha", quantity(len(houses), "house")]
    parts += [f"{len(village.blocks)} blocks"] if len(village.blocks) > 1 else []
    parts += [quantity(faults, "violation")] if faults else []
    return " · ".join(["Village plan", *parts])
