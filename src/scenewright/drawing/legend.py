"""The legend of a plan: rows of signs and words, beside the drawing or below it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from scenewright.drawing.marks import (
    EXIT,
    FINE,
    GREY,
    INK,
    LINE,
    NOTHING,
    POCHE,
    ROUTE,
    Mark,
    arrow_head,
    clean,
    fit_text,
    group,
    line,
    shape,
    text,
    text_width,
)
from scenewright.drawing.outlets import outlet_sign
from scenewright.drawing.sheet import EDGE, SCALES, PaperSheet, choose, drawing_area, papers
from scenewright.drawing.signs import PEN, bubble, end_mark, narrow_mark, start_mark

COLUMN, ROW, INSET, TEXT = 64.0, 4.1, 4.0, 2.2
"""Millimetres: width of a column, height of a row, space around, text height."""

SIGN = 8.0
"""Width of the signs before the words."""


class LegendRow(NamedTuple):
    """One row: its sign (``heading``, ``swatch``, ``stop`` …), words on the left and on the
    right, and what the sign needs: a colour or a number."""

    sign: str
    words: str
    right: str = ""
    value: str = ""


class Arrangement(NamedTuple):
    """A sheet, the room left for the drawing (width and height in millimetres), and the columns
    of the legend, each with the paper point of its upper left corner and all ``width`` wide."""

    sheet: PaperSheet
    room: tuple[float, float]
    columns: tuple[tuple[float, float, tuple[LegendRow, ...]], ...]
    width: float = COLUMN


def arrange(
    need: tuple[float, float],
    extra: tuple[float, float],
    rows: Sequence[LegendRow],
    large: int = 200,
) -> Arrangement:
    """The largest scale, then the smallest paper on which drawing and legend fit.

    ``need`` is the drawing in metres to scale, ``extra`` millimetres that stay as they are.
    Papers larger than A3 are only used from the scale ``large`` on.
    """
    for scale in SCALES if rows else ():
        wide, high = (n * 1000 / scale + more for n, more in zip(need, extra, strict=True))
        for paper in papers(scale, large):
            found = beside(PaperSheet(*paper, scale), wide, high, rows)
            found = found or below(PaperSheet(*paper, scale), wide, high, rows)
            if found is not None:
                return found
    sheet = choose(*need, *extra)
    return Arrangement(sheet, drawing_area(sheet), ())


def beside(
    sheet: PaperSheet, wide: float, high: float, rows: Sequence[LegendRow], width: float = COLUMN
) -> Arrangement | None:
    """The legend in columns on the right of the drawing, if both fit."""
    room_wide, room_high = drawing_area(sheet)
    columns = _flow(rows, int((room_high - 2 * INSET) / ROW))
    room_wide -= len(columns) * width + INSET / 2
    if wide > room_wide or high > room_high:
        return None
    left = EDGE + room_wide
    placed = tuple((left + k * width, EDGE + INSET, part) for k, part in enumerate(columns))
    return Arrangement(sheet, (room_wide, room_high), placed, width)


def below(
    sheet: PaperSheet, wide: float, high: float, rows: Sequence[LegendRow], width: float = COLUMN
) -> Arrangement | None:
    """The legend in columns below the drawing, as low as can be, if both fit."""
    room_wide, room_high = drawing_area(sheet)
    most = int((room_wide - INSET) / width)
    per = next((n for n in range(1, len(rows) + 1) if len(_flow(rows, n)) <= most), len(rows))
    columns = _flow(rows, per)
    room_high -= max(len(part) for part in columns) * ROW + 2 * INSET
    if wide > room_wide or high > room_high or len(columns) > most:
        return None
    step = (room_wide - INSET) / max(len(columns), 1)
    top = EDGE + room_high + INSET
    placed = tuple((EDGE + INSET / 2 + k * step, top, part) for k, part in enumerate(columns))
    return Arrangement(sheet, (room_wide, room_high), placed, width)


def _flow(rows: Sequence[LegendRow], per: int) -> list[tuple[LegendRow, ...]]:
    """Rows in columns of at most ``per``; no column ends with a heading."""
    columns: list[tuple[LegendRow, ...]] = []
    rest = list(rows)
    while rest:
        cut = min(max(per, 2), len(rest))
        if cut < len(rest) and rest[cut - 1].sign == "heading" and cut > 1:
            cut -= 1
        columns.append(tuple(rest[:cut]))
        rest = rest[cut:]
    return columns


def legend_mark(arranged: Arrangement) -> Mark:
    """The columns with a thin line that parts them from the drawing: below it, or round the block
    in the corner."""
    if not arranged.columns:
        return NOTHING
    sheet, (wide, high) = arranged.sheet, arranged.room
    beside = wide < drawing_area(sheet)[0] - 1e-6
    if beside:
        foot = max(top + len(rows) * ROW for _, top, rows in arranged.columns) + INSET
        side, foot = EDGE + wide, min(foot, EDGE + high)
        ends = [(side, EDGE), (side, foot), (sheet.width - EDGE, foot)]
    else:
        ends = [(EDGE, EDGE + high), (EDGE + wide, EDGE + high)]
    marks = [line(ends, stroke=INK, stroke_width=LINE)]
    for left, top, rows in arranged.columns:
        for number, row in enumerate(rows):
            marks.append(_row(row, left + INSET, top + (number + 0.5) * ROW, arranged.width))
    return group(marks, fill="none")


def _row(row: LegendRow, left: float, y: float, width: float) -> Mark:
    room = width - INSET
    if row.sign == "heading":
        rule = line(
            [(left, y + ROW / 2 - 0.4), (left + room - 2, y + ROW / 2 - 0.4)],
            stroke=GREY,
            stroke_width=FINE,
        )
        return group([_words(row.words, left, y, 1.05 * TEXT, weight="bold"), rule])
    wide = text_width(row.right, 0.9 * TEXT) + 2.0 if row.right else 0.0
    words, size = fit_text(clean(row.words, 80), TEXT, room - SIGN - wide - 2.0, 0.75)
    marks = [_sign(row, left, y), _words(words, left + SIGN, y, size)]
    if row.right:
        marks.append(_words(row.right, left + room - 2.0, y, 0.9 * TEXT, anchor="end", fill=GREY))
    return group(marks)


def _words(
    words: str,
    x: float,
    y: float,
    size: float,
    anchor: str = "start",
    weight: str = "normal",
    fill: str = INK,
) -> Mark:
    style: dict[str, str | float] = {"text_anchor": anchor, "font_weight": weight, "fill": fill}
    return text(words, (x, y), size, 0.0, stroke="none", **style)


def _sign(row: LegendRow, left: float, y: float) -> Mark:
    """The sign of a row, in the ``SIGN`` millimetres before its words."""
    middle = np.array([left + SIGN / 2 - 0.9, y])
    box = [(left, y - 1.4), (left + 5.6, y - 1.4), (left + 5.6, y + 1.4), (left, y + 1.4)]
    flat = [(left, y), (left + 6.2, y)]
    match row.sign:
        case "swatch":
            return shape([box], fill=row.value, stroke=GREY, stroke_width=FINE)
        case "letter":
            return _words(row.value, left, y, TEXT, weight="bold")
        case "outlet":
            return outlet_sign(row.value, np.array([left + 1.0, y]), np.array([1.0, 0.0]))
        case "stop" | "number":
            return bubble(int(row.value), middle, filled=row.sign == "stop")
        case "route":
            head = arrow_head((left + 6.4, y), (1, 0), 2.0)
            bar = line(flat, stroke=ROUTE, stroke_width=PEN, stroke_dasharray="2.4 1.1")
            return group([bar, shape([head], fill=ROUTE)])
        case "ends":
            return group([start_mark((left + 1.4, y)), end_mark((left + 5.0, y))])
        case "tight":
            return narrow_mark(np.array([(left + 0.6, y), (left + 5.6, y)]))
        case "border":
            return line(flat, stroke=GREY, stroke_width=LINE, stroke_dasharray="1.6 1")
        case "wall":
            thin = [(left, y - 0.6), (left + 5.6, y - 0.6), (left + 5.6, y + 0.6), (left, y + 0.6)]
            return shape([thin], fill=POCHE, stroke=INK, stroke_width=LINE)
        case "passage":
            heads = [arrow_head((left + end, y), (way, 0), 1.5) for end, way in ((0, -1), (6, 1))]
            bar = line([(left, y), (left + 6, y)], stroke=INK, stroke_width=LINE)
            return group([bar, *(shape([head], fill=INK) for head in heads)])
        case "entrance" | "exit":
            up = row.sign == "exit"
            tip, foot = (y - 1.15, y + 1.15) if up else (y + 1.15, y - 1.15)
            x = float(middle[0])
            return shape([[(x, tip), (x - 1.3, foot), (x + 1.3, foot)]], fill=EXIT if up else INK)
    return NOTHING
