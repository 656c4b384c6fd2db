"""Furniture in plan: the symbols of the assets, lower things under higher ones."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import ArrayLike, NDArray

from scenewright.catalog.kinds import name_of
from scenewright.core.catalog import Catalog, footprint_of
from scenewright.core.footprint import Footprint
from scenewright.core.kind import Kind
from scenewright.core.scene import STAIRS, Piece, Pose
from scenewright.core.space import Points
from scenewright.drawing.marks import (
    FINE,
    GREY,
    INK,
    LINE,
    CopyMark,
    Mark,
    MeantMark,
    NoteMark,
    PaperView,
    Stencil,
    clean,
    group,
    line,
    shape,
    to_paper,
)
from scenewright.drawing.meanings import PieceMeaning
from scenewright.drawing.shell import CUT_HEIGHT

SEAT_HEIGHT = 0.45
PAPER, RUG = "#ffffff", "#e9e4d9"
COARSE, SMALL = 7.5, 2.0
"""Millimetres a metre below which symbols are simplified; size in millimetres below which things
are drawn with the thin pen."""

Key = tuple[str, str, tuple[float, ...], bool, Footprint]
"""The key that two pieces share if they are drawn alike."""


class Symbols(NamedTuple):
    """Symbols drawn more than once: the id of each, and their definitions."""

    ids: dict[Key, str]
    definitions: tuple[Stencil, ...]


NONE = Symbols({}, ())


def define_repeated_symbols(scale: float, pieces: Sequence[Piece], catalog: Catalog) -> Symbols:
    """What is drawn more than once at ``scale`` millimetres a metre, to be defined once.

    Definitions look to the top of the paper, their middle in the origin.
    """
    seen = [piece for piece in pieces if is_drawn(piece, catalog.kinds)]
    counts = Counter(_key(piece) for piece in seen)
    firsts = {_key(piece): piece for piece in reversed(seen)}
    keys = [key for key, count in counts.items() if count > 1]
    ids = {key: f"s{number}" for number, key in enumerate(keys)}
    upright = Pose(0.0, 0.0, 0.0, np.pi / 2)
    found = []
    for key, name in ids.items():
        high = firsts[key].pose.z
        model = replace(firsts[key], pose=upright._replace(z=high))
        found.append(Stencil(name, tuple(_strokes(PaperView(scale, 0.0, 0.0), model, catalog))))
    return Symbols(ids, tuple(found))


def is_drawn(piece: Piece, kinds: dict[str, Kind]) -> bool:
    """Whether the plan shows a piece by a symbol: what hangs from the ceiling is left to the
    ceiling plan, partitions and stairs are drawn with the walls."""
    drawn_with_walls = piece.category == "partition" or piece.function == STAIRS
    return _support(piece, kinds) != "ceiling" and not drawn_with_walls


def pieces_mark(
    view: PaperView, pieces: Sequence[Piece], catalog: Catalog, symbols: Symbols = NONE
) -> Mark:
    """Every piece by its symbol, drawn from the floor up; what hangs on a wall above the cut is
    dashed."""
    seen = [piece for piece in pieces if is_drawn(piece, catalog.kinds)]
    ordered = sorted(seen, key=lambda piece: drawing_height(piece, catalog.kinds))
    return group(
        [_piece(view, piece, catalog, symbols) for piece in ordered],
        stroke=INK,
        stroke_linejoin="round",
        stroke_linecap="round",
    )


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


def to_plan_coordinates(piece: Piece, points: ArrayLike) -> NDArray[np.float64]:
    """Points of the piece's local frame in the plan (see :mod:`scenewright.core.scene`)."""
    local = np.asarray(points, dtype=float)
    cos, sin = np.cos(piece.pose.heading), np.sin(piece.pose.heading)
    return local @ np.array([[sin, -cos], [cos, sin]]) + (piece.pose.x, piece.pose.y)


def footprint(piece: Piece) -> NDArray[np.float64]:
    """Corners ``(n, 2)`` of the footprint in the plan."""
    if piece.footprint:
        return to_plan_coordinates(piece, piece.footprint)
    half = np.array(piece.size[:2]) / 2
    return to_plan_coordinates(piece, half * [(-1, -1), (1, -1), (1, 1), (-1, 1)])


def _key(piece: Piece) -> Key:
    return (
        piece.asset,
        piece.category,
        tuple(np.round(piece.size, 4).tolist()),
        hangs(piece),
        piece.footprint,
    )


def _piece(view: PaperView, piece: Piece, catalog: Catalog, symbols: Symbols) -> Mark:
    name = NoteMark(clean(_name(piece, catalog)))
    known = symbols.ids.get(_key(piece))
    meaning = mean_piece(view, piece, name.words, _key(piece))
    if known is None:
        return MeantMark(group([name, *_strokes(view, piece, catalog)]), meaning)
    turned = meaning.turn if abs(np.remainder(meaning.turn + 1e-6, 360.0)) > 1e-5 else 0.0
    return MeantMark(CopyMark(known, *meaning.at, turned, name), meaning)


def mean_piece(view: PaperView, piece: Piece, name: str, symbol: Hashable) -> PieceMeaning:
    """What a piece is on paper; ``symbol`` is what pieces that are drawn alike share."""
    x, y = to_paper(view, piece.pose[:2]).tolist()
    turn = float(90.0 - np.degrees(piece.pose.heading))
    size = piece.size.width, piece.size.depth, piece.size.height
    return PieceMeaning(piece.id, piece.category, name, piece.asset, size, (x, y), turn, symbol)


def _strokes(view: PaperView, piece: Piece, catalog: Catalog) -> list[Mark]:
    lines = symbol(piece, catalog)
    if view.scale < COARSE:
        lines = plain(piece, lines, view.scale)
    points = [to_paper(view, to_plan_coordinates(piece, row)) for row in lines]
    if hangs(piece):
        dashed = {"stroke_dasharray": "0.8 0.6", "stroke": GREY, "fill": "none"}
        return [line(row, stroke_width=FINE, **dashed) for row in points[:1]]
    kind = catalog.kinds.get(piece.category)
    fill = RUG if kind and kind.flat else PAPER
    edge = LINE if min(piece.size[:2]) * view.scale > SMALL else FINE
    pens = [edge] + [FINE] * (len(points) - 1)
    return [_stroke(row, pen, fill) for row, pen in zip(points, pens, strict=True)]


def plain(piece: Piece, lines: tuple[Points, ...], scale: float) -> tuple[Points, ...]:
    """The symbol for small scales: its outline, and where there is room a line at its front."""
    sizes = [np.ptp(row, axis=0) if len(row) > 3 else np.zeros(2) for row in lines]
    whole = max(range(len(lines)), key=lambda k: float(sizes[k].min()))
    w, d = piece.size.width / 2, piece.size.depth / 2
    covers = bool((sizes[whole] > 0.9 * np.array([2 * w, 2 * d])).all())
    edge = lines[whole] if covers else _box_symbol(piece)[0]
    if min(2 * w, 2 * d) * scale < SMALL or len(edge) > 9 or piece.footprint:
        return (edge,)
    front = d - min(0.7 / scale, 0.4 * d)
    return edge, np.array([(-w, front), (w, front)])


def symbol(piece: Piece, catalog: Catalog) -> tuple[Points, ...]:
    """The asset's polylines at the piece's size; if it has none or covers another polygon, the
    outline with its front marked."""
    asset = catalog.assets.get(piece.asset)
    if piece.footprint != footprint_of(asset, piece.size):
        return _outline_symbol(piece)
    lines = asset.symbol(piece.size) if asset else ()
    return lines or _box_symbol(piece)


def _box_symbol(piece: Piece) -> tuple[Points, ...]:
    w, d = piece.size.width / 2, piece.size.depth / 2
    box = np.array([(-w, -d), (w, -d), (w, d), (-w, d), (-w, -d)])
    front = np.array([(-w, 0.85 * d), (w, 0.85 * d)])
    return box, front


def _outline_symbol(piece: Piece) -> tuple[Points, ...]:
    """The polygon or box a piece covers, and a line along its front inside it."""
    if not piece.footprint:
        return _box_symbol(piece)
    ring = np.array([*piece.footprint, piece.footprint[0]])
    level = 0.85 * piece.size.depth / 2
    reach = piece.size.width / 2
    front = shapely.LineString([(-reach, level), (reach, level)])
    parts = shapely.get_parts(shapely.intersection(shapely.Polygon(ring), front))
    lines = [shapely.get_coordinates(part) for part in parts if part.length > 0]
    return (ring, *lines)


def _stroke(points: Points, pen: float, fill: str) -> Mark:
    """Closed lines are filled, so that what is below does not show through."""
    style: dict[str, str | float] = {"stroke_width": pen}
    if len(points) > 2 and np.allclose(points[0], points[-1]):
        return shape([points[:-1]], fill=fill, **style)
    return line(points, fill="none", **style)


def _name(piece: Piece, catalog: Catalog) -> str:
    asset = catalog.assets.get(piece.asset)
    return asset.name if asset else name_of(piece.category)
