"""How pieces of a room lie to each other: in front of, on, above, into."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import cos, sin

import shapely

from scenewright.core.catalog import Catalog
from scenewright.core.scene import Piece

TOP = 0.15  # a thing this near to a piece's top stands on it, metres
BACK_AT_WALL = 0.25  # a back nearer to a wall than this belongs to it, metres
BACKREST = 0.06  # of a seat this much stays out of the table it is pushed under, metres
LAP = 0.3  # between a sofa and a table moved out of its corner, metres
STEP, STEPS = 0.02, 30  # how a seat is drawn out, metres
OVERLAP = 0.004  # floor two pieces may share, square metres


def on(piece: Piece, below: Piece) -> bool:
    """Whether a piece stands on another."""
    top = below.pose.z + below.size.height
    return piece.pose.z > TOP and abs(piece.pose.z - top) < TOP and inside(piece, below)


def inside(piece: Piece, below: Piece) -> bool:
    """Whether a piece's middle is over another."""
    x, y = local(piece, below)
    return abs(x) < below.size.width / 2 and abs(y) < below.size.depth / 2


def above(piece: Piece, standing: Sequence[Piece]) -> bool:
    """Whether a thing on the wall hangs behind one of the pieces, above it."""
    for below in standing:
        x, y = local(piece, below)
        behind = -below.size.depth / 2 - BACK_AT_WALL < y < below.size.depth / 2
        if (
            abs(x) < below.size.width / 2 + TOP
            and behind
            and piece.pose.z > below.size.height - TOP
        ):
            return True
    return False


def local(piece: Piece, frame: Piece) -> tuple[float, float]:
    """A piece's middle in another's frame."""
    return rotate_to_frame(
        piece.pose.x - frame.pose.x, piece.pose.y - frame.pose.y, frame.pose.heading
    )


def rotate_to_frame(dx: float, dy: float, heading: float) -> tuple[float, float]:
    """A vector in the frame of a heading: across it to the right, and along it."""
    return dx * sin(heading) - dy * cos(heading), dx * cos(heading) + dy * sin(heading)


def gap(a: Piece, b: Piece) -> float:
    """Floor between two pieces, metres."""
    return float(shapely.distance(footprint(a), footprint(b)))


def drawn_out(seat: Piece, table: Piece) -> Piece:
    """A seat drawn out backwards until its backrest is clear of the table; designers push chairs
    into round and oval tables further than the box round these allows."""
    if seat.size.height < table.size.height:
        return seat
    box, c, s = footprint(table), cos(seat.pose.heading), sin(seat.pose.heading)
    rear = BACKREST - seat.size.depth / 2
    for step in range(STEPS):
        moved = seat.pose._replace(x=seat.pose.x - step * STEP * c, y=seat.pose.y - step * STEP * s)
        tried = replace(seat, pose=moved)
        w = seat.size.width  # wider than the seat, so that no slivers are left beside it
        ends = [(moved.x + c * rear + k * s * w, moved.y + s * rear - k * c * w) for k in (-1, 1)]
        rest = footprint(tried).difference(_ahead(ends, c, s))
        if not rest.intersects(box):
            return tried
    return seat


def pushed_out(piece: Piece, sofa: Piece) -> Piece:
    """A piece moved ahead of a sofa until it is clear of the box round it, as far as a lap."""
    box, c, s = footprint(sofa), cos(sofa.pose.heading), sin(sofa.pose.heading)
    for step in range(3 * STEPS):
        moved = piece.pose._replace(
            x=piece.pose.x + step * STEP * c, y=piece.pose.y + step * STEP * s
        )
        tried = replace(piece, pose=moved)
        if not footprint(tried).intersects(box) and gap(tried, sofa) >= (LAP if step else 0.0):
            return tried
    return piece


def _ahead(ends: list[tuple[float, float]], c: float, s: float) -> shapely.Polygon:
    """What is before a line, as far as matters."""
    (ax, ay), (bx, by) = ends
    return shapely.Polygon([(ax, ay), (bx, by), (bx + 5 * c, by + 5 * s), (ax + 5 * c, ay + 5 * s)])


def footprint(piece: Piece) -> shapely.Polygon:
    """The floor a piece covers."""
    w, d, h = piece.size.width / 2, piece.size.depth / 2, piece.pose.heading
    corners = [
        (x * sin(h) + y * cos(h), -x * cos(h) + y * sin(h))
        for x, y in ((-w, -d), (w, -d), (w, d), (-w, d))
    ]
    return shapely.Polygon([(piece.pose.x + x, piece.pose.y + y) for x, y in corners])


def measure_coverage(pieces: Sequence[Piece]) -> float:
    """The floor that pieces cover together, square metres; rugs and what hangs cover none."""
    low = [footprint(p) for p in pieces if p.pose.z < 0.05 and p.size.height > 0.05]
    return float(shapely.union_all(low).area)


def apart(anchor: Piece, pieces: Sequence[Piece], catalog: Catalog) -> list[Piece]:
    """The pieces without those that run into the anchor or an earlier one."""
    kept: list[Piece] = []
    for piece in sorted(pieces, key=lambda p: (p is not anchor, p.pose.z > TOP)):
        if all(not collide(piece, other, catalog) for other in kept):
            kept.append(piece)
    return kept


def collide(a: Piece, b: Piece, catalog: Catalog) -> bool:
    """Whether two pieces take the same room, where their kinds do not belong under each other."""
    first, second = catalog.kinds[a.category], catalog.kinds[b.category]
    allowed = first.flat or second.flat or b.category in first.under or a.category in second.under
    level = min(a.pose.z + a.size.height, b.pose.z + b.size.height) - max(a.pose.z, b.pose.z)
    shared = footprint(a).intersection(footprint(b)).area
    return not allowed and level > 0.02 and shared > OVERLAP
