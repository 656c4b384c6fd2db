"""Plans as SVG 1.1 in millimetres: every layer a group by its name, as drawing programs show it.

The file holds no script, no style sheet, no image and no font; names are escaped.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from scenewright.core.space import Points
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.marks import (
    ArcMark,
    CopyMark,
    CurveMark,
    Definition,
    DiscMark,
    FillPattern,
    GroupMark,
    Mark,
    MeantMark,
    NoteMark,
    PathMark,
    PictureMark,
    TextMark,
    title,
)

NAMESPACES = {
    "xmlns": "http://www.w3.org/2000/svg",
    "xmlns:xlink": "http://www.w3.org/1999/xlink",
    "xmlns:inkscape": "http://www.inkscape.org/namespaces/inkscape",
}
FONTS = "Helvetica, Arial, 'DejaVu Sans', sans-serif"


def write_svg(drawing: PlanDrawing) -> str:
    """The SVG file of a drawing."""
    sheet = drawing.sheet
    defined = [_define(definition) for definition in drawing.definitions]
    parts = [
        mark_text(title(drawing.name)),
        tag("rect", width=sheet.width, height=sheet.height, fill="#ffffff"),
        tag("defs", "\n".join(defined)) if defined else "",
        *(_layer(layer) for layer in drawing.layers),
    ]
    body = tag(
        "svg",
        "\n".join(["", *(part for part in parts if part), ""]),
        **NAMESPACES,
        version="1.1",
        width=f"{sheet.width:g}mm",
        height=f"{sheet.height:g}mm",
        viewBox=f"0 0 {sheet.width:g} {sheet.height:g}",
        font_family=FONTS,
    )
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{body}\n'


def mark_text(mark: Mark) -> str:
    """One mark as an element, or elements, of SVG.

    >>> from scenewright.drawing.marks import disc
    >>> mark_text(disc((1, 2), 2.50, stroke_width=0.1))
    '<circle cx="1" cy="2" r="2.5" stroke-width="0.1"/>'
    """
    match mark:
        case GroupMark():
            return _group(mark)
        case PathMark(rings, closed, style):
            data = "".join(_outline(ring, closed) for ring in rings)
            return tag("path", "", d=data, **style)
        case CurveMark(points, style):
            return tag("path", "", d=_curve(points), **style)
        case ArcMark():
            return _arc(mark)
        case DiscMark(x, y, radius, style):
            return tag("circle", "", cx=x, cy=y, r=radius, **style)
        case TextMark():
            return _text(mark)
        case NoteMark(words):
            return tag("title", escape(words))
        case CopyMark():
            return _copy(mark)
        case MeantMark(drawn):
            return mark_text(drawn)
        case PictureMark():
            raise TypeError("a plan as SVG holds no pictures")


def number(value: float) -> str:
    """A length to a hundredth of a millimetre, short.

    >>> [number(v) for v in (1.0, -0.001, 12.345)]
    ['1', '0', '12.35']
    """
    short = f"{float(value):.2f}".rstrip("0").rstrip(".")
    return "0" if short == "-0" else short


def tag(name: str, content: str = "", /, **attributes: str | float) -> str:
    """One element of SVG; underscores in attribute names stand for hyphens, values are escaped."""
    pairs = "".join(
        f" {key.replace('_', '-')}={quoteattr(value if isinstance(value, str) else number(value))}"
        for key, value in attributes.items()
    )
    return f"<{name}{pairs}>{content}</{name}>" if content else f"<{name}{pairs}/>"


def _lines(marks: Iterable[Mark]) -> str:
    return "\n".join(mark_text(mark) for mark in marks)


def _group(mark: GroupMark) -> str:
    """A group; one that shares nothing is not written, unless it is what a note is about."""
    content = _lines(mark.marks)
    noted = any(isinstance(part, NoteMark) for part in mark.marks)
    return tag("g", f"\n{content}\n", **mark.style) if mark.style or noted else content


def _layer(layer: PlanLayer) -> str:
    """A layer as drawing programs read it: a group by its id, in Inkscape by its label."""
    names = {"inkscape:groupmode": "layer", "inkscape:label": layer.name}
    name = re.sub(r"[^a-z0-9]+", "-", layer.name.lower()).strip("-")
    return tag("g", f"\n{mark_text(layer.mark)}\n", id=f"layer-{name}", **names)


def _define(definition: Definition) -> str:
    if not isinstance(definition, FillPattern):
        return tag("g", _lines(definition.marks), id=definition.id)
    size = {"width": definition.width, "height": definition.height}
    paper = tag("rect", "", **size, fill=definition.paper) if definition.paper else ""
    turn = {"patternTransform": f"rotate({number(definition.turn)})"} if definition.turn else {}
    units = {"patternUnits": "userSpaceOnUse"} | turn
    return tag("pattern", paper + _lines(definition.marks), id=definition.id, **size, **units)


def _outline(points: Points, closed: bool) -> str:
    """Path data through paper points ``(k, 2)``."""
    steps = " ".join(f"{number(x)},{number(y)}" for x, y in points)
    return f"M{steps}{'Z' if closed else ''}"


def _curve(points: Points) -> str:
    """Path data of cubic pieces."""
    start = f"M{number(points[0, 0])},{number(points[0, 1])}"
    steps = np.reshape(points[1:], (-1, 6))
    return start + "".join(f"C{' '.join(number(v) for v in step)}" for step in steps)


def _arc(mark: ArcMark) -> str:
    (x0, y0), (x1, y1), radius = mark.start, mark.end, number(mark.radius)
    turn = f"A{radius},{radius} 0 0 {int(mark.clockwise)} {number(x1)},{number(y1)}"
    return tag("path", "", d=f"M{number(x0)},{number(y0)}{turn}", **mark.style)


def _text(mark: TextMark) -> str:
    place: dict[str, str | float] = {"x": mark.x, "y": mark.y, "dy": 0.35 * mark.size}
    if mark.turn:
        turn = number(-mark.turn)
        place["transform"] = f"rotate({turn} {number(mark.x)} {number(mark.y)})"
    style: dict[str, str | float] = {"font_size": mark.size, "text_anchor": "middle"}
    return tag("text", escape(mark.words), **(place | style | dict(mark.style)))


def _copy(mark: CopyMark) -> str:
    where = f"translate({number(mark.x)} {number(mark.y)})"
    where += f" rotate({number(mark.turn)})" if mark.turn else ""
    names = {"xlink:href": f"#{mark.stencil}", "transform": where}
    return tag("use", mark_text(mark.note), **names)
