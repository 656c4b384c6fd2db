"""Room names and areas, put where they can be read."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from shapely import Geometry, Point, Polygon, contains_xy, prepare
from shapely.ops import polylabel

from scenewright.building.shafts import is_shaft
from scenewright.core.space import Space
from scenewright.drawing.marks import (
    GREY,
    INK,
    NOTHING,
    Mark,
    MeantMark,
    PaperView,
    group,
    text,
    to_paper,
)
from scenewright.drawing.meanings import TagMeaning
from scenewright.drawing.shafts import printed_name
from scenewright.drawing.wordings import CLOSET, HALO, Label, extent, wordings

CLEAR, ROOMY, GRID = 0.6, 2.5, 48
"""Millimetres that stay free around a label, and that better do; positions tried along either side
of a room."""

COVERING, CROSSING, TIGHT, LEAST = 6.0, 1.6, 0.2, 0.005
"""What it costs to cover a piece or leave the floor, to lie on a rug or in a door's swing (more
than any horizontal wording does), to stand close to all that; and the share from which on it
counts."""


class Floor(NamedTuple):
    """What labels of rooms keep off, in plan metres: ``taken`` by furniture, and
    what only lies there or sweeps over it, ``crossed`` if no other place is left."""

    taken: Geometry
    crossed: Geometry = Polygon()


def labels_mark(
    view: PaperView,
    spaces: Sequence[Space],
    floor: Floor,
    halos: Sequence[str],
    enlarge: float = 1.0,
) -> Mark:
    """Names of all rooms off the ``floor`` that is taken; ``halos[i]`` is the colour around the
    letters of label i, which are ``enlarge`` times as high as usual where there is room. A closet
    or shaft full to the door is left without a name."""
    rows = [(s, halo) for s, halo in zip(spaces, halos, strict=True) if _is_named(s)]
    marks = []
    for space, halo in rows:
        label, at, cost = _find(view, space, floor, enlarge)
        full = cost > COVERING and polygon_of(space).area < CLOSET
        marks.append(NOTHING if full else _label_mark(view, label, at, halo))
    return group(marks, stroke="none", fill=INK)


def _is_named(space: Space) -> bool:
    return bool(printed_name(space)) or not is_shaft(space)


def polygon_of(space: Space) -> Polygon:
    """The space's floor as a polygon."""
    return Polygon(space.outline, space.holes)


class LabelRaster(NamedTuple):
    """Cells of ``cell`` metres from ``corner``; ``inside``, ``taken`` and ``crossed``
    (ny + 1, nx + 1) hold how many cells of the kind lie south-west of each cell corner
    (summed-area tables)."""

    corner: NDArray[np.float64]
    cell: float
    inside: NDArray[np.int64]
    taken: NDArray[np.int64]
    crossed: NDArray[np.int64]


def place(
    view: PaperView, space: Space, taken: Geometry, crossed: Geometry | None = None
) -> tuple[Label, NDArray[np.float64]]:
    """The wording, turn and plan position at which the room's label disturbs least."""
    return _find(view, space, Floor(taken, Polygon() if crossed is None else crossed))[:2]


def _find(
    view: PaperView, space: Space, floor: Floor, enlarge: float = 1.0
) -> tuple[Label, NDArray[np.float64], float]:
    """The best label, its position and what it costs; wordings come cheapest first."""
    room = polygon_of(space)
    raster, at = _raster(room, floor), _candidates(room)
    away = np.hypot(*(at - np.array(_middle(room).coords[0])).T) / np.sqrt(room.area)
    found = None
    for label in wordings(space, room.area, enlarge):
        if found is not None and found[2] <= label.cost:
            break
        cost = label.cost + _costs(view, label, raster, at, away)
        best = int(np.argmin(cost))
        if found is None or cost[best] < found[2]:
            found = label, at[best], float(cost[best])
    assert found is not None
    return found


def _costs(
    view: PaperView,
    label: Label,
    raster: LabelRaster,
    at: NDArray[np.float64],
    away: NDArray[np.float64],
) -> NDArray[np.float64]:
    """At each position: share of the label off the floor, share over things, distance to the
    middle."""
    half = (np.array(extent(label)) + 2 * CLEAR) / view.scale / 2
    whole = np.prod(2 * half / raster.cell)
    low = np.rint((at - half - raster.corner) / raster.cell).astype(int)
    high = np.rint((at + half - raster.corner) / raster.cell).astype(int)
    seen = np.maximum(np.prod(high - low, axis=1), 1)
    off = 1 - _cells(raster.inside, low, high) / seen
    over = _cells(raster.taken, low, high) / whole
    across = _cells(raster.crossed, low, high) / whole
    wide = round(ROOMY / view.scale / raster.cell)
    tight = _cells(raster.taken, low - wide, high + wide) / whole
    tight += 1 - _cells(raster.inside, low - wide, high + wide) / np.prod(high - low + 2 * wide, 1)
    cost: NDArray[np.float64] = 12 * off + 7 * over + across + 0.15 * away + TIGHT * tight
    cost += COVERING * ((over > LEAST) | (off > 0.05)) + CROSSING * (across > LEAST)
    return cost


def _raster(room: Polygon, floor: Floor) -> LabelRaster:
    west, south, east, north = room.bounds
    cell = max(0.02, np.sqrt((east - west) * (north - south)) / 120)
    x, y = np.meshgrid(
        np.arange(west, east, cell) + cell / 2, np.arange(south, north, cell) + cell / 2
    )
    prepare([room, *floor])
    masks = [contains_xy(region, x, y) for region in (room, *floor)]
    sums = (np.pad(mask.cumsum(0).cumsum(1), ((1, 0), (1, 0))) for mask in masks)
    return LabelRaster(np.array([west, south]), cell, *sums)


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


def _candidates(room: Polygon) -> NDArray[np.float64]:
    """A grid of points inside the room, and one that is surely inside."""
    west, south, east, north = room.bounds
    x, y = np.meshgrid(np.linspace(west, east, GRID), np.linspace(south, north, GRID))
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
    return MeantMark(group(marks), _tag(label, centre))


def _tag(label: Label, centre: NDArray[np.float64]) -> TagMeaning:
    """What a label says: its name may take several lines; below it the area, then the size."""
    words = [row for row, _ in label.lines]
    name, rest = " ".join(words[: label.names]), [*words[label.names :], "", ""]
    return TagMeaning(name, rest[0], rest[1], (float(centre[0]), float(centre[1])))
