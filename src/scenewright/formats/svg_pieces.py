"""Furniture in plan: the symbols of the assets, lower things under higher ones."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from scenewright.catalog import Catalog, Kind
from scenewright.formats.svg_marks import (
    FINE,
    GREY,
    INK,
    LINE,
    View,
    group,
    line,
    shape,
    title,
    to_paper,
)  # fmt: skip
from scenewright.formats.svg_shell import CUT_HEIGHT
from scenewright.scene import Piece
from scenewright.space import Points

SEAT_HEIGHT = 0.45
PAPER, RUG = "#ffffff", "#e9e4d9"


def pieces_mark(view: View, pieces: Sequence[Piece], catalog: Catalog) -> str:
    """Every piece by its symbol, drawn from the floor up; what hangs on a wall above the cut is
    dashed, what hangs from the ceiling is left to the ceiling plan."""
    seen = [p for p in pieces if _support(p, catalog.kinds) != "ceiling"]
    ordered = sorted(seen, key=lambda piece: drawing_height(piece, catalog.kinds))
    return group(
        [_piece(view, piece, catalog) for piece in ordered],
        stroke=INK, stroke_linejoin="round", stroke_linecap="round",
    )  # fmt: skip


def drawing_height(piece: Piece, kinds: dict[str, Kind]) -> float:
    """Height that decides what covers what: flat things lowest, chairs by their seat, the rest
    by its top."""
    kind = kinds.get(piece.category, Kind(piece.category))
    if kind.flat:
        return piece.pose.z
    tall = min(piece.size.height, SEAT_HEIGHT) if kind.under else piece.size.height
    return piece.pose.z + tall + (100.0 if hangs(piece) else 0.0)


def _support(piece: Piece, kinds: dict[str, Kind]) -> str:
    return kinds[piece.category].support if piece.category in kinds else "floor"


def hangs(piece: Piece) -> bool:
    """Whether the piece is wholly above the cut (wall cabinets, pictures)."""
    return piece.pose.z >= CUT_HEIGHT


def placed(piece: Piece, points: ArrayLike) -> NDArray[np.float64]:
    """Points of the piece's local frame in the plan (see :mod:`scenewright.scene`)."""
    local = np.asarray(points, dtype=float)
    cos, sin = np.cos(piece.pose.heading), np.sin(piece.pose.heading)
    return local @ np.array([[sin, -cos], [cos, sin]]) + (piece.pose.x, piece.pose.y)


def footprint(piece: Piece) -> NDArray[np.float64]:
    """Corners ``(4, 2)`` of the footprint in the plan."""
    half = np.array(piece.size[:2]) / 2
    return placed(piece, half * [(-1, -1), (1, -1), (1, 1), (-1, 1)])


def _piece(view: View, piece: Piece, catalog: Catalog) -> str:
    drawn = [to_paper(view, placed(piece, points)) for points in symbol(piece, catalog)]
    name = title(_name(piece, catalog))
    if hangs(piece):
        dashed = [line(points, stroke=GREY, stroke_width=FINE, fill="none") for points in drawn[:1]]
        return group([name, *dashed], stroke_dasharray="0.8 0.6")
    kind = catalog.kinds.get(piece.category)
    fill = RUG if kind and kind.flat else PAPER
    pens = [LINE] + [FINE] * (len(drawn) - 1)
    strokes = [_stroke(points, pen, fill) for points, pen in zip(drawn, pens, strict=True)]
    return group([name, *strokes])


def symbol(piece: Piece, catalog: Catalog) -> tuple[Points, ...]:
    """The asset's polylines at the piece's size; a box with its front marked if it has none."""
    asset = catalog.assets.get(piece.asset)
    lines = asset.symbol(piece.size) if asset else ()
    return lines or _box_symbol(piece)


def _box_symbol(piece: Piece) -> tuple[Points, ...]:
    w, d = piece.size.width / 2, piece.size.depth / 2
    box = np.array([(-w, -d), (w, -d), (w, d), (-w, d), (-w, -d)])
    front = np.array([(-w, 0.85 * d), (w, 0.85 * d)])
    return box, front


def _stroke(points: Points, pen: float, fill: str) -> str:
    """Closed lines are filled, so that what is below does not show through."""
    style: dict[str, str | float] = {"stroke_width": pen}
    if len(points) > 2 and np.allclose(points[0], points[-1]):
        return shape([points[:-1]], fill=fill, **style)
    return line(points, fill="none", **style)


def _name(piece: Piece, catalog: Catalog) -> str:
    asset = catalog.assets.get(piece.asset)
    return asset.name if asset else piece.category.replace("_", " ")
