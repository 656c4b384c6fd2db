"""Marks of the plan of an extension: ground, streets, buildings old and new, letters, faults."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely

from scenewright.building.outlines import rings
from scenewright.core.scene import Piece
from scenewright.domains.extend.areas import OLD, AreaPlan
from scenewright.drawing.houses import GROUND
from scenewright.drawing.marks import LINE, Mark, PaperView, group, line, shape, to_paper
from scenewright.ground.plan import Way

STREET, NEW_STREET, BORDER = "#dcdcd8", "#ece4d4", "#b35c1e"
KERBS = {"kerb": "#b5b2ac"}
STOOD, KEPT, NEW = "#b9b4ae", "#d9b48a", "#eb9f55"
FILLS = (("Stood before", STOOD), ("New", NEW), ("New, locked", KEPT))
LABEL = 2.2
"""Height of letters in millimetres."""


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
