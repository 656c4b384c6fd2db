"""Elevations: the walls that kitchens and shelves stand at, seen from inside the room.

What stands at a wall is drawn by the outlines of the parts of its model, the nearest last; the
wall with its windows and doors behind it, its length and the height of the room beside it.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray

from scenewright.core.catalog import Asset, Catalog, asset_of
from scenewright.core.scene import Piece, Scene, Size
from scenewright.core.space import Opening, Space
from scenewright.drawing.layers import PlanDrawing, PlanLayer
from scenewright.drawing.marks import (
    CUT,
    FINE,
    GREY,
    INK,
    LINE,
    Mark,
    PaperView,
    group,
    line,
    shape,
    text,
    to_paper,
)
from scenewright.drawing.sheet import EDGE, PaperSheet, TitleBlock, drawing_area, sheet_mark

KITCHEN = ("cabinet", "fridge", "hob", "oven", "dishwasher", "sink", "hood", "wall_cabinet")
SHELVES = ("shelf", "bookcase", "showcase", "cupboard", "wardrobe")
"""Parts of the names of kinds that are drawn in elevation."""
LEAST = 2
"""Pieces of a kitchen or shelves at a wall that is drawn."""
DEEP, APART = 0.9, 18.0
"""Metres before a wall in which pieces are drawn; millimetres between elevations."""
MOST_PARTS = 40
SHEET = PaperSheet(420.0, 297.0, 25)


class WallView(NamedTuple):
    """A wall of a room: its name, left end seen from inside, direction to the right, length, the
    room's height, and the pieces and openings at it."""

    name: str
    start: NDArray[np.float64]
    along: NDArray[np.float64]
    length: float
    height: float
    pieces: tuple[Piece, ...]
    openings: tuple[Opening, ...]


def wall_views(scene: Scene) -> list[WallView]:
    """The walls of all rooms at which a kitchen or shelves stand, room by room."""
    found = []
    for space in scene.spaces:
        here = [piece for piece in scene.pieces if piece.space == space.id]
        number = 0
        for start, end in zip(space.outline, np.roll(space.outline, -1, axis=0), strict=True):
            view = _view(space, start, end, here)
            if view is not None:
                number += 1
                found.append(view._replace(name=f"{space.name or space.id} · wall {number}"))
    return found


def _view(
    space: Space, start: NDArray[np.float64], end: NDArray[np.float64], pieces: Sequence[Piece]
) -> WallView | None:
    """The view of one edge of an outline; rooms lie on its left, so it is seen from end to start
    from left to right."""
    way = start - end
    length = float(np.hypot(*way))
    if length < 0.8:
        return None
    along = way / length
    into = np.array([along[1], -along[0]])
    into = into if (np.mean(space.outline, axis=0) - end) @ into > 0 else -into
    near = [piece for piece in pieces if _stands_at(piece, end, along, into, length)]
    if sum(_is_shown(piece.category) for piece in near) < LEAST:
        return None
    here = tuple(
        opening
        for opening in space.openings
        if abs((np.array([opening.x, opening.y]) - end) @ into) < opening.thickness + 0.1
        and 0 < (np.array([opening.x, opening.y]) - end) @ along < length
        and abs(opening.ux * along[0] + opening.uy * along[1]) > 0.99
    )
    return WallView("", end, along, length, space.height, tuple(near), here)


def _is_shown(category: str) -> bool:
    return any(part in category for part in (*KITCHEN, *SHELVES))


def _stands_at(
    piece: Piece,
    start: NDArray[np.float64],
    along: NDArray[np.float64],
    into: NDArray[np.float64],
    length: float,
) -> bool:
    """Whether a piece stands with its back to a wall."""
    place = np.array(piece.pose[:2]) - start
    front = np.array([np.cos(piece.pose.heading), np.sin(piece.pose.heading)])
    near = 0 < place @ into < piece.size.depth / 2 + 0.2
    return bool(near and -0.05 < place @ along < length + 0.05 and front @ into > 0.9)


def elevation_sheets(
    views: Sequence[WallView], catalog: Catalog, name: str, first: int, date: str
) -> list[PlanDrawing]:
    """The elevations in rows on sheets at 1:25, numbered from ``first``."""
    sheets: list[PlanDrawing] = []
    marks: list[Mark] = []
    wide, high = drawing_area(SHEET)
    x, y, row = EDGE + 10.0, EDGE + 8.0, 0.0
    for view in views:
        need = (view.length * 1000 / SHEET.scale, view.height * 1000 / SHEET.scale + 14.0)
        if x + need[0] > EDGE + wide - 5.0:
            x, y, row = EDGE + 10.0, y + row + APART, 0.0
        if y + need[1] > EDGE + high - 5.0 and marks:
            sheets.append(_sheet(marks, name, TitleBlock(str(first + len(sheets)), date)))
            marks, x, y, row = [], EDGE + 10.0, EDGE + 8.0, 0.0
        floor = y + view.height * 1000 / SHEET.scale
        marks.append(_draw(view, catalog, PaperView(1000 / SHEET.scale, x, floor)))
        x, row = x + need[0] + APART, max(row, need[1])
    return (
        [*sheets, _sheet(marks, name, TitleBlock(str(first + len(sheets)), date))]
        if marks
        else sheets
    )


def _sheet(marks: Sequence[Mark], name: str, block: TitleBlock) -> PlanDrawing:
    words = "Elevations of kitchen and shelf walls"
    layers = (
        PlanLayer("Sheet", sheet_mark(SHEET, name, words, block)),
        PlanLayer("Elevations", group(marks)),
    )
    return PlanDrawing(name, SHEET, (), layers)


def _draw(view: WallView, catalog: Catalog, paper: PaperView) -> Mark:
    """The wall, its openings, the pieces at it, its measures and its name."""
    ring = [(0, 0), (view.length, 0), (view.length, view.height), (0, view.height)]
    wall = shape([to_paper(paper, ring)], fill="none", stroke=INK, stroke_width=CUT)
    openings = [_opening(view, opening, paper) for opening in view.openings]
    far = sorted(view.pieces, key=lambda piece: piece.size.depth)
    drawn = [mark for piece in far for mark in _piece(view, piece, catalog, paper)]
    foot = to_paper(paper, [(0, 0), (view.length, 0)])
    ticks = [line([(x, y + 3.0), (x, y + 6.0)]) for x, y in foot]
    chain = group([line(foot + np.array([0.0, 4.5])), *ticks], stroke=GREY, stroke_width=FINE)
    style: dict[str, str | float] = {"fill": GREY, "stroke": "none"}
    x, y = foot.mean(0).tolist()
    words = [
        text(f"{view.length:.2f}", (x, y + 6.6), 1.8, 0.0, **style),
        text(f"{view.name} · height {view.height:.2f}", (x, y + 10.0), 2.3, fill=INK),
    ]
    return group([wall, *openings, *drawn, chain, *words])


def _opening(view: WallView, opening: Opening, paper: PaperView) -> Mark:
    along = float((np.array([opening.x, opening.y]) - view.start) @ view.along)
    a, b = along - opening.width / 2, along + opening.width / 2
    ring = [(a, opening.sill), (b, opening.sill), (b, opening.head), (a, opening.head)]
    return shape([to_paper(paper, ring)], fill="none", stroke=GREY, stroke_width=LINE)


def _piece(view: WallView, piece: Piece, catalog: Catalog, paper: PaperView) -> list[Mark]:
    """The outlines of a piece's parts as seen from before it; its box where there is no model."""
    asset = asset_of(piece, catalog)
    place = float((np.array(piece.pose[:2]) - view.start) @ view.along)
    right = np.array([np.sin(piece.pose.heading), -np.cos(piece.pose.heading)])
    turn = float(np.sign(right @ view.along)) or 1.0
    seen = _silhouettes(asset, piece.size) if asset else ()
    spot = np.array([place, piece.pose.z])
    shapes = [shapely.transform(one, lambda at: at * (turn, 1.0) + spot) for one in seen]
    if not shapes:
        w, (low, high) = piece.size.width / 2, (piece.pose.z, piece.pose.z + piece.size.height)
        shapes = [shapely.box(place - w, low, place + w, high)]
    return [_outline(one, paper) for one in shapes]


@lru_cache(maxsize=1024)
def _silhouettes(asset: Asset, size: Size) -> tuple[shapely.Polygon, ...]:
    """The outlines of the parts of a model as seen from before it, the farthest first."""
    parts = sorted(asset.mesh(size)[:MOST_PARTS], key=lambda part: float(part.vertices[:, 1].max()))
    flat = (part.vertices[:, [0, 2]][part.faces] for part in parts)
    return tuple(one for triangles in flat for one in _silhouette(triangles))


def _silhouette(triangles: NDArray[np.float64]) -> list[shapely.Polygon]:
    """The outline of triangles ``(n, 3, 2)``."""
    rings = shapely.polygons(triangles)
    rings = rings[shapely.area(rings) > 1e-7]
    if not len(rings):
        return []
    whole = shapely.simplify(shapely.union_all(rings, grid_size=1e-4), 0.002)
    return [p for p in shapely.get_parts(whole) if isinstance(p, shapely.Polygon)]


def _outline(polygon: shapely.Polygon, paper: PaperView) -> Mark:
    rings = [
        to_paper(paper, np.asarray(ring.coords)[:-1])
        for ring in (polygon.exterior, *polygon.interiors)
    ]
    return shape(rings, fill="#ffffff", fill_rule="evenodd", stroke=INK, stroke_width=FINE)
