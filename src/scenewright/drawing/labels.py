"""Room names and areas, put where they can be read."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Geometry, Point, Polygon, contains_xy, prepare
from shapely.ops import polylabel

from scenewright.core.space import Space
from scenewright.drawing.marks import (
    GREY,
    INK,
    Mark,
    PaperView,
    clean,
    group,
    text,
    text_width,
    to_paper,
)

NAME, AREA, SIZE = 2.5, 2.0, 1.6
"""Text heights in millimetres: room name, its area, its inner dimensions."""

HALO, CLEAR, BOLD = 0.9, 0.8, 1.12
COVERING, LEAST = 3.0, 0.005
"""What it costs to cover anything, more than the smallest label does, from so small a share on."""


class Label(NamedTuple):
    """Lines of text with their heights, the first ``names`` of them bold; the turn in degrees and
    how much we mind using it."""

    lines: tuple[tuple[str, float], ...]
    names: int
    turn: float
    cost: float


def labels_mark(
    view: PaperView, spaces: Sequence[Space], busy: Sequence[Geometry], halos: Sequence[str]
) -> Mark:
    """Names of all rooms; ``busy[i]`` is what label i should not cover, in plan metres, and
    ``halos[i]`` the colour around its letters."""
    rows = zip(spaces, busy, halos, strict=True)
    marks = [_label_mark(view, *place(view, space, taken), halo) for space, taken, halo in rows]
    return group(marks, stroke="none", fill=INK)


def polygon_of(space: Space) -> Polygon:
    """The space's floor as a polygon."""
    return Polygon(space.outline, space.holes)


def area_words(square_metres: float) -> str:
    """An area as printed.

    >>> area_words(12.345)
    '12.3 m²'
    """
    return f"{square_metres:.1f} m²"


class LabelRaster(NamedTuple):
    """Cells of ``cell`` metres from ``corner``; ``floor`` and ``busy`` (ny + 1, nx + 1) hold how
    many cells of the kind lie south-west of each cell corner (summed-area tables)."""

    corner: NDArray[np.float64]
    cell: float
    floor: NDArray[np.int64]
    busy: NDArray[np.int64]


def place(view: PaperView, space: Space, busy: Geometry) -> tuple[Label, NDArray[np.float64]]:
    """The wording, turn and plan position at which the room's label disturbs least."""
    room = polygon_of(space)
    raster, at = _raster(room, busy), _candidates(room)
    away = np.hypot(*(at - np.array(_middle(room).coords[0])).T) / np.sqrt(room.area)
    tried = [
        (*_best_position(view, label, raster, at, away), label)
        for label in wordings(space, room.area)
    ]
    _, best, label = min(tried, key=lambda found: found[0])
    return label, at[best]


def wordings(space: Space, square_metres: float) -> list[Label]:
    """Ever shorter and smaller labels, upright and turned, with what each costs."""
    name, floor = clean(space.name or space.id, 32), area_words(square_metres)
    size = inner_dimensions(space)
    split = _halves(name)
    options = (
        ((name,), (floor, size), 1.0, 0.0),
        ((name,), (floor,), 1.0, 0.15),
        (split, (floor,), 1.0, 0.2),
        ((name,), (floor,), 0.72, 0.45),
        (split, (floor,), 0.72, 0.5),
        ((name,), (), 0.72, 0.7),
        ((name,), (), 0.6, 0.9),
    )
    turns = ((0.0, 0.0), (90.0, 0.3))
    return [
        Label(_lines(names, rest, scale), len(names), turn, cost + more)
        for names, rest, scale, cost in options
        for turn, more in turns
    ]


def _lines(
    names: tuple[str, ...], rest: tuple[str, ...], scale: float
) -> tuple[tuple[str, float], ...]:
    bold = [(words, scale * NAME) for words in names]
    plain = zip(rest, (scale * AREA, scale * SIZE), strict=False)
    return (*bold, *((words, size) for words, size in plain if words))


def _halves(name: str) -> tuple[str, ...]:
    """The name in two lines, parted at the space nearest its middle, if it has one."""
    gaps = [i for i, letter in enumerate(name) if letter == " "]
    if not gaps:
        return (name,)
    cut = min(gaps, key=lambda i: abs(2 * i - len(name)))
    return name[:cut], name[cut + 1 :]


def inner_dimensions(space: Space) -> str:
    """Clear width and depth of a room that is (nearly) a rectangle square to the plan, or nothing.

    >>> square = Space("a", "A", (), "g", np.array([[0, 0], [3, 0], [3, 4], [0, 4.0]]))
    >>> inner_dimensions(square)
    '3.00 × 4.00'
    """
    room = polygon_of(space)
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
    width = max(widths) + 2 * HALO
    height = sum(1.35 * size for _, size in label.lines) + HALO
    return (height, width) if label.turn else (width, height)


def _best_position(
    view: PaperView,
    label: Label,
    raster: LabelRaster,
    at: NDArray[np.float64],
    away: NDArray[np.float64],
) -> tuple[float, int]:
    """Least of: share of the label off the floor, share over things, distance to the middle."""
    half = (np.array(extent(label)) + 2 * CLEAR) / view.scale / 2
    whole = np.prod(2 * half / raster.cell)
    low = np.rint((at - half - raster.corner) / raster.cell).astype(int)
    high = np.rint((at + half - raster.corner) / raster.cell).astype(int)
    off = 1 - np.minimum(_cells(raster.floor, low, high) / whole, 1)
    over = _cells(raster.busy, low, high) / whole
    cost = 12 * off + 7 * over + 0.15 * away + label.cost
    cost += COVERING * (over > LEAST)
    best = int(np.argmin(cost))
    return float(cost[best]), best


def _raster(room: Polygon, busy: Geometry) -> LabelRaster:
    west, south, east, north = room.bounds
    cell = max(0.04, np.sqrt((east - west) * (north - south)) / 120)
    x, y = np.meshgrid(
        np.arange(west, east, cell) + cell / 2, np.arange(south, north, cell) + cell / 2
    )
    prepare([room, busy])
    masks = [contains_xy(region, x, y) for region in (room, busy)]
    floor, taken = (np.pad(mask.cumsum(0).cumsum(1), ((1, 0), (1, 0))) for mask in masks)
    return LabelRaster(np.array([west, south]), cell, floor, taken)


def _cells(
    sums: NDArray[np.int64], low: NDArray[np.int64], high: NDArray[np.int64]
) -> NDArray[np.int64]:
    """Marked cells in boxes of cell indices ``(k, 2)``, x first; outside the raster is none."""
    most = np.array(sums.shape[::-1]) - 1
    (x0, y0), (x1, y1) = np.clip(low, 0, most).T, np.clip(high, 0, most).T
    found: NDArray[np.int64] = sums[y1, x1] - sums[y0, x1] - sums[y1, x0] + sums[y0, x0]
    return found


def _middle(room: Polygon) -> Point:
    """The centroid of a compact room, else the point farthest from its walls."""
    compact = room.area > 0.9 * room.convex_hull.area
    return room.centroid if compact else polylabel(room, 0.05)


def _candidates(room: Polygon, count: int = 24) -> NDArray[np.float64]:
    """A grid of points inside the room, and one that is surely inside."""
    west, south, east, north = room.bounds
    x, y = np.meshgrid(np.linspace(west, east, count), np.linspace(south, north, count))
    grid = np.column_stack([x.ravel(), y.ravel()])
    inside = grid[contains_xy(room, grid)]
    return np.vstack([np.array(room.representative_point().coords), inside])


def _label_mark(view: PaperView, label: Label, at: NDArray[np.float64], colour: str) -> Mark:
    """The lines, each over its own halo, stacked around the position."""
    centre = to_paper(view, at)
    heights = np.array([1.35 * size for _, size in label.lines])
    offsets = np.cumsum(heights) - heights / 2 - heights.sum() / 2
    angle = np.radians(label.turn)
    down = np.array([np.sin(angle), np.cos(angle)])
    marks = []
    for row, ((words, size), offset) in enumerate(zip(label.lines, offsets, strict=True)):
        style: dict[str, str | float] = {"fill": INK if row <= label.names else GREY}
        style["font_weight"] = "bold" if row < label.names else "normal"
        halo: dict[str, str | float] = {
            "stroke": colour,
            "stroke_width": HALO,
            "stroke_linejoin": "round",
        }
        where = centre + offset * down
        marks.append(text(words, where, size, label.turn, **(style | halo)))
        marks.append(text(words, where, size, label.turn, **style))
    return group(marks)
