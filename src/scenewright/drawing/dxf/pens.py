"""Pens of DXF: colours, line weights and line types of the styles of marks."""

from __future__ import annotations

from itertools import pairwise
from typing import Any

import numpy as np

from scenewright.drawing.marks import GREY, INK, PALE, POCHE, Style
from scenewright.drawing.shell import FLOOR

WEIGHTS = (0, 5, 9, 13, 15, 18, 20, 25, 30, 35, 40, 50, 53, 60, 70, 80, 90, 100, 106, 120, 140, 158)
"""Line weights that DXF knows, hundredths of a millimetre; there are thicker ones."""

INDEXED = {INK: 7, POCHE: 7, "#000000": 7, GREY: 8, PALE: 9}
"""Colours that CAD programs adapt to a dark or white background, by AutoCAD's index."""
NO_INK = ("none", "#ffffff", FLOOR)
"""Fills that only cover what lies below."""


def colour_attributes(colour: str) -> dict[str, int]:
    """A colour as attributes of an entity.

    >>> colour_attributes("#0064a8"), colour_attributes("#1f2226")
    ({'true_color': 25768}, {'color': 7})
    """
    if colour in INDEXED:
        return {"color": INDEXED[colour]}
    short = colour.lstrip("#")
    full = short if len(short) == 6 else "".join(letter * 2 for letter in short)
    return {"true_color": int(full, 16)}


def line_weight(millimetres: float) -> int:
    """The nearest line weight.

    >>> line_weight(0.5), line_weight(0.13), line_weight(0.22)
    (50, 13, 20)
    """
    return int(WEIGHTS[int(np.argmin(np.abs(np.array(WEIGHTS) - 100 * millimetres)))])


def inherit(outer: Style, inner: Style) -> Style:
    """A style within that of the group it is in."""
    return {**outer, **inner}


def stroke_of(style: Style) -> str:
    """The colour of a mark's pen, ``none`` for none (as in SVG, where a mark does not say)."""
    return str(style.get("stroke", "none"))


def fill_of(style: Style) -> str:
    """The fill of a mark; black where it states none, as in SVG."""
    return str(style.get("fill", "#000000"))


def pen_attributes(style: Style, size: float, types: LineTypes) -> dict[str, Any]:
    """Colour, weight and line type of a mark, drawn with ``size`` units a millimetre of paper."""
    width = float(style.get("stroke_width", 0.25))
    found: dict[str, Any] = {"lineweight": line_weight(width)}
    found.update(colour_attributes(stroke_of(style)))
    dashes = str(style.get("stroke_dasharray", "none"))
    if dashes != "none":
        found["linetype"] = types.name(dashes, size)
    return found


class LineTypes:
    """The dashed line types of a document, one for each pattern and scale, made when needed."""

    def __init__(self, table: Any) -> None:
        self._table = table
        self._names: dict[tuple[str, float], str] = {}

    def name(self, dashes: str, size: float) -> str:
        """The line type of dashes and gaps in millimetres, as SVG writes them, at ``size`` units a
        millimetre."""
        key = (dashes, round(size, 9))
        if key not in self._names:
            self._names[key] = f"DASHES{len(self._names) + 1}"
            self._table.add(self._names[key], _pattern(dashes, size), description=dashes)
        return self._names[key]


def _pattern(dashes: str, size: float) -> list[float]:
    """A pattern of DXF: its length, then dashes and, negative, gaps."""
    lengths = [float(part) * size for part in dashes.replace(",", " ").split()]
    lengths *= 1 + len(lengths) % 2
    signed = [length if k % 2 == 0 else -length for k, length in enumerate(lengths)]
    return [sum(lengths), *signed]


def pattern_lines(turn: float, tile: tuple[float, float], rows: list[Any], size: float) -> Any:
    """The lines of a hatch: those of the ``rows`` of points of a tile that cross it along its
    sides, each repeated by the tile's other side.

    >>> pattern_lines(45.0, (1.4, 1.4), [[(0, 0), (0, 1.4)]], 1.0)
    [[45.0, (0.0, 0.0), (-0.98995, 0.98995), []]]
    """
    wide, high = tile
    found = []
    for points in rows:
        for (x0, y0), (x1, y1) in pairwise(points):
            upright = abs(x1 - x0) < abs(y1 - y0)
            angle = ((90.0 if upright else 0.0) - turn) % 180.0
            step = wide if upright else high
            base = _turned(x0 * size, -y0 * size, -turn)
            away = np.radians(angle + 90.0)
            offset = (step * size * np.cos(away), step * size * np.sin(away))
            found.append([angle, base, tuple(round(float(v), 5) for v in offset), []])
    return found


def _turned(x: float, y: float, degrees: float) -> tuple[float, float]:
    cos, sin = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return (round(float(x * cos - y * sin), 6) + 0.0, round(float(x * sin + y * cos), 6) + 0.0)
