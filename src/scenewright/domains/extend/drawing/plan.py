"""The plan of an extension to print, to scale, north up: old buildings in grey, what is new in
colour.

Ground, streets old and new, buildings with their fronts and the letters of their kinds; what the
referee finds in red. Beside it the legend and the figures.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from scenewright.core.piece_outlines import outline_of, polygons_of
from scenewright.core.plan import Plan
from scenewright.core.report import Report
from scenewright.core.scene import GroundSurface, Piece
from scenewright.core.solution import Solution
from scenewright.domains.extend.areas import OLD, ExtendPlan
from scenewright.domains.extend.drawing import marks
from scenewright.domains.extend.works import lay_walks, plots_of_extension
from scenewright.drawing.ground_sheet import (
    draw_ground_sheet,
    figure_rows,
    is_drawable,
    paving_mark,
)
from scenewright.drawing.houses import FAULT, LEAF, faults_mark, houses_mark, trees_mark, words_mark
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.legend import LegendRow
from scenewright.drawing.marks import PaperView, clean
from scenewright.drawing.plots import plots_mark
from scenewright.geometry.folding import fold, show
from scenewright.ground.buildings.built import BuiltFrames
from scenewright.ground.buildings.rows import find_rows, string_of
from scenewright.ground.streetside.plots import Plot
from scenewright.ground.ways.surfaces import surfaces
from scenewright.text import quantity

LISTED, ROWS = 20, 4
"""Most kinds and rows listed."""


def draw(solution: Solution, made: Plan, judge: Callable[[], Report]) -> PlanDrawing:
    """The plan of a solution's areas and sources; ``judge`` gives the referee's report."""
    plan: ExtendPlan = made.detail
    report, trees = judge(), [p for p in solution.pieces if p.category == "tree"]
    houses = [p for p in solution.pieces if is_drawable(p)]
    plots, works = plots_of_extension(solution, made), lay_walks(plan, solution.pieces)
    laid = surfaces((plan.ground,), (works,), polygons_of(houses))
    return draw_ground_sheet(
        solution,
        _bounds(plan, houses),
        _summary(plan, houses, report),
        _legend(plan, houses, report, bool(trees)),
        lambda view: _layers(view, plan, laid, houses, report, plots, trees),
    )


def _bounds(plan: ExtendPlan, houses: Sequence[Piece]) -> tuple[float, float, float, float]:
    rings = [np.array(area.outline.exterior.coords) for area in plan.areas]
    rings += [outline_of(piece) for piece in houses]
    corners = np.vstack(rings)
    (west, south), (east, north) = (corners.min(0) - 6).tolist(), (corners.max(0) + 6).tolist()
    return west, south, east, north


def _layers(
    view: PaperView,
    plan: ExtendPlan,
    laid: Sequence[GroundSurface],
    houses: Sequence[Piece],
    report: Report,
    plots: Sequence[Plot],
    trees: Sequence[Piece],
) -> list[PlanLayer]:
    """The scene on paper, from the ground up."""
    old = [piece for piece in houses if piece.space == OLD]
    new = [piece for piece in houses if piece.space != OLD]
    return [
        *(PlanLayer("Ground", marks.ground_mark(view, area)) for area in plan.areas),
        PlanLayer("Streets", marks.streets_mark(view, plan.ground.roads)),
        PlanLayer("Kerbs", paving_mark(view, laid, marks.KERBS, "kerb")),
        PlanLayer("Plots", plots_mark(view, plots)),
        PlanLayer("Old buildings", houses_mark(view, old, marks.fill_of)),
        PlanLayer("New buildings", houses_mark(view, new, marks.fill_of)),
        PlanLayer("Trees", trees_mark(view, trees)),
        PlanLayer("Kinds", words_mark(view, houses, lambda piece: piece.function[:4], marks.LABEL)),
        *(PlanLayer("Border", marks.border_mark(view, area)) for area in plan.areas),
        PlanLayer("Violations", faults_mark(view, houses, report.findings)),
    ]


def _legend(
    plan: ExtendPlan, houses: Sequence[Piece], report: Report, planted: bool
) -> tuple[LegendRow, ...]:
    """Signs that occur, the kinds by letter with how many are old and new, figures."""
    rows = [LegendRow("heading", "Legend")]
    used = {marks.fill_of(piece) for piece in houses}
    rows += [LegendRow("swatch", w, value=colour) for w, colour in marks.FILLS if colour in used]
    rows.append(LegendRow("entrance", "Front"))
    rows += [LegendRow("swatch", "Tree", value=LEAF)] * planted
    if report.findings:
        rows.append(LegendRow("swatch", "Violation", value=FAULT))
    rows += _kinds(houses)
    rows += _strings(plan)
    for area in plan.areas[:4]:
        heading = clean(area.name, 40) if len(plan.areas) > 1 else "Figures"
        rows += _figures(heading, report.figures["areas"][area.id])
    return tuple(rows)


def _kinds(houses: Sequence[Piece]) -> list[LegendRow]:
    old = Counter(p.function for p in houses if p.space == OLD)
    new = Counter(p.function for p in houses if p.space != OLD)
    names = sorted({*old, *new}, key=lambda name: (-old[name] - new[name], len(name), name))
    rows = [LegendRow("heading", "Kinds, old + new")]
    for name in names[:LISTED]:
        rows.append(LegendRow("letter", _size(houses, name), f"{old[name]} + {new[name]}", name))
    if len(names) > LISTED:
        rows.append(LegendRow("", f"{len(names) - LISTED} more kinds"))
    return rows


def _strings(plan: ExtendPlan) -> list[LegendRow]:
    """The longest rows of the sources as folded strings."""
    letters = [kind.letter for kind in plan.pattern.kinds]
    named = [letters[k] for k in plan.pattern.kind.tolist()]
    frames = BuiltFrames(plan.pattern.boxes, plan.pattern.shapes, plan.pattern.boxes[:, 3])
    found = [show(fold(string_of(row, named))) for row in find_rows(frames)[:ROWS]]
    if not found:
        return []
    heading = LegendRow("heading", "Rows of the source")
    return [heading, *(LegendRow("", clean(text, 46)) for text in found)]


def _size(houses: Sequence[Piece], name: str) -> str:
    size = next(piece.size for piece in houses if piece.function == name)
    return f"{size.width:.1f} x {size.depth:.1f} m, {size.height:.1f} m high"


def _figures(heading: str, found: dict[str, Any]) -> list[LegendRow]:
    gap = found["median_gap"]
    figures = [
        ("Ground", f"{found['area']:,.0f} m²"),
        ("Buildings", f"{found['buildings']}"),
        ("Coverage", f"{found['coverage']:.0%}"),
        ("Coverage of the source", f"{found['source_coverage']:.0%}"),
        ("Distance to the nearest, median", "–" if gap is None else f"{gap:.1f} m"),
        ("Streets continued", f"{found['streets_continued']}"),
    ]
    return figure_rows(heading, figures)


def _summary(plan: ExtendPlan, houses: Sequence[Piece], report: Report) -> str:
    area = sum(one.outline.area for one in plan.areas)
    old = sum(piece.space == OLD for piece in houses)
    faults = sum(found.is_blamed for found in report.findings)
    parts = [f"{area / 1e4:.2f} ha", quantity(len(houses) - old, "new building"), f"{old} old"]
    parts += [quantity(faults, "violation")] if faults else []
    return " · ".join(["Extension plan", *parts])
