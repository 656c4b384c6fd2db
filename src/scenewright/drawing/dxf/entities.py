"""Marks as entities of DXF: polylines, hatches, arcs, circles and words."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from ezdxf.enums import TextEntityAlignment
from numpy.typing import NDArray

from scenewright.core.space import Points
from scenewright.drawing.dxf.layers import HATCHES
from scenewright.drawing.dxf.pens import (
    NO_INK,
    LineTypes,
    colour_attributes,
    fill_of,
    inherit,
    pattern_lines,
    pen_attributes,
    stroke_of,
)
from scenewright.drawing.dxf.place import Placing
from scenewright.drawing.marks import (
    ArcMark,
    CurveMark,
    DiscMark,
    FillPattern,
    GroupMark,
    Mark,
    MeantMark,
    PathMark,
    Style,
    TextMark,
)

CAPITALS = 0.72
"""Height of capitals, by which DXF measures text, as a share of the size of letters."""
PIECES_OF_CURVE = 12
ANCHORS = {
    "start": TextEntityAlignment.MIDDLE_LEFT,
    "middle": TextEntityAlignment.MIDDLE_CENTER,
    "end": TextEntityAlignment.MIDDLE_RIGHT,
}


class Canvas(NamedTuple):
    """Where entities go (a layout or block), on which ``layer``, by which placing, with the line
    types of the document and its patterns by id. Shapes are only ``filled`` where that says more
    than their outline."""

    space: Any
    layer: str
    placing: Placing
    types: LineTypes
    patterns: Mapping[str, FillPattern]
    text_style: str
    filled: bool = True


def draw_mark(canvas: Canvas, mark: Mark, style: Style) -> None:
    """Add the entities of a mark that has no entity of its own; ``style`` is what it takes from
    the groups it is in."""
    match mark:
        case GroupMark(marks, own):
            for part in marks:
                draw_mark(canvas, part, inherit(style, own))
        case MeantMark(drawn):
            draw_mark(canvas, drawn, style)
        case PathMark(rings, closed, own):
            _draw_path(canvas, rings, closed, inherit(style, own))
        case CurveMark(points, own):
            _draw_lines(canvas, [_flatten(points)], False, inherit(style, own))
        case ArcMark():
            _draw_arc(canvas, mark, inherit(style, mark.style))
        case DiscMark():
            _draw_disc(canvas, mark, inherit(style, mark.style))
        case TextMark():
            draw_text(canvas, mark, inherit(style, mark.style))
        case _:
            pass


def _attributes(canvas: Canvas, style: Style) -> dict[str, Any]:
    pen = pen_attributes(style, canvas.placing.size, canvas.types)
    return {"layer": canvas.layer, **pen}


def _draw_path(canvas: Canvas, rings: tuple[Points, ...], closed: bool, style: Style) -> None:
    if closed and canvas.filled:
        _hatch(canvas, rings, style)
    if stroke_of(style) not in NO_INK or (closed and fill_of(style) not in NO_INK):
        _draw_lines(canvas, rings, closed, style)


def _draw_lines(canvas: Canvas, rings: Any, closed: bool, style: Style) -> None:
    if stroke_of(style) in NO_INK and not (closed and not canvas.filled):
        return
    pen = style if stroke_of(style) not in NO_INK else {**style, "stroke": fill_of(style)}
    for ring in rings:
        points = canvas.placing.points(ring).tolist()
        canvas.space.add_lwpolyline(points, close=closed, dxfattribs=_attributes(canvas, pen))


SLANTED, SQUARES = ("ANSI31", 2.0**0.5), ("SQUARE", 50.0)
"""Names of patterns that every program has, and the pitch of those that take no definition from
the file but look the name up (LibreCAD)."""


def _hatch(canvas: Canvas, rings: tuple[Points, ...], style: Style) -> None:
    """What fills a shape: a pattern, or a plain colour; white is left as paper."""
    fill = fill_of(style)
    if fill in NO_INK:
        return
    layer = {"layer": canvas.layer + HATCHES if canvas.layer != "0" else "0"}
    if fill.startswith("url("):
        pattern = canvas.patterns.get(fill[5:-1])
        if pattern is None:
            return
        hatch = canvas.space.add_hatch(color=8, dxfattribs=layer)
        name, pitch = SLANTED if pattern.turn % 90.0 else SQUARES
        hatch.set_pattern_fill(name, definition=_pattern_of(canvas, pattern))
        hatch.dxf.pattern_scale = pattern.width * canvas.placing.size / pitch
    else:
        colour = colour_attributes(fill)
        hatch = canvas.space.add_hatch(dxfattribs=layer | colour)
        opacity = float(style.get("fill_opacity", 1.0))
        hatch.transparency = 1.0 - opacity if opacity < 1.0 else 0.0
    for number, ring in enumerate(rings):
        points = canvas.placing.points(ring).tolist()
        hatch.paths.add_polyline_path(points, is_closed=True, flags=1 if number == 0 else 16)


def _pattern_of(canvas: Canvas, pattern: FillPattern) -> Any:
    rows = [ring for mark in pattern.marks if isinstance(mark, PathMark) for ring in mark.rings]
    size = canvas.placing.size
    return pattern_lines(pattern.turn, (pattern.width, pattern.height), rows, size)


def _draw_arc(canvas: Canvas, mark: ArcMark, style: Style) -> None:
    """The arc by its middle: right of the way from start to end where it runs clockwise."""
    start, end = canvas.placing.points([mark.start, mark.end])
    radius = mark.radius * canvas.placing.size
    chord = end - start
    half = float(np.hypot(*chord)) / 2
    right = np.array([chord[1], -chord[0]]) / max(2 * half, 1e-12)
    aside = np.sqrt(max(radius**2 - half**2, 0.0)) * (1.0 if mark.clockwise else -1.0)
    middle = (start + end) / 2 + aside * right
    first, last = (end, start) if mark.clockwise else (start, end)
    canvas.space.add_arc(
        middle.tolist(),
        radius,
        _bearing(first - middle),
        _bearing(last - middle),
        dxfattribs=_attributes(canvas, style),
    )


def _bearing(vector: NDArray[np.float64]) -> float:
    return float(np.degrees(np.arctan2(vector[1], vector[0]))) % 360.0


def _draw_disc(canvas: Canvas, mark: DiscMark, style: Style) -> None:
    middle = canvas.placing.points([mark.x, mark.y]).tolist()
    radius = mark.radius * canvas.placing.size
    fill, stroke = fill_of(style), stroke_of(style)
    if fill not in NO_INK and canvas.filled:
        layer = canvas.layer + HATCHES if canvas.layer != "0" else "0"
        hatch = canvas.space.add_hatch(dxfattribs={"layer": layer} | colour_attributes(fill))
        hatch.paths.add_edge_path().add_arc(middle, radius, 0, 360)
    if stroke not in NO_INK or (fill not in NO_INK and not canvas.filled):
        pen = style if stroke not in NO_INK else {**style, "stroke": fill}
        canvas.space.add_circle(middle, radius, dxfattribs=_attributes(canvas, pen))


def _text_colour(style: Style) -> str:
    fill = fill_of(style)
    return "#000000" if fill in NO_INK else fill


def draw_text(canvas: Canvas, mark: TextMark, style: Style) -> None:
    """Words; the halo around others (words with an outline) is left out."""
    if not mark.words or is_halo(style):
        return
    look = {
        "layer": canvas.layer,
        "height": mark.size * CAPITALS * canvas.placing.size,
        "rotation": mark.turn + canvas.placing.turn,
        "style": canvas.text_style,
        **colour_attributes(_text_colour(style)),
    }
    entity = canvas.space.add_text(plain_words(mark.words), dxfattribs=look)
    anchor = ANCHORS[str(style.get("text_anchor", "middle"))]
    entity.set_placement(canvas.placing.points([mark.x, mark.y]).tolist(), align=anchor)


def is_halo(style: Style) -> bool:
    """Whether words only clear the paper around the same words."""
    return stroke_of(style) != "none"


def plain_words(words: str) -> str:
    """Words in which no sign is a code of DXF.

    >>> plain_words("50 %%d ^ off")
    '50 %  %d ^  off'
    """
    return words.replace("%%", "%  %").replace("^", "^ ")


def _flatten(points: Points) -> Points:
    """Points along cubic pieces."""
    share = np.linspace(0.0, 1.0, PIECES_OF_CURVE + 1)[:, None]
    found = [points[:1]]
    for k in range(0, len(points) - 1, 3):
        a, b, c, d = points[k : k + 4]
        piece = (1 - share) ** 3 * a + 3 * (1 - share) ** 2 * share * b
        piece = piece + 3 * (1 - share) * share**2 * c + share**3 * d
        found.append(piece[1:])
    return np.vstack(found)
