"""Plans from vector PDF by PDFium (pypdfium2, extra ``pdf``): paths and words of a page."""

from __future__ import annotations

import ctypes
import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from scenewright.building.drawn.drawing import Word
from scenewright.building.drawn.paper import Paper, Run, Shape
from scenewright.core.errors import InputError
from scenewright.core.extras import require
from scenewright.core.isolated_reading import Allowance, read_apart

if TYPE_CHECKING:
    from scenewright.core.brief import Brief

require("pypdfium2")
ALLOWANCE = Allowance(memory=768, per_size=4, seconds=40)
MOST_BYTES, MOST_SHAPES, MOST_PAGES, DEEPEST = 100_000_000, 100_000, 30, 12
POINT = 0.0254 / 72
"""Metres of a unit of a page."""
CUTS = np.linspace(0.0, 1.0, 9)[1:, None]
"""Where a curve is cut into lines."""
PASSWORD = 4
"""PDFium's number for a file that needs a password."""
Matrix = NDArray[np.float64]


def read(path: str | os.PathLike[str], keep: bool = False, scale: float = 1.0) -> Brief:
    """The brief of a set of pages, each that holds a plan a storey; furniture in drawings is left
    aside, kept or not. ``scale`` is the 50 of 1:50 where the page does not say it.

    Raises :class:`InputError` where no page holds the plan of a building, or none can be read.
    """
    from scenewright.formats.drawn_plan import brief_of

    del keep
    file = Path(path)
    return brief_of(read_apart(__name__, file, ALLOWANCE, {"scale": scale}), file, "PDF")


def extract(path: str, scale: float) -> dict[str, Any]:
    """The plan of a file as plain values (:func:`scenewright.building.drawn.plan.plan_sheet`)."""
    from scenewright.formats.painted.pages import read_pages

    document = _open(path)
    count = min(len(document), MOST_PAGES)
    found = read_pages(count, lambda number: read_page(document, number), scale)
    rest = len(document) - count
    reason = f"only the first {MOST_PAGES} pages are read"
    more = [[f"pages from {count + 1}", "page", "left out", reason, rest]] if rest else []
    return found | {"fates": found["fates"] + more}


def _open(path: str) -> Any:
    import pypdfium2 as pdfium

    if os.path.getsize(path) > MOST_BYTES:
        raise InputError("is larger than 100 MB", "save only the page of the plan")
    try:
        return pdfium.PdfDocument(path)
    except pdfium.PdfiumError as error:
        if getattr(error, "err_code", None) == PASSWORD or "password" in str(error).lower():
            raise InputError("is encrypted", "save it without a password") from None
        raise InputError("is no readable PDF", "print it to PDF again from its program") from None


def read_page(document: Any, number: int) -> Paper:
    """What a page paints, in points, y upwards.

    Raises :class:`InputError` where it paints no lines, or too many.
    """
    import pypdfium2.raw as c

    page = document[number]
    shapes: list[Shape] = []
    pictures = 0
    for kind, element, matrix in _elements(page.raw, np.eye(3), 0):
        if len(shapes) > MOST_SHAPES:
            raise InputError(
                f"holds more than {MOST_SHAPES:,} shapes", "print only the plan of a storey"
            )
        pictures += kind == c.FPDF_PAGEOBJ_IMAGE
        if kind == c.FPDF_PAGEOBJ_PATH:
            shapes += _shape(element, matrix)
    if not shapes:
        raise InputError(*(PICTURE if pictures else ("holds no lines", "give a plan's page")))
    left, bottom, right, top = page.get_mediabox()
    low, high = np.array([left, bottom]), np.array([right, top])
    return Paper(tuple(shapes), tuple(_words(page)), low, high, POINT, True)


PICTURE = (
    "holds a picture and no lines: plans are not read from pictures",
    "print the plan to PDF from the program it was drawn in, or write a brief",
)


def _elements(holder: Any, matrix: Matrix, depth: int) -> Iterator[tuple[int, Any, Matrix]]:
    """All objects of a page or form, with their kind and the matrix to the page."""
    import pypdfium2.raw as c

    count = c.FPDFFormObj_CountObjects if depth else c.FPDFPage_CountObjects
    get = c.FPDFFormObj_GetObject if depth else c.FPDFPage_GetObject
    for number in range(count(holder)):
        element = get(holder, number)
        kind = c.FPDFPageObj_GetType(element)
        own = _matrix(element) @ matrix
        if kind == c.FPDF_PAGEOBJ_FORM and depth < DEEPEST:
            yield from _elements(element, own, depth + 1)
        yield kind, element, own


def _matrix(element: Any) -> Matrix:
    """The matrix of an object for rows (x, y, 1)."""
    import pypdfium2.raw as c

    found = c.FS_MATRIX()
    c.FPDFPageObj_GetMatrix(element, found)
    return np.array(
        [[found.a, found.b, 0.0], [found.c, found.d, 0.0], [found.e, found.f, 1.0]], dtype=float
    )


def _shape(element: Any, matrix: Matrix) -> Iterator[Shape]:
    """A path as it is painted, nothing if it is not."""
    import pypdfium2.raw as c

    filled, stroked = ctypes.c_int(), ctypes.c_int()
    c.FPDFPath_GetDrawMode(element, filled, stroked)
    fill = _lightness(c.FPDFPageObj_GetFillColor, element) if filled.value else None
    pen = _lightness(c.FPDFPageObj_GetStrokeColor, element) if stroked.value else None
    drawn = pen is not None and pen <= 0.97
    if fill is None and not drawn:
        return
    width = ctypes.c_float()
    c.FPDFPageObj_GetStrokeWidth(element, width)
    size = float(np.sqrt(abs(np.linalg.det(matrix[:2, :2]))))
    subpaths = tuple(tuple(part) for part in _subpaths(element, matrix))
    yield Shape(subpaths, fill, width.value * size * 25.4 / 72 if drawn else None)


def _lightness(get: Any, element: Any) -> float | None:
    """Lightness from 0 to 1; ``None`` where it is a pattern, or nearly transparent."""
    red, green, blue, alpha = (ctypes.c_uint() for _ in range(4))
    if not get(element, red, green, blue, alpha) or alpha.value < 64:
        return None
    return (0.3 * red.value + 0.59 * green.value + 0.11 * blue.value) / 255


def _subpaths(element: Any, matrix: Matrix) -> Iterator[list[Run]]:
    """The subpaths of a path, each of runs: curves that follow each other are one."""
    part: list[Run] = []
    points: list[Matrix] = []
    curved = False
    for kind, found in _segments(element, matrix):
        if kind != "move" and points and len(points) > 1 and (kind == "curve") != curved:
            part.append(Run(np.array(points), curved))
            points = points[-1:]
        if kind == "move":
            part += [Run(np.array(points), curved)] if len(points) > 1 else []
            yield part
            part, points = [], []
        curved = kind == "curve"
        points += found
    yield [*part, Run(np.array(points), curved)] if len(points) > 1 else part


def _segments(element: Any, matrix: Matrix) -> Iterator[tuple[str, list[Matrix]]]:
    """What each segment of a path is (move, line, curve), and the points it adds."""
    import pypdfium2.raw as c

    first = here = np.zeros(2)
    controls: list[Matrix] = []
    for number in range(c.FPDFPath_CountSegments(element)):
        segment = c.FPDFPath_GetPathSegment(element, number)
        x, y = ctypes.c_float(), ctypes.c_float()
        c.FPDFPathSegment_GetPoint(segment, x, y)
        point = (np.array([x.value, y.value, 1.0]) @ matrix)[:2]
        kind = c.FPDFPathSegment_GetType(segment)
        if kind == c.FPDF_SEGMENT_BEZIERTO:
            controls.append(point)
            if len(controls) < 3:
                continue
            yield "curve", list(_bezier(here, *controls))
            controls = []
        else:
            yield ("move" if kind == c.FPDF_SEGMENT_MOVETO else "line"), [point]
            first = point if kind == c.FPDF_SEGMENT_MOVETO else first
        here = point
        if c.FPDFPathSegment_GetClose(segment):
            if np.abs(first - here).max() > 1e-6:
                yield "line", [first]
            here = first


def _bezier(a: Matrix, b: Matrix, c: Matrix, d: Matrix) -> Matrix:
    t = CUTS
    points: Matrix = (1 - t) ** 3 * a + 3 * (1 - t) ** 2 * t * b + 3 * (1 - t) * t**2 * c + t**3 * d
    return points


def _words(page: Any) -> Iterator[Word]:
    """Words of a page, each at the middle of its box."""
    text = page.get_textpage()
    for number in range(text.count_rects()):
        left, bottom, right, top = text.get_rect(number)
        words = " ".join(text.get_text_bounded(left, bottom, right, top).split())
        yield Word(words, (left + right) / 2, (bottom + top) / 2, min(top - bottom, right - left))
