"""Draw every pattern of halls on one sheet: ``python -m benchmarks.draw_patterns patterns.svg``.

The blue arrow is the front of a pattern.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from shapely import Polygon, unary_union

from scenewright.assets import shipped
from scenewright.encodings.patterns import PATTERNS, WALL
from scenewright.encodings.patterns.expand import expand, seed
from scenewright.formats.svg_marks import (
    GREY,
    INK,
    POCHE,
    ROUTE,
    View,
    arrow_head,
    fitted,
    group,
    line,
    shape,
    tag,
    text,
)  # fmt: skip
from scenewright.formats.svg_pieces import footprint, pieces_mark
from scenewright.scene import Piece, Pose, Size

EXAMPLES = {
    "single": ("info_desk", 1, 0.0, 1.0, 1.0),
    "chain": ("gondola", 18, 0.6, 0.02, 1.6),
    "grid": ("plinth", 12, 0.7, 1.2, 1.4),
    "radiation": ("showcase", 14, 0.4, 1.0, 1.4),
    "circulation": ("ring_shelf", 10, 0.0, 0.02, 1.4),
    "fan": ("auditorium_seat", 48, 0.5, 0.06, 0.5),
    "mixture": ("showcase", 20, 0.5, 1.0, 1.4),
    "wall": ("wall_exhibit", 6, 0.0, 0.05, 0.0),
}
"""The example of each pattern: asset, number of objects, shape, gaps along rows and across."""

WIDE, HIGH, COLUMNS, ROOM = 62.0, 64.0, 4, 46.0
"""Millimetres of a cell, cells in a row, and the most a pattern takes."""


def sheet() -> str:
    """The SVG text: a cell for every pattern, with its name and what it is."""
    marks = [_cell(number, name) for number, name in enumerate(PATTERNS)]
    width, height = WIDE * COLUMNS, HIGH * -(-len(PATTERNS) // COLUMNS)
    paper = tag("rect", width=width, height=height, fill="#ffffff")
    return tag(
        "svg", "\n".join([paper, *marks]), xmlns="http://www.w3.org/2000/svg", version="1.1",
        width=f"{width:g}mm", height=f"{height:g}mm", viewBox=f"0 0 {width:g} {height:g}",
        font_family="Helvetica, Arial, 'DejaVu Sans', sans-serif",
    )  # fmt: skip


def example(name: str) -> list[Piece]:
    """The objects of one pattern, its middle in the origin, its front to +y."""
    asset = shipped().assets[EXAMPLES[name][0]]
    places = _places(name, asset.usual)
    return [
        Piece(str(k), asset.category, asset.id, "", Pose(x, y, 0.0, np.pi / 2 + turn), asset.usual)
        for k, (x, y, turn) in enumerate(places.tolist())
    ]


def _places(name: str, size: Size) -> NDArray[np.float64]:
    """Rows x, y and turn of the objects."""
    _, count, form, along, across = EXAMPLES[name]
    code = list(PATTERNS).index(name)
    if code == WALL:
        x = (np.arange(count) - (count - 1) / 2) * (size.width + along)
        return np.column_stack([x, np.zeros(count), np.full(count, np.pi)])
    layers, out = np.zeros((max(count, 8), 5)), np.zeros((count, 3))
    used, extra = seed(code, count, form, size.width, size.depth, along, across, 1.5, layers)
    expand(code, layers[:used], extra, np.tile(size[:2], (count, 1)), 0, out)
    return out


def _cell(number: int, name: str) -> str:
    row, column = divmod(number, COLUMNS)
    left, top = column * WIDE, row * HIGH
    pieces = example(name)
    west, south, east, north = unary_union([Polygon(footprint(p)) for p in pieces]).bounds
    scale = min(ROOM / max(east - west, north - south), 14.0)
    middle = np.array([left + WIDE / 2, top + 6.0 + ROOM / 2])
    x, y = middle - scale * np.array([west + east, -south - north]) / 2
    marks = [pieces_mark(View(scale, x, y), pieces, shipped())]
    reach = scale * np.array([east - west, north - south]) / 2
    if name == "wall":
        low, high = middle - reach - (3.0, 2.0), middle - (-reach[0] - 3.0, reach[1])
        wall = [low, (high[0], low[1]), high, (low[0], high[1])]
        marks.append(shape([wall], fill=POCHE))
    else:
        tip = middle - (0.0, reach[1] + 4.5)
        marks.append(line([tip - (0.0, -3.0), tip], stroke=ROUTE, stroke_width=0.3))
        marks.append(shape([arrow_head(tip, (0, -1), 1.6)], fill=ROUTE))
    about, size = fitted(PATTERNS[name].about, 2.1, WIDE - 4, 0.7)
    marks.append(text(name, (middle[0], top + HIGH - 8.6), 3.0, font_weight="bold", fill=INK))
    marks.append(text(about, (middle[0], top + HIGH - 4.6), size, fill=GREY))
    return group(marks)


if __name__ == "__main__":
    Path(sys.argv[1] if len(sys.argv) > 1 else "patterns.svg").write_text(sheet(), "utf-8")
