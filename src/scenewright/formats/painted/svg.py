"""Plans from SVG by svgelements (extra ``svg``): shapes in place, words, layers by their labels."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from scenewright.building.drawn.drawing import Word
from scenewright.building.drawn.paper import Paper, Run, Shape
from scenewright.core.errors import InputError
from scenewright.core.extras import require
from scenewright.core.isolated_reading import Allowance, read_apart

if TYPE_CHECKING:
    from scenewright.core.brief import Brief

require("svgelements")
ALLOWANCE = Allowance(memory=768, per_size=16, seconds=40)
MOST_BYTES, MOST_SHAPES = 20_000_000, 100_000
PIXELS = 96.0
"""Pixels of an inch on paper."""
CUTS = 8
"""Lines that a curve is cut into."""
LABELS = ("{http://www.inkscape.org/namespaces/inkscape}label", "id", "class")
"""Attributes that may name a layer; those of a shape include those of its groups."""


def read(path: str | os.PathLike[str], keep: bool = False, scale: float = 1.0) -> Brief:
    """The brief of a plan; furniture in drawings is left aside, kept or not. ``scale`` is the 50 of
    1:50 where the drawing does not say it.

    Raises :class:`InputError` where the file holds no plan of a building, or none can be read.
    """
    from scenewright.formats.drawn_plan import brief_of

    del keep
    file = Path(path)
    return brief_of(read_apart(__name__, file, ALLOWANCE, {"scale": scale}), file, "SVG")


def extract(path: str, scale: float) -> dict[str, Any]:
    """The plan of a file as plain values (:func:`scenewright.building.drawn.plan.plan_sheet`)."""
    from scenewright.building.drawn.paper_plan import plan_page

    return plan_page(read_page(path), scale)


def read_page(path: str) -> Paper:
    """What an SVG file paints, in pixels, y upwards.

    Raises :class:`InputError` for what is no SVG, damaged, or too large.
    """
    from svgelements import SVG

    if os.path.getsize(path) > MOST_BYTES:
        raise InputError("is larger than 20 MB", "save only the plan of a storey")
    try:
        document = SVG.parse(path, reify=True, ppi=PIXELS)
    except MemoryError:
        raise
    except Exception as error:  # a damaged file: the library raises many kinds of error
        reason = " ".join(str(error).split())[:120] or type(error).__name__
        remedy = "open it in a drawing program and save it as plain SVG"
        raise InputError(f"is no readable SVG ({reason})", remedy) from None
    shapes, words, pictures = _elements(document)
    if not shapes and pictures:
        raise InputError(
            "holds a picture and no lines: plans are not read from pictures",
            "draw the walls over it as lines, or write a brief",
        )
    points = [run.points for shape in shapes for path in shape.subpaths for run in path]
    if not points:
        raise InputError("holds no lines", "give the plan of a storey")
    corners = np.array([[0.0, -float(document.height)], [float(document.width), 0.0]])
    printed = str(document.values.get("width", "")).strip().endswith(("mm", "cm", "in", "pt", "pc"))
    return Paper(tuple(shapes), tuple(words), corners[0], corners[1], 0.0254 / PIXELS, printed)


def _elements(document: Any) -> tuple[list[Shape], list[Word], int]:
    """Shapes and words of a document, and how many pictures it holds."""
    from svgelements import Image, Text
    from svgelements import Shape as Drawn

    shapes: list[Shape] = []
    words: list[Word] = []
    pictures = 0
    for element in document.elements():
        if len(shapes) > MOST_SHAPES:
            raise InputError(
                f"holds more than {MOST_SHAPES:,} shapes", "save only the plan of a storey"
            )
        pictures += isinstance(element, Image)
        if isinstance(element, Text):
            words += _word(element)
        elif isinstance(element, Drawn):
            shapes += _shape(element)
    return shapes, words, pictures


def _word(text: Any) -> Iterator[Word]:
    place = text.transform.point_in_matrix_space((text.x, text.y))
    size = float(text.font_size or 1.0) * float(np.sqrt(abs(text.transform.determinant)))
    yield Word(" ".join(str(text.text or "").split()), float(place.x), -float(place.y), size)


def _shape(element: Any) -> Iterator[Shape]:
    """A shape as it is painted, nothing if it is not."""
    values = element.values
    if values.get("visibility") in ("hidden", "collapse") or values.get("display") == "none":
        return
    fill = None if _is_pattern(values, "fill") else _lightness(element.fill)
    pen = None if _is_pattern(values, "stroke") else _lightness(element.stroke)
    width = float(element.stroke_width or 0.0) * 25.4 / PIXELS
    if fill is None and (pen is None or pen > 0.97):
        return
    subpaths = tuple(tuple(_runs(part)) for part in _path(element).as_subpaths())
    label = next((str(values[key]) for key in LABELS if values.get(key)), "")[:60]
    drawn = None if pen is None or pen > 0.97 else width
    yield Shape(tuple(part for part in subpaths if part), fill, drawn, label)


def _path(element: Any) -> Any:
    from svgelements import Path as SvgPath

    return element if isinstance(element, SvgPath) else SvgPath(element).reify()


def _is_pattern(values: Any, key: str) -> bool:
    """Whether a shape is painted with a pattern or gradient, which the library takes for black."""
    return str(values.get(key, "")).strip().startswith("url(")


def _lightness(colour: Any) -> float | None:
    """Lightness from 0 to 1; ``None`` where nothing is painted."""
    if colour is None or colour.value is None or colour.alpha is None or colour.alpha < 64:
        return None
    return (0.3 * colour.red + 0.59 * colour.green + 0.11 * colour.blue) / 255


def _runs(subpath: Any) -> Iterator[Run]:
    """The runs of a subpath: curves that follow each other are one."""
    from svgelements import Arc, CubicBezier, Move, QuadraticBezier

    points: list[tuple[float, float]] = []
    curved = False
    for segment in subpath:
        if isinstance(segment, Move) or segment.start is None:
            continue
        bends = isinstance(segment, Arc | CubicBezier | QuadraticBezier)
        if points and bends != curved:
            yield Run(np.array(points), curved)
            points = []
        curved = bends
        steps = np.linspace(0.0, 1.0, CUTS + 1) if bends else np.array([0.0, 1.0])
        found = [segment.point(float(t)) for t in steps]
        points += [(float(p.x), -float(p.y)) for p in found[bool(points) :]]
    if len(points) > 1:
        yield Run(np.array(points), curved)
