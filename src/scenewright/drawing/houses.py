"""Marks of houses on plans of villages and extensions: bodies with their fronts, words, faults."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.core.space import Points
from scenewright.drawing.marks import (
    FINE,
    INK,
    LINE,
    Mark,
    MeantMark,
    PaperView,
    disc,
    group,
    plate,
    shape,
    title,
    to_paper,
)
from scenewright.drawing.pieces import mean_piece

GROUND, LEAF, FAULT = "#f1f4ea", "#bcd6a8", "#d1121f"
RINGED, FRONT = 0.5, 1.2
"""Millimetres: the width of a fault's outline, and the size of the triangle before a front."""
SMALLEST = 1.0
"""Least height in millimetres at which words are still written."""


def houses_mark(
    view: PaperView, houses: Iterable[Piece], fill_of: Callable[[Piece], str], named: bool = False
) -> Mark:
    """Houses in their colours, a triangle pointing out of each front; told by what they are
    (``named``) or by their ids."""
    marks = []
    for piece in houses:
        ring, fill = outline_of(piece), fill_of(piece)
        words = f"{piece.function if named else piece.id} · {shapely.Polygon(ring).area:.0f} m²"
        body = shape([to_paper(view, ring)], fill=fill)
        drawn = group([title(words), body, _front(view, piece, ring)])
        alike = (piece.asset, piece.size, piece.footprint, fill)
        marks.append(MeantMark(drawn, mean_piece(view, piece, words, alike)))
    return group(marks, stroke=INK, stroke_width=LINE, stroke_linejoin="round")


def _front(view: PaperView, piece: Piece, ring: Points) -> Mark:
    """A small triangle at the middle of the side farthest ahead."""
    ahead = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    at = middle[int(np.argmax(np.round(middle @ ahead, 6)))]
    size = FRONT / view.scale
    side = np.array([-ahead[1], ahead[0]]) * size * 0.7
    return shape([to_paper(view, np.array([at + side, at - side, at + ahead * size]))], fill=INK)


def words_mark(
    view: PaperView, houses: Iterable[Piece], word_of: Callable[[Piece], str], high: float
) -> Mark:
    """A word in each house, at most ``high`` millimetres, where it fits."""
    marks = []
    for piece in houses:
        spot = shapely.get_coordinates(shapely.Polygon(outline_of(piece)).representative_point())[0]
        size = min(high, 0.4 * min(piece.size[:2]) * view.scale)
        if size >= SMALLEST and word_of(piece):
            marks.append(plate(word_of(piece), to_paper(view, spot), size, fill=INK))
    return group(marks, fill=INK)


def faults_mark(view: PaperView, houses: Sequence[Piece], findings: Sequence[Finding]) -> Mark:
    """What the referee found, as a red outline of the house."""
    known = {piece.id: piece for piece in houses}
    marks = []
    for found in findings:
        if found.piece in known:
            body = shape([to_paper(view, outline_of(known[found.piece]))])
            marks.append(group([title(found.message), body]))
    return group(marks, fill="none", stroke=FAULT, stroke_width=RINGED)


def trees_mark(view: PaperView, pieces: Iterable[Piece]) -> Mark:
    """Crowns."""
    marks = []
    for piece in pieces:
        radius = max(min(piece.size[:2]) / 2 * view.scale, 0.3)
        crown = disc(to_paper(view, piece.pose[:2]), radius)
        meaning = mean_piece(view, piece, "Tree", ("tree", round(radius, 3)))
        marks.append(MeantMark(crown, meaning))
    return group(marks, fill=LEAF, fill_opacity=0.8, stroke="#7d9c66", stroke_width=FINE)
