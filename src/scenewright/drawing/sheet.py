"""The sheet of paper: which size, which scale, frame, title block, scale bar, north arrow."""

from __future__ import annotations

import re
from typing import NamedTuple

from scenewright._version import __version__
from scenewright.core.brief import Brief
from scenewright.drawing.marks import (
    FINE,
    GREY,
    INK,
    LINE,
    OUTLINE,
    Mark,
    PaperView,
    clean,
    disc,
    fit_text,
    group,
    line,
    shape,
    text,
    text_width,
)

SCALES = (50, 100, 200, 500, 1000, 2000, 5000, 10_000)
PAPERS = ((297.0, 210.0), (210.0, 297.0), (420.0, 297.0), (297.0, 420.0))
"""A4 and A3, lying and standing, in millimetres."""
LARGE = ((594.0, 420.0), (420.0, 594.0), (841.0, 594.0), (594.0, 841.0))
"""A2 and A1: only for what is too large for A3 at 1:100."""

EDGE, STRIP = 7.0, 15.0
"""Millimetres from the paper's edge to the frame, and height of the title strip."""


_ID = re.compile(r"(?=[0-9a-f]*[0-9])(?=[0-9a-f]*[a-f])\b[0-9a-f]{12,}\b", re.IGNORECASE)
"""Numbers that files are stored by."""


class PaperSheet(NamedTuple):
    """Width and height in millimetres, and the scale as in 1:50."""

    width: float
    height: float
    scale: int


class TitleBlock(NamedTuple):
    """What a sheet is filed by: its number and the date it was issued (as stated: no clock is
    read, so that the same solution gives the same drawing)."""

    number: str = "1"
    date: str = ""


UNDATED = TitleBlock()


def title_of(brief: Brief) -> TitleBlock:
    """What a brief states of the sheet its plan is drawn on.

    >>> room = {"outline": [[0, 0], [3, 0], [3, 4], [0, 4]]}
    >>> title_of(Brief(rooms=[room], sheet="A-101", date="2026-11-22"))
    TitleBlock(number='A-101', date='2026-11-22')
    """
    return TitleBlock(brief.sheet or "1", brief.date)


def number_sheets(block: TitleBlock, count: int) -> list[TitleBlock]:
    """The title blocks of ``count`` sheets of a set: numbered on, a stated number with a part.

    >>> [row.number for row in number_sheets(UNDATED, 2)]
    ['1', '2']
    >>> [row.number for row in number_sheets(TitleBlock("A-101"), 2)]
    ['A-101.1', 'A-101.2']
    """
    if count == 1:
        return [block]
    plain = block.number == UNDATED.number
    numbers = [str(k) if plain else f"{block.number}.{k}" for k in range(1, count + 1)]
    return [block._replace(number=number) for number in numbers]


def choose(width: float, height: float, extra_width: float, extra_height: float) -> PaperSheet:
    """The largest scale and then smallest paper on which a drawing fits.

    ``width`` and ``height`` are metres to scale; the extras millimetres that stay as they are.

    >>> choose(9.0, 7.0, 30.0, 30.0)
    PaperSheet(width=297.0, height=210.0, scale=50)
    """
    for scale in SCALES:
        need = width * 1000 / scale + extra_width, height * 1000 / scale + extra_height
        for paper in papers(scale):
            if need[0] <= paper[0] - 2 * EDGE and need[1] <= paper[1] - 2 * EDGE - STRIP:
                return PaperSheet(*paper, scale)
    last = SCALES[-1]
    return PaperSheet(
        width * 1000 / last + extra_width + 2 * EDGE,
        height * 1000 / last + extra_height + 2 * EDGE + STRIP,
        last,
    )


def papers(scale: int, large: int = 200) -> tuple[tuple[float, float], ...]:
    """The papers to try at a scale, the smallest first; those above A3 from ``large`` on."""
    return PAPERS if scale < large else PAPERS + LARGE


def sheet_mark(sheet: PaperSheet, name: str, summary: str, block: TitleBlock = UNDATED) -> Mark:
    """Frame and title strip: name and summary take the room that the scale bar leaves; scale,
    number of the sheet and date are on the right. A sheet of scale 0 (a list, pictures) has
    neither scale nor north."""
    right, bottom = sheet.width - EDGE, sheet.height - EDGE
    top = bottom - STRIP
    middle = (top + bottom) / 2
    corners = [(EDGE, EDGE), (right, EDGE), (right, bottom), (EDGE, bottom)]
    room = right - 64 - EDGE - 5
    if sheet.scale:
        unit, divisions = _divisions(sheet.scale, 0.45 * room)
        room -= divisions * unit * 1000 / sheet.scale + 10
    words, size = fit_text(shorten_ids(clean(name, 80)), 4.4, room, wide=1.12)
    line_below, small = fit_text(summary, 2.3, room)
    marks = [
        shape([corners], stroke_width=OUTLINE),
        line([(EDGE, top), (right, top)], stroke_width=LINE),
        line([(right - 44, top), (right - 44, bottom)], stroke_width=LINE),
        line([(right - 58, top), (right - 58, bottom)], stroke_width=LINE),
        _words(words, (EDGE + 5, middle - 2.2), size, weight="bold"),
        _words(line_below, (EDGE + 5, middle + 3.6), small, fill=GREY),
        *(_scale_marks(sheet, right, middle) if sheet.scale else []),
        _words(f"Sheet {clean(block.number, 8)}", (right - 20, middle - 2.2), 2.3, weight="bold"),
        _words(f"Scenewright {__version__}", (right - 40, middle + 3.6), 2.1, fill=GREY),
    ]
    if block.date:
        marks.append(_words(clean(block.date, 10), (right - 17, middle + 3.6), 2.1))
    return group(marks, fill="none", stroke=INK)


def _scale_marks(sheet: PaperSheet, right: float, middle: float) -> list[Mark]:
    """The scale bar, the arrow to the north and the scale."""
    return [
        scale_bar(right - 64, middle + 1.5, sheet.scale, 0.45 * (right - 69 - EDGE)),
        north_arrow(right - 51, middle + 1.2),
        _words(f"1:{sheet.scale}", (right - 40, middle - 2.2), 4.4, weight="bold"),
    ]


def shorten_ids(name: str) -> str:
    """A name with the middles of long hexadecimal numbers left out: nobody reads them.

    >>> shorten_ids("07-ee-d0bc3031a7f3d6848c7a64826307-0002"), shorten_ids("Flat 12, Feedbackstr.")
    ('07-ee-d0bc30…-0002', 'Flat 12, Feedbackstr.')
    """
    return _ID.sub(lambda found: f"{found[0][:6]}…", name)


def _divisions(scale: int, most: float) -> tuple[float, int]:
    """Metres of a division of the scale bar, and how many: four, or two in a narrow strip."""
    units = (0.5, 1, 2, 5, 10, 20, 50, 100, 200)[scale >= SCALES[0] :]
    unit = next(u for u in units if u * 1000 / scale >= 9)
    return unit, 4 if 4 * unit * 1000 / scale + 4 <= most else 2


def scale_bar(right: float, y: float, scale: int, most: float = 100.0) -> Mark:
    """A bar of divisions, black and white, ending at ``right``, at most ``most`` millimetres
    long; labelled in metres."""
    unit, count = _divisions(scale, most)
    step = unit * 1000 / scale
    left = right - count * step - 4
    marks = []
    for index in range(count):
        x = left + index * step
        box = [(x, y), (x + step, y), (x + step, y + 1.5), (x, y + 1.5)]
        fill = INK if index % 2 == 0 else "#ffffff"
        marks.append(shape([box], fill=fill, stroke_width=FINE))
    for index in dict.fromkeys((0, 1, 2, count)):
        words = f"{index * unit:g}" + (" m" if index == count else "")
        shift = text_width(" m", 1.8) / 2 if index == count else 0.0
        at = (left + index * step + shift, y - 1.8)
        marks.append(text(words, at, 1.8, stroke="none", fill=GREY))
    return group(marks)


def north_arrow(x: float, y: float, radius: float = 4.0) -> Mark:
    """A circle with a needle to the top of the sheet: plans have y to the north."""
    needle = [(x, y - radius), (x - 0.45 * radius, y + 0.78 * radius), (x, y + 0.45 * radius)]
    half = [(x, y - radius), (x + 0.45 * radius, y + 0.78 * radius), (x, y + 0.45 * radius)]
    marks = [
        disc((x, y), radius, stroke_width=FINE, stroke=GREY),
        shape([needle], fill=INK, stroke_width=FINE),
        shape([half], fill="#ffffff", stroke_width=FINE),
        text("N", (x, y - 1.3 * radius), 1.9, stroke="none", fill=INK),
    ]
    return group(marks, stroke_linejoin="round")


def drawing_area(sheet: PaperSheet) -> tuple[float, float]:
    """Width and height in millimetres inside the frame, above the title strip."""
    return sheet.width - 2 * EDGE, sheet.height - 2 * EDGE - STRIP


def view_at(sheet: PaperSheet, west: float, south: float, left: float, bottom: float) -> PaperView:
    """The view that puts the plan point (west, south) at the paper point (left, bottom)."""
    scale = 1000 / sheet.scale
    return PaperView(scale, left - west * scale, bottom + south * scale)


def _words(
    words: str, at: tuple[float, float], size: float, weight: str = "normal", fill: str = INK
) -> Mark:
    style: dict[str, str | float] = {
        "text_anchor": "start",
        "font_weight": weight,
        "fill": fill,
        "stroke": "none",
    }
    return text(words, at, size, 0.0, **style)
