"""Marks of a village plan: ground, lanes, gardens, houses by class with their doors, faults."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.core.scene import Piece
from scenewright.domains.village.blocks import BlockPlan
from scenewright.domains.village.house import class_of_area
from scenewright.drawing.houses import GROUND
from scenewright.drawing.marks import (
    FINE,
    GREY,
    INK,
    NOTHING,
    OUTLINE,
    Mark,
    PaperView,
    group,
    line,
    plate,
    shape,
    text_width,
    to_paper,
)
from scenewright.ground.plan import Way

STREET = "#b35c1e"
CLASSES = (
    ("Small, under 50 m²", "#fbe9d3"),
    ("Medium", "#efbf8a"),
    ("Large, over 100 m²", "#c9824a"),
)
KEPT = "#b9b4ae"
"""Fill of houses that stay where they stand."""
PAVING = {
    "asphalt": "#d9d9d6",
    "path": "#ece3d0",
    "yard": "#eee9dc",
    "square": "#e3dccd",
    "walk": "#e2dccb",
    "hedge": "#a9c48e",
    "white_wall": "#9a968f",
    "stone_wall": "#b3a890",
    "fence": "#8d7a5f",
    "bed": "#d9cfa6",
}
ENCLOSING = ("hedge", "white_wall", "stone_wall", "fence", "bed")
LABEL, SMALLEST = 2.0, 1.1
"""Height of labels in millimetres, and the least at which they are still written."""


def ground_mark(view: PaperView, block: BlockPlan) -> Mark:
    """The ground of a block."""
    return shape([to_paper(view, block.outline)], fill=GROUND, stroke=GREY, stroke_width=FINE)


def streets_mark(view: PaperView, block: BlockPlan) -> Mark:
    """The street sides of a block."""
    marks = [line(to_paper(view, side)) for side in block.streets]
    return group(marks, fill="none", stroke=STREET, stroke_width=OUTLINE, stroke_linecap="round")


def names_mark(view: PaperView, lanes: Sequence[Way]) -> Mark:
    """The names of lanes along their longest piece, where they fit."""
    return group([_name(view, way) for way in lanes])


def _name(view: PaperView, way: Way) -> Mark:
    steps = np.diff(way.line, axis=0)
    length = np.hypot(steps[:, 0], steps[:, 1])
    k = int(np.argmax(length))
    size = min(LABEL, 0.75 * way.width * view.scale)
    if not way.name or size < SMALLEST:
        return NOTHING
    if length[k] * view.scale < text_width(way.name, size) + 2:
        return NOTHING
    turn = float(np.degrees(np.arctan2(steps[k, 1], steps[k, 0])))
    turn = (turn + 90.0) % 180.0 - 90.0
    return plate(way.name, to_paper(view, way.line[k : k + 2].mean(0)), size, turn=turn, fill=INK)


def fill_of(piece: Piece) -> str:
    """The colour of a house by the class of its area."""
    area = float(shapely.Polygon(outline_of(piece)).area)
    return KEPT if piece.fixed else CLASSES[class_of_area(area)][1]
