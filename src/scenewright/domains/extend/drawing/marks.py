"""Marks of the plan of an extension: ground, streets, buildings old and new, letters, faults."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.core.piece_outlines import outline_of
from scenewright.core.report import Finding
from scenewright.core.scene import Piece
from scenewright.core.space import Points
from scenewright.domains.extend.areas import OLD, AreaPlan
from scenewright.drawing.marks import (
    INK,
    LINE,
    OUTLINE,
    Mark,
    MeantMark,
    PaperView,
    group,
    line,
    plate,
    shape,
    title,
    to_paper,
)
from scenewright.drawing.pieces import mean_piece
from scenewright.ground.plan import Way

GROUND, STREET, NEW_STREET, BORDER, FAULT = "#f1f4ea", "#dcdcd8", "#ece4d4", "#b35c1e", "#d1121f"
STOOD, KEPT, NEW = "#b9b4ae", "#d9b48a", "#eb9f55"
FILLS = (("Stood before", STOOD), ("New", NEW), ("New, locked", KEPT))
LABEL, SMALLEST = 2.2, 1.0
"""Height of letters in millimetres, and the least at which they are still written."""


def ground_mark(view: PaperView, area: AreaPlan) -> Mark:
    """The ground of an area."""
    outline, holes = rings(area.outline)
    paper = [to_paper(view, ring) for ring in (outline, *holes)]
    return shape(paper, fill=GROUND, fill_rule="evenodd")


def border_mark(view: PaperView, area: AreaPlan) -> Mark:
    """The border of an area, dashed: where the old ends."""
    outline, _ = rings(area.outline)
    closed = np.vstack([outline, outline[:1]])
    return group(
        [line(to_paper(view, closed))],
        fill="none",
        stroke=BORDER,
        stroke_width=LINE,
        stroke_dasharray="2 1",
    )


def streets_mark(view: PaperView, ways: Sequence[Way]) -> Mark:
    """Streets, new ones lighter."""
    found = []
    for way in sorted(ways, key=lambda way: not way.id.startswith("new")):
        area = shapely.LineString(way.line).buffer(way.width / 2, cap_style="flat")
        fill = NEW_STREET if way.id.startswith("new") else STREET
        for part in shapely.get_parts(area):
            outline, holes = rings(part)
            paper = [to_paper(view, ring) for ring in (outline, *holes)]
            found.append(shape(paper, fill=fill, fill_rule="evenodd"))
    return group(found)


def fill_of(piece: Piece) -> str:
    """The colour of a building by its age."""
    return STOOD if piece.space == OLD else KEPT if piece.fixed else NEW


def buildings_mark(view: PaperView, houses: Iterable[Piece]) -> Mark:
    """Buildings by age, a triangle pointing out of each front."""
    marks = []
    for piece in houses:
        ring = outline_of(piece)
        words = f"{piece.id} · {shapely.Polygon(ring).area:.0f} m²"
        body = shape([to_paper(view, ring)], fill=fill_of(piece))
        drawn = group([title(words), body, _front(view, piece, ring)])
        alike = (piece.asset, piece.size, piece.footprint, fill_of(piece))
        marks.append(MeantMark(drawn, mean_piece(view, piece, words, alike)))
    return group(marks, stroke=INK, stroke_width=LINE, stroke_linejoin="round")


def _front(view: PaperView, piece: Piece, ring: Points) -> Mark:
    """A small triangle at the middle of the side farthest ahead."""
    ahead = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    middle = (ring + np.roll(ring, -1, axis=0)) / 2
    at = middle[int(np.argmax(np.round(middle @ ahead, 6)))]
    size = 1.1 / view.scale
    side = np.array([-ahead[1], ahead[0]]) * size * 0.7
    return shape([to_paper(view, np.array([at + side, at - side, at + ahead * size]))], fill=INK)


def letters_mark(view: PaperView, houses: Iterable[Piece]) -> Mark:
    """The letter of the kind of each building, where it fits."""
    marks = []
    for piece in houses:
        spot = shapely.get_coordinates(shapely.Polygon(outline_of(piece)).representative_point())[0]
        size = min(LABEL, 0.4 * min(piece.size[:2]) * view.scale)
        if size >= SMALLEST and piece.function:
            marks.append(plate(piece.function[:4], to_paper(view, spot), size, fill=INK))
    return group(marks, fill=INK)


def faults_mark(view: PaperView, houses: Sequence[Piece], findings: Sequence[Finding]) -> Mark:
    """What the referee found, as a red outline of the building."""
    known = {piece.id: piece for piece in houses}
    marks = []
    for found in findings:
        if found.piece in known:
            body = shape([to_paper(view, outline_of(known[found.piece]))])
            marks.append(group([title(found.message), body]))
    return group(marks, fill="none", stroke=FAULT, stroke_width=OUTLINE)
