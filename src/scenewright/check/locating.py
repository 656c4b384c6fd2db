"""Where findings lie: polygons and points in the plan, worked out of what they name."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
import shapely

from scenewright.core.piece_outlines import outline_of
from scenewright.core.report import Finding, Place, Ring
from scenewright.core.scene import Piece
from scenewright.core.space import Space

DIGITS = 3
"""Decimals of a metre."""
Shapes = list[shapely.Geometry]


class Ground(NamedTuple):
    """What findings may name, by id: pieces, spaces, and the middles of openings."""

    pieces: Mapping[str, Piece]
    spaces: Mapping[str, Space]
    openings: Mapping[str, Place]


def locate_findings(
    findings: Sequence[Finding], pieces: Sequence[Piece], spaces: Sequence[Space]
) -> tuple[Finding, ...]:
    """Findings with ``polygons`` (m) of what is at fault: of two pieces where they overlap, of one
    that sticks out what does, else all of it; and ``points`` to look at: the middle of that, and of
    the openings named. A finding that names neither lies in the middle of its space."""
    if not findings:
        return ()
    ground = Ground(
        {piece.id: piece for piece in pieces},
        {space.id: space for space in spaces},
        {one.id: (float(one.x), float(one.y)) for space in spaces for one in space.openings},
    )
    return tuple(_locate(found, ground) for found in findings)


def _locate(found: Finding, ground: Ground) -> Finding:
    names = (found.piece, *found.other.split(","))
    own = [_outline(ground.pieces[name]) for name in names if name in ground.pieces]
    space = ground.spaces.get(found.space)
    shapes = [one for one in own if one is not None]
    at_fault = PARTS.get(found.kind, _whole)(shapes, space) or shapes
    rings = [ring for shape in at_fault for ring in _rings(shape)]
    points = [ground.openings[name] for name in names if name in ground.openings]
    points += [_middle(shapely.Polygon(ring)) for ring in rings]
    if not points and space is not None:
        points = [_middle(shapely.Polygon(space.outline, [*space.holes]))]
    return replace(found, polygons=tuple(rings), points=tuple(points))


def _outline(piece: Piece) -> shapely.Geometry | None:
    numbers = (*piece.pose, *piece.size, *(x for point in piece.footprint or () for x in point))
    if not np.isfinite(numbers).all():
        return None
    with np.errstate(over="ignore", invalid="ignore"):
        corners = outline_of(piece)
    if not np.isfinite(corners).all() or len(corners) < 3:
        return None
    shape = shapely.Polygon(corners)
    return shape if shape.is_valid and shape.area > 0 else None


def _whole(shapes: Shapes, _space: Space | None) -> Shapes:
    return shapes


def _overlap(shapes: Shapes, _space: Space | None) -> Shapes:
    return [shapely.intersection(*shapes)] if len(shapes) == 2 else shapes


def _outside(shapes: Shapes, space: Space | None) -> Shapes:
    if space is None or len(shapes) != 1:
        return shapes
    return [shapely.difference(shapes[0], shapely.Polygon(space.outline, [*space.holes]))]


PARTS: Mapping[str, Callable[[Shapes, Space | None], Shapes]] = {
    "collision": _overlap,
    "mesh_overlap": _overlap,
    "out_of_bounds": _outside,
}
"""Which part of what a finding names is at fault; all of it for other kinds."""


def _rings(shape: shapely.Geometry) -> list[Ring]:
    """The outer rings of all parts with an area, without the point that closes them."""
    parts = [part for part in shapely.get_parts(shape).tolist() if part.area > 0]
    return [tuple(_place(at) for at in part.exterior.coords[:-1]) for part in parts]


def _middle(shape: shapely.Geometry) -> Place:
    return _place(shape.representative_point().coords[0])


def _place(at: Sequence[float]) -> Place:
    return round(float(at[0]), DIGITS), round(float(at[1]), DIGITS)
