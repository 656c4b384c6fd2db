"""Contour lines of a grid of heights, for plans."""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.heights import HeightGrid
from scenewright.core.space import Points
from scenewright.drawing.marks import Mark, PaperView, group, line, plate, shape, to_paper

Floats = NDArray[np.float64]
EARTH, WATER, FLOW = "#a58a6a", "#cfe0ea", "#7fa3b8"
INTERVALS, MOST = (0.25, 0.5, 1.0, 2.0, 5.0, 10.0), 16
"""Metres between contours, and how many there are at most but for the widest."""
THIN, THICK, LETTER = 0.09, 0.2, 1.7
"""Widths of contours, of every fifth one, and the height of their numbers, in millimetres."""


def contour_lines(grid: HeightGrid, level: float) -> shapely.Geometry:
    """The line at a level: through each triangle of the grid straight from side to side.

    >>> slope = HeightGrid((0.0, 0.0), 1.0, np.array([[0.0, 1.0, 2.0], [0.0, 1.0, 2.0]]))
    >>> contour_lines(slope, 0.5).bounds
    (0.5, 0.0, 0.5, 1.0)
    """
    p = np.concatenate([grid.points, grid.values[..., None]], -1)
    a, b, c, d = p[:-1, :-1], p[:-1, 1:], p[1:, 1:], p[1:, :-1]
    faces = np.concatenate([np.stack(t, -2).reshape(-1, 3, 3) for t in ((a, b, c), (a, c, d))])
    above = faces[..., 2] > level
    faces, above = (rows[above.any(1) & ~above.all(1)] for rows in (faces, above))
    lone = np.argmax(np.where(above.sum(1, keepdims=True) == 1, above, ~above), axis=1)
    each = np.arange(len(faces))
    tip = faces[each, lone]
    ends = []
    for k in (1, 2):
        far = faces[each, (lone + k) % 3]
        share = (level - tip[:, 2:]) / (far[:, 2:] - tip[:, 2:])
        ends.append(tip[:, :2] + share * (far[:, :2] - tip[:, :2]))
    parts = shapely.linestrings(np.stack(ends, 1))
    return shapely.line_merge(shapely.multilinestrings(parts[shapely.length(parts) > 1e-9]))


def contours_mark(view: PaperView, grid: HeightGrid, floor: shapely.Geometry) -> Mark:
    """Contours of the ground on a floor, every fifth one heavier and with its height."""
    points = grid.points.reshape(-1, 2)
    inside = shapely.contains_xy(floor, points[:, 0], points[:, 1])
    low, high = np.ptp(grid.values.reshape(-1)[inside]), grid.values.reshape(-1)[inside]
    step = next((one for one in INTERVALS if low / one <= MOST), INTERVALS[-1])
    marks = []
    first, last = int(np.ceil(high.min() / step)), int(np.floor(high.max() / step))
    for number in range(first, last + 1):
        drawn = shapely.intersection(contour_lines(grid, number * step), floor)
        heavy = number % 5 == 0
        lines = [p for p in shapely.get_parts(drawn) if p.geom_type == "LineString"]
        marks += [
            line(
                to_paper(view, shapely.get_coordinates(part.simplify(0.1))),
                stroke_width=THICK if heavy else THIN,
            )
            for part in lines
        ]
        if heavy and lines:
            longest = max(lines, key=lambda part: part.length)
            at = shapely.get_coordinates(longest.interpolate(0.5, normalized=True))[0]
            marks.append(plate(f"{number * step:g}", to_paper(view, at), LETTER, fill=EARTH))
    return group(marks, fill="none", stroke=EARTH)


def water_mark(view: PaperView, waters: list[Points], floor: shapely.Geometry) -> Mark:
    """Rivers and lakes on a floor."""
    shapes = [shapely.intersection(shapely.Polygon(ring), floor) for ring in waters]
    parts = [p for one in shapes for p in shapely.get_parts(one) if p.geom_type == "Polygon"]
    rings = [to_paper(view, shapely.get_coordinates(part.exterior)) for part in parts]
    return group([shape([ring], fill=WATER, stroke=FLOW, stroke_width=THICK) for ring in rings])
