"""Marks of a village plan: ground, lanes, gardens, houses by class with their doors, faults."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.core.report import Finding
from scenewright.core.scene import GroundSurface, Piece
from scenewright.core.space import Points
from scenewright.domains.village.blocks import BlockPlan
from scenewright.domains.village.house import class_of_area
from scenewright.drawing.marks import (
    FINE,
    GREY,
    INK,
    LINE,
    NOTHING,
    OUTLINE,
    Mark,
    MeantMark,
    PaperView,
    disc,
    group,
    line,
    plate,
    shape,
    text_width,
    title,
    to_paper,
)
from scenewright.drawing.pieces import mean_piece
from scenewright.ground.plan import Way

GROUND, LEAF, FAULT, STREET = "#f1f4ea", "#bcd6a8", "#d1121f", "#b35c1e"
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


def paving_mark(view: PaperView, rows: Iterable[GroundSurface]) -> Mark:
    """Surfaces of the ground, each kind in its colour."""
    found = []
    for row in rows:
        for outline, holes in row.areas:
            rings = [to_paper(view, ring) for ring in (outline, *holes)]
            found.append(shape(rings, fill=PAVING[row.kind], fill_rule="evenodd"))
    return group(found)


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


def trees_mark(view: PaperView, pieces: Iterable[Piece]) -> Mark:
    """Crowns."""
    marks = []
    for piece in pieces:
        radius = max(min(piece.size[:2]) / 2 * view.scale, 0.3)
        crown = disc(to_paper(view, piece.pose[:2]), radius)
        meaning = mean_piece(view, piece, "Tree", ("tree", round(radius, 3)))
        marks.append(MeantMark(crown, meaning))
    return group(marks, fill=LEAF, fill_opacity=0.8, stroke="#7d9c66", stroke_width=FINE)


def fill_of(piece: Piece, ring: Points) -> str:
    """The colour of a house by the class of its area."""
    return KEPT if piece.fixed else CLASSES[class_of_area(float(shapely.Polygon(ring).area))][1]


def houses_mark(view: PaperView, houses: Iterable[Piece]) -> Mark:
    """Houses by class, a triangle pointing out of each door."""
    marks = []
    for piece in houses:
        ring = outline_of(piece)
        words = f"{piece.function} · {shapely.Polygon(ring).area:.0f} m²"
        body = shape([to_paper(view, ring)], fill=fill_of(piece, ring))
        drawn = group([title(words), body, _door(view, piece, ring)])
        alike = (piece.asset, piece.size, piece.footprint, fill_of(piece, ring))
        marks.append(MeantMark(drawn, mean_piece(view, piece, words, alike)))
    return group(marks, stroke=INK, stroke_width=LINE, stroke_linejoin="round")


def _door(view: PaperView, piece: Piece, ring: Points) -> Mark:
    """A small triangle at the middle of the side farthest ahead."""
    ahead = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    at = middle[int(np.argmax(np.round(middle @ ahead, 6)))]
    size = 1.2 / view.scale
    side = np.array([-ahead[1], ahead[0]]) * size * 0.7
    return shape([to_paper(view, np.array([at + side, at - side, at + ahead * size]))], fill=INK)


def labels_mark(view: PaperView, numbers: dict[str, int], houses: Iterable[Piece]) -> Mark:
    """The number of each house in the list beside the plan, where it fits."""
    marks = []
    for piece in houses:
        polygon = shapely.Polygon(outline_of(piece))
        spot = shapely.get_coordinates(polygon.representative_point())[0]
        size = min(LABEL, 0.4 * min(piece.size[:2]) * view.scale)
        if size >= SMALLEST:
            marks.append(plate(str(numbers[piece.function]), to_paper(view, spot), size, fill=INK))
    return group(marks, fill=INK)


def faults_mark(view: PaperView, houses: Sequence[Piece], findings: Sequence[Finding]) -> Mark:
    """What the referee found, as a red outline of the house."""
    known = {piece.id: piece for piece in houses}
    marks = []
    for found in findings:
        if found.piece in known:
            body = shape([to_paper(view, outline_of(known[found.piece]))])
            marks.append(group([title(found.message), body]))
    return group(marks, fill="none", stroke=FAULT, stroke_width=0.5)
