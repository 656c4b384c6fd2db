"""Tests of buildings on open ground that do not depend on what they stand for."""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
import shapely

from scenewright.check.bodies import TOLERANCE, Shape, Shapes
from scenewright.check.shared_ground import intersect_footprints
from scenewright.core.piece_outlines import outline_of
from scenewright.core.report import Finding
from scenewright.core.scene import Piece

LARGEST = 1e5
"""Metres beyond which a pose or size is none."""
ALIKE = 0.02
"""The share by which the ground a building covers may differ from that of its kind."""
LEVEL = 0.02
"""Metres a building may stand off the ground."""


def split_sound(
    pieces: Sequence[Piece], known: Collection[str], what: str
) -> tuple[list[Finding], list[Piece]]:
    """A finding for each piece that cannot be judged, and the buildings that can.

    A piece is sound if its pose and size are metres and its space is ``known``; ``what`` says in
    words what a space is.
    """
    findings, sound = [], []
    for piece in pieces:
        fault = _find_fault(piece, known, what)
        if fault:
            text = f"{piece.id or 'a piece'} {fault}"
            findings.append(
                Finding("malformed", "", piece.space, piece.id, "", text, given=piece.fixed)
            )
        elif piece.category == "building":
            sound.append(piece)
    return findings, sound


def _find_fault(piece: Piece, known: Collection[str], what: str) -> str:
    values = np.array([*piece.pose, *piece.size], float)
    if not np.isfinite(values).all() or np.abs(values).max() > LARGEST:
        return "has a pose or size that is not a number of metres"
    if (values[4:] <= 0).any():
        return f"has no size: {values[4]:g} x {values[5]:g} x {values[6]:g} m"
    return "" if piece.space in known else f"stands in {piece.space!r}, which is not {what}"


def find_collisions(pieces: Sequence[Piece], shapes: Shapes) -> list[Finding]:
    """Pairs that share more than a wall: an area more than 1 cm thick. ``shapes`` (n,) are the
    footprints of ``pieces``."""
    found: list[Finding] = []
    for a, b in _find_pairs(shapes):
        depth, area = measure_shared(intersect_footprints(shapes[a], shapes[b]))
        one, other = pieces[a], pieces[b]
        if depth > TOLERANCE:
            text = f"{one.id} and {other.id} overlap by {depth:.2f} m ({area:.2f} m²)"
            given = one.fixed and other.fixed
            found.append(state_fault("collision", one, text, depth, area, other.id, given))
    return found


def _find_pairs(shapes: Shapes) -> list[tuple[int, int]]:
    if len(shapes) < 2:
        return []
    i, j = shapely.STRtree(shapes).query(shapes, predicate="intersects")
    return sorted((int(a), int(b)) for a, b in zip(i, j, strict=True) if a < b)


def measure_shared(shared: Shape) -> tuple[float, float]:
    """The short side of the least rectangle about a shape, in metres, and the area of the shape;
    a side of 0 where it is nowhere 1 cm thick, as two walls along a corner.

    >>> measure_shared(shapely.box(0, 0, 3, 0.5))
    (0.5, 1.5)
    >>> measure_shared(shapely.box(0, 0, 3, 3) - shapely.box(0.005, 0.005, 4, 4))[0]
    0.0
    """
    area = float(shared.area)
    if area <= TOLERANCE**2 or shared.buffer(-TOLERANCE / 2, join_style="mitre").is_empty:
        return 0.0, area
    frame = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shared))
    return float(np.hypot(*np.diff(frame[:3], axis=0).T).min()), area


def is_like(piece: Piece, area: float, height: float, within: float = ALIKE) -> bool:
    """Whether a building covers an ``area`` in square metres, ``within`` a share, and is as high as
    ``height`` in metres; what is malformed is not judged here."""
    if _find_fault(piece, (piece.space,), ""):
        return True
    covered = float(shapely.Polygon(outline_of(piece)).area)
    return abs(covered - area) <= within * area and abs(piece.size.height - height) <= TOLERANCE


def find_off_ground(piece: Piece) -> list[Finding]:
    """A finding for a building that floats above its ground or is sunk into it."""
    if abs(piece.pose.z) <= LEVEL:
        return []
    kind = "floating" if piece.pose.z > 0 else "sunk"
    text = f"{piece.id} stands {piece.pose.z:+.2f} m off the ground"
    return [state_fault(kind, piece, text, abs(piece.pose.z))]


def state_fault(
    kind: str,
    piece: Piece,
    text: str,
    amount: float = 0.0,
    area: float = 0.0,
    other: str = "",
    given: bool | None = None,
) -> Finding:
    """A finding about a building: metres and square metres to 0.1 mm; it counts as ``given`` if
    the building is fixed, unless stated."""
    fixed = bool(piece.fixed if given is None else given)
    figures = (round(amount, 4), round(area, 4))
    return Finding(kind, "", piece.space, piece.id, other, text, *figures, fixed)
