"""Marks as operators of PDF: paths, clipped hatches, words, pictures; millimetres, y down."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.core.space import Points
from scenewright.drawing.hatching import hatch_lines
from scenewright.drawing.marks import (
    ArcMark,
    CopyMark,
    CurveMark,
    DiscMark,
    FillPattern,
    GroupMark,
    Mark,
    MeantMark,
    PathMark,
    PictureMark,
    Stencil,
    Style,
    TextMark,
)
from scenewright.drawing.pdf.fonts import Fonts, Run
from scenewright.drawing.pdf.outlines import outline_words

POINT = 72.0 / 25.4
ROUND = 4 / 3 * np.tan(np.pi / 8)
"""Handles of a quarter of a circle, as a share of its radius."""
CAPS = {"butt": 0, "round": 1, "square": 2}
JOINS = {"miter": 0, "round": 1, "bevel": 2}
BOLD = 0.035
"""Width of the outline of bold letters, as a share of their size."""
START: Style = {"stroke": "none", "fill": "#000000", "stroke_width": 1.0}


class Canvas(NamedTuple):
    """A page ``high`` millimetres high, with what is defined once."""

    pdf: Any
    high: float
    fonts: Fonts
    patterns: Mapping[str, FillPattern]
    stencils: Mapping[str, Stencil]

    def out(self, *operators: str) -> None:
        """Add operators to the page."""
        for operator in operators:
            self.pdf._out(operator)


def draw_mark(canvas: Canvas, mark: Mark, style: Style) -> None:
    """Add a mark to the page; ``style`` is what it takes from the groups it is in."""
    match mark:
        case GroupMark(marks, own):
            for part in marks:
                draw_mark(canvas, part, {**style, **own})
        case MeantMark(drawn):
            draw_mark(canvas, drawn, style)
        case PathMark(rings, closed, own):
            _paint(canvas, _rings(canvas, rings, closed), {**style, **own}, np.vstack(rings))
        case CurveMark(points, own):
            _paint(canvas, _curve(canvas, points), {**style, **own}, points)
        case ArcMark():
            _paint(canvas, _arc(canvas, mark), {**style, **mark.style, "fill": "none"}, None)
        case DiscMark(x, y, radius, own):
            bounds = np.array([[x - radius, y - radius], [x + radius, y + radius]])
            _paint(canvas, _circle(canvas, x, y, radius), {**style, **own}, bounds)
        case TextMark():
            _text(canvas, mark, {**style, **mark.style})
        case CopyMark():
            _copy(canvas, mark, style)
        case PictureMark():
            _picture(canvas, mark)
        case _:
            pass


def _xy(canvas: Canvas, points: ArrayLike) -> list[str]:
    """Paper points as numbers of PDF: points of 1/72 inch, y upwards."""
    flat = np.asarray(points, dtype=float).reshape(-1, 2)
    moved = np.column_stack([flat[:, 0], canvas.high - flat[:, 1]]) * POINT
    return [f"{x:.3f} {y:.3f}" for x, y in moved]


def _rings(canvas: Canvas, rings: tuple[Points, ...], closed: bool) -> str:
    parts = []
    for ring in rings:
        first, *rest = _xy(canvas, ring)
        parts += [f"{first} m", *(f"{point} l" for point in rest), *(["h"] if closed else [])]
    return " ".join(parts)


def _curve(canvas: Canvas, points: Points) -> str:
    first, *rest = _xy(canvas, points)
    steps = [" ".join(rest[k : k + 3]) + " c" for k in range(0, len(rest), 3)]
    return " ".join([f"{first} m", *steps])


def _circle(canvas: Canvas, x: float, y: float, radius: float) -> str:
    quarter = np.array([[1, 0], [1, ROUND], [ROUND, 1], [0, 1]])
    turn = np.array([[0.0, 1.0], [-1.0, 0.0]])
    points, rows = quarter, [quarter[:1]]
    for _ in range(4):
        rows.append(points[1:])
        points = points @ turn
    return _curve(canvas, np.vstack(rows) * radius + (x, y)) + " h"


def _arc(canvas: Canvas, mark: ArcMark) -> str:
    """The shorter arc as one cubic piece, true to a ten-thousandth for a quarter."""
    start, end = np.array(mark.start), np.array(mark.end)
    chord = end - start
    half = float(np.hypot(*chord)) / 2
    side = 1.0 if mark.clockwise else -1.0
    normal = np.array([-chord[1], chord[0]]) / max(2 * half, 1e-12) * side
    middle = (start + end) / 2 + normal * np.sqrt(max(mark.radius**2 - half**2, 0.0))
    sweep = 2 * np.arcsin(min(half / max(mark.radius, 1e-12), 1.0)) * side
    handle = 4 / 3 * np.tan(sweep / 4)
    a, b = start - middle, end - middle
    points = [start, start + handle * _left(a), end - handle * _left(b), end]
    return _curve(canvas, np.array(points))


def _left(vector: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.array([-vector[1], vector[0]])


def colour(value: str) -> str:
    """A colour as three numbers of PDF.

    >>> colour("#ff0000"), colour("#000")
    ('1.000 0.000 0.000', '0.000 0.000 0.000')
    """
    short = value.lstrip("#")
    full = short if len(short) == 6 else "".join(letter * 2 for letter in short)
    return " ".join(f"{int(full[k : k + 2], 16) / 255:.3f}" for k in (0, 2, 4))


def _paint(canvas: Canvas, path: str, style: Style, points: Points | None) -> None:
    """Fill and stroke a path; a pattern is lines within it."""
    fill, stroke = str(style["fill"]), str(style["stroke"])
    rule = "*" if style.get("fill_rule") == "evenodd" else ""
    if fill.startswith("url(") and points is not None:
        _hatch(canvas, path, canvas.patterns.get(fill[5:-1]), points, rule)
        fill = "none"
    if fill == "none" and stroke == "none":
        return
    see_through = float(style.get("fill_opacity", 1.0))
    opaque = blend(fill, see_through) if fill != "none" else fill
    setting = [f"{colour(opaque)} rg"] if fill != "none" else []
    if stroke != "none":
        setting += [f"{colour(stroke)} RG", *_pen(style)]
    ends = {(True, True): "B" + rule, (True, False): "f" + rule, (False, True): "S"}
    canvas.out("q " + " ".join(setting), path, ends[fill != "none", stroke != "none"] + " Q")


def blend(value: str, opacity: float) -> str:
    """A colour as it looks on white paper through its opacity.

    >>> blend("#000000", 0.5)
    '#808080'
    """
    if opacity >= 1.0:
        return value
    full = value.lstrip("#")
    mixed = (255 - opacity * (255 - int(full[k : k + 2], 16)) for k in (0, 2, 4))
    return "#" + "".join(f"{round(part):02x}" for part in mixed)


def _pen(style: Style) -> list[str]:
    found = [f"{float(style['stroke_width']) * POINT:.3f} w"]
    found.append(f"{CAPS[str(style.get('stroke_linecap', 'butt'))]} J")
    found.append(f"{JOINS[str(style.get('stroke_linejoin', 'miter'))]} j")
    dashes = str(style.get("stroke_dasharray", "none"))
    if dashes != "none":
        lengths = " ".join(f"{float(d) * POINT:.3f}" for d in dashes.replace(",", " ").split())
        found.append(f"[{lengths}] 0 d")
    return found


def _hatch(
    canvas: Canvas, path: str, pattern: FillPattern | None, points: Points, rule: str
) -> None:
    """The lines of a pattern, clipped to a path."""
    if pattern is None:
        return
    if pattern.paper:
        canvas.out(f"q {colour(pattern.paper)} rg {path} f{rule} Q")
    canvas.out(f"q {path} W{rule} n")
    for rows, own in hatch_lines(pattern, points.min(0), points.max(0)):
        style = {**START, **own}
        ends = _xy(canvas, rows)
        lines = " ".join(f"{a} m {b} l" for a, b in zip(ends[::2], ends[1::2], strict=True))
        if lines:
            pens = " ".join(_pen(style))
            canvas.out(f"{colour(str(style['stroke']))} RG {pens}", f"{lines} S")
    canvas.out("Q")


def _copy(canvas: Canvas, mark: CopyMark, style: Style) -> None:
    """A symbol defined once, moved and turned."""
    angle = np.radians(-mark.turn)
    x, y = mark.x * POINT, (canvas.high - mark.y) * POINT
    cos, sin = np.cos(angle), np.sin(angle)
    canvas.out(f"q {cos:.6f} {sin:.6f} {-sin:.6f} {cos:.6f} {x:.3f} {y:.3f} cm")
    around = canvas._replace(high=0.0)
    for part in canvas.stencils[mark.stencil].marks:
        draw_mark(around, part, style)
    canvas.out("Q")


def _picture(canvas: Canvas, mark: PictureMark) -> None:
    from PIL import Image

    canvas.pdf.image(Image.fromarray(mark.pixels), mark.x, mark.y, w=mark.width, h=mark.height)


def _text(canvas: Canvas, mark: TextMark, style: Style) -> None:
    """Words by font; a halo (words with an outline) is drawn as outlines, which are no text."""
    if not mark.words:
        return
    runs = [(run, _width(canvas, run, mark.size)) for run in canvas.fonts.runs(mark.words)]
    share = {"start": 0.0, "middle": 0.5, "end": 1.0}[str(style.get("text_anchor", "middle"))]
    x, y = -share * sum(wide for _, wide in runs), -0.35 * mark.size
    angle = np.radians(mark.turn)
    cos, sin = np.cos(angle), np.sin(angle)
    left, up = mark.x * POINT, (canvas.high - mark.y) * POINT
    canvas.out(f"q {cos:.6f} {sin:.6f} {-sin:.6f} {cos:.6f} {left:.3f} {up:.3f} cm")
    for run, wide in runs:
        _write_run(canvas, run, mark.size, (x, y), style)
        x += wide
    canvas.out("Q")


def _width(canvas: Canvas, run: Run, size: float) -> float:
    canvas.pdf.set_font(run.family, size=size * POINT)
    return float(canvas.pdf.get_string_width(run.words))


def _write_run(
    canvas: Canvas, run: Run, size: float, at: tuple[float, float], style: Style
) -> None:
    canvas.pdf.set_font(run.family, size=size * POINT)
    font = canvas.pdf.fonts[run.family]
    if str(style["stroke"]) != "none":
        path = outline_words(font, run.words, size * POINT, at[0] * POINT, at[1] * POINT)
        pens = " ".join(_pen(style))
        canvas.out(f"q {colour(str(style['stroke']))} RG {pens}", path, "S Q")
        return
    fill = colour(str(style["fill"]))
    bold = style.get("font_weight") == "bold"
    mode = f"2 Tr {BOLD * size * POINT:.3f} w 0 J 1 j" if bold else "0 Tr"
    canvas.out(f"q {fill} rg {fill} RG {mode}", f"BT /F{font.i} {size * POINT:.3f} Tf ET")
    canvas.pdf.text(at[0], canvas.pdf.h - at[1], run.words)
    canvas.out("Q")
