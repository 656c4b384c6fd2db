"""How the name of a room can be worded on a plan: in lines, with its area, smaller, turned."""

from __future__ import annotations

from itertools import combinations, pairwise
from typing import NamedTuple

from shapely import Polygon

from scenewright.core.space import Space
from scenewright.drawing.marks import clean, text_width
from scenewright.drawing.shafts import printed_name

NAME, AREA, SIZE = 2.5, 2.0, 1.6
"""Text heights in millimetres: room name, its area, its inner dimensions."""

READABLE = 1.5
"""Millimetres: the least height of a text that can be read in print."""

HALO, BOLD = 0.9, 1.2
"""Millimetres around the letters; how much wider bold letters are."""

SCALES = ((1.0, 0.0), (0.8, 0.25), (READABLE / NAME, 0.5))
"""How large the words are, and what we mind; a small room starts with the second."""

USUAL = 0.06
"""Cost of usual letters where larger ones are wanted."""

CLOSET, LONGEST, MOST_LINES = 1.5, 60, 4
"""Square metres up to which a room is named in small type; letters and lines of a name."""

TURNED, BROKEN, SHORT_COST = 1.0, 0.1, 0.55
"""Costs of a turned label, of each further line of a name, and of a short form."""

SHORT = {"bathroom": "bath", "storage": "ST", "toilet": "WC", "washroom": "wash"}
"""Usual short forms of rooms that are named by what they are for; capital where the name is."""


class Label(NamedTuple):
    """Lines of text with their heights, the first ``names`` of them bold; the turn in degrees and
    how much we mind using it."""

    lines: tuple[tuple[str, float], ...]
    names: int
    turn: float
    cost: float


def wordings(space: Space, square_metres: float, enlarge: float = 1.0) -> list[Label]:
    """The labels of a room, the ones we like best first: the name in ever more lines, with ever
    less below it, smaller, and all of that turned. The first are ``enlarge`` times as large.

    A name is turned only where no horizontal one that tells the area finds room.
    """
    name = clean(printed_name(space), LONGEST)
    names = [(lines, BROKEN * (len(lines) - 1)) for lines in broken(name)]
    if name.lower() in SHORT:
        short = SHORT[name.lower()]
        names.append(((short if name.islower() else short[:1].upper() + short[1:],), SHORT_COST))
    small = square_metres < CLOSET
    scales = [(scale, cost + USUAL * (enlarge > 1.0)) for scale, cost in SCALES]
    scales = [(enlarge, 0.0), *scales] if enlarge > 1.0 else scales
    found = [
        Label(_lines(lines, rest, scale), len(lines), turn, sum(costs))
        for scale, size_cost in scales[small:]
        for lines, name_cost in names
        for rest, rest_cost in _rests(space, square_metres, scale, bool(name))
        for turn, turn_cost in ((0.0, 0.0), (90.0, TURNED))
        for costs in [(size_cost, name_cost, rest_cost, turn_cost)]
    ]
    return sorted(found, key=lambda label: label.cost)


def _rests(
    space: Space, square_metres: float, scale: float, named: bool
) -> list[tuple[tuple[str, ...], float]]:
    """Lines below a name: area and inner dimensions, the area, nothing."""
    area, size = area_words(square_metres), inner_dimensions(space)
    rests: list[tuple[tuple[str, ...], float]] = [((area,), 0.12), ((), 0.45)]
    return ([((area, size), 0.0)] if size and scale >= 1.0 else []) + rests[: 1 + named]


def broken(name: str) -> list[tuple[str, ...]]:
    """The name in one line, in two and so on, each time as even as can be; what joins two words
    ends a line.

    >>> broken("bedroom + kitchen + hall")[1:]
    [('bedroom +', 'kitchen + hall'), ('bedroom +', 'kitchen +', 'hall')]
    """
    words: list[str] = []
    for word in name.split():
        if words and word in ("+", "&", "/", "-"):
            words[-1] += f" {word}"
        else:
            words.append(word)
    most = min(len(words), MOST_LINES)
    return [_evenly(words, count) for count in range(1, most + 1)] if words else [()]


def _evenly(words: list[str], count: int) -> tuple[str, ...]:
    ways = [
        tuple(" ".join(words[a:b]) for a, b in pairwise((0, *cuts, len(words))))
        for cuts in combinations(range(1, len(words)), count - 1)
    ]
    return min(ways, key=lambda lines: max(map(len, lines)))


def _lines(
    names: tuple[str, ...], rest: tuple[str, ...], scale: float
) -> tuple[tuple[str, float], ...]:
    bold = [(words, scale * NAME) for words in names]
    plain = zip(rest, (AREA, SIZE), strict=False)
    return (*bold, *((words, max(scale * size, READABLE)) for words, size in plain))


def area_words(square_metres: float) -> str:
    """An area as printed.

    >>> area_words(12.345)
    '12.3 m²'
    """
    return f"{square_metres:.1f} m²"


def inner_dimensions(space: Space) -> str:
    """Clear width and depth of a room that is (nearly) a rectangle square to the plan, or nothing.

    >>> import numpy as np
    >>> square = Space("a", "A", (), "g", np.array([[0, 0], [3, 0], [3, 4], [0, 4.0]]))
    >>> inner_dimensions(square)
    '3.00 × 4.00'
    """
    room = Polygon(space.outline, space.holes)
    west, south, east, north = room.bounds
    width, depth = east - west, north - south
    return f"{width:.2f} × {depth:.2f}" if room.area > 0.985 * width * depth else ""


def extent(label: Label) -> tuple[float, float]:
    """Width and height of the label on paper, in millimetres."""
    bold = [BOLD] * label.names + [1.0] * len(label.lines)
    widths = [
        text_width(words, size) * wide
        for (words, size), wide in zip(label.lines, bold, strict=False)
    ]
    width = max(widths, default=0.0) + HALO
    height = sum(1.35 * size for _, size in label.lines)
    return (height, width) if label.turn else (width, height)
