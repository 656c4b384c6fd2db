"""A set of sheets as one PDF: a page a sheet, a layer a layer of the plan."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import UTC, datetime
from typing import Any

from fpdf import FPDF

from scenewright._version import __version__
from scenewright.drawing.layers import PlanDrawing
from scenewright.drawing.marks import FillPattern, Stencil
from scenewright.drawing.pdf.canvas import START, Canvas, draw_mark
from scenewright.drawing.pdf.fonts import Fonts, name_missing

UNDATED = datetime(2000, 1, 1, tzinfo=UTC)
"""No clock is read: the same solution gives the same bytes."""


def make_pdf(sheets: Sequence[PlanDrawing], title: str) -> Any:
    """The document of sheets, each a page of its own size."""
    missing = name_missing()
    if missing is not None:
        raise missing
    pdf = FPDF(unit="mm")
    pdf.set_auto_page_break(False)
    pdf.set_creation_date(UNDATED)
    pdf.set_title(title)
    pdf.set_producer(f"Scenewright {__version__}")
    pdf.c_margin = 0
    fonts = Fonts(pdf)
    for sheet in sheets:
        _add_page(pdf, fonts, sheet)
    return pdf


def _add_page(pdf: Any, fonts: Fonts, sheet: PlanDrawing) -> None:
    wide, high = sheet.sheet.width, sheet.sheet.height
    pdf.add_page(orientation="portrait", format=(wide, high))
    patterns = {d.id: d for d in sheet.definitions if isinstance(d, FillPattern)}
    stencils = {d.id: d for d in sheet.definitions if isinstance(d, Stencil)}
    canvas = Canvas(pdf, high, fonts, patterns, stencils)
    for layer in sheet.layers:
        draw_mark(canvas, layer.mark, START)
