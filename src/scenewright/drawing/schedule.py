"""The schedule as sheets: every piece by room, with its kind, model and size."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from scenewright.core.catalog import Catalog
from scenewright.core.scene import STAIRS, Scene
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.marks import FINE, GREY, INK, Mark, clean, group, line, text
from scenewright.drawing.sheet import EDGE, STRIP, PaperSheet, TitleBlock, sheet_mark

HEADS = ("Room", "Piece", "Model", "Width", "Depth", "Height", "Number")
COLUMNS = (0.0, 55.0, 110.0, 192.0, 211.0, 230.0, 252.0)
"""Heads of the columns, and where they begin, millimetres from the left edge."""
ROW, SIZE, TOP = 5.0, 2.4, 9.0
PAPER = PaperSheet(297.0, 210.0, 0)

Row = tuple[str, ...]


def schedule_rows(scene: Scene, catalog: Catalog) -> list[Row]:
    """A row for each model and size in each room, with how many there are."""
    names = {space.id: space.name or space.id for space in scene.spaces}
    order = {space.id: number for number, space in enumerate(scene.spaces)}
    counts: Counter[tuple[int, Row]] = Counter()
    for piece in scene.pieces:
        if piece.function == STAIRS or piece.space not in names:
            continue
        kind, asset = catalog.kinds.get(piece.category), catalog.assets.get(piece.asset)
        sizes = tuple(f"{side:.2f}" for side in piece.size)
        words = (kind.name if kind else piece.category, asset.name if asset else piece.asset)
        row = (names[piece.space], words[0].capitalize(), words[1], *sizes)
        counts[order[piece.space], row] += 1
    return [(*row, str(count)) for (_, row), count in sorted(counts.items())]


def schedule_sheets(rows: Sequence[Row], name: str, first: int, date: str) -> list[PlanDrawing]:
    """The rows on as many sheets as they need, numbered from ``first``; none without rows."""
    most = int((PAPER.height - 2 * EDGE - STRIP - TOP - 4.0) / ROW)
    pages = [rows[k : k + most] for k in range(0, len(rows), most)]
    return [
        PlanDrawing(
            name,
            PAPER,
            (),
            (
                PlanLayer("Sheet", _title(name, pages, k, TitleBlock(str(first + k), date))),
                PlanLayer("Schedule", _table(page)),
            ),
        )
        for k, page in enumerate(pages)
    ]


def _title(name: str, pages: Sequence[Sequence[Row]], number: int, block: TitleBlock) -> Mark:
    return sheet_mark(PAPER, name, _summary(number, pages), block)


def _summary(number: int, pages: Sequence[Sequence[Row]]) -> str:
    pieces = sum(int(row[-1]) for page in pages for row in page)
    return f"Schedule of furniture · {pieces} pieces · page {number + 1} of {len(pages)}"


def _table(rows: Sequence[Row]) -> Mark:
    left, y = EDGE + 5.0, EDGE + TOP
    marks = [_row(HEADS, left, y, "bold")]
    rule = [(left, y + 0.6 * ROW), (PAPER.width - EDGE - 5.0, y + 0.6 * ROW)]
    marks.append(line(rule, stroke=GREY, stroke_width=FINE))
    for number, row in enumerate(rows):
        marks.append(_row(row, left, y + (number + 1.2) * ROW, "normal"))
    return group(marks)


def _row(words: Row, left: float, y: float, weight: str) -> Mark:
    marks = []
    for number, (word, x) in enumerate(zip(words, COLUMNS, strict=True)):
        right = number >= 3
        style: dict[str, str | float] = {
            "text_anchor": "end" if right else "start",
            "font_weight": weight,
            "fill": INK,
            "stroke": "none",
        }
        marks.append(
            text(clean(word, 42), (left + x + (14.0 if right else 0.0), y), SIZE, 0.0, **style)
        )
    return group(marks)
