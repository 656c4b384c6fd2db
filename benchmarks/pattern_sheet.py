"""Draw every pattern a group of a hall may take, with real objects: ``docs/patterns.svg``.

``python -m benchmarks.pattern_sheet`` writes it anew. The free patterns are seeded and expanded as
the solver does it; the wall row is the answer to a small brief. All are drawn to one scale.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from scenewright.catalog.kinds import SIZES, hall_use
from scenewright.core.brief import Brief, Room
from scenewright.core.brief.zones import Demand
from scenewright.core.layout import corners
from scenewright.domains import solve
from scenewright.domains.hall.patterns import PATTERNS
from scenewright.domains.hall.patterns.expand import expand, seed
from scenewright.drawing.marks import (
    GREY,
    INK,
    LINE,
    NOTHING,
    OUTLINE,
    POCHE,
    Mark,
    PaperView,
    arrow_head,
    group,
    line,
    shape,
    text,
    to_paper,
)
from scenewright.drawing.svg import mark_text, tag

Floats = NDArray[np.float64]

TARGET = Path(__file__).parent.parent / "docs" / "patterns.svg"
SCALE = 8.0
CELL, HEAD = (86.0, 84.0), 19.0
"""Millimetres a metre; millimetres of one cell and of its heading."""
ROWS = (
    ("chain", "grid", "radiation"),
    ("circulation", "fan", "wall"),
    ("mixture", "single"),
    ("around",),
)
WIDE = "mixture"
"""The pattern that takes two cells."""
ALLEY, FRONT, FAN = "#bfe0d6", "#0064a8", "fan"
ROOM = ((0.0, 0.0), (8.4, 0.0), (8.4, 5.6), (0.0, 5.6))


class Example(NamedTuple):
    """What a pattern is drawn with: objects, their number, the ``shape`` it is seeded with."""

    category: str
    number: int
    shape: float
    told: str


EXAMPLES = {
    "single": Example("info_desk", 1, 0.0, "an information desk"),
    "chain": Example("gondola", 15, 0.6, "15 gondolas"),
    "grid": Example("display_table", 9, 0.6, "9 display tables"),
    "radiation": Example("plinth", 9, 0.2, "9 plinths"),
    "circulation": Example("ring_shelf", 12, 0.0, "12 ring shelves"),
    "fan": Example("auditorium_seat", 46, 0.55, "46 seats, apex ahead"),
    "mixture": Example("plinth", 14, 0.5, "14 plinths"),
    "around": Example("lounge_seat", 7, 0.0, "7 lounge seats; tables are set between them"),
    "wall": Example("wall_exhibit", 10, 0.0, "10 wall exhibits"),
}


def free_boxes(name: str, example: Example) -> Floats:
    """Boxes (n, 5) of a pattern as it is seeded, its front up."""
    code, count = list(PATTERNS).index(name), example.number
    wide, deep, _ = SIZES[example.category][1]
    front, left, back, right = hall_use(example.category).clearance
    layers, out = np.zeros((count + 6, 5)), np.zeros((count, 3))
    along, across = left + right, front + back
    used, extra = seed(code, count, example.shape, wide, deep, along, across, 3.0, layers)
    sizes = np.tile([wide, deep], (count, 1))
    expand(code, layers[:used], extra, sizes, 0, out)
    return np.column_stack([out[:, :2], out[:, 2] + math.pi / 2, sizes])


def wall_boxes(example: Example) -> Floats:
    """Boxes (n, 5) of a wall row in a small room, about its middle."""
    demand = Demand(category=example.category, count=example.number)
    room = Room(outline=list(ROOM), demands=[demand])
    pieces = solve(Brief(domain="hall", rooms=[room]), steps=400, seed=1).pieces
    rows = [[*p.pose[:2], p.pose.heading, p.size.width, p.size.depth] for p in pieces]
    return np.array(rows) - [ROOM[2][0] / 2, ROOM[2][1] / 2, 0.0, 0.0, 0.0]


def grown(boxes: Floats, category: str) -> Floats:
    """Boxes (n, 5) with the clearance of a category around them."""
    front, left, back, right = hall_use(category).clearance
    c, s = np.cos(boxes[:, 2]), np.sin(boxes[:, 2])
    ahead, aside = (front - back) / 2, (right - left) / 2
    middles = boxes[:, :2] + np.column_stack([ahead * c + aside * s, ahead * s - aside * c])
    return np.column_stack(
        [middles, boxes[:, 2], boxes[:, 3] + left + right, boxes[:, 4] + front + back]
    )


def drawn(name: str, x: float, y: float, wide: float) -> Mark:
    """One cell so wide with its upper left corner at paper point x, y."""
    example = EXAMPLES[name]
    boxes = wall_boxes(example) if name == "wall" else free_boxes(name, example)
    clear = grown(boxes, example.category)
    reach = corners(clear).reshape(-1, 2)
    if name == FAN:
        reach = np.vstack([reach, apex(boxes)])
    middle = np.zeros(2) if name == "wall" else (reach.min(0) + reach.max(0)) / 2
    centre = x + wide / 2, y + (HEAD + CELL[1]) / 2
    view = PaperView(SCALE, centre[0] - SCALE * middle[0], centre[1] + SCALE * middle[1])
    marks = [
        text(name, (centre[0], y + 7.0), 4.6, font_weight="bold"),
        text(PATTERNS[name].about, (centre[0], y + 12.6), 2.7, fill=GREY),
        text(example.told, (centre[0], y + 16.8), 2.7, fill=GREY),
        group(shape([ring], fill=ALLEY, fill_opacity=0.55) for ring in rings(view, clear)),
        group(
            (shape([ring]) for ring in rings(view, boxes)),
            fill="#ffffff",
            stroke=INK,
            stroke_width=LINE,
        ),
        group(front_marks(view, boxes), fill=FRONT),
        around(name, view, boxes),
    ]
    return group(marks)


def rings(view: PaperView, boxes: Floats) -> Iterable[Floats]:
    """Corners of boxes (n, 5) on paper."""
    return list(to_paper(view, corners(boxes)))


def front_marks(view: PaperView, boxes: Floats) -> list[Mark]:
    """A small arrow head at the front of every object."""
    marks = []
    for x, y, heading, _, depth in boxes:
        way = np.array([math.cos(heading), math.sin(heading)])
        tip = to_paper(view, np.array([x, y]) + way * (depth / 2 - 0.04))
        marks.append(shape([arrow_head(tip, way * (1.0, -1.0), min(2.0, 0.6 * SCALE * depth))]))
    return marks


def around(name: str, view: PaperView, boxes: Floats) -> Mark:
    """What a pattern refers to: the walls of a row, the apex of a fan, the centre of rings."""
    if name == "wall":
        ring = np.array(ROOM) - np.array(ROOM[2]) / 2
        return shape([to_paper(view, ring)], fill="none", stroke=POCHE, stroke_width=1.2)
    if name == FAN:
        at = apex(boxes)
        ends = [boxes[0, :2], at, boxes[int(np.flatnonzero(np.diff(boxes[:, 2]) < 0)[0]), :2]]
        return line(
            to_paper(view, ends), fill="none", stroke=GREY, stroke_width=0.2, stroke_dasharray="1 1"
        )
    return NOTHING


def apex(boxes: Floats) -> Floats:
    """Where the first two objects of an arc look both."""
    ways = np.column_stack([np.cos(boxes[:2, 2]), np.sin(boxes[:2, 2])])
    far = np.linalg.solve(np.column_stack([ways[0], -ways[1]]), boxes[1, :2] - boxes[0, :2])
    found: Floats = boxes[0, :2] + far[0] * ways[0]
    return found


def key(y: float) -> Mark:
    """What the colours mean, and the scale."""
    bar = np.array([[10.0, y], [10.0 + 2 * SCALE, y]])
    swatch = [(42.0, y - 2.2), (49.0, y - 2.2), (49.0, y + 1.8), (42.0, y + 1.8)]
    words = "wish for free floor (clearance); where two overlap, two objects share it"
    return group(
        [
            line(bar, stroke=INK, stroke_width=OUTLINE, fill="none"),
            text("2 m", (10.0 + SCALE, y - 2.5), 2.7),
            shape([swatch], fill=ALLEY),
            text(words, (52.0, y), 2.9, text_anchor="start"),
            shape([arrow_head((178.0, y - 1.4), (0.0, -1.0), 2.6)], fill=FRONT),
            text("front", (182.0, y), 2.9, text_anchor="start"),
        ]
    )


def sheet() -> str:
    """The whole picture as SVG text."""
    cells, width = [], 3 * CELL[0]
    for row, names in enumerate(ROWS):
        x = 0.0
        for name in names:
            wide = CELL[0] * (2 if name == WIDE else 1)
            cells.append(drawn(name, x, row * CELL[1], wide))
            x += wide
    height = len(ROWS) * CELL[1] + 12.0
    paper = tag("rect", width=width, height=height, fill="#ffffff")
    return (
        tag(
            "svg",
            "\n".join([paper, *map(mark_text, [*cells, key(height - 7.0)])]),
            xmlns="http://www.w3.org/2000/svg",
            viewBox=f"0 0 {width:g} {height:g}",
            width=f"{3 * width:g}",
            height=f"{3 * height:g}",
            font_family="Helvetica, Arial, 'DejaVu Sans', sans-serif",
            fill=INK,
        )
        + "\n"
    )


if __name__ == "__main__":
    TARGET.write_text(sheet(), encoding="utf-8")
    print(f"wrote {TARGET}")
