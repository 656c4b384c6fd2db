"""Sloped ceilings in plan: dashed lines where they are 1 m and 2 m high."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import shapely
from shapely import Geometry, LineString

from scenewright.building.ceiling import HALF, WHOLE, below, planes
from scenewright.core.space import Space
from scenewright.drawing.labels import polygon_of
from scenewright.drawing.marks import GREY, LINE, Mark, PaperView, group, line, plate, to_paper

WORD = 1.5
"""Height of the figures, millimetres."""
CLEAR = 0.02
"""What of a line lies nearer than this to a wall is not drawn, in metres."""


def slopes_mark(view: PaperView, spaces: Sequence[Space], busy: Geometry) -> Mark:
    """The lines of all rooms with their heights, written where least is ``busy``, plan metres."""
    marks, words = [], []
    for space in spaces:
        for height in (HALF, WHOLE):
            for part in contours(space, height):
                marks.append(line(to_paper(view, shapely.get_coordinates(part))))
                at = to_paper(view, _quiet(part, busy))
                words.append(plate(f"{height:.1f} m", at, WORD, fill=GREY))
    drawn = group(marks, stroke=GREY, stroke_width=LINE, stroke_dasharray="2.2 1.1", fill="none")
    return group([drawn, *words])


def low_lines(view: PaperView, space: Space) -> list[Geometry]:
    """What names of rooms should keep off: the lines, as wide as their figures are high."""
    wide = WORD / view.scale / 2
    return [part.buffer(wide) for height in (HALF, WHOLE) for part in contours(space, height)]


def contours(space: Space, height: float) -> list[LineString]:
    """Where in a room the sloped ceiling is just ``height`` high."""
    if not space.slopes or space.height < height:
        return []
    floor = polygon_of(space)
    low = below(floor, planes(space), space.height, height)
    inner = shapely.line_merge(low.boundary.intersection(floor.buffer(-CLEAR)))
    return [p for p in shapely.get_parts(inner) if isinstance(p, LineString) and p.length > 0.2]


def _quiet(part: LineString, busy: Geometry) -> np.ndarray:
    """The point of a line that is farthest from what is drawn, and not quite at its end."""
    spare = min(0.4, part.length / 3)
    along = np.arange(spare, part.length - spare + 1e-9, 0.1)
    points = shapely.line_interpolate_point(part, along)
    away = np.minimum(shapely.distance(points, busy), 0.4)
    return np.asarray(shapely.get_coordinates(points[int(np.argmax(away))])[0])
