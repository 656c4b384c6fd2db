"""Sheets that a plan fills: the scale and the paper for homes, and where their schedule stands."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from scenewright.drawing.legend import Arrangement, LegendRow, arrange, below, beside
from scenewright.drawing.sheet import PaperSheet, drawing_area

USUAL, LARGER, SMALLER = 50, (25, 20), (100, 200)
"""Scales: that of a plan that shows furniture, those for small homes, those for large ones."""

FORMATS = ((297.0, 210.0), (420.0, 297.0), (594.0, 420.0), (841.0, 594.0))
"""A4, A3, A2 and A1, lying, in millimetres."""

ENOUGH, NARROW = 0.7, 51.0
"""The share of its field a plan should fill; millimetres of a column of the schedule."""

LYING = 1.2
"""A landscape sheet is preferred until a plan fills a portrait one this many times better."""
LARGEST = 1.4
"""Most times their usual height that names of rooms grow with the sheet."""

Need = tuple[float, float]


def arrange_filled(need: Need, extra: Need, rows: Sequence[LegendRow]) -> Arrangement:
    """1:50 on the smallest sheet up to A2; where the plan would fill less than 0.7 of its field,
    the one of 1:50, 1:25 and 1:20 that fills most of a sheet up to A3; 1:100 and smaller
    only where 1:50 does not fit. The schedule stands where the plan fills more of what is left.

    ``need`` is the drawing in metres to scale, ``extra`` millimetres that stay as they are.

    >>> arrange_filled((4.8, 3.9), (14.0, 35.0), [LegendRow("letter", "Bed")] * 9).sheet
    PaperSheet(width=420.0, height=297.0, scale=20)
    """
    usual = next(_best_sheets(need, extra, rows, USUAL, 3), None)
    if usual and _share(need, extra, usual) >= ENOUGH:
        return usual
    closer = [found for scale in LARGER for found in _best_sheets(need, extra, rows, scale, 2)]
    found = [usual, *closer] if usual else closer
    if found:
        return max(found, key=lambda arranged: _share(need, extra, arranged))
    farther = (found for scale in SMALLER for found in _best_sheets(need, extra, rows, scale, 4))
    return next(farther, None) or arrange(need, extra, rows)


def _best_sheets(
    need: Need, extra: Need, rows: Sequence[LegendRow], scale: int, formats: int
) -> Iterator[Arrangement]:
    """For each of ``formats`` formats that holds plan and schedule, the arrangement that suits the
    plan: a tall plan lies high on a landscape sheet rather than in the middle of a portrait one."""
    for long, short in FORMATS[:formats]:
        papers = [PaperSheet(*paper, scale) for paper in ((long, short), (short, long))]
        found = [way for paper in papers for way in _ways(paper, need, extra, rows)]
        if found:
            yield max(found, key=lambda arranged: _suit(need, extra, arranged))


def _ways(
    sheet: PaperSheet, need: Need, extra: Need, rows: Sequence[LegendRow]
) -> list[Arrangement]:
    wide, high = _on_paper(need, extra, sheet)
    if not rows:
        room = drawing_area(sheet)
        return [Arrangement(sheet, room, ())] if wide <= room[0] and high <= room[1] else []
    tried = [way(sheet, wide, high, rows, NARROW) for way in (beside, below)]
    return [found for found in tried if found is not None]


def _share(need: Need, extra: Need, arranged: Arrangement) -> float:
    wide, high = _on_paper(need, extra, arranged.sheet)
    return wide * high / (arranged.room[0] * arranged.room[1])


def _suit(need: Need, extra: Need, arranged: Arrangement) -> float:
    """How well a plan lies on its field: the share it fills, a little more on a lying sheet."""
    lying = arranged.sheet.width > arranged.sheet.height
    return _share(need, extra, arranged) * (LYING if lying else 1.0)


def _on_paper(need: Need, extra: Need, sheet: PaperSheet) -> Need:
    """Width and height of the drawing in millimetres."""
    wide, high = (n * 1000 / sheet.scale + more for n, more in zip(need, extra, strict=True))
    return wide, high


def enlarge_names(sheet: PaperSheet) -> float:
    """How many times as large as on A4 the names of rooms are at best: a larger sheet is looked at
    from farther away, or smaller on a screen.

    >>> [round(enlarge_names(PaperSheet(*paper, 50)), 2) for paper in FORMATS]
    [1.0, 1.19, 1.4, 1.4]
    """
    return float(min(LARGEST, (max(sheet.width, sheet.height) / FORMATS[0][0]) ** 0.5))
